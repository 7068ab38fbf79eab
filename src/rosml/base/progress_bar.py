"""Progress bars for long work, on a terminal only."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterable, Iterator
from typing import TypeVar

Thing = TypeVar("Thing")


def over(things: Iterable[Thing], title: str, total: int) -> Iterator[Thing]:
    """Yields the things one by one; a bar below the printed lines shows how many are done.

    The bar goes away at the end, also if the caller stops early. Meanwhile, write to the current `sys.stderr`.

    Args:
        things: the work, or its results.
        title: the name of the work.
        total: the number of things.
    """
    if total < 2 or not sys.stderr.isatty():
        yield from things
        return
    from rich.console import Console
    from rich.file_proxy import FileProxy
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    class Above(FileProxy):
        """Takes lines while there is a bar. rich's own class has no encoding, and click would write past it."""

        encoding, errors = "utf-8", "replace"

    console = Console(file=sys.stderr)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    progress = Progress(*columns, console=console, transient=True, redirect_stdout=False, redirect_stderr=False)
    with contextlib.redirect_stderr(Above(console, sys.stderr)), progress:
        task = progress.add_task(title, total=total)
        for thing in things:
            yield thing
            progress.advance(task)
