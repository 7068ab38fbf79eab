"""Files and folders that are not sent to the builder: by `.dockerignore`, virtual environments, and output of colcon and catkin."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.containerize import within

FILE = ".dockerignore"
OUTPUT_FOLDERS = {
    "build": ("COLCON_IGNORE", "CATKIN_IGNORE"),
    "build_isolated": ("CATKIN_IGNORE",),
    "install": ("COLCON_IGNORE",),
    "log": ("COLCON_IGNORE",),
    "logs": ("../.catkin_tools",),
    ".catkin_tools": ("CATKIN_IGNORE",),
    ".rosml": ("dev/COLCON_IGNORE",),
}
"""Folders that colcon, catkin_make, catkin_tools and `rosml dev` make in the current folder, each with files that only they write."""

SPACE = ".catkin"
"""A file in each install and devel space of catkin."""

LARGEST = 1 << 20
"""Bytes of a `.dockerignore`."""

LONGEST_WILD = 100_000
"""The most characters of names with wildcards in it: each becomes a regular expression."""

_WILD = re.compile(r"[*?[\\]")


@dataclass(frozen=True)
class _Rule:
    """A line of `.dockerignore`. Most are plain, without a wildcard: comparing names is faster. A line with `!` does not ignore."""

    ignores: bool
    names: tuple[str, ...]
    is_plain: bool

    def matches(self, path: Sequence[str]) -> bool:
        """Whether it matches a path, or a folder above it."""
        if self.is_plain:
            return tuple(path[: len(self.names)]) == self.names
        return any(_matches(self.names, path[:end]) for end in range(1, len(path) + 1))


class IgnoredFiles:
    """Decides which files and folders below a root stay on this machine."""

    def __init__(self, root: Path) -> None:
        self._root = root
        text = (within.read(root / FILE, root, LARGEST) or b"").decode("utf-8-sig", "replace")
        self._rules = _rules(text, root / FILE)
        self._brings_back = any(not rule.ignores for rule in self._rules)

    def __call__(self, path: Path) -> bool:
        """Whether a file stays. The last rule that matches counts."""
        names = path.relative_to(self._root).parts
        stays = False
        for rule in self._rules:
            if rule.ignores != stays and rule.matches(names):
                stays = rule.ignores
        return stays

    def whole(self, folder: Path) -> bool:
        """Whether a folder stays, with everything in it."""
        if folder.is_symlink():
            return self(folder)
        if os.path.isfile(folder / "pyvenv.cfg") or os.path.isfile(folder / SPACE):  # False also if nobody may look
            return True
        marks = OUTPUT_FOLDERS.get(folder.name, ())
        if folder.parent == self._root and any(os.path.exists(folder / mark) for mark in marks):
            return True
        return not self._brings_back and self(folder)


def _rules(text: str, file: Path) -> list[_Rule]:
    rules, wild = list[_Rule](), 0
    # The last rule that matches counts, and so the last of equal ones.
    for line in reversed(dict.fromkeys(reversed(text.splitlines()))):
        pattern = line.strip()
        if not pattern or line.startswith("#"):
            continue
        names = [name for name in pattern.removeprefix("!").strip().split("/") if name not in ("", ".")]
        if not names:
            continue
        is_plain = not _WILD.search(pattern)
        if not is_plain:
            wild += len(pattern) + 10
            if wild > LONGEST_WILD:
                raise RosmlError(f"{file}: it has too many wildcards", "name folders in their place", exit_code=2)
            names = [*map(_as_fnmatch, names)]
        rules.append(_Rule(not pattern.startswith("!"), tuple(names), is_plain))
    return rules


def _as_fnmatch(name: str) -> str:
    # `[!a]` for `[^a]`, `[*]` for `\*`. Python would look for the end of a bracket that does not close at each of them.
    whole, end, rest = re.sub(r"\\(.)", r"[\1]", name).replace("[^", "[!").rpartition("]")
    return f"{whole}{end}{rest.replace('[', '[[]')}"


def _matches(pattern: Sequence[str], path: Sequence[str]) -> bool:
    """Whether a pattern matches a path: `**` is any number of names. The steps are at most the number of pairs of both."""
    at_pattern = at_path = 0
    star: tuple[int, int] | None = None
    while at_path < len(path):
        if at_pattern < len(pattern) and pattern[at_pattern] == "**":
            star = at_pattern, at_path
            at_pattern += 1
        elif at_pattern < len(pattern) and fnmatchcase(path[at_path], pattern[at_pattern]):
            at_pattern, at_path = at_pattern + 1, at_path + 1
        elif star:
            star = star[0], star[1] + 1
            at_pattern, at_path = star[0] + 1, star[1]
        else:
            return False
    return all(name == "**" for name in pattern[at_pattern:])
