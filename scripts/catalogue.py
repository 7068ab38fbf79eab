#!/usr/bin/env python3
"""Writes the catalogue of what is published: a page for people, and catalogue.json."""

from __future__ import annotations

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import rosml.base.environment  # noqa: F401 (first: says what to do where the others are missing)

# isort: split

import click

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.cli import command


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--registry",
    default="",
    metavar="PREFIX",
    help="where the images are, such as ghcr.io/me/rosml; the local registry's rosml if left out",
)
@click.option("--matrix", type=click.Path(path_type=Path), default=ROOT / "matrix.yaml", help="another matrix.yaml")
@click.option("--only", multiple=True, metavar="GLOB", help="images by target, pattern or group; repeatable")
@click.option(
    "--output",
    type=click.Path(path_type=Path, file_okay=False),
    default=ROOT / ".state/catalogue",
    help="the folder to write; .state/catalogue if left out",
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

    Reads manifests, configs and the ledger; pulls no layer, builds nothing, and needs no right to write.

    \b
    Examples:
      uv run scripts/catalogue.py
      uv run scripts/catalogue.py --registry ghcr.io/me/rosml --output public
      uv run scripts/catalogue.py --only 'bookworm-*' --json
    """
    from rosml.base.clock import now
    from rosml.base.problems import counted
    from rosml.catalogue import site
    from rosml.catalogue.read import Gatherer
    from rosml.images import load
    from rosml.machine.services import Services
    from rosml.registry import oci
    from rosml.registry.repositories import destination

    catalogue = load.load(matrix, ROOT)
    ca_bundle = os.environ.get("SSL_CERT_FILE", "")
    if not registry:
        services = Services.load(ROOT)
        registry, ca_bundle = services.place, services.ca_bundle
    place = destination(registry.lower())
    words = tuple(word for text in only for word in text.split())  # a job in CI has one field for all of them
    with oci.Registry(place.host, ca_bundle=ca_bundle) as client:
        gatherer = Gatherer(catalogue, client, f"{place.host}/{place.prefix}", place.prefix, history)
        found = gatherer.gather(now(), words)
    for remark in gatherer.remarks:
        click.echo(f"{click.style('warning:', fg='yellow', bold=True)} {remark}", err=True)
    if as_json:
        click.echo(site.text(found), nl=False)
        return
    try:
        written = site.write(output, found)
    except OSError as error:
        raise RosmlError(f"{output}: {error.strerror}", "name a folder that you may write to") from None
    published = sum(image.status == "built" for image in found.images)
    click.echo(
        f"{counted(len(found.images), 'image')} described, {published} of them published in {found.registry}", err=True
    )
    click.echo(next(file for file in written if file.name == "index.html").resolve().as_uri())


if __name__ == "__main__":
    sys.exit(command.run(main))
