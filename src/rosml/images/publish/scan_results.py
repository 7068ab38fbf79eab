"""The results of a scan, as a file for a job that may write into the registry.

The scanner is a large program that reads foreign data, so it gets no right to publish. Its job hands over an outcome for each image.
Outcomes go only into entries about the same image digest. Nothing else in the registry changes.
"""

from __future__ import annotations

import json
import time
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal

from pydantic import ConfigDict, ValidationError

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import Shape
from rosml.images.publish import vex as publish_vex
from rosml.images.publish.run import Outcome, Run
from rosml.images.records import store
from rosml.images.scan import judge, vex
from rosml.images.scan.trivy import WRITTEN_BYTES
from rosml.images.scan.vex import Statement
from rosml.registry.references import is_digest

PAUSE_SECONDS = 30.0
"""Between two writes of the file during a scan."""


@dataclass
class Results:
    """Facts for entries of the records, by target and architecture; `date` is the run's."""

    file: Path
    date: str
    entries: dict[tuple[str, str], dict[str, Any]] = field(default_factory=dict)
    _written: float = float("-inf")

    def add(self, entry: store.Entry, statements: Sequence[Statement] = ()) -> None:
        """Adds the result of an image, and its new VEX. Writes the file from time to time: if a scan is killed, its finished images are kept."""
        facts = entry.to_json()
        names = ("target", "architecture", "digest", "scanned", "scan")
        result = {name: facts[name] for name in names if name in facts}
        if statements:
            result["vex"] = vex.packed(statements)
        self.entries[entry.target, entry.architecture] = result
        if time.monotonic() - self._written >= PAUSE_SECONDS:
            self.write()

    def write(self) -> None:
        content = {"version": 1, "date": self.date, "entries": list(self.entries.values())}
        files.write(self.file, json.dumps(content))
        self._written = time.monotonic()


class _File(Shape):
    model_config = ConfigDict(frozen=True, strict=True)

    version: Literal[1]
    entries: list[Any]


def record(run: Run, file: Path) -> None:
    """Writes the results of a scan into the registry."""
    for scanned, statements in _read(file):
        key = scanned.target, scanned.architecture
        entry = run.state.entries.get(key)
        if entry is None or entry.digest != scanned.digest:
            run.outcomes.append(Outcome("record", *key, "waits", "it was rebuilt after the scan"))
            continue
        entry = replace(entry, scanned=scanned.scanned, scan=scanned.scan, changed=run.state.date)
        if statements:
            entry = publish_vex.attach(run.state.place, entry, statements, run.state.date)
        run.records.write(entry)
        run.state.entries[key] = entry
        run.outcomes.append(Outcome("record", *key, "done", scanned.scanned))


def _read(file: Path) -> list[tuple[store.Entry, list[Statement]]]:
    try:
        data = file.read_bytes()
        content = _File.model_validate_json(untrusted.json_text(data, WRITTEN_BYTES))
        untrusted.json_value(data, WRITTEN_BYTES)  # checks it: the entries go into the records unchanged
        return [_entry(item) for item in content.entries]
    except (OSError, ValueError) as error:
        reason = first_of(error) if isinstance(error, ValidationError) else getattr(error, "strerror", "") or error
        text = f"{file} does not hold the results of a scan: {reason}"
        raise RosmlError(text, "write it again with: rosml publish scan --output FILE", exit_code=2) from None


def _entry(item: Any) -> tuple[store.Entry, list[Statement]]:
    text = item.pop("vex", "") if isinstance(item, dict) else ""
    entry, statements = store.parse(item), vex.unpacked(str(text)) if text else []
    outcomes = {outcome.value for outcome in judge.Outcome}
    if entry is None or entry.scanned not in outcomes or not is_digest(entry.digest):
        raise ValueError("an entry has no outcome of a scan")
    return entry, statements
