"""The files with defaults of `rosml run`, and the question whether a project's file may have what it wants."""

from __future__ import annotations

import os
import sys
from collections.abc import Collection
from dataclasses import replace

from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command, container
from rosml.run import defaults, words


def read(line: words.Line, options: Collection[str], refused: Collection[str], folder: str) -> defaults.Files:
    """The files that count for a command line: none with --no-defaults.

    Args:
        line: what somebody typed. options, refused: as in `defaults.files`. folder: the current one.
    """
    if line.asks("no-defaults"):
        return defaults.Files()
    return defaults.files(os.environ, folder, options, refused)


def require(typed: words.Line, file: defaults.File | None) -> bool:
    """Asks whether a project's file may have what it wants, unless somebody allowed that already. Where nothing runs, says that
    it would ask.

    Args:
        typed: what somebody typed: the file's image and command count where this names none.

    Returns:
        Whether it may; False only where nothing runs.

    Raises:
        RosmlError: they say no, or there is no terminal to ask on.
    """
    from rosml.run import consent
    from rosml.run.host import write

    if file is None:
        return True
    trusted = consent.is_own(file.owner, os.environ)
    used = file.line if typed.image in ("", defaults.HERE) else replace(file.line, image="", command=())
    place = consent.memory(os.environ)
    if not consent.wanted(used, trusted) or consent.is_allowed(file, place):
        return True
    name = defaults.shown(file.path)
    items = [defaults.shown(item) for item in consent.wanted(file.line, trusted)]
    said = f"{name} wants what you have not allowed: {', '.join(items)}"
    if container.only_shown(typed):
        command.warn(said, "rosml run will ask you first")
        return False
    if not (os.isatty(0) and os.isatty(2)):
        raise RosmlError(said, "call it once in a terminal, where rosml asks you; --no-defaults leaves the file out", 2)
    whose = "" if trusted else f", a file of another user ({file.owner}),"
    terminal.echo("\n  ".join([f"{name}{whose} wants:", *items]), err=True)
    terminal.echo("Allow this until the file changes? [y/N] ", err=True, nl=False)
    if sys.stdin.buffer.readline().strip().lower() not in (b"y", b"yes"):
        raise RosmlError(f"{name} is not allowed", "--no-defaults leaves it out", exit_code=2)
    try:
        write(place, consent.remembered(file, place))
    except OSError as error:
        command.warn(f"{place}: {error.strerror}", "let this user write it; until then, rosml asks each time")
    return True
