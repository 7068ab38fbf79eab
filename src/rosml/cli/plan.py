"""`rosml plan`: what a publishing run will do."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from rosml.cli.call import Call, sharing
from rosml.cli.checkout import Command


@click.command("plan", cls=Command)
@sharing("registry", "matrix", "only", "architecture", "serve", "force", "date", "json")
@click.option(
    "--everywhere",
    is_flag=True,
    help="plan for all architectures that the registry serves, each on machines of its own",
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
      rosml plan --only 'bookworm-*' --output plan.json
    """
    from rosml.base import files
    from rosml.cli import report

    call = Call(**options)
    if everywhere:
        call.architectures = call.serve or tuple(call.image_set.matrix.architectures)
    pipeline = call.pipeline()
    text = report.plan_json(pipeline, shards, why)
    if output:
        files.write(output, text)
        report.tell(text)
    if call.as_json:
        click.echo(text, nl=False)
    else:
        report.print_plan(pipeline, why)
