"""Programs that one checkout has built, for all checkouts and sets of a user."""

from __future__ import annotations

import os
import re
import shutil
import stat
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

UNUSED_SECONDS = 60 * 86_400
"""A program that no checkout has taken for so long goes when another one comes."""


@dataclass(frozen=True)
class ToolCache:
    """A folder with a file for each program: `regctl-v0.11.7-0123456789abcdef-x86_64`.

    The name has the version, the digest of all pins, and the machine's architecture. Only files and folders count that belong to this user
    or to root, and that nobody else may write to. A failure to read or write loses time alone.
    """

    folder: Path

    def has(self, name: str, pins: str) -> bool:
        path = self._path(name, pins)
        try:
            facts = path.lstat()
        except OSError:
            return False
        whole = stat.S_ISREG(facts.st_mode) and facts.st_size > 0 and facts.st_mode & stat.S_IXUSR
        return bool(whole) and self._is_ours and _is_trusted(facts)

    @property
    def _is_ours(self) -> bool:
        try:
            facts = self.folder.lstat()
        except OSError:
            return False
        return stat.S_ISDIR(facts.st_mode) and _is_trusted(facts)

    def take(self, name: str, pins: str, to: Path) -> bool:
        """Copies a program, and says whether it was there. `to` is a file that nobody else reads yet."""
        if not self.has(name, pins):
            return False
        try:
            shutil.copyfile(self._path(name, pins), to)
            to.chmod(0o755)
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
            if not self._is_ours:
                return
            shutil.copy(program, partial)
            partial.replace(path)
        except OSError:
            with suppress(OSError):
                partial.unlink()
        with suppress(OSError):
            for file in self.folder.iterdir():
                if _NAME.fullmatch(file.name) and file.lstat().st_mtime < time.time() - UNUSED_SECONDS:
                    file.unlink(missing_ok=True)

    def _path(self, name: str, pins: str) -> Path:
        return self.folder / "-".join((name, *pins.split(), os.uname().machine))


_NAME = re.compile(r"\.?[a-z]+-v?[\w.+-]+-[0-9a-f]{16}-\w+(\.\d+\.partial)?")


def _is_trusted(facts: os.stat_result) -> bool:
    return facts.st_uid in (0, os.geteuid()) and not facts.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
