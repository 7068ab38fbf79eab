"""`rosml load`: gives an image of `rosml save` to docker or podman, with the layers that this machine has already."""

from __future__ import annotations

import dataclasses
import json
import os

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import options
from rosml.cli.checkout import Command
from rosml.cli.command import say, warn

KEPT = "interrupted: nothing was loaded"


@click.command(
    "load", short_help="Loads an image that rosml save wrote for this machine.", cls=Command, alone=True, kept=KEPT
)
@click.argument("file")
@click.option(
    "--from", "origins", multiple=True, metavar="WHERE", help="who has missing layers: a file, or an image; repeatable"
)
@click.option("--into", default="", metavar="FILE", help="write the whole archive, and load nothing")
@options.JSON
def main(file: str, origins: tuple[str, ...], into: str, as_json: bool) -> None:
    """Loads the image of FILE, which 'rosml save' wrote. '-' is standard input.

    Layers that are not in FILE come from images of docker or podman here, or from where --from says: another archive, an image here, or
    an image in a registry. All are checked by their digests. Nothing is loaded if one is missing or damaged.

    \b
    Examples:
      rosml load robot.tar
      rosml load robot.tar --from 127.0.0.1:5000/ros:jazzy-base --into whole.tar
    """
    from rosml.base.problems import counted
    from rosml.base.units import size
    from rosml.delivery.load import Loader
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    services = Services.load(ROOT, required=False)
    with Registries(services.ca_bundle) as registries:
        loaded = Loader(services, registries, os.environ, say, warn).load(file, origins, into)
    if as_json:
        terminal.echo(json.dumps(dataclasses.asdict(loaded), indent=2))
        return
    terminal.echo(f"{loaded.image}@{loaded.digest}" if loaded.image else loaded.id)
    terminal.echo(f"{counted(loaded.layers, 'layer')} of the file, {size(loaded.bytes)}")
    if loaded.patches:
        terminal.echo(f"differences of {counted(loaded.patches, 'layer')}, {size(loaded.patch_bytes)}")
    if loaded.taken or origins:
        terminal.echo(f"{counted(loaded.taken, 'layer')} of {', '.join(origins) or 'images here'}")
    if loaded.held:
        terminal.echo(f"{counted(loaded.held, 'layer')} here already")
    if into:
        other = (
            "" if loaded.written == loaded.digest else f" as {loaded.written}: some of its layers are not compressed"
        )
        terminal.echo(f"written into {into}{other}")
