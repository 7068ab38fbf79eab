"""Programs that one checkout has built, for all checkouts and sets of a user."""

from __future__ import annotations

import os
import shutil
import stat
import time
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

UNUSED_SECONDS = 60 * 86_400
"""A program that no checkout has taken for so long goes when another one comes."""


@dataclass(frozen=True)
class ToolCache:
    """A folder with a file for each program: `regctl-v0.11.7-0123456789abcdef-x86_64`.

    The name has the version, the digest of all pins, and the machine's architecture. A failure to read or write loses time alone.

    Attributes:
        folder: only files and folders that belong to this user or to root, and that nobody else may write to, count.
    """

    folder: Path

    def has(self, name: str, pins: str) -> bool:
        """Whether a program with these pins is there.

        Args:
            name: of the program.
            pins: its version and the digest of its pins.
        """
        path = self._path(name, pins)
        try:
            return stat.S_ISREG(path.lstat().st_mode) and all(map(_is_trusted, (path, self.folder)))
        except OSError:
            return False

    def take(self, name: str, pins: str, to: Path) -> bool:
        """Copies a program, and says whether it was there. `to` is a file that nobody else reads yet."""
        if not self.has(name, pins):
            return False
        try:
            shutil.copy(self._path(name, pins), to)
            with suppress(OSError):
                os.utime(self._path(name, pins))
            return True
        except OSError:
            to.unlink(missing_ok=True)
            return False

    def keep(self, name: str, pins: str, program: Path) -> None:
        """Keeps a program, if the folder can be written to. Removes what was not taken for a long time."""
        path = self._path(name, pins)
        partial = path.with_name(f".{path.name}.{os.getpid()}.partial")
        try:
            self.folder.mkdir(mode=0o755, parents=True, exist_ok=True)
            shutil.copy(program, partial)
            partial.replace(path)
        except OSError:
            with suppress(OSError):
                partial.unlink()
        for old in self._unused():
            with suppress(OSError):
                old.unlink()

    def _path(self, name: str, pins: str) -> Path:
        return self.folder / "-".join((name, *pins.split(), os.uname().machine))

    def _unused(self) -> Iterator[Path]:
        """Programs, and files of interrupted calls, that nobody has taken for a long time."""
        with suppress(OSError):
            for path in sorted(self.folder.iterdir()):
                if path.lstat().st_mtime < time.time() - UNUSED_SECONDS:
                    yield path


def _is_trusted(path: Path) -> bool:
    facts = path.lstat()
    return facts.st_uid in (0, os.geteuid()) and not facts.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
