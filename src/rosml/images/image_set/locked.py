"""The usable locks, and an image set that knows which images and parts lack one."""

from __future__ import annotations

import os
from collections.abc import Collection
from dataclasses import replace
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.base.files import shown
from rosml.base.problems import some
from rosml.images.image_set import lock_file, missing_locks
from rosml.images.image_set.model import Environment, Image, ImageSet, Part
from rosml.images.matrix.names import ENVIRONMENTS, environments_end


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
    """An image set whose environments know what their locks say, and whose images know if that does not go with them."""
    image_set = replace(image_set, parts=tuple(_with_heads(part, root) for part in image_set.parts))
    images = (
        replace(image, misfit=_misfit(image, image_set, root)) if image.environment else image
        for image in image_set.images
    )
    return replace(image_set, images=tuple(images))


def _with_heads(part: Part, root: Path) -> Part:
    if not isinstance(part, Environment):
        return part
    texts = (_text(root / lock) for lock in part.locks if os.path.isfile(root / lock))
    if not (heads := [*filter(None, map(lock_file.environment_head, texts))]):
        return part
    needs = frozenset(package for head in heads for package in head.takes)
    return replace(part, takes=heads[0].releases, needs=needs, glibc=heads[0].glibc)


def _misfit(image: Image, image_set: ImageSet, root: Path) -> str:
    """Why the environment of an image does not go with it; empty if it does, or if nobody can tell, since a lock is missing."""
    environment = image_set.part_by_name[image.parts[-1]]
    assert isinstance(environment, Environment)
    lock, plain = environment.locks[0], image.target.removesuffix(environments_end([image.environment]))
    for release, version in environment.takes.items():
        if (has := image.versions.get(release)) != version:
            return f"{lock} takes {release} {version}, and {plain} has {f'{release} {has}' if has else f'no {release}'}"
    others = [root / other for other in image.locks if other not in environment.locks]
    if not all(map(os.path.isfile, others)):
        return ""
    packages = {lock_file.package_name(name) for other in others for name in lock_file.versions(_text(other))}
    lacking = sorted(environment.needs - packages)
    return f"{lock} takes {some(lacking)} of its image, and {plain} does not have that" if lacking else ""


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
        unfit = {lock for lock in image.locks if image.misfit and lock.startswith(f"{ENVIRONMENTS}/")}
        unlocked = tuple(lock for lock in image.locks if lock in absent or lock in unfit)
        damaged = tuple(lock for lock in unlocked if lock in unusable or lock in unfit)
        lost_locks = tuple(lock for lock in unlocked if lock in lost or lock in unfit)
        return replace(image, unlocked=unlocked, damaged=damaged, lost=lost_locks)

    images = tuple(
        without(image) if image.misfit or absent.intersection(image.locks) else image for image in image_set.images
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
