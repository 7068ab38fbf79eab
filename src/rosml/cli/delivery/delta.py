"""`rosml delta`: what a machine with one image pulls for another one. It reads manifests alone."""

from __future__ import annotations

import dataclasses
import json

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import options
from rosml.cli.checkout import Command


@click.command("delta", short_help="Says what a robot with A pulls for B.", cls=Command, alone=True, prints=True)
@click.argument("one", metavar="A")
@click.argument("other", metavar="B")
@click.option(
    "--platform", "platforms", multiple=True, metavar="PLATFORM", help="only this one, such as linux/arm64; repeatable"
)
@options.JSON
def main(one: str, other: str, platforms: tuple[str, ...], as_json: bool) -> None:
    """Says what a machine that has image A pulls for image B: layers and bytes, for each platform of B.

    \b
    Example:
      rosml delta ghcr.io/me/robot:monday ghcr.io/me/robot:tuesday
    """
    from rosml.base.errors import RosmlError
    from rosml.base.problems import counted, listed
    from rosml.base.units import size
    from rosml.delivery import pulled_layers
    from rosml.images.join.transfer import Transfer
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    services = Services.load(ROOT, required=False)
    with Registries(services.ca_bundle) as registries, Transfer(registries) as transfer:
        names = [pulled_layers.complete(name, services, registries) for name in (one, other)]
        before, after = (transfer.platforms(name) for name in names)
        if missing := [name for name in platforms if name not in after]:
            text = f"{names[1]} is for {listed(sorted(after)) or 'no platform'}, not for {listed(missing)}"
            raise RosmlError(text, "name a platform that it has", exit_code=2)
        chosen = sorted(set(platforms or after))
        deltas = [pulled_layers.delta(after[name], before.get(name)) for name in chosen]
    if as_json:
        content = {"before": names[0], "after": names[1], "platforms": [dataclasses.asdict(item) for item in deltas]}
        terminal.echo(json.dumps(content, indent=2))
        return
    for item in deltas:
        pulled = f"{counted(item.pulled, 'layer')}, {size(item.pulled_bytes)}"
        kept = f"keeps {counted(item.kept, 'layer')}, {size(item.kept_bytes)}"
        if item.replaced:
            kept += (
                f"; of {counted(item.replaced, 'layer')}, {size(item.replaced_bytes)}, rosml save looks for differences"
            )
        note = "" if item.before else f" ({one} is not for this platform)"
        terminal.echo(f"{item.platform}: pulls {pulled}; {kept}{note}")
