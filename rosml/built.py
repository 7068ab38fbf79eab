"""What was built and tested, and how large it was: docs/built.json, from which the tables of docs/built.md and README.md are
made. One record for each image, of the last time; people write what else there is to say."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from datetime import date
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, ValidationError

from rosml import files, results
from rosml.catalogue import Published
from rosml.errors import RosmlError
from rosml.expand import Catalogue
from rosml.model import Facts, Target
from rosml.problems import listed

BEGIN = "<!-- built {day}: written by scripts/generate_bake.py -->"
END = "<!-- /built -->"
OUTDATED = "†"
"""Stands in the tables beside what is outdated; the text says why."""


class Built(Facts):
    """An image that was built and passed its tests, on one machine.

    Attributes:
        date: when. compressed, unpacked: bytes. passed: structure tests. seconds: wall time of the call; each None where
            nobody wrote it down.
        outdated: whether its payloads have changed so much since that its sizes are no more those of today. Whoever
            records it anew takes that away.
    """

    target: Target
    date: Annotated[date, Field(strict=False)]
    compressed: int | None = None
    unpacked: int | None = None
    passed: int
    seconds: float | None = None
    outdated: bool = False


def read(file: Path) -> tuple[Built, ...]:
    """The records.

    Raises:
        RosmlError: the file is no list of them.
    """
    try:
        return tuple(Built.model_validate(item) for item in json.loads(file.read_text(encoding="utf-8")))
    except (OSError, ValueError, TypeError, ValidationError) as error:
        raise RosmlError(
            f"{file}: no list of what was built: {error}", "get it back: git checkout docs/built.json"
        ) from None


def text(records: Iterable[Built]) -> str:
    """docs/built.json: a line for each image, so that a change of one is a change of one line."""
    lines = [json.dumps(item.model_dump(mode="json", exclude_defaults=True), ensure_ascii=False) for item in records]
    return "[\n" + ",\n".join(f"  {line}" for line in lines) + "\n]\n"


def merged(known: Iterable[Built], newer: Iterable[Built], catalogue: Catalogue) -> tuple[Built, ...]:
    """Records with newer ones in the place of those that they replace, in the order of the matrix; those of images that the
    matrix has no more are gone."""
    by_target = {item.target: item for item in (*known, *newer)}
    return tuple(by_target[image.target] for image in catalogue.images if image.target in by_target)


def record(file: Path, newer: Sequence[Built], catalogue: Catalogue) -> int:
    """Writes newer records into the file; gives how many.

    Raises:
        RosmlError: the file is no list of records, or cannot be written.
    """
    files.write(file, text(merged(read(file), newer, catalogue)))
    return len(newer)


def of_results(records: Iterable[results.Record], day: date) -> tuple[Built, ...]:
    """What `make image` wrote down in this checkout; what failed was not built."""
    return tuple(
        Built(
            target=item["target"],
            date=day,
            compressed=item["compressed"],
            unpacked=item["unpacked"],
            passed=item["passed"],
            seconds=round(sum(item["seconds"].values()), 1),
        )
        for item in records
        if item["passed"] and not item["failed"]
    )


def of_catalogue(published: Published) -> tuple[Built, ...]:
    """What is published in a registry, by its first platform; without what nobody knows the tests of."""
    found = []
    for image in published.images:
        build = image.builds[0] if image.status == "built" else None
        platform = build.platforms[0] if build else None
        if build and platform and build.created and platform.tests and not platform.tests.failures:
            found.append(
                Built(
                    target=image.target,
                    date=date.fromisoformat(build.created[:10]),
                    compressed=platform.size.compressed,
                    unpacked=platform.size.unpacked,
                    passed=platform.tests.passed,
                )
            )
    return tuple(found)


def table(records: Iterable[Built]) -> str:
    """A table in Markdown."""
    lines = [f"| {' | '.join(results.COLUMNS)} |", "| --- |" + " ---: |" * (len(results.COLUMNS) - 1)]
    for item in records:
        known: dict[str, Any] = {
            "target": item.target,
            "compressed": item.compressed or 0,
            "unpacked": item.unpacked or 0,
            "passed": item.passed,
            "failed": 0,
            "seconds": {"all": item.seconds or 0.0},
        }
        ((name, compressed, unpacked, passed, seconds),) = results.rows([known])
        cells = [
            f"`{name}`{f' {OUTDATED}' if item.outdated else ''}",
            compressed if item.compressed else "",
            unpacked if item.unpacked else "",
            passed,
            seconds if item.seconds else "",
        ]
        lines.append(f"| {' | '.join(cells)} |".replace("|  |", "| |").replace("|  |", "| |"))
    return "\n".join(lines) + "\n"


def render(document: str, records: Sequence[Built]) -> str:
    """docs/built.md with its tables, each between markers that name its day.

    Raises:
        RosmlError: there is no place for the records of a day, or a place for a day without any.
    """
    days = list(dict.fromkeys(str(item.date) for item in records))
    for day in days:
        head, begin, rest = document.partition(BEGIN.format(day=day))
        _, end, tail = rest.partition(END)
        if not begin or not end:
            remedy = f"write a section for it there, with the lines {BEGIN.format(day=day)} and {END}"
            raise RosmlError(f"docs/built.md has no place for what was built on {day}", remedy)
        document = f"{head}{begin}\n{table(item for item in records if str(item.date) == day)}{end}{tail}"
    known = {BEGIN.format(day=day) for day in days}
    empty = [line for line in document.splitlines() if line.startswith(BEGIN.partition("{")[0]) and line not in known]
    if empty:
        raise RosmlError(f"docs/built.md: nothing in docs/built.json is for {listed(empty)}", "remove that section")
    return document
