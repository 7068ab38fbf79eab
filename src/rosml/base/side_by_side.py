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
    """Does some work for each item, in threads, and returns the results in order. The first error ends it. AT_ONCE is the default
    of `at_once`; with a title, a terminal shows how many items are done.
    """
    work_items = list(items)
    pool = ThreadPoolExecutor(at_once or AT_ONCE)
    try:
        results = pool.map(work, work_items)
        return list(progress_bar.over(results, title, len(work_items)) if title else results)
    finally:
        pool.shutdown(cancel_futures=True)
