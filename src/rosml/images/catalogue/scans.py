"""The results of scans, from the entries of the records."""

from __future__ import annotations

from typing import Any

from pydantic import ValidationError

from rosml.images.catalogue.model import Scan, Vulnerability
from rosml.images.records.store import Entry
from rosml.images.scan import recorded
from rosml.images.scan.judge import RECORDED


def scan_of(entry: Entry) -> Scan | None:
    """The result of an image's scan; None if the entry is damaged."""
    try:
        if not (scan := recorded.scan_of(entry)):
            return None
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
        # Records of earlier versions say nothing of VEX.
        return Vulnerability.model_validate({"status": ""} | content if isinstance(content, dict) else content)
    except ValidationError:
        return None
