"""`rosml catalogue`: what is published, as a page for people and as catalogue.json."""

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
    short_help="Writes a page of all published images, and JSON.",
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
    help="the folder to write; if left out, .state/catalogue in the checkout, or rosml/catalogue in your cache",
)
@click.option(
    "--history",
    type=click.IntRange(min=1),
    default=10,
    show_default=True,
    help="for each image, describe at most this many builds that have no tag; builds with a tag are all described",
)
@click.option("--json", "as_json", is_flag=True, help="print catalogue.json on standard output, and write no file")
def main(registry: str, matrix: Path, only: tuple[str, ...], output: Path, history: int, as_json: bool) -> None:
    """Writes the catalogue into a folder. Open it in a browser, or serve it from any static host.

    Reads manifests, configs, SBOMs and the records. Pulls no layer, builds nothing, and needs only read access.

    \b
    Examples:
      rosml catalogue
      rosml catalogue --registry ghcr.io/me/rosml --output public
      rosml catalogue --only 'ros1-bookworm-*' --json
    """
    from rosml.base.clock import now
    from rosml.base.problems import counted
    from rosml.images.catalogue import site
    from rosml.images.catalogue.packages import read as read_packages
    from rosml.images.catalogue.read import Gatherer
    from rosml.images.image_set import load

    if not output.name:
        raise click.UsageError("--output needs the name of a folder")
    image_set = load.load(matrix, ROOT)
    place = options.place_of(registry, ROOT)
    with place.client:
        gatherer = Gatherer(image_set, place, history)
        published = gatherer.gather(now(), only)
        packages, unread = ({}, []) if as_json else read_packages(place, published)
    for remark in (*gatherer.remarks, *unread):
        command.warn(remark)
    if as_json:
        terminal.echo(site.text(published), nl=False)
        return
    try:
        written = site.write(output, published, packages)
    except OSError as error:
        raise RosmlError(f"{output}: {error.strerror}", "choose a writable folder") from None
    described, built = counted(len(published.images), "image"), sum(it.status == "built" for it in published.images)
    terminal.echo(f"{described} described, {built} of them published in {published.registry}", err=True)
    terminal.echo(next(file for file in written if file.name == "index.html").resolve().as_uri())
