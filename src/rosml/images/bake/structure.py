"""The files of tests/structure that belong to the tests of an image. A change of another file does not concern the image.

They are the YAML files of its tests, the files that these call, and so on. Nobody lists them by hand: we read the texts. Other files
beside the YAML files (run.sh) belong to all tests.

In a folder such as `programs`, a file and a folder with one name belong together, with everything in them: `torch/`, and
`setuid.sh` with `setuid.txt`. So a program is free in its own folder. To reach another one, it has to write out the path,
`/run/tests/programs/torch/company.py` or `$here/../roscore.sh`. If a text computes a path, or leaves its folder in another way, we
cannot tell what it calls, and all files count.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from posixpath import dirname, normpath

FOLDER = "tests/structure"
"""Their folder in the checkout. In an image they are at PLACE."""

PLACE = "/run/tests"

_REST = r"[\w.+@/-]*"
_COMMENT = re.compile(r"^[ \t]*#[ \t!].*$", re.MULTILINE)
_UPWARD = re.compile(rf"(?<![\w.])(?:\.\./)*\.\.(?!\.)(?:/{_REST})?")
_OWN_PLACE = re.compile(r"\$\{?0|BASH_SOURCE|__file__|argv\[0\]|sys\.path")
_HERE = re.compile(r"\$\{?here\b")
_CLIMBS = re.compile(r"\bparents\b|parent\W+parent|pardir|%/\*|dirname(?s:.*)dirname")


class StructureTests:
    """The files of tests/structure and their calls. `texts` has the text of each file, by path in the folder."""

    def __init__(self, texts: Mapping[str, str]) -> None:
        self.texts = texts
        self._members: dict[str, list[str]] = {}
        self._beside: dict[str, list[str]] = {}
        for path in texts:
            self._members.setdefault(_unit(path), []).append(path)
            self._beside.setdefault(dirname(path), []).append(path)
        self._folders = "|".join(sorted({re.escape(path.split("/")[0]) for path in texts if "/" in path})) or "(?!)"
        self._called: dict[str, frozenset[str] | None] = {}

    def of(self, names: Collection[str]) -> Collection[str]:
        """The paths of all files that belong to tests, by names such as `contract`; all paths if we cannot tell."""
        todo = [f"{name}.yaml" for name in names if f"{name}.yaml" in self.texts]
        needed = set[str]()
        while todo:
            unit = todo.pop()
            if unit in needed:
                continue
            needed.add(unit)
            if (called := self._calls(unit)) is None:
                return self.texts.keys()
            todo += called
        shared = {path for path in self.texts if "/" not in path and not path.endswith(".yaml")}
        return shared | {path for unit in needed for path in self._members[unit]}

    def _calls(self, unit: str) -> frozenset[str] | None:
        """The units to which a unit refers; None if we cannot tell."""
        if unit not in self._called:
            called_units = {called for path in self._members[unit] for called in self._references(path)}
            self._called[unit] = (
                None if None in called_units else frozenset(called for called in called_units if called)
            )
        return self._called[unit]

    def _references(self, path: str) -> Iterator[str | None]:
        text = self.texts[path]
        if path.endswith((".yaml", ".sh", ".py")):
            text = _COMMENT.sub("", text)
        for reference in re.findall(rf"\b(?:{self._folders})/{_REST}", text):
            yield self._resolved(reference)
        for reference in re.findall(rf"{PLACE}(?!/(?:{self._folders})/)({_REST})", text):
            yield self._resolved(reference.strip("/"))
        for reference in _UPWARD.findall(text):
            yield self._resolved(normpath(f"{dirname(path)}/{reference}"))
        lines = [line for line in text.splitlines() if _OWN_PLACE.search(line)]
        # A script has a variable `here` from run.sh, unless its own folder sets another one.
        lent = _HERE.search(text) and not any("here=" in self.texts[other] for other in self._members[_unit(path)])
        if lent or (lines and _CLIMBS.search(text)):
            yield None
        if path.count("/") == 1:  # others share its folder
            others = [other for other in self._beside[dirname(path)] if _names(path, text, other)]
            yield from map(_unit, others)
            if not all(any(_names(path, line, other) for other in others) for line in lines):
                yield None

    def _resolved(self, path: str) -> str | None:
        """The unit of a path; None if the path does not exist, or is a folder of several units."""
        path = path.rstrip("/.")
        unit = _unit(path)
        if unit in self._members and (path in self.texts or any(item.startswith(f"{path}/") for item in self.texts)):
            return unit
        return None


def _names(path: str, text: str, other: str) -> bool:
    """Whether a text of a file refers to a file in the same folder, perhaps by one of Python's imports."""
    name = other.rpartition("/")[2]
    python = path.endswith(".py") and name.endswith(".py")
    name = name.removesuffix(".py") if python else name
    if name not in text:  # which takes a tenth of the search's time
        return False
    before, after = (r"\b", r"\b") if python else (r"(?<![\w.-])", r"(?![\w-])")
    return bool(re.search(f"{before}{re.escape(name)}{after}", text))


def _unit(path: str) -> str:
    """The unit of a path: a file beside the YAML files; below that, a file or folder with all others of its name."""
    first, *rest = path.split("/")
    return f"{first}/{rest[0].partition('.')[0]}" if rest else first
