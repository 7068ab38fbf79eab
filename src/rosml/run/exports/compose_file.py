"""Adds a service to a file of compose. The rest of the file stays as it is, byte for byte."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.run.exports import compose, yaml_text
from rosml.run.exports.description import Call

SECTIONS = ("services", "networks", "volumes")
MOST_CHARACTERS = 256 << 10
BY_HAND = "add the service by hand: without --add, it is printed"


@dataclass(frozen=True)
class Edit:
    """An addition: a text, and its events among those of the file."""

    line: int  # before which it stands
    text: str
    event: int  # before which its events stand
    replaced: int  # how many events they replace
    events: Sequence[Any]


def add(file: Path, call: Call) -> str:
    """Adds the service of a call to a file, at once. Returns a message for the user."""
    before = _read(file)
    after = added(before, compose.escaped(compose.content(call)), str(file))
    if after == before:
        return f"{file}: has the service {call.name} already"
    files.write(file, after)
    return f"{file}: added the service {call.name}"


def _read(file: Path) -> str:
    """The text of a file, with its own ends of lines."""
    content = files.regular(file, untrusted.SIZE)
    if content is None:
        remedy = f"make it: rosml run --export compose … >{file}"
        raise RosmlError(f"{file}: there is no such file", remedy, exit_code=2)
    try:
        return content.decode()
    except UnicodeDecodeError:
        raise RosmlError(f"{file}: it is no text in UTF-8", "write it in UTF-8", exit_code=2) from None


def added(text: str, content: Mapping[str, Mapping[str, Any]], text_name: str) -> str:
    """A text of compose with more content; the same text if it has all of that. `content` has, by the names of `SECTIONS`, names and
    their values; `text_name` is for messages."""
    if len(text) > MOST_CHARACTERS:
        raise RosmlError(f"{text_name}: has more than {MOST_CHARACTERS >> 10} kB", BY_HAND, exit_code=2)
    events, newline = _events(text, text_name), "\r\n" if "\r\n" in text else "\n"
    if not events:
        ending = newline if text and text[-1] not in "\r\n" else ""
        return text + ending + yaml_text.text(content).replace("\n", newline)
    sections = [_section(text, events, name, content[name], text_name) for name in SECTIONS if content.get(name)]
    # At the same line, the inner one comes first.
    edits = sorted(filter(None, sections), key=lambda edit: (edit.line, edit.event))
    lines, signatures = text.splitlines(keepends=True), [*map(_signature, events)]
    if any(edit.line == len(lines) for edit in edits) and lines[-1][-1] not in "\r\n":
        lines[-1] += newline
    for edit in reversed(edits):
        lines.insert(edit.line, edit.text.replace("\n", newline))
        signatures[edit.event : edit.event + edit.replaced] = map(_signature, edit.events)
    after = "".join(lines)
    if [*map(_signature, _events(after, text_name))] != signatures:
        raise RosmlError(f"{text_name}: the addition would change what is there", BY_HAND, exit_code=2)
    return after


def _events(text: str, text_name: str) -> list[Any]:
    """The events of a text; none if it is empty. It must be a mapping with a line for each key."""
    try:
        events = [*untrusted.yaml_events(text)]
        untrusted.yaml_node(text)
    except yaml.YAMLError as error:
        mark: Any = getattr(error, "problem_mark", None)
        why = "it has a character that YAML does not allow"
        if mark:
            why = f"line {mark.line + 1}: {getattr(error, 'problem', '')}"
        raise RosmlError(f"{text_name} is no YAML: {why}", "correct it", exit_code=2) from None
    starts = [event for event in events if isinstance(event, yaml.DocumentStartEvent)]
    if not starts:
        return []
    top = events[2]
    odd = any(isinstance(event, yaml.DocumentEndEvent) and event.explicit for event in events)
    if len(starts) > 1 or odd or not isinstance(top, yaml.MappingStartEvent) or top.flow_style:
        raise RosmlError(f"{text_name}: it is no file of compose with a line for each key", BY_HAND, exit_code=2)
    return events


def _signature(event: Any) -> tuple[Any, ...]:
    """All of an event but its place."""
    fields = ("anchor", "tag", "implicit", "value", "style", "flow_style", "explicit", "version", "tags")
    return (type(event).__name__, *(getattr(event, name, None) for name in fields))


def _end(events: Sequence[Any], start: int) -> int:
    """The event after a value."""
    depth = 0
    for place in range(start, len(events)):
        depth += isinstance(events[place], yaml.CollectionStartEvent)
        depth -= isinstance(events[place], yaml.CollectionEndEvent)
        if depth == 0:
            return place + 1
    return len(events)


def _pairs(events: Sequence[Any], start: int) -> dict[str, tuple[int, int]]:
    """The pairs of a mapping that starts at an event, by their keys: where the value is, and where it has ended."""
    pairs, key = {}, start + 1
    while not isinstance(events[key], yaml.MappingEndEvent):
        value = _end(events, key)
        after = _end(events, value)
        pairs[getattr(events[key], "value", "")] = value, after
        key = after
    return pairs


def _section(text: str, events: Sequence[Any], name: str, additions: Mapping[str, Any], text_name: str) -> Edit | None:
    """The addition to a section of the file; None if it has all already."""
    span = _pairs(events, 2).get(name)
    if span is None:
        column = events[3].start_mark.column if len(events) > 6 else 0
        content = {name: additions}
        return Edit(len(text.splitlines()), _indented(content, column), _end(events, 2) - 1, 0, _inner(content))
    value, after = span
    start = events[value]
    if isinstance(start, yaml.ScalarEvent) and not (start.value or start.style or start.anchor or start.tag):
        mapping = [*untrusted.yaml_events(yaml_text.text(additions))][2:-2]
        return Edit(events[value].end_mark.line + 1, _indented(additions, 2), value, 1, mapping)
    present = _pairs(events, value) if isinstance(start, yaml.MappingStartEvent) else {}
    section = _value(untrusted.yaml_node(text), name)
    for key in [key for key in additions if key in present]:
        if _meaning(_value(section, key)) != _meaning(untrusted.yaml_node(yaml_text.text(additions[key]))):
            kind = name.removesuffix("s")
            remedy = "--name gives the service another name" if name == "services" else f"rename that {kind}"
            raise RosmlError(f"{text_name} has a {kind} {key} already, with other content", remedy, exit_code=2)
    missing = {key: value for key, value in additions.items() if key not in present}
    if not missing:
        return None
    if not isinstance(start, yaml.MappingStartEvent) or start.flow_style:
        raise RosmlError(f"{text_name}: {name} has no line for each key", BY_HAND, exit_code=2)
    if start.anchor:
        why = f"{text_name}: {name} has the anchor {start.anchor}, so the addition may be elsewhere as well"
        raise RosmlError(why, BY_HAND, exit_code=2)
    return _last(text, events, value, after, missing)


def _last(text: str, events: Sequence[Any], start: int, after: int, content: Mapping[str, Any]) -> Edit:
    """An addition behind the last item of a section, and behind the comments that belong to it."""
    column = events[start + 1].start_mark.column
    line = max(_line_after(event) for event in events[start + 1 : after - 1])
    lines = text.splitlines()
    for number in range(line, len(lines)):
        comment = re.match(r"( *)#", lines[number])
        if comment and len(comment[1]) > column:
            line = number + 1
        elif lines[number].strip():
            break
    return Edit(line, _indented(content, column), after - 1, 0, _inner(content))


def _line_after(event: Any) -> int:
    """The line after an event; 0 for the end of a mapping or list with a line for each item, whose mark comes too late."""
    mark: Any = event.end_mark
    if isinstance(event, yaml.CollectionEndEvent) and getattr(event.start_mark, "index", 0) == mark.index:
        return 0
    return int(mark.line + (1 if mark.column else 0))


def _inner(content: Mapping[str, Any]) -> list[Any]:
    """The events of keys and values, without those of the mapping that has them."""
    return [*untrusted.yaml_events(yaml_text.text(content))][3:-3]


def _indented(content: Mapping[str, Any], column: int) -> str:
    return "".join(f"{' ' * column}{line}" for line in yaml_text.text(content).splitlines(keepends=True))


def _value(node: Any, key: str) -> Any:
    return next((value for name, value in node.value if name.value == key), None)


def _meaning(node: Any) -> tuple[str, object]:
    """A node's tag and value, to compare two of them; the order of keys does not count."""
    if isinstance(node, yaml.ScalarNode):
        return node.tag, node.value
    if isinstance(node, yaml.SequenceNode):
        return node.tag, tuple(map(_meaning, node.value))
    return node.tag, frozenset((_meaning(key)[1], _meaning(value)) for key, value in node.value)
