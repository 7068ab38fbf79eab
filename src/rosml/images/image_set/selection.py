"""Selections of images: by name, pattern, group and architecture."""

from __future__ import annotations

import fnmatch
from collections.abc import Iterable, Sequence

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.images.image_set.model import Image, ImageSet


def select(image_set: ImageSet, only: Sequence[str]) -> tuple[Image, ...]:
    """The images that patterns of targets or tags, or groups, name; all images without any of these.

    Raises:
        RosmlError: a pattern names no image (exit code 2).
    """
    if not only:
        return image_set.images
    wanted: set[str] = set()
    for pattern in only:
        found = fnmatch.filter(image_set.by_target, pattern)
        if not found and ":" in pattern:
            found = [image.target for image in image_set.images if fnmatch.filter(image.tags, pattern)]
        if not found and pattern in image_set.groups:
            found = [name for name in image_set.groups[pattern] if name in image_set.by_target]
        if not found:
            raise RosmlError(unknown("image", pattern, image_set.by_target), "see all with: rosml list", exit_code=2)
        wanted.update(found)
    return tuple(image for image in image_set.images if image.target in wanted)


def require_architectures(image_set: ImageSet, names: Iterable[str]) -> None:
    """Checks names of architectures.

    Raises:
        RosmlError: the matrix has no architecture of that name (exit code 2).
    """
    known = image_set.matrix.architectures
    for name in names:
        if name not in known:
            raise RosmlError(unknown("architecture", name, known), f"there is {', '.join(known)}", exit_code=2)


def groups_of(image_set: ImageSet) -> list[str]:
    """All groups that `members` knows, including architectures and groups of images without a lock."""
    return sorted({group for image in image_set.images for group in (*image.groups, *image.architectures)})


def members(image_set: ImageSet, groups: Sequence[str] = ()) -> tuple[Image, ...]:
    """The images that are in all given groups, in the order of the matrix, including those without a lock. An architecture is the
    group of its images.

    Raises:
        RosmlError: there is no such group (exit code 2).
    """
    known = groups_of(image_set)
    for name in groups:
        if name not in known:
            raise RosmlError(unknown("group", name, known), f"there is {listed(known)}", exit_code=2)
    wanted = set(groups)
    return tuple(image for image in image_set.images if wanted <= {*image.groups, *image.architectures})


def none_in(groups: Sequence[str]) -> str:
    """The message if no image is in all given groups."""
    return f"no image is in all of {listed(groups)}; see why: rosml explain <distribution>-<component>-<framework>"


def architecture_of(image_set: ImageSet, platform: str) -> str:
    """The architecture of a platform such as `linux/arm64`.

    Raises:
        RosmlError: the matrix has no such platform (exit code 2).
    """
    known = {facts.platform: name for name, facts in image_set.matrix.architectures.items()}
    if platform not in known:
        raise RosmlError(unknown("platform", platform, known), f"take one of {listed(list(known))}", exit_code=2)
    return known[platform]
