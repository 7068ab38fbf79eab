"""`rosml containerize` beside the Dockerfiles that people write by hand, for the example of ROS 1: cold, after a change of one C++ file,
and after no change.

All sides start from the same base image, with another layer of some bytes for each round and side: so the builder's cache has no step
that reads the base image, of another side or of a round before. All are compressed alike and pushed into the local registry. The two
Dockerfiles read rosdep's lists from files, as `rosml containerize` does for this base image: on both sides, `rosdep update` downloads nothing.
"""

from __future__ import annotations

import json
import os
import re
import secrets
import shutil
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bench import local, results, second_image
from bench.results import Result, Row
from rosml import ROOT
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.containerize.build import bake_file as app_bake_file
from rosml.images.builds import base_images
from rosml.images.builds.push import COMPRESSION
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry.client import Registry

NAMESPACE = "bench-app"
"""Namespace in the local registry: nothing of anybody else is in it."""

ROUNDS = 3
"""Rounds of each situation, of which the median counts."""

PASSES = 3
"""How often the builder's cache is looked through: the builder holds some records a little longer than others."""

ONE, SEVERAL, OURS = SIDES = ("one stage", "several stages", "containerize")

COLD, CHANGED, SAME = "cold", "after one .cpp", "after nothing"

GOALS = {COLD: 0.7, CHANGED: 0.5, SAME: 0.2}
"""By situation, how much of the time of the faster Dockerfile `rosml containerize` may take."""

ROSML = (sys.executable, str(ROOT / "src"))
"""The command rosml."""

COMMAND = "roslaunch compass compass.launch"

SOURCE = "src/compass/src/compass.cpp"
"""The file that changes. Its new function is in the library, so that the result differs."""

MARK = """\
FROM base AS {marker}
RUN echo {marker} >/etc/rosml-bench
"""
"""The base image of one round and side."""

LISTS = {
    "10-debian.list": "yaml file:///usr/share/python3-rosdep2/debian.yaml debian\n",
    "index.yaml": "distributions: {}\ntype: index\nversion: 4\n",
}
"""rosdep's lists, as files of the base image. ROS's documentation has `rosdep update` download all lists."""

INSTALL = """\
RUN --mount=type=secret,id=ca-bundle --mount=type=secret,id=os-apt-mirror --mount=type=bind,from=lists,target=/run/lists \\
    --mount=type=bind,from=scripts,source=build/network.sh,target=/run/network.sh \\
    source /run/network.sh && export ROSDEP_SOURCE_PATH=/run/lists ROSDISTRO_INDEX_URL=file:///run/lists/index.yaml && \\
    apt-get update && rosdep update && rosdep install --from-paths src --ignore-src --default-yes{option} && \\
    rm -rf /var/lib/apt/lists/*
"""
"""The step that ROS's documentation has for dependencies. network.sh is how steps of this project reach a mirror."""

BUILD = """\
RUN /entrypoint.sh catkin_make install -DCMAKE_BUILD_TYPE=Release
"""

DOCKERFILES = {
    ONE: f"""\
FROM base
SHELL ["/bin/bash", "-c"]
COPY src src
{INSTALL.format(option="")}{BUILD}CMD {json.dumps(COMMAND.split())}
""",
    SEVERAL: f"""\
FROM base AS build
SHELL ["/bin/bash", "-c"]
COPY --parents src/*/package.xml ./
{INSTALL.format(option="")}COPY src src
{BUILD}
FROM base
SHELL ["/bin/bash", "-c"]
COPY --parents src/*/package.xml ./
{INSTALL.format(option=" --dependency-types=exec")}COPY --from=build /docker-ros/ws/install install
CMD {json.dumps(COMMAND.split())}
""",
}
"""What people write. The first one is the shortest: a change of any source installs the dependencies again. The second one copies the
manifests first, and its image has neither sources nor what only a build needs."""

CHECK = """\
FROM image AS {marker}
RUN --network=none : {marker}; /entrypoint.sh roslaunch --nodes compass compass.launch >/nodes && \\
    /entrypoint.sh bash -c 'ldd "$(catkin_find --first-only compass compass_node)"' >/libraries && \\
    grep -q compass /nodes && ! grep 'not found' /libraries
"""
"""The image finds its launch file, its program and all libraries of it."""


@dataclass(frozen=True)
class Pushed:
    """One build: its wall time in seconds, the sizes of what the registry stores for it by digest, and of these the layers."""

    seconds: float
    stored: Mapping[str, int]
    layers: Mapping[str, int]


