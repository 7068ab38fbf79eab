"""`rosml affected`: which images in registries have a vulnerability or a package, and what fixes them. It reads SBOMs alone."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.base.problems import some
from rosml.cli import command, options
from rosml.cli.checkout import Command
from rosml.cli.command import say

if TYPE_CHECKING:
    from rosml.containerize.affected.inventory import Inventory, Matches
    from rosml.containerize.affected.query import Query
    from rosml.containerize.affected.search import Answer, Hit
    from rosml.containerize.rebase.rebaser import Rebaser
    from rosml.images.scan.trivy import Trivy

AFFECTED, UNKNOWN = 3, 4
"""Exit codes, as of a scan: an image is affected; of some images nothing is known, and no other one is affected."""


@click.command(
    "affected",
    short_help="Says which images have a vulnerability or a package.",
    cls=Command,
    alone=True,
    prints=True,
)
@click.argument("query", metavar="CVE|PACKAGE[<VERSION]")
@click.argument("images", nargs=-1, metavar="[IMAGE]...")
@click.option("--repository", metavar="REPOSITORY", help="all images of a repository, such as ghcr.io/me/robot")
@click.option(
    "--all",
    "apps",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="all apps that a file apps.yaml names, as for rebase",
)
@click.option(
    "--platform", "platforms", multiple=True, metavar="PLATFORM", help="only this one, such as linux/arm64; repeatable"
)
@options.JSON
def main(
    query: str,
    images: tuple[str, ...],
    repository: str | None,
    apps: Path | None,
    platforms: tuple[str, ...],
    as_json: bool,
) -> None:
    """Says which images have an advisory, such as CVE-2026-12345, or a package, such as openssl or 'openssl<3.0.15'.

    It reads the SBOMs that are attached to images in a registry, and pulls no layer. For each image it says which part has the
    package, whether VEX says that it does no harm, and what fixes it: a newer base image with 'rosml rebase', or a build of your app.

    Versions are compared by the rules of the package's kind: deb, pypi or ros. A kind can stand before the name: 'pypi:torch<2.6'.
    For an advisory, it needs the scanner of 'rosml setup scanner'.

    Exits with 3 if an image is affected, and with 4 if none is and some are unknown.

    \b
    Examples:
      rosml affected CVE-2026-12345 --all apps.yaml
      rosml affected 'openssl<3.0.15' ghcr.io/me/robot:latest
      rosml affected 'pypi:torch<2.6' --repository ghcr.io/me/robot --json
    """
    from rosml.containerize.affected import query as asking
    from rosml.containerize.affected.images import Images
    from rosml.containerize.affected.search import Search
    from rosml.containerize.rebase.rebaser import Rebaser
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    question = asking.parse(query)
    services = Services.load(ROOT, required=False)
    with Registries(services.ca_bundle) as registries, Rebaser(services, registries, say) as rebaser:
        names = _names(rebaser, images, repository, apps)
        trivy = _scanner(services) if question.is_advisory else None
        with Images(registries, rebaser.where) as reading:
            judge = _judge(question, reading.inventory, trivy)
            answers = Search(reading, question, judge, str(apps) if apps else "").run(names, platforms)
    database = trivy.database().updated if trivy else ""
    if as_json:
        date = datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%SZ")
        facts = {"query": question.text, "date": date, "database": database, "counts": _counts(answers)}
        terminal.echo(json.dumps({**facts, "images": [answer.to_json() for answer in answers]}, indent=2))
    else:
        _print(answers, database)
    states = {answer.state for answer in answers}
    raise SystemExit(AFFECTED if "affected" in states else UNKNOWN if "unknown" in states else 0)


def _names(rebaser: Rebaser, images: Sequence[str], repository: str | None, apps: Path | None) -> list[str]:
    """The images that a call is about, in full."""
    from rosml.containerize.rebase import fleet

    names = [str(rebaser.where(name)) for name in images]
    if repository:
        place = rebaser.where(f"{repository}:x")
        tags = fleet.moving_tags(rebaser.registries(place.host), place.repository)
        if not tags:
            raise RosmlError(f"{place.host}/{place.repository} has no tags of images", "check its name", exit_code=2)
        names += [str(place._replace(reference=tag)) for tag in tags]
    for entry in fleet.read(apps) if apps else ():
        names += fleet.names_of(entry, rebaser.where, rebaser.registries)
    if not names:
        remedy = "name images, or --repository REPOSITORY, or --all apps.yaml"
        raise RosmlError("no image is named", remedy, exit_code=2)
    if len(unique := [*dict.fromkeys(names)]) > fleet.MANY:
        raise RosmlError(f"{len(unique):,} images, and at most {fleet.MANY:,} are read", "name fewer", exit_code=2)
    return unique


def _scanner(services: Any) -> Trivy:
    from rosml.containerize.rebase import screen

    return screen.scanner(ROOT, services, say)


def _judge(question: Query, inventory: Inventory, trivy: Trivy | None) -> Callable[[int], Matches]:
    if trivy is None:
        return lambda start: inventory.matching(question, start)
    return lambda start: inventory.vulnerable(question.text, trivy, start)


def _print(answers: Sequence[Answer], database: str) -> None:
    for answer in answers:
        name = f"{answer.image} {answer.platform}".rstrip()
        if answer.state == "clear":
            continue
        terminal.echo(f"{answer.state:<9} {terminal.line(name)}")
        lines = [*map(_hit, answer.hits), *([answer.fix] if answer.fix else []), *answer.notes]
        for line in lines:
            terminal.echo(f"          {terminal.line(line)}")
    commands = dict.fromkeys(answer.command for answer in answers if answer.command)
    for line in commands:
        terminal.echo(f"fix: {command.call()} {line}")
    counts = ", ".join(f"{number} {state}" for state, number in _counts(answers).items() if number)
    terminal.echo(counts + (f"; database of {database}" if database else ""))


def _hit(hit: Hit) -> str:
    """Such as `libssl3 3.0.1, fixed in 3.0.15, of core, of the base image; VEX: not affected: …`."""
    where = {"base": "of the base image", "part": "", "app": "of the app", "image": "", "unknown": ""}[hit.origin]
    causes = [it.package + (f" through {it.through}" if it.through else "") for it in hit.needed_by]
    parts = [f"of {hit.part}" if hit.part else "", where, f"needed by {some(causes)}" if causes else ""]
    text = ", ".join(filter(None, (f"{hit.name} {hit.version}", f"fixed in {hit.fixed}" * bool(hit.fixed), *parts)))
    verdict = hit.status.replace("_", " ")
    return text + (f"; VEX: {verdict}" + f": {hit.reason}" * bool(hit.reason) if verdict else "")


def _counts(answers: Sequence[Answer]) -> dict[str, int]:
    states = ("affected", "harmless", "clear", "unknown")
    return {state: sum(answer.state == state for answer in answers) for state in states}
