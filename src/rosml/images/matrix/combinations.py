"""The rules about combinations. Each rule checks positive facts, and returns None or the sentence why there is no such image."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fnmatch import fnmatchcase
from functools import wraps
from typing import Concatenate, ParamSpec, TypeVar

from rosml.base.problems import listed
from rosml.images.matrix.model import Framework, Matrix, PartEntry, Release, RosArchive, Stack
from rosml.images.matrix.sizes import Size

NVIDIA = ("cuda", "cudnn", "nccl")
"""A stack's facts of CUDA."""

Names = ParamSpec("Names")
Answer = TypeVar("Answer")


def remembered(rule: Callable[Concatenate[Matrix, Names], Answer]) -> Callable[Concatenate[Matrix, Names], Answer]:
    """Decorates a rule: each matrix works an answer out once, since hundreds of images ask the same. The names must be hashable."""

    @wraps(rule)
    def answer(matrix: Matrix, /, *names: Names.args, **others: Names.kwargs) -> Answer:
        answers, key = matrix.answers, (rule, names, *others.items())
        if key not in answers:
            answers[key] = rule(matrix, *names, **others)
        kept: Answer = answers[key]
        return kept

    return answer


@dataclass(frozen=True)
class Brought:
    """Software in a part whose version counts.

    Attributes:
        name: `tensorflow`.
        version: `2.20.0`.
        title: `TensorFlow`; may be empty.
        short: its name in tags, `tf`; may be empty.
        released: whether it is a release, and no fact of the stack.
        environment: variables that it needs, and their values.
    """

    name: str
    version: str
    title: str = ""
    short: str = ""
    released: bool = False
    environment: Mapping[str, str] = field(default_factory=dict, hash=False)


def component_reason(matrix: Matrix, distribution: str, component: str) -> str | None:
    """Does the distribution have the component?"""
    facts = matrix.distributions[distribution]
    if component in facts.components:
        return None
    return f"{distribution} (ROS {facts.ros}) has no {component} metapackage; it has {listed(facts.components)}"


@remembered
def stack_reason(matrix: Matrix, distribution: str, framework: str, stack: str | None, addon: str = "") -> str | None:
    """Can images of a distribution carry the framework on the stack, on any architecture? If an add-on is named, with it."""
    facts, os = matrix.carrying(framework, addon), matrix.distributions[distribution].os
    if (reason := _content_reason(matrix, framework, stack, addon)) or stack is None:
        return reason
    if addon and (reason := system_reason(matrix, distribution, stack, addon)):
        return reason
    return _python(matrix, os, facts, matrix.stacks[stack]) or _architectures(matrix, distribution, facts, stack)


def system_reason(matrix: Matrix, distribution: str, stack: str, addon: str) -> str | None:
    """Does the add-on work on the operating system of a distribution?"""
    os = matrix.distributions[distribution].os
    if os in (systems := matrix.addons[addon].systems.get(stack, (os,))):
        return None
    return f"add-on {addon} of stack {stack} works on {listed(systems)}, and {distribution} stands on {os}"


@remembered
def default_stack(matrix: Matrix, distribution: str, framework: str, addon: str = "") -> str | None:
    """The stack of a framework's short tags: the first of the distribution's on which it exists, if any."""
    stacks = matrix.distributions[distribution].default_stacks
    return next(
        (stack for stack in stacks if stack_reason(matrix, distribution, framework, stack, addon) is None), None
    )


@remembered
def _content_reason(matrix: Matrix, framework: str, stack: str | None, addon: str = "") -> str | None:
    """Does the stack have the parts that the framework and the add-on take?"""
    facts = matrix.carrying(framework, addon)
    if stack is None:
        return f"framework {framework} needs a stack" if facts.parts else None
    if not facts.parts:
        return f"framework {framework} adds nothing to a ROS image, so it has no stack"
    entry = matrix.stacks[stack]
    if entry.accelerator not in facts.accelerators:
        accelerators = listed(facts.accelerators)
        return f"framework {framework} needs accelerator {accelerators}, and stack {stack} has {entry.accelerator}"
    addon_parts = [matrix.part[name] for name in (matrix.addons[addon].parts if addon else ())]
    if lacking := [part.name for part in addon_parts if part.accelerator not in (None, entry.accelerator)]:
        return f"stack {stack} has no {listed(lacking)}, which add-on {addon} takes"
    carried = [matrix.part[name] for name in parts(matrix, facts, entry)]
    if not carried:
        return f"stack {stack} has nothing that framework {framework} takes"
    if other := next((part for part in carried if not part.of_generation(entry.cuda)), None):
        return f"part {other.name} is for CUDA {listed(list(other.adds))}, and stack {stack} has CUDA {entry.cuda}"
    released = families(matrix, facts)
    if lacking := [family for family in released if family not in entry.releases]:
        return f"stack {stack} has no release of {listed(lacking)}"
    if entry.apart and len(released) > 1:
        return f"what framework {framework} needs of stack {stack} does not go together ({entry.apart})"
    return None


