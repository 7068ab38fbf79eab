"""What a container costs, beside bare processes on the same files: its start, and the work of ROS nodes in it.

All sides take turns in each round, and another one begins each time. A ratio is the median of the ratios within rounds, so that what
else the machine did meanwhile counts for both. Containers share the host's network, as ROS nodes on one machine mostly do.
"""

from __future__ import annotations

import json
import os
import shutil
import statistics
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path

from bench import local, results
from bench.results import Result, Row
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.images.builds import base_images
from rosml.images.matrix.model import Matrix
from rosml.machine.services import Services
from rosml.registry.client import Registry

STARTS, WORKS, TRIPS = 21, 15, 2000
"""Rounds of starts and of work; round trips of each size in a round of work, of which the median counts."""

PROCESS, DEBIAN, PLAIN, OURS, USER = SIDES = (
    *("process", "debian:bookworm", "ours, no entrypoint", "ours", "ours, DOCKER_UID"),
)

WORKING = (PROCESS, OURS, USER)
"""The sides that work; the others only start."""

OPTIONS = {
    DEBIAN: (),
    PLAIN: ("--entrypoint", "/usr/bin/env"),
    OURS: (),
    USER: ("--env", "DOCKER_UID=1000", "--env", "DOCKER_GID=1000"),
}
"""By side, options of `docker run`."""

MEASURES = {
    "a product of two matrices": "computation",
    "round trip of 1 kB": "trip 1000",
    "round trip of 1 MB": "trip 1000000",
    "processor time for 1 MB": "processor 1000000",
}
"""By what a row says: what `round_trip.cpp` calls it, in seconds."""

FILES = (ROOT / "bench/round_trip.cpp", ROOT / "bench/round_trip.sh", ROOT / "tests/structure/programs/roscore.sh")

DOCKERFILE = """\
FROM {image}
COPY . /bench/
RUN /entrypoint.sh bash -c 'g++ -O2 -o /bench/round_trip /bench/round_trip.cpp $(pkg-config --cflags --libs roscpp std_msgs)'
"""

DEVICES = {"null": ("1", "3"), "zero": ("1", "5"), "urandom": ("1", "9")}
"""Of a process: their numbers, which Linux never changes."""

NAME = "rosml-bench-container"
"""Of the images in Docker."""


def measure(services: Services, matrix: Matrix, say: Callable[[str], None]) -> Result:
    """Starts containers of both images and processes on the files of ours, and removes all of it.

    Raises:
        RosmlError: no Docker answers, this is not root, the image is missing, or a call failed.
    """
    if os.geteuid():
        raise RosmlError("a process on an image's files needs root (chroot)", "run it as root")
    version = _output("docker", "version", "--format", "{{.Server.Version}}").strip()
    ours, base = _ours(services), base_images.reference(services, matrix.operating_systems, "bookworm")
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(dir=services.state)))
        context = folder / "context"
        context.mkdir()
        for file in FILES:
            shutil.copy(file, context)
        say("load the images into Docker")
        for name, text in (("debian", f"FROM {base}\n"), ("ours", DOCKERFILE.format(image=ours))):
            stack.enter_context(_loaded(services, f"{NAME}:{name}", text, context, folder))
        calls = Calls(stack.enter_context(_files(folder)), _environment())
        load = os.getloadavg()[0]
        starts = turns(STARTS, SIDES, calls.start, lambda line: say(f"starts, {line}"))
        works = turns(WORKS, WORKING, calls.work, lambda line: say(f"work, {line}"))
    machine = f"{results.machine()}, Docker {version}, load {load:.1f} when it began"
    return Result("container", "python -m bench container", SIDES, rows(starts, works), machine=machine)


@dataclass(frozen=True)
class Calls:
    """How a side runs a command.

    Attributes:
        root: the files of our image.
        environment: what the image sets, as words of `env`.
    """

    root: Path
    environment: Sequence[str]

    def start(self, side: str) -> dict[str, float]:
        """Seconds until `true` has ended."""
        begun = time.perf_counter()
        _output(*self._argv(side, ("true",)))
        return {"start": time.perf_counter() - begun}

    def work(self, side: str) -> dict[str, float]:
        """What the nodes of round_trip.cpp took."""
        command = ("/bench/round_trip.sh", str(TRIPS), "1000", "1000000")
        measured: dict[str, float] = json.loads(_output(*self._argv(side, command)).splitlines()[-1])
        return measured

    def _argv(self, side: str, command: Sequence[str]) -> list[str]:
        if side == PROCESS:
            entrypoint = ("/entrypoint.sh",) if command[0] != "true" else ()
            return ["chroot", str(self.root), "/usr/bin/env", "-i", *self.environment, *entrypoint, *command]
        image = f"{NAME}:{'debian' if side == DEBIAN else 'ours'}"
        return ["docker", "run", "--rm", "--network", "host", *OPTIONS[side], image, *command]


