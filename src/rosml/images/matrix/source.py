"""YAML text -> plain data, and the place of every value in the text.

It reads a strict subset of YAML: one document of mappings, lists and scalars. It refuses anchors, aliases, merge keys and tags:
a few lines of them can expand to gigabytes ("YAML bombs").
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import date
from pathlib import Path
from typing import Any

import yaml

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.files import shown
from rosml.base.problems import InputError, KeyPath, Problem, dotted

_TAG = "tag:yaml.org,2002:"
_INTEGER = re.compile(r"[-+]?(0|[1-9][0-9]{0,17})")


@dataclass(frozen=True)
class Place:
    """The place of a value: line and column, from 1, of its key or of the list's item; and a scalar as it was written."""

    line: int
    column: int
    text: str = ""


@dataclass
class Document:
    """A parsed file: `data`, and a place for every path in it.

    Attributes:
        called: what messages call items of lists that have another index in the file, or are not in it: `parts[torch]`.
        base: the file that this one extends, if any.
    """

    name: str
    data: Any = None
    places: dict[KeyPath, Place] = field(default_factory=dict)
    problems: list[Problem] = field(default_factory=list)
    called: dict[KeyPath, str] = field(default_factory=dict)
    base: Document | None = None

    def place(self, path: KeyPath) -> Place:
        """The place of a value, or of the nearest thing around it."""
        while path and path not in self.places:
            path = path[:-1]
        return self.places.get(path, Place(1, 1))

    def problem(self, path: KeyPath, text: str) -> Problem:
        """A problem with the value at `path`."""
        place = self.place(path)
        called = self.called.get(path[:2])
        return Problem(place.line, place.column, dotted(path[2:], called) if called else dotted(path), text)


def quoted(value: str) -> str:
    """A value in quotes, for messages; an address without its user and password."""
    address, at_digest, digest = value.partition("@sha256:")
    login, at, host = address.rpartition("@")
    scheme = f"{login.partition('//')[0]}//" if "//" in login else ""
    return repr(f"{scheme}***@{host}{at_digest}{digest}" if at else value)


LEAST = "version: 1"
"""What matrix.yaml and scan.yaml need at least."""


def read(file: Path, option: str = "--matrix", least: str = LEAST) -> Document:
    """Reads a YAML file. `option` names another file on the command line; `least` is what the file needs at least, for messages."""
    name = shown(file)
    try:
        content = file.read_bytes()
    except FileNotFoundError:
        raise RosmlError(f"{name}: no such file", remedy=f"name the file with {option}", exit_code=2) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise RosmlError(
            f"{name}: cannot be read: {reason}", f"name a file that you can read with {option}", exit_code=2
        ) from None
    return parse(content, name, least)


LARGEST = 1 << 20
"""The most bytes of a file that people write. matrix.yaml has 25 kB."""


def parse(content: bytes, name: str = "matrix.yaml", least: str = LEAST) -> Document:
    """Parses YAML text; raises as `read` does."""
    if len(content) > LARGEST:
        raise InputError(name, [Problem(1, 1, "", f"the file has more than {LARGEST >> 10} kB; check what it is")])
    text = _decode(content, name)
    document = Document(name)
    try:
        if problems := list(_refused(text)):
            raise InputError(name, problems)
        node = untrusted.yaml_node(text, plain=True)
    except yaml.MarkedYAMLError as error:
        raise InputError(name, [_syntax(error, text)]) from None
    except yaml.reader.ReaderError as error:
        what = "a character that YAML does not allow; remove it"
        raise InputError(name, [Problem(*_end(text[: error.position]), "", what)]) from None
    if node is None:
        raise InputError(name, [Problem(1, 1, "", f"the file is empty; it needs at least '{least}'")])
    document.places[()] = _place(node)
    document.data = _value(document, (), node)
    return document


def _decode(content: bytes, name: str) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        text = f"not UTF-8 (byte 0x{content[error.start]:02x}); save the file as UTF-8"
        before = content[: error.start].decode("utf-8", errors="replace")
        raise InputError(name, [Problem(*_end(before), "", text)]) from None


def _end(text: str) -> tuple[int, int]:
    return text.count("\n") + 1, len(text) - text.rfind("\n")


def _refused(text: str) -> Iterator[Problem]:
    """Problems with anchors, aliases and tags, which we refuse."""
    for event in untrusted.yaml_events(text):
        kind = "alias" if isinstance(event, yaml.AliasEvent) else "anchor"
        for what, name in ((kind, getattr(event, "anchor", None)), ("tag", getattr(event, "tag", None))):
            if name:
                mark = event.start_mark
                yield Problem(
                    mark.line + 1, mark.column + 1, "", f"the {what} {name} is not allowed; write plain values out"
                )


