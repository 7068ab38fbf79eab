"""The record of a run's moves: where each tag pointed before, and where it points since."""

from __future__ import annotations

import re
from dataclasses import dataclass

from pydantic import BaseModel

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.images.records.store import Records

UNDO = "undo."
"""The tag of each record of moves begins with this."""


@dataclass(frozen=True)
class Move:
    """A move of a tag.

    Attributes:
        repository: without the registry's prefix.
        tag: the tag.
        old: the digest before; empty if the tag did not exist.
        new: the digest after.
    """

    repository: str
    tag: str
    old: str
    new: str

    def to_json(self) -> dict[str, str]:
        """As plain data."""
        return dict(vars(self))


class _Record(BaseModel):
    """The content of a record."""

    moves: list[Move]


def record_name(date: str) -> str:
    """The tag of a run's record."""
    return UNDO + re.sub(r"[^0-9TZ]", "", date)


def read_moves(records: Records, name: str) -> list[Move]:
    """The moves in a record; none if there is no such record.

    Raises:
        RosmlError: the record cannot be read.
    """
    found = records.registry.manifest(records.repository, name)
    if found is None:
        return []
    try:
        content = untrusted.json_value(records.registry.part(records.repository, found.layers[0]))
        return _Record.model_validate(content).moves
    except (KeyError, TypeError, ValueError, IndexError):
        raise RosmlError(f"the record {name} cannot be read", "move the tags by hand: regctl image copy") from None
