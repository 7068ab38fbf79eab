"""The results of a scan, as a file for a job that may write into the registry.

The scanner is a large program that reads foreign data, so it gets no right to publish. Its job hands over an outcome for each image.
"""

from __future__ import annotations

import json
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosml.base import files
from rosml.images.records.store import Entry

FORMAT = 1

PAUSE_SECONDS = 30.0
"""Between two writes of the file during a scan."""


@dataclass
class Results:
    """Facts for entries of the records, by target and architecture; `date` is the run's."""

    file: Path
    date: str
    entries: dict[tuple[str, str], dict[str, Any]] = field(default_factory=dict)
    _written: float = float("-inf")

    def add(self, entry: Entry) -> None:
        """Adds the result of an image, and writes the file from time to time: if a scan is killed, its finished images are kept."""
        facts = entry.to_json()
        names = ("target", "architecture", "digest", "scanned", "scan")
        self.entries[entry.target, entry.architecture] = {name: facts[name] for name in names if name in facts}
        if time.monotonic() - self._written >= PAUSE_SECONDS:
            self.write()

    def write(self) -> None:
        content = {"version": FORMAT, "date": self.date, "entries": list(self.entries.values())}
        files.write(self.file, json.dumps(content))
        self._written = time.monotonic()
