"""Progress bars for long work, on a terminal only."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from rich.progress import ProgressColumn

Thing = TypeVar("Thing")


def over(things: Iterable[Thing], title: str, total: int) -> Iterator[Thing]:
    """Yields the things; a bar below the printed lines shows how many are done. Meanwhile, write to the current `sys.stderr`."""
    if total < 2 or not sys.stderr.isatty():
        yield from things
        return
    from rich.progress import MofNCompleteColumn

    with _bar(title, total, MofNCompleteColumn()) as advance:
        for thing in things:
            yield thing
            advance(1)


@contextlib.contextmanager
def of_bytes(title: str, total: int) -> Iterator[Callable[[int], object]]:
    """Gives a function to call with the number of further bytes."""
    if not total or not sys.stderr.isatty():
        yield lambda _: None
        return
    from rich.progress import DownloadColumn

    with _bar(title, total, DownloadColumn()) as advance:
        yield advance


@contextlib.contextmanager
def _bar(title: str, total: int, count: ProgressColumn) -> Iterator[Callable[[int], object]]:
    from rich.console import Console
    from rich.file_proxy import FileProxy
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    class Above(FileProxy):
        """Takes lines while there is a bar. rich's own class has no encoding, and click would write past it."""

        encoding, errors = "utf-8", "replace"

    console = Console(file=sys.stderr)
    columns = (TextColumn("{task.description}"), BarColumn(), count, TimeElapsedColumn())
    progress = Progress(*columns, console=console, transient=True, redirect_stdout=False, redirect_stderr=False)
    with contextlib.redirect_stderr(Above(console, sys.stderr)), progress:
        task = progress.add_task(title, total=total)
        yield lambda number: progress.advance(task, number)
