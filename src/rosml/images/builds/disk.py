"""Disk space for a build, checked or freed before the build starts."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Iterable, Set
from pathlib import Path
from typing import TYPE_CHECKING

from rosml.base.errors import RosmlError
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix import rules

if TYPE_CHECKING:  # the pictures of docs/ need the forecast alone
    from rosml.machine.services import Services

RESERVE_MB = 2_000
"""Kept free beside the forecast, for logs, the builder's database and other programs."""

PRUNE_SECONDS = 600.0
"""Time limit of the builder to prune its cache."""


def needed_mb(image_set: ImageSet, image: Image, built: Iterable[str]) -> int:
    """Megabytes that building an image takes, without the parts that are built already.

    The builder holds a part unpacked twice: as it was built, and as the layer that is joined. It holds a ROS image
    unpacked once. The builder and the registry each hold both compressed.

    Args:
        built: names of the parts and targets that are built already.
    """
    present = built if isinstance(built, Set) else set(built)
    ros = 0 if image.target in present else _ros_mb(image_set, _ros(image_set, image), present)
    return ros + sum(part_mb(image_set.part_by_name[name]) for name in image.parts if name not in present)


def part_mb(part: Part) -> int:
    return 2 * part.disk.unpacked + 2 * part.disk.compressed


def tested_mb(image_set: ImageSet, image: Image, present: Set[str]) -> int:
    """Megabytes that testing an image takes if it was perhaps built elsewhere: it is pulled and unpacked.

    Args:
        present: names of the parts and targets that the builder has.
    """
    parts = [image_set.part_by_name[name].disk for name in image.parts if name not in present]
    return _ros_mb(image_set, _ros(image_set, image), present) + sum(size.unpacked + size.compressed for size in parts)


def _ros(image_set: ImageSet, image: Image) -> Image:
    """The image itself if it is a ROS image, or the ROS image below it; with the size in the image set."""
    return image_set.by_target[image.parent if image.stack else image.target]


def _ros_mb(image_set: ImageSet, image: Image, present: Set[str]) -> int:
    """Megabytes for a ROS image and the images below it, down to the first one that is built already."""
    if image.target in present:
        return 0
    below = image_set.by_target.get(image.parent)
    base = below.disk if below else rules.system_size(image_set.matrix, image.component)
    size = image.disk.unpacked - base.unpacked + 2 * (image.disk.compressed - base.compressed)
    if below:
        return size + _ros_mb(image_set, below, present)
    return size + (0 if image.parent in present else base.unpacked + 2 * base.compressed)


def layers(image_set: ImageSet, image: Image) -> dict[str, int]:
    """What an image is made of, from the bottom up, each with its compressed megabytes alone."""
    ros: list[tuple[str, int]] = []
    below: Image | None = _ros(image_set, image)
    while below:
        lower = image_set.by_target.get(below.parent)
        base = lower.disk if lower else rules.system_size(image_set.matrix, below.component)
        ros.append((below.target, below.disk.compressed - base.compressed))
        if not lower:
            ros.append((below.parent, base.compressed))
        below = lower
    return dict(reversed(ros)) | {name: image_set.part_by_name[name].disk.compressed for name in image.parts}


def registry_mb(image_set: ImageSet, images: Iterable[Image], architectures: Iterable[str]) -> int:
    """Megabytes that images take in a registry together, with the ROS images below them. It keeps each layer once."""
    counted = set(architectures)
    sizes = {
        (name, architecture): size
        for image in images
        for architecture in counted.intersection(image.architectures)
        for name, size in layers(image_set, image).items()
    }
    return sum(sizes.values())


def make_room(services: Services, needed: int, say: Callable[[str], None]) -> bool:
    """Prunes the builder's cache, the oldest entries first, until there is room for a build.

    The builder also prunes its cache itself, after a build and down to a fixed limit. An image with CUDA needs more
    room at once. The user's own builder may be on another machine, and is left alone.

    Args:
        needed: forecast in megabytes.

    Returns:
        Whether the builder may have removed something.
    """
    room, free = needed + RESERVE_MB, _free_mb(services.state)
    if services.builder_kind == "user" or free >= room:
        return False
    say(f"{gigabytes(free)} are free, and {gigabytes(room)} needed: the builder prunes its cache")
    arguments = ["prune", "--builder", services.builder, "--force", "--all", "--min-free-space", f"{room}MB"]
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
    if (free := _free_mb(services.state)) < room:
        remedy = "use a larger machine (architectures.*.runner in matrix.yaml)"
        say(f"{gigabytes(free)} are free now: if the disk gets full, {remedy}")
    return True


def require(path: Path, needed: int, target: str, say: Callable[[str], None]) -> None:
    """Checks that a file system has room for a build, and says what the build will need.

    Args:
        path: a folder on the file system of the builder and the registry.
        needed: forecast in megabytes.
    """
    free = _free_mb(path)
    if needed:
        say(f"{target} needs about {gigabytes(needed)} of disk; {gigabytes(free)} are free")
    if needed and free < needed + RESERVE_MB:
        raise RosmlError(
            f"not enough disk space to build {target}: {gigabytes(needed + RESERVE_MB)} are needed (forecast and reserve),"
            f" {gigabytes(free)} are free at {path}",
            "free some space ('rosml setup clean' removes what was made here), or choose a smaller target: rosml list",
        )


def _free_mb(path: Path) -> int:
    return shutil.disk_usage(path).free // 1_000_000


def gigabytes(megabytes: int) -> str:
    """`12345` -> `12.3 GB`."""
    return f"{megabytes / 1000:.1f} GB"
