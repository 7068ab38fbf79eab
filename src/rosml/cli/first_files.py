"""What `rosml init` says of the files that it wrote, and of what to call next."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from rosml.base import terminal

if TYPE_CHECKING:
    from rosml.containerize.init.folder import File

Calls = list[tuple[str, str]]


def show(proposed: Sequence[File], calls: Calls, dry_run: bool) -> None:
    for file in proposed:
        state = "same" if file.same else "kept" if file.exists else "new" if dry_run else "written"
        terminal.echo(f"{state:<7}  {file.path}")
        if dry_run and not file.same:
            terminal.echo("".join(f"    {line}\n" for line in file.text.splitlines()))
    terminal.echo("\nnext:")
    for line, what in calls:
        terminal.echo(f"  {line}\n      {what}")


def as_json(proposed: Sequence[File], calls: Calls) -> dict[str, Any]:
    return {
        "files": [{"path": file.path, "there": file.exists, "same": file.same, "text": file.text} for file in proposed],
        "next": [line for line, _ in calls],
    }
