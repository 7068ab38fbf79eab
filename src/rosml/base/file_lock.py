"""Calls that take turns: in one checkout because they publish the same images, in one builder because its cache wants it."""

from __future__ import annotations

import fcntl
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def turn(file: Path, waiting: Callable[[], object]) -> Iterator[int]:
    """Waits until no other process is in a turn of the same name. The kernel ends the turn of one that is killed.

    Args:
        file: what the turn is known by; made if it is not there, and left there.
        waiting: called once, where there is something to wait for.

    Yields:
        The file's descriptor: a child that inherits it keeps the turn until it has ended, too.

    Raises:
        OSError: the file cannot be made.
    """
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("a") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            waiting()
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield lock.fileno()
