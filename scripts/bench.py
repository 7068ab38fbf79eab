#!/usr/bin/env python3
"""Measures the generator: a whole run on the real matrix, and matrices of up to 10,000 images."""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import rosml.environment  # noqa: F401 (first: says what to do where the others are missing)

# isort: split

import click

from rosml import ROOT, command
from rosml.errors import RosmlError

RUNS = 5
"""Whole runs on the real matrix, of which the median counts."""

ROUNDS = 3
"""Measurements of each size, of which the fastest counts: what other programs take away is not the generator's."""

SIZES = (1_000, 2_000, 5_000, 10_000)
"""Images of the synthetic matrices, about."""

REAL_SECONDS = 0.5
"""A whole run on the real matrix, with the start of the interpreter."""

LARGEST_SECONDS = 3.0
"""The largest matrix, without it."""

GROWTH = 1.5
"""An image of the largest matrix may take so many times as long as one of the smallest."""


@dataclass(frozen=True)
class Measured:
    """Seconds from a matrix' text to the text of the bake file and README's table, all in this process."""

    images: int
    seconds: float

    @property
    def each(self) -> float:
        """Microseconds for an image."""
        return self.seconds / self.images * 1_000_000


@click.command(help=__doc__)
@click.option("--json", "as_json", is_flag=True, help="Print the numbers as JSON.")
@click.option("--check", is_flag=True, help="Exit 1 if a limit is missed; on an idle machine it means something.")
def main(as_json: bool, check: bool) -> None:
    real = whole_run()
    sizes = [measured(size) for size in SIZES]
    if as_json:
        growth = sizes[-1].each / sizes[0].each
        data = {"real_seconds": real, "sizes": [asdict(size) for size in sizes], "growth": growth}
        click.echo(json.dumps(data, indent=2))
    else:
        print_table(real, sizes)
    problems = missed(real, sizes)
    if problems and check:
        raise RosmlError(
            "the generator is too slow: " + "; ".join(problems),
            "see where the time goes: uv run python -m cProfile -s tottime scripts/generate_bake.py --check",
        )
    for problem in problems:
        click.echo(f"{problem} for an idle machine", err=True)


def whole_run() -> float:
    """Seconds of a run on the real matrix that renders every file: the median, in processes of their own."""
    argv = [sys.executable, str(ROOT / "scripts/generate_bake.py"), "--check"]
    seconds = []
    for _ in range(RUNS):
        start = time.perf_counter()
        done = subprocess.run(argv, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        seconds.append(time.perf_counter() - start)
        if done.returncode:
            raise RosmlError(f"generate_bake.py --check failed:\n{done.stderr.strip()}")
    return statistics.median(seconds)


def measured(images: int) -> Measured:
    """A synthetic matrix of about that many images."""
    from rosml import bake, expand, readme, source, synthetic

    text = synthetic.matrix(images).encode()
    seconds = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        catalogue = expand.catalogue(source.parse(text))
        bake.render(catalogue)
        readme.tables(catalogue)
        seconds.append(time.perf_counter() - start)
    return Measured(len(catalogue.images), min(seconds))


def missed(real: float, sizes: Sequence[Measured]) -> list[str]:
    """The limits that are missed, each with its numbers."""
    small, large = sizes[0], sizes[-1]
    problems = []
    if real >= REAL_SECONDS:
        problems.append(f"the real matrix takes {real:.2f} s; the limit of {REAL_SECONDS} s holds")
    if large.seconds >= LARGEST_SECONDS:
        problems.append(f"{large.images} images take {large.seconds:.2f} s; the limit of {LARGEST_SECONDS} s holds")
    if large.each > GROWTH * small.each:
        problems.append(
            f"an image takes {large.each:.0f} µs among {large.images} and {small.each:.0f} µs among {small.images}; "
            f"the limit of {GROWTH} times that holds"
        )
    return problems


def print_table(real: float, sizes: Sequence[Measured]) -> None:
    """Prints the numbers beside their limits."""
    from rich.table import Table  # slow to import, and only needed here

    from rosml.listing import show

    table = Table(box=None, header_style="bold", pad_edge=False)
    table.add_column("matrix", no_wrap=True)
    for column in ("seconds", "limit", "µs for an image", "limit"):
        table.add_column(column, justify="right", no_wrap=True)
    table.add_row("the real one, with the interpreter's start", f"{real:.2f}", f"{REAL_SECONDS:.2f}", "", "")
    for size in sizes:
        largest = size is sizes[-1]
        limits = (f"{LARGEST_SECONDS:.2f}", f"{GROWTH * sizes[0].each:.0f}") if largest else ("", "")
        table.add_row(f"{size.images} images", f"{size.seconds:.2f}", limits[0], f"{size.each:.0f}", limits[1])
    show(table)


if __name__ == "__main__":
    sys.exit(command.run(main))
