"""A question of `rosml run` to the user, and the memory of the answer."""

from __future__ import annotations

import os
import sys
import termios
from contextlib import suppress
from pathlib import Path

from rosml.base import terminal
from rosml.cli import command


def possible() -> bool:
    """Whether there is a terminal for a question and its answer."""
    return os.isatty(0) and os.isatty(2)


def agreed(*lines: str) -> bool:
    """Asks, and waits for the answer. Anything but `y` and `yes` is a no. What was typed before the question is no answer to it. The last
    line is the question."""
    terminal.echo("\n".join(lines), err=True, nl=False)
    drop_typed()
    terminal.echo(" [y/N] ", err=True, nl=False)
    return sys.stdin.buffer.readline().strip().lower() in (b"y", b"yes")


def drop_typed() -> None:
    """Drops what was typed before a question, which is no answer to it."""
    with suppress(termios.error):
        termios.tcflush(0, termios.TCIFLUSH)


def keep(place: Path, content: bytes) -> None:
    """Writes the memory of answers. If that fails, rosml asks again next time."""
    from rosml.run.host import write

    try:
        write(place, content)
    except OSError as error:
        command.warn(f"{place}: {error.strerror}", "let this user write it; until then, rosml asks each time")
