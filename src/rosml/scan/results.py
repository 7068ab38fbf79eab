"""What a scan found, as a file for a job that may write into the registry.

The scanner is a large program that reads whatever is in the images and fetches a database; it gets no right to publish.
What its job hands over is data: for each image an outcome, and SBOMs.
"""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosml.base import files
from rosml.records.store import Entry
from rosml.registry.oci import Registry
from rosml.scan.sbom import Sbom, Shelf

FORMAT = 1
"""Version of the file's format."""


PAUSE_SECONDS = 30.0
"""Between two times that the file is written while the scan goes on: with the SBOMs of a first scan it has many megabytes."""


@dataclass
class Results:
    """What is handed over: facts of entries of the records, and SBOMs that are not in the registry yet.

    Attributes:
        file: where it goes. date: of the run.
        entries: by target and architecture. sboms: each with its place.
    """

    file: Path
    date: str
    entries: dict[tuple[str, str], dict[str, Any]] = field(default_factory=dict)
    sboms: list[dict[str, str]] = field(default_factory=list)
    _written: float = float("-inf")

    def add(self, entry: Entry) -> None:
        """Adds what a scan found out about an image, and writes the file from time to time: a scan that is killed leaves the
        images that it had got to."""
        facts = entry.to_json()
        names = ("target", "architecture", "digest", "scanned", "scan")
        self.entries[entry.target, entry.architecture] = {name: facts[name] for name in names if name in facts}
        if time.monotonic() - self._written >= PAUSE_SECONDS:
            self.write()

    def write(self) -> None:
        """Writes the file."""
        content = {"version": FORMAT, "date": self.date, "entries": list(self.entries.values()), "sboms": self.sboms}
        files.write(self.file, json.dumps(content))
        self._written = time.monotonic()


class Kept(Shelf):
    """A shelf that reads SBOMs from the registry, and keeps new ones for the file."""

    def __init__(
        self, client: Registry, scanner: str, results: Results, recorded: Mapping[str, str] | None = None
    ) -> None:
        """As of a shelf; `results` gets what is new."""
        super().__init__(client, scanner, recorded)
        self.results = results

    def store(self, repository: str, digest: str, sbom: Sbom) -> None:
        """Keeps an SBOM."""
        place = {"repository": repository, "digest": digest, "scanner": self.scanner}
        self.results.sboms.append({**place, "content": sbom.content.decode()})