def measure(services: Services, say: Callable[[str], None]) -> Result:
    """Builds the example in all ways, and removes what this left in registry and builder.

    Raises:
        RosmlError: a service is down, the base image is missing, or a build failed.
    """
    services.require_registry()
    services.require_builder()
    bench = Bench(services, say)
    with bench.cleaned():
        return bench.measure()


@dataclass
class Bench:
    """One comparison.

    Attributes:
        run: tells this comparison's steps in the builder from all others'.
        pushed: repositories with digests that are to be removed.
    """

    services: Services
    say: Callable[[str], None]
    run: str = field(default_factory=lambda: f"bench-{secrets.token_hex(6)}")
    pushed: set[tuple[str, str]] = field(default_factory=set)

    def measure(self) -> Result:
        """All builds, one after the other: in each round, each situation for all sides, of which another one begins each time."""
        load = os.getloadavg()[0]
        self._lists.mkdir(parents=True)
        for name, text in LISTS.items():
            files.write(self._lists / name, text)
        builds: dict[tuple[str, str], list[Pushed]] = {}
        for number in range(ROUNDS):
            order = SIDES[number % len(SIDES) :] + SIDES[: number % len(SIDES)]
            bases = {side: self._base(f"{self.run}-{number}-{_name(side)}") for side in order}
            for situation in GOALS:
                for side in order:
                    self.say(f"round {number + 1} of {ROUNDS}, {situation}: {side}")
                    self._edit(side, situation, number)
                    builds.setdefault((situation, side), []).append(self._build(side, bases[side]))
        for side in SIDES:
            self.say(f"what it made starts: {side}")
            self._check(side)
        machine = f"{results.machine()}, load {load:.1f} when it began"
        return Result("app", "python -m bench app", SIDES, rows(builds), machine=machine)

    @contextmanager
    def cleaned(self) -> Iterator[None]:
        """Removes what was pushed, the builder's cache of it, and all files, however the measurement ends."""
        with Registry(self.services.registry) as registry, local.cleaned(registry, self.pushed, self.say):
            try:
                yield
            finally:
                self._prune()
                shutil.rmtree(self._folder, ignore_errors=True)
                shutil.rmtree(
                    self.services.state / "containerize" / f"{NAMESPACE}+{_name(OURS)}@latest", ignore_errors=True
                )

    @property
    def _folder(self) -> Path:
        return self.services.state / "bench" / self.run

    @property
    def _lists(self) -> Path:
        return self._folder / "lists"

    def place(self, side: str) -> str:
        """The repository of a side, with the registry."""
        return f"{self.services.registry}/{NAMESPACE}/{_name(side)}"

    def _edit(self, side: str, situation: str, number: int) -> None:
        """Puts the sources of a side into the state of a situation."""
        folder = self._folder / _name(side)
        if situation == COLD:
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(ROOT / "examples/ros1", folder)
        elif situation == CHANGED:
            with (folder / SOURCE).open("a") as file:
                file.write(f'\nnamespace compass {{ const char* round() {{ return "{self.run}-{number}"; }} }}\n')

    def _base(self, marker: str) -> str:
        """Pushes the base image of one round and side: its reference by digest."""
        inline = MARK.format(marker=marker)
        contexts = {"base": f"docker-image://{self.services.registry}/{local.BASE}"}
        digest = self._bake(
            marker, {"dockerfile-inline": inline, "contexts": contexts, "output": [self.output("base")]}
        )
        self.pushed.add((f"{NAMESPACE}/base", digest))
        return f"{self.services.registry}/{NAMESPACE}/base@{digest}"

    def _build(self, side: str, base: str) -> Pushed:
        begun = time.monotonic()
        if side == OURS:
            self._containerize(base)
        else:
            self._bake(_name(side), self.handwritten(side, base))
        return self._stored(side, time.monotonic() - begun)

    def handwritten(self, side: str, base: str) -> dict[str, Any]:
        """The bake target of a Dockerfile."""
        folders = {"scripts": str(ROOT / "components"), "lists": str(self._lists)}
        return {
            "context": str(self._folder / _name(side)),
            "dockerfile-inline": DOCKERFILES[side],
            "contexts": {"base": f"docker-image://{base}", **folders},
            "output": [self.output(_name(side))],
        }

    def output(self, name: str) -> str:
        """The builder's output of what is written by hand."""
        return f"type=image,name={self.services.registry}/{NAMESPACE}/{name}:latest,push=true,{COMPRESSION}"

    def _containerize(self, base: str) -> None:
        """Calls `rosml containerize`, as a user does; without tests, which no Dockerfile here runs."""
        options = {"base-image": base, "image-name": f"{NAMESPACE}/{_name(OURS)}", "image-tag": "latest"}
        options |= {"target": "run", "command": COMMAND}
        words = [word for name, value in options.items() for word in (f"--{name}", value)]
        argv = [*ROSML, "containerize", str(self._folder / _name(OURS)), *words, "--no-tests"]
        if subprocess.run(argv, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=False).returncode:
            raise RosmlError("rosml containerize failed", "see above")

    def _bake(self, target: str, fields: Mapping[str, Any]) -> str:
        """Builds one target. Returns the digest of its image, if it has one."""
        platform = f"linux/{base_images.native_architecture()}"
        common = {"context": str(self._folder), **app_bake_file.steps(self.services, os.environ, [platform])}
        file = self._folder / "bake.json"
        files.write(file, json.dumps({"target": {target: {**common, **fields}}}))
        name = f"bench-app-{target.removeprefix(f'{self.run}-')}"
        return buildx.run(self.services, buildx.Bake(target, name, file))[1].get("containerimage.digest", "")

    def _stored(self, side: str, seconds: float) -> Pushed:
        """What the registry has of the build that ended just now, with what is attached to the image."""
        repository = f"{NAMESPACE}/{_name(side)}"
        with Registry(self.services.registry) as registry:
            digest = registry.head(repository, "latest")
            attached = [str(entry["digest"]) for entry in registry.referrers(repository, digest)]
        self.pushed.update((repository, item) for item in (digest, *attached))
        stored: dict[str, int] = {}
        for item in (digest, *attached):
            stored |= second_image.stored(f"{self.place(side)}@{item}")
        layers = {layer.digest: layer.size for layer in second_image.manifest(f"{self.place(side)}@{digest}").layers}
        return Pushed(seconds, stored, layers)

    def _check(self, side: str) -> None:
        marker = f"{self.run}-check-{_name(side)}"
        contexts = {"image": f"docker-image://{self.place(side)}:latest"}
        inline = CHECK.format(marker=marker)
        self._bake(marker, {"dockerfile-inline": inline, "contexts": contexts, "output": ["type=cacheonly"]})

    def _prune(self) -> None:
        """Removes from the builder's cache the layers of this comparison's base images, and all that were built on them."""
        for _ in range(PASSES):
            for item in descendants(local.buildx(self.services, "du", "--verbose"), self.run):
                local.buildx(self.services, "prune", "--force", "--all", "--filter", f"id={item}")


