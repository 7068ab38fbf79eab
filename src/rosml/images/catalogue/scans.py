"""The results of scans, from the entries of the records."""

from __future__ import annotations

from typing import Any

from pydantic import ConfigDict, Field, ValidationError

from rosml.base.shapes import Shape
from rosml.images.catalogue.model import Scan, Vulnerability
from rosml.images.records.store import Entry
from rosml.images.scan.judge import RECORDED


class _Recorded(Shape):
    """The scan in an entry of the records."""

    model_config = ConfigDict(strict=True)

    updated: str = ""
    packages: int = 0
    findings: dict[str, int] = {}
    failing: list[str] = []
    vulnerabilities: list[Any] = Field(default=[], alias="named")


def scan_of(entry: Entry) -> Scan | None:
    """The result of an image's scan; None if the entry is damaged."""
    try:
        scan = _Recorded.model_validate(dict(entry.scan))
        return Scan(
            outcome=entry.scanned,
            database=scan.updated,
            packages=scan.packages,
            findings=scan.findings,
            failing=tuple(scan.failing),
            vulnerabilities=tuple(filter(None, map(_vulnerability, scan.vulnerabilities[:RECORDED]))),
        )
    except ValidationError:
        return None


def _vulnerability(content: Any) -> Vulnerability | None:
    """A vulnerability of the records; None if it is damaged: then it counts, and has no name."""
    try:
        return Vulnerability.model_validate(content)
    except ValidationError:
        return None