@remembered
def built_for(matrix: Matrix, distribution: str) -> tuple[str, ...]:
    """The architectures of a distribution: those of its operating system, or the ones among them that it names."""
    facts = matrix.distributions[distribution]
    system = matrix.operating_systems[facts.os].architectures
    return tuple(name for name in system if not facts.architectures or name in facts.architectures)


def ros_live(matrix: Matrix, distribution: str) -> str:
    """The address of ROS's live apt repository for a distribution that gets its packages from ROS."""
    return _ros_archive(matrix).live.format(generation=matrix.distributions[distribution].generation)


def ros_testing(matrix: Matrix, distribution: str) -> str:
    """The address of ROS's repository of packages before their release; empty if matrix.yaml names none."""
    return (_ros_archive(matrix).testing or "").format(generation=matrix.distributions[distribution].generation)


def ros_snapshot(matrix: Matrix, distribution: str, day: str) -> str:
    """The address of a snapshot of ROS's repository: of a day, such as 2026-08-07, or `final`."""
    return _ros_archive(matrix).snapshot.format(
        ros_distro=matrix.distributions[distribution].ros_distro or distribution, day=day
    )


def ros_apt_source(matrix: Matrix, distribution: str) -> str | None:
    """The address and digest of the package that sets up the live repository; None if matrix.yaml pins none."""
    facts = matrix.distributions[distribution]
    system = matrix.operating_systems[facts.os]
    if (pinned := system.apt_sources.get(facts.generation)) is None:
        return None
    address = _ros_archive(matrix).apt_source.format(
        generation=facts.generation, version=pinned.version, codename=system.codename
    )
    return f"{address}@{pinned.digest}"


def _ros_archive(matrix: Matrix) -> RosArchive:
    assert matrix.ros_archive, "references: a distribution with apt needs it"
    return matrix.ros_archive


@remembered
def architectures(
    matrix: Matrix, distribution: str, framework: str, stack: str | None, addon: str = ""
) -> tuple[str, ...]:
    """Architectures with the same content: those of the distribution for which every release has a wheel."""
    allowed = set(built_for(matrix, distribution))
    if stack is not None:
        for _, wheels in _available(matrix, matrix.carrying(framework, addon), stack):
            allowed &= set(wheels)
    return tuple(name for name in matrix.architectures if name in allowed)


def architecture_reason(
    matrix: Matrix, distribution: str, framework: str, stack: str | None, architecture: str, addon: str = ""
) -> str | None:
    """Why an image that exists leaves out an architecture."""
    os = matrix.distributions[distribution].os
    if architecture not in matrix.operating_systems[os].architectures:
        return f"images of {os} are built for {listed(matrix.operating_systems[os].architectures)} only"
    if architecture not in built_for(matrix, distribution):
        return f"{distribution} exists for {listed(built_for(matrix, distribution))} only"
    for what, wheels in _available(matrix, matrix.carrying(framework, addon), stack) if stack else ():
        if architecture not in wheels:
            return f"{what} has {stack} wheels for {listed(wheels)} only"
    return None


@remembered
def plain(matrix: Matrix) -> str:
    """The framework of plain ROS images: the only one without parts."""
    return next(name for name, framework in matrix.frameworks.items() if not framework.parts)


def parts(matrix: Matrix, framework: Framework, stack: Stack) -> tuple[str, ...]:
    """The parts that a framework takes of a stack, in the order in which they are joined."""
    return tuple(
        part.name
        for part in matrix.parts
        if part.name in framework.parts and part.accelerator in (None, stack.accelerator)
    )


