"""`rosml explain`: why an image exists, or why it does not."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.cli import command, completion, options
from rosml.cli.checkout import Command

if TYPE_CHECKING:
    from rosml.images.image_set.explain import Explained
    from rosml.images.image_set.model import ImageSet


@click.command(
    "explain",
    cls=Command,
    alone=True,
    prints=True,
    extra="it is one name, such as jazzy-base-torch-cu130; rosml list takes several words",
)
@click.argument("name", type=completion.Name("targets"))
@click.option("--addons", default="", metavar="NAMES", help="say whether the image can have these, such as onnx,devel")
@options.MATRIX
@options.JSON
def main(name: str, addons: str, matrix: Path, as_json: bool) -> None:
    """Says why an image exists or not, or what a part or add-on is.

    Of an image it says which add-ons it can take as well, and of an add-on what it brings.

    NAME is a target or a tag, with or without the registry. Leave out the date of a dated tag: the matrix has no dates. With --addons, it
    can be any image in a registry, such as one of your own.

    \b
    Examples:
      rosml explain jazzy-robot
      rosml explain ros-torch:jazzy-base-cu128
      rosml explain part:torch-cu128-py311
      rosml explain onnx
      rosml explain onnx-cu130
      rosml explain ghcr.io/me/robot:1.2 --addons onnx
    """
    from rosml.images.image_set import load
    from rosml.images.image_set.explain import explained

    if addons:
        explanation = _with_addons(load.load(matrix, ROOT), name, addons)
    else:
        explanation = explained(load.load_one(matrix, name, ROOT), name)
    if as_json:
        terminal.echo(json.dumps(explanation.to_json(), indent=2, ensure_ascii=False))
    else:
        terminal.echo(command.as_called(explanation.text))


def _with_addons(image_set: ImageSet, name: str, text: str) -> Explained:
    """Whether an image can have add-ons: by its labels and the parts beside it if it is in a registry, or else by the matrix."""
    from rosml.containerize.base_image import addons
    from rosml.containerize.base_image import base as app_base
    from rosml.images.image_set import explain
    from rosml.images.image_set.explain import Explained
    from rosml.machine.services import Services
    from rosml.registry import references

    addon_names = addons.names_in(text)
    published_image = image_set.by_tag(name) or image_set.by_target.get(name)
    if published_image and not references.has_registry(name):
        return explain.with_addons(image_set.matrix, published_image, name, addon_names)
    services = Services.load(ROOT, required=False)
    try:
        base = app_base.find(name, services, ())
    except RosmlError:
        if published_image:
            return explain.with_addons(image_set.matrix, published_image, name, addon_names)
        raise
    try:
        choices = addons.onto(base, text, services, ())
    except RosmlError as error:
        if error.exit_code != 2:
            raise
        return Explained(name, False, (f"{error.message}; {error.remedy}",))
    if not choices.addons:
        return Explained(name, True, (f"{name} has {listed(addon_names)} already",))
    parts = [part.rpartition(":")[2] for part in choices.addons.parts]
    lines = explain.added(choices.name, addon_names, parts, addons.repository(choices))
    return Explained(name, True, tuple(lines), explain.can_have(name, addon_names))
