"""Which stages of an app's build are taken from a registry: their keys change with what decides their content, and with
nothing else."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from fakes.http_registry import LocalRegistry
from rosml.base.errors import RosmlError
from rosml.containerize.base_image.base import Base
from rosml.containerize.build import bake_file, junit
from rosml.containerize.build.bake_file import Inputs
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.build.report import Answer
from rosml.containerize.build.stage_cache import Cache, Keys, Report, form, keys
from rosml.containerize.inputs import Values
from rosml.containerize.lock import Packages
from rosml.registry import oci
from rosml.registry.client import Registry

FOLDERS = ("manifests", "requests", "additional", "upstream", "target", "downstream")
SCRIPTS = ("containerize", "build", "ros")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(bake_file, "SCRIPTS", tmp_path)
    for name in (*FOLDERS, *SCRIPTS, "target/src"):
        (tmp_path / name).mkdir(parents=True, exist_ok=True)
        (tmp_path / name / "file").write_text(name)
    return tmp_path


def keys_of(folder: Path, base: str = "sha256:1", slim: str = "", hooked: bool = False, **values: Any) -> Keys:
    bases = Base("base", base, {}), Base("slim", slim, {}) if slim else None
    folders = {name: folder / name for name in FOLDERS}
    inputs = Inputs(("run",), *bases, "jazzy", "jazzy", Values(**values), folders, folder, hooked, commit="", time=0)
    return keys(inputs, ("linux/amd64",))


ALL = ["environment", "upstream", "app"]


def changed(one: Keys, other: Keys) -> list[str]:
    return [name for name in ALL if getattr(one, name) != getattr(other, name)]


def write(path: str) -> Callable[[Path], object]:
    return lambda folder: (folder / path).write_text("other")


def git_folder(folder: Path) -> None:
    (folder / "target/.git").mkdir()
    (folder / "target/.git/HEAD").touch()


@pytest.mark.parametrize(
    ("change", "stages"),
    [
        (write("target/src/file"), ["app"]),
        (lambda folder: (folder / "target/src/file").chmod(0o755), ["app"]),
        (lambda folder: (folder / "target/link").symlink_to("src"), ["app"]),
        (lambda folder: (folder / "target/src").chmod(0o700), ["app"]),
        (write("upstream/file"), ["upstream", "app"]),
        (write("downstream/file"), ["app"]),
        (write("manifests/file"), ALL),
        (write("ros/file"), ALL),
        (write("target/.env"), []),
        (git_folder, []),
        (lambda folder: os.utime(folder / "target/src/file", (1, 1)), []),
    ],
)
def test_a_stage_is_made_again_for_what_decides_its_content(
    change: Callable[[Path], object], stages: list[str], folder: Path
) -> None:
    before = keys_of(folder)
    change(folder)
    assert changed(before, keys_of(folder)) == stages


@pytest.mark.parametrize(
    ("values", "stages"),
    [
        ({"base": "sha256:2"}, ALL),
        ({"slim": "sha256:2"}, ALL),
        ({"skip_keys": "boost"}, ALL),
        ({"cmake_args": "-DX=1"}, ["upstream", "app"]),
        ({"tests": False}, ["app"]),
    ],
)
def test_values_decide_as_well(values: dict[str, Any], stages: list[str], folder: Path) -> None:
    assert changed(keys_of(folder), keys_of(folder, **values)) == stages


def test_a_slim_image_has_stages_of_its_own(folder: Path) -> None:
    stages, with_slim = keys_of(folder).stages, keys_of(folder, slim="sha256:3").stages
    assert {*with_slim} - {*stages} == {"slim-runtime", "slim-app"}


def test_sources_that_a_script_changes_decide_which_packages_are_needed(folder: Path) -> None:
    before = keys_of(folder, hooked=True)
    write("target/src/file")(folder)
    assert changed(before, keys_of(folder, hooked=True)) == ALL


KEYS = Keys("e", "u", "a", False)

OUTCOME = Outcome(
    packages=["robot"],
    keys={"roscpp": [Answer(installer="apt", names=["libroscpp-dev"])]},
    added=Packages(apt={"amd64": {"libroscpp-dev": "1.16.0+ds-4"}}),
)
TESTS = junit.Tests(3, 1)
REPORT = Report(form=form(), outcome=OUTCOME, tests=[3, 1])


def altered(outcome: dict[str, Any] | None = None, **others: Any) -> bytes:
    """A report with other values."""
    report = REPORT.model_dump()
    return oci.encoded(report | {"outcome": report["outcome"] | (outcome or {})} | others)


def test_a_docstring_decides_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    before = form.__wrapped__()
    schema = Report.model_json_schema()
    described = {**schema, "description": "other words", "properties": {**schema["properties"], "description": {}}}
    monkeypatch.setattr(Report, "model_json_schema", lambda: {**schema, "description": "other words"})
    assert form.__wrapped__() == before
    monkeypatch.setattr(Report, "model_json_schema", lambda: described)
    assert form.__wrapped__() != before, "a field may be called so"


def test_a_report_is_found_again(server: LocalRegistry) -> None:
    with Cache(f"{server.address}/me/robot-cache", "") as cache:
        assert (cache.stages(KEYS), cache.report(KEYS)) == ({}, None)
        cache.keep(KEYS, OUTCOME, TESTS, {"run/linux/amd64/files.gz": b"some", "slim/linux/amd64/files.gz": b"others"})
        assert cache.report(KEYS) == REPORT
        assert cache.detail(KEYS, "slim/linux/amd64/files.gz") == b"others"
        with pytest.raises(RosmlError, match="has no other"):
            cache.detail(KEYS, "other")
        assert cache.report(Keys("e", "u", "other", False)) is None
        assert cache.reference("app-a") == f"{server.address}/me/robot-cache:app-a"


ROBOT = "me/robot-cache"


@pytest.mark.parametrize(
    "content",
    [
        b"no JSON",
        altered(form="other"),
        altered(more=1),
        oci.encoded({"form": form(), "tests": [3, 1]}),
        altered(tests=["3", 1]),
        altered({"new": []}),
        altered({"keys": {"roscpp": ["libroscpp-dev"]}}),
        altered({"added": {"apt": {"amd64": {"libfoo": "1 ; true"}}, "pip": {}}}),
    ],
)
def test_a_damaged_report_is_none(content: bytes, server: LocalRegistry) -> None:
    with Cache(f"{server.address}/{ROBOT}", "") as cache, Registry(server.address) as client:
        cache.keep(KEYS, OUTCOME, TESTS, {})
        manifest = json.loads(server.manifests[ROBOT, server.tags[ROBOT][KEYS.report]][1])
        client.put_blob(ROBOT, content)
        client.put_manifest(ROBOT, KEYS.report, {**manifest, "layers": [oci.descriptor("application/json", content)]})
        assert cache.report(KEYS) is None


@pytest.mark.parametrize(
    "manifest",
    [
        {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": []},
        {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []},
        {**oci.artifact("application/vnd.rosml.app.report.v1+json", b"", ""), "layers": []},
    ],
)
def test_another_manifest_is_no_report(manifest: dict[str, Any], server: LocalRegistry) -> None:
    with Cache(f"{server.address}/{ROBOT}", "") as cache, Registry(server.address) as client:
        client.put_blob(ROBOT, oci.EMPTY_BLOB)
        client.put_manifest(ROBOT, KEYS.report, manifest, manifest["mediaType"])
        assert cache.report(KEYS) is None


def test_a_cache_is_a_repository() -> None:
    with pytest.raises(RosmlError, match=r"cache: ghcr\.io/me/robot-cache:1 has a tag"):
        Cache("ghcr.io/me/robot-cache:1", "")
    with pytest.raises(RosmlError, match="is no reference with a registry"):
        Cache("robot-cache", "")
