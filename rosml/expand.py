"""The facts of a matrix -> every image and payload that they allow."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice
from pathlib import Path

from rosml import ROOT, missing, names, rules
from rosml.errors import RosmlError
from rosml.model import (
    ANY_PYTHON,
    FAMILY_OF,
    FOR_ANY_PYTHON,
    UNTESTED,
    Distribution,
    Framework,
    Matrix,
    Part,
    Size,
    Stack,
)
from rosml.problems import SHOWN, InputError, listed, unknown
from rosml.problems import Path as Place
from rosml.source import Document, read, shown
from rosml.structure import validate


@dataclass(frozen=True)
class Payload:
    """A part of a stack, assembled once and added to many images.

    Attributes:
        name: `torch-cu128-py311`; also the tag in the repository `payload`, and the key in DIGESTS.
        part: `cuda`, `common`, `torch`, `tensorflow-cc` or `tensorflow`.
        stack: name of the stack.
        python: version of Python, `any` where the part is the same for all.
        os: operating system that it is assembled on, one with that Python: the assembler of the matrix, or else the first
            by name.
        architectures: those that images need it for.
        platforms: the same as BuildKit calls them.
        locks: its lock for each architecture, relative to the project's root.
        disk: forecast of its size.
        unlocked: the locks that are missing, or not of what the matrix says now; it cannot be assembled from these.
    """

    name: str
    part: Part
    stack: str
    python: str
    os: str
    architectures: tuple[str, ...]
    platforms: tuple[str, ...]
    locks: tuple[str, ...]
    disk: Size
    unlocked: tuple[str, ...] = ()

    @property
    def target(self) -> str:
        """The bake target of the payload as an image of its own."""
        return names.payload_target(self.name)


@dataclass(frozen=True)
class Wheels:
    """The wheels that ROS itself comes from, of a distribution without Debian packages.

    Attributes:
        distribution: whose they are. os: its operating system. python: version of that one's Python.
        requirements: what the matrix names.
        architectures: those that images exist for. locks: the lock for each, relative to the project's root.
    """

    distribution: str
    os: str
    python: str
    requirements: tuple[str, ...]
    architectures: tuple[str, ...]
    locks: tuple[str, ...]


@dataclass(frozen=True)
class Image:
    """An image with its resolved facts.

    Attributes:
        target: name of the bake target.
        distribution, component, framework: its place on the axes.
        stack: None for images without a framework.
        os: operating system. python: version of its Python. ros: 1 or 2. ros_distro: value of ROS_DISTRO.
        architectures: architectures with the same content; platforms: the same as BuildKit calls them.
        versions: what it carries, e.g. `{"torch": "2.10.0", "cuda": "12.8.90"}`.
        repository: without the registry. tags: `repository:tag` without the registry; the first one is the main tag.
        groups: bake groups that build it.
        parent: target that it stands on: of a ROS image the component below or the operating system, otherwise the
            ROS image that payloads are joined to.
        packages: Debian packages that a ROS image adds to its parent, separated by spaces.
        wheels: Python packages that a ROS image gets in their place.
        parts: payloads that are joined to the parent, in this order.
        tests: names of the files in tests/structure, those of its ancestors first.
        covered: targets of images with all its layers and more frameworks, on all its architectures. What takes longer
            than all other tests runs in them, and not in this one, unless a lock is missing to build any of them.
        locks: locks of the wheels that its ROS comes from, and of its payloads.
        unlocked: those that are missing; without all of them it cannot be built, and is in no group.
        lost: those of them that should be there, since they wait for no other index.
        disk: forecast of its size with everything below it.
        budget: MB that its payloads may have together in the registry; None if that is left open.
    """

    target: str
    distribution: str
    component: str
    framework: str
    stack: str | None
    os: str
    python: str
    ros: int
    ros_distro: str
    architectures: tuple[str, ...]
    platforms: tuple[str, ...]
    versions: dict[str, str]
    repository: str
    tags: tuple[str, ...]
    groups: tuple[str, ...]
    parent: str
    packages: str
    parts: tuple[str, ...]
    tests: tuple[str, ...]
    locks: tuple[str, ...]
    disk: Size
    wheels: tuple[str, ...] = ()
    covered: tuple[str, ...] = ()
    unlocked: tuple[str, ...] = ()
    lost: tuple[str, ...] = ()
    budget: int | None = None

    @property
    def locked(self) -> bool:
        """Whether it can be built: every lock is there."""
        return not self.unlocked

    @property
    def test_target(self) -> str:
        """The bake target that tests it."""
        return names.test_target(self.target)


@dataclass(frozen=True)
class Catalogue:
    """All that a matrix describes, in the order of the file."""

    matrix: Matrix
    images: tuple[Image, ...]
    payloads: tuple[Payload, ...]
    wheels: tuple[Wheels, ...] = ()

    @property
    def locks(self) -> set[str]:
        """Every lock that is needed, relative to the project's root."""
        wheels = {lock for item in self.wheels for lock in item.locks}
        return wheels.union(lock for payload in self.payloads for lock in payload.locks)

    @cached_property
    def by_target(self) -> dict[str, Image]:
        """Images by target."""
        return {image.target: image for image in self.images}

    @cached_property
    def payload_by_name(self) -> dict[str, Payload]:
        """Payloads by name."""
        return {payload.name: payload for payload in self.payloads}

    @cached_property
    def groups(self) -> dict[str, tuple[str, ...]]:
        """Targets of every bake group; images without a lock, and groups without a target, are left out."""
        locked = {image.target: image for image in self.images if image.locked}
        members: dict[str, list[str]] = {"default": [name for name in self.matrix.default.group if name in locked]}
        for axis in ("distributions", "components", "frameworks", "stacks"):
            members.update({name: [] for name in getattr(self.matrix, axis)})
        for image in locked.values():
            for group in image.groups:
                if group != "default":
                    members.setdefault(group, []).append(image.target)
        used = {name for image in locked.values() for name in image.parts}
        members["payloads"] = [payload.target for payload in self.payloads if payload.name in used]
        members["tests"] = [image.test_target for image in locked.values()]
        return {name: tuple(targets) for name, targets in members.items() if targets}

    def image(self, target: str) -> Image:
        """The image of a target, or of one of its tags, with or without the registry: `ros-torch:jazzy-base-cu128`.

        Raises:
            RosmlError: there is none (exit code 2); names near ones, or says why the facts rule it out.
        """
        if target in self.by_target:
            return self.by_target[target]
        if image := self.by_tag(target):
            return image
        from rosml.explain import why_not  # imports this module

        reason = why_not(self, target) or unknown("image", target, self.by_target)
        raise RosmlError(reason, remedy="see all with: make list", exit_code=2)

    def by_tag(self, reference: str) -> Image | None:
        """The image that has a tag, with or without the registry before it."""
        tag = reference.rpartition("/")[2]
        return next((image for image in self.images if tag in image.tags), None) if ":" in tag else None


