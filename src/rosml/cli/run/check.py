"""`rosml run --check`: shows what keeps ROS nodes of a container apart from others, and starts no command."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict

import click

from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli.run.container import printing
from rosml.run import check, engine
from rosml.run.context import Context
from rosml.run.plugins import places

COLOURS = {check.GOOD: "green", check.ADVICE: "yellow", check.PROBLEM: "red"}

RMWS = "/opt/ros/{}/share/ament_index/resource_index/rmw_typesupport"
"""The folder of an image with a file for each RMW implementation."""


def show(context: Context, argv: Sequence[str], *, into: bool) -> None:
    """Prints the findings about the container that a command of the engine would start.

    Args:
        into: whether we may start a container of the image that lists a folder.

    Raises:
        RosmlError: the image has no ROS, or the engine does not answer.
        click.exceptions.Exit: something will not work.
    """
    place = places.planned(context, argv)
    if not place.version:
        text = f"--check is about ROS, and {context.line.image} has none: ROS_DISTRO is not in its environment"
        raise RosmlError(text, "an image with ROS; -e ROS_DISTRO=jazzy says what another one has", exit_code=2)
    command, rootless = context.engine.program, context.engine.rootless
    running = [places.running(found, rootless) for found in engine.running(command)]
    others = [found for found in running if found.version]
    distribution = place.environment.get("ROS_DISTRO", "")
    looked = into and place.version == "2"
    installed = engine.folder(command, context.line.image, RMWS.format(distribution)) if looked else []
    found = check.findings(context, place, others, [name for name in installed if name != "rmw_implementation"])
    with printing():
        if context.line.asks("json"):
            terminal.echo(json.dumps([asdict(it) for it in found], indent=2))
        else:
            print_findings(found)
    if any(it.state == check.PROBLEM for it in found):
        raise click.exceptions.Exit(1)


def print_findings(found: Sequence[check.Finding]) -> None:
    """Prints a line for each finding, with its remedy below."""
    width = max(len(it.what) for it in found)
    for it in found:
        state = click.style(f"{it.state:8}", fg=COLOURS[it.state])
        terminal.echo(f"{state} {it.what:{width}}  {it.found}")
        if it.remedy:
            terminal.echo(f"{'':{9 + width}}  {click.style('remedy:', bold=True)} {it.remedy}")