def rows(builds: Mapping[tuple[str, str], Sequence[Pushed]]) -> list[Row]:
    """The rows of the result.

    Args:
        builds: by situation and side, a build of each round.
    """
    lines = []
    for situation, goal in GOALS.items():
        seconds = [statistics.median(build.seconds for build in builds[situation, side]) for side in SIDES]
        goal_text = f"at most {goal} of the faster Dockerfile"
        lines.append(Row(situation, seconds, "s", goal_text, seconds[-1] <= goal * min(seconds[:-1])))
    again = {side: list(zip(builds[COLD, side], builds[CHANGED, side], strict=True)) for side in SIDES}
    kinds: tuple[tuple[str, Callable[[Pushed], Mapping[str, int]]], ...] = (
        (f"pushed {CHANGED}", lambda build: build.stored),
        (f"pulled {CHANGED}", lambda build: build.layers),
    )
    for what, kind in kinds:
        sizes = [statistics.median(_new(kind(before), kind(after)) for before, after in again[side]) for side in SIDES]
        lines.append(Row(what, sizes, "B"))
    sizes = [statistics.median(sum(build.layers.values()) for build in builds[COLD, side]) for side in SIDES]
    return [*lines, Row("the run image, compressed", sizes, "B")]


def _new(before: Mapping[str, int], after: Mapping[str, int]) -> int:
    return sum(size for digest, size in after.items() if digest not in before)


def descendants(listed: str, marker: str) -> list[str]:
    """Records of the builder's cache that have a marker in their description, and all that were made from them, the last ones first.

    Args:
        listed: what `buildx du --verbose` prints.
    """
    parents: dict[str, list[str]] = {}
    marked = set[str]()
    for record in listed.split("\n\n"):
        if match := re.search(r"^ID:\s+(\S+)", record, re.MULTILINE):
            parents[match[1]] = re.findall(r"^ - (\S+)", record, re.MULTILINE)
            if re.search(rf"^Description:.*{re.escape(marker)}", record, re.MULTILINE):
                marked.add(match[1])
    generations = [*_generation(parents, set(), marked)]
    return [item for generation in reversed(generations) for item in sorted(generation)]


def _generation(parents: Mapping[str, Iterable[str]], above: set[str], now: set[str]) -> Iterator[set[str]]:
    while now:
        yield now
        above = above | now
        now = {item for item, names in parents.items() if item not in above and now & {*names}}


def _name(side: str) -> str:
    return side.replace(" ", "-")
