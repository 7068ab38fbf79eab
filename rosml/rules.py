"""Why a combination does not exist. Each rule looks at positive facts and returns one sentence, or None if they hold."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rosml.model import FAMILIES, PARTS, Family, Framework, Matrix, Part, Stack
from rosml.problems import listed


def component_reason(matrix: Matrix, distribution: str, component: str) -> str | None:
    """Does the distribution have the component?"""
    facts = matrix.distributions[distribution]
    if component in facts.components:
        return None
    return f"{distribution} (ROS {facts.ros}) has no {component} metapackage; it has {listed(facts.components)}"


def stack_reason(matrix: Matrix, os: str, framework: str, stack: str | None) -> str | None:
    """Can images of an operating system carry the framework on the stack, on any architecture?"""
    facts = matrix.frameworks[framework]
    if stack is None or not facts.parts:
        return _pairing(framework, facts, stack)
    return (
        _accelerator(framework, facts, stack, matrix.stacks[stack])
        or _parts(framework, facts, stack, matrix.stacks[stack])
        or _releases(framework, facts, stack, matrix.stacks[stack])
        or _apart(framework, facts, stack, matrix.stacks[stack])
        or _python(matrix, os, facts, matrix.stacks[stack])
        or _architectures(matrix, os, facts, stack)
    )


def architectures(matrix: Matrix, os: str, framework: str, stack: str | None) -> tuple[str, ...]:
    """Architectures with the same content: those of the operating system for which every release has a wheel."""
    facts = matrix.frameworks[framework]
    allowed = set(matrix.operating_systems[os].architectures)
    if stack is not None:
        for _, wheels in _available(matrix, facts, stack):
            allowed &= set(wheels)
    return tuple(name for name in matrix.architectures if name in allowed)


def architecture_reason(matrix: Matrix, os: str, framework: str, stack: str | None, architecture: str) -> str | None:
    """Why an image that exists leaves out an architecture."""
    if architecture not in matrix.operating_systems[os].architectures:
        return f"images of {os} are built for {listed(matrix.operating_systems[os].architectures)} only"
    for what, wheels in _available(matrix, matrix.frameworks[framework], stack) if stack else ():
        if architecture not in wheels:
            return f"{what} has {stack} wheels for {listed(wheels)} only"
    return None


def plain(matrix: Matrix) -> str:
    """The framework of images that carry none: the only one without parts."""
    return next(name for name, framework in matrix.frameworks.items() if not framework.parts)


def parts(framework: Framework, stack: Stack) -> tuple[Part, ...]:
    """The parts that a framework takes of a stack, in the order in which they are joined."""
    return tuple(part for part in PARTS if part in framework.parts and (part != "cuda" or stack.accelerator == "cuda"))


def families(framework: Framework) -> tuple[Family, ...]:
    """The families that a framework has releases of, in a fixed order."""
    return tuple(family for family in FAMILIES if family in framework.releases)


def _pairing(name: str, framework: Framework, stack: str | None) -> str | None:
    if framework.parts and stack is None:
        return f"framework {name} needs a stack"
    if not framework.parts and stack is not None:
        return f"framework {name} adds nothing to a ROS image, so it has no stack"
    return None


def _accelerator(name: str, framework: Framework, stack: str, facts: Stack) -> str | None:
    if facts.accelerator in framework.accelerators:
        return None
    return f"framework {name} needs accelerator {listed(framework.accelerators)}, and stack {stack} has {facts.accelerator}"


def _parts(name: str, framework: Framework, stack: str, facts: Stack) -> str | None:
    return None if parts(framework, facts) else f"stack {stack} has nothing that framework {name} takes"


def _releases(name: str, framework: Framework, stack: str, facts: Stack) -> str | None:
    lacking = [family for family in families(framework) if facts.release(family) is None]
    return f"stack {stack} has no release of {listed(lacking)}" if lacking else None


def _apart(name: str, framework: Framework, stack: str, facts: Stack) -> str | None:
    if facts.apart is None or len(framework.releases) < 2:
        return None
    return f"what framework {name} needs of stack {stack} does not go together ({facts.apart})"


def _python(matrix: Matrix, os: str, framework: Framework, stack: Stack) -> str | None:
    python = matrix.operating_systems[os].python
    for family in families(framework):
        releases, version = matrix.releases.of(family), stack.release(family) or ""
        if python in releases[version].python:
            continue
        others = [name for name, release in releases.items() if python in release.python]
        if not others:
            return f"no release of {family} has a wheel for Python {python}, the Python of {os}"
        return f"{family} {version} has no wheel for Python {python}, the Python of {os} ({listed(others)} has)"
    return None


def _architectures(matrix: Matrix, os: str, framework: Framework, stack: str) -> str | None:
    available = matrix.operating_systems[os].architectures
    common = set(available)
    for what, wheels in _available(matrix, framework, stack):
        if not common & set(wheels):
            if not wheels:
                return f"{what} has no wheel for stack {stack}"
            return f"{what} has {stack} wheels for {listed(wheels)} only, and {os} is built for {listed(available)}"
        common &= set(wheels)
    return None


def _available(matrix: Matrix, framework: Framework, stack: str) -> Iterator[tuple[str, Sequence[str]]]:
    """What a framework takes of a stack, and the architectures that it has wheels for."""
    facts = matrix.stacks[stack]
    wheels = {
        family: matrix.releases.of(family)[version].architectures(stack)
        for family in FAMILIES
        if (version := facts.release(family))
    }
    for family in families(framework):
        yield f"{family} {facts.release(family)}", wheels.get(family, ())
    if not framework.releases:  # CUDA's libraries come with the releases: they are where any of those is
        anywhere = [architecture for found in wheels.values() for architecture in found]
        yield f"CUDA {facts.cuda}", tuple(name for name in matrix.architectures if name in anywhere)
