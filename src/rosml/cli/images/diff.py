"""`rosml diff`: which images a change rebuilds."""

from __future__ import annotations

from pathlib import Path

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import options
from rosml.cli.checkout import Command


@click.command("diff", short_help="Lists which images a change rebuilds, and why.", cls=Command, prints=True)
@click.argument("version", metavar="[REVISION]", default="HEAD")
@options.MATRIX
@options.JSON
def main(version: str, matrix: Path, as_json: bool) -> None:
    """Lists which images differ from a git revision or another matrix file, and why. Without REVISION, compares with
    HEAD.

    \b
    Examples:
      rosml diff               which images the uncommitted changes rebuild
      rosml diff v1.2 --json   all changes since a tag, for machines
    """
    from rosml.base import github
    from rosml.cli.images import tables
    from rosml.images.bake import diff as changes
    from rosml.images.bake.inputs import Inputs
    from rosml.images.image_set import load
    from rosml.images.publish import revision

    difference = revision.since(version, Inputs(ROOT, load.load(matrix, ROOT)))
    github.summary(changes.markdown(difference))
    if as_json:
        terminal.echo(changes.as_json(difference), nl=False)
    else:
        tables.print_difference(difference)
