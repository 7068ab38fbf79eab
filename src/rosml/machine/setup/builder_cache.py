"""How much disk the builder's cache may take."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from pathlib import Path

GB = 1_000_000_000
LARGEST = 40
SMALLEST = 20
"""An image with PyTorch and CUDA takes most of it while it is built."""
FREE = 12

_LINES = re.compile(r'^  maxUsedSpace = "(\d+)GB"\n  minFreeSpace = "(\d+)GB"$', re.MULTILINE)


@dataclass(frozen=True)
class CacheLimits:
    """The limits of a builder's cache, in GB."""

    used: int = LARGEST
    free: int = FREE  # free blocks below which the builder prunes it

    @classmethod
    def kept(cls, file: Path, folder: Path) -> CacheLimits:
        """The limits in a builder's configuration, if it exists: with others, the builder would start again. Else those of the disk with `folder`."""
        match = _LINES.search(file.read_text(errors="replace")) if file.is_file() else None
        return cls(int(match[1]), int(match[2])) if match else cls._of_disk(folder)

    @classmethod
    def _of_disk(cls, folder: Path) -> CacheLimits:
        """Limits that leave half of a disk to others, such as the builders of other checkouts."""
        # BuildKit counts free blocks, also those that only root or nobody may use: these come on top of what stays free.
        disk = os.statvfs(folder)
        available, free_blocks = (blocks * disk.f_frsize / GB for blocks in (disk.f_bavail, disk.f_bfree))
        return cls(
            used=max(SMALLEST, min(LARGEST, int(available / 2))), free=FREE + max(0, int(free_blocks - available))
        )

    def lines(self) -> list[str]:
        return [f'  maxUsedSpace = "{self.used}GB"', f'  minFreeSpace = "{self.free}GB"']
