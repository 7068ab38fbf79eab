#!/usr/bin/env python3
"""Writes the hash-pinned locks in locks/ from matrix.yaml."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import rosml.environment  # noqa: F401 (first: says what to do where the others are missing)

# isort: split

import click

from rosml import ROOT, command, files
from rosml.errors import RosmlError

if TYPE_CHECKING:
    from rosml.lock import Move


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--upgrade", is_flag=True, help="Move to the newest versions that fit; otherwise earlier ones stay.")
@click.option("--check", is_flag=True, help="Write nothing; exit 1 if a lock would change.")
@click.option("--stack", "stacks", multiple=True, metavar="NAME", help="Only this stack's locks; may be repeated.")
@click.option(
    "--matrix", type=click.Path(path_type=Path), default=ROOT / "matrix.yaml", help="Read this matrix instead."
)
def main(upgrade: bool, check: bool, stacks: tuple[str, ...], matrix: Path) -> None:
    """Resolves every stack for every Python version and architecture, and writes the locks that changed.

    \b
    Examples:
      uv run scripts/lock.py              after a change in matrix.yaml
      uv run scripts/lock.py --upgrade    take new releases of the dependencies
      uv run scripts/lock.py --stack cpu  the locks of one stack
    """
    from rosml import expand, names, source
    from rosml.lock import lock, moves
    from rosml.problems import unknown

    catalogue = expand.catalogue(source.read(matrix))
    for name in stacks:
        if name not in catalogue.matrix.stacks:
            raise RosmlError(unknown("stack", name, catalogue.matrix.stacks), exit_code=2)
    locks = lock(catalogue, ROOT, upgrade=upgrade, say=lambda line: click.echo(line, err=True), stacks=stacks)
    there = {path for path in names.locks(ROOT) if not stacks or path.split("/")[1] in stacks}
    earlier = {path: (ROOT / path).read_text(errors="replace") for path in there & locks.texts.keys()}
    stale = [path for path, text in sorted(locks.texts.items()) if earlier.get(path) != text]
    for path in () if check else stale:
        (ROOT / path).parent.mkdir(parents=True, exist_ok=True)
        files.write(ROOT / path, locks.texts[path])
    for path in stale:  # when all is written: whoever reads along may stop reading
        click.echo(f"{path}: {'would change' if check else 'written'}")
    print_moves(moves(earlier, {path: locks.texts[path] for path in stale if path in earlier}))
    for path in sorted(there - locks.texts.keys()):
        click.echo(f"{path}: belongs to nothing in {matrix.name}; delete it")
    for request, reason in locks.left_out.items():
        click.echo(f"{request}: locks stay as they are: {reason}", err=True)
    click.echo(f"{len(locks.texts)} locks, {len(stale)} {'stale' if check else 'changed'}")
    if check and stale:
        raise RosmlError(f"{len(stale)} locks are stale", "run 'make locks' and commit the result")


def print_moves(moved: Mapping[Move, int]) -> None:
    """A table of old and new versions."""
    if not moved:
        return
    from rich.table import Table  # slow to import, and only needed here

    from rosml.listing import show

    table = Table("stack", "package", "old", "new", "locks", box=None, header_style="bold", pad_edge=False)
    for move, count in sorted(moved.items()):
        table.add_row(move.stack, move.package, move.old or "-", move.new or "-", str(count))
    show(table)


if __name__ == "__main__":
    sys.exit(command.run(main))