PAYLOADS = "payload"
"""The repository of payloads, without the registry's prefix."""


def repository_of(thing: Image | Payload) -> str:
    """The repository of an image or payload, without the registry's prefix."""
    return PAYLOADS if isinstance(thing, Payload) else thing.repository


def tags_of(thing: Image | Payload) -> list[str]:
    """The tags of an image or payload, without the repository: the main one, those that spell versions out, floating ones."""
    return [thing.name] if isinstance(thing, Payload) else [tag.split(":", 1)[1] for tag in thing.tags]


def load(file: Path, root: Path = ROOT) -> Catalogue:
    """Reads, validates and expands a matrix, and looks which locks are there.

    Args:
        file: the matrix.
        root: the project's root, where the locks are.

    Raises:
        RosmlError: the file cannot be read (exit code 2).
        InputError: it has problems: all that can be seen at once, each with its place (exit code 2).
    """
    result = catalogue(read(file))
    return with_locks(result, current_locks(result, root))


def current_locks(catalogue: Catalogue, root: Path) -> frozenset[str]:
    """The locks that can be used: they are there, whole, and hold what the facts say now."""
    from rosml import lockfile  # needs the types from here

    present = names.locks(root)
    wheels = frozenset(
        lock
        for item in catalogue.wheels
        for architecture, lock in zip(item.architectures, item.locks, strict=True)
        if lock in present and lockfile.current_wheels(_text(root / lock), item, architecture)
    )
    return wheels | frozenset(
        lock
        for payload in catalogue.payloads
        for architecture, lock in zip(payload.architectures, payload.locks, strict=True)
        if lock in present
        and lockfile.current(_text(root / lock), payload, catalogue.matrix.stacks[payload.stack], architecture)
    )


