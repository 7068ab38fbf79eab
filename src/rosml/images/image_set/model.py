"""The model of the image set: the images and parts that a matrix allows, with all their facts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.problems import unknown
from rosml.images.matrix import names
from rosml.images.matrix.combinations import Brought
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.sizes import Size

PARTS = "part"
"""The repository of parts, without the registry's prefix."""

ENVIRONMENTS = "env"
"""The repository of environments, likewise."""


@dataclass(frozen=True)
class Part:
    """A part of a stack, built once and joined to many images.

    Attributes:
        name: `torch-cu128-py311`; also the tag in the repository `part`, and the key in DIGESTS.
        kind: its entry in the matrix, such as `torch`.
        stack: the name of its stack.
        python: its version of Python; `any` if the part fits every Python.
        os: the operating system on which it is built, one with that Python: the assembler of the matrix, or else the first by
            name.
        architectures: the architectures for which images need it.
        platforms: the same by BuildKit's names.
        locks: its lock for each architecture, relative to the project's root.
        disk: the forecast of its size.
        unlocked: locks that are missing, or do not match the matrix; the part cannot be built from these.
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

    @property
    def repository(self) -> str:
        """Its repository, without the registry's prefix."""
        return PARTS

    @property
    def tag(self) -> str:
        """Its tag there."""
        return self.name


@dataclass(frozen=True)
class Environment(Part):
    """An environment of Python packages beside ROS: a part at a prefix of its own, of no stack. Its name is `env:lerobot-py311`, its
    kind `env-lerobot`.

    Attributes:
        environment: its own name, `lerobot`.
        takes: the releases that it takes from its image, and their versions, by its locks; none if it has no lock.
        needs: the names of all packages that it takes.
        glibc: the N of the glibc 2.N that its locks are for; 0 if it has none.
    """

    environment: str = ""
    takes: Mapping[str, str] = field(default_factory=dict, hash=False)
    needs: frozenset[str] = frozenset()
    glibc: int = 0

    @property
    def repository(self) -> str:
        return ENVIRONMENTS

    @property
    def tag(self) -> str:
        return names.environment_name(self.environment, self.python)


@dataclass(frozen=True)
class Wheels:
    """The wheels of ROS itself, for a distribution without Debian packages. `locks` has the lock of each architecture, relative to the
    project's root."""

    distribution: str
    os: str
    python: str
    requirements: tuple[str, ...]
    architectures: tuple[str, ...]
    locks: tuple[str, ...]


_IN_JSON = (
    *(
        "target",
        "distribution",
        "component",
        "framework",
        "addons",
        "environment",
        "stack",
        "os",
        "python",
        "ros",
        "ros_distro",
    ),
    *("platforms", "versions", "repository", "tags", "groups", "parent", "packages", "wheels", "parts", "locks"),
    *("locked", "tests", "disk"),
)


