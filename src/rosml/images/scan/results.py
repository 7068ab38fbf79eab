"""What a scan found, as a file for a job that may write into the registry.

The scanner is a large program that reads whatever is in the images and fetches a database; it gets no right to publish.
What its job hands over is data: an outcome for each image.
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
"""Version of the file's format."""


PAUSE_SECONDS = 30.0
"""Between two times that the file is written while the scan goes on."""


@dataclass
class Results:
    """What is handed over: facts of entries of the records.

    Attributes:
        file: where it goes. date: of the run.
        entries: by target and architecture.
    """

    file: Path
    date: str
    entries: dict[tuple[str, str], dict[str, Any]] = field(default_factory=dict)
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
        content = {"version": FORMAT, "date": self.date, "entries": list(self.entries.values())}
        files.write(self.file, json.dumps(content))
        self._written = time.monotonic()
