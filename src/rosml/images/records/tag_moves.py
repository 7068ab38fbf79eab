"""The record of a run's moves: where each tag pointed before, and where it points since."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Annotated

from pydantic import Field

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.images.records.store import ANNOTATION, Records

UNDO = "undo."
"""The tag of each record of moves begins with this."""


@dataclass(frozen=True)
class Move:
    """A move of a tag from the previous digest, empty if it did not exist, to a new one. `repository` has no prefix."""

    repository: str
    tag: str
    previous: Annotated[str, Field(alias="old")]
    new: str

    def to_json(self) -> dict[str, str]:
        return {"repository": self.repository, "tag": self.tag, "old": self.previous, "new": self.new}


class _Record(Shape):
    """The content of a record."""

    moves: list[Move]
    date: str = ""  # of the run
    undone: str = ""  # when somebody undid the run; empty if nobody did


def record_name(date: str) -> str:
    """The tag of a run's record."""
    return UNDO + re.sub(r"[^0-9TZ]", "", date)


def run_date(name: str) -> str:
    """The date of a run from the tag of its record; the end of the tag, if it is no date."""
    text = name.removeprefix(UNDO)
    match = re.fullmatch(r"(\d{4})(\d\d)(\d\d)T(\d\d)(\d\d)(\d\d)Z", text, re.ASCII)
    return "{}-{}-{}T{}:{}:{}Z".format(*match.groups()) if match else text


def read_moves(records: Records, name: str) -> list[Move]:
    """The moves in a record; none if there is no such record."""
    return _read(records, name).moves


def undone_moves(records: Records, runs: int) -> list[Move]:
    """The moves of the last runs, as far as somebody undid these."""
    last = [_read(records, name) for name in _names(records)[-runs:]]
    return [move for record in last if record.undone for move in record.moves]


def later_moves(records: Records, name: str) -> dict[tuple[str, str, str], str]:
    """Where later runs moved tags, by repository, tag and digest, with the date of the last. Runs that somebody undid do not count."""
    later = [_read(records, record) for record in _names(records) if record > name]
    return {(move.repository, move.tag, move.new): run.date for run in later if not run.undone for move in run.moves}


def mark_undone(records: Records, name: str, date: str) -> None:
    """Says in a record that the run is undone, before its tags move back."""
    content = _read(records, name)
    if not content.undone:
        _write(records, name, content.date, content.moves, date)


def record(records: Records, date: str, planned: Iterable[Move]) -> None:
    """Records where tags were before a run. If the run is called again, its first record of a tag counts."""
    name = record_name(date)
    before = {(move.repository, move.tag): move for move in read_moves(records, name)}
    merged = dict(before)
    for move in planned:
        first = before.get((move.repository, move.tag))
        merged[move.repository, move.tag] = replace(move, previous=first.previous if first else move.previous)
    _write(records, name, date, merged.values())


def _names(records: Records) -> list[str]:
    return sorted(name for name in records.registry.tags(records.repository) if name.startswith(UNDO))


def _read(records: Records, name: str) -> _Record:
    manifest = records.registry.manifest(records.repository, name)
    if manifest is None:
        return _Record(moves=[])
    try:
        layer = records.registry.part(records.repository, manifest.layers[0])
        return _Record.model_validate(untrusted.json_value(layer))
    except (KeyError, TypeError, ValueError, IndexError):
        raise RosmlError(f"the record {name} cannot be read", "move the tags by hand: regctl image copy") from None


def _write(records: Records, name: str, date: str, moves: Iterable[Move], undone: str = "") -> None:
    content = {"date": date, "moves": [move.to_json() for move in moves]} | ({"undone": undone} if undone else {})
    text = json.dumps(content, sort_keys=True)
    records.artifact(name, text.encode(), {ANNOTATION: json.dumps({"undo": date})})
