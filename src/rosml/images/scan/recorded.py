"""What the records say of an image's scan."""

from __future__ import annotations

from typing import Any

from pydantic import ConfigDict, Field, ValidationError

from rosml.base.shapes import Shape
from rosml.images.records.store import Entry


class Recorded(Shape):
    """The scan in an entry of the records."""

    model_config = ConfigDict(strict=True)

    updated: str = ""  # when the database was made
    packages: int = 0
    findings: dict[str, int] = {}  # their number by severity
    failing: list[str] = []  # advisories that stop the image
    vulnerabilities: list[Any] = Field(default=[], alias="named")


def scan_of(entry: Entry) -> Recorded | None:
    """The scan of an image; None if the entry is damaged."""
    try:
        return Recorded.model_validate(dict(entry.scan))
    except ValidationError:
        return None
