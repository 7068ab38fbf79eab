"""Bars that show how far long work is, for whoever watches a terminal. Elsewhere there is nothing but the lines that commands
print anyhow."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterable, Iterator
from typing import TypeVar

Thing = TypeVar("Thing")


def over(things: Iterable[Thing], title: str, total: int) -> Iterator[Thing]:
    """The things, one after the other; a bar below what is printed meanwhile says how many are done.

    It goes when they end, and when whoever takes them stops; what others write has to go to `sys.stderr` of that moment.

    Args:
        things: what is worked on, or what comes of it.
        title: what the work is called.
        total: how many they are.
    """
    if total < 2 or not sys.stderr.isatty():
        yield from things
        return
    from rich.console import Console
    from rich.file_proxy import FileProxy
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    class Above(FileProxy):
        """Where lines go while there is a bar. rich's own has no encoding, and click would write past it."""

        encoding, errors = "utf-8", "replace"

    console = Console(file=sys.stderr)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    progress = Progress(*columns, console=console, transient=True, redirect_stdout=False, redirect_stderr=False)
    with contextlib.redirect_stderr(Above(console, sys.stderr)), progress:
        task = progress.add_task(title, total=total)
        for thing in things:
            yield thing
            progress.advance(task)
