#!/usr/bin/env python3
"""Measures the generator, our second image beside one whose Dockerfile has a `RUN pip install`, and many tags.

\b
Examples:
  bench.py --generator                         the generator alone: no registry, no builder
  bench.py                                     all, with a small image (make bench)
  bench.py --target bookworm-base-torch-cu128  with one that has CUDA: 35 GB of free disk

A page with charts is written as well: .state/bench/report/report.md, and report.json beside it.
"""

from __future__ import annotations

import contextlib
import json
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import rosml.environment  # noqa: F401 (first: says what to do where the others are missing)

# isort: split

import click

from rosml import ROOT, command
from rosml.errors import RosmlError

if TYPE_CHECKING:
    from rosml.publish import Publisher

TARGET = "bookworm-base-tensorflow-cpu"
"""What is built in both ways: the smallest with a framework. One with CUDA takes several times as long."""

REPORT = ROOT / ".state/bench/report"
"""Where the page with charts is written, if nothing else is said."""

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

WORST_FILE = f"version: [{'1,' * 60_000}1]"
"""A matrix that is refused after more work for each of its bytes than others."""

PLAN_SECONDS, DIGESTS_SECONDS, REFUSED_SECONDS = 2.0, 0.5, 1.0
"""Dealing the largest matrix out to machines; what decides the content of each real image; refusing the worst file."""

SECOND_IMAGE_SECONDS, COMPOSED_SECONDS, ENTRYPOINT_SECONDS, SHELL_SECONDS = 20.0, 1.0, 0.05, 0.2
"""Building and pushing a second image; one of many composed images; the entrypoint beyond what it sources; an interactive
shell with its banner."""

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


@dataclass(frozen=True)
class Held:
    """A median of seconds beside its limit. Tests hold the work behind it: calls, requests, bytes, layers."""

    what: str
    seconds: float
    limit: float


@click.command(help=__doc__, context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--generator", is_flag=True, help="Measure the generator alone; needs no registry and no builder.")
@click.option("--target", default="", help=f"The image that is built in both ways; {TARGET} if it is empty.")
@click.option("--json", "as_json", is_flag=True, help="Print the numbers as JSON.")
@click.option(
    "--output", default="", metavar="FOLDER", help="Where the report is written; .state/bench/report if it is empty."
)
@click.option("--check", is_flag=True, help="Exit 1 if a limit is missed, which an idle machine can tell.")
def main(generator: bool, target: str, as_json: bool, output: str, check: bool) -> None:
    if generator and target:
        raise click.UsageError("--generator builds no image: leave --target out")
    publisher = None if generator else bench_publisher(target or TARGET)  # what cannot be built is told before all else
    from rosml import bench_report

    environment = bench_report.machine()
    real = whole_run()
    sizes = [measured(size) for size in SIZES]
    held = generator_held()
    growth = sizes[-1].each / sizes[0].each
    data: dict[str, Any] = {
        "machine": environment,
        "real_seconds": real,
        "sizes": [asdict(size) for size in sizes],
        "growth": growth,
    }
    if not as_json:
        print_table(real, sizes)
    if publisher:
        from rosml import comparison
        from rosml import growth as growth_of_tags

        found = comparison.compare(publisher, target or TARGET)
        data["comparison"] = found.to_json()
        if not as_json:
            click.echo()
            comparison.print_table(found)
        grown = growth_of_tags.measure(publisher, publisher.catalogue.image(target or TARGET).target, found)
        data["growth_of_tags"] = grown.to_json()
        held += [
            Held("a second image, built and pushed", found.ours.build_and_push_seconds, SECOND_IMAGE_SECONDS),
            Held("one of many composed images", grown.rows[-1].seconds / grown.rows[-1].tags, COMPOSED_SECONDS),
            Held("the entrypoint", found.ours.start_seconds, ENTRYPOINT_SECONDS),
            Held("an interactive shell with its banner", found.ours.shell_seconds, SHELL_SECONDS),
        ]
        if not as_json:
            click.echo()
            growth_of_tags.print_table(grown, found.target)
    data["limits"] = [asdict(item) for item in held]
    if not as_json:
        click.echo()
        print_limits(held)
    limits = {"real": REAL_SECONDS, "largest": LARGEST_SECONDS}
    report = bench_report.write(data, Path(output) if output else REPORT, limits)
    if as_json:
        click.echo(json.dumps(data, indent=2))
    click.echo(f"with charts: {report}", err=True)
    problems = missed(real, sizes) + [
        f"{item.what} takes {item.seconds:.2f} s; the limit of {item.limit} s holds"
        for item in held
        if item.seconds >= item.limit
    ]
    if problems and check:
        raise RosmlError(
            "too slow: " + "; ".join(problems),
            "see where the time goes: uv run python -m cProfile -s tottime scripts/generate_bake.py --check",
        )
    for problem in problems:
        click.echo(f"{problem} for an idle machine", err=True)


def bench_publisher(target: str) -> Publisher:
    """What builds in the bench's namespace of the local registry.

    Raises:
        RosmlError: the target cannot be built in both ways, or the services are not up.
    """
    from rosml import comparison, expand
    from rosml.publish import Publisher
    from rosml.services import Services

    def say(line: str) -> None:
        click.echo(click.style(f"==> {line}", bold=True), err=True)

    catalogue = expand.load(ROOT / "matrix.yaml", ROOT)
    comparison.require_comparable(catalogue.image(target), catalogue, ROOT)
    return Publisher(Services.load(ROOT), catalogue, say, comparison.NAMESPACE)


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

    def work() -> None:
        catalogue = expand.catalogue(source.parse(text))
        bake.render(catalogue)
        readme.tables(catalogue)

    return Measured(len(expand.catalogue(source.parse(text)).images), median(work))


def median(work: Callable[[], object]) -> float:
    """Seconds that a piece of work in this process takes: the median of some rounds."""
    seconds = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
    return statistics.median(seconds)


def generator_held() -> list[Held]:
    """What is measured beside the generator's own output: without a registry and a builder."""
    from rosml import expand, plan, source, synthetic
    from rosml.inputs import Inputs

    largest = expand.catalogue(source.parse(synthetic.matrix(SIZES[-1]).encode()))
    real = expand.load(ROOT / "matrix.yaml", ROOT)

    def digests() -> None:
        inputs = Inputs(ROOT, real)
        for image in real.images:
            inputs.together(image)

    def refuse() -> None:
        with contextlib.suppress(RosmlError):
            expand.catalogue(source.parse(WORST_FILE.encode()))

    return [
        Held("dealing the largest matrix out to 20 machines", median(lambda: plan.plan(largest, 20)), PLAN_SECONDS),
        Held("digests of the real images' inputs", median(digests), DIGESTS_SECONDS),
        Held("refusing the worst file", median(refuse), REFUSED_SECONDS),
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


def print_limits(held: Sequence[Held]) -> None:
    """Prints medians beside their limits."""
    from rich.table import Table  # slow to import, and only needed here

    from rosml.listing import show

    table = Table(box=None, header_style="bold", pad_edge=False)
    table.add_column("median of", no_wrap=True)
    for column in ("seconds", "limit"):
        table.add_column(column, justify="right", no_wrap=True)
    for item in held:
        table.add_row(item.what, f"{item.seconds:.3f}", f"{item.limit:.2f}")
    show(table)


if __name__ == "__main__":
    sys.exit(command.run(main, "interrupted: no tag was made or moved; finished steps are kept"))
