"""Disk space for a build, checked or freed before the build starts."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Iterable, Iterator, Set
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING

from rosml.base.errors import RosmlError
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix import combinations

if TYPE_CHECKING:  # the pictures of docs/ need the forecast alone
    from rosml.machine.services import Services

RESERVE_MB = 2_000
"""Kept free beside the forecast, for logs, the builder's database and other programs."""

PRUNE_SECONDS = 600.0


def needed_mb(image_set: ImageSet, image: Image, present: Set[str]) -> int:
    """Megabytes that building an image takes, without the parts that are built already.

    The builder holds a part unpacked twice: as it was built, and as the layer that is joined. It holds a ROS image
    unpacked once. The builder and the registry each hold both compressed.
    """
    ros = 0 if image.target in present else _ros_mb(image_set, image, present)
    return ros + sum(part_mb(image_set.part_by_name[name]) for name in image.parts if name not in present)


def part_mb(part: Part) -> int:
    return 2 * part.disk.unpacked + 2 * part.disk.compressed


def tested_mb(image_set: ImageSet, image: Image, present: Set[str]) -> int:
    """Megabytes that testing an image takes: what the builder does not have yet is pulled and unpacked."""
    parts = [image_set.part_by_name[name].disk for name in image.parts if name not in present]
    return _ros_mb(image_set, image, present) + sum(size.unpacked + size.compressed for size in parts)


def _ros_images(image_set: ImageSet, image: Image) -> Iterator[tuple[str, int, int]]:
    """The ROS images below an image and the system, from the top: megabytes of each alone, unpacked and compressed."""
    above: Image | None = image_set.by_target[image.parent if image.stack else image.target]
    while above:
        below = image_set.by_target.get(above.parent)
        base = below.disk if below else combinations.system_size(image_set.matrix, above.component)
        yield above.target, above.disk.unpacked - base.unpacked, above.disk.compressed - base.compressed
        if not below:
            yield above.parent, base.unpacked, base.compressed
        above = below


def _ros_mb(image_set: ImageSet, image: Image, present: Set[str]) -> int:
    """Megabytes for the ROS images of an image, down to the first one that is built already."""
    missing = takewhile(lambda ros: ros[0] not in present, _ros_images(image_set, image))
    return sum(unpacked + 2 * compressed for _, unpacked, compressed in missing)


def layers(image_set: ImageSet, image: Image) -> dict[str, int]:
    """The images and parts that an image consists of, from the bottom up, each with its compressed megabytes alone."""
    ros = [(name, compressed) for name, _, compressed in _ros_images(image_set, image)]
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
    room at once. The user's own builder may be on another machine, and is left alone; so is Docker's, which has the cache of their other builds. Returns whether it may have removed something.
    """
    room, free = needed + RESERVE_MB, _free_mb(services.state)
    if services.builder_kind in ("user", "engine") or free >= room:
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
    """Checks that the file system of the builder and the registry has room for a build, and says what it will need."""
    if not needed:
        return
    free = _free_mb(path)
    say(f"{target} needs about {gigabytes(needed)} of disk; {gigabytes(free)} are free")
    if free < needed + RESERVE_MB:
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
