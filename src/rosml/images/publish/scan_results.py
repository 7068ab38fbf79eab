"""Records the results of a scan that had no write access to the registry (scan/results.py).

Results go only into entries about the same image digest. Nothing else in the registry changes.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

from pydantic import ConfigDict, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import Shape
from rosml.images.publish.run import Outcome, Run
from rosml.images.records import store
from rosml.images.scan import judge
from rosml.images.scan.trivy import WRITTEN_BYTES
from rosml.registry.references import is_digest


class _Facts(Shape):
    model_config = ConfigDict(frozen=True, strict=True)


class _Handed(_Facts):
    """The content of the file, as `scan/results.py` writes it."""

    version: Literal[1]
    entries: list[Any]


def record(run: Run, file: Path) -> None:
    """Writes the results of a scan into the registry.

    Raises:
        RosmlError: the file cannot be read, or the registry fails.
    """
    try:
        data = file.read_bytes()
        content = _Handed.model_validate_json(untrusted.json_text(data, WRITTEN_BYTES))
        untrusted.json_value(data, WRITTEN_BYTES)  # checks it: the entries go into the records unchanged
        entries = [_entry(item) for item in content.entries]
    except (OSError, ValueError) as error:
        reason = first_of(error) if isinstance(error, ValidationError) else getattr(error, "strerror", "") or error
        text = f"{file} does not hold the results of a scan: {reason}"
        raise RosmlError(text, "write it again with: rosml publish scan --output FILE", exit_code=2) from None
    for found in entries:
        key = found.target, found.architecture
        known = run.state.known.get(key)
        if known is None or known.digest != found.digest:
            run.outcomes.append(Outcome("record", *key, "waits", "it was rebuilt after the scan"))
            continue
        entry = replace(known, scanned=found.scanned, scan=found.scan, changed=run.state.date)
        run.records.write(entry)
        run.state.known[key] = entry
        run.outcomes.append(Outcome("record", *key, "done", found.scanned))


def _entry(item: Any) -> store.Entry:
    found = store.parse(item)
    if (
        found is None
        or found.scanned not in {outcome.value for outcome in judge.Outcome}
        or not is_digest(found.digest)
    ):
        raise ValueError("an entry has no outcome of a scan")
    return found