def _text(file: Path) -> str:
    """A lock's text.

    Raises:
        RosmlError: it is there and cannot be read: that is another matter than a lock that nobody made yet.
    """
    try:
        return file.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise RosmlError(f"{shown(file)}: cannot be read: {error.strerror}", "give this user read access") from None


def with_locks(catalogue: Catalogue, present: Collection[str]) -> Catalogue:
    """A catalogue that knows which of its images and payloads lack a lock."""
    absent = catalogue.locks.difference(present)
    lost = absent - missing.waiting(catalogue.matrix, catalogue.payloads)

    def without(image: Image) -> Image:
        unlocked = tuple(lock for lock in image.locks if lock in absent)
        return replace(image, unlocked=unlocked, lost=tuple(lock for lock in unlocked if lock in lost))

    images = tuple(without(image) if absent.intersection(image.locks) else image for image in catalogue.images)
    locked = {image.target for image in images if image.locked}

    def alone(image: Image) -> Image:
        """With all tests, since none of the images that cover it can be built."""
        long = long_tests(catalogue.matrix.distributions[image.distribution])
        return replace(image, tests=tuple(dict.fromkeys((*image.tests, *long))))

    images = tuple(alone(image) if image.covered and locked.isdisjoint(image.covered) else image for image in images)
    payloads = tuple(
        replace(payload, unlocked=tuple(lock for lock in payload.locks if lock in absent))
        for payload in catalogue.payloads
    )
    return replace(catalogue, images=images, payloads=payloads)


def long_tests(distribution: Distribution) -> tuple[str, ...]:
    """What an image is tested with unless another one covers it: a workspace is built, each component's programs run, pip
    installs. ROS from wheels has no messages to build and no components, and is so small that pip is tried in all."""
    ros = f"ros{distribution.ros}"
    return ("pip",) if distribution.wheels else (f"{ros}-workspace", f"{ros}-components", "pip")


def catalogue(document: Document) -> Catalogue:
    """The catalogue of a parsed matrix; raises as `load` does."""
    result = expand(validate(document))
    if found := [document.problem(path, text) for path, text in islice(_collisions(result), SHOWN + 1)]:
        raise InputError(document.name, found)
    return result


def expand(matrix: Matrix) -> Catalogue:
    """Every image and payload of a matrix whose references hold."""
    images = tuple(_images(matrix))
    return Catalogue(matrix, images, tuple(_payloads(matrix, images)), tuple(_wheels(matrix)))


def combinations(matrix: Matrix) -> Iterator[tuple[str, str, str, str | None]]:
    """Distribution, component, framework and stack of everything that could be asked for."""
    kinds = [
        (framework, stack)
        for framework, facts in matrix.frameworks.items()
        for stack in (matrix.stacks if facts.parts else (None,))
    ]
    for distribution in matrix.distributions:
        for framework, stack in kinds:
            for component in matrix.components:
                yield distribution, component, framework, stack


@dataclass(frozen=True)
class _Kind:
    """What images of one distribution with one framework and stack have in common.

    `covering`: the frameworks whose images have all their layers and more.
    """

    framework: str
    facts: Framework
    stack: str | None
    architectures: tuple[str, ...]
    payloads: tuple[Payload, ...]
    versions: dict[str, str]
    covering: tuple[str, ...] = ()


