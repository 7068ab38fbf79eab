"""Reads `.env`: lines of `NAME=VALUE`, as a shell reads them. Nothing is run or expanded."""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Container
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError

NAME = ".env"

LARGEST = 256 << 10
"""Bytes."""

# No possessive group, such as (…)*+: up to Python 3.11.4 it may end too early.
_BETWEEN = re.compile(r"(?:[ \t\n]+|(?<![^ \t\n])#[^\n]*)*")
"""Blanks, empty lines, and comments."""

_NAME = re.compile(r"(?:export[ \t]+)?([A-Za-z_][A-Za-z0-9_]*)=")

BLANKS = " \t\n"
"""A shell has no others."""

PIECE = re.compile(r"""'([^']*)'|"([^"\\]*(?:\\.[^"\\]*)*)"|\\(.)|([^ \t\n'"\\]++)""", re.DOTALL)
"""A piece of a word."""


def read(file: Path, names: Container[str]) -> dict[str, str]:
    """The variables of a file; none if there is no file. A line that needs a shell is an error if it sets one of these names: the
    file may also be for others, such as docker compose. For them, its variable is empty."""
    content = files.regular(file, LARGEST)
    if content is None:
        return {}
    try:
        text = content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError:
        raise RosmlError(f"{file} is not UTF-8", "save it as UTF-8", exit_code=2) from None
    if "\0" in text:
        raise RosmlError(f"{file}: it has a NUL character", "write lines of NAME='value' into it", exit_code=2)
    variables: dict[str, str] = {}
    place = 0
    while (place := _BETWEEN.match(text, place).end()) < len(text):  # type: ignore[union-attr] # it matches anywhere
        refusal = functools.partial(_refusal, file, text, place)
        name = _NAME.match(text, place)
        if not name:
            raise refusal("it is not NAME=VALUE")
        try:
            variables[name[1]], place = _value(text, name.end(), refusal)
        except RosmlError:
            if name[1] in names:
                raise
            variables[name[1]], place = "", _line_end(text, place)
    return variables


def line_of(file: Path, variable: str) -> int:
    """The last line that sets a variable."""
    lines = file.read_text("utf-8-sig").split("\n")
    pattern = re.compile(rf"\s*(export\s+)?{variable}=")
    return max((number for number, line in enumerate(lines, 1) if pattern.match(line)), default=1)


def _refusal(file: Path, text: str, place: int, why: str) -> RosmlError:
    line = text.count("\n", 0, place) + 1
    return RosmlError(f"{file}:{line}: {why}", "write NAME='value'", exit_code=2)


def _value(text: str, place: int, refusal: Callable[[str], RosmlError]) -> tuple[str, int]:
    """The value that begins at a place, and where it ends."""
    pieces: list[str] = []
    while place < len(text) and text[place] not in BLANKS:
        piece = PIECE.match(text, place)
        if piece is None:
            raise refusal("its quotation has no end")
        single, double, escaped, bare = piece.groups()
        if re.search(r"(?<!\\)(\\\\)*(\$[A-Za-z_{(]|`)", double or bare or ""):
            raise refusal("a shell would expand it: put the value into single quotes")
        if double is not None:
            pieces.append(re.sub(r"\\([$`\"\\\n])", lambda escape: escape[1].strip("\n"), double))
        elif escaped != "\n":  # an escaped line end joins two lines
            pieces.append(single or escaped or bare or "")
        place = piece.end()
    end = _line_end(text, place)
    rest = text[place:end].strip(" \t")
    if rest and not rest.startswith("#"):
        raise refusal("a value with blanks needs quotes")
    return "".join(pieces), end


def _line_end(text: str, place: int) -> int:
    end = text.find("\n", place)
    return len(text) if end < 0 else end
