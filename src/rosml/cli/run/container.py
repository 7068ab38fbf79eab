"""The common part of `rosml run` and `rosml attach`, which become docker or podman."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import shlex
import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from typing import NoReturn

import click

from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.checkout import Command
from rosml.run import attach, host, words
from rosml.run.context import Container, Person
from rosml.run.plugins.basic_options import FOLDER_LABEL

LINE = "rosml.run.line"
SETTINGS = {"allow_interspersed_args": False, "help_option_names": ["--help"]}
"""Without -h, which is an option of the engines: the container's host name."""


class Words(Command):
    """A command of which click reads only its own options and the first word that is none.

    It fails with docker's own code: all others belong to the command in the container.
    """

    failure = 125

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        with printing():  # --help
            return super().parse_args(ctx, self.for_click(ctx, args))

    def for_click(self, ctx: click.Context, args: Sequence[str]) -> list[str]:
        """The words that click reads. Puts the whole line into the context. A shell that completes a word gets no error."""
        if [*args] == ["-h"]:  # of the engines, it needs a value
            return ["--help"]
        options = [option for option in self.get_params(ctx) if isinstance(option, click.Option)]
        own_names = [name for option in options for name in option.opts]
        with_value = [name for option in options if not option.is_flag for name in option.opts]
        try:
            line = words.split(args, own_names, with_value)
        except RosmlError:
            if not ctx.resilient_parsing:
                raise
            return [*args]
        ctx.meta[LINE] = line
        return [*line.rosml, *([line.image, *line.command] if line.image else [])]


def flag(name: str, text: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """A switch that is read from the line of words."""
    return click.option(name, is_flag=True, expose_value=False, help=text)


def showing(main: Callable[..., None]) -> Callable[..., None]:
    """Adds the options that show what would run."""
    main = flag("--json", "print its words as JSON, and run nothing")(main)
    main = flag("--dry-run", "print the engine's command, and run nothing")(main)
    return flag("--verbose", "print the engine's command on standard error, then run it")(main)


SHOW = ("--dry-run", "--json", "--check", "--export")


def only_shown(line: words.Line) -> bool:
    """Whether the call only shows something."""
    return any(word.partition("=")[0] in SHOW for word in line.rosml)


def perform(line: words.Line, argv: Sequence[str], begin: Callable[[], object] | None = None) -> None:
    """Shows the engine's command, or calls `begin` and becomes the engine."""
    if line.asks("json"):
        with printing():
            terminal.echo(json.dumps(argv))
    elif line.asks("dry-run"):
        with printing():
            terminal.echo(shown(argv))
    else:
        if line.asks("verbose"):
            terminal.echo(shown(argv), err=True)
        if begin:
            begin()
        become(argv)


def shown(argv: Sequence[str]) -> str:
    """A command as a shell reads it. Bytes that are no text are quoted for bash, zsh and ksh."""
    return " ".join(map(_quoted, argv))


def _quoted(word: str) -> str:
    try:
        word.encode()
    except UnicodeEncodeError:
        safe = {code: chr(code) for code in range(ord(" "), 127) if chr(code) not in "'\\"}
        return f"$'{''.join(safe.get(code) or f'{chr(92)}x{code:02x}' for code in os.fsencode(word))}'"
    return shlex.quote(word)


@contextlib.contextmanager
def printing() -> Iterator[None]:
    """For output only: its reader may stop early."""
    try:
        yield
    except OSError as error:
        if error.errno not in (errno.EPIPE, errno.ENOSPC):
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # otherwise Python tries again when it ends
        if error.errno == errno.EPIPE:
            raise click.exceptions.Exit(0) from None
        raise RosmlError(f"standard output: {error.strerror}", "send it to another place") from None


def become(argv: Sequence[str]) -> NoReturn:
    """Becomes the engine, which then has the terminal, the signals and the exit code."""
    for number in (signal.SIGPIPE, signal.SIGXFSZ):  # Python ignores them, and the engine would inherit that
        signal.signal(number, signal.SIG_DFL)
    os.execvp(argv[0], [*argv])


def enter(program: str, line: words.Line, caller: Person, container: Container) -> None:
    """Enters a container, or shows how. If the container has stopped, starts it first. `program` is the engine's command."""
    from rosml.run import engine

    attach.check_state(program, container)
    image = None if line.command else engine.image(program, container.image_id)
    argv = attach.argv(program, line, caller, container, image)
    if note := attach.lacking(line, container):
        command.warn(*note)
    if container.state == "running":
        perform(line, argv)
        return
    if only_shown(line):
        terminal.echo(f"{container.name} is {container.state}: {program} start {container.name} comes first", err=True)

    def begin() -> None:
        from rosml.run.plugins import sockets  # few containers are started again

        machine = host.host(os.environ)
        here = engine.about(program).is_on(machine)
        for file, content in sockets.files_again(machine, caller, container).items() if here else ():
            with contextlib.suppress(OSError):  # the engine then says what is missing
                host.write(machine.path(file), content)
        engine.start(program, container, here)

    perform(line, argv, begin)


def engine_program() -> str:
    """The engine's command. If podman takes Docker's place, says so."""
    from rosml.run import engine

    return engine.choose(os.environ, lambda text: terminal.echo(f"rosml: {text}", err=True))


def enter_folder(line: words.Line, command: str) -> None:
    """Enters the container of the current folder. `command` is the call, for messages."""
    from rosml.run import engine

    program, caller = engine_program(), host.person(os.environ)
    containers = engine.containers(program, FOLDER_LABEL)
    enter(program, line, caller, attach.of_folder(containers, caller.folder, command))
