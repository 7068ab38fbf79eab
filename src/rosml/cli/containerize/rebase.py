"""`rosml rebase`: puts apps on other base images in a registry. It needs no Docker, no builder and no sources, and pulls no layer."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.core import ParameterSource

from rosml import IN_CHECKOUT, ROOT, STATE
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import checkout, options
from rosml.cli.checkout import Command
from rosml.cli.command import say

if TYPE_CHECKING:
    from rosml.containerize.rebase.fleet import Outcome
    from rosml.containerize.rebase.rebaser import Plan, Rebased, Rebaser
    from rosml.containerize.rebase.trial import Pair
    from rosml.machine.services import Services

KEPT = "interrupted: the old tag stands; the next call finds again what was pushed"
"""The message after Ctrl-C."""

STATES = {name: name for name in ("moved", "planned", "there", "held", "unaffected", "refused", "failed")}
STATES |= {"planned": "would move"}
"""What became of an app, by the words for people."""


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
def main(
    app: str,
    base: str,
    tag: str,
    platforms: tuple[str, ...],
    apps: Path | None,
    back: str | None,
    variants: str | None,
    fixes: str,
    check: str,
    command: str,
    no_sbom: bool,
    dry_run: bool,
    as_json: bool,
) -> None:
    """Puts APP on another base image, such as tonight's, and moves its tag there.

    APP is a run or slim image of 'rosml containerize' in a registry. The result is the image that a build of the same packages on that
    base image would give. Only a manifest and a config are pushed: nothing is built or pulled. --back DIGEST moves the tag back.

    Before it writes anything, it compares packages, files and libraries of the app and of both base images, and refuses what does not
    fit. If C++ libraries changed in a way that these facts do not decide, the builder links the app in the new image first.

    \b
    Examples:
      rosml rebase ghcr.io/me/robot:latest
      rosml rebase ghcr.io/me/robot:latest --base ghcr.io/us/ros-torch:jazzy-base-cu130 --tag ghcr.io/me/robot:torch
      rosml rebase --all apps.yaml --dry-run
      rosml rebase --all apps.yaml --fixes CVE-2026-12345
    """
    from rosml.containerize.rebase.rebaser import Rebaser
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    context = click.get_current_context()
    for name in ("base", "tag"):
        if not context.params[name] and context.get_parameter_source(name) is ParameterSource.COMMANDLINE:
            raise RosmlError(f"--{name} is an empty word", "name an image, or leave the option out", exit_code=2)
    if bool(command) != (check == "run"):
        raise RosmlError("--check run and --command belong together", "give both, or neither", exit_code=2)
    one = {
        "APP": app,
        "--base": base,
        "--tag": tag,
        "--platform": platforms,
        "--command": command,
        "--back": back is not None,
        "--variants": variants is not None,
        "--check": check != "auto",
    }
    given = [name for name, value in one.items() if value]
    if variants is not None and (base or platforms):
        raise RosmlError("--variants chooses base images and platforms by itself", "leave the other option out", 2)
    if apps and given:
        raise RosmlError(f"--all and {given[0]} exclude each other", "write what holds for an app into the file", 2)
    if back is not None and (other := [name for name in given if name not in ("APP", "--back")]):
        raise RosmlError(f"--back and {other[0]} exclude each other", "leave one of them out", exit_code=2)
    if fixes and not apps:
        raise RosmlError("--fixes looks at the apps of a file", "name it with --all apps.yaml", exit_code=2)
    if not apps and not app:
        raise RosmlError("no app is named", "name one, or a file of them with --all apps.yaml", exit_code=2)
    services = Services.load(ROOT, required=False)
    with Registries(services.ca_bundle) as registries, Rebaser(services, registries, say) as rebaser:
        if apps:
            _fleet(rebaser, apps, fixes, with_sbom=not no_sbom, dry_run=dry_run, as_json=as_json)
            return
        if back is not None:
            found = [rebaser.back(app, back, dry_run)]
        else:
            plans = (
                [rebaser.plan(app, base, tag, platforms)]
                if variants is None
                else _variants(rebaser, app, variants, tag)
            )
            found = [_moved(rebaser, plan, check, command, not no_sbom, dry_run) for plan in plans]
    if as_json:
        documents = [item.to_json() for item in found]
        terminal.echo(json.dumps(documents[0] if variants is None else documents, indent=2))
    elif dry_run and back is not None:
        terminal.echo(f"{found[0].reference} would point at {back}")
    elif not dry_run:
        for item in found:
            _print(item)


def _variants(rebaser: Rebaser, app: str, stacks: str, tag: str) -> list[Plan]:
    from rosml.containerize.names import listed
    from rosml.containerize.rebase import variants

    return variants.plans(rebaser, app, listed(stacks), tag)


def _moved(rebaser: Rebaser, plan: Plan, check: str, command: str, with_sbom: bool, dry_run: bool) -> Rebased:
    """Carries out a plan, or only tells what would come of it."""
    for reason in plan.judgement.undecided:
        say(f"check by link: {reason}")
    if dry_run:
        if plan.there == plan.digest:
            say(f"{plan.target} points at {plan.digest} already; nothing would change")
        else:
            say(f"{plan.judgement.words}; {plan.target} would point at {plan.digest}")
        return plan.result
    links = check in ("link", "run") or (check == "auto" and bool(plan.judgement.undecided))
    links = links and plan.there != plan.digest
    if links:
        _builder()  # before anything is pushed
    found = rebaser.push(plan, with_sbom)
    if links:
        _link(found, rebaser.pairs(plan))
        found.linked = True
        if command:
            _start(found, rebaser.pairs(plan), command)
    rebaser.move(plan, found)
    return found


def _fleet(rebaser: Rebaser, file: Path, fixes: str, with_sbom: bool, dry_run: bool, as_json: bool) -> None:
    """Moves the apps of a file, or only tells what would become of them.

    Raises:
        SystemExit: one was refused or failed (exit code 1).
    """
    from rosml.base.clock import now
    from rosml.containerize.rebase import fleet

    date, entries = now(), fleet.read(file)
    screen = _screen(fixes) if fixes else None
    found = fleet.Fleet(rebaser, date, _link, _start, with_sbom, say, screen).run(entries, dry_run)
    if as_json:
        back = {"undo": fleet.places(found)} if not dry_run else {}
        terminal.echo(json.dumps({"date": date, "apps": [item.to_json() for item in found], **back}, indent=2))
    else:
        _tell(found)
        for place in fleet.places(found):
            terminal.echo(f"back: {checkout.call()} publish undo {date} --registry {place}")
        if dry_run:
            terminal.echo("nothing was changed")
    if any(item.state in ("refused", "failed") for item in found):
        raise SystemExit(1)


def _screen(name: str) -> Callable[[bytes, str], str]:
    """Looks for a vulnerability in SBOMs, by the scanner of `rosml setup scanner` and its database.

    Raises:
        RosmlError: it is no name of one (exit code 2), the scanner is missing, or its database is too old.
    """
    from datetime import UTC, datetime

    from rosml.containerize.rebase.screen import Screen, require_advisory
    from rosml.images.scan import policy
    from rosml.images.scan.trivy import Trivy
    from rosml.machine import trust
    from rosml.machine.services import Services

    require_advisory(name)  # before the database is fetched
    trivy = Trivy.find(ROOT, environment=trust.trusting(Services.load(ROOT, required=False)))
    rules = policy.load(ROOT / "scan.yaml").policy.database
    trivy.fetch(rules, say=say).require_fresh(rules, datetime.now(UTC))
    return Screen(name, trivy.scan)


def _tell(found: Sequence[Outcome]) -> None:
    for item in found:
        what = item.reason.partition("\n")[0]
        if item.rebased and not what:
            digests = f"{_short(item.rebased.before)} -> {_short(item.rebased.digest)}"
            trial = "" if item.rebased.linked or not item.rebased.reasons else f"  {item.rebased.verdict}"
            what = f"{digests}  {item.rebased.base}{trial}"
        terminal.echo(f"{STATES[item.state]:<10} {item.app}  {what}".rstrip())
        for line in item.reason.split("\n")[1:]:
            terminal.echo(f"           {line}")
        if item.remedy:
            terminal.echo(f"           {item.remedy}")
    counts = {words: sum(item.state == state for item in found) for state, words in STATES.items()}
    terminal.echo(", ".join(f"{number} {words}" for words, number in counts.items() if number))


def _short(digest: str) -> str:
    """The beginning of a digest, for people."""
    return digest.partition(":")[2][:12]


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


def _link(found: Rebased, pairs: dict[str, Pair]) -> None:
    from rosml.containerize.rebase.trial import Trial

    Trial(_builder(), found.reference).link(pairs)


def _start(found: Rebased, pairs: dict[str, Pair], command: str) -> None:
    from rosml.containerize.rebase.trial import Trial

    Trial(_builder(), found.reference).run(pairs, command)


def _print(found: Rebased) -> None:
    from rosml.base.units import duration, size

    terminal.echo(f"{found.reference}@{found.digest}")
    if not found.moved:
        terminal.echo("it was there already")
        return
    terminal.echo(f"base    {_in_full(found.base, found.base_digest)}")
    back = f"; back: {checkout.call()} rebase {found.reference} --back {found.back}" if found.back else ""
    terminal.echo(f"before  {_in_full(found.old_base, found.old_base_digest) or 'an unknown base image'}{back}")
    if not found.verdict:  # after --back, which sends no layer
        return
    terminal.echo(f"check   {found.verdict}{', and the linker finds everything' if found.linked else ''}")
    counts = ((found.mounted, "mounted"), (found.present, "there already"), (found.copied, "copied"))
    ways = ", ".join(f"{number} {what}" for number, what in counts if number)
    terminal.echo(f"layers  {found.layers} for {', '.join(found.manifests)}: {ways}")
    terminal.echo(f"sent    {size(found.uploaded)} in {duration(found.seconds)}")


def _in_full(name: str, digest: str) -> str:
    """An image's name with its digest, which it may have already."""
    return name if "@" in name or not name or not digest else f"{name}@{digest}"