@dataclass(frozen=True)
class Image:
    """An image with its resolved facts.

    Attributes:
        target: the name of its bake target.
        distribution, component, framework: its place on the axes.
        addons: the add-ons that it has besides.
        environment: the environment that it has beside ROS; empty if it has none.
        combination: framework and add-ons as in its target: `torch`, `onnx`, `torch-onnx`; `none`.
        stack: its stack; None for images without a framework.
        os: its operating system.
        python: the version of its Python.
        ros: 1 or 2.
        ros_distro: the value of ROS_DISTRO.
        architectures: architectures with the same content.
        platforms: the same by BuildKit's names.
        versions: the versions in it, e.g. `{"torch": "2.10.0", "cuda": "12.8.90"}`.
        brought: its software that labels and the environment name.
        gpu: the facts about GPUs in its labels (combinations.gpu).
        repository: its repository without the registry.
        tags: `repository:tag` without the registry; the first one is the main tag. None if it only tests its add-on.
        groups: bake groups that build it.
        parent: the target below it: for a ROS image the component below or the operating system, otherwise the ROS image to
            which parts are joined.
        packages: Debian packages that a ROS image adds to its parent, separated by spaces.
        wheels: Python packages that a ROS image gets instead of Debian packages.
        parts: parts that are joined to the parent, in this order.
        tests: the names of the files in tests/structure with which a publishing run tests it.
        shared: further tests that must pass in it. Other images run them for it (`proven_by`); if none exists, it runs them.
        carried: the tests that one image of a distribution runs for all with the same parts.
        carriers: the images that may run them, the best first.
        locks: the locks of its wheels of ROS, and of its parts.
        unlocked: missing or unusable locks. If it has some, it cannot be built, and is in no group.
        damaged: locks of `unlocked` that exist, but are damaged or do not match the matrix.
        lost: locks of `unlocked` that should exist, since they wait for no other index.
        misfit: why its environment does not go with it, by the environment's locks; empty if it does.
        disk: the forecast of its size with everything below it.
        budget: MB that parts of it may have together in the registry; None for any.
        budgeted: those parts: all, or, if it has an add-on, those that no framework of the stack has.
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
    budgeted: tuple[str, ...] = ()
    addons: tuple[str, ...] = ()
    combination: str = ""
    environment: str = ""
    misfit: str = ""

    @property
    def locked(self) -> bool:
        """Whether it can be built: it has every lock."""
        return not self.unlocked

    @property
    def proven_by(self) -> tuple[str, ...]:
        """The images whose tests also count for it: the ROS image below it, and the one that runs its shared tests."""
        below = () if self.parent.startswith("_") else (self.parent,)  # a stage of the Dockerfile is no image
        return tuple(name for name in dict.fromkeys((*below, *self.carriers[:1])) if name != self.target)

    @property
    def test_target(self) -> str:
        """The bake target that tests it."""
        return names.test_target(self.target)

    def to_json(self) -> dict[str, Any]:
        """For `rosml list --json`. Tags are without the registry, sizes in MB."""
        disk = {"unpacked": self.disk.unpacked, "compressed": self.disk.compressed}
        facts = {name: getattr(self, name) for name in _IN_JSON}
        return {**facts, "packages": self.packages.split(), "disk": disk}


@dataclass(frozen=True)
class ImageSet:
    """All images and parts of a matrix, in the order of the file. `base` is the matrix that a set extends."""

    matrix: Matrix
    images: tuple[Image, ...]
    parts: tuple[Part, ...]
    wheels: tuple[Wheels, ...] = ()
    base: Matrix | None = None

    @property
    def locks(self) -> set[str]:
        """Every needed lock, relative to the project's root."""
        wheels = {lock for item in self.wheels for lock in item.locks}
        return wheels.union(lock for part in self.parts for lock in part.locks)

    @property
    def parts_of_stacks(self) -> tuple[Part, ...]:
        """The parts without environments: `rosml locks` makes the locks of these."""
        return tuple(part for part in self.parts if not isinstance(part, Environment))

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
        """The targets of every bake group, without images that lack a lock, and without empty groups."""
        locked = {image.target: image for image in self.images if image.locked}
        members: dict[str, list[str]] = {"default": [name for name in self.matrix.default.group if name in locked]}
        for axis in names.AXES:
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
        """The image of a target, or of one of its tags, with or without the registry. `explain.image` says why there is none."""
        if image := self.by_target.get(target) or self.by_tag(target):
            return image
        raise RosmlError(unknown("image", target, self.by_target), remedy="see all with: rosml list", exit_code=2)

    def by_tag(self, reference: str) -> Image | None:
        """The image with a tag, with or without the registry before it."""
        tag = reference.rpartition("/")[2]
        return next((image for image in self.images if tag in image.tags), None) if ":" in tag else None


def tags_of(thing: Image | Part) -> list[str]:
    """The tags of an image or part, without the repository: the main one, those with versions, floating ones."""
    return [thing.tag] if isinstance(thing, Part) else [tag.split(":", 1)[1] for tag in thing.tags]
