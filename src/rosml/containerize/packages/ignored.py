"""Files and folders that are not sent to the builder: those in `.dockerignore`, virtual environments, and the output of colcon and
catkin."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fnmatch import fnmatchcase
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.containerize import within

FILE = ".dockerignore"
MADE = {
    "build": ("COLCON_IGNORE", "CATKIN_IGNORE"),
    "build_isolated": ("CATKIN_IGNORE",),
    "install": ("COLCON_IGNORE",),
    "log": ("COLCON_IGNORE",),
    "logs": ("../.catkin_tools",),
    ".catkin_tools": ("CATKIN_IGNORE",),
    ".rosml": ("dev/COLCON_IGNORE",),
}
"""Folders that colcon, catkin_make, catkin_tools and `rosml dev` make in the current folder, each with the files by which we know
it."""

SPACE = ".catkin"
"""A file in each install space and each devel space of catkin."""

MOST = 1 << 20
"""The most bytes of a `.dockerignore`."""

WILD = 100_000
"""The most characters of names with wildcards in it: each becomes a regular expression."""


class LeftOut:
    """Decides which files and folders below a root stay on this machine.

    Raises:
        RosmlError: `.dockerignore` cannot be read, is no file of the folder, or has too many wildcards (exit code 2).
    """

    def __init__(self, root: Path) -> None:
        self._root = root
        self._rules = _rules(_text(root / FILE, root), root / FILE)
        self._brings_back = any(not leaves for leaves, _, _ in self._rules)

    def __call__(self, path: Path) -> bool:
        """Whether a file stays."""
        names = path.relative_to(self._root).parts
        found = False
        for leaves, pattern, is_plain in self._rules:
            if leaves != found and (
                names[: len(pattern)] == pattern
                if is_plain
                else any(_matches(pattern, names[:end]) for end in range(1, len(names) + 1))
            ):
                found = leaves
        return found

    def whole(self, folder: Path) -> bool:
        """Whether a folder stays, with everything in it."""
        if folder.is_symlink():
            return self(folder)
        if (folder / "pyvenv.cfg").is_file() or (folder / SPACE).is_file():
            return True
        if folder.parent == self._root and any((folder / mark).exists() for mark in MADE.get(folder.name, ())):
            return True
        return not self._brings_back and self(folder)


def _text(file: Path, root: Path) -> str:
    if not within.there(file, root):
        return ""
    try:
        return files.limited(file, MOST).decode("utf-8-sig", "replace")
    except OSError as error:
        raise RosmlError(f"{file}: cannot be read: {error.strerror}", "make it readable", exit_code=2) from None


def _rules(text: str, file: Path) -> list[tuple[bool, tuple[str, ...], bool]]:
    """The patterns of a `.dockerignore` in their order, each as the names of its path, and whether it has no wildcard. The last pattern
    that matches a path, or a folder above it, counts. True: the path is left out; False: it is kept, by `!`."""
    found, wild = [], 0
    for line in text.splitlines():
        pattern = line.strip()
        if not pattern or line.startswith("#"):
            continue
        leaves = not pattern.startswith("!")
        names = [name for name in pattern.removeprefix("!").strip().split("/") if name not in ("", ".")]
        if not names:
            continue
        is_plain = not _WILD.search(pattern)
        if not is_plain:
            wild += len(pattern) + 10
            if wild > WILD:
                raise RosmlError(f"{file}: it has too many wildcards", "name folders in their place", exit_code=2)
            names = [*map(_as_fnmatch, names)]
        found.append((leaves, tuple(names), is_plain))
    return found


_WILD = re.compile(r"[*?[\\]")
"""What makes a path a pattern. Most are none, and comparing them is faster."""


def _as_fnmatch(name: str) -> str:
    """A name with Python's wildcards: `[!a]` for `[^a]`, and `[*]` for `\\*`. A bracket that does not close stands for itself; Python
    would look for its end at each of them."""
    whole, end, rest = re.sub(r"\\(.)", r"[\1]", name).replace("[^", "[!").rpartition("]")
    return f"{whole}{end}{rest.replace('[', '[[]')}"


def _matches(pattern: Sequence[str], path: Sequence[str]) -> bool:
    """Whether a pattern matches a path: `**` is any number of names. The steps are at most the number of pairs of both."""
    here = there = 0
    star: tuple[int, int] | None = None
    while there < len(path):
        if here < len(pattern) and pattern[here] == "**":
            star = here, there
            here += 1
        elif here < len(pattern) and fnmatchcase(path[there], pattern[here]):
            here, there = here + 1, there + 1
        elif star:
            star = star[0], star[1] + 1
            here, there = star[0] + 1, star[1]
        else:
            return False
    return all(name == "**" for name in pattern[here:])
