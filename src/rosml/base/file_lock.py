"""Locks by which processes take turns: in a checkout, because they publish the same images; in a builder, because of its cache."""

from __future__ import annotations

import fcntl
import itertools
import os
import re
import shlex
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from rosml.base.units import ago

LONGEST_COMMAND = 100
"""The most characters of a holder's command."""


@contextmanager
def turn(file: Path, waiting: Callable[[], object]) -> Iterator[int]:
    """Waits until no other process holds the same lock, then holds it. If a process is killed, the kernel releases its lock.

    The file is made if it is missing, and stays. `waiting` is called once if another process holds the lock. Yields the file's
    descriptor: a child that inherits it holds the lock until it has ended, too.
    """
    file.parent.mkdir(parents=True, exist_ok=True)
    # A link is not followed, and a named pipe is not waited for.
    flags = os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_NONBLOCK
    with os.fdopen(os.open(file, flags, 0o666), "r+b", buffering=0) as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            waiting()
            fcntl.flock(lock, fcntl.LOCK_EX)
        # Options may have secrets, such as -e TOKEN=…, and the file stays.
        before_options = itertools.takewhile(lambda word: not word.startswith("-"), sys.argv[1:])
        words = shlex.join(["rosml", *before_options])[:LONGEST_COMMAND]
        with suppress(OSError):  # a full disk, or no file: then nobody sees who holds it
            lock.truncate(0)
            lock.write(f"{os.getpid()} {time.time():.0f} {words}".encode(errors="replace"))
        try:
            yield lock.fileno()
        finally:
            with suppress(OSError):
                lock.truncate(0)  # the next holder is not taken for this one


def holder(file: Path) -> str:
    """Who holds a lock, for people: `process 4711, which began 2 minutes ago: rosml image jazzy-base`."""
    text = ""
    with suppress(OSError):
        for _ in range(10):  # who has just got the lock writes at once
            with file.open("rb") as stream:
                text = stream.read(1000).decode(errors="replace")
            if text:
                break
            time.sleep(0.02)
    match = re.fullmatch(r"(\d{1,10}) (\d{1,12}) ([ -~]+)", text)
    if not match:
        return "another process"
    return f"process {match[1]}, which began {ago(max(0.0, time.time() - int(match[2])))}: {match[3]}"