def shown(matrix: Matrix, part: str) -> str:
    """The part for any Python whose packages another part shows to its Python, which would not find them by itself.

    A part that only repeats another one is not shown. Empty if there is none.
    """
    needs = (matrix.part[need] for need in matrix.part[part].needs)
    return next((need.name for need in needs if need.any_python and need.takes), "")


def versions(matrix: Matrix, stack: Stack) -> dict[str, str]:
    """Every version of a stack that counts, by name: of releases, in the order of parts, then of CUDA."""
    released = {family: stack.releases[family] for family in matrix.families if family in stack.releases}
    return released | {name: version for name in NVIDIA if (version := getattr(stack, name))}


def brought(matrix: Matrix, parts: Iterable[str], stack: Stack) -> tuple[Brought, ...]:
    """The software that parts of a stack bring, each once: releases first, then facts of the stack."""
    releases, items = versions(matrix, stack), dict[str, Brought]()
    for item in (item for name in parts for item in brought_by(matrix.part[name])):
        if item.name in releases and (item.title or item.name not in items):
            version = releases[item.name]
            environment = matrix.releases[item.name][version].environment if item.released else {}
            items[item.name] = replace(item, version=version, environment=environment)
    return tuple(sorted(items.values(), key=lambda item: not item.released))


def brought_by(part: PartEntry) -> Iterator[Brought]:
    """The software that a part brings, without versions. The first has the part's title."""
    for index, name in enumerate(part.brings):
        title = (part.title or "") if index == 0 else ""
        yield Brought(name, "", title, (part.short or part.name) if title else "", bool(part.release))


def wheels(matrix: Matrix, architecture: str, releases: Iterable[Release]) -> str:
    """uv's name of the wheel platform of an architecture, with the glibc that some releases ask for: `aarch64-manylinux_2_34`."""
    oldest = matrix.architectures[architecture].wheels
    minors = [int(release.glibc.partition(".")[2]) for release in releases if release.glibc]
    machine, _, second = oldest.rpartition("_")
    return f"{machine}_{max([int(second), *minors])}"


def company(matrix: Matrix, stack: str | None, families: Iterable[str]) -> dict[str, str]:
    """The packages that go with releases of a stack in their parts, and their versions."""
    chosen = matrix.stacks[stack].releases if stack else {}
    releases = [matrix.releases[family][chosen[family]] for family in families if family in chosen]
    return {name: version for release in releases for name, version in release.company(stack or "").items()}


def index(matrix: Matrix, stack: str, part: str) -> str:
    """The index of Python packages that is asked first for those of a part; empty if that is the usual one."""
    return next((release.index for release in releases_of(matrix, stack, part) if release.index), "")


def glibc(matrix: Matrix, stack: str, part: str) -> str:
    """The glibc that wheels of a part ask for; empty if none is newer than the architectures' own."""
    return max((release.glibc for release in releases_of(matrix, stack, part) if release.glibc), default="")


def releases_of(matrix: Matrix, stack: str, part: str) -> Iterator[Release]:
    """The releases of a stack that have packages in a part: its own, and those whose company it takes."""
    entry = matrix.part[part]
    for family in matrix.stacks[stack].releases:
        release = matrix.release(stack, family)
        company = release.company(stack)
        if entry.release == family or any(fnmatchcase(name, pattern) for name in company for pattern in entry.takes):
            yield release


def gpu(matrix: Matrix, stack: str | None, parts: Iterable[str]) -> dict[str, str]:
    """The facts about GPUs of parts of a stack: the oldest driver, and the GPUs for which each release was built on an
    architecture: `{"driver": "580", "torch.amd64": "sm_80 sm_90"}`. Empty on a stack without CUDA."""
    facts, facts_of_gpu = matrix.stacks[stack] if stack else None, dict[str, str]()
    if facts is None or facts.accelerator != "cuda":
        return facts_of_gpu
    for entry in (matrix.part[name] for name in parts):
        if "cuda" in entry.versions and (driver := matrix.drivers.get((facts.cuda or "").partition(".")[0])):
            facts_of_gpu["driver"] = driver
        if entry.release == entry.name:
            built = matrix.releases[entry.name][facts.releases[entry.name]].gpus
            facts_of_gpu |= {
                f"{entry.name}.{architecture}": " ".join(built[architecture]) for architecture in sorted(built)
            }
    return facts_of_gpu


