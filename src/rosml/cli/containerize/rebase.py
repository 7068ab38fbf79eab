"""`rosml rebase`: puts an app on another base image in a registry. It needs no Docker, no builder and no sources, and pulls no layer."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import click

from rosml import IN_CHECKOUT, ROOT, STATE
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import options
from rosml.cli.checkout import Command
from rosml.cli.command import say

if TYPE_CHECKING:
    from rosml.containerize.rebase.rebaser import Rebased
    from rosml.machine.services import Services

KEPT = "interrupted: the old tag stands; the next call finds again what was pushed"
"""The message after Ctrl-C."""


@click.command(
    "rebase", short_help="Puts an app on another base image, without a build.", cls=Command, alone=True, kept=KEPT
)
@click.argument("app")
@click.option(
    "--base", default="", metavar="REFERENCE", help="the new base image [the app's own, where its tag is now]"
)
@click.option("--tag", default="", metavar="REFERENCE", help="the tag to move, in full [the app's own]")
@click.option(
    "--platform", "platforms", multiple=True, metavar="PLATFORM", help="only this one, such as linux/arm64; repeatable"
)
@click.option(
    "--check",
    type=click.Choice(["auto", "metadata", "link", "run"]),
    default="auto",
    help="auto: link in the builder if the facts do not decide; metadata: never; run: start --command as well [auto]",
)
@click.option("--command", default="", help="for --check run: what has to end with exit code 0 in the new image")
@click.option("--no-sbom", is_flag=True, help="attach no SBOM to the new image")
@click.option("--dry-run", is_flag=True, help="say what speaks against it, and change nothing")
@options.JSON
def main(
    app: str,
    base: str,
    tag: str,
    platforms: tuple[str, ...],
    check: str,
    command: str,
    no_sbom: bool,
    dry_run: bool,
    as_json: bool,
) -> None:
    """Puts APP on another base image, such as tonight's, and moves its tag there.

    APP is a run or slim image of 'rosml containerize' in a registry. The result is the image that a build of the same packages on that
    base image would give. Only a manifest and a config are pushed: nothing is built or pulled. The same command moves it back.

    Before it writes anything, it compares packages, files and libraries of the app and of both base images, and refuses what does not
    fit. If C++ libraries changed in a way that these facts do not decide, the builder links the app in the new image first.

    \b
    Examples:
      rosml rebase ghcr.io/me/robot:latest
      rosml rebase ghcr.io/me/robot:latest --base ghcr.io/us/ros-torch:jazzy-base-cu130 --tag ghcr.io/me/robot:torch
    """
    from rosml.containerize.rebase import checks
    from rosml.containerize.rebase.rebaser import Rebaser
    from rosml.containerize.rebase.trial import Trial
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    if bool(command) != (check == "run"):
        raise RosmlError("--check run and --command belong together", "give both, or neither", exit_code=2)
    services = Services.load(ROOT, required=False)
    with Registries(services.ca_bundle) as registries, Rebaser(services, registries, say) as rebaser:
        plan = rebaser.plan(app, base, tag, platforms)
        for reason in plan.judgement.of(checks.Verdict.LINK):
            say(f"check by link: {reason}")
        if dry_run:
            say(f"{checks.WORDS[plan.judgement.verdict]}; {plan.target} would point at {plan.digest}")
            return
        links = check in ("link", "run") or (check == "auto" and plan.judgement.verdict is checks.Verdict.LINK)
        if links:
            services = _builder()
        found = rebaser.push(plan, with_sbom=not no_sbom)
        if links:
            trial = Trial(services, found.reference)
            trial.link(rebaser.pairs(plan))
            found.linked = True
            if command:
                trial.run(rebaser.pairs(plan), command)
        rebaser.move(plan, found)
    if as_json:
        terminal.echo(json.dumps(found.to_json(), indent=2))
        return
    _print(found)


def _builder() -> Services:
    """The builder for a trial.

    Raises:
        RosmlError: there is none.
    """
    from rosml.machine.services import Services

    try:
        services = Services.load(ROOT) if IN_CHECKOUT else Services.of_docker(STATE)
        services.require_builder()
    except RosmlError as error:
        remedy = f"{error.remedy}; or --check metadata, to move it without"
        raise RosmlError(f"the app has to be linked in the new image, and {error.message}", remedy) from None
    return services


def _print(found: Rebased) -> None:
    from rosml.base.units import duration, size

    terminal.echo(f"{found.reference}@{found.digest}")
    if not found.moved:
        terminal.echo("it was there already")
        return
    terminal.echo(f"base    {found.base}@{found.base_digest}")
    terminal.echo(f"before  {found.old_base}@{found.old_base_digest}")
    terminal.echo(f"check   {found.verdict}{', and the linker finds everything' if found.linked else ''}")
    counts = ((found.mounted, "mounted"), (found.present, "there already"), (found.copied, "copied"))
    ways = ", ".join(f"{number} {what}" for number, what in counts if number)
    terminal.echo(f"layers  {found.layers} for {', '.join(found.manifests)}: {ways}")
    terminal.echo(f"sent    {size(found.uploaded)} in {duration(found.seconds)}")
