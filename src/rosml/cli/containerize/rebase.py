"""`rosml rebase`: puts an app on another base image in a registry. It needs no Docker, no builder and no sources, and pulls no layer."""

from __future__ import annotations

import json

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import options
from rosml.cli.checkout import Command
from rosml.cli.command import say

KEPT = "interrupted: the old tag stands; the next call finds again what was pushed"
"""The message after Ctrl-C."""


@click.command(
    "rebase", short_help="Puts an app on another base image, without a build.", cls=Command, alone=True, kept=KEPT
)
@click.argument("app")
@click.option("--base", required=True, metavar="REFERENCE", help="the new base image")
@click.option("--tag", default="", metavar="REFERENCE", help="the tag to move, in full [the app's own]")
@click.option(
    "--platform", "platforms", multiple=True, metavar="PLATFORM", help="only this one, such as linux/arm64; repeatable"
)
@click.option("--dry-run", is_flag=True, help="check only, and change nothing")
@options.JSON
def main(app: str, base: str, tag: str, platforms: tuple[str, ...], dry_run: bool, as_json: bool) -> None:
    """Puts APP on another base image, such as tonight's, and moves its tag there.

    APP is a run or slim image of 'rosml containerize' in a registry. The result is the image that a build of the same packages on that
    base image would give. Only a manifest and a config are pushed: nothing is built or pulled. The same command moves it back.

    \b
    Examples:
      rosml rebase ghcr.io/me/robot:latest --base ghcr.io/us/ros:jazzy-base
      rosml rebase ghcr.io/me/robot:latest --base ghcr.io/us/ros-torch:jazzy-base-cu130 --tag ghcr.io/me/robot:torch
    """
    from rosml.base.units import duration, size
    from rosml.containerize.rebase.rebaser import Rebaser
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    services = Services.load(ROOT, required=False)
    with Registries(services.ca_bundle) as registries, Rebaser(services, registries, say) as rebaser:
        plan = rebaser.plan(app, base, tag, platforms)
        if dry_run:
            say(f"nothing speaks against it; {plan.target} would point at {plan.digest}")
            return
        found = rebaser.carry_out(plan)
    if as_json:
        terminal.echo(json.dumps(found.to_json(), indent=2))
        return
    terminal.echo(f"{found.reference}@{found.digest}")
    if not found.moved:
        terminal.echo("it was there already")
        return
    terminal.echo(f"base    {found.base}@{found.base_digest}")
    terminal.echo(f"before  {found.old_base}@{found.old_base_digest}")
    counts = ((found.mounted, "mounted"), (found.present, "there already"), (found.copied, "copied"))
    ways = ", ".join(f"{number} {what}" for number, what in counts if number)
    terminal.echo(f"{', '.join(found.manifests)}: {found.layers} layers ({ways})")
    terminal.echo(f"{size(found.uploaded)} uploaded in {duration(found.seconds)}")
