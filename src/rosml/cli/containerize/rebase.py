"""`rosml rebase`: puts apps on other base images in a registry. It needs no Docker, no builder and no sources, and pulls no layer."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from rosml import IN_CHECKOUT, ROOT, STATE
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command, options
from rosml.cli.checkout import Command
from rosml.cli.command import say

if TYPE_CHECKING:
    from rosml.containerize.rebase.fleet import Outcome
    from rosml.containerize.rebase.plan import Plan, Rebased
    from rosml.containerize.rebase.rebaser import Rebaser
    from rosml.containerize.rebase.screen import Screen
    from rosml.containerize.rebase.trial import Pair
    from rosml.machine.services import Services

STATES = ("moved", "planned", "there", "held", "unaffected", "refused", "failed")

KEPT = "interrupted: the old tag stands; the next call finds again what was pushed"


@dataclass(frozen=True)
class Call:
    app: str
    base: str
    tag: str
    platforms: tuple[str, ...]
    apps: Path | None
    back: str | None
    variants: str | None
    fixes: str
    check: str
    command: str
    no_sbom: bool
    dry_run: bool
    as_json: bool


@click.command(
    "rebase", short_help="Puts an app on another base image, without a build.", cls=Command, alone=True, kept=KEPT
)
@click.argument("app", required=False, default="")
@click.option(
    "--base", default="", metavar="REFERENCE", help="the new base image [the app's own, where its tag is now]"
)
@click.option("--tag", default="", metavar="REFERENCE", help="the tag to move, in full [the app's own]")
@click.option(
    "--platform", "platforms", multiple=True, metavar="PLATFORM", help="only this one, such as linux/arm64; repeatable"
)
@click.option(
    "--all",
    "apps",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="all apps that a file apps.yaml names, instead of APP",
)
@click.option("--back", metavar="DIGEST", help="move APP's tag back to this earlier image of it")
@click.option("--variants", metavar="STACKS", help="an image for each of these, such as cpu,cu130: TAG-cpu, TAG-cu130")
@click.option(
    "--fixes", default="", metavar="CVE", help="with --all: only apps that have it, if their new base image has not"
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
def main(**values: Any) -> None:
    """Puts APP on another base image, such as tonight's, and moves its tag there.

    APP is a run or slim image of 'rosml containerize' in a registry. The result is the image that a build of the same packages on that
    base image would give. Only a manifest and a config are pushed: nothing is built or pulled. --back DIGEST moves the tag back.

    Before it writes anything, it compares packages, files and libraries of the app and of both base images, and refuses what does not
    fit. If C++ libraries changed in a way that these facts do not decide, the builder links the app in the new image first.

    \b
    Examples:
      rosml rebase ghcr.io/me/robot:latest
      rosml rebase ghcr.io/me/robot:latest --base ghcr.io/us/ros-torch:jazzy-base-cu130 \\
        --tag ghcr.io/me/robot:torch
      rosml rebase --all apps.yaml --dry-run
      rosml rebase --all apps.yaml --fixes CVE-2026-12345
    """
    call = Call(**values)
    _require_sense(call)
    from rosml.containerize.rebase.rebaser import Rebaser
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    services = Services.load(ROOT, required=False)
    with Registries(services.ca_bundle) as registries, Rebaser(services, registries, say) as rebaser:
        if call.apps:
            _move_fleet(rebaser, call.apps, call)
        elif call.back is not None:
            _move_back(rebaser, call.back, call)
        else:
            _move_app(rebaser, call)


def _require_sense(call: Call) -> None:
    context = click.get_current_context()
    for name in ("base", "tag"):
        if not getattr(call, name) and context.get_parameter_source(name) is ParameterSource.COMMANDLINE:
            raise RosmlError(f"--{name} is an empty word", "name an image, or leave the option out", exit_code=2)
    if bool(call.command) != (call.check == "run"):
        raise RosmlError("--check run and --command belong together", "give both, or neither", exit_code=2)
    for_one_app = {
        "APP": call.app,
        "--base": call.base,
        "--tag": call.tag,
        "--platform": call.platforms,
        "--command": call.command,
        "--back": call.back is not None,
        "--variants": call.variants is not None,
        "--check": call.check != "auto",
    }
    present = [name for name, value in for_one_app.items() if value]
    if call.variants is not None and (call.base or call.platforms):
        raise RosmlError("--variants chooses base images and platforms by itself", "leave the other option out", 2)
    if call.apps and present:
        raise RosmlError(f"--all and {present[0]} exclude each other", "write what holds for an app into the file", 2)
    if call.back is not None and (others := [name for name in present if name not in ("APP", "--back")]):
        raise RosmlError(f"--back and {others[0]} exclude each other", "leave one of them out", exit_code=2)
    if call.fixes and not call.apps:
        raise RosmlError("--fixes looks at the apps of a file", "name it with --all apps.yaml", exit_code=2)
    if not call.apps and not call.app:
        raise RosmlError("no app is named", "name one, or a file of them with --all apps.yaml", exit_code=2)


# ---- One app ---------------------------------------------------------------------------------------------------------


def _move_back(rebaser: Rebaser, digest: str, call: Call) -> None:
    rebased = rebaser.back(call.app, digest, call.dry_run)
    if call.as_json:
        _print_json(rebased.to_json())
    elif call.dry_run:
        terminal.echo(f"{rebased.reference} would point at {digest}")
    else:
        _print(rebased)


def _move_app(rebaser: Rebaser, call: Call) -> None:
    from rosml.containerize.names import listed
    from rosml.containerize.rebase import variants

    if call.variants is None:
        plans = [rebaser.plan(call.app, call.base, call.tag, call.platforms)]
    else:
        plans = variants.plans(rebaser, call.app, listed(call.variants), call.tag)
    moved = [_foreseen(plan) if call.dry_run else _carry_out(rebaser, plan, call) for plan in plans]
    if call.as_json:
        documents = [rebased.to_json() for rebased in moved]
        _print_json(documents[0] if call.variants is None else documents)
    elif not call.dry_run:
        for rebased in moved:
            _print(rebased)


def _foreseen(plan: Plan) -> Rebased:
    _tell_undecided(plan)
    if plan.changes_nothing:
        say(f"{plan.target} points at {plan.digest} already; nothing would change")
    else:
        say(f"{plan.judgement.words}; {plan.target} would point at {plan.digest}")
    return plan.rebased


def _carry_out(rebaser: Rebaser, plan: Plan, call: Call) -> Rebased:
    _tell_undecided(plan)
    links = plan.needs_link(call.check) and not plan.changes_nothing
    if links:
        _builder()  # before anything is pushed
    rebased = rebaser.push(plan, not call.no_sbom)
    if links:
        _try(rebased, plan.pairs, call.command)
        rebased = replace(rebased, linked=True)
    return rebaser.move(plan, rebased)


def _tell_undecided(plan: Plan) -> None:
    for reason in plan.judgement.undecided:
        say(f"check by link: {reason}")


def _print(rebased: Rebased) -> None:
    from rosml.base.units import duration, size

    terminal.echo(f"{rebased.reference}@{rebased.digest}")
    if not rebased.moved:
        terminal.echo("it was there already")
        return
    terminal.echo(f"base    {_in_full(rebased.base, rebased.base_digest)}")
    back = f"; back: {command.call()} rebase {rebased.reference} --back {rebased.back}" if rebased.back else ""
    terminal.echo(f"before  {_in_full(rebased.old_base, rebased.old_base_digest) or 'an unknown base image'}{back}")
    if not rebased.verdict:  # after --back, which sends no layer
        return
    terminal.echo(f"check   {rebased.verdict}{', and the linker finds everything' if rebased.linked else ''}")
    counts = ((rebased.mounted, "mounted"), (rebased.present, "there already"), (rebased.copied, "copied"))
    ways = ", ".join(f"{number} {what}" for number, what in counts if number)
    terminal.echo(f"layers  {rebased.layers} for {', '.join(rebased.manifests)}: {ways}")
    terminal.echo(f"sent    {size(rebased.uploaded)} in {duration(rebased.seconds)}")


def _in_full(name: str, digest: str) -> str:
    return name if "@" in name or not name or not digest else f"{name}@{digest}"


def _print_json(document: Any) -> None:
    terminal.echo(json.dumps(document, indent=2))


# ---- Many apps -------------------------------------------------------------------------------------------------------


def _move_fleet(rebaser: Rebaser, file: Path, call: Call) -> None:
    from rosml.base.clock import now
    from rosml.containerize.rebase import fleet

    date, entries = now(), fleet.read(file)
    screen = _screen(call.fixes, rebaser.services) if call.fixes else None
    run = fleet.Fleet(rebaser, date, _try, not call.no_sbom, say, screen)
    outcomes = run.run(entries, call.dry_run)
    places = fleet.places(outcomes)
    if call.as_json:
        undo = {} if call.dry_run else {"undo": places}
        _print_json({"date": date, "apps": [outcome.to_json() for outcome in outcomes], **undo})
    else:
        _print_outcomes(outcomes)
        for place in places:
            terminal.echo(f"back: {command.call()} publish undo {date} --registry {place}")
        if call.dry_run:
            terminal.echo("nothing was changed")
    if any(outcome.state in ("refused", "failed") for outcome in outcomes):
        raise SystemExit(1)


def _screen(name: str, services: Services) -> Screen:
    from rosml.containerize.rebase import screen

    screen.require_advisory(name)  # before the database is fetched
    return screen.Screen(name, screen.scanner(ROOT, services, say).scan)


def _print_outcomes(outcomes: Sequence[Outcome]) -> None:
    for outcome in outcomes:
        text, *lines = (outcome.reason or _summary(outcome.rebased)).split("\n")
        terminal.echo(f"{_words(outcome.state):<10} {outcome.app}  {text}".rstrip())
        for line in (*lines, *([outcome.remedy] if outcome.remedy else [])):
            terminal.echo(f"           {line}")
    counts = {state: sum(outcome.state == state for outcome in outcomes) for state in STATES}
    terminal.echo(", ".join(f"{number} {_words(state)}" for state, number in counts.items() if number))


def _words(state: str) -> str:
    return "would move" if state == "planned" else state


def _summary(rebased: Rebased | None) -> str:
    if not rebased:
        return ""
    before, after = (digest.partition(":")[2][:12] for digest in (rebased.before, rebased.digest))
    verdict = "" if rebased.linked or not rebased.reasons else f"  {rebased.verdict}"
    return f"{before} -> {after}  {rebased.base}{verdict}"


# ---- The builder -----------------------------------------------------------------------------------------------------


def _builder() -> Services:
    from rosml.machine.services import Services

    try:
        services = Services.load(ROOT) if IN_CHECKOUT else Services.of_docker(STATE)
        services.require_builder()
    except RosmlError as error:
        remedy = f"{error.remedy}; or --check metadata, to move it without"
        raise RosmlError(f"the app has to be linked in the new image, and {error.message}", remedy) from None
    return services


def _try(rebased: Rebased, pairs: dict[str, Pair], command: str) -> None:
    """Links an app in its new image, and starts a command in it, unless that is empty."""
    from rosml.containerize.rebase.trial import Trial

    trial = Trial(_builder(), rebased.reference)
    trial.link(pairs)
    if command:
        trial.run(pairs, command)
