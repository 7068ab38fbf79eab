"""`rosml plan`: what a publishing run will do."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from rosml.base import terminal
from rosml.cli.checkout import Command
from rosml.cli.command import say
from rosml.cli.images.call import Call, sharing


@click.command("plan", short_help="Says what a publishing run will do, and why.", cls=Command)
@sharing("registry", "matrix", "only", "architecture", "serve", "force", "date", "json")
@click.option(
    "--everywhere",
    is_flag=True,
    help="plan for all architectures that the registry serves, each on its own machines, and deal the images to machines",
)
@click.option(
    "--shards",
    type=click.IntRange(min=1),
    default=8,
    show_default=True,
    help="deal builds to at most this many machines, or to more if their disks are too small (runner_disk in matrix.yaml)",
)
@click.option("--why", is_flag=True, help="name the inputs that changed")
@click.option(
    "--output",
    type=click.Path(path_type=Path, dir_okay=False),
    help="write the plan into this file, for the other steps",
)
def main(everywhere: bool, shards: int, why: bool, output: Path | None, **options: Any) -> None:
    """Says which images a run will build, join or test, and why.

    Compares the inputs of every image, and the dates of its packages, with the registry's records. No later step
    touches images that are up to date. Run 'rosml setup' or 'rosml setup client' first, also if you name a --registry.

    \b
    Examples:
      rosml plan --why
      rosml plan --only 'ros1-bookworm-*' --output plan.json
      rosml plan --everywhere --force --shards 24   how long all images would take on 24 machines
    """
    from rosml.base import files
    from rosml.cli.images import report, tables
    from rosml.images.publish.plan import make_plan

    call = Call(**options)
    if everywhere:
        call.architectures = call.serve or tuple(call.image_set.matrix.architectures)
    state = call.survey()
    # A plan for this machine alone needs no machines in CI, and no runner in the matrix.
    plan = make_plan(state, shards, why) if everywhere or output or call.as_json else None
    for remark in plan.remarks[len(state.remarks) :] if plan else ():
        say(remark)
    if output and plan:
        files.write(output, plan.text())
        report.plan_to_ci(plan, state.image_set, report.cost(state, plan.shards))
    if call.as_json and plan:
        terminal.echo(plan.text(), nl=False)
        return
    report.print_plan(state, why)
    if everywhere and plan:
        if plan.shards:
            tables.show(tables.SHARDS, tables.shard_rows(plan.shards), right=tables.SHARDS[3:])
        terminal.echo(report.cost(state, plan.shards))
