"""The commands of `rosml setup`: what they start, print and leave."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from fakes.setups import new_state, program, services_of
from rosml.base.errors import RosmlError
from rosml.cli import main
from rosml.cli.machine import setup as commands
from rosml.machine.services import Services
from rosml.machine.setup import services, tools
from rosml.machine.setup.fitness import Unfit
from rosml.machine.setup.installer import Installer
from rosml.machine.setup.state import State


@pytest.fixture
def state(tmp_path: Path) -> State:
    return new_state(tmp_path)


def call(state: State, monkeypatch: pytest.MonkeyPatch, *words: str) -> str:
    monkeypatch.setattr(commands, "ROOT", state.root)
    monkeypatch.setenv(commands.UV, "/uv")
    monkeypatch.setenv("XDG_CACHE_HOME", str(state.cache))
    return CliRunner().invoke(commands.main, words, catch_exceptions=False).output


@pytest.mark.parametrize("word", ["scanner", "signer"])
def test_the_scanner_and_the_signer_are_saved(state: State, monkeypatch: pytest.MonkeyPatch, word: str) -> None:
    monkeypatch.setattr(Installer, "on_path", lambda *_: None)
    monkeypatch.setattr(Installer, "go_program", lambda self, name: f"/built/{name}")
    call(state, monkeypatch, word)
    name = {"scanner": "trivy", "signer": "cosign"}[word]
    assert json.loads((state.folder / f"{word}.json").read_text()) == {name: f"/built/{name}"}


def test_a_client_of_a_registry_builds_no_program(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Installer, "go_program", lambda self, name: pytest.fail(f"{name} was built"))
    monkeypatch.setattr(Installer, "debian_packages", lambda self, packages: pytest.fail("packages of the system"))
    path = state.root / "path"
    monkeypatch.setenv("GITHUB_PATH", str(path))
    call(state, monkeypatch, "client")
    assert path.read_text() == f"{state.bin}\n"
    client = Services.load(state.root)
    assert not client.bases, "base images are the official ones, on the machines that build"
    for ask in (client.require_registry, client.require_builder, lambda: client.place):
        with pytest.raises(RosmlError) as caught:
            ask()
        assert caught.value.remedy == "run 'rosml setup'"
    assert services.status(state)["up"] is False
    assert "not up (./rosml setup)" in call(state, monkeypatch, "status")


def test_a_client_leaves_services_that_are_up(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    facts = services_of(state, "buildkitd")
    facts.save()
    call(state, monkeypatch, "client")
    assert Services.load(state.root) == facts


@pytest.mark.parametrize("typed", [["status", "--json"], []])
def test_a_call_by_people_begins_with_uv_and_packages(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, typed: list[str]
) -> None:
    def become(_program: str, argv: list[str]) -> None:
        called.extend(argv)
        raise SystemExit

    called: list[str] = []
    monkeypatch.setattr(commands, "PROGRAM", (sys.executable, str(tmp_path / "scripts/bootstrap.py")))
    monkeypatch.setattr(os, "execv", become)
    monkeypatch.delenv(commands.UV, raising=False)
    monkeypatch.setattr(sys, "argv", ["rosml", "setup", *typed])
    CliRunner().invoke(main.cli, ["setup", *typed], catch_exceptions=False)
    assert called == [sys.executable, str(tmp_path / "scripts/bootstrap.py"), *(typed or ["up"])]


def test_status_after_the_services_died(state: State, monkeypatch: pytest.MonkeyPatch) -> None:
    services_of(state, "buildkitd", "/nowhere/buildx", "127.0.0.1:1").save()
    assert call(state, monkeypatch, "status").count("DOES NOT ANSWER (./rosml setup)") == 2
    facts = json.loads(call(state, monkeypatch, "status", "--json"))
    assert (facts["up"], facts["registry"], facts["docker_hub"]) == (
        True,
        {"address": "127.0.0.1:1", "answers": False},
        True,
    )


@pytest.mark.parametrize(("word", "output"), [("down", "nothing was running\n"), ("clean", "")])
def test_down_where_nothing_runs(state: State, monkeypatch: pytest.MonkeyPatch, word: str, output: str) -> None:
    (state.folder / "services.json").write_text("{")
    assert call(state, monkeypatch, word) == output
    assert not (state.folder / "services.json").exists()


@pytest.mark.parametrize("where", ["", "self-hosted", "github-hosted"])
def test_room_is_made_on_githubs_machines_only(
    state: State, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    big = tmp_path / "android"
    (big / "sdk").mkdir(parents=True)
    program(tmp_path / "bin", "sudo", 'exec "$@"')
    monkeypatch.setenv("PATH", str(tmp_path / "bin"), prepend=os.pathsep)
    monkeypatch.setenv("RUNNER_ENVIRONMENT", where)
    monkeypatch.setattr(commands, "PREINSTALLED", (str(big), str(tmp_path / "nowhere")))
    call(state, monkeypatch, "room")
    assert big.exists() == (where != "github-hosted")


@pytest.mark.parametrize("name", ["", "desktop"])
def test_setup_tries_the_next_builder(state: State, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    """Docker's own, then the one in a container, then ours. One that BUILDX_BUILDER names is the only one."""
    monkeypatch.setenv("BUILDX_BUILDER", name)
    kinds = ["engine", "docker", "buildkitd"]

    def install(_state: State, _hub: bool, _tests: bool, unfit: dict[str, Unfit]) -> Services:
        assert [*unfit] == kinds[: len(unfit)]
        return services_of(state, kinds[len(unfit)])

    def up(_state: State, tools_of_machine: Services) -> None:
        if tools_of_machine.builder_kind != "buildkitd":
            raise Unfit("it pushes nothing")
        tools_of_machine.save()

    monkeypatch.setattr(commands, "_tools", lambda hub, tests: install(state, hub, tests, {}))
    monkeypatch.setattr(tools, "install", install)
    monkeypatch.setattr(services, "up", up)
    monkeypatch.setenv("ROSML_DOCKER_HUB", "0")
    if name:
        with pytest.raises(RosmlError, match="BUILDX_BUILDER=desktop: it pushes nothing") as caught:
            call(state, monkeypatch, "up")
        assert "unset BUILDX_BUILDER" in caught.value.remedy
        return
    output = call(state, monkeypatch, "up")
    assert "Docker's own cannot build" in output and "the one in a container of Docker cannot build" in output
    assert Services.load(state.root).builder_kind == "buildkitd"
