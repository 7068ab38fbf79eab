"""Locks by which processes take turns: in a checkout, because they publish the same images; in a builder, because of its cache."""

from __future__ import annotations

import fcntl
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def turn(file: Path, waiting: Callable[[], object]) -> Iterator[int]:
    """Waits until no other process holds the same lock, then holds it. If a process is killed, the kernel releases its lock.

    Args:
        file: the lock's file. It is made if it is missing, and stays.
        waiting: called once if another process holds the lock.

    Yields:
        The file's descriptor. A child that inherits it holds the lock until it has ended, too.

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
