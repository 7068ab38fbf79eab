"""What the run image starts: a launch file, or the only program of Python; a shell if neither is likely."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator, Sequence

from rosml.base.errors import RosmlError
from rosml.base.problems import counted
from rosml.containerize.init.file_texts import INSTALLED
from rosml.containerize.init.situation import BY_ENV, Choice, Question, Situation
from rosml.containerize.packages.manifest import Package

SHELL = "bash"

Startable = tuple[Package, str]


def choose(situation: Situation, distribution: str) -> Choice:
    wish, of_env = situation.wishes.command, situation.surroundings.env.get("COMMAND")
    if of_env and not wish:
        return Choice(_read(of_env), BY_ENV)
    return situation.settle(Question("Command to start", _read), wish, _proposed(situation, distribution))


def _read(command: str) -> str:
    try:
        shlex.split(command)
    except ValueError as error:
        text = f"the command {command!r} is none that a shell reads: {str(error).lower()}"
        raise RosmlError(text, "close its quotation", exit_code=2) from None
    return command


def _proposed(situation: Situation, distribution: str) -> Choice:
    facts, packages = situation.matrix.distributions[distribution], situation.scan.packages
    launches = [(package, file) for package in packages for file in package.launches]
    scripts = [(package, name) for package in packages for name in package.scripts]
    if facts.wheels:  # there is no command ros2, and no launch (docs/limits.md)
        if len(scripts) == 1:
            return Choice(_installed(*scripts[0]), f"the only program, by its path: {distribution} has no ros2")
        return Choice(SHELL, f"a shell, as {distribution} has no ros2; --command names another")
    launch, run = ("roslaunch", "rosrun") if facts.ros == 1 else ("ros2 launch", "ros2 run")
    for startable, verb, why in (
        (launches, launch, "the only launch file"),
        (list(_likely(launches)), launch, "the likeliest launch file"),
        ([] if launches else scripts, run, "the only program"),
    ):
        if len(startable) == 1:
            package, name = startable[0]
            return Choice(f"{verb} {shlex.join((package.name, name))}", why)
    count = counted(*((len(launches), "launch file") if launches else (len(scripts), "program")))
    why = f"a shell, as there are {count}" if launches or scripts else "a shell"
    return Choice(SHELL, f"{why}; --command names another")


def _installed(package: Package, script: str) -> str:
    """The path at which colcon installs a program of a Python package whose setup.cfg is as ROS's tools write it."""
    return shlex.quote(f"{INSTALLED}/{package.name}/lib/{package.name}/{script}")


def _likely(launches: Sequence[Startable]) -> Iterator[Startable]:
    """The launch files that start a whole robot, by their names: those for bringing it up, or called like their package."""
    for package, file in launches:
        if re.sub(r"[._]launch.*$", "", file) in ("bringup", "all", "main", package.name):
            yield package, file
