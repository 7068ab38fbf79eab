"""Parts as images of their own, with local replacements for buildx and the registry: for all architectures that have a lock,
bytecode or not, and said so."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from conftest import changed, parse, write_locks

from fakes.stubs import buildx, calls, executable, services
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.images import part as script
from rosml.images.builds import contents, part
from rosml.images.image_set import locked
from rosml.images.image_set import model as sets
from rosml.registry import oci
from rosml.registry.client import Registry

INDEX, LAYER = "sha256:" + "b" * 64, "sha256:" + "c" * 64
OTHER = "registry.test/other:1@sha256:" + "d" * 64
LOCK = "locks/cpu/arm64/3.12/torch.txt"
BAKE = """
env | grep '^OS_' >>"$here/calls"; printf '{"%s": {"containerimage.digest": "%s"}}' "$target" "$(cat "$here/digest")" >"$metadata"
"""


class Stage:
    """A checkout with local replacements."""

    def __init__(self, folder: Path, registry: str, image_set: sets.ImageSet) -> None:
        self.folder, self.image_set, self.said = folder, image_set, list[str]()
        self.listed: list[tuple[str, str]] = []
        self.tagged: list[tuple[str, str, str]] = []
        self.facts: dict[str, Any] = {
            "registry": registry,
            "buildx": buildx(folder, BAKE),
        }
        (folder / "digest").write_text(INDEX)
        entries = [
            {**oci.descriptor(oci.IMAGE, name.encode()), "platform": {"os": "linux", "architecture": name}}
            for name in ("amd64", "arm64")
        ]
        self.index: dict[str, Any] = {"schemaVersion": 2, "manifests": entries}
        layer = {"mediaType": "x", "digest": LAYER, "size": 2_500_000}
        self.image: dict[str, Any] = {"schemaVersion": 2, "layers": [layer]}
        write_locks(folder, image_set)

    def publish(self, name: str, again: bool = False, platform: str = "", **changes: Any) -> part.Assembled:
        found = services(self.folder, **{**self.facts, **changes})
        (found.state / "tmp").mkdir(exist_ok=True)
        image_set = locked.with_locks(self.image_set, locked.current_locks(self.image_set, self.folder))
        wanted = part.find(image_set, name)
        return part.publish(found, image_set, wanted, self.said.append, again=again, platform=platform)


@pytest.fixture
def stage(tmp_path: Path, registry: str, monkeypatch: pytest.MonkeyPatch) -> Stage:
    found = Stage(tmp_path, registry, parse(changed("cpu: [arm64]}", "cpu: [amd64, arm64]}")))
    monkeypatch.setattr(contents, "attach", lambda *facts: found.listed.extend(facts[3]))
    monkeypatch.setattr(Registry, "tag", lambda client, *move: found.tagged.append(move))

    def manifest(_client: Registry, _repository: str, digest: str) -> oci.Manifest:
        content, kind = (found.index, oci.INDEX) if digest == INDEX else (found.image, oci.IMAGE)
        return oci.Manifest(content, digest, kind, 1)

    monkeypatch.setattr(Registry, "manifest", manifest)
    return found


def baked(stage: Stage) -> str:
    (call,) = [call for call in calls(stage.folder) if call.startswith("buildx bake")]
    return call


def test_all_architectures(stage: Stage) -> None:
    found = stage.publish("common-cpu-py312")
    assert found.reference.endswith(f"/rosml/part:common-cpu-py312@{INDEX}")
    assert (found.digest, found.bytecode) == (INDEX, "3.12")
    assert found.layers == {"linux/amd64": (LAYER, 2_500_000), "linux/arm64": (LAYER, 2_500_000)}
    assert "part-common-cpu-py312.platform=linux/amd64,linux/arm64" in baked(stage)
    assert "BYTECODE" not in baked(stage)
    assert stage.tagged == [("rosml/part", INDEX, "common-cpu-py312")]


def test_without_the_builders_cache(stage: Stage) -> None:
    stage.publish("common-cpu-py312", again=True)
    assert "--set part-common-cpu-py312.no-cache=true" in baked(stage)


def test_one_platform_only(stage: Stage) -> None:
    (stage.folder / "digest").write_text("sha256:one")
    assert list(stage.publish("common-cpu-py312", platform="linux/arm64").layers) == ["linux/arm64"]
    assert "platform=linux/arm64 " in baked(stage)
    with pytest.raises(RosmlError, match="is for linux/amd64, linux/arm64"):
        stage.publish("common-cpu-py312", platform="linux/s390x")


def test_an_architecture_without_a_lock_is_left_out(stage: Stage) -> None:
    (stage.folder / "locks/cpu/amd64/3.12/common.txt").unlink()
    (stage.folder / "digest").write_text("sha256:one")
    found = stage.publish("common-cpu-py312")
    assert list(found.layers) == ["linux/arm64"]
    assert found.reference.endswith("/part@sha256:one"), "a tag is for all platforms"
    assert "platform=linux/arm64 " in baked(stage)
    assert not stage.tagged
    (stage.folder / "locks/cpu/arm64/3.12/common.txt").unlink()
    with pytest.raises(RosmlError, match=r"has no lock .*: locks/cpu/amd64/3\.12/common\.txt") as caught:
        stage.publish("common-cpu-py312")
    assert "rosml locks" in caught.value.remedy


@pytest.mark.parametrize("of", ["another version", "a cut file", "another part"])
def test_a_lock_of_something_else_is_none(stage: Stage, of: str) -> None:
    """What it pins would be assembled under a label and a tag that promise what matrix.yaml says now."""
    text = (stage.folder / LOCK).read_text()
    wrong = {
        "another version": text.replace("torch==2.10.0", "torch==2.9.1"),
        "a cut file": text[: len(text) // 2],
        "another part": (stage.folder / LOCK.replace("torch", "common")).read_text(),
    }
    (stage.folder / LOCK).write_text(wrong[of])
    with pytest.raises(RosmlError, match=r"has no lock .*: locks/cpu/arm64/3\.12/torch\.txt"):
        stage.publish("torch-cpu-py312", platform="linux/arm64")
    assert not calls(stage.folder)


def instead(stage: Stage, python: str) -> dict[str, Any]:
    """The facts of a machine that takes another base image, with a release of Python on it."""
    answer = json.dumps({"reference": OTHER, "python": python})
    script = f"echo \"bases $*\" >>'{stage.folder}/calls'\necho '{answer}'"
    return {"bases": [executable(stage.folder / "bases", script)]}


def test_on_another_base_image(stage: Stage) -> None:
    found = stage.publish("common-cpu-py312", **instead(stage, "3.12.10"))
    assert (found.bytecode, found.assembled_on) == ("3.12.10", OTHER)
    assert "BYTECODE" not in baked(stage)
    (asked,) = [call for call in calls(stage.folder) if call.startswith("bases")]
    assert asked.startswith("bases docker.io/library/ubuntu:24.04@sha256:") and asked.endswith(" --assembler 3.12")
    assert f"OS_UBUNTU_24_04=docker-image://{OTHER}" in calls(stage.folder)


def test_on_a_base_image_without_the_python(stage: Stage) -> None:
    found = stage.publish("common-cpu-py312", **instead(stage, ""))
    assert found.bytecode == ""
    assert "part-common-cpu-py312.args.BYTECODE=none" in baked(stage)
    assert found.assembled_on == f"{OTHER}, without bytecode: it has no Python 3.12"
    assert found.assembled_on in stage.said[0]
    assert "| none |" in part.markdown([found])


def test_what_has_no_python_needs_none(stage: Stage) -> None:
    found = stage.publish("tensorflow-cc-cpu", **instead(stage, ""))
    assert "BYTECODE" not in baked(stage)
    assert found.assembled_on == OTHER
    assert "| no Python in it |" in part.markdown([found])


def test_unknown(stage: Stage) -> None:
    with pytest.raises(RosmlError, match="common-cpu-py312") as caught:
        part.find(stage.image_set, "comon-cpu-py312")
    assert caught.value.exit_code == 2
    assert part.find(stage.image_set, "part-common-cpu-py312").kind == "common"


@pytest.mark.parametrize("layers", [0, 2])
def test_what_is_no_part_gets_no_tag(stage: Stage, layers: int) -> None:
    stage.image["layers"] *= layers
    with pytest.raises(RosmlError, match="is not a part with one layer for each platform"):
        stage.publish("common-cpu-py312")
    assert not stage.tagged


# ---- The command -----------------------------------------------------------------------------------------------------


def run(stage: Stage, monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(script, "ROOT", stage.folder)
    services(stage.folder, **{**stage.facts, "buildx": list(stage.facts["buildx"])})
    (stage.folder / "matrix.yaml").write_text(changed("cpu: [arm64]}", "cpu: [amd64, arm64]}"))
    return command.run(script.main, "interrupted", ["--matrix", str(stage.folder / "matrix.yaml"), *arguments])


def test_several_at_once(stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(stage, monkeypatch, "common-cpu-py312", "tensorflow-cc-cpu", "common-cpu-py312") == 0
    bakes = [call for call in calls(stage.folder) if call.startswith("buildx bake")]
    assert ["platform=linux/amd64,linux/arm64" in call for call in bakes] == [True, True]
    assert len(stage.tagged) == 2
    assert f"  linux/arm64  {LAYER}  2.5 MB" in capsys.readouterr().out
    assert stage.listed == [("rosml/part", INDEX)] * 2, "their files are listed, for whoever joins images of them"


def test_results_for_machines(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(stage, monkeypatch, "common-cpu-py312", "--json") == 0
    (found,) = json.loads(capsys.readouterr().out)
    assert found["layers"]["linux/arm64"] == [LAYER, 2_500_000]
    assert run(stage, monkeypatch, "common-cpu-py312", "--json", "--markdown") == 2
    assert run(stage, monkeypatch) == 0
    assert "common-cpu-py312  linux/amd64, linux/arm64" in capsys.readouterr().out
    assert run(stage, monkeypatch, "--json") == 0
    listed = json.loads(capsys.readouterr().out)
    assert [item["name"] for item in listed] == [item.name for item in stage.image_set.parts]
    assert {"name": "common-cpu-py312", "platforms": ["linux/amd64", "linux/arm64"]} in listed


@pytest.mark.parametrize("namespace", ["", "a,dest=x B/../", "Team", "a//b"])
def test_a_namespace_that_is_none(stage: Stage, monkeypatch: pytest.MonkeyPatch, namespace: str) -> None:
    assert run(stage, monkeypatch, "common-cpu-py312", "--namespace", namespace) == 2
    assert not calls(stage.folder)
