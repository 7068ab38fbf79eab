"""Parts as images of their own, with local replacements for buildx and the registry: for all architectures that have a lock,
with or without bytecode."""

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
LOCKS = "locks/cpu/{}/3.12/{}.txt"
NAME = "common-cpu-py312"
MATRIX = changed("cpu: [arm64]}", "cpu: [amd64, arm64]}")
BAKE = """
env | grep '^OS_' >>"$here/calls"; printf '{"%s": {"containerimage.digest": "%s"}}' "$target" "$(cat "$here/digest")" >"$metadata"
"""


class Stage:
    """A checkout with local replacements."""

    def __init__(self, folder: Path, registry: str, image_set: sets.ImageSet) -> None:
        self.folder, self.image_set, self.lines = folder, image_set, list[str]()
        self.listed: list[tuple[str, str]] = []
        self.tagged: list[tuple[str, str, str]] = []
        self.facts: dict[str, Any] = {"registry": registry, "buildx": buildx(folder, BAKE)}
        (folder / "digest").write_text(INDEX)
        entries = [
            {**oci.descriptor(oci.IMAGE, name.encode()), "platform": {"os": "linux", "architecture": name}}
            for name in ("amd64", "arm64")
        ]
        self.index: dict[str, Any] = {"schemaVersion": 2, "manifests": entries}
        layer = {"mediaType": "x", "digest": LAYER, "size": 2_500_000}
        self.image: dict[str, Any] = {"schemaVersion": 2, "layers": [layer]}
        write_locks(folder, image_set)

    def publish(self, name: str = NAME, platform: str = "") -> part.BuiltPart:
        machine = services(self.folder, **self.facts)
        (machine.state / "tmp").mkdir(exist_ok=True)
        image_set = locked.with_locks(self.image_set, locked.current_locks(self.image_set, self.folder))
        prefix = f"{machine.registry}/rosml"
        builder = part.PartBuilder(machine, image_set, prefix, self.lines.append)
        return builder.publish(part.by_name(image_set, name), platform)

    def on_another_base(self, python: str) -> None:
        """Takes another base image, with a release of Python on it."""
        answer = json.dumps({"reference": OTHER, "python": python})
        text = f"echo \"bases $*\" >>'{self.folder}/calls'\necho '{answer}'"
        self.facts["bases"] = [executable(self.folder / "bases", text)]

    def baked(self) -> str:
        (call,) = [call for call in calls(self.folder) if call.startswith("buildx bake")]
        return call


@pytest.fixture
def stage(tmp_path: Path, registry: str, monkeypatch: pytest.MonkeyPatch) -> Stage:
    stage = Stage(tmp_path, registry, parse(MATRIX))
    monkeypatch.setattr(contents, "attach", lambda *facts: stage.listed.extend(facts[3]))
    monkeypatch.setattr(Registry, "tag", lambda client, *move: stage.tagged.append(move))

    def manifest(_client: Registry, _repository: str, digest: str) -> oci.Manifest:
        content, kind = (stage.index, oci.INDEX) if digest == INDEX else (stage.image, oci.IMAGE)
        return oci.Manifest(content, digest, kind, 1)

    monkeypatch.setattr(Registry, "manifest", manifest)
    return stage


def test_all_architectures(stage: Stage) -> None:
    built = stage.publish(f"part-{NAME}")
    assert built.reference.endswith(f"/rosml/part:{NAME}@{INDEX}")
    assert (built.digest, built.bytecode) == (INDEX, "3.12")
    assert built.layers == {"linux/amd64": (LAYER, 2_500_000), "linux/arm64": (LAYER, 2_500_000)}
    assert f"part-{NAME}.platform=linux/amd64,linux/arm64" in stage.baked() and "BYTECODE" not in stage.baked()
    assert stage.tagged == [("rosml/part", INDEX, NAME)]


def test_one_platform_only(stage: Stage) -> None:
    (stage.folder / "digest").write_text("sha256:one")
    assert list(stage.publish(platform="linux/arm64").layers) == ["linux/arm64"]
    assert "platform=linux/arm64 " in stage.baked() and not stage.tagged
    with pytest.raises(RosmlError, match="is for linux/amd64, linux/arm64") as caught:
        stage.publish(platform="linux/s390x")
    assert caught.value.exit_code == 2
    with pytest.raises(RosmlError, match=NAME) as caught:
        stage.publish("comon-cpu-py312")
    assert caught.value.exit_code == 2


