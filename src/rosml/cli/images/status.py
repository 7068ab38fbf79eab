"""`rosml status`: how the images of a matrix stand in a registry."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from rosml.base import ci, files, terminal
from rosml.cli.checkout import Command
from rosml.cli.images.call import Call, sharing


@click.command(
    "status",
    short_help="Shows which images are published, and why others are not.",
    cls=Command,
    alone=True,
    prints=True,
)
@sharing("registry", "matrix", "only", "architecture", "serve", "json")
@click.option(
    "--markdown", type=click.Path(path_type=Path, dir_okay=False), help="also write a summary there, grouped by cause"
)
def main(markdown: Path | None, **options: Any) -> None:
    """Shows how every image stands: published, outdated, failed, missing, lock missing, or waiting
    for a builder; and why.

    Below the table it says once for each cause how many images it keeps from being published. In CI, that is also the summary of
    the job.

    With --registry, it needs no service of this machine: it asks that registry, and for images of a live repository of
    packages, that repository for its date.

    \b
    Examples:
      rosml status --only 'ros1-bookworm-*'
      rosml status --registry ghcr.io/me/rosml --json
    """
    from rosml.base.clock import now
    from rosml.cli.images import tables
    from rosml.images.publish import status as states

    call = Call(**options)
    pipeline = call.pipeline(reading=True)
    found = list(states.read(pipeline.plan, pipeline.registry, pipeline.prefix, now(), pipeline.serving))
    plan = pipeline.plan
    causes = states.causes(found, plan.image_set.matrix.architectures)
    ahead = states.ahead(plan, pipeline.serving)
    text = tables.status_markdown(f"{pipeline.host}/{pipeline.prefix}", found, causes, ahead)
    if markdown:
        files.write(markdown, text)
    ci.summary(text)
    ci.output("open", str(sum(item.state in states.OPEN for item in found)))
    if call.as_json:
        terminal.echo(states.as_json(found))
    else:
        tables.print_status(found, causes, ahead)
