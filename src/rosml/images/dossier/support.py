"""Until when somebody corrects what an image has: its system, ROS, Python, CUDA and frameworks."""

from __future__ import annotations

import datetime
import re
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path
from typing import Any

from pydantic import ConfigDict

from rosml.base import untrusted
from rosml.base.shapes import Shape, adapter
from rosml.images.dossier.bill import Component, shortened
from rosml.images.matrix.model import Matrix

FILE = Path(__file__).with_name("support.yaml")

UNKNOWN = "nobody named a day that rosml knows of"


class Supported(Shape):
    """An entry of `support.yaml`. `name` is a pattern."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    title: str
    type: str
    name: str
    page: str
    note: str
    ends: dict[str, datetime.date] = {}

    def covers(self, component: Component) -> bool:
        purl = component.purl
        kind = purl.type if purl else component.type
        return kind == self.type and re.fullmatch(self.name, component.name) is not None

    def end(self, version: str) -> datetime.date | None:
        release = version.partition(":")[2] or version  # an epoch of Debian's
        fits = [name for name in self.ends if re.match(rf"{re.escape(name)}(?![0-9])", release)]
        return self.ends[max(fits, key=len)] if fits else None


@dataclass(frozen=True)
class End:
    """The end of support of something. `day` is the last one with support, such as 2028-06-30; empty if there is none."""

    title: str
    version: str
    day: str
    note: str
    page: str = ""

    def has_ended(self, today: datetime.date) -> bool:
        return bool(self.day) and self.day < str(today)

    def to_json(self) -> dict[str, Any]:
        return asdict(self)


@cache
def table() -> tuple[Supported, ...]:
    entries = untrusted.yaml_of(FILE.read_bytes(), str(FILE))
    return tuple(adapter(list[Supported]).validate_python(entries))


def ends(components: Iterable[Component], distribution: str, matrix: Matrix) -> list[End]:
    """The ends of support of an image, the earliest first; those without a day last. `distribution` is the image's ROS; it may be empty."""
    every = {*_of_ros(distribution, matrix), *_of_components(components)}
    return sorted(every, key=lambda it: (not it.day, it.day, it.title, it.version))


def _of_ros(distribution: str, matrix: Matrix) -> Iterator[End]:
    if not distribution:
        return
    entry = matrix.distributions.get(distribution)
    day = str(entry.eol) if entry and entry.eol else ""
    if entry is None:
        note = UNKNOWN
    else:
        note = "of this ROS distribution" if day else "a rolling distribution: each package until the next one"
    yield End("ROS", shortened(distribution), day, note)


def _of_components(components: Iterable[Component]) -> Iterator[End]:
    for component in components:
        for entry in table():
            if entry.covers(component):
                day = entry.end(component.version)
                note = entry.note if day or not entry.ends else f"{UNKNOWN}; {entry.note}"
                yield End(entry.title, shortened(component.version), str(day or ""), note, entry.page)
