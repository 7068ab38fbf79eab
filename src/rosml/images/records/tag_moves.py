"""The record of a run's moves: where each tag was before, and where it went."""

from __future__ import annotations

import re
from dataclasses import dataclass

from pydantic import BaseModel

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.images.records.store import Records

UNDO = "undo."
"""How tags of records begin that say where tags were."""


@dataclass(frozen=True)
class Move:
    """A tag that moves: its repository without the registry's prefix, where it was (empty: nowhere), where it goes."""

    repository: str
    tag: str
    old: str
    new: str

    def to_json(self) -> dict[str, str]:
        """As plain data."""
        return dict(vars(self))


class _Record(BaseModel):
    """What the layer of a record says."""

    moves: list[Move]


def record_name(date: str) -> str:
    """The tag of a run's record."""
    return UNDO + re.sub(r"[^0-9TZ]", "", date)


def read_moves(records: Records, name: str) -> list[Move]:
    """The moves that a record tells of; none where there is no such record.

    Raises:
        RosmlError: it cannot be read.
    """
    found = records.registry.manifest(records.repository, name)
    if found is None:
        return []
    try:
        content = untrusted.json_value(records.registry.part(records.repository, found.layers[0]))
        return _Record.model_validate(content).moves
    except (KeyError, TypeError, ValueError, IndexError):
        raise RosmlError(f"the record {name} cannot be read", "move the tags by hand: regctl image copy") from None
