"""Several things at a time that mostly wait for an answer from somewhere else."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from rosml.base import progress_bar

T = TypeVar("T")
R = TypeVar("R")

AT_ONCE = 16
"""How many requests to a registry are under way at a time: it answers one in some milliseconds, one far away in a tenth of
a second."""


def side_by_side(work: Callable[[T], R], items: Iterable[T], at_once: int = 0, title: str = "") -> list[R]:
    """Does some work for each of several things, in threads.

    Args:
        at_once: how many are under way at a time; AT_ONCE if 0.
        title: names the work on a terminal, which shows how many of the things are done; it shows nothing if empty.

    Returns:
        The results, in the order of the things.

    Raises:
        Exception: what the work for the first of them that failed raised. After an error, no more work is begun.
    """
    wanted = list(items)
    pool = ThreadPoolExecutor(at_once or AT_ONCE)
    try:
        found = pool.map(work, wanted)
        return list(progress_bar.over(found, title, len(wanted)) if title else found)
    finally:
        pool.shutdown(cancel_futures=True)
