"""`rosml doctor`: what it says of machines of several kinds, and when it fails."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from rosml.base.errors import RosmlError
from rosml.cli.machine import doctor
from rosml.machine.setup import network, services
from rosml.run import engine, host
from rosml.run.context import Engine

DRIVER = "NVRM version: NVIDIA UNIX x86_64 Kernel Module  {}  Thu\n"


@pytest.fixture
def machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(host, "ROOT", tmp_path)
    monkeypatch.setattr(engine, "choose", lambda *_: "docker")
    monkeypatch.setattr(engine, "answering", lambda name: Engine(name, version="29.9.3"))
    monkeypatch.setattr(network, "docker_hub_answers", lambda _: True)
    monkeypatch.setattr(network, "answers", lambda _: True)
    monkeypatch.setattr(services, "status", lambda _: {"up": False})
    return tmp_path


def with_driver(root: Path, version: str) -> None:
    (root / "dev").mkdir()
    (root / "dev/nvidiactl").write_text("")
    (root / "proc/driver/nvidia").mkdir(parents=True)
    (root / "proc/driver/nvidia/version").write_text(DRIVER.format(version))


def findings(code: int = 0) -> dict[str, dict[str, Any]]:
    done = CliRunner().invoke(doctor.main, ["--json"])
    assert done.exit_code == code, done.output
    return {finding["name"]: finding for finding in json.loads(done.output)}


def test_a_machine_without_a_gpu_lacks_nothing_that_fails(machine: Path) -> None:
    by_name = findings()
    assert by_name["engine"]["found"] == "docker 29.9.3 answers"
    assert "-cpu" in by_name["GPU"]["remedy"] and "GPU in containers" not in by_name
    assert by_name["services"]["remedy"].startswith("./rosml setup")
    assert "GB free; building jazzy-base-torch-cu130 takes " in by_name["disk"]["found"]


@pytest.mark.parametrize(
    ("driver", "fit", "unfit"), [("580.65.06", {"cu132", "cu130", "cu128"}, set()), ("550.9", {"cu128"}, {"cu130"})]
)
def test_which_images_a_driver_runs(machine: Path, driver: str, fit: set[str], unfit: set[str]) -> None:
    with_driver(machine, driver)
    text = findings(1)["GPU"]["found"]
    assert all(name in text for name in fit) and not any(name in text for name in unfit)


def test_a_driver_that_is_too_old(machine: Path) -> None:
    with_driver(machine, "470.1")
    assert "525" in findings(1)["GPU"]["remedy"]


def test_a_gpu_that_the_engine_cannot_hand_in_is_wrong(machine: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with_driver(machine, "580.1")
    finding = findings(1)["GPU in containers"]
    assert finding["state"] == "wrong" and "Container Toolkit" in finding["remedy"]
    monkeypatch.setattr(engine, "answering", lambda name: Engine(name, nvidia=True))
    assert findings()["GPU in containers"]["found"] == "docker hands it in: --gpus all"


def test_podman_in_dockers_place(machine: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def choose(_: object, say: Callable[[str], object]) -> str:
        say("docker is down")
        return "podman"

    monkeypatch.setattr(engine, "choose", choose)
    monkeypatch.setattr(engine, "answering", lambda name: Engine(name, podman=True, version="4.3.1", rootless=True))
    assert findings()["engine"]["found"] == "podman 4.3.1 answers, rootless; docker is down"


def test_docker_that_reads_no_zstd_is_wrong(machine: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "answering", lambda name: Engine(name, zstd=False))
    finding = findings(1)["engine"]
    assert finding["state"] == "wrong" and "before version 23" in finding["found"] and "podman" in finding["remedy"]


def test_what_does_not_answer_is_named(machine: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def silent(_: str) -> Engine:
        raise RosmlError("docker does not answer", "start it")

    monkeypatch.setattr(engine, "answering", silent)
    monkeypatch.setattr(network, "answers", lambda address: "github" in address)
    done = CliRunner().invoke(doctor.main)
    assert done.exit_code == 0
    assert "docker does not answer\n" in done.output and "→ start it\n" in done.output
    assert "Docker Hub, GitHub: answers" in done.output and "ROS's archive: no answer" in done.output


def test_a_service_that_does_not_answer_is_wrong(machine: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    facts = {
        "up": True,
        "registry": {"address": "127.0.0.1:5000", "answers": True},
        "builder": {
            "name": "rosml",
            "kind": "docker",
            "no_engine": "it is too old",
            "version": "v0.33.0",
            "answers": False,
        },
        "docker_hub": True,
    }
    monkeypatch.setattr(services, "status", lambda _: facts)
    by_name = findings(1)
    assert (by_name["registry"]["state"], by_name["builder"]["state"]) == ("ok", "wrong")
    assert by_name["builder"]["remedy"] == "./rosml setup"
    assert by_name["builder"]["found"].startswith(
        "rosml (BuildKit v0.33.0, in a container of your Docker, and not Docker's own: it is too old)"
    )
