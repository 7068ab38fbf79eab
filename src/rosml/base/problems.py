"""Problems in an input file: place, text and remedy. Also lists and counts in words."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rosml.base.errors import RosmlError

if TYPE_CHECKING:
    from pydantic import ValidationError

KeyPath = tuple[str | int, ...]

SHOWN = 50
"""How many problems one message spells out; a broken file can hold thousands."""


@dataclass(frozen=True, order=True)
class Problem:
    """One problem. `line` and `column` count from 1; `path` is empty if the whole file is meant."""

    line: int
    column: int
    path: str
    text: str

    def message(self, file: str) -> str:
        """The problem as editors and terminals link it: `file:line:column: path: text`."""
        place = f"{file}:{self.line}:{self.column}"
        return ": ".join(part for part in (place, self.path, self.text) if part)


class InputError(RosmlError):
    """All problems of a file, in its order. The exit code is 2."""

    def __init__(self, file: str, problems: Iterable[Problem]) -> None:
        self.problems = tuple(sorted(set(problems)))
        lines = [problem.message(file) for problem in self.problems[:SHOWN]]
        if len(self.problems) > SHOWN:
            lines.append(f"{file}: and more; the first {SHOWN} problems are shown")
        super().__init__("\n".join(lines), exit_code=2)


def dotted(path: KeyPath, start: str = "") -> str:
    """A path for people: `distributions.jazzy.components[2]`, after what it starts with."""
    for step in path:
        start += f"[{step}]" if isinstance(step, int) else f".{step}" if start else step
    return start


def first_of(error: ValidationError) -> str:
    """The first problem that a model found: `manifests[0].digest: field required`."""
    wrong = error.errors(include_url=False, include_context=False, include_input=False)[0]
    text = re.sub(r"a valid dictionary or instance of \w+", "an object", wrong["msg"])
    return ": ".join(part for part in (dotted(wrong["loc"]), text[:1].lower() + text[1:]) if part)


def listed(names: Sequence[str], last: str = "and") -> str:
    """Names in a sentence: `a`, `a and b`, `a, b and c`."""
    return f" {last} ".join(part for part in (", ".join(names[:-1]), *names[-1:]) if part)


SOME = 4
"""The most names of a long list that a message shows."""


def some(names: Iterable[str]) -> str:
    """The first names of many: `a, b, c, d and 7 more`."""
    shown = list(names)
    more = len(shown) - SOME
    return ", ".join(shown) if more <= 1 else f"{', '.join(shown[:SOME])} and {more} more"


def counted(number: int, what: str) -> str:
    """A number with its noun: `1 image`, `2 images`."""
    return f"{number} {what}{'s'[: number != 1]}"


def near(name: str, names: Iterable[str]) -> str:
    """The remedy for an unknown name: `did you mean 'x'?`, `known: a, b, c`, or nothing."""
    from difflib import get_close_matches  # only needed when something is wrong

    names = list(names)
    if matches := get_close_matches(name, names, n=3):
        return f"did you mean {listed([repr(match) for match in matches], last='or')}?"
    return f"known: {', '.join(names)}" if 0 < len(names) <= 12 else ""


def unknown(kind: str, name: str, names: Iterable[str]) -> str:
    """The sentence about an unknown name: `no stack named 'cu129'; did you mean 'cu128'?`."""
    return "; ".join(part for part in (f"no {kind} named {name!r}", near(name, names)) if part)
