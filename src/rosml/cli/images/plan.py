"""`rosml plan`: what a publishing run will do."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from rosml.base import terminal
from rosml.cli.checkout import Command
from rosml.cli.images.call import Call, sharing


@click.command("plan", short_help="Says what a publishing run will do, and why.", cls=Command)
@sharing("registry", "matrix", "only", "architecture", "serve", "force", "date", "json")
@click.option(
    "--everywhere",
    is_flag=True,
    help="plan for all architectures that the registry serves, each on machines of its own, and say which builds what",
)
@click.option(
    "--shards",
    type=click.IntRange(min=1),
    default=8,
    show_default=True,
    help="among how many machines builds are dealt out, at most",
)
@click.option("--why", is_flag=True, help="name the inputs that changed")
@click.option(
    "--output", type=click.Path(path_type=Path, dir_okay=False), help="write the plan there, for the other steps"
)
def main(everywhere: bool, shards: int, why: bool, output: Path | None, **options: Any) -> None:
    """Says what is to be done: which images are not as they should be, and why.

    Compares the inputs of every image, and the dates of the packages that it is built from, with what the registry's
    records say. No later step touches unchanged images. Also with --registry, it needs what 'rosml setup', or 'rosml setup
    client', leaves in the checkout.

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
    # Who plans for this machine alone needs no machines in CI, and no word in the matrix on which they are.
    found = make_plan(state, shards, why) if everywhere or output or call.as_json else None
    if output and found:
        files.write(output, found.text())
        report.tell(found)
    if call.as_json and found:
        terminal.echo(found.text(), nl=False)
        return
    report.print_plan(state, why)
    if everywhere and found and found.shards:
        tables.show(tables.SHARDS, tables.shard_rows(found.shards), right=tables.SHARDS[3:])
