#!/usr/bin/env python3
"""Writes the hash-pinned locks in locks/ from matrix.yaml."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import click

from rosml import ROOT, command, files
from rosml.errors import RosmlError


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--upgrade", is_flag=True, help="Move to the newest versions that fit; otherwise earlier ones stay.")
@click.option("--check", is_flag=True, help="Write nothing; exit 1 if a lock would change.")
@click.option(
    "--matrix", type=click.Path(path_type=Path), default=ROOT / "matrix.yaml", help="Read this matrix instead."
)
def main(upgrade: bool, check: bool, matrix: Path) -> None:
    """Resolves every stack for every Python version and architecture, and writes the locks that changed.

    \b
    Examples:
      uv run scripts/lock.py              after a change in matrix.yaml
      uv run scripts/lock.py --upgrade    take new releases of the dependencies
    """
    from rosml import expand, source
    from rosml.lock import lock, versions

    locks = lock(expand.catalogue(source.read(matrix)), ROOT, upgrade=upgrade)
    wanted = locks.texts
    stale = []
    for path, text in sorted(wanted.items()):
        file = ROOT / path
        old = versions(file.read_text()) if file.exists() else {}
        new = versions(text)
        if file.exists() and file.read_text() == text:
            continue
        stale.append(path)
        click.echo(f"{path}: {'would change' if check else 'written'}")
        for name in sorted(old.keys() | new.keys()):
            if old.get(name) != new.get(name):
                click.echo(f"  {name:32} {old.get(name, '-'):>16} -> {new.get(name, '-')}")
        if not check:
            file.parent.mkdir(parents=True, exist_ok=True)
            files.write(file, text)
    left = {str(file.relative_to(ROOT)) for file in (ROOT / "locks").rglob("*.txt")} - wanted.keys()
    for path in sorted(left):
        click.echo(f"{path}: belongs to nothing in {matrix.name}; delete it")
    for request, reason in locks.left_out.items():
        click.echo(f"{request}: locks stay as they are: {reason}", err=True)
    click.echo(f"{len(wanted)} locks, {len(stale)} {'stale' if check else 'changed'}")
    if check and stale:
        raise RosmlError(f"{len(stale)} locks are stale", "run 'make locks' and commit the result")


if __name__ == "__main__":
    sys.exit(command.run(main))
