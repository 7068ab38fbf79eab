"""`rosml setup`: makes this machine ready for the other commands. scripts/bootstrap.py calls it."""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import checkout, command, options
from rosml.cli.checkout import Command, Group

if TYPE_CHECKING:
    from rosml.machine.services import Services
    from rosml.machine.setup.installer import Installer
    from rosml.machine.setup.state import State

KEPT = "interrupted; call it again to carry on"

UV = "ROSML_UV"
"""The variable with the path of uv. scripts/bootstrap.py sets it after it has installed the Python packages."""

PREINSTALLED = (
    "/usr/local/lib/android",
    "/usr/share/dotnet",
    "/usr/share/swift",
    "/usr/local/.ghcup",
    "/opt/ghc",
    "/opt/hostedtoolcache/CodeQL",
)
"""Folders of GitHub's machines that take gigabytes, and that we do not use."""

TESTS = click.option("--tests", is_flag=True, help="also install a registry and pytest, for its tests")

PROGRAM = (sys.executable, str(ROOT / "scripts/bootstrap.py"))


def bootstrap() -> None:
    """Becomes scripts/bootstrap.py, once: it installs uv and Python packages, then calls the command again."""
    if UV not in os.environ:
        os.execv(PROGRAM[0], [*PROGRAM, *(sys.argv[2:] or ["up"])])


def is_up(root: Path) -> bool:
    """Whether a checkout is ready for builds: its registry and builder answer, and whoever pushes has the registry's password."""
    from rosml.base.errors import RosmlError
    from rosml.machine.services import Services
    from rosml.registry import credentials

    try:
        services = Services.load(root)
        services.require_registry()
        services.require_builder()
    except RosmlError:
        return False
    return not services.registry or bool(credentials.local_file(services.state))


def bring_up(root: Path) -> None:
    """Sets this machine up, as `rosml setup` does. Its output goes to standard error."""
    import subprocess  # only needed here

    from rosml.base.errors import RosmlError

    program = [sys.executable, str(root / "scripts/bootstrap.py"), "up"]
    if subprocess.run(program, stdout=2, check=False).returncode:
        raise RosmlError("this machine could not be set up", "follow the remedy above, then call it again")


class Step(Command):
    def __init__(self, *arguments: Any, **settings: Any) -> None:
        super().__init__(*arguments, kept=KEPT, before=(bootstrap,), **settings)


class Steps(Group):
    command_class = Step


@click.group(
    "setup",
    short_help="Makes this machine ready, or takes away what it made.",
    cls=Steps,
    kept=KEPT,
    invoke_without_command=True,
)
@click.pass_context
def main(context: click.Context) -> None:
    """Makes this machine ready: tools at pinned versions, a local registry, a builder.

    It uses your Docker. Without Docker it starts its own buildkitd, which needs root. All its files are in .state and .venv.
    If Debian packages are missing, it installs them and says so. Without a command: up.

    \b
    Environment:
      ROSML_DOCKER_HUB=0|1  whether Docker Hub answers; setup does not check
      ROSML_CA_BUNDLE       a company's certificates, as SSL_CERT_FILE,
                            REQUESTS_CA_BUNDLE and CURL_CA_BUNDLE are
      BUILDX_BUILDER        use this builder

    \b
    Examples:
      rosml setup
      rosml setup status --json
      rosml setup down
    """
    if context.invoked_subcommand is None:
        checkout.require()
        bootstrap()
        _up(_docker_hub())


@main.command(short_help="Installs missing tools.")
def tools() -> None:
    """Finds the tools that builds need, and installs missing ones."""
    _tools(_docker_hub())


@main.command(short_help="Installs missing tools, starts the registry and the builder.")
def up() -> None:
    """Finds or installs the tools, then starts the local registry and the builder."""
    _up(_docker_hub())


@main.command(hidden=True)
def suite() -> None:
    """Does what `up` does, for `make test`: also installs Docker, Chromium, actionlint and composecheck if they are missing."""
    _up(_docker_hub(), tests=True)


@main.command(short_help="Installs the Python packages alone: enough for a registry.")
def client() -> None:
    """Installs uv and the commands' Python packages: enough to read and write a registry."""
    from rosml.machine.services import Services
    from rosml.machine.setup import services

    installer = _installer()
    installer.report()
    state = installer.state
    if not services.written(state):
        Services(ROOT, "", (), "", "", None, state.uv, state.ca_bundle, bases=()).save()


@main.command(hidden=True)
def linters() -> None:
    """Installs the Python packages for linters, and builds actionlint and composecheck in some seconds."""
    installer = _installer()
    if not installer.on_path("actionlint", "--version"):
        installer.go_program("actionlint")
    installer.go_program("composecheck")
    installer.drop_go_caches()


@main.command(short_help="Lets this machine build for the other architecture.")
def emulate() -> None:
    """Lets this machine build and test for the other architecture, with QEMU."""
    from rosml.machine.setup import builder, emulation

    installer, hub = _installer(), _docker_hub()
    if emulation.ensure(installer, hub):
        builder.stop(installer.state)  # it looks for architectures once, when it starts
    _up(hub)


@main.command(hidden=True)
def engine() -> None:
    """Builds a current Docker Engine, in 10 minutes: tests start it if the machine has none."""
    from rosml.machine.setup.tools import build_engine

    build_engine(_installer())


@main.command(hidden=True)
def browser() -> None:
    """Installs Chromium if it is missing: tests open the catalogue's page in it."""
    from rosml.machine.setup.tools import browser_packages

    _installer().debian_packages(browser_packages())


@main.command(short_help="Finds or builds trivy, which looks for vulnerabilities.")
@TESTS
def scanner(tests: bool) -> None:
    """Finds or builds trivy, which looks for known vulnerabilities in images: 10 minutes."""
    _program("trivy", "--version", "scanner.json", tests)


