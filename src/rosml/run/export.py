"""A call without its passing parts, for files from which other programs start it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace

from rosml.base.errors import RosmlError
from rosml.run import concerns, sockets
from rosml.run.context import Context
from rosml.run.words import Given, Line, split

OF_A_CALL = ("attach", "detach", "detach-keys", "quiet", "replace", "rm", "rmi", "sig-proxy")
"""Options about how a single call waits and cleans up. Programs that start the file have their own."""

SYNONYMS = {"net": "network", "dns-option": "dns-opt"}
"""Options with two names."""

FIELDS = {"src": "source", "dst": "target", "destination": "target", "ro": "readonly"}
"""Fields of `--mount` with several names."""

X11 = ("-v", "/tmp/.X11-unix:/tmp/.X11-unix", "-e", "DISPLAY", "-e", "QT_X11_NO_MITSHM=1")
"""Options for windows that last as long as a file: the sockets of all displays, and the DISPLAY of the user who starts it."""


@dataclass(frozen=True)
class Option:
    """An option of the engine.

    Attributes:
        name: its long name.
        value: its value; None if it is a switch.
    """

    name: str
    value: str | None = None

    @property
    def is_on(self) -> bool:
        """Whether a switch is on."""
        return self.value is None or self.value.lower() in ("1", "t", "true")


@dataclass(frozen=True)
class Call:
    """A call.

    Attributes:
        name: its name for people, from the folder.
        options: the engine's options. If two set the same thing, the last one counts.
        folder: the current folder, for the file.
    """

    name: str
    options: tuple[Option, ...]
    image: str
    command: tuple[str, ...]
    folder: str


def lasting(context: Context) -> Context:
    """The context as on a terminal, without the parts of a session: the cookie of X11, and the socket of ssh's agent.

    Raises:
        RosmlError: the user asks for ssh's agent.
    """
    line = context.line
    if line.asks("ssh-agent"):
        text = "--ssh-agent does not go with --export: the agent's socket has another path in each session"
        raise RosmlError(text, "leave it out; editors pass your agent themselves", exit_code=2)
    windows = X11 if _has_windows(context) else ()
    kept = preceded(replace(line, own=(*line.own, "--no-name", "--no-x11")), *windows)
    return replace(context, line=kept, person=replace(context.person, terminal=True, reads=True))


def preceded(line: Line, *words: str) -> Line:
    """The line with more options of the engine before the typed ones."""
    return replace(line, engine=(*split([*words, line.image], ()).engine, *line.engine))


def _has_windows(context: Context) -> bool:
    """Whether X11 shows windows of this machine. A display of `ssh -X` is gone when the file is used."""
    line, host = context.line, context.host
    named = sockets.DISPLAY.fullmatch(host.environment.get("DISPLAY", ""))
    if line.asks("no-x11") or line.sets("DISPLAY") or not context.is_here or not named:
        return False
    return named["machine"] in ("", "unix") and host.has(f"/tmp/.X11-unix/X{named['number']}")


def call(context: Context, argv: Sequence[str]) -> Call:
    """The call.

    Args:
        argv: the engine's command, from the plugins.

    Raises:
        RosmlError: a word of the command is no text.
    """
    odd = next((word for word in argv if not _is_text(word)), None)
    if odd is not None:
        raise RosmlError(f"--export: {odd!a} is no text", "write it in UTF-8", exit_code=2)
    line = split(argv[2:], ())
    options = [Option(SYNONYMS.get(name, name), value) for given in line.engine for name, value in _pairs(given)]
    kept = tuple(option for option in options if option.name not in OF_A_CALL)
    folder = context.person.folder
    name = concerns.name_of(Line((), (), line.image, ()), context.person) or "container"
    return Call(name, kept, line.image, line.command, folder)


def _is_text(word: str) -> bool:
    try:
        word.encode()
    except UnicodeEncodeError:
        return False
    return True


def _pairs(given: Given) -> list[tuple[str, str | None]]:
    """The options in a word, such as `-itv`, each with its value; only the last one can have a value."""
    *switches, last = given.names
    return [*((name, None) for name in switches), (last, given.value)]


def fields(option: Option) -> list[tuple[str, str]]:
    """The fields of a value such as `type=bind,source=/a,target=/b`; a switch among them has an empty value.

    Raises:
        RosmlError: its quotes do not close.
    """
    import csv  # few values have any

    try:
        (found,) = csv.reader([option.value or ""], strict=True)
    except (csv.Error, ValueError):
        raise RosmlError(
            f"--{option.name}={option.value}: its quotes do not close", 'write one " at each end', exit_code=2
        ) from None
    return [(FIELDS.get(key, key), value) for key, _, value in (field.partition("=") for field in found)]


def placed(path: str, folder: str, start: str) -> str:
    """A path. If it lies in the current folder, it begins with `start` instead, so that the file works elsewhere."""
    if folder == "/" or not f"{path}/".startswith(f"{folder}/"):
        return path
    return start + path[len(folder) :]


def file(option: Option, folder: str, start: str) -> str:
    """The value of an option that is a file of this machine; a relative path begins at the current folder."""
    return placed(os.path.normpath(os.path.join(folder, option.value or "")), folder, start)


def volume(option: Option, folder: str, start: str) -> str:
    """The value of `-v`, with its folder as `placed` has it. Without a colon it is a place in the container."""
    source, colon, rest = (option.value or "").partition(":")
    return placed(source, folder, start) + colon + rest if colon else source
