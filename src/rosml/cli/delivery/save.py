"""`rosml save`: an image of a registry in a file, without layers that another machine has. It needs no Docker."""

from __future__ import annotations

import contextlib
import dataclasses
import json
import sys
from pathlib import Path

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import options
from rosml.cli.checkout import Command

KEPT = "interrupted: no file was written"


@click.command(
    "save", short_help="Saves an image in a file, without layers that a robot has.", cls=Command, alone=True, kept=KEPT
)
@click.argument("image")
@click.option("--have", multiple=True, metavar="IMAGE", help="an image that the other machine has; repeatable")
@click.option("-o", "--output", required=True, metavar="FILE", help="the file to write; - for standard output")
@click.option(
    "--platform", default="", metavar="PLATFORM", help="the other machine's, such as linux/arm64 [this one's]"
)
@options.JSON
def main(image: str, have: tuple[str, ...], output: str, platform: str, as_json: bool) -> None:
    """Saves IMAGE of a registry in a file, for a machine without network or with a slow one.

    Layers that an image of --have has stay out: they are not even pulled. 'rosml load' on the other machine takes them from what it
    has. Of a layer that replaces one of theirs, the file gets what differs, if that is much smaller. It is an OCI archive; without --have, 'docker load' and 'podman load' take it as well.

    \b
    Examples:
      rosml save ghcr.io/me/robot:latest --have ghcr.io/us/ros:jazzy-base \\
        --platform linux/arm64 -o robot.tar
      rosml save ghcr.io/me/robot:new --have ghcr.io/me/robot:old -o - | ssh robot rosml load -
    """
    from rosml.base import files, progress_bar
    from rosml.base.errors import RosmlError
    from rosml.base.problems import counted
    from rosml.base.units import duration, size
    from rosml.delivery import pulled_layers, save
    from rosml.images.builds.base_images import native_architecture
    from rosml.images.join.transfer import Transfer
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    pipe = output == "-"
    if pipe and (as_json or sys.stdout.isatty()):
        why = "--json goes to standard output, too" if as_json else "standard output is a terminal"
        raise RosmlError(f"the file cannot go to standard output: {why}", "name a file: -o robot.tar", exit_code=2)
    platform = platform or f"linux/{native_architecture()}"
    services = Services.load(ROOT, required=False)
    with Registries(services.ca_bundle) as registries, Transfer(registries) as transfer:
        name = pulled_layers.complete(image, services, registries)
        source = pulled_layers.for_platform(transfer, name, platform)
        others = [pulled_layers.complete(other, services, registries) for other in have]
        plan = save.plan(source, name, [pulled_layers.for_platform(transfer, other, platform) for other in others])
        with (
            contextlib.nullcontext(sys.stdout.buffer) if pipe else files.whole(Path(output)) as out,
            progress_bar.of_bytes("layers", plan.bytes) as advance,
        ):
            saved = save.write(plan, registries, out, advance)
    if as_json:
        terminal.echo(json.dumps(dataclasses.asdict(saved), indent=2))
        return
    terminal.echo(f"{saved.image.partition('@')[0]}@{saved.digest}", err=pipe)
    terminal.echo(f"{saved.platform}: {counted(saved.layers, 'layer')}, {size(saved.bytes)}", err=pipe)
    if saved.patches:
        instead = f"{size(saved.patch_bytes)} instead of {size(saved.patched_bytes)}"
        terminal.echo(f"differences of {counted(saved.patches, 'layer')}: {instead}", err=pipe)
    if have:
        terminal.echo(f"left out: {counted(saved.left_out, 'layer')}, {size(saved.left_out_bytes)}", err=pipe)
    terminal.echo(f"written in {duration(saved.seconds)}", err=pipe)
