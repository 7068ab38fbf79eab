"""Mounts that a killed builder left."""

from __future__ import annotations

import re
from pathlib import Path

from machine.console import Failure
from machine.install import output_of


def unmount_below(folder: Path) -> None:
    """Unmounts what a killed builder left mounted, so that removing its files stays within the folder.

    Raises:
        Failure: something stays mounted.
    """
    for point in reversed(mounted_below(folder)):
        output_of(["umount", "--lazy", point])
    left = mounted_below(folder)
    if left:
        raise Failure(f"still mounted: {', '.join(left)}", f"umount --lazy {left[-1]}")


def mounted_below(folder: Path) -> list[str]:
    """Mount points in a folder, outer ones first."""
    lines = Path("/proc/self/mounts").read_text().splitlines()
    points = [re.sub(r"\\([0-7]{3})", lambda match: chr(int(match[1], 8)), line.split(" ")[1]) for line in lines]
    return [point for point in points if point.startswith(f"{folder}/")]
