"""Measures our second image beside one whose Dockerfile has a `RUN pip install`, or the start of `rosml run`.

\b
Examples:
  uv run python -m bench                   a small image, both ways (make bench)
  uv run python -m bench --target ros1-bookworm-base-torch-cu128
                                           one that has CUDA: 35 GB of free disk
  uv run python -m bench --start           what rosml run takes longer than docker run
  uv run python -m bench --fleet           a thousand apps that move to tonight's base images
  uv run python -m bench --addons          an add-on that is joined to an image, and to an app
"""

from __future__ import annotations

import click

from bench import addons, fleet, second_image, start
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.images.image_set import load
from rosml.machine.services import Services

TARGET = "ros1-bookworm-base-tensorflow-cpu"
"""The smallest image with a framework. One with CUDA takes several times as long."""


@click.command(help=__doc__, context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--target", default="", help=f"The image that is built in both ways; {TARGET} if it is empty.")
@click.option("--start", "only_start", is_flag=True, help="Measure the start of rosml run alone.")
@click.option("--fleet", "only_fleet", is_flag=True, help="Move a thousand apps alone.")
@click.option("--apps", default=fleet.APPS, help="How many apps --fleet moves.")
@click.option("--addons", "only_addons", is_flag=True, help="Join add-ons alone.")
def main(target: str, only_start: bool, only_fleet: bool, apps: int, only_addons: bool) -> None:
    if only_start:
        click.echo(f"rosml run takes {start.seconds():.3f} s longer than docker run (median of {start.ROUNDS})")
        return
    if only_fleet:
        found, again = fleet.measure(Services.load(ROOT), apps, _say)
        fleet.print_table(found, again)
        if found.beyond:
            raise RosmlError(f"one app took {'; '.join(found.beyond)}")
        return
    image_set = load.load(ROOT / "matrix.yaml", ROOT)
    if only_addons:
        rows = addons.measure(Services.load(ROOT), image_set, _say)
        addons.print_table(rows)
        if beyond := [line for row in rows for line in row.beyond]:
            raise RosmlError("; ".join(beyond))
        return
    image = image_set.image(target or TARGET)
    second_image.require_comparable(image, ROOT, image_set)

    second_image.print_table(image, second_image.compare(Services.load(ROOT), image_set, image, _say))


def _say(line: str) -> None:
    click.echo(click.style(f"==> {line}", bold=True), err=True)
