"""A catalogue as a table for people and as JSON for machines."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from rosml import missing
from rosml.errors import RosmlError
from rosml.expand import Catalogue, Image
from rosml.inputs import Inputs
from rosml.problems import listed, unknown

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table


def facts(image: Image) -> dict[str, Any]:
    """An image's resolved facts as plain data. Tags are without the registry, sizes in MB."""
    return {
        "target": image.target,
        "distribution": image.distribution,
        "component": image.component,
        "framework": image.framework,
        "stack": image.stack,
        "os": image.os,
        "python": image.python,
        "ros": image.ros,
        "ros_distro": image.ros_distro,
        "platforms": list(image.platforms),
        "versions": dict(image.versions),
        "repository": image.repository,
        "tags": list(image.tags),
        "groups": list(image.groups),
        "parent": image.parent,
        "packages": image.packages.split(),
        "parts": list(image.parts),
        "locks": list(image.locks),
        "locked": image.locked,
        "tests": list(image.tests),
        "disk": {"unpacked": image.disk.unpacked, "compressed": image.disk.compressed},
    }


def members(catalogue: Catalogue, groups: Sequence[str] = ()) -> tuple[Image, ...]:
    """The images that are in all of some groups, those without a lock among them, in the order of the matrix.

    Raises:
        RosmlError: there is no such group (exit code 2).
    """
    known = {group for image in catalogue.images for group in image.groups}
    for name in groups:
        if name not in known:
            raise RosmlError(unknown("group", name, sorted(known)), f"there is {listed(sorted(known))}", exit_code=2)
    return tuple(image for image in catalogue.images if set(groups) <= set(image.groups))


def as_json(inputs: Inputs, images: Sequence[Image]) -> str:
    """Images with the digests of their inputs by architecture."""
    return json.dumps([{**facts(image), "inputs": inputs.digests(image)} for image in images], indent=2) + "\n"


def console() -> Console:
    """Where tables go: one line for each row, also where nobody watches and the terminal's width is unknown."""
    from rich.console import Console  # slow to import, and only needed here

    class Output(Console):
        def on_broken_pipe(self) -> None:
            """Raises BrokenPipeError, which `command.run` knows: a reader that has seen enough is no failure."""
            raise BrokenPipeError

    terminal = Output(highlight=False, soft_wrap=True)
    return terminal if terminal.is_terminal else Output(highlight=False, width=400)


def show(table: Table) -> None:
    """Prints a table, without the spaces that fill its last column up."""
    out = console()
    with out.capture() as captured:
        out.print(table)
    click.echo(_PADDING.sub(r"\1", captured.get()), nl=False)


_PADDING = re.compile(r" +((?:\x1b\[[0-9;]*m)*)$", re.MULTILINE)
"""Spaces at the end of a line, before codes that end a colour."""


def print_table(images: Sequence[Image]) -> None:
    """Prints images, a row each."""
    from rich.table import Table  # slow to import, and only needed here

    table = Table(box=None, header_style="bold", pad_edge=False)
    for column in ("target", "versions", "platforms", "main tag", ""):
        table.add_column(column, no_wrap=True)
    table.add_column("GB unpacked (forecast)", justify="right", no_wrap=True)
    for image in images:
        versions = ", ".join(f"{name} {version}" for name, version in image.versions.items())
        platforms = ", ".join(image.platforms)
        state = "" if image.locked else "no lock"
        table.add_row(image.target, versions, platforms, image.tags[0], state, f"{image.disk.unpacked / 1000:.1f}")
    show(table)
    out = console()
    payloads = {name for image in images for name in image.parts}
    out.print(f"{len(images)} images, {len(payloads)} payloads", style="dim")
    lost = sum(bool(image.lost) for image in images)
    waiting = sum(not image.locked for image in images) - lost
    for count, remedy in ((lost, missing.RESTORE), (waiting, missing.ASK_PYTORCH)):
        if count:
            out.print(f"{count} without a lock, which cannot be built yet: {remedy}", style="yellow")
