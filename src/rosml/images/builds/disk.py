"""Disk space: what a build will need, checked, or made, before it starts instead of in its middle."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Iterable, Set
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix import rules
from rosml.machine.services import Services

RESERVE_MB = 2_000
"""Left free beside the forecast: logs, the builder's bookkeeping, everybody else's."""

PRUNE_SECONDS = 600.0
"""How long the builder may take to remove what it keeps."""


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
        total += _ros_mb(image_set, _ros(image_set, image), done)
    for name in image.parts:
        if name not in done:
            total += part_mb(image_set.part_by_name[name])
    return total


def part_mb(part: Part) -> int:
    """Megabytes that assembling a part takes."""
    return 2 * part.disk.unpacked + 2 * part.disk.compressed


def tested_mb(image_set: ImageSet, image: Image, there: Set[str]) -> int:
    """Megabytes that testing an image takes that was made before, elsewhere for all that is known: it is fetched and unpacked.

    Args:
        there: names of the parts, and targets, that the builder has.
    """
    parts = [image_set.part_by_name[name].disk for name in image.parts if name not in there]
    return _ros_mb(image_set, _ros(image_set, image), there) + sum(size.unpacked + size.compressed for size in parts)


def _ros(image_set: ImageSet, image: Image) -> Image:
    """The ROS image that an image is, or that parts are joined to, with the size that the image set says."""
    return image_set.by_target[image.parent if image.stack else image.target]


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


def make_room(services: Services, needed: int, say: Callable[[str], None]) -> bool:
    """Has the builder forget what no build uses, the oldest first, until there is room for a build.

    The builder prunes its cache by itself, after a build and down to a limit that is the same for all; an image with CUDA needs
    more at once. A builder that somebody brought may be on another machine, and is left alone.

    Args:
        needed: forecast in megabytes. say: told of it, and if there is too little even so.

    Returns:
        Whether the builder may have forgotten something.
    """
    if services.builder_kind == "user" or _free_mb(services.state) >= needed + RESERVE_MB:
        return False
    wanted = f"{needed + RESERVE_MB}MB"
    say(
        f"{gigabytes(_free_mb(services.state))} are free, and {gigabytes(needed + RESERVE_MB)} needed: the builder prunes its cache"
    )
    arguments = ["prune", "--builder", services.builder, "--force", "--all", "--min-free-space", wanted]
    try:
        subprocess.run(
            [*services.buildx, *arguments],
            env=services.environment(),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=PRUNE_SECONDS,
            check=True,
        )
    except (OSError, subprocess.SubprocessError) as error:
        say(f"the builder's cache was not pruned: {error}")
    if (free := _free_mb(services.state)) < needed + RESERVE_MB:
        say(
            f"{gigabytes(free)} are free now: if the disk gets full, take a machine with more (architectures.*.runner in matrix.yaml)"
        )
    return True


def require(path: Path, needed: int, target: str) -> None:
    """Checks that a file system has room for a build.

    Args:
        path: a folder on the file system that the builder and the registry use.
        needed: forecast in megabytes.
        target: for the message.

    Raises:
        RosmlError: there is too little, with the numbers.
    """
    free = _free_mb(path)
    if needed and free < needed + RESERVE_MB:
        raise RosmlError(
            f"not enough disk space to build {target}: {gigabytes(needed + RESERVE_MB)} are needed (forecast and reserve),"
            f" {gigabytes(free)} are free at {path}",
            "free some space ('rosml setup clean' removes what was made here), or take a smaller target: rosml list",
        )


def _free_mb(path: Path) -> int:
    """Megabytes that are free on a folder's file system."""
    return shutil.disk_usage(path).free // 1_000_000


def gigabytes(megabytes: int) -> str:
    """``12345`` -> ``12.3 GB``."""
    return f"{megabytes / 1000:.1f} GB"
