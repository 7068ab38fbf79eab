"""How much disk the builder's cache may take."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from pathlib import Path

GB = 1_000_000_000
LARGEST = 40
"""GB that a builder keeps at most."""
SMALLEST = 20
"""GB that a builder may keep on a small disk: an image with PyTorch and CUDA takes most of them while it is built."""
FREE = 12
"""GB that a builder leaves free: with less, it prunes its cache."""

_LINES = re.compile(r'^  maxUsedSpace = "(\d+)GB"\n  minFreeSpace = "(\d+)GB"$', re.MULTILINE)


@dataclass(frozen=True)
class CacheLimits:
    """The limits of a builder's cache.

    Attributes:
        used: GB that the cache may take.
        free: GB of free blocks below which the builder prunes it.
    """

    used: int = LARGEST
    free: int = FREE

    @classmethod
    def kept(cls, file: Path, folder: Path) -> CacheLimits:
        """The limits in a builder's configuration, since a builder with another configuration starts again; without one, those of the
        disk.

        Args:
            file: the configuration, which may be missing.
            folder: a folder on the disk of the cache.
        """
        found = _LINES.search(file.read_text(errors="replace")) if file.is_file() else None
        return cls(int(found[1]), int(found[2])) if found else cls.of_disk(folder)

    @classmethod
    def of_disk(cls, folder: Path) -> CacheLimits:
        """Limits that leave half of a disk to others, such as the builders of other checkouts.

        BuildKit counts free blocks, also those that only root or nobody may use: these come on top of what stays free.
        """
        disk = os.statvfs(folder)
        available, free_blocks = (blocks * disk.f_frsize / GB for blocks in (disk.f_bavail, disk.f_bfree))
        return cls(
            used=max(SMALLEST, min(LARGEST, int(available / 2))), free=FREE + max(0, int(free_blocks - available))
        )

    def lines(self) -> list[str]:
        """The lines of buildkitd.toml."""
        return [f'  maxUsedSpace = "{self.used}GB"', f'  minFreeSpace = "{self.free}GB"']