def test_an_architecture_without_a_lock_is_left_out(stage: Stage) -> None:
    (stage.folder / LOCKS.format("amd64", "common")).unlink()
    (stage.folder / "digest").write_text("sha256:one")
    built = stage.publish()
    assert list(built.layers) == ["linux/arm64"]
    assert built.reference.endswith("/part@sha256:one") and not stage.tagged, "a tag is for all platforms"
    (stage.folder / LOCKS.format("arm64", "common")).unlink()
    with pytest.raises(RosmlError, match=r"has no lock .*: locks/cpu/amd64/3\.12/common\.txt") as caught:
        stage.publish()
    assert "rosml locks" in caught.value.remedy


@pytest.mark.parametrize("content", ["another version", "a cut file", "another part"])
def test_a_lock_of_something_else_is_none(stage: Stage, content: str) -> None:
    """Its pins would be built under a label and a tag that promise what matrix.yaml says now."""
    lock = stage.folder / LOCKS.format("arm64", "torch")
    text = lock.read_text()
    wrong = {
        "another version": text.replace("torch==2.10.0", "torch==2.9.1"),
        "a cut file": text[: len(text) // 2],
        "another part": (stage.folder / LOCKS.format("arm64", "common")).read_text(),
    }
    lock.write_text(wrong[content])
    with pytest.raises(RosmlError, match=r"has no lock .*: locks/cpu/arm64/3\.12/torch\.txt"):
        stage.publish("torch-cpu-py312", "linux/arm64")
    assert not calls(stage.folder)


def test_on_another_base_image(stage: Stage) -> None:
    stage.on_another_base("3.12.10")
    built = stage.publish()
    assert (built.bytecode, built.assembled_on) == ("3.12.10", OTHER) and "BYTECODE" not in stage.baked()
    (call,) = [call for call in calls(stage.folder) if call.startswith("bases")]
    assert call.startswith("bases docker.io/library/ubuntu:24.04@sha256:") and call.endswith(" --assembler 3.12")
    assert f"OS_UBUNTU_24_04=docker-image://{OTHER}" in calls(stage.folder)


@pytest.mark.parametrize(
    ("name", "needs_python", "cell"),
    [(NAME, True, "| none |"), ("tensorflow-cc-cpu", False, "| no Python in it |")],
)
def test_on_a_base_image_without_the_python(stage: Stage, name: str, needs_python: bool, cell: str) -> None:
    stage.on_another_base("")
    built = stage.publish(name)
    assert (f"part-{name}.args.BYTECODE=none" in stage.baked()) == needs_python
    assert built.assembled_on == OTHER + (", without bytecode: it has no Python 3.12" if needs_python else "")
    assert built.bytecode == "" and built.assembled_on in stage.lines[0]
    assert cell in part.markdown([built])


@pytest.mark.parametrize("layers", [0, 2])
def test_what_is_no_part_gets_no_tag(stage: Stage, layers: int) -> None:
    stage.image["layers"] *= layers
    with pytest.raises(RosmlError, match="is not a part with one layer for each platform"):
        stage.publish()
    assert not stage.tagged


# ---- The command -----------------------------------------------------------------------------------------------------


def run(stage: Stage, monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(script, "ROOT", stage.folder)
    services(stage.folder, **{**stage.facts, "buildx": list(stage.facts["buildx"])})
    (stage.folder / "matrix.yaml").write_text(MATRIX)
    return command.run(script.main, "interrupted", ["--matrix", str(stage.folder / "matrix.yaml"), *arguments])


def test_several_at_once(stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(stage, monkeypatch, NAME, "tensorflow-cc-cpu", NAME) == 0
    assert len(stage.tagged) == 2
    assert f"  linux/arm64  {LAYER}  2.5 MB" in capsys.readouterr().out
    assert stage.listed == [("rosml/part", INDEX)] * 2, "joins compare their lists of files"


def test_results_for_machines(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(stage, monkeypatch, NAME, "--json") == 0
    (built,) = json.loads(capsys.readouterr().out)
    assert built["layers"]["linux/arm64"] == [LAYER, 2_500_000]
    assert run(stage, monkeypatch, NAME, "--json", "--markdown") == 2
    assert run(stage, monkeypatch) == 0
    assert f"{NAME}  linux/amd64, linux/arm64" in capsys.readouterr().out
    assert run(stage, monkeypatch, "--json") == 0
    items = json.loads(capsys.readouterr().out)
    assert [item["name"] for item in items] == [item.name for item in stage.image_set.parts]
    assert {"name": NAME, "platforms": ["linux/amd64", "linux/arm64"]} in items


@pytest.mark.parametrize("options", [("--namespace", ""), ("--namespace", "a,dest=x B/../"), ("--platform", "s390x")])
def test_options_that_are_wrong(stage: Stage, monkeypatch: pytest.MonkeyPatch, options: tuple[str, ...]) -> None:
    assert run(stage, monkeypatch, NAME, *options) == 2
    assert not calls(stage.folder)
