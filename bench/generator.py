"""How fast the generator is, on the project's own matrix and on larger ones: no registry, no builder."""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from bench import synthetic
from bench.limits import Held
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.base.terminal import show, table
from rosml.images.bake import bake_file
from rosml.images.bake.inputs import Inputs
from rosml.images.catalogue import readme
from rosml.images.image_set import load
from rosml.images.matrix import source
from rosml.images.publish import shards

RUNS = 5
"""Whole runs on the real matrix, of which the median counts."""

ROUNDS = 3
"""Measurements of everything else, of which the median counts."""

SIZES = (1_000, 2_000, 5_000, 10_000)
"""Images of the synthetic matrices, about."""

REAL_SECONDS = 0.5
"""A whole run on the real matrix, with the start of the interpreter."""

LARGEST_SECONDS = 3.0
"""The largest matrix, without it."""

GROWTH = 1.5
"""An image of the largest matrix may take so many times as long as one of the smallest."""

PLAN_SECONDS, DIGESTS_SECONDS = 2.0, 0.5
"""Dealing the largest matrix out to machines; what decides the content of each real image."""


@dataclass(frozen=True)
class Measured:
    """Seconds from a matrix' text to the text of the bake file and README's table, all in this process."""

    images: int
    seconds: float

    @property
    def each(self) -> float:
        """Microseconds for an image."""
        return self.seconds / self.images * 1_000_000


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
    text = synthetic.matrix(images).encode()

    def work() -> None:
        image_set = load.image_set(source.parse(text))
        bake_file.render(image_set)
        readme.tables(image_set)

    return Measured(len(load.image_set(source.parse(text)).images), median(work))


def median(work: Callable[[], object]) -> float:
    """Seconds that a piece of work in this process takes: the median of some rounds."""
    seconds = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
    return statistics.median(seconds)


def held() -> list[Held]:
    """What is measured beside the generator's own output."""
    largest = load.image_set(source.parse(synthetic.matrix(SIZES[-1]).encode()))
    real = load.load(ROOT / "matrix.yaml", ROOT)

    def digests() -> None:
        inputs = Inputs(ROOT, real)
        for image in real.images:
            inputs.together(image)

    return [
        Held("dealing the largest matrix out to 20 machines", median(lambda: shards.deal(largest, 20)), PLAN_SECONDS),
        Held("digests of the real images' inputs", median(digests), DIGESTS_SECONDS),
    ]


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
    numbers = ("seconds", "limit", "µs for an image", "limit")
    made = table("matrix", *numbers, right=numbers)
    made.add_row("the real one, with the interpreter's start", f"{real:.2f}", f"{REAL_SECONDS:.2f}", "", "")
    for size in sizes:
        largest = size is sizes[-1]
        limits = (f"{LARGEST_SECONDS:.2f}", f"{GROWTH * sizes[0].each:.0f}") if largest else ("", "")
        made.add_row(f"{size.images} images", f"{size.seconds:.2f}", limits[0], f"{size.each:.0f}", limits[1])
    show(made)
