"""What was built and tested, and how large it was: docs/built.json, from which the tables of docs/built.md and README.md are
made. One record for each image, of the last time; people write what else there is to say."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from datetime import date
from pathlib import Path
from typing import Annotated, Any

import click
from pydantic import Field, ValidationError

from rosml import files, results
from rosml.catalogue import Published
from rosml.errors import RosmlError
from rosml.expand import Catalogue
from rosml.model import Facts, Target
from rosml.problems import counted, listed

BEGIN = "<!-- built {day}: written by scripts/generate_bake.py -->"
END = "<!-- /built -->"
OUTDATED = "†"
"""Stands in the tables beside what is outdated; the text says why."""

REMEDY = "git checkout docs/built.json"

Bytes = Annotated[int, Field(ge=0, le=10**15)]
Passed = Annotated[int, Field(ge=0, le=10**6)]
Seconds = Annotated[float, Field(ge=0, le=10**8, allow_inf_nan=False)]


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
    compressed: Bytes | None = None
    unpacked: Bytes | None = None
    passed: Passed
    seconds: Seconds | None = None
    outdated: bool = False


def read(file: Path) -> tuple[Built, ...]:
    """The records, at most one for each target; targets that the matrix does not have are allowed.

    Raises:
        RosmlError: the file is no list of them.
    """
    wrong = f"{files.shown(file)}: no list of what was built"
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
    except RecursionError:
        raise RosmlError(f"{wrong}: nested too deeply", REMEDY) from None
    except (OSError, ValueError) as error:
        raise RosmlError(f"{wrong}: {error}", REMEDY) from None
    if not isinstance(content, list):
        raise RosmlError(wrong, REMEDY)
    found: dict[str, Built] = {}
    for number, facts in enumerate(content, start=1):
        try:
            item = Built.model_validate(facts)
        except ValidationError as error:
            raise RosmlError(f"{wrong}: record {number}: {_first(error)}", REMEDY) from None
        except OverflowError:
            raise RosmlError(f"{wrong}: record {number}: a number is too large", REMEDY) from None
        if item.target in found:
            raise RosmlError(f"{wrong}: record {number}: {item.target} is there twice", REMEDY)
        found[item.target] = item
    return tuple(found.values())


def _first(error: ValidationError) -> str:
    """What is wrong, without the value: that may be of any length."""
    problem = error.errors(include_url=False, include_context=False, include_input=False)[0]
    return ": ".join(text for text in (".".join(map(str, problem["loc"])), problem["msg"]) if text)


def text(records: Iterable[Built]) -> str:
    """docs/built.json: a line for each image, so that a change of one is a change of one line."""
    lines = [json.dumps(item.model_dump(mode="json", exclude_defaults=True), ensure_ascii=False) for item in records]
    return "[\n" + ",\n".join(f"  {line}" for line in lines) + "\n]\n"


def merged(known: Iterable[Built], newer: Iterable[Built], catalogue: Catalogue) -> tuple[Built, ...]:
    """Records with newer ones in the place of those that they replace, in the order of the matrix; those of images that the
    matrix has no more are gone."""
    by_target = {item.target: item for item in (*known, *newer)}
    return tuple(by_target[image.target] for image in catalogue.images if image.target in by_target)


def left_out(known: Iterable[Built], catalogue: Catalogue) -> str:
    """A remark about records that `merged` leaves out; empty where there are none."""
    number = sum(item.target not in catalogue.by_target for item in known)
    if not number:
        return ""
    images, are, them = ("an image", "is", "it") if number == 1 else ("images", "are", "them")
    return (
        f"docs/built.json: {counted(number, 'record')} of {images} that the matrix no longer has {are} left out "
        f"({REMEDY} brings {them} back)"
    )


def record(file: Path, newer: Sequence[Built], catalogue: Catalogue) -> int:
    """Writes newer records into the file, and says which old ones it loses; gives how many.

    Raises:
        RosmlError: the file is no list of records, or cannot be written.
    """
    known = read(file)
    files.write(file, text(merged(known, newer, catalogue)))
    if remark := left_out(known, catalogue):
        click.echo(remark, err=True)
    return len(newer)


def _made(**facts: Any) -> Built:
    try:
        return Built(**facts)
    except ValidationError as error:
        raise RosmlError(f"{facts['target']}: cannot be recorded: {_first(error)}", "publish it again") from None


def of_results(records: Iterable[results.Record], day: date) -> tuple[Built, ...]:
    """What `make image` wrote down in this checkout; what failed was not built."""
    return tuple(
        _made(
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
                _made(
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
