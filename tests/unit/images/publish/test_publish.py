"""`rosml image`: a publishing run for one image, and what it tells; above all, that no untested tag moves."""

from __future__ import annotations

import json
import shutil
import signal
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import click
import pytest
from conftest import SMALL, write_locks

from fakes.memory_registry import DAY, HOST, NEXT, Publisher, Run, publisher
from fakes.projects import copy
from fakes.stubs import OFFLINE, buildx, calls, services
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.cli import command
from rosml.cli.images import call
from rosml.cli.images import image as script
from rosml.containerize.base_image import base as app_base
from rosml.containerize.build import adopt
from rosml.images.builds import base_images, contents
from rosml.images.image_set import model as sets
from rosml.images.publish import survey as surveys
from rosml.images.publish.state import Request
from rosml.machine.services import Services

TARGET = "alpha-base-torch-cu1"
TAGS = ["alpha-base-cu1", "alpha-base-cu1-torch2.10.0", "alpha", "latest"]


@dataclass
class Stage:
    """A checkout whose registry is in memory, and the runs of the command."""

    folder: Path
    image_set: sets.ImageSet
    place: Publisher
    options: dict[str, Any] = field(default_factory=dict)
    runs: list[Run] = field(default_factory=list)

    def image(self, *arguments: str) -> int:
        return command.run(script.main, arguments=["--matrix", str(self.folder / "matrix.yaml"), *arguments])

    def tags(self, repository: str = "ros-torch") -> dict[str, str]:
        """Tags and what they point at, but for dated ones."""
        return {tag: to for tag, to in self.place.tagged(repository).items() if "-2026" not in tag}


def free(monkeypatch: pytest.MonkeyPatch, megabytes: int) -> None:
    """Makes every file system have this much room."""
    usage = shutil.disk_usage("/")._replace(free=megabytes * 1_000_000)
    monkeypatch.setattr(shutil, "disk_usage", lambda path: usage)


@pytest.fixture
def stage(tmp_path: Path, registry: str, small: sets.ImageSet, monkeypatch: pytest.MonkeyPatch) -> Stage:
    """Its first run is of one day, the second of the next."""
    free(monkeypatch, 1_000_000)
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(script, "ROOT", tmp_path)
    monkeypatch.setattr(call, "ROOT", tmp_path)
    monkeypatch.setattr(signal, "signal", lambda *_: None)  # a test run keeps its own
    copy(tmp_path)
    (tmp_path / "matrix.yaml").write_text(SMALL)
    write_locks(tmp_path, small)
    services(tmp_path, registry, buildx=buildx(tmp_path, "exit 1"))
    (tmp_path / ".state/auth").mkdir()
    (tmp_path / ".state/auth/docker.json").write_text('{"auths": {}}')
    stage = Stage(tmp_path, small, publisher(tmp_path, Services.load(tmp_path), monkeypatch))

    def run(called: call.Call) -> Run:
        facts: dict[str, Any] = {
            "date": (DAY, NEXT)[len(stage.runs)],
            "only": called.only,
            "architectures": called.architectures,
            "serving": called.serve,
            "force": called.force,
        }
        stage.runs.append(stage.place.run(small, **facts, **stage.options))
        return stage.runs[-1]

    monkeypatch.setattr(call.Call, "run", run)
    return stage


def test_an_image_is_published(stage: Stage, capsys: pytest.CaptureFixture[str]) -> None:
    assert stage.image(TARGET, "--json") == 0
    result = json.loads(capsys.readouterr().out)
    repository = f"{HOST}/rosml/ros-torch"
    assert result["reference"] == f"{repository}:alpha-base-cu1"
    assert result["tags"] == [f"{repository}:{tag}" for tag in TAGS]
    assert stage.tags() == dict.fromkeys(TAGS, result["digest"])
    assert set(TAGS) <= set(result["moved"])
    assert (result["passed"], result["versions"]) == (5, {"torch": "2.10.0"})
    assert result["compressed"] > result["parts"] > 0 < result["uploaded"]
    assert result["made"] == [
        *("alpha-core", "alpha-base", "part-cuda-cu1", "part-common-cu1-py312", "part-torch-cu1-py312", TARGET)
    ]
    index = stage.place.registry.manifest("rosml/ros-torch", result["digest"])
    assert index and [item["digest"] for item in index.content["manifests"]] == [result["manifest"]]
    stage.place.check(stage.image_set)