@main.command(short_help="Finds or builds cosign, which signs images.")
@TESTS
def signer(tests: bool) -> None:
    """Finds or builds cosign, which signs images: a quarter of an hour."""
    _program("cosign", "version", "signer.json", tests)


@main.command(short_help="Builds regctl, which reads and copies images in registries.")
def regctl() -> None:
    """Builds regctl into .state/bin: the pages of the documentation read and copy images with it. No other command needs it."""
    installer = _installer()
    terminal.echo(installer.go_program("regctl"))
    installer.drop_go_caches()


@main.command(hidden=True)
def room() -> None:
    """Frees disk space on GitHub's machines: removes preinstalled folders that we do not use."""
    if os.environ.get("RUNNER_ENVIRONMENT") != "github-hosted":
        terminal.echo("this is none of GitHub's own machines: nothing is removed")
        return
    import shutil
    import subprocess

    before = shutil.disk_usage("/").free
    folders = [folder for folder in PREINSTALLED if os.path.isdir(folder)]
    if folders:
        subprocess.run(["sudo", "rm", "-rf", *folders], stdin=subprocess.DEVNULL, check=False)
    free = shutil.disk_usage("/").free
    terminal.echo(f"removed {len(folders)} folders, {(free - before) / 1e9:.1f} GB; {free / 1e9:.1f} GB are free")


@main.command()
def down() -> None:
    """Stops the registry and the builder, and keeps what they stored."""
    _down(remove=False)


@main.command(short_help="Stops both, and removes .state and .venv.")
def clean() -> None:
    """Stops the registry and the builder, and removes all files of setup (.state, .venv)."""
    _down(remove=True)  # scripts/bootstrap.py, which waits for this, removes the folders


@main.command()
@options.JSON
def status(as_json: bool) -> None:
    """Shows what is running."""
    from rosml.machine.setup import services

    facts = services.status(state_of_checkout())
    if as_json:
        terminal.echo(json.dumps(facts, indent=2))
        return
    rows = {"services": "not up (rosml setup)"}
    if facts["up"]:
        place, builds = facts["registry"], facts["builder"]
        answers = {True: "answers", False: "DOES NOT ANSWER (rosml setup)"}
        rows = {
            "registry": f"{place['address']}, {answers[place['answers']]}",
            "builder": f"{builds['name']} ({builds['kind']}), {answers[builds['answers']]}",
            "base images": "official ones, from Docker Hub" if facts["docker_hub"] else "made here with mmdebstrap",
            "CA bundle": facts["ca_bundle"] or "the system's",
        }
    rows |= {"built tools": ", ".join(facts["installed"]) or "none", "disk free": f"{facts['disk_free_gb']} GB"}
    for name, value in {**rows, "state": facts["state"]}.items():
        terminal.echo(command.as_called(f"{name:<11}  {value}"))


def state_of_checkout() -> State:
    from rosml.machine.setup.state import State

    return State(ROOT, terminal.echo, os.environ.get(UV, ""), os.environ.get("ROSML_CA_BUNDLE", ""))


def _installer() -> Installer:
    from rosml.machine.setup.installer import Installer

    return Installer(state_of_checkout())


def _docker_hub() -> bool:
    """Whether Docker Hub answers. Docker needs it for the builder; without Docker, base images are made here at once."""
    from rosml.machine.setup import network

    installer = _installer()
    return network.docker_hub_answers(installer.state.ca_bundle, attempts=3 if installer.docker.answers else 1)


def _tools(hub: bool, tests: bool = False) -> Services:
    from rosml.machine.setup.tools import install

    state = state_of_checkout()
    state.say("Docker Hub: answers" if hub else "Docker Hub: does not answer; Debian base images are made here")
    return install(state, hub, tests)


def _up(hub: bool, tests: bool = False) -> None:
    from rosml.base.errors import RosmlError
    from rosml.base.units import duration
    from rosml.machine.setup import services
    from rosml.machine.setup.fitness import Unfit
    from rosml.machine.setup.tools import BUILDER, install

    state, started = state_of_checkout(), time.monotonic()
    unfit: dict[str, Unfit] = {}
    tools_of_machine = _tools(hub, tests)
    while True:
        try:
            services.up(state, tools_of_machine)
            break
        except Unfit as error:
            name = os.environ.get("BUILDX_BUILDER") or BUILDER
            if name != BUILDER:
                remedy = error.remedy or "unset BUILDX_BUILDER: setup finds another builder, or says what Docker lacks"
                raise RosmlError(f"BUILDX_BUILDER={name}: {error.message}", remedy) from None
            kind = tools_of_machine.builder_kind
            whose = "Docker's own" if kind == "engine" else "the one in a container of Docker"
            state.say(f"builder: {whose} cannot build our images: {error.message}")
            unfit[kind] = error
            tools_of_machine = install(state, hub, tests, unfit)
    state.say(f"setup: done in {duration(time.monotonic() - started)}")


def _program(name: str, version_argument: str, file: str, tests: bool) -> None:
    from rosml.base import files

    installer = _installer()
    path = installer.on_path(name, version_argument) or installer.go_program(name)
    if tests:
        installer.go_program("registry")
    installer.drop_go_caches()
    installer.report()
    files.write(installer.state.folder / file, json.dumps({name: path}, indent=2) + "\n")


def _down(remove: bool) -> None:
    from rosml.machine.setup import builder, services

    state = state_of_checkout()
    stopped = services.down(state, remove)
    if remove:
        builder.unmount_below(state.folder)
    if stopped or not remove:
        terminal.echo(f"stopped: {', '.join(stopped)}" if stopped else "nothing was running")
