"""What the user's Docker says of itself, and why there is no answer."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from fakes.setups import program
from rosml.machine import docker
from rosml.machine.docker import Docker

INFO = (
    '{{"ServerVersion": "29.9.3", "Name": "{machine}", "SecurityOptions": ["name=seccomp", "name=rootless"],'
    ' "DriverStatus": [["driver-type", "io.containerd.snapshotter.v1"]]}}'
)
NOBODY = '{"ServerVersion": "", "ServerErrors": ["Is the docker daemon running?"]}'
HOME = os.uname().nodename


def ask(folder: Path, script: str) -> Docker:
    return docker.ask(str(program(folder, "docker", script)))


def test_what_docker_says_of_itself(tmp_path: Path) -> None:
    engine = ask(tmp_path, f"echo '{INFO.format(machine=HOME)}'")
    assert engine == Docker(machine=HOME, containerd_store=True, rootless=True)
    assert engine.answers and not engine.is_elsewhere
    assert ask(tmp_path, f"echo '{INFO.format(machine='robot')}'").is_elsewhere
    assert not ask(tmp_path, f"echo '{INFO.format(machine=docker.DESKTOP)}'").is_elsewhere, "only a trial tells"
    classic = ask(tmp_path, """echo '{"ServerVersion": "20.10.24", "DriverStatus": [["Supports d_type", "true"]]}'""")
    assert classic == Docker()


@pytest.mark.parametrize(
    ("script", "silence", "remedy"),
    [
        ("echo permission denied while trying to connect >&2; exit 1", "not let you in: permission denied", "usermod"),
        ("echo warning >&2; echo error during connect: x >&2; exit 1", "not answer: error during connect: x", "start"),
        (f"echo '{NOBODY}'", "not answer: Is the docker daemon running?", "docker context ls"),
        ("exit 1", "not answer: it says nothing", "start Docker"),
        ("echo 29", "not answer: it says nothing", "start Docker"),
        ("""echo '{"host": {}}'""", "docker is podman", "install Docker"),
        ("exec sleep 9", "no answer within 0 s", "start Docker"),
    ],
)
def test_why_docker_does_not_answer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str, silence: str, remedy: str
) -> None:
    monkeypatch.setattr(docker, "SECONDS", 0.3 if "sleep" in script else 20.0)
    engine = ask(tmp_path, script)
    assert not engine.answers and silence in engine.silence and remedy in engine.remedy


def test_docker_that_is_not_installed_or_cannot_run(tmp_path: Path) -> None:
    assert docker.ask("") == Docker("Docker is not installed", "install it")
    (tmp_path / "docker").mkdir()
    assert "cannot run" in docker.ask(str(tmp_path / "docker")).silence
