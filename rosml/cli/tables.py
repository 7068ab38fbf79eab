"""Tables for people of images, differences, shards, states and findings."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from rosml.bake.diff import Difference, how_many, rows
from rosml.bake.inputs import Inputs
from rosml.base import terminal
from rosml.base.problems import counted
from rosml.images import missing
from rosml.images.facts import facts
from rosml.images.image_set import Image
from rosml.publish.shards import Dealt
from rosml.scan.judge import Run, Scanned

if TYPE_CHECKING:
    from rich.table import Table
from collections import Counter

from rosml.publish.status import STATES, ImageStatus, age
from rosml.scan.sarif import COLUMNS, finding_rows, summary

COLOURS = {"critical": "bold red", "high": "red", "medium": "yellow"}


def print_difference(difference: Difference) -> None:
    """Prints it in few lines, whatever the number of images."""
    from rich.text import Text  # slow to import, and only needed here

    columns = ("what", "why", "which")
    table = terminal.table(*columns, wrapped=columns)
    table.padding = (0, 2, 0, 0)
    for row in rows(difference):
        table.add_row(*map(Text, row))
    out = terminal.console()
    if difference.registry:
        out.print(f"registry: {' → '.join(difference.registry)}; all names change")
    if table.row_count:
        terminal.show(table)
    counts = [how_many(difference, name) for name in ("added", "removed", "changed")]
    out.print(", ".join([*counts, f"{difference.same} same"]), style="dim")


def images_as_json(inputs: Inputs, images: Sequence[Image]) -> str:
    """Images with the digests of their inputs by architecture."""
    return json.dumps([{**facts(image), "inputs": inputs.digests(image)} for image in images], indent=2) + "\n"


def print_images(images: Sequence[Image]) -> None:
    """Prints images, a row each."""
    size = "GB unpacked (forecast)"
    table = terminal.table("target", "versions", "platforms", "main tag", "lock", size, right=[size])
    for image in images:
        versions = ", ".join(f"{name} {version}" for name, version in image.versions.items())
        platforms = ", ".join(image.platforms)
        state = "" if image.locked else "missing"
        table.add_row(image.target, versions, platforms, image.tags[0], state, f"{image.disk.unpacked / 1000:.1f}")
    terminal.show(table)
    out = terminal.console()
    parts = {name for image in images for name in image.parts}
    out.print(f"{counted(len(images), 'image')}, {counted(len(parts), 'part')}", style="dim")
    lost = sum(bool(image.lost) for image in images)
    waiting = sum(not image.locked for image in images) - lost
    for count, remedy in ((lost, missing.RESTORE), (waiting, missing.ASK_PYTORCH)):
        if count:
            out.print(f"{count} without a lock, which cannot be built yet: {remedy}", style="yellow")


def print_shards(plan: Dealt, left_out: int = 0) -> None:
    """Prints one line for each shard, and what the whole takes. `left_out`: how many images have no lock."""
    numbers = ("images", "parts", "minutes", "GB download", "GB disk")
    table = terminal.table("shard", "runner", "distributions", *numbers, right=numbers)
    for shard in plan.shards:
        sizes = (f"{megabytes / 1000:.1f}" for megabytes in (shard.download_mb, shard.disk_mb))
        counts = (str(len(shard.targets)), str(len(shard.parts)), f"{shard.seconds / 60:.0f}")
        table.add_row(shard.name, shard.runner, ", ".join(shard.distributions), *counts, *sizes)
    terminal.show(table)
    out = terminal.console()
    seconds = [shard.seconds for shard in plan.shards]
    total = f"{max(seconds) / 60:.0f} minutes until all is built, {sum(seconds) / 60:.0f} minutes of machines"
    out.print(f"estimates: {total}", style="dim")
    if left_out:
        out.print(f"left out: {counted(left_out, 'image')} without a lock; see them with: make list", style="yellow")
    if len(plan.shards) < plan.allowed:
        units = "as many as there are distributions on architectures"
        out.print(f"{len(plan.shards)} shards instead of {plan.allowed}: {units}, which are never split", style="dim")


def findings_table(scanned: Scanned) -> Table:
    """An image's findings that stop it or are ignored, the worst first."""
    from rich.text import Text  # slow to import, and only needed here

    made = terminal.table(*COLUMNS)
    for severity, *others in finding_rows([it for it in scanned.findings if it.fails or it.ignored]):
        made.add_row(Text(severity, COLOURS.get(severity, "")), *map(Text, others))
    return made


def print_scan(run: Run) -> None:
    """Prints a run: each image's line and table, what is wrong with the policy's entries, and the run's outcome."""
    said: set[str] = set()
    for image in run.images:
        click.echo(summary(image))
        if any(finding.fails or finding.ignored for finding in image.findings):
            terminal.show(findings_table(image))
        for note in image.notes:
            if note not in said:
                click.echo(f"note: {note}")
        said.update(image.notes)
    for problem in run.problems:
        click.echo(problem)
    states = {(image.database.updated, image.database.digest) for image in run.images if image.database}
    for updated, digest in sorted(states):
        click.echo(f"database of {updated}, {digest}")
    click.echo(f"{counted(len(run.images), 'image')}: {run.outcome.value}")


def print_status(found: list[ImageStatus]) -> None:
    """A line for each image, and how many there are of each state."""
    table = terminal.table("image", "state", "age", "platforms", "why", wrapped=["why"])
    for item in found:
        state = f"[{STATES[item.state]}]{item.state}[/]"
        table.add_row(item.target, state, age(item.age), ", ".join(item.platforms), item.reason)
    terminal.show(table)
    counts = Counter(item.state for item in found)
    text = ", ".join(f"{counts[name]} {name}" for name in STATES if counts[name])
    terminal.console().print(f"{counted(len(found), 'image')}: {text}", style="dim")
