"""Lock files of apps: they are written, read and followed, and a build takes nothing that they do not have."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from rosml import ROOT
from rosml.apps import lock
from rosml.apps.sources import Pin
from rosml.base.errors import RosmlError

LOCK = lock.Lock(
    base_image=lock.Image(name="ros:jazzy-base", digest="sha256:1"),
    repositories={"up": Pin("https://example.org/up.git", "main", "c" * 40)},
    apt={"amd64": {"tree": "2.1", "libc6:i386": "2.36"}},
    pip={"amd64": ["toolz==1.0 --hash=sha256:00"]},
)


def test_a_lock_file_is_read_as_it_was_written(tmp_path: Path) -> None:
    file = tmp_path / "containerize.lock"
    assert lock.read(file, tmp_path) is None
    file.write_text(LOCK.text())
    assert lock.read(file, tmp_path) == LOCK
    assert json.loads(LOCK.line()) == json.loads(LOCK.text()) and "\n" not in LOCK.line()


@pytest.mark.parametrize("text", ["", "{}", LOCK.text().replace('"format": 1', '"format": 2'), "[]"])
def test_what_is_no_lock_file_is_refused_with_a_remedy(text: str, tmp_path: Path) -> None:
    file = tmp_path / "containerize.lock"
    file.write_text(text)
    with pytest.raises(RosmlError, match="is no lock file") as caught:
        lock.read(file, tmp_path)
    assert caught.value.exit_code == 2 and "--lock" in caught.value.remedy


def test_a_lock_file_of_another_base_image_is_refused() -> None:
    assert LOCK.base_image.of("ros:jazzy-base") == "sha256:1"
    with pytest.raises(RosmlError, match="of the base image ros:jazzy-base, and not of ros:jazzy-core"):
        LOCK.base_image.of("ros:jazzy-core")


def test_other_architectures_stay_while_all_else_is_the_same() -> None:
    new = LOCK.model_copy(update={"apt": {"arm64": {"tree": "2.2"}}, "pip": {}})
    assert set(new.with_other_architectures(LOCK).apt) == {"amd64", "arm64"}
    newer = new.model_copy(update={"base_image": lock.Image(name="ros:jazzy-base", digest="sha256:2")})
    assert set(newer.with_other_architectures(LOCK).apt) == {"arm64"}, "the old versions were of the old image"


def test_each_architecture_gets_its_lists(tmp_path: Path) -> None:
    LOCK.write_requests(tmp_path)
    assert (tmp_path / "lock/amd64/apt").read_text() == "libc6:i386 2.36\ntree 2.1\n"
    assert (tmp_path / "lock/amd64/pip").read_text() == "toolz==1.0 --hash=sha256:00\n"


def test_it_says_for_which_platforms_it_has_no_packages() -> None:
    assert LOCK.lacks(["linux/amd64", "linux/arm64", "linux/arm/v7"]) == ["linux/arm64", "linux/arm/v7"]


def test_the_first_of_two_versions_counts() -> None:
    one = {"architecture": "amd64", "apt": {"a": "1", "b": "1"}, "pip": ["x==1 --hash=sha256:1"]}
    other = {"architecture": "amd64", "apt": {"a": "2", "c": "1"}, "pip": ["x==2 --hash=sha256:2", "y==1"]}
    found = lock.added([one, other])
    assert found.apt == {"amd64": {"a": "1", "b": "1", "c": "1"}}
    assert found.pip == {"amd64": ["x==1 --hash=sha256:1", "y==1"]}


# ---- pip, in the build -----------------------------------------------------------------------------------------------


@pytest.fixture
def script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("pip_install", ROOT / "components/containerize/pip_install.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def entry(name: str, **info: Any) -> dict[str, Any]:
    return {"metadata": {"name": name, "version": "1.0"}, "is_direct": False, "download_info": info}


HASH = {"hash": "sha256=aa", "hashes": {"sha256": "aa"}}


@pytest.mark.parametrize(
    ("item", "line"),
    [
        (entry("Ruamel.YAML", url="https://example.org/x.whl", archive_info=HASH), "ruamel-yaml==1.0 --hash=sha256:aa"),
        (entry("a", url="https://example.org/x.whl", archive_info={"hash": "sha256=aa"}), "a==1.0 --hash=sha256:aa"),
        (
            entry("a", url="https://example.org/a", vcs_info={"vcs": "git", "commit_id": "c0"}, subdirectory="py"),
            "a @ git+https://example.org/a@c0#subdirectory=py",
        ),
        (
            {**entry("a", url="https://example.org/a.whl", archive_info=HASH), "is_direct": True},
            "a @ https://example.org/a.whl#sha256=aa",
        ),
        (entry("a", url="file:///a", dir_info={}), None),
    ],
)
def test_what_pip_would_install_becomes_a_line(item: dict[str, Any], line: str | None, script: ModuleType) -> None:
    planned = script.planned(item)
    assert (planned.line if planned.locked else None) == line


def install(script: ModuleType, folder: Path, report: list[dict[str, Any]], locked: str | None) -> list[list[str]]:
    """The calls of pip after it said what it would install, each with the requirements that it got."""
    calls: list[list[str]] = []

    def pip(*arguments: str) -> None:
        if "--report" in arguments:
            Path(arguments[arguments.index("--report") + 1]).write_text(json.dumps({"install": report}))
        else:
            file = Path(arguments[arguments.index("--requirement") + 1])
            calls.append([*arguments[:-2], *file.read_text().splitlines()])

    script.pip = pip  # type: ignore[attr-defined]
    script.knows_report = lambda: True  # type: ignore[attr-defined]
    (folder / "requests").write_text("a\n--extra-index-url https://example.org/simple\n-r other\n-e b\n")
    if locked is not None:
        (folder / "locked").write_text(locked)
    script.main(folder / "written", folder / "locked", folder / "requests")
    return calls


def test_what_pip_resolved_is_installed_by_its_hash(script: ModuleType, tmp_path: Path) -> None:
    report = [entry("b", url="file:///b", dir_info={}), entry("a", url="https://example.org/x.whl", archive_info=HASH)]
    index = "--extra-index-url https://example.org/simple"
    assert install(script, tmp_path, report, None) == [
        ["install", "--no-deps", "--require-hashes", index, "a==1.0 --hash=sha256:aa"],
        ["install", "--no-deps", index, "b @ file:///b"],
    ]
    assert (tmp_path / "written").read_text() == "a==1.0 --hash=sha256:aa\n"


def test_pip_installs_the_archive_of_the_lock_file_or_nothing(script: ModuleType, tmp_path: Path) -> None:
    report = [entry("a", url="https://example.org/x.whl", archive_info=HASH)]
    [call] = install(script, tmp_path, report, "a==1.0 --hash=sha256:bb\n")
    assert call[-1] == "a==1.0 --hash=sha256:bb"
    for other in ("a==2.0 --hash=sha256:aa\n", "a==1.0.1 --hash=sha256:aa\n", "b==1.0 --hash=sha256:aa\n", ""):
        with pytest.raises(SystemExit, match=r"the lock file does not have a==1\.0; .*--lock"):
            install(script, tmp_path, report, other)


def test_a_pip_without_reports_is_compared_with_before(script: ModuleType, tmp_path: Path) -> None:
    states = [{"numpy==1.0"}, {"numpy==1.0", "a==1.0"}] * 2
    script.pip = lambda *_: None  # type: ignore[attr-defined]
    script.knows_report = lambda: False  # type: ignore[attr-defined]
    script.installed = lambda: states.pop(0)  # type: ignore[attr-defined]
    (tmp_path / "requests").write_text("a\n")
    script.main(tmp_path / "written", tmp_path / "locked", tmp_path / "requests")
    assert (tmp_path / "written").read_text() == "a==1.0\n"
    (tmp_path / "locked").write_text("a==2.0\n")
    with pytest.raises(SystemExit, match=r"the lock file does not have a==1\.0"):
        script.main(tmp_path / "written", tmp_path / "locked", tmp_path / "requests")
