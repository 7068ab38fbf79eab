"""The questions of `rosml run`: whether to allow what a project's file wants, and whether an image may start as root."""

from __future__ import annotations

import os
import sys
import termios
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from rosml import IN_CHECKOUT, STATE
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.run import container
from rosml.run import defaults, host, words
from rosml.run.context import Context
from rosml.run.plugins.user import needs_trust

TRUST = "trust"
"""The option that trusts an image's repository."""


def allow(typed: words.Line, file: defaults.File | None) -> bool:
    """Asks whether to allow the settings of a project's file, unless the user has allowed them before. Returns whether it is allowed.
    If nothing runs, only warns and returns False. Of the file's image and command, those count that `typed` does not replace."""
    if file is None:
        return True
    from rosml.run import consent

    trusted = defaults.is_own(file.owner, os.environ)
    used = file.line if typed.image in ("", words.HERE) else replace(file.line, image="", command=())
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
    if not possible():
        remedy = "call it once in a terminal, so that rosml can ask you; --no-defaults leaves the file out"
        raise RosmlError(message, remedy, exit_code=2)
    whose = "" if trusted else f", a file of another user ({file.owner}),"
    until = "Allow this until the file or what it names changes?"
    if not agreed("\n  ".join([f"{name}{whose} wants:", *items]), until):
        raise RosmlError(f"{name} is not allowed", "--no-defaults leaves it out", exit_code=2)
    keep(place, consent.with_answer(file.path, digest, place))
    return True


def settle_trust(context: Context) -> Context:
    """The context with whether the image's repository is trusted. If the user has not said so, asks on a terminal and keeps
    the answer. If nothing runs, or there is no terminal, only warns."""
    says_so = context.line.asks(TRUST)
    if not says_so and not needs_trust(context):
        return context
    from rosml.run import consent, trust

    name = trust.repository(context.line.image, context.image.id, context.engine.podman)
    place, runs = consent.memory(os.environ), not container.only_shown(context.line)
    answer = consent.is_trusted(name, place)
    if says_so and runs and answer is not True:
        keep(place, consent.with_answer(consent.IMAGES + name, True, place))
    if says_so or (answer is None and IN_CHECKOUT and trust.is_local(name, trust.local_registry(STATE))):
        answer = True
    if answer is None and (not runs or not possible() or context.line.has("userns")):
        text = f"{name} wants to start as root, and you have not trusted it: it runs as you, without sudo"
        command.warn(text, f"--{TRUST} trusts all images of that repository from now on")
        return context
    if answer is None:
        answer = agreed(
            f"{name} wants to start as root, and to make a user with your ids then.",
            "As root it can read and change all that you mount, and leave files of root's there. If not, it runs as you, without sudo.",
            f"Trust all images of {name}?",
        )
        keep(place, consent.with_answer(consent.IMAGES + name, answer, place))
    return replace(context, trusted=answer)


def possible() -> bool:
    """Whether there is a terminal for a question and its answer."""
    return os.isatty(0) and os.isatty(2)


def agreed(*lines: str) -> bool:
    """Asks, and waits for the answer. The last line is the question. Anything but `y` and `yes` is a no."""
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
    try:
        host.write(place, content)
    except OSError as error:
        command.warn(f"{place}: {error.strerror}", "let this user write it; until then, rosml asks each time")