def _images(matrix: Matrix) -> Iterator[Image]:
    latest = _latest(matrix)
    for name, distribution in matrix.distributions.items():
        for framework, facts in matrix.frameworks.items():
            for stack in matrix.stacks if facts.parts else (None,):
                if rules.stack_reason(matrix, name, framework, stack) is None:
                    kind = _kind(matrix, name, distribution, framework, stack)
                    for component in matrix.components:
                        if component in distribution.present:
                            yield _image(matrix, name, distribution, component, kind, name == latest)


def _kind(matrix: Matrix, name: str, distribution: Distribution, framework: str, stack: str | None) -> _Kind:
    facts = matrix.frameworks[framework]
    architectures = rules.architectures(matrix, name, framework, stack)
    python = matrix.operating_systems[distribution.os].python
    if stack is None:
        return _Kind(framework, facts, None, architectures, (), {})
    parts = rules.parts(facts, matrix.stacks[stack])
    payloads = tuple(_payload(matrix, part, stack, python, architectures) for part in parts)
    covering = tuple(
        other
        for other, more in matrix.frameworks.items()
        if facts.releases
        and set(facts.releases) < set(more.releases)
        and rules.stack_reason(matrix, name, other, stack) is None
        and set(architectures) <= set(rules.architectures(matrix, name, other, stack))
    )
    return _Kind(framework, facts, stack, architectures, payloads, _versions(facts, matrix.stacks[stack]), covering)


def _versions(framework: Framework, stack: Stack) -> dict[str, str]:
    return {name: version for name in rules.counted(framework) if (version := getattr(stack, name))}


def _image(matrix: Matrix, name: str, distribution: Distribution, component: str, kind: _Kind, latest: bool) -> Image:
    chain = _chain(matrix, distribution, component)
    ros_image = names.image_target(name, component)
    below = names.image_target(name, chain[-2]) if len(chain) > 1 else names.os_target(distribution.os)
    target = names.image_target(name, component, kind.framework, kind.stack)
    groups = [name, component, kind.framework, *([kind.stack] if kind.stack else []), "all"]
    ros = f"ros{distribution.ros}"
    ml = ["ml"] if len(kind.facts.releases) > 1 else []
    apt = [ros, *(f"{ros}-{link}" for link in chain)]
    long = long_tests(distribution) if distribution.wheels or not kind.covering else ()
    shared = [payload.part for payload in kind.payloads if payload.part not in UNTESTED]
    wheels = _wheels_of(matrix, name, kind.architectures)
    return Image(
        target=target,
        distribution=name,
        component=component,
        framework=kind.framework,
        stack=kind.stack,
        os=distribution.os,
        python=matrix.operating_systems[distribution.os].python,
        ros=distribution.ros,
        ros_distro=distribution.ros_distro or name,
        architectures=kind.architectures,
        platforms=tuple(matrix.architectures[architecture].platform for architecture in kind.architectures),
        versions=kind.versions,
        repository=kind.facts.repository,
        tags=_tags(distribution, name, component, kind, latest),
        groups=(*groups, "default") if target in matrix.default.group else tuple(groups),
        parent=ros_image if kind.stack else below,
        packages="" if kind.stack else _packages(matrix, name, distribution, component),
        wheels=() if kind.stack else distribution.wheels,
        parts=tuple(payload.name for payload in kind.payloads),
        tests=("contract", *([f"{ros}-wheels"] if distribution.wheels else apt), *shared, *ml, *long),
        covered=tuple(names.image_target(name, component, other, kind.stack) for other in kind.covering),
        locks=(
            *(lock for item in wheels for lock in item.locks),
            *(lock for item in kind.payloads for lock in item.locks),
        ),
        disk=Size.total(
            matrix.disk.os,
            *(matrix.disk.components[link] for link in chain),
            *(payload.disk for payload in kind.payloads),
        ),
        budget=matrix.disk.budgets.get(kind.stack or "", {}).get(kind.framework),
    )


def _chain(matrix: Matrix, distribution: Distribution, component: str) -> tuple[str, ...]:
    """The components that one is built on, lowest first, itself last; those that the distribution lacks are skipped."""
    return tuple(link for link in rules.chain(matrix, component) if link in distribution.present)


