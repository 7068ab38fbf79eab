"""What was published from this checkout: one record for each image, as a table for people and for the documentation."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from rosml.errors import RosmlError
from rosml.expand import Catalogue
from rosml.summary import duration, size

Record = dict[str, Any]
"""The outcome of publishing an image, as `publish.Result` is written down."""

COLUMNS = ("image", "compressed", "unpacked", "tests passed", "wall time")


def folder(state: Path, namespace: str) -> Path:
    """Where records of a namespace of the local registry are kept."""
    return state / "results" / namespace


def read(state: Path, namespace: str, catalogue: Catalogue) -> list[Record]:
    """The records of a catalogue's images, in its order.

    Raises:
        RosmlError: a record cannot be read.
    """
    files = {file.stem: file for file in folder(state, namespace).glob("*.json")}
    return [_record(files[image.target]) for image in catalogue.images if image.target in files]


def _record(file: Path) -> Record:
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise RosmlError(f"{file}: no record: {error}", remedy="delete it and publish that image again") from None
    if not isinstance(content, dict) or not all(isinstance(content.get(key), kind) for key, kind in _FACTS.items()):
        raise RosmlError(f"{file}: no record of a published image", remedy="delete it and publish that image again")
    return content


_FACTS = {"target": str, "seconds": dict, **dict.fromkeys(("passed", "failed", "compressed", "unpacked"), int)}
"""What the table needs of a record."""


def rows(records: Iterable[Record]) -> Iterator[tuple[str, ...]]:
    """A row for each record, as `COLUMNS` says."""
    for record in records:
        yield (
            record["target"],
            size(record["compressed"]),
            size(record["unpacked"]),
            f"{record['passed']} of {record['passed'] + record['failed']}",
            duration(sum(record["seconds"].values())),
        )


def markdown(records: Iterable[Record]) -> str:
    """The table for the documentation."""
    lines = [f"| {' | '.join(COLUMNS)} |", "| --- |" + " ---: |" * (len(COLUMNS) - 1)]
    lines += [f"| `{name}` | {' | '.join(others)} |" for name, *others in rows(records)]
    return "\n".join(lines) + "\n"


def print_table(records: list[Record]) -> None:
    """Prints the table, with its sums."""
    from rich.table import Table  # slow to import, and only needed here

    from rosml.listing import console, show

    table = Table(box=None, header_style="bold", pad_edge=False)
    for column in COLUMNS:
        table.add_column(column, no_wrap=True, justify="left" if column == "image" else "right")
    for row in rows(records):
        table.add_row(*row)
    show(table)
    out = console()
    total = sum(sum(record["seconds"].values()) for record in records)
    out.print(f"{len(records)} images, {duration(total)} in all", style="dim")