def _syntax(error: yaml.MarkedYAMLError, text: str) -> Problem:
    what = error.problem or "cannot be read"
    mark = error.problem_mark or error.context_mark
    if error.context_mark and what == "could not find expected ':'":  # the line after the one with the mistake
        mark = error.context_mark
    line, column = (mark.line + 1, mark.column + 1) if mark else (1, 1)
    if "cannot start any token" in what and text.split("\n")[line - 1][column - 1 :].startswith("\t"):
        return Problem(line, column, "", "not YAML: this line is indented with a tab; indent with spaces")
    remedy = next((remedy for sign, remedy in _REMEDIES.items() if sign in what), "")
    return Problem(line, column, "", "; ".join(part for part in (f"not YAML: {what}", remedy) if part))


_REMEDIES = {
    "could not find expected ':'": "a key is followed by a colon and a space, as in 'key: value'",
    "mapping values are not allowed": "indent keys of one level alike, "
    "put a space after each colon, and text with ': ' in it in quotes",
    "did not find expected key": "look at this line and those above for a quote that is left open, or another indentation",
    "found unexpected end of stream": "look above for a quote that is left open",
    "did not find expected ','": "close the bracket, and put commas between its items",
    "cannot start any token": "indent with spaces, and put text that begins like this in quotes",
    "tab character": "indent with spaces",
    "levels deep": "remove what was pasted",
    "another document": "keep one document in a file",
    "did not find expected comment or line break": "put the text in quotes",
}
"""Remedies for the parser's messages, by their words. The messages are about its own work."""


def _place(node: Any, text: str = "") -> Place:
    return Place(node.start_mark.line + 1, node.start_mark.column + 1, text)


def _value(document: Document, path: KeyPath, node: Any) -> Any:
    if isinstance(node, yaml.MappingNode):
        return _mapping(document, path, node)
    if isinstance(node, yaml.SequenceNode):
        items: list[Any] = []
        seen: set[str] = set()
        for index, item in enumerate(node.value):
            below = (*path, index)
            document.places[below] = _place(item, text := _text(item))
            if text and text in seen:
                document.problems.append(document.problem(below, f"{quoted(text)} is there twice; keep one"))
            seen.add(text)
            items.append(_value(document, below, item))
        return tuple(items)
    return _scalar(document, path, node)


def _mapping(document: Document, path: KeyPath, node: Any) -> dict[str, Any]:
    data: dict[str, Any] = {}
    for key, item in node.value:
        place = _place(key, _text(item))
        if not isinstance(key, yaml.ScalarNode):
            document.problems.append(Problem(place.line, place.column, dotted(path), "a key must be plain text"))
            continue
        below = (*path, key.value)
        where = dotted(below)
        if key.tag != f"{_TAG}str":
            kind = key.tag.removeprefix(_TAG)
            text = f'YAML reads the key {key.value} as {_KINDS.get(kind, kind)}; write it in quotes: "{key.value}"'
            document.problems.append(Problem(place.line, place.column, where, text))
        elif key.value in data:
            first = document.places[below].line
            text = f"the key {key.value!r} is there twice, first on line {first}; keep one"
            document.problems.append(Problem(place.line, place.column, where, text))
            continue
        document.places[below] = place
        data[key.value] = _value(document, below, item)
    return data


_KINDS = {
    "int": "a number",
    "float": "a number",
    "bool": "true or false",
    "null": "nothing",
    "timestamp": "a date",
    "value": "a default",
}


def _text(node: Any) -> str:
    return node.value if isinstance(node, yaml.ScalarNode) else ""


def _scalar(document: Document, path: KeyPath, node: Any) -> Any:
    """A scalar's value. We refuse spellings of YAML 1.1 that surprise people: `yes`, `012` and `1:30` would silently become true,
    10 and 90."""
    kind, text = node.tag.removeprefix(_TAG), node.value
    if kind == "null":
        return None
    if kind == "bool" and text in ("true", "false"):
        return text == "true"
    if kind == "int" and _INTEGER.fullmatch(text):
        return int(text)
    if kind == "float":  # no key takes one; messages show it as written
        return float("nan")
    if kind == "timestamp":
        try:
            return date.fromisoformat(text)
        except ValueError:
            document.problems.append(document.problem(path, f"{text} is not a day of the calendar, as in 2028-06-30"))
            return text
    if kind in ("bool", "int"):
        remedy = "write true or false" if kind == "bool" else "write it in decimal digits"
        problem = f'YAML reads {text} as {_KINDS[kind]}; {remedy}; or, if text is meant, in quotes: "{text}"'
        document.problems.append(document.problem(path, problem))
    return node.value
