"""Explains why an image exists, or why it does not."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from rosml.base import clock
from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed, some, unknown
from rosml.images.image_set import addons, apt_repository, missing_locks, search
from rosml.images.image_set.labels import ENVIRONMENTS_FOLDER
from rosml.images.image_set.model import Environment, Image, ImageSet
from rosml.images.matrix import combinations, lacks, names, support
from rosml.images.matrix.model import ANY_PYTHON, Matrix
from rosml.images.matrix.tags import FLOATING, main_tag


@dataclass(frozen=True)
class Wanted:
    """The facts in a name. `stack` is None if the name has none."""

    distribution: str
    component: str
    framework: str
    stack: str | None


@dataclass(frozen=True)
class Explained:
    """The explanation of a name.

    Attributes:
        target: the image, part or group that the name means; the name itself if there is none.
        exists: whether there is one, with its lock or without.
        reasons: the facts behind it; or one sentence that says why it does not exist, or what it is.
        head: the line before several reasons.
    """

    target: str
    exists: bool
    reasons: tuple[str, ...]
    head: str = ""

    @property
    def text(self) -> str:
        """For people."""
        return "\n".join([self.head, *(f"  - {reason}" for reason in self.reasons)]) if self.head else self.reasons[0]

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {"target": self.target, "exists": self.exists, "reasons": list(self.reasons)}


def explained(image_set: ImageSet, name: str, environ: Mapping[str, str] = os.environ) -> Explained:
    """Explains why an image, part or group exists, or why not. ROS_CHANNEL and ROS_SNAPSHOT of `environ` choose another apt repository
    of ROS."""
    if not name:
        raise RosmlError("no image is named", remedy="name one: rosml explain jazzy-robot", exit_code=2)
    tagged = image_set.by_tag(name)
    if image := tagged or image_set.by_target.get(name.removesuffix("-test"), image_set.by_target.get(name)):
        head = f"{image.target} {'exists' if image.locked else 'exists, but cannot be built yet'}:"
        return Explained(image.target, True, tuple(_facts(image_set.matrix, image, environ)), head)
    part_tag = re.fullmatch(r"(?:.*/)?part:(.+)", name)
    if addon_image := _addon(image_set.matrix, name):
        return addon_image
    by_target = {part.target: part for part in image_set.parts}
    if part := image_set.part_by_name.get(part_tag[1] if part_tag else name.rpartition("/")[2]) or by_target.get(name):
        users = sum(part.name in image.parts for image in image_set.images)
        of = (
            f"environment {part.environment}" if isinstance(part, Environment) else f"{part.kind} of stack {part.stack}"
        )
        text = f"{part.name}: {of}, built from {listed(part.locks)}, in {counted(users, 'image')};"
        text += f" rosml part {part.name} builds it, and COPY --link adds it to an image"
        return Explained(part.name, True, (text,))
    if part_tag:
        if reason := _no_part(image_set.matrix, part_tag[1]):
            return Explained(name, False, (reason,))
        begun = [part for part in image_set.part_by_name if part.startswith(f"{part_tag[1]}-")]
        text = f"no part named {part_tag[1]!r}; there is {some(begun)}"
        text = text if begun else unknown("part", part_tag[1], image_set.part_by_name)
        raise RosmlError(text, "see all with: rosml part", exit_code=2)
    if addon := next(
        (text for text in (name, names.our_word(image_set.matrix, name)) if text in image_set.matrix.addons), ""
    ):
        head = f"{addon} is an add-on: it goes onto any image of its stacks, without an image of its own."
        return Explained(addon, True, tuple(_of_addon(image_set, addon)), head)
    name = name.removeprefix("env:") if name.removeprefix("env:") in image_set.matrix.environments else name
    if name in image_set.groups:
        listed_by = "rosml list" if name in ("parts", "tests") else f"rosml list {name}"
        text = f"{name}: a group of {counted(len(image_set.groups[name]), 'target')}; see them with: {listed_by}"
        about = lacks.sentences(image_set.matrix, {name} & image_set.matrix.distributions.keys())
        return Explained(name, True, ("\n".join([text, *about]),))
    if members := [image for image in image_set.images if name in image.groups]:
        text = f"{name}: a group of no targets: none of its images has a lock; {missing_locks.remedy(members[0])}"
        return Explained(name, True, (text,))
    if reason := why_not(image_set, name):
        return Explained(name, False, (reason,))
    if targets := search.having(image_set, name):
        text = f"{name}: {counted(len(targets), 'image')}; see them with: rosml list {name}"
        return Explained(name, True, (text,))
    text = unknown("image", name, _alike(image_set, name))
    suggestion = f"; for an image of your own: rosml explain {name} --addons onnx" if re.search("[:/]", name) else ""
    raise RosmlError(text, f"see all with: rosml list{suggestion}", exit_code=2)


def _addon(matrix: Matrix, name: str) -> Explained | None:
    """Which images can have an add-on of a stack: `onnx-cu130`. None if the name is of none."""
    addon = addons.read(matrix, name)
    if not addon.addon or addon.stack not in matrix.stacks:
        return None
    head = f"{name} is an add-on of stack {addon.stack}; docs/addons.md says how to add it:"
    return Explained(name, True, tuple(addons.described(matrix, addon.addon, addon.stack)), head)


def _no_part(matrix: Matrix, name: str) -> str | None:
    """Why a stack has no part for a Python, if a rule says so: `onnxruntime-cu130-py310`."""
    for kind, stack in product((part.name for part in matrix.parts), matrix.stacks):
        for row, facts in matrix.distributions.items():
            if name == names.part_name(kind, stack, matrix.operating_systems[facts.os].python):
                takers = [(item, "") for item, it in matrix.frameworks.items() if kind in it.parts]
                takers += [(combinations.plain(matrix), item) for item, it in matrix.addons.items() if kind in it.parts]
                reasons = [combinations.stack_reason(matrix, row, framework, stack, item) for framework, item in takers]
                why = "; ".join(dict.fromkeys(filter(None, reasons)))
                return f"there is no part {name}: {why}." if why and None not in reasons else None
    return None


def with_addons(matrix: Matrix, image: Image, name: str, addon_names: Sequence[str]) -> Explained:
    """Whether an image can have add-ons, and how it gets them; or why not, and what to take instead."""
    onto = addons.Onto(name, image.distribution, image.component, image.framework, image.stack or "")
    for item in addon_names:
        if refused := addons.refused(matrix, onto, item):
            return Explained(name, False, (f"{refused.message}; {refused.remedy}.",))
    read = [addons.read(matrix, item) for item in addon_names]
    stacks = {image.stack or item.stack for item in read}
    if len(stacks) > 1:
        return Explained(name, False, (f"an image has one stack, and these are of {listed(sorted(stacks))}.",))
    [stack] = stacks
    carried_parts = matrix.carrying(image.framework, *image.addons).parts
    parts = [
        part for item in read for part in addons.parts(matrix, image.distribution, item.addon, stack, carried_parts)
    ]
    if not parts:
        return Explained(name, True, (f"{name} has {listed(addon_names)} already",))
    held = [part for item in read for part in matrix.addons[item.addon].parts if matrix.part[part].restricted]
    lines = [*added(image.tags[0] if image.tags else name, addon_names, [*dict.fromkeys(parts)])]
    lines += [f"the licence of {listed(held)} keeps the result out of public registries"] if held else []
    for architecture, addon in product(image.architectures, (item.addon for item in read)):
        place = image.distribution, image.framework, stack, architecture, addon
        if reason := combinations.architecture_reason(matrix, *place):
            lines.append(f"not for {architecture}: {reason}")
    return Explained(name, True, tuple(lines), can_have(name, addon_names))


def can_have(name: str, addon_names: Sequence[str]) -> str:
    """The first line of the answer that an image can have add-ons."""
    return f"{name} can have {listed(addon_names)}:"


def added(image: str, addon_names: Sequence[str], parts: Sequence[str], place: str = "REGISTRY/part") -> Iterator[str]:
    """Lines about the two ways in which an image gets add-ons. `parts` are those that it lacks, in the repository `place`."""
    yield f"it lacks {'the part' if len(parts) == 1 else 'the parts'} {listed(parts)}"
    yield f"for your packages: rosml containerize --base-image {image} --addons {','.join(addon_names)}"
    complete = image if "/" in image else f"REGISTRY/{image}"
    yield f"in a registry: rosml join {complete} {place}:{addons.braced(parts)} --tag {complete}-with-{addon_names[0]}"


def _alike(image_set: ImageSet, name: str) -> list[str]:
    """The names among which we look for similar ones: for a tag, those of its repository."""
    repository = name.rpartition("/")[2].partition(":")[0] if ":" in name else ""
    tags = [tag for image in image_set.images for tag in image.tags if image.repository == repository]
    return tags or [*image_set.by_target, *image_set.groups]


def _with_environment(image_set: ImageSet, name: str) -> str | None:
    """How an image gets an environment with which it is not built; None if the name is of none."""
    plain, _, environment = name.rpartition("-env-")
    image = image_set.by_target.get(plain) or image_set.by_tag(plain)
    if image is None or environment not in image_set.matrix.environments:
        return None
    tag = next(iter(image.tags), image.target)
    join = f"rosml join REGISTRY/{tag} env:{environment} --tag REGISTRY/NAME:TAG"
    return f"{image.target} is not built with the environment {environment}; if it has what that takes: {join}."


def why_not(image_set: ImageSet, name: str) -> str | None:
    """One sentence about why a combination does not exist; None if it exists, or if the name cannot be read."""
    if name in image_set.by_target:
        return None
    for row, facts in image_set.matrix.distributions.items():
        if name in facts.aliases:
            return f"{name} is called {row}."
    if image_set.base and (sentence := _not_chosen(image_set.matrix, image_set.base, name)):
        return sentence
    if sentence := _with_environment(image_set, name):
        return sentence
    for reading in _readings(image_set.matrix, name):
        if sentence := _reason(image_set, name, reading):
            return sentence
    if sentence := _with_addon(image_set.matrix, name):
        return sentence
    for matrix in filter(None, (image_set.matrix, image_set.base)):
        meant = _in_our_words(matrix, name)
        if meant != name and (image_set.by_target.get(meant) or image_set.by_tag(meant)):
            return f"{name} is called {meant}."
        if meant != name and (sentence := why_not(image_set, meant)):
            return sentence
    return None


def _with_addon(matrix: Matrix, name: str) -> str | None:
    """Why there is no image with an add-on: the stack cannot have it, or it is joined to an image; None if the name has no add-on."""
    for addon in matrix.addons:
        short = re.sub(rf"-{addon}(?=-|:|$)", "", name)
        bare = re.sub(rf"(?<=-){addon}-(?={'|'.join(matrix.stacks)}$)", f"{combinations.plain(matrix)}-", name)
        for reading in (item for text in (short, bare) if text != name for item in _readings(matrix, text)):
            row, component, framework, stack = reading.distribution, reading.component, reading.framework, reading.stack
            if reason := combinations.component_reason(matrix, row, component):
                return f"{name} does not exist: {reason}."
            stacks = [stack] if stack else [*matrix.stacks]
            reasons = {item: combinations.stack_reason(matrix, row, framework, item, addon) for item in stacks}
            if not (possible := [item for item, reason in reasons.items() if reason is None]):
                why = "; ".join(dict.fromkeys(reason for reason in reasons.values() if reason))
                onto = addons.Onto(name, row, component, framework, "")
                return f"{name} does not exist: {why}; {addons.instead(matrix, onto, addon)}."
            facts = matrix.frameworks[framework]
            base = f"{facts.repository}:{main_tag(row, component, possible[0] if facts.parts else None)}"
            called = addon if facts.parts else f"{addon}-{possible[0]}"
            return f"{name} has no tag: {addon} is an add-on; take {base}, and --addons {called}, or join its parts: rosml join --help."
    return None


def _not_chosen(matrix: Matrix, base: Matrix, name: str) -> str | None:
    """What a set does not choose of the matrix that it extends, and an image needs; None if that is nothing."""
    for reading in _readings(base, name):
        row, component, stack = reading.distribution, reading.component, reading.stack
        distribution = matrix.distributions.get(row)
        lacks = {
            f"the distribution {row}": not distribution,
            f"the component {component} of {row}": distribution and component not in distribution.components,
            f"the framework {reading.framework}": reading.framework not in matrix.frameworks,
            f"the stack {stack}": stack and stack not in matrix.stacks,
        }
        left_out = [name for name, is_lacking in lacks.items() if is_lacking]
        reason = combinations.component_reason(base, row, component) or _stack_reason(base, reading)
        if left_out and not combinations.component_reason(base, row, component):
            end = f", and is not in rosml either: {reason}." if reason else "; it is in rosml: name it in set.yaml."
            return f"{name} does not exist in this set, which does not choose {listed(left_out)}{end}"
    return None


def _stack_reason(matrix: Matrix, reading: Wanted) -> str | None:
    """Why no stack that a name can mean carries the framework."""
    several = matrix.frameworks[reading.framework].parts and not reading.stack
    stacks = tuple(matrix.stacks) if several else (reading.stack,)
    reasons = [combinations.stack_reason(matrix, reading.distribution, reading.framework, stack) for stack in stacks]
    return None if None in reasons else "; ".join(dict.fromkeys(filter(None, reasons)))


def _in_our_words(matrix: Matrix, name: str) -> str:
    """A name as others write it, in our words: `jazzy-base-tf-cu128`, `rwthika/ros2-torch:jazzy-ros-base`."""
    name = name.lower()
    if ":" not in name:
        return "-".join(names.our_word(matrix, word) for word in name.split("-"))
    repository, _, tag = name.rpartition("/")[2].partition(":")
    return f"{re.sub('^ros2(?=-|$)', 'ros', repository)}:{tag.replace('-ros-', '-')}"


def image(image_set: ImageSet, name: str) -> Image:
    """The image of a target, or of one of its tags, with or without the registry: `ros-torch:jazzy-base-cu128`."""
    if name not in image_set.by_target and not image_set.by_tag(name) and (reason := why_not(image_set, name)):
        raise RosmlError(reason, remedy="see all with: rosml list", exit_code=2)
    return image_set.image(name)


def _reason(image_set: ImageSet, name: str, reading: Wanted) -> str | None:
    matrix = image_set.matrix
    if reason := combinations.component_reason(matrix, reading.distribution, reading.component):
        base = image_set.base if image_set.base and reading.distribution in image_set.base.distributions else matrix
        reason = combinations.component_reason(base, reading.distribution, reading.component) or reason
        other = lacks.with_component(base, reading.distribution, reading.component)
        return f"{name} does not exist: {reason}{f'; {other} has it' if other else ''}."
    row, facts = reading.distribution, matrix.frameworks[reading.framework]
    if reading.stack or not facts.parts:
        if reason := combinations.stack_reason(matrix, row, reading.framework, reading.stack):
            return f"{name} does not exist: {reason}."
        target = names.image_target(reading.distribution, reading.component, reading.framework, reading.stack)
        if ":" in name and target in image_set.by_target:
            stack = combinations.default_stack(matrix, row, reading.framework)
            short = f"short ones are for stack {stack} alone"
            why = short if stack else "the distribution's default stack has no such framework"
            return f"there is no tag {name}: {why}; take {image_set.by_target[target].tags[0]}."
        return f"{name} is called {target}."
    reasons = {stack: combinations.stack_reason(matrix, row, reading.framework, stack) for stack in matrix.stacks}
    image = reading.distribution, reading.component, reading.framework
    if targets := [names.image_target(*image, stack) for stack, reason in reasons.items() if reason is None]:
        return f"{name} names no stack; there is {listed(targets)}."
    why = "; ".join(dict.fromkeys(reason for reason in reasons.values() if reason)) or "there is no stack"
    return f"{name} does not exist on any stack: {why}."


def _readings(matrix: Matrix, name: str) -> Iterator[Wanted]:
    """Every way to read a name as `<distribution>-<component>[-<framework>[-<stack>]]`, or as a tag,
    `<repository>:<distribution>-<component>[-<stack>]`. Without a component, it has that of the short tags: `jazzy-torch` means
    `jazzy-base-torch`."""
    name = name.rpartition("/")[2]
    components = {component: f"-{component}" for component in matrix.components}
    short = {FLOATING: ""} if FLOATING in components else {}
    called = [(row, name) for name, facts in matrix.distributions.items() for row in (name, *facts.aliases)]
    starts = [*product(called, components.items()), *product(called, short.items())]
    for (row, distribution), (component, word) in starts:
        start = f"{row}{word}"
        if name == start and word:
            yield Wanted(distribution, component, combinations.plain(matrix), None)
        for framework, stack in product(matrix.frameworks, (None, *matrix.stacks)):
            end = f"-{stack}" if stack else ""
            if name in (f"{start}-{framework}{end}", f"{matrix.frameworks[framework].repository}:{start}{end}"):
                yield Wanted(distribution, component, framework, stack)


def _where_from(matrix: Matrix, image: Image, environ: Mapping[str, str]) -> Iterator[str]:
    this_time = bool(environ.get("ROS_CHANNEL") or environ.get("ROS_SNAPSHOT"))
    archive = apt_repository.of(matrix, image.distribution, environ)
    if archive and (this_time or not image.stack):
        kinds = {
            "live": "ROS's live apt repository",
            "testing": "ROS's testing repository, before they are released",
            "final": "ROS's apt snapshot: final, which gets no updates",
            apt_repository.ARCHIVE: f"the suite {archive.codename} of an apt archive",
        }
        kind = kinds.get(archive.channel, f"ROS's apt snapshot: of {archive.day}")
        yield f"{'this time, ' * this_time}packages come from {kind}, {archive.address}"


def _of_addon(image_set: ImageSet, addon: str) -> Iterator[str]:
    """What an add-on brings, where it exists, and how you take it."""
    matrix = image_set.matrix
    entries = [matrix.part[part] for part in matrix.addons[addon].parts]
    yield f"its parts: {listed([entry.name for entry in entries])}"
    if any(entry.restricted for entry in entries):
        yield "its licence keeps it out of public registries: docs/licences.md"
    for it in addons.on_stacks(image_set, addon):
        pythons = [python for python in it.pythons if python != ANY_PYTHON]
        python = f", Python {listed(pythons)}" if pythons else ""
        yield f"{it.stack}: {listed(it.brings)} for {listed(it.platforms)}{python}"
    images = [image for image in image_set.images if addon in image.addons]
    tags = [image.tags[0] for image in images if image.tags]
    yield f"tags with it: {some(tags)}" if tags else "no tag has it"
    yield f"{counted(len(images) - len(tags), 'image')} without a tag for its tests: rosml list {addon}"
    usual = [image_set.by_target[target] for target in matrix.default.targets if target in image_set.by_target]
    for image in (*usual, *image_set.images):
        taken = next((item for item in addons.fitting(matrix, image) if image.tags and item.addon == addon), None)
        if taken:
            yield f"onto the base image of your packages, for example: {_containerize(image, taken)}"
            yield f"onto an image in a registry, for example: {taken.joins(image.tags[0])}"
            break


def _containerize(image: Image, addon: addons.Fitting) -> str:
    return f"rosml containerize --base-image {image.tags[0]} --addons {addon.called}"


def _taken(matrix: Matrix, image: Image) -> Iterator[str]:
    fitting = [*addons.fitting(matrix, image)] if image.tags else []
    if fitting and not image.stack:
        called = listed([item.called for item in fitting])
        yield f"add-ons that it can take: {called}; for example: {_containerize(image, fitting[0])}"
        return
    for item in fitting:
        only = f" for {listed(item.platforms)}" * (item.platforms != image.platforms)
        private = " (private registries alone)" * item.restricted
        yield f"it can take the add-on {item.addon}{only}{private}: {_containerize(image, item)}, or {item.joins(image.tags[0])}"


def _facts(matrix: Matrix, image: Image, environ: Mapping[str, str]) -> Iterator[str]:
    system, distribution = matrix.operating_systems[image.os], matrix.distributions[image.distribution]
    yield f"{image.distribution} (ROS {image.ros}) has the component {image.component} and stands on {image.os}"
    yield f"{image.os} has Python {image.python} and numpy{system.numpy}, and is built for {listed(system.architectures)}"
    yield from support.ends(matrix, [image.distribution], clock.today())
    if sentence := lacks.sentence(matrix, image.distribution, image.framework, image.stack):
        yield sentence
    if distribution.experimental:
        # The page is about ROS 2 from wheels.
        page = "docs/limits.md says what it has, and " if distribution.wheels else ""
        yield f"{image.distribution} is experimental: {page}it never gets the tag latest"
    # A name that begins with _ is a stage of the Dockerfile, which has no image.
    stands_on = image.os if image.parent.startswith("_") else image.parent
    if image.stack:
        stack = matrix.stacks[image.stack]
        for family in combinations.families(matrix, matrix.carrying(image.framework, *image.addons)):
            version = stack.releases[family]
            release = matrix.releases[family][version]
            wheels = listed(release.architectures(image.stack))
            yield f"{family} {version} has a wheel for Python {image.python}, and {image.stack} wheels for {wheels}"
            if company := combinations.company(matrix, image.stack, [family]):
                yield f"with it {'go' if len(company) > 1 else 'goes'} {listed([' '.join(item) for item in company.items()])}"
            if release.environment:
                yield f"its images have {listed([f'{name}={value}' for name, value in release.environment.items()])}"
        yield f"stack {image.stack} carries {listed([f'{name} {version}' for name, version in image.versions.items()])}"
        yield f"it is {image.parent} joined with {listed(image.parts)}"
        if image.environment:
            yield f"environment {image.environment} is below {ENVIRONMENTS_FOLDER}; docs/environments.md says how to use it"
    elif image.wheels:
        yield f"it is {stands_on} with ROS from wheels: {listed(image.wheels)}, and what they need, by {listed(image.locks)}"
    else:
        yield f"it is {stands_on} with {image.packages} installed"
    yield from _where_from(matrix, image, environ)
    yield f"platforms: {listed(image.platforms)}"
    for architecture in matrix.architectures:
        reason = combinations.architecture_reason(
            matrix, image.distribution, image.framework, image.stack, architecture, *image.addons
        )
        if architecture not in image.architectures and reason:
            yield f"not for {architecture}: {reason}"
    yield f"tags: {listed(image.tags)}" if image.tags else f"tags: none; it tests {listed(image.addons)}"
    yield from _taken(matrix, image)
    yield f"a publishing run tests it with {listed(image.tests)}"
    if image.shared:
        yield f"what it shares with others is tested in {listed(image.proven_by)}: {listed(image.shared)}"
    if not image.locked:
        yield f"{missing_locks.reason(image)}; {missing_locks.remedy(image)}"
