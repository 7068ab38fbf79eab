"""Which ROS distribution fits the packages of a folder."""

from __future__ import annotations

import datetime
from collections.abc import Collection, Iterator, Sequence

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.containerize.init import framework, synonyms
from rosml.containerize.init.situation import Choice, Note, Question, Situation, settle
from rosml.containerize.packages.manifest import Package
from rosml.images.matrix import lacks, support

DEBIAN = "noetic"
"""The distribution whose name conditions in package.xml compare with if ROS 1 is Debian's own (docs/containerize.md, rosdep)."""


def choose(situation: Situation) -> Choice:
    """The distribution. RosmlError if none fits all packages, or the user names one that does not."""
    fitting = [name for name in situation.matrix.distributions if _fits(situation, name, situation.scan.packages)]
    if not fitting:
        raise _mixed(situation)
    best = _sorted(situation, fitting)
    question = Question(
        "ROS distribution", lambda answer: _read(situation, answer, best), best, lambda name: _support(situation, name)
    )
    return settle(situation.ask, question, situation.wishes.distribution, _proposed(situation, best))


def notes(situation: Situation, name: str) -> Iterator[Note]:
    facts, packages = situation.matrix.distributions[name], situation.scan.packages
    if has_ended(situation, name):
        living = [other for other in situation.matrix.distributions if not has_ended(situation, other)]
        others = _sorted(situation, [other for other in living if _fits(situation, other, packages)])
        remedy = f"if your packages allow it, take {listed(others[:3], 'or')}" if others else ""
        yield f"{name} had its end of life on {facts.eol}", remedy
    other = lacks.other_distribution(situation.matrix, name)
    instead = f"--distribution {other}" if other else "another distribution"
    compiled = next((package for package in packages if not package.is_python), None)
    if facts.wheels and compiled:
        text = f"{name} builds packages of Python alone, and {compiled.manifest} is none"
        yield text, f"take {instead}, or leave the package out: put COLCON_IGNORE into its folder"
    keys = {*facts.lacks}.difference(package.name for package in packages)
    for package in packages:
        if lacking := sorted(keys & package.needs):
            component = lacks.component_with(situation.matrix, other, frozenset(lacking)) if other else ""
            text = f"{name} lacks {listed(lacking)}, which {package.manifest} depends on"
            yield text, f"take {instead}{f' --component {component}' if component else ''}"


def has_ended(situation: Situation, name: str) -> bool:
    return support.has_ended(situation.matrix, name, situation.surroundings.today)


def _fits(situation: Situation, name: str, packages: Collection[Package]) -> bool:
    distributions = situation.matrix.distributions
    facts = distributions[name]
    ros_distro = facts.ros_distro or name
    ros_distro = DEBIAN if facts.ros == 1 and ros_distro not in distributions else ros_distro
    return all(package.fits(facts.ros, ros_distro) for package in packages)


def _mixed(situation: Situation) -> RosmlError:
    rows, first, unfit = situation.matrix.distributions, dict[int, Package](), []
    for package in situation.scan.packages:
        generations = {facts.ros for name, facts in rows.items() if _fits(situation, name, [package])}
        if len(generations) == 1:
            first.setdefault(generations.pop(), package)
        elif not generations:
            unfit.append(package.manifest)
    if len(first) < 2:
        text = f"no distribution fits {listed(unfit) or 'all packages together'}"
        return RosmlError(text, "check their build types", exit_code=2)
    both = listed([f"{package.manifest} (ROS {ros})" for ros, package in sorted(first.items())])
    text = f"packages of ROS 1 and of ROS 2 do not build together: {both}"
    return RosmlError(text, "name the folder of some of them, or put COLCON_IGNORE into the others", exit_code=2)


def _read(situation: Situation, answer: str, best: Sequence[str]) -> str:
    """The distribution that a word of the user means; the best one of several."""
    rows = situation.matrix.distributions
    meant = synonyms.distributions(situation.matrix, answer)
    if not meant:
        raise RosmlError(unknown("distribution", answer, rows), f"take {listed(best, 'or')}", exit_code=2)
    if name := next((name for name in best if name in meant), ""):
        return name
    odd = next(package for package in situation.scan.packages if not _fits(situation, meant[0], [package]))
    text = f"{odd.manifest} is not for {meant[0]}, which is ROS {rows[meant[0]].ros}"
    raise RosmlError(text, f"take {listed(best, 'or')}", exit_code=2)


def _proposed(situation: Situation, best: Sequence[str]) -> Choice:
    """The one of `.env`, else the one that files and branches name, else the best that has the framework."""
    if before := next(filter(None, map(situation.before, best)), None):
        return Choice(before.distribution, situation.by_repository)
    living = [name for name in best if not has_ended(situation, name)] or list(best)
    for words, source in situation.surroundings.hints:
        for name in living:
            if words.intersection((name, situation.matrix.distributions[name].ros_distro)):
                return Choice(name, f"{source}; {_support(situation, name)}")
    combination = situation.wishes.framework or framework.needed(situation).value
    name = next((name for name in living if _carries(situation, name, combination)), living[0])
    return Choice(name, _support(situation, name))


def _sorted(situation: Situation, distributions: Collection[str]) -> list[str]:
    """Distributions, the best first: those of matrix.yaml's default, long-term ones, those with the longest support."""
    images, defaults = situation.image_set.by_target, situation.matrix.default.targets
    usual = {images[name].distribution for name in defaults if name in images}

    def order(name: str) -> tuple[bool, bool, bool, bool, datetime.timedelta]:
        facts = situation.matrix.distributions[name]
        support = datetime.date.max - (facts.eol or datetime.date.min)
        return has_ended(situation, name), facts.experimental, name not in usual, not facts.lts, support

    return sorted(distributions, key=order)


def _carries(situation: Situation, distribution: str, combination: str) -> bool:
    matrix, gpu = situation.matrix, situation.wishes.gpu
    stacks = {
        image.stack
        for image in situation.image_set.images
        if image.locked and (image.distribution, image.combination) == (distribution, combination)
    }
    facts = matrix.frameworks.get(combination)
    accelerators = facts.accelerators if facts else ()
    with_cpu = any(not stack.cuda and stack.accelerator in accelerators for stack in matrix.stacks.values())
    on_gpu = (situation.surroundings.nvidia if gpu is None else gpu) or not with_cpu
    return any(stack is None or situation.is_gpu(stack) == on_gpu for stack in stacks)


def _support(situation: Situation, name: str) -> str:
    facts = situation.matrix.distributions[name]
    until = f"supported until {facts.eol}" if facts.eol else "without an end of life"
    until = f"without support since {facts.eol}" if has_ended(situation, name) else until
    kind = ", experimental" if facts.experimental else ", long-term" if facts.lts else ""
    return f"ROS {facts.ros}{kind}, {until}"
