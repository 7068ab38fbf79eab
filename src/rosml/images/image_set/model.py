"""Images and parts that a matrix allows, with all their facts: the image set."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

from rosml.base.errors import RosmlError
from rosml.base.problems import unknown
from rosml.images.matrix import names
from rosml.images.matrix.model import Matrix, Size
from rosml.images.matrix.rules import Brought

PARTS = "part"
"""The repository of parts, without the registry's prefix."""


@dataclass(frozen=True)
class Part:
    """A part of a stack, assembled once and added to many images.

    Attributes:
        name: `torch-cu128-py311`; also the tag in the repository `part`, and the key in DIGESTS.
        kind: the entry of the matrix that it is built from, such as `torch`.
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
    kind: str
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
        """The bake target of the part as an image of its own."""
        return names.part_target(self.name)


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
        brought: what of it labels and the environment name. gpu: what labels say of GPUs (rules.gpu).
        repository: without the registry. tags: `repository:tag` without the registry; the first one is the main tag.
        groups: bake groups that build it.
        parent: target that it stands on: of a ROS image the component below or the operating system, otherwise the
            ROS image that parts are joined to.
        packages: Debian packages that a ROS image adds to its parent, separated by spaces.
        wheels: Python packages that a ROS image gets in their place.
        parts: parts that are joined to the parent, in this order.
        tests: names of the files in tests/structure that a publishing run tests it with.
        shared: further ones that must hold in it, and that other images run for it (`proven_by`). It runs them itself where those
            are not there.
        carried: the tests that one image of a row runs for all with the same parts. carriers: the images that may be that one,
            the best first.
        locks: locks of the wheels that its ROS comes from, and of its parts.
        unlocked: those that are missing; without all of them it cannot be built, and is in no group.
        damaged: those of `unlocked` that are there, and damaged or not of what the matrix says now.
        lost: those of them that should be there, since they wait for no other index.
        disk: forecast of its size with everything below it.
        budget: MB that its parts may have together in the registry; None if that is left open.
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
    brought: tuple[Brought, ...] = ()
    gpu: dict[str, str] = field(default_factory=dict)
    shared: tuple[str, ...] = ()
    carried: tuple[str, ...] = ()
    carriers: tuple[str, ...] = ()
    unlocked: tuple[str, ...] = ()
    lost: tuple[str, ...] = ()
    damaged: tuple[str, ...] = ()
    budget: int | None = None

    @property
    def locked(self) -> bool:
        """Whether it can be built: every lock is there."""
        return not self.unlocked

    @property
    def proven_by(self) -> tuple[str, ...]:
        """The images whose tests count for it as well: the ROS image below it, and the one that runs what it shares with others."""
        below = () if self.parent.startswith("_") else (self.parent,)  # a stage of the Dockerfile is none
        return tuple(name for name in (*below, *self.carriers[:1]) if name != self.target)

    @property
    def test_target(self) -> str:
        """The bake target that tests it."""
        return names.test_target(self.target)


@dataclass(frozen=True)
class ImageSet:
    """All that a matrix describes, in the order of the file."""

    matrix: Matrix
    images: tuple[Image, ...]
    parts: tuple[Part, ...]
    wheels: tuple[Wheels, ...] = ()

    @property
    def locks(self) -> set[str]:
        """Every lock that is needed, relative to the project's root."""
        wheels = {lock for item in self.wheels for lock in item.locks}
        return wheels.union(lock for part in self.parts for lock in part.locks)

    @cached_property
    def by_target(self) -> dict[str, Image]:
        """Images by target."""
        return {image.target: image for image in self.images}

    @cached_property
    def part_by_name(self) -> dict[str, Part]:
        """Parts by name."""
        return {part.name: part for part in self.parts}

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
        members["parts"] = [part.target for part in self.parts if part.name in used]
        members["tests"] = [image.test_target for image in locked.values()]
        return {name: tuple(targets) for name, targets in members.items() if targets}

    def image(self, target: str) -> Image:
        """The image of a target, or of one of its tags, with or without the registry: `ros-torch:jazzy-base-cu128`.

        Raises:
            RosmlError: there is none (exit code 2); names near ones. `explain.image` says why there is none.
        """
        if image := self.by_target.get(target) or self.by_tag(target):
            return image
        raise RosmlError(unknown("image", target, self.by_target), remedy="see all with: rosml list", exit_code=2)

    def by_tag(self, reference: str) -> Image | None:
        """The image that has a tag, with or without the registry before it."""
        tag = reference.rpartition("/")[2]
        return next((image for image in self.images if tag in image.tags), None) if ":" in tag else None


def repository_of(thing: Image | Part) -> str:
    """The repository of an image or part, without the registry's prefix."""
    return PARTS if isinstance(thing, Part) else thing.repository


def tags_of(thing: Image | Part) -> list[str]:
    """The tags of an image or part, without the repository: the main one, those that spell versions out, floating ones."""
    return [thing.name] if isinstance(thing, Part) else [tag.split(":", 1)[1] for tag in thing.tags]
