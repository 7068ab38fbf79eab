"""Why an image exists, or why it does not."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rosml import missing, names, rules
from rosml.errors import RosmlError
from rosml.expand import FLOATING, Catalogue, Image
from rosml.model import Apt, Distribution, Matrix, OperatingSystem
from rosml.problems import counted, listed, unknown


@dataclass(frozen=True)
class Wanted:
    """What a name asks for. `stack` is None where the name has none."""

    distribution: str
    component: str
    framework: str
    stack: str | None


def explain(catalogue: Catalogue, name: str) -> str:
    """The facts behind an image, payload or group; or one sentence about why the facts rule it out.

    Raises:
        RosmlError: the name is not understood at all (exit code 2); names near ones.
    """
    if not name:
        raise RosmlError("no image is named", remedy="name one: make explain TARGET=jazzy-robot", exit_code=2)
    tagged = catalogue.by_tag(name)
    if image := tagged or catalogue.by_target.get(name.removesuffix("-test"), catalogue.by_target.get(name)):
        return _image(catalogue.matrix, image)
    if payload := catalogue.payload_by_name.get(name.removeprefix("payload-")):
        users = sum(payload.name in image.parts for image in catalogue.images)
        return f"{payload.name}: {payload.part} of stack {payload.stack}, assembled from {listed(payload.locks)}, in {counted(users, 'image')}"
    if name in catalogue.groups:
        listed_by = "make list" if name in ("payloads", "tests") else f"make list GROUP={name}"
        return f"{name}: a group of {counted(len(catalogue.groups[name]), 'target')}; see them with: {listed_by}"
    if members := [image for image in catalogue.images if name in image.groups]:
        return f"{name}: a group of no targets: none of its images has a lock; {missing.remedy(members[0])}"
    if reason := why_not(catalogue, name):
        return reason
    raise RosmlError(unknown("image", name, _alike(catalogue, name)), remedy="see all with: make list", exit_code=2)


def _alike(catalogue: Catalogue, name: str) -> list[str]:
    """Among what near names are sought: for a tag, those of its repository."""
    repository = name.rpartition("/")[2].partition(":")[0] if ":" in name else ""
    tags = [tag for image in catalogue.images for tag in image.tags if image.repository == repository]
    return tags or [*catalogue.by_target, *catalogue.groups]


def why_not(catalogue: Catalogue, name: str) -> str | None:
    """One sentence about why a combination does not exist; None where it exists or the name is not understood."""
    if name in catalogue.by_target:
        return None
    for wanted in _readings(catalogue.matrix, name):
        if sentence := _reason(catalogue, name, wanted):
            return sentence
    return None


def _reason(catalogue: Catalogue, name: str, wanted: Wanted) -> str | None:
    matrix = catalogue.matrix
    if reason := rules.component_reason(matrix, wanted.distribution, wanted.component):
        return f"{name} does not exist: {reason}."
    os, facts = matrix.distributions[wanted.distribution].os, matrix.frameworks[wanted.framework]
    if wanted.stack or not facts.parts:
        if reason := rules.stack_reason(matrix, os, wanted.framework, wanted.stack):
            return f"{name} does not exist: {reason}."
        target = names.image_target(wanted.distribution, wanted.component, wanted.framework, wanted.stack)
        return f"{name} is called {target}."
    reasons = {stack: rules.stack_reason(matrix, os, wanted.framework, stack) for stack in matrix.stacks}
    image = wanted.distribution, wanted.component, wanted.framework
    if there := [names.image_target(*image, stack) for stack, reason in reasons.items() if reason is None]:
        return f"{name} names no stack; there is {listed(there)}."
    why = "; ".join(dict.fromkeys(reason for reason in reasons.values() if reason)) or "there is no stack"
    return f"{name} does not exist on any stack: {why}."


def _readings(matrix: Matrix, name: str) -> Iterator[Wanted]:
    """Every way to read a name as `<distribution>-<component>[-<framework>[-<stack>]]`, or as a tag. Without a component
    it is that of the short tags: `jazzy-torch` is read as `jazzy-base-torch`."""
    repository, colon, tag = name.rpartition("/")[2].partition(":")
    if colon:
        for framework, facts in matrix.frameworks.items():
            if facts.repository == repository:
                yield from _tag_readings(matrix, framework, tag)
        return
    for start, distribution, component in _starts(matrix):
        if name == start and component:
            yield Wanted(distribution, component, rules.plain(matrix), None)
        elif name.startswith(f"{start}-"):
            rest = name[len(start) + 1 :]
            for framework in matrix.frameworks:
                if rest == framework:
                    yield Wanted(distribution, component or FLOATING, framework, None)
                elif rest.startswith(f"{framework}-") and (stack := rest[len(framework) + 1 :]) in matrix.stacks:
                    yield Wanted(distribution, component or FLOATING, framework, stack)


def _tag_readings(matrix: Matrix, framework: str, tag: str) -> Iterator[Wanted]:
    """Every way to read a framework's tag as `<distribution>[-<component>][-<stack>]`."""
    for start, distribution, component in _starts(matrix):
        if tag == start:
            yield Wanted(distribution, component or FLOATING, framework, None)
        elif tag.startswith(f"{start}-") and (stack := tag[len(start) + 1 :]) in matrix.stacks:
            yield Wanted(distribution, component or FLOATING, framework, stack)


