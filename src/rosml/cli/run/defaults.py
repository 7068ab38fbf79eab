"""The files with defaults of `rosml run`, and the question whether to allow what a project's file wants."""

from __future__ import annotations

import os
from collections.abc import Collection
from dataclasses import replace

from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.run import container, question
from rosml.run import defaults, words


def read(line: words.Line, options: Collection[str], refused: Collection[str], folder: str) -> defaults.Files:
    """The files that count for a command line: none with --no-defaults. `options` and `refused` are as in `defaults.files`."""
    if line.asks("no-defaults"):
        return defaults.Files()
    return defaults.files(os.environ, folder, options, refused)


def require(typed: words.Line, file: defaults.File | None) -> bool:
    """Asks whether to allow the settings of a project's file, unless the user has allowed them before. If nothing runs, only warns.

    Args:
        typed: the command line as typed. If it names no image, the file's image and command count.

    Returns:
        Whether it is allowed; False only if nothing runs.
    """
    if file is None:
        return True
    from rosml.run import consent

    trusted = defaults.is_own(file.owner, os.environ)
    used = file.line if typed.image in ("", defaults.HERE) else replace(file.line, image="", command=())
    if not consent.questionable(used, trusted):
        return True
    place, digest = consent.memory(os.environ), consent.digest(file)
    if consent.is_allowed(file, digest, place):
        return True
    name = defaults.shown(file.path)
    settings = consent.questionable(file.line, trusted, file.leads, os.path.dirname(file.path))
    items = [defaults.shown(item) for item in settings]
    message = f"{name} wants what you have not allowed: {', '.join(items)}"
    if container.only_shown(typed):
        command.warn(message, "rosml run will ask you first")
        return False
    if not question.possible():
        raise RosmlError(
            message, "call it once in a terminal, so that rosml can ask you; --no-defaults leaves the file out", 2
        )
    whose = "" if trusted else f", a file of another user ({file.owner}),"
    until = "Allow this until the file or what it names changes?"
    if not question.agreed("\n  ".join([f"{name}{whose} wants:", *items]), until):
        raise RosmlError(f"{name} is not allowed", "--no-defaults leaves it out", exit_code=2)
    question.keep(place, consent.with_file(file, digest, place))
    return True
