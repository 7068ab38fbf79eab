"""Measures the generator and the start of `rosml run`, our second image beside one whose Dockerfile has a `RUN pip install`,
and many tags.

\b
Examples:
  uv run python -m bench --generator       the generator and rosml run alone: no registry, no builder
  uv run python -m bench                   all, with a small image (make bench)
  uv run python -m bench --target ros1-bookworm-base-torch-cu128
                                           with one that has CUDA: 35 GB of free disk

A page with charts is written as well: .state/bench/report/report.md, and report.json beside it.
"""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import click

from bench import generator, limits, many_tags, report, second_image, start
from bench.here import Here
from bench.limits import Held
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.images.image_set import load
from rosml.machine.services import Services

TARGET = "ros1-bookworm-base-tensorflow-cpu"
"""What is built in both ways: the smallest with a framework. One with CUDA takes several times as long."""

REPORT = ROOT / ".state/bench/report"
"""Where the page with charts is written, if nothing else is said."""

SECOND_IMAGE_SECONDS, JOIN_SECONDS, ENTRYPOINT_SECONDS, SHELL_SECONDS = 20.0, 1.0, 0.05, 0.2
"""Building and pushing a second image; one of many joined images; the entrypoint beyond what it sources; an interactive
shell with its banner."""


@click.command(help=__doc__, context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--generator",
    "only_generator",
    is_flag=True,
    help="Measure the generator and rosml run alone; needs no registry and no builder.",
)
@click.option("--target", default="", help=f"The image that is built in both ways; {TARGET} if it is empty.")
@click.option("--json", "as_json", is_flag=True, help="Print the numbers as JSON.")
@click.option(
    "--output", default="", metavar="FOLDER", help="Where the report is written; .state/bench/report if it is empty."
)
@click.option("--check", is_flag=True, help="Exit 1 if a limit is missed, which an idle machine can tell.")
def main(only_generator: bool, target: str, as_json: bool, output: str, check: bool) -> None:
    if only_generator and target:
        raise click.UsageError("--generator builds no image: leave --target out")
    # What cannot be built is told before all else.
    here = None if only_generator else bench_here(target or TARGET)
    data: dict[str, Any] = {"machine": report.machine()}
    held, problems = measure_generator(data, quiet=as_json)
    held.append(start.held())
    if here:
        held += measure_images(here, target or TARGET, data, quiet=as_json)
    data["limits"] = [asdict(item) for item in held]
    if not as_json:
        click.echo()
        limits.print_table(held)
    of_generator = {"real": generator.REAL_SECONDS, "largest": generator.LARGEST_SECONDS}
    written = report.write(data, Path(output) if output else REPORT, of_generator)
    if as_json:
        click.echo(json.dumps(data, indent=2))
    click.echo(f"with charts: {written}", err=True)
    problems += limits.missed(held)
    if problems and check:
        raise RosmlError(
            "too slow: " + "; ".join(problems),
            "see where the time goes: uv run python -m cProfile -s tottime scripts/generate_bake.py --check",
        )
    for problem in problems:
        click.echo(f"{problem} for an idle machine", err=True)


def measure_generator(data: dict[str, Any], quiet: bool) -> tuple[list[Held], list[str]]:
    """Measures the generator, and adds the numbers to the report's data; gives what has limits, and which of the generator's
    own are missed."""
    real = generator.whole_run()
    sizes = [generator.measured(size) for size in generator.SIZES]
    data["real_seconds"] = real
    data["sizes"] = [asdict(size) for size in sizes]
    data["growth"] = sizes[-1].each / sizes[0].each
    if not quiet:
        generator.print_table(real, sizes)
    return generator.held(), generator.missed(real, sizes)


def measure_images(here: Here, target: str, data: dict[str, Any], quiet: bool) -> list[Held]:
    """Measures a second image and many tags, and adds the numbers to the report's data; gives what has limits."""
    found = second_image.compare(here, target)
    data["comparison"] = found.to_json()
    if not quiet:
        click.echo()
        second_image.print_table(found)
    grown = many_tags.measure(here, here.image_set.image(target).target, found)
    data["growth_of_tags"] = grown.to_json()
    if not quiet:
        click.echo()
        many_tags.print_table(grown, found.target)
    last = grown.rows[-1]
    return [
        Held("a second image, built and pushed", found.ours.build_and_push_seconds, SECOND_IMAGE_SECONDS),
        Held("one of many joined images", last.seconds / last.tags, JOIN_SECONDS),
        Held("the entrypoint", found.ours.start_seconds, ENTRYPOINT_SECONDS),
        Held("an interactive shell with its banner", found.ours.shell_seconds, SHELL_SECONDS),
    ]


def bench_here(target: str) -> Here:
    """What builds in the bench's namespace of the local registry.

    Raises:
        RosmlError: the target cannot be built in both ways, or the services are not up.
    """

    def say(line: str) -> None:
        click.echo(click.style(f"==> {line}", bold=True), err=True)

    image_set = load.load(ROOT / "matrix.yaml", ROOT)
    second_image.require_comparable(image_set.image(target), image_set, ROOT)
    return Here(Services.load(ROOT), image_set, say, second_image.NAMESPACE)