def _packages(matrix: Matrix, name: str, distribution: Distribution, component: str) -> str:
    metapackage = matrix.components[component].metapackage or component
    ros_distro = distribution.ros_distro or name
    return (distribution.packages or "").format(component=component, metapackage=metapackage, ros_distro=ros_distro)


def _tags(distribution: Distribution, name: str, component: str, kind: _Kind, latest: bool) -> tuple[str, ...]:
    main = names.main_tag(name, component, kind.stack)
    tags = list(dict.fromkeys((main, names.spelled_tag(main, kind.versions))))
    if component == FLOATING and kind.stack in (None, distribution.default_stack):
        tags += [name, *(["latest"] if latest else [])]
    return tuple(f"{kind.facts.repository}:{tag}" for tag in tags)


FLOATING = "base"
"""The component of the short tags: `ros:jazzy` is `ros:jazzy-base`."""


def _latest(matrix: Matrix) -> str | None:
    """The newest long-term distribution that has the component of the short tags: the one that lives longest. None that
    is experimental."""
    rows = matrix.distributions.items()
    lasting = [(row.eol, name, row) for name, row in rows if row.lts and row.eol and not row.experimental]
    living = [(eol, name) for eol, name, row in lasting if FLOATING in row.present]
    return max(living)[1] if living else None


def _wheels(matrix: Matrix) -> Iterator[Wheels]:
    """Of each distribution without Debian packages."""
    for name in matrix.distributions:
        yield from _wheels_of(matrix, name, rules.built_for(matrix, name))


def _wheels_of(matrix: Matrix, name: str, architectures: tuple[str, ...]) -> tuple[Wheels, ...]:
    """The wheels that ROS comes from on some architectures; none where it comes from Debian packages."""
    distribution = matrix.distributions[name]
    python = matrix.operating_systems[distribution.os].python
    locks = tuple(names.lock_path(name, architecture, python, names.ROS) for architecture in architectures)
    found = Wheels(name, distribution.os, python, distribution.wheels, architectures, locks)
    return (found,) if distribution.wheels else ()


def _payload(matrix: Matrix, part: Part, stack: str, python: str, architectures: tuple[str, ...]) -> Payload:
    pythons = _pythons(matrix, part, stack) if part in FOR_ANY_PYTHON else (python,)
    fitting = sorted(name for name, system in matrix.operating_systems.items() if system.python in pythons)
    assembler = matrix.default.assembler
    os = assembler if assembler in fitting or not fitting else fitting[0]
    if part in FOR_ANY_PYTHON:
        python = ANY_PYTHON
    return Payload(
        name=names.payload_name(part, stack, python),
        part=part,
        stack=stack,
        python=python,
        os=os,
        architectures=architectures,
        platforms=tuple(matrix.architectures[architecture].platform for architecture in architectures),
        locks=tuple(names.lock_path(stack, architecture, python, part) for architecture in architectures),
        disk=matrix.disk.parts[stack][part],
    )


def _pythons(matrix: Matrix, part: Part, stack: str) -> tuple[str, ...]:
    """The Pythons of the wheels that a part for any Python is taken from; none where the wheels say the same themselves."""
    family = FAMILY_OF.get(part)
    return matrix.releases.of(family)[matrix.stacks[stack].release(family) or ""].python if family else ()


def _payloads(matrix: Matrix, images: tuple[Image, ...]) -> Iterator[Payload]:
    """Each payload that an image needs, once, for all architectures that any image needs it for."""
    needed: dict[tuple[str, str], dict[Part, set[str]]] = {}
    for image in images:
        if image.stack:
            parts = needed.setdefault((image.stack, image.python), {})
            for part in rules.parts(matrix.frameworks[image.framework], matrix.stacks[image.stack]):
                parts.setdefault(part, set()).update(image.architectures)
    merged: dict[str, tuple[Part, str, str, set[str]]] = {}
    for (stack, python), parts in needed.items():
        for part, wanted in parts.items():
            name = names.payload_name(part, stack, ANY_PYTHON if part in FOR_ANY_PYTHON else python)
            merged.setdefault(name, (part, stack, python, set()))[3].update(wanted)
    for part, stack, python, wanted in merged.values():
        yield _payload(matrix, part, stack, python, tuple(name for name in matrix.architectures if name in wanted))


