"""What a scan found, as a file for a job that may write into the registry.

The scanner is a large program that reads whatever is in the images and fetches a database; it gets no right to publish.
What its job hands over is data: for each image an outcome, and SBOMs.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosml.base import files
from rosml.records.store import Entry
from rosml.registry.oci import Registry
from rosml.scan.sbom import Sbom, Shelf

FORMAT = 1
"""Version of the file's format."""


@dataclass
class Results:
    """What is handed over: facts of entries of the records, and SBOMs that are not in the registry yet."""

    entries: list[dict[str, Any]] = field(default_factory=list)
    sboms: list[dict[str, str]] = field(default_factory=list)

    def add(self, entry: Entry) -> None:
        """Adds what a scan found out about an image."""
        facts = entry.to_json()
        names = ("target", "architecture", "digest", "scanned", "scan")
        self.entries.append({name: facts[name] for name in names if name in facts})

    def write(self, file: Path, date: str) -> None:
        """Writes the file."""
        files.write(file, json.dumps({"version": FORMAT, "date": date, **vars(self)}))


class Kept(Shelf):
    """A shelf that reads SBOMs from the registry, and keeps new ones for the file."""

    def __init__(self, client: Registry, scanner: str, results: Results) -> None:
        """As of a shelf; `results` gets what is new."""
        super().__init__(client, scanner)
        self.results = results

    def store(self, repository: str, digest: str, sbom: Sbom) -> None:
        """Keeps an SBOM."""
        place = {"repository": repository, "digest": digest, "scanner": self.scanner}
        self.results.sboms.append({**place, "content": sbom.content.decode()})
