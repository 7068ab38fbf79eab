"""Disk space: what a build will need, checked before it starts instead of in its middle."""

from __future__ import annotations

import shutil
from collections.abc import Iterable, Set
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.images.image_set import Image, ImageSet
from rosml.matrix import rules

RESERVE_MB = 2_000
"""Left free beside the forecast: logs, the builder's bookkeeping, everybody else's."""


def needed_mb(image_set: ImageSet, image: Image, built: Iterable[str]) -> int:
    """Megabytes that building an image takes, without the parts that are built already.

    A part stands unpacked twice in the builder (assembled, and as the layer that is joined) and compressed twice
    (in the builder and in the registry); a ROS image unpacked once and compressed twice.

    Args:
        image_set: all that the matrix describes.
        image: what is to be built.
        built: names of the parts and targets that are there already.
    """
    done = built if isinstance(built, Set) else set(built)
    total = 0
    if image.target not in done:
        total += _ros_mb(image_set, image_set.by_target[image.parent] if image.stack else image, done)
    for name in image.parts:
        if name not in done:
            size = image_set.part_by_name[name].disk
            total += 2 * size.unpacked + 2 * size.compressed
    return total


def _ros_mb(image_set: ImageSet, image: Image, done: Set[str]) -> int:
    """Megabytes for a ROS image and what it stands on, down to the first one that is built."""
    if image.target in done:
        return 0
    below = image_set.by_target.get(image.parent)
    base = below.disk if below else rules.system_size(image_set.matrix, image.component)
    own = image.disk.unpacked - base.unpacked + 2 * (image.disk.compressed - base.compressed)
    if below:
        return own + _ros_mb(image_set, below, done)
    return own + (0 if image.parent in done else base.unpacked + 2 * base.compressed)


def require(path: Path, needed: int, target: str) -> None:
    """Checks that a file system has room for a build.

    Args:
        path: a folder on the file system that the builder and the registry use.
        needed: forecast in megabytes.
        target: for the message.

    Raises:
        RosmlError: there is too little, with the numbers.
    """
    free = shutil.disk_usage(path).free // 1_000_000
    if needed and free < needed + RESERVE_MB:
        raise RosmlError(
            f"not enough disk space to build {target}: {gigabytes(needed + RESERVE_MB)} are needed (forecast and reserve),"
            f" {gigabytes(free)} are free at {path}",
            "free some space ('rosml setup clean' removes what was made here), or take a smaller target: rosml list",
        )


def gigabytes(megabytes: int) -> str:
    """``12345`` -> ``12.3 GB``."""
    return f"{megabytes / 1000:.1f} GB"
