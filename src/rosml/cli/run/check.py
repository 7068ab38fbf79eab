"""`rosml run --check`: shows what keeps ROS nodes of a container apart from others, and starts no command."""

from __future__ import annotations

import json
from collections.abc import Sequence

import click

from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli.run.container import printing
from rosml.run import check, engine
from rosml.run.context import Context
from rosml.run.plugins import places

COLOURS = {check.GOOD: "green", check.ADVICE: "yellow", check.PROBLEM: "red"}

RMW_FOLDER = "/opt/ros/{}/share/ament_index/resource_index/rmw_typesupport"


def show(context: Context, argv: Sequence[str], *, into: bool) -> None:
    """Prints the findings about the container that a command of the engine would start. Exits with 1 if something will not work. `into`:
    whether we may start a container of the image that lists a folder."""
    place = places.planned(context, argv)
    if not place.version:
        text = f"--check is about ROS, and {context.line.image} has none: ROS_DISTRO is not in its environment"
        raise RosmlError(text, "an image with ROS; -e ROS_DISTRO=jazzy says what another one has", exit_code=2)
    command, rootless = context.engine.program, context.engine.rootless
    running = [places.running(container, rootless) for container in engine.running(command)]
    others = [place for place in running if place.version]
    distribution = place.environment.get("ROS_DISTRO", "")
    lists = into and place.version == "2"
    installed = engine.folder(command, context.line.image, RMW_FOLDER.format(distribution)) if lists else []
    findings = check.findings(context, place, others, [name for name in installed if name != "rmw_implementation"])
    with printing():
        if context.line.asks("json"):
            rows = [{"what": x.subject, "state": x.state, "found": x.fact, "remedy": x.remedy} for x in findings]
            terminal.echo(json.dumps(rows, indent=2))
        else:
            print_findings(findings)
    if any(finding.state == check.PROBLEM for finding in findings):
        raise click.exceptions.Exit(1)


def print_findings(findings: Sequence[check.Finding]) -> None:
    """Prints a line for each finding, with its remedy below."""
    width = max(len(finding.subject) for finding in findings)
    for finding in findings:
        state = click.style(f"{finding.state:8}", fg=COLOURS[finding.state])
        terminal.echo(f"{state} {finding.subject:{width}}  {finding.fact}")
        if finding.remedy:
            terminal.echo(f"{'':{9 + width}}  {click.style('remedy:', bold=True)} {finding.remedy}")