def rows(
    starts: Mapping[str, Sequence[Mapping[str, float]]], works: Mapping[str, Sequence[Mapping[str, float]]]
) -> list[Row]:
    """The rows of the result.

    Args:
        starts, works: by side, what each round measured.
    """
    lines = [Row("start and end of `true`", [_milliseconds(starts[side], "start") for side in SIDES], "ms")]
    for what, name in MEASURES.items():
        lines.append(Row(what, [_milliseconds(works.get(side), name) for side in SIDES], "ms"))
    for what, name in MEASURES.items():
        pairs = {side: zip(rounds, works[PROCESS], strict=True) for side, rounds in works.items()}
        ratios = {side: statistics.median(one[name] / bare[name] for one, bare in pair) for side, pair in pairs.items()}
        lines.append(Row(f"{what}, beside a process", [ratios.get(side) for side in SIDES], "ratio"))
    return lines


def _milliseconds(rounds: Sequence[Mapping[str, float]] | None, name: str) -> float | None:
    """The median; None if a side does not have it."""
    return 1000 * statistics.median(measured[name] for measured in rounds) if rounds else None


def turns(
    count: int, sides: Sequence[str], call: Callable[[str], dict[str, float]], say: Callable[[str], None]
) -> dict[str, list[dict[str, float]]]:
    """What each side measured in each round. A round before them fills the caches."""
    measured: dict[str, list[dict[str, float]]] = {side: [] for side in sides}
    for number in range(-1, count):
        say("caches are filled" if number < 0 else f"round {number + 1} of {count}")
        first = number % len(sides)
        for side in (*sides[first:], *sides[:first]):
            result = call(side)
            if number >= 0:
                measured[side].append(result)
    return measured


def _ours(services: Services) -> str:
    services.require_registry()
    services.require_builder()
    with Registry(services.registry) as registry:
        if registry.manifest(*local.BASE.split(":")) is None:
            raise RosmlError(f"{local.BASE} is not in the local registry", "rosml image ros1-bookworm-core")
    return f"{services.registry}/{local.BASE}"


@contextmanager
def _loaded(services: Services, name: str, dockerfile: str, context: Path, folder: Path) -> Iterator[None]:
    """An image in Docker, by an archive that old versions of it can read."""
    file, archive = folder / "Dockerfile", folder / "image.tar"
    file.write_text(dockerfile)
    output = f"type=docker,dest={archive},name={name},compression=uncompressed,force-compression=true"
    words = ["--builder", services.builder, "--file", str(file), "--output", output, str(context)]
    _output(*services.buildx, "build", *words, env=services.environment())
    _output("docker", "load", "--input", str(archive))
    archive.unlink()
    try:
        yield
    finally:
        _output("docker", "rmi", name)


@contextmanager
def _files(folder: Path) -> Iterator[Path]:
    """The files of our image in a folder, with /proc and what programs expect in /dev, as long as this lasts."""
    root, archive = folder / "root", folder / "files.tar"
    root.mkdir()
    container = _output("docker", "create", f"{NAME}:ours").strip()
    try:
        _output("docker", "export", "--output", str(archive), container)
    finally:
        _output("docker", "rm", container)
    _output("tar", "--extract", "--numeric-owner", "--file", str(archive), "--directory", str(root))
    archive.unlink()
    # Not the machine's /dev: whoever removes this folder must not reach it.
    for name, numbers in DEVICES.items():
        _output("mknod", "--mode=666", str(root / "dev" / name), "c", *numbers)
    (root / "dev/fd").symlink_to("/proc/self/fd")
    _output("mount", "-t", "proc", "proc", str(root / "proc"))
    try:
        yield root
    finally:
        _output("umount", "--lazy", str(root / "proc"))


def _environment() -> list[str]:
    words: list[str] = json.loads(_output("docker", "inspect", "--format", "{{json .Config.Env}}", f"{NAME}:ours"))
    return words


def _output(*argv: str, env: Mapping[str, str] | None = None) -> str:
    try:
        done = subprocess.run(argv, stdin=subprocess.DEVNULL, capture_output=True, text=True, env=env, check=False)
    except FileNotFoundError as error:
        raise RosmlError(f"{argv[0]} is not installed") from error
    if done.returncode:
        raise RosmlError(f"{' '.join(argv)} failed:\n{done.stderr.strip()[-2000:]}")
    return done.stdout
