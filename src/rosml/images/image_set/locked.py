"""The usable locks, and an image set that knows which images and parts lack one."""

from __future__ import annotations

import os
from collections.abc import Collection
from dataclasses import replace
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.base.files import shown
from rosml.images.image_set import lock_file, missing_locks
from rosml.images.image_set.model import Environment, Image, ImageSet, Part
from rosml.images.matrix.names import ENVIRONMENTS


def current_locks(image_set: ImageSet, root: Path, only: Collection[str] | None = None) -> frozenset[str]:
    """The usable locks: they exist, are complete, and match the matrix. `only`: the locks to look at; all if left out."""
    present = locks(root) if only is None else locks(root).intersection(only)
    wheels = frozenset(
        lock
        for item in image_set.wheels
        for architecture, lock in zip(item.architectures, item.locks, strict=True)
        if lock in present and lock_file.current_wheels(_text(root / lock), item, architecture)
    )
    return wheels | frozenset(
        lock
        for part in image_set.parts
        for architecture, lock in zip(part.architectures, part.locks, strict=True)
        if lock in present and _is_current(_text(root / lock), part, image_set, architecture)
    )


def _is_current(text: str, part: Part, image_set: ImageSet, architecture: str) -> bool:
    if isinstance(part, Environment):
        return lock_file.current_environment(text, part, architecture)
    return lock_file.current(text, part, image_set.matrix, architecture)


def with_environments(image_set: ImageSet, root: Path) -> ImageSet:
    """An image set whose environments know what their first lock says: the releases that they take, and their glibc."""
    return replace(image_set, parts=tuple(_with_head(part, root) for part in image_set.parts))


def _with_head(part: Part, root: Path) -> Part:
    if not isinstance(part, Environment):
        return part
    texts = (_text(root / lock) for lock in part.locks if os.path.isfile(root / lock))
    head = next(filter(None, map(lock_file.environment_head, texts)), None)
    return replace(part, takes=head.releases, glibc=head.glibc) if head else part


def _text(file: Path) -> str:
    try:
        text = file.read_bytes().decode(errors="replace")
    except OSError as error:
        raise RosmlError(f"{shown(file)}: cannot be read: {error.strerror}", "give this user read access") from None
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def unusable_locks(image_set: ImageSet, root: Path, present: Collection[str]) -> frozenset[str]:
    """The locks whose files exist, but are not usable."""
    return frozenset(lock for lock in image_set.locks.difference(present) if os.path.lexists(root / lock))


def with_locks(image_set: ImageSet, present: Collection[str], unusable: Collection[str] = ()) -> ImageSet:
    """An image set that knows which of its images and parts lack a lock, or have one that is not usable."""
    absent = image_set.locks.difference(present)
    lost = absent - missing_locks.waiting(image_set.matrix, image_set.parts_of_stacks)

    def without(image: Image) -> Image:
        unfit = {lock for part in environments.get(image.target, ()) for lock in part.locks if _misses(image, part)}
        unlocked = tuple(lock for lock in image.locks if lock in absent or lock in unfit)
        damaged = tuple(lock for lock in unlocked if lock in unusable or lock in unfit - absent)
        lost_locks = tuple(lock for lock in unlocked if lock in lost or lock in unfit)
        return replace(image, unlocked=unlocked, damaged=damaged, lost=lost_locks)

    environments = {
        image.target: [part for name in image.parts if isinstance(part := image_set.part_by_name[name], Environment)]
        for image in image_set.images
        if image.environment
    }
    images = tuple(
        without(image) if image.environment or absent.intersection(image.locks) else image for image in image_set.images
    )
    locked = {image.target for image in images if image.locked}

    def carried(image: Image) -> Image:
        """The image with its shared tests in the first carrier that can be built, which may be itself."""
        carriers = tuple(name for name in image.carriers if name in locked) or image.carriers
        if carriers[:1] != (image.target,):
            return image if carriers == image.carriers else replace(image, carriers=carriers)
        shared = tuple(name for name in image.shared if name not in image.carried)
        return replace(
            image, carriers=carriers, tests=tuple(dict.fromkeys((*image.tests, *image.carried))), shared=shared
        )

    images = tuple(map(carried, images))
    parts = tuple(
        replace(part, unlocked=tuple(lock for lock in part.locks if lock in absent)) for part in image_set.parts
    )
    return replace(image_set, images=images, parts=parts)


def _misses(image: Image, part: Environment) -> bool:
    """Whether an environment takes a release that an image does not have."""
    return any(image.versions.get(name) != version for name, version in part.takes.items())


def locks(root: Path) -> frozenset[str]:
    """The existing locks, relative to the project's root."""
    every = set[str]()
    for folder in (root / "locks", root / ENVIRONMENTS):
        if folder.exists() and not os.access(folder, os.R_OK | os.X_OK):
            raise RosmlError(f"{shown(folder)} cannot be read", "make it a folder that you can read")
        files = (
            os.path.join(above, name) for above, _, names in os.walk(folder) for name in names if name.endswith(".txt")
        )
        every |= {f"{folder.name}{file.removeprefix(str(folder))}" for file in files if os.path.isfile(file)}
    return frozenset(every)
