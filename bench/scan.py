"""What a night's scan takes: trivy reads each SBOM once, however many images have that part. Measured with the SBOMs of one
image, and counted for all."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from bench.here import Here
from rosml import ROOT
from rosml.base.units import duration, size
from rosml.images.image_set.model import ImageSet
from rosml.images.scan.judge import Part
from rosml.images.scan.sbom import Shelf
from rosml.images.scan.trivy import ScannerFailed, Trivy

HEADING = "a scan of the whole matrix"


@dataclass(frozen=True)
class Scan:
    """A scan of all images.

    Attributes:
        images: all, on their architectures. ros, parts: SBOMs of ROS images, and of parts.
        ros_seconds, part_seconds: what trivy takes for one; `part_seconds` is the mean of an image's parts.
        ros_bytes, part_bytes: of one.
    """

    images: int
    ros: int
    parts: int
    ros_seconds: float
    part_seconds: float
    ros_bytes: int
    part_bytes: int

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)


def text(found: Scan) -> str:
    """For people."""
    seconds = found.ros * found.ros_seconds + found.parts * found.part_seconds
    read = found.ros * found.ros_bytes + found.parts * found.part_bytes
    return (
        f"{found.images} images on their architectures, {duration(seconds)}, {size(read)} read:"
        f" {found.ros} SBOMs of ROS images, {found.ros_seconds:.1f} s each,"
        f" and {found.parts} of parts, {found.part_seconds:.1f} s each (measured with those of one image, and multiplied)"
    )


def measure(here: Here, shelf: Shelf, parts: Sequence[Part]) -> Scan | None:
    """Scans what one image is the sum of, by the database that is there. None if there is no scanner, or no database.

    Args:
        here: is told why. shelf: has the SBOMs. parts: the ROS image, then its parts.

    Raises:
        ScannerFailed: trivy or the registry failed.
    """
    try:
        trivy = Trivy.find(ROOT)
        trivy.database()
    except ScannerFailed as error:
        here.say(f"no scan is measured: {error.message}; {error.remedy}")
        return None
    seconds, sizes = list[float](), list[int]()
    for part in parts:
        start = time.monotonic()
        content = shelf.load(part.repository, part.digest).content
        trivy.scan(content, part.name)
        seconds.append(time.monotonic() - start)
        sizes.append(len(content))
    others = len(parts) - 1
    return Scan(
        *_counts(here.image_set),
        seconds[0],
        sum(seconds[1:]) / max(1, others),
        sizes[0],
        sum(sizes[1:]) // max(1, others),
    )


def _counts(image_set: ImageSet) -> tuple[int, int, int]:
    ros = [image for image in image_set.images if not image.stack]
    return (
        sum(len(image.architectures) for image in image_set.images),
        sum(len(image.architectures) for image in ros),
        sum(len(part.architectures) for part in image_set.parts),
    )