def test_an_image_of_others_with_ros_gets_an_sbom(
    stage: Stage, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    name, attached = "example.org/me/cuda:13", list[tuple[str, str]]()
    base = SimpleNamespace(name=name, reference=name, digest="sha256:0", environment={}, adopted="alpha-base")
    monkeypatch.setattr(app_base, "find", lambda *_: base)
    monkeypatch.setattr(adopt, "with_ros", lambda image, *_: image)
    monkeypatch.setattr(adopt, "make", lambda *_: "sha256:1")
    monkeypatch.setattr(contents, "attach", lambda *facts: attached.extend(facts[3]))
    assert stage.image("alpha-base", "--on", name, "--json") == 0
    reference = json.loads(capsys.readouterr().out)["reference"]
    assert reference.endswith("/rosml/on/me/cuda:13-alpha-base") and attached == [("rosml/on/me/cuda", "sha256:1")]


def test_a_second_call_does_nothing(
    stage: Stage, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert stage.image(TARGET) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[1] == f"{TARGET} is built, tested and published"
    assert lines[3] == f"FROM             {HOST}/rosml/ros-torch:alpha-base-cu1"
    assert "structure tests  5 passed, 0 failed" in lines
    actions = stage.runs[0].actions
    assert [step for step, _, _ in actions] == ["build"] * 5 + ["join", "test"] and actions[-1][1] == TARGET
    assert not stage.tags("ros"), "what it stands on gets no tag"
    free(monkeypatch, 1)
    stage.place.services = replace(stage.place.services, bases=tuple(OFFLINE))
    assert stage.image(TARGET) == 0, "it needs neither room nor the base image"
    assert stage.runs[1].actions == []
    lines = capsys.readouterr().out.splitlines()
    assert "tags moved       none: all pointed here already" in lines and "time             nothing to do" in lines


def test_a_run_waits_for_another_one_of_its_checkout(
    stage: Stage, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    lock, places = stage.folder / ".state/publish.lock", list[str]()
    waits: list[str] = []
    options: dict[str, Any] = {"matrix": stage.folder / "matrix.yaml", "only": (TARGET,)}

    def survey(request: Request) -> None:
        places.append(str(request.place))
        raise RosmlError("that is all")

    monkeypatch.setattr(surveys, "survey", survey)
    with ExitStack() as other:
        other.enter_context(turn(lock, lambda: None))

        def say(line: str) -> None:
            if "waiting for another publishing run of this checkout" in line:
                assert not places
                waits.append(line)
                other.close()

        monkeypatch.setattr(call, "say", say)
        with click.Context(click.Command("x")):
            with pytest.raises(RosmlError, match="NOWHERE"):
                call.Call(registry="NOWHERE", **options).survey(turn=True)
            assert not places and not waits
            with pytest.raises(RosmlError, match="that is all"):
                call.Call(registry=f"{HOST}/rosml", **options).survey(turn=True)
            assert places == [f"{HOST}/rosml"] and waits
    with turn(lock, lambda: pytest.fail("its own turn has not ended")):
        assert places


def test_another_architecture_is_built_and_tested_and_gets_no_tag(
    stage: Stage, capsys: pytest.CaptureFixture[str]
) -> None:
    (stage.folder / "status").write_text("Status: running\nPlatforms: linux/amd64, linux/arm64*\n")
    assert stage.image("alpha-core-ml-cpu", "--platform", "linux/arm64") == 0
    printed = capsys.readouterr().out
    assert "alpha-core-ml-cpu is built, tested and pushed by its digest" in printed
    assert "tags             none: a tag is for all platforms of an image" in printed
    assert not stage.place.tagged("ros-ml")


# ---- Nothing is tagged -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("fault", "error", "rest"),
    [
        ({"poisoned": {TARGET}}, f"test of {TARGET} failed, so {TARGET} gets no tag: tests failed: contract", [TARGET]),
        (
            {"broken": {"part-torch-cu1-py312"}},
            f"build of part-torch-cu1-py312 failed, so {TARGET} gets no tag",
            ["part-torch-cu1-py312", TARGET, TARGET],
        ),
        ({"broken": {"alpha-core"}}, f"build of alpha-core failed, so {TARGET} gets no tag", None),
    ],
)
def test_the_next_call_continues_after_a_failure(
    stage: Stage, capsys: pytest.CaptureFixture[str], fault: dict[str, Any], error: str, rest: list[str] | None
) -> None:
    stage.options = fault
    assert stage.image(TARGET, "--json") == 1
    assert error in json.loads(capsys.readouterr().out)["error"]
    assert not stage.tags()
    stage.options = {}
    assert stage.image(TARGET) == 0
    if rest is None:
        assert not stage.runs[0].actions, "nothing more is started after a failure"
    else:
        assert [target for _, target, _ in stage.runs[1].actions] == rest


def test_a_base_image_that_cannot_be_had(stage: Stage, capsys: pytest.CaptureFixture[str]) -> None:
    stage.place.services = replace(stage.place.services, bases=tuple(OFFLINE))
    assert stage.image(TARGET) == 1
    error = capsys.readouterr().err
    assert f"{TARGET} gets no tag: waiting for a builder: docker.io/library/ubuntu:24.04 is on Docker Hub" in error
    assert "or name one that answers: OS_UBUNTU_24_04=" in error
    assert not stage.runs[0].actions


def test_no_room(stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    free(monkeypatch, 4_000)
    assert stage.image(TARGET) == 1
    assert f"build {TARGET}: 9.4 GB are needed" in capsys.readouterr().err
    assert not stage.runs[0].actions


SET_UP = """\
import pathlib, shutil, sys
print("set up:", *sys.argv[1:])
root = pathlib.Path(__file__).parents[1]
shutil.copytree(root / "kept", root / ".state", dirs_exist_ok=True)
"""
"""In the place of scripts/bootstrap.py: the services are as they were."""


@pytest.mark.parametrize("lost", ["all", "registry", "builder"])
def test_it_sets_the_machine_up(stage: Stage, capfd: pytest.CaptureFixture[str], lost: str) -> None:
    shutil.copytree(stage.folder / ".state", stage.folder / "kept")
    (stage.folder / "scripts").mkdir()
    program = stage.folder / "scripts/bootstrap.py"
    program.write_text(SET_UP)
    if lost == "all":
        shutil.rmtree(stage.folder / ".state")
    elif lost == "registry":
        file = stage.folder / ".state/services.json"
        file.write_text(json.dumps({**json.loads(file.read_text()), "registry": "127.0.0.1:1"}))
    else:
        (stage.folder / "status").write_text("Status: stopped\n")
        program.write_text(SET_UP + '(root / "status").write_text("Status: running")\n')
    assert stage.image(TARGET, "--json") == 0
    printed = capfd.readouterr()
    assert "set up: up\n" in printed.err and json.loads(printed.out)


def test_a_set_up_that_fails(stage: Stage, capfd: pytest.CaptureFixture[str]) -> None:
    shutil.rmtree(stage.folder / ".state")
    (stage.folder / "scripts").mkdir()
    (stage.folder / "scripts/bootstrap.py").write_text("import sys\nsys.exit('error: no disk')\n")
    assert stage.image(TARGET) == 1
    assert "error: no disk\nerror: this machine could not be set up\n" in capfd.readouterr().err
    assert not stage.runs


# ---- What is told before anything happens ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        (["alpha-bse-torch-cu1"], "did you mean 'alpha-base-torch-cu1'"),
        ([TARGET, "--platform", "linux/arm64"], f"{TARGET} exists for amd64 only"),
        ([TARGET, "--on", "debian:12"], "--on installs the ROS of one target"),
        (["alpha-core-ml-cpu", "--platform", "linux/arm64", "--env", "policy"], "--env joins environments to a named"),
        ([TARGET, "--env", "policy"], "environments/policy has no lock"),
        ([TARGET], "no channel 'fina'"),
    ],
)
def test_a_wrong_argument_ends_the_command_before_anything_else(
    stage: Stage,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    error: str,
) -> None:
    shutil.rmtree(stage.folder / ".state")
    if "channel" in error:
        monkeypatch.setenv("ROS_CHANNEL", "fina")
    assert stage.image(*arguments) == 2
    assert error in capsys.readouterr().err
    assert not calls(stage.folder)
