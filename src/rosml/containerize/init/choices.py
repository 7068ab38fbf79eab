"""Which base image and command fit the packages of a folder: a proposal with its reason for each, unless the user chooses."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed
from rosml.containerize.init import distribution, framework, libraries, synonyms
from rosml.containerize.init.file_texts import INSTALLED
from rosml.containerize.init.situation import BY_ENV, Choice, Note, Question, Situation, Wishes, settle
from rosml.containerize.packages.manifest import Package
from rosml.images.image_set import missing_locks
from rosml.images.image_set.model import Image
from rosml.images.matrix import combinations, lacks, names
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.tags import FLOATING

SHELL = "bash"

Startable = tuple[Package, str]


@dataclass(frozen=True)
class Decision:
    """What is decided. `keys` are rosdep's keys in manifests for what the base image has."""

    choices: Mapping[str, Choice]
    image: Image
    ended: bool
    notes: tuple[Note, ...]
    keys: tuple[str, ...]
    addons: tuple[str, ...]


def decide(situation: Situation) -> Decision:
    matrix = situation.matrix
    situation = replace(situation, wishes=_understood(matrix, situation.wishes))
    row = distribution.choose(situation)
    component = _component(situation, row.value)
    combination, framework_notes = framework.choose(situation, row.value, component.value)
    stack = framework.choose_stack(situation, row.value, component.value, combination.value)
    target = names.image_target(row.value, component.value, combination.value, stack.value or None)
    image = situation.image_set.by_target[target]
    start = _command(situation, row.value)
    addons, addon_notes = libraries.addons(matrix, situation.scan, image)
    unlocked = (f"{target} cannot be built yet: {missing_locks.reason(image)}", missing_locks.remedy(image))
    notes = (
        *distribution.notes(situation, row.value),
        *framework_notes,
        *(() if image.locked else [unlocked]),
        *libraries.missing(situation.scan),
        *addon_notes,
    )
    choices = {
        "distribution": row,
        "component": component,
        "framework": combination,
        "accelerator": stack,
        "command": start,
    }
    keys = libraries.keys_in_base(matrix, image, {key for package in situation.scan.packages for key in package.needs})
    return Decision(choices, image, distribution.has_ended(situation, row.value), notes, keys, tuple(addons))


def _understood(matrix: Matrix, wishes: Wishes) -> Wishes:
    """The user's wishes in our words: a stack `gpu` is a wish for any GPU."""
    stack, gpu = wishes.stack.lower(), wishes.gpu
    if stack in synonyms.NVIDIA and gpu is None:
        wishes = replace(wishes, stack="", gpu=True)
    elif stack in synonyms.NOTHING and not gpu:
        wishes = replace(wishes, stack="", gpu=False)
    return replace(wishes, framework=framework.meant(matrix, wishes.framework)) if wishes.framework else wishes


def _component(situation: Situation, row: str) -> Choice:
    matrix, reason = situation.matrix, "the build installs what your packages need beyond it"
    available = [name for name in matrix.distributions[row].components if not combinations.only_runs(matrix, name)]

    def read(answer: str) -> str:
        name = synonyms.component(matrix, answer)
        if name in available:
            return name
        text = combinations.component_reason(matrix, row, name) or f"{name} only runs programs that are built"
        other = lacks.with_component(matrix, row, name)
        remedy = f"take {listed(available, 'or')}{f', or --distribution {other}' if other else ''}"
        raise RosmlError(text, remedy, exit_code=2)

    if (before := situation.before(row)) and before.component in available:
        proposal = Choice(before.component, situation.by_repository)
    else:
        proposal = Choice(FLOATING if FLOATING in available else available[0], reason)
        needs = {key: package for package in situation.scan.packages for key in package.needs}
        for name in available[available.index(proposal.value) + 1 :]:
            meta = (matrix.components[name].metapackage or name).replace("-", "_")
            if meta in needs:
                proposal = Choice(name, f"{needs[meta].manifest} depends on {meta}")
    question = Question("How much of ROS", read, available, lambda _: reason)
    return settle(situation.ask, question, situation.wishes.component, proposal)


def _command(situation: Situation, distribution: str) -> Choice:
    """What the run image starts: a launch file, or the only program; a shell if neither is likely."""
    wish, of_env = situation.wishes.command, situation.surroundings.env.get("COMMAND")
    if of_env and not wish:
        return Choice(_shell_words(of_env), BY_ENV)
    question = Question("Command to start", _shell_words)
    return settle(situation.ask, question, wish, _proposed_command(situation, distribution))


def _shell_words(command: str) -> str:
    try:
        shlex.split(command)
    except ValueError as error:
        text = f"the command {command!r} is none that a shell reads: {str(error).lower()}"
        raise RosmlError(text, "close its quotation", exit_code=2) from None
    return command


def _proposed_command(situation: Situation, distribution: str) -> Choice:
    facts, packages = situation.matrix.distributions[distribution], situation.scan.packages
    launches = [(package, file) for package in packages for file in package.launches]
    programs = [(package, name) for package in packages for name in package.programs]
    if facts.wheels:  # there is no command ros2, and no launch (docs/limits.md)
        if len(programs) == 1:
            return Choice(_installed(*programs[0]), f"the only program, by its path: {distribution} has no ros2")
        return Choice(SHELL, f"a shell, as {distribution} has no ros2; --command names another")
    launch, run = ("roslaunch", "rosrun") if facts.ros == 1 else ("ros2 launch", "ros2 run")
    for startable, verb, why in (
        (launches, launch, "the only launch file"),
        (list(_likely(launches)), launch, "the likeliest launch file"),
        (
            [] if launches else programs,
            run,
            "the only program; it needs a roscore" if facts.ros == 1 else "the only program",
        ),
    ):
        if len(startable) == 1:
            package, name = startable[0]
            return Choice(f"{verb} {shlex.join((package.name, name))}", why)
    count = counted(*((len(launches), "launch file") if launches else (len(programs), "program")))
    why = f"there are {count}" if launches or programs else "there is no launch file and no program"
    return Choice(SHELL, f"a shell, as {why}; --command names another")


def _installed(package: Package, program: str) -> str:
    """The path at which colcon installs a program of a package; of one in Python if its setup.cfg is as ROS's tools write it."""
    return shlex.quote(f"{INSTALLED}/{package.name}/lib/{package.name}/{program}")


def _likely(launches: Sequence[Startable]) -> Iterator[Startable]:
    """The launch files that start a whole robot, by their names: those for bringing it up, or called like their package."""
    for package, file in launches:
        if re.sub(r"[._]launch.*$", "", file) in ("bringup", "all", "main", package.name):
            yield package, file