@remembered
def frameworks(matrix: Matrix, stack: str) -> dict[str, tuple[str, ...]]:
    """The parts of every framework that a stack can carry, on some operating system and architecture."""
    facts = matrix.stacks[stack]
    return {
        name: parts(matrix, framework, facts)
        for name, framework in matrix.frameworks.items()
        if _content_reason(matrix, name, stack) is None
    }


@remembered
def addons(matrix: Matrix, stack: str) -> dict[str, tuple[str, ...]]:
    """The parts of every add-on that a stack can carry, with those that they need."""
    bare = plain(matrix)
    return {
        name: parts(matrix, matrix.carrying(bare, name), matrix.stacks[stack])
        for name in matrix.addons
        if _content_reason(matrix, bare, stack, name) is None
    }


def families(matrix: Matrix, framework: Framework) -> tuple[str, ...]:
    """The names of releases that a framework's parts have, in the order in which parts are joined."""
    released = {matrix.part[part].release for part in framework.parts}
    return tuple(family for family in matrix.families if family in released)


def counted(matrix: Matrix, framework: Framework) -> tuple[str, ...]:
    """The software of a framework's images whose versions count, in a fixed order."""
    cuda = any(matrix.part[part].versions for part in framework.parts)
    return (*families(matrix, framework), *(NVIDIA if cuda else ()))


@remembered
def chain(matrix: Matrix, component: str) -> tuple[str, ...]:
    """A component with all components below it, the lowest first."""
    links: list[str] = []
    link: str | None = component
    while link:
        links.insert(0, link)
        link = matrix.components[link].builds_on
    return tuple(links)


def only_runs(matrix: Matrix, component: str) -> bool:
    """Whether a component only runs built programs."""
    return matrix.components[component].runtime_of is not None


def system_size(matrix: Matrix, component: str) -> Size:
    """The size of the operating system that a component stands on."""
    return (only_runs(matrix, component) and matrix.disk.runtime) or matrix.disk.os


@remembered
def runtime(matrix: Matrix, distribution: str, component: str) -> str:
    """The component that runs programs built on another one, or on the nearest below it; empty if there is none."""
    present = matrix.distributions[distribution].present
    smaller = {
        facts.runtime_of: name for name, facts in matrix.components.items() if facts.runtime_of and name in present
    }
    return next((smaller[link] for link in reversed(chain(matrix, component)) if link in smaller), "")


def _python(matrix: Matrix, os: str, framework: Framework, stack: Stack) -> str | None:
    python = matrix.operating_systems[os].python
    for family in families(matrix, framework):
        releases, version = matrix.releases[family], stack.releases[family]
        if python in releases[version].python:
            continue
        others = [name for name, release in releases.items() if python in release.python]
        if not others:
            return f"no release of {family} has a wheel for Python {python}, the Python of {os}"
        have = f"{listed(others)} {'has' if len(others) == 1 else 'have'}"
        return f"{family} {version} has no wheel for Python {python}, the Python of {os} ({have})"
    return None


def _architectures(matrix: Matrix, distribution: str, framework: Framework, stack: str) -> str | None:
    facts, available = matrix.distributions[distribution], built_for(matrix, distribution)
    who = distribution if facts.architectures else facts.os
    common = set(available)
    for what, wheels in _available(matrix, framework, stack):
        if not common & set(wheels):
            if not wheels:
                return f"{what} has no wheel for stack {stack}"
            return f"{what} has {stack} wheels for {listed(wheels)} only, and {who} is built for {listed(available)}"
        common &= set(wheels)
    return None


def _available(matrix: Matrix, framework: Framework, stack: str) -> Iterator[tuple[str, Sequence[str]]]:
    facts = matrix.stacks[stack]
    wheels = {
        family: matrix.releases[family][version].architectures(stack) for family, version in facts.releases.items()
    }
    carried = families(matrix, framework)
    for family in carried:
        yield f"{family} {facts.releases[family]}", wheels.get(family, ())
    if not carried:  # CUDA's libraries come with any of the releases
        anywhere = [architecture for architectures in wheels.values() for architecture in architectures]
        yield f"CUDA {facts.cuda}", tuple(name for name in matrix.architectures if name in anywhere)
