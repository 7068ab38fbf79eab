"""`rosml doctor`: what this machine has for rosml, what it lacks, and the remedy."""

from __future__ import annotations

import json
import os
import platform
import shutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import click

from rosml import IN_CHECKOUT, MATRIX, ROOT
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command, options
from rosml.cli.checkout import Command

if TYPE_CHECKING:
    from rosml.images.matrix.model import Matrix

BUILD_GB = 40
"""Free disk that builds of several images need (README.md)."""

STYLES = {"ok": "green", "note": "yellow", "wrong": "red"}
"""Every state of a finding, with its colour: it works; some commands lack it; something that is installed does not work."""


@dataclass(frozen=True)
class Finding:
    """The state of one thing that rosml uses."""

    name: str
    state: Literal["ok", "note", "wrong"]
    text: str  # what this machine has of it
    remedy: str = ""

    def to_json(self) -> dict[str, str]:
        return {"name": self.name, "state": self.state, "found": self.text, "remedy": command.as_called(self.remedy)}


@click.command(
    "doctor", short_help="Says what this machine lacks for rosml, and the remedy.", cls=Command, alone=True, prints=True
)
@options.JSON
def main(as_json: bool) -> None:
    """Says what this machine has for rosml, what it lacks, and the remedy: system, disk, docker or podman, GPU and driver, the
    services of a checkout, the network. Changes nothing.

    'rosml run --check IMAGE' looks at what ROS nodes in a container depend on.

    Exits with 1 if something that is there does not work.

    \b
    Examples:
      rosml doctor
      rosml doctor --json
    """
    findings = [finding for check in CHECKS for finding in check()]
    if as_json:
        terminal.echo(json.dumps([finding.to_json() for finding in findings], indent=2))
    else:
        show(findings)
    if any(finding.state == "wrong" for finding in findings):
        raise SystemExit(1)


def show(findings: list[Finding]) -> None:
    width = max(len(finding.name) for finding in findings)
    for finding in findings:
        state = click.style(finding.state.ljust(5), fg=STYLES[finding.state])
        terminal.echo(f"{state}  {finding.name.ljust(width)}  {finding.text}")
        if finding.remedy:
            terminal.echo(f"{'':5}  {'':{width}}  → {command.as_called(finding.remedy)}")


def system() -> Iterator[Finding]:
    system_name = platform.system()
    if Path("/etc/os-release").exists():
        system_name = platform.freedesktop_os_release().get("PRETTY_NAME", "Linux")
    text = f"{system_name}, {platform.machine()}, {os.cpu_count()} processors, Python {platform.python_version()}"
    if platform.machine() in ("x86_64", "aarch64", "arm64"):
        yield Finding("machine", "ok", text)
    else:
        yield Finding("machine", "note", text, "images exist for amd64 and arm64")


def disk() -> Iterator[Finding]:
    from rosml.images.builds.disk import gigabytes, needed_mb
    from rosml.images.image_set import load

    place = ROOT if IN_CHECKOUT else Path.home()
    free = shutil.disk_usage(place).free / 1e9
    image_set = load.load(MATRIX, ROOT)
    image = image_set.image(image_set.matrix.default.targets[0])
    needs = f"; building {image.target} takes {gigabytes(needed_mb(image_set, image, set()))}" if IN_CHECKOUT else ""
    text = f"{free:.0f} GB free{needs}"
    if free >= BUILD_GB:
        yield Finding("disk", "ok", text)
    else:
        remedy = f"builds of several images need {BUILD_GB} GB; docker system df shows what Docker has"
        yield Finding("disk", "note", text, remedy)


def engine() -> Iterator[Finding]:
    from rosml.run import engine as engines
    from rosml.run.context import NEW_DOCKER, OLD_DOCKER
    from rosml.run.host import host
    from rosml.run.plugins import gpu as gpus

    try:
        reasons: list[str] = []
        program = engines.choose(os.environ, reasons.append)
        about = engines.answering(program)
    except RosmlError as error:
        # A checkout builds without an engine, and some people only join images in a registry.
        installed = any(shutil.which(name) for name in engines.ENGINES)
        yield Finding("engine", "wrong" if installed and not IN_CHECKOUT else "note", error.message, error.remedy)
        return
    kind = "podman" if about.podman else "docker"
    name = kind if kind == os.path.basename(program) else f"{program}, which is {kind}"
    if about.zstd:
        text = f"{name} {about.version}".rstrip() + " answers" + (", rootless" if about.rootless else "")
        yield Finding("engine", "ok", "; ".join([text, *reasons]))
    else:
        yield Finding("engine", "wrong", OLD_DOCKER, NEW_DOCKER)
    here = host(os.environ)
    if words := gpus.is_nvidia(here) and gpus.handed_in(about, here):
        yield Finding("GPU in containers", "ok", f"{about.program} hands it in: {' '.join(words)}")
    elif gpus.is_nvidia(here):
        yield Finding("GPU in containers", "wrong", *gpus.lacking(about))


