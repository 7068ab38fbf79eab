"""`rosml explain`: why an image exists, or why it does not."""

from __future__ import annotations

import json
from pathlib import Path

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import completion, options
from rosml.cli.checkout import Command


@click.command(
    "explain",
    cls=Command,
    alone=True,
    prints=True,
    extra="it is one name, such as jazzy-base-torch-cu130; rosml list takes several words",
)
@click.argument("name", type=completion.Name("targets"))
@options.MATRIX
@options.JSON
def main(name: str, matrix: Path, as_json: bool) -> None:
    """Says why an image exists, or why it does not; or what a part is.

    Of an image it says which add-ons it can take as well, and of an add-on what it brings.

    NAME is a target or a tag, with or without the registry. Leave out the date of a dated tag: the matrix has no dates.

    \b
    Examples:
      rosml explain jazzy-robot
      rosml explain ros-torch:jazzy-base-cu128
      rosml explain part:torch-cu128-py311
      rosml explain onnx
    """
    from rosml.images.image_set import load
    from rosml.images.image_set.explain import explained

    found = explained(load.load(matrix, ROOT), name)
    terminal.echo(json.dumps(found.to_json(), indent=2, ensure_ascii=False) if as_json else found.text)
