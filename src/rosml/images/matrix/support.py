"""Until when distributions are supported, and what to take after that. The day `eol` is the last one with support."""

from __future__ import annotations

import datetime
from collections.abc import Iterable, Iterator

from rosml.base.problems import listed
from rosml.images.matrix.model import Matrix

FINAL = "final"
"""The apt channel of a distribution that is published after its end of life: its last packages, which do not move."""


def has_ended(matrix: Matrix, name: str, day: datetime.date) -> bool:
    """Whether a distribution is past its end of life on a day."""
    eol = matrix.distributions[name].eol
    return eol is not None and eol < day


def instead(matrix: Matrix, name: str, day: datetime.date) -> tuple[str, ...]:
    """At most two supported distributions to take instead of one: of its generation, on its system first, then those with the longest
    support."""
    row = matrix.distributions[name]
    supported = [
        (other.os != row.os, not other.lts, datetime.date.max - (other.eol or day), key)
        for key, other in matrix.distributions.items()
        if other.ros == row.ros and not other.experimental and key != name and not has_ended(matrix, key, day)
    ]
    return tuple(key for *_, key in sorted(supported)[:2])


def end(matrix: Matrix, name: str, day: datetime.date) -> str:
    """Says that a distribution is past its end of life, and what to take instead; empty if it is supported."""
    if not has_ended(matrix, name, day):
        return ""
    others = instead(matrix, name, day)
    remedy = f"; take {listed(others, 'or')}" if others else ""
    return f"{name} had its end of life on {matrix.distributions[name].eol}{remedy}"


def ends(matrix: Matrix, names: Iterable[str], day: datetime.date) -> Iterator[str]:
    """The same of those of some distributions that are past their end of life."""
    return filter(None, (end(matrix, name, day) for name in dict.fromkeys(names)))


def is_closed(matrix: Matrix, name: str, day: datetime.date) -> bool:
    """Whether the tags of a distribution stay where they are, because its packages come to an end: it is past its end of life, and its
    entry does not ask for its last packages."""
    apt = matrix.distributions[name].apt
    return has_ended(matrix, name, day) and not (apt and apt.channel == FINAL)


def how_to_open(matrix: Matrix, name: str) -> str:
    """What to write into matrix.yaml, so that a distribution is published after its end of life."""
    last = "'apt: {channel: final}' for ROS's last packages of it, or " if matrix.distributions[name].apt else ""
    return f"to go on publishing {name}, write {last}a later 'eol' into its entry in matrix.yaml"
