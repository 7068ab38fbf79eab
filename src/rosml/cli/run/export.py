"""`rosml run --export`: prints what would run as a file, or adds it to one."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from rosml.base import terminal
from rosml.cli import command
from rosml.cli.run import container
from rosml.run.context import Context
from rosml.run.defaults import shown
from rosml.run.exports import compose, compose_file, devcontainer, kubernetes, quadlet
from rosml.run.exports.description import Call, describe, lacking_command, lasting
from rosml.run.plan import Plan


@dataclass(frozen=True)
class Kind:
    """A kind of file."""

    seen: Callable[[Context], Context]  # the context there, such as of a machine on which nobody logs in
    text: Callable[[Call], str]
    settled: Callable[[Context], Context] = lambda context: context  # once we know whether the image may start as root
    service: bool = False  # it starts without a terminal


KINDS = {
    "devcontainer": Kind(lasting, devcontainer.text, devcontainer.bare),
    "compose": Kind(compose.portable, compose.text),
    "quadlet": Kind(quadlet.service, quadlet.text, service=True),
    "kubernetes": Kind(kubernetes.cluster, kubernetes.text, service=True),
}


def write(context: Context, planned: Callable[[Context], Plan], kind: str, add: str | None) -> None:
    """Prints a file, or adds the service to the file of compose `add`. `context` is as `Kind.seen` has it, with the user's trust, and
    `planned` gives the plan of the plugins."""
    form = KINDS[kind]
    context = form.settled(context)
    plan = planned(context)
    for file in plan.files:
        command.warn(f"the export does not make {file}", "rosml run makes it whenever it starts a container")
    place = os.path.dirname(os.path.abspath(add)) if add is not None else ""
    call = describe(context, plan.argv, place)
    if form.service:
        missing = [folder for folder in plan.folders if not context.host.has(folder)]
        for text, remedy in lacking_command(call):
            command.warn(text, remedy)
        for folder in missing:
            text = f"{shown(folder)} is missing here, and podman makes no folder"
            command.warn(text, f"mkdir -p {container.shown([folder])}")
    if add is not None:
        terminal.echo(compose_file.add(Path(add), call), err=True)
        return
    document = form.text(call)
    with container.printing():
        terminal.echo(document, nl=False)
