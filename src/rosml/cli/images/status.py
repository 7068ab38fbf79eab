"""`rosml status`: the state of a matrix's images in a registry."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from rosml.base import files, github, terminal
from rosml.cli.checkout import Command
from rosml.cli.images.call import Call, sharing


@click.command(
    "status",
    short_help="Shows which images are published, and why others are not.",
    cls=Command,
    alone=True,
    prints=True,
)
@sharing("registry", "matrix", "only", "architecture", "serve", "policy", "json")
@click.option(
    "--markdown", type=click.Path(path_type=Path, dir_okay=False), help="also write a summary into this file, by cause"
)
def main(markdown: Path | None, **options: Any) -> None:
    """Shows the state of every image, and why: published, outdated, failed, missing, lock missing, waiting
    for a builder, or ended.

    Below the table, it counts for each cause the images that this cause keeps from being published. In CI, the summary
    of the job has the same. It also shows the vulnerabilities of each image's last scan, and entries of scan.yaml that end within
    thirty days.

    With --registry, the command needs no service of this machine. It asks that registry, and the package repositories
    for their dates.

    \b
    Examples:
      rosml status --only 'ros1-bookworm-*'
      rosml status --registry ghcr.io/me/rosml --json
    """
    from rosml.base.clock import day_of, now
    from rosml.cli.images import tables
    from rosml.images.publish import status
    from rosml.images.scan import policy

    call = Call(**options)
    state = call.survey(reading=True)
    date = now()
    statuses, ending = list(status.read(state, date)), policy.ending(call.policy, day_of(date))
    causes = status.causes(statuses, state.image_set.matrix.architectures)
    ahead = status.ahead(state)
    text = tables.status_markdown(str(state.place), statuses, causes, ahead, ending)
    if markdown:
        files.write(markdown, text)
    github.summary(text)
    github.output("open", str(sum(image.state in status.OPEN for image in statuses)))
    if call.as_json:
        terminal.echo(status.as_json(statuses, ending))
    else:
        tables.print_status(statuses, causes, ahead, ending, date)
