"""Writes the catalogue of what is published: a page for people, and catalogue.json."""

from __future__ import annotations

from pathlib import Path

import click

from rosml import ROOT, STATE
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command, options
from rosml.cli.checkout import Command


@click.command(
    "catalogue",
    short_help="Writes a page of what is published, and the same as JSON.",
    cls=Command,
    alone=True,
    prints=True,
)
@options.registry("where the images are")
@options.MATRIX
@options.ONLY
@click.option(
    "--output",
    type=click.Path(path_type=Path, file_okay=False),
    default=STATE / "catalogue",
    help="the folder to write; .state/catalogue of the checkout if left out, or rosml/catalogue in the user's cache",
)
@click.option(
    "--history",
    type=click.IntRange(min=1),
    default=10,
    show_default=True,
    help="describe so many builds of each image that no tag points at any more; those with a tag are all described",
)
@click.option("--json", "as_json", is_flag=True, help="print catalogue.json on standard output, and write nothing")
def main(registry: str, matrix: Path, only: tuple[str, ...], output: Path, history: int, as_json: bool) -> None:
    """Writes the catalogue into a folder that any static host can serve, or that is opened as it is.

    Reads manifests, configs and the records; pulls no layer, builds nothing, and needs no right to write.

    \b
    Examples:
      rosml catalogue
      rosml catalogue --registry ghcr.io/me/rosml --output public
      rosml catalogue --only 'ros1-bookworm-*' --json
    """
    from rosml.base.clock import now
    from rosml.base.problems import counted
    from rosml.images.catalogue import site
    from rosml.images.catalogue.read import Gatherer
    from rosml.images.image_set import load

    if not output.name:
        raise click.UsageError("--output names no folder")
    image_set = load.load(matrix, ROOT)
    place = options.place_of(registry, ROOT)
    with place.client:
        gatherer = Gatherer(image_set, place, history)
        found = gatherer.gather(now(), only)
    for remark in gatherer.remarks:
        command.warn(remark)
    if as_json:
        terminal.echo(site.text(found), nl=False)
        return
    try:
        written = site.write(output, found)
    except OSError as error:
        raise RosmlError(f"{output}: {error.strerror}", "name a folder that you may write to") from None
    published = sum(image.status == "built" for image in found.images)
    terminal.echo(
        f"{counted(len(found.images), 'image')} described, {published} of them published in {found.registry}", err=True
    )
    terminal.echo(next(file for file in written if file.name == "index.html").resolve().as_uri())