def _collisions(catalogue: Catalogue) -> Iterator[tuple[Place, str]]:
    """Names that two things would share, and names in `default` that nothing has."""
    owners: dict[str, str] = {}  # of targets and tags
    yield from _shared_by_images(catalogue, owners)
    yield from _shared_by_payloads(catalogue)
    yield from _taken(catalogue, owners)
    yield from _unusable_defaults(catalogue)


def _shared_by_images(catalogue: Catalogue, owners: dict[str, str]) -> Iterator[tuple[Place, str]]:
    """Targets and tags that two images would share; and writes down whose they are."""
    for image in catalogue.images:
        for target in (image.target, image.test_target):
            if target in owners:
                text = f"{image.target} and {owners[target]} would both be the target {target}; rename one"
                yield ("distributions", image.distribution), text
            owners.setdefault(target, image.target)
        for tag in image.tags:
            if owners.setdefault(tag, image.target) != image.target:
                text = f"{image.target} and {owners[tag]} would both have the tag {tag}; rename one"
                yield ("distributions", image.distribution), text


def _shared_by_payloads(catalogue: Catalogue) -> Iterator[tuple[Place, str]]:
    """Names that the payloads of two stacks would share."""
    sources: dict[str, tuple[Part, str, str]] = {}
    for stack, python, framework in {(image.stack, image.python, image.framework): None for image in catalogue.images}:
        for part in (
            rules.parts(catalogue.matrix.frameworks[framework], catalogue.matrix.stacks[stack]) if stack else ()
        ):
            source = (part, stack or "", ANY_PYTHON if part in FOR_ANY_PYTHON else python)
            name = names.payload_name(*source)
            if sources.setdefault(name, source) != source:
                yield (
                    ("stacks", source[1]),
                    f"{source[1]} and {sources[name][1]} would share the payload {name}; rename one",
                )


def _taken(catalogue: Catalogue, owners: Mapping[str, str]) -> Iterator[tuple[Place, str]]:
    """Groups and payloads whose names are those of targets."""
    taken = owners.keys() | {payload.target for payload in catalogue.payloads}
    for axis in ("distributions", "components", "frameworks", "stacks"):
        for name in getattr(catalogue.matrix, axis):
            if name in taken:
                yield (axis, name), f"the group {name} would have the name of a target; rename it"
    for payload in catalogue.payloads:
        if payload.name in owners:  # both are keys of DIGESTS
            text = f"{payload.name} is the name of a payload and of an image; rename one"
            yield ("stacks", payload.stack), text
        if payload.target in owners:
            yield ("stacks", payload.stack), f"{payload.target} is a payload and an image; rename one"


def _unusable_defaults(catalogue: Catalogue) -> Iterator[tuple[Place, str]]:
    """Default stacks and targets that there are not."""
    carried = {(image.distribution, image.stack) for image in catalogue.images if len(image.parts) > 1}
    for name, distribution in catalogue.matrix.distributions.items():
        if (name, distribution.default_stack) not in carried and any(row == name and stack for row, stack in carried):
            there = dict.fromkeys(stack for row, stack in carried if row == name and stack)
            text = f"no framework exists for {name} on stack {distribution.default_stack}; there is {listed(sorted(there))}"
            yield ("distributions", name, "default_stack"), text
    default = catalogue.matrix.default
    targets: list[tuple[Place, str]] = [(("default", "target"), default.target)]
    targets += [(("default", "group", index), name) for index, name in enumerate(default.group)]
    for path, name in targets:
        if name not in catalogue.by_target:
            from rosml.explain import why_not  # imports this module

            yield path, why_not(catalogue, name) or unknown("image", name, catalogue.by_target)