def gpu() -> Iterator[Finding]:
    from rosml.run.host import host
    from rosml.run.plugins import gpu as gpus

    here = host(os.environ)
    if not gpus.is_nvidia(here):
        yield Finding("GPU", "note", "no NVIDIA GPU, or no driver for it", "take images whose tag ends in -cpu")
        return
    kind, driver = "Jetson" if here.has(*gpus.JETSON) else "NVIDIA", gpus.driver(here)
    stacks = _stacks(driver)
    fit = f"; CUDA images: {', '.join(stacks)}" if stacks else ""
    needed = ", ".join(f"CUDA {cuda} needs {oldest} or newer" for cuda, oldest in _matrix().drivers.items())
    remedy = "" if stacks or not driver else f"update the driver: {needed}"
    yield Finding("GPU", "note" if remedy else "ok", f"{kind}, driver {driver or 'unknown'}{fit}", remedy)


def _stacks(driver: str) -> list[str]:
    """The stacks with CUDA that a driver runs, the newest CUDA first."""
    from rosml.run.plugins.gpu import numbers

    matrix, has = _matrix(), numbers(driver)
    fit = [
        (numbers(facts.cuda), name)
        for name, facts in matrix.stacks.items()
        if facts.cuda and has and has >= numbers(matrix.drivers.get(facts.cuda.partition(".")[0], "0"))
    ]
    return [name for _, name in sorted(fit, reverse=True)]


@cache
def _matrix() -> Matrix:
    from rosml.images.matrix import extends
    from rosml.images.matrix.validate import validate

    return validate(extends.read(MATRIX))


def services() -> Iterator[Finding]:
    if not IN_CHECKOUT:
        yield Finding("checkout", "note", "none: list, explain, join, run and containerize need none", "")
        return
    from rosml.cli.machine.setup import state_of_checkout
    from rosml.machine.setup.services import status

    facts = status(state_of_checkout())
    if not facts["up"]:
        text = "not up: no local registry, and no builder"
        yield Finding("services", "note", text, "rosml setup; make image calls it")
        return
    about = facts["builder"]
    places = {
        "engine": "Docker's own",
        "docker": "in a container of your Docker",
        "buildkitd": "our own",
        "user": "yours",
    }
    no_engine = f", and not Docker's own: {about['no_engine']}" if about["no_engine"] else ""
    version = f"BuildKit {about['version']}, " if about["version"] else ""
    builder = f"{about['name']} ({version}{places.get(about['kind'], about['kind'])}{no_engine})"
    for name, title in (("registry", facts["registry"]["address"]), ("builder", builder)):
        answers = facts[name]["answers"]
        text = f"{title} {'answers' if answers else 'does not answer'}"
        yield Finding(name, "ok" if answers else "wrong", text, "" if answers else "rosml setup")
    bases = "official ones, from Docker Hub" if facts["docker_hub"] else "made here from Debian's archive"
    yield Finding("base images", "ok", bases)


def network() -> Iterator[Finding]:
    from rosml.base.side_by_side import side_by_side
    from rosml.machine.setup.network import answers, docker_hub_answers

    ca_bundle = os.environ.get("SSL_CERT_FILE", "")
    archive = _matrix().ros_archive
    probes: dict[str, Callable[[], bool]] = {"Docker Hub": lambda: docker_hub_answers(ca_bundle)}
    if archive:
        address = archive.live.format(generation="ros2")
        probes["ROS's archive"] = lambda: answers(f"{address}/dists/")
    probes["GitHub"] = lambda: answers("https://github.com/ros/rosdistro")
    replies = side_by_side(lambda name: probes[name](), probes)
    silent = [name for name, reply in zip(probes, replies, strict=True) if not reply]
    if len(silent) < len(probes):
        yield Finding("network", "ok", f"{', '.join(name for name in probes if name not in silent)}: answers")
    if silent:
        remedy = "set HTTPS_PROXY and SSL_CERT_FILE if a proxy is between; mirrors are in docs/registry/networks.md"
        yield Finding("network", "note", f"{', '.join(silent)}: no answer", remedy)


CHECKS: tuple[Callable[[], Iterator[Finding]], ...] = (system, disk, engine, gpu, services, network)