def _starts(matrix: Matrix) -> Iterator[tuple[str, str, str]]:
    """How names may begin, with the distribution and the component; those without a component last."""
    for distribution in matrix.distributions:
        for component in matrix.components:
            yield f"{distribution}-{component}", distribution, component
    if FLOATING in matrix.components:
        for distribution in matrix.distributions:
            yield distribution, distribution, ""


def _image(matrix: Matrix, image: Image) -> str:
    head = "exists:" if image.locked else "exists, but cannot be built yet:"
    return "\n".join([f"{image.target} {head}", *(f"  - {fact}" for fact in _facts(matrix, image))])


def _apt(distribution: Distribution, system: OperatingSystem, apt: Apt) -> str:
    if apt.channel == "live":
        source = system.apt_sources[distribution.generation]
        return f"packages come from ROS's live apt repository, set up by {distribution.generation}-apt-source {source.version}"
    which = f"of {apt.date}" if apt.date else "final, which gets no updates"
    return f"packages come from ROS's apt snapshot: {which}"


def _facts(matrix: Matrix, image: Image) -> Iterator[str]:
    system = matrix.operating_systems[image.os]
    yield f"{image.distribution} (ROS {image.ros}) has the component {image.component} and stands on {image.os}"
    yield f"{image.os} has Python {image.python} and numpy{system.numpy}, and is built for {listed(system.architectures)}"
    if image.stack:
        stack = matrix.stacks[image.stack]
        for family in rules.families(matrix.frameworks[image.framework]):
            release = matrix.releases.of(family)[stack.release(family) or ""]
            wheels = listed(release.architectures(image.stack))
            yield f"{family} {stack.release(family)} has a wheel for Python {image.python}, and {image.stack} wheels for {wheels}"
        yield f"stack {image.stack} carries {listed([f'{name} {version}' for name, version in image.versions.items()])}"
        yield f"it is {image.parent} joined with {listed(image.parts)}"
    else:
        yield f"it is {image.parent} with {image.packages} installed"
        if apt := matrix.distributions[image.distribution].apt:
            yield _apt(matrix.distributions[image.distribution], system, apt)
    yield f"platforms: {listed(image.platforms)}"
    for architecture in matrix.architectures:
        reason = rules.architecture_reason(matrix, image.os, image.framework, image.stack, architecture)
        if architecture not in image.architectures and reason:
            yield f"not for {architecture}: {reason}"
    yield f"tags: {listed(image.tags)}"
    if not image.locked:
        yield f"{missing.reason(image)}; {missing.remedy(image)}"
