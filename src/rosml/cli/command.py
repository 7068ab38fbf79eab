"""What all commands do at their end: every failure is a message with its remedy and an exit code, never a traceback."""

from __future__ import annotations

import contextlib
import errno
import io
import json
import os
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from types import FrameType

import click

from rosml import IN_CHECKOUT
from rosml.base import terminal
from rosml.base.environment import program
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.base.terminal import plain_where_wanted

INTERRUPTED_TEXT = "interrupted"
"""What is said after Ctrl-C, if a command has nothing better to say."""

INTERRUPTED = 130
"""Exit code after Ctrl-C, as shells have it: 128 and the signal's number."""

ERROR = click.style("error: ", fg="red", bold=True)
"""Before what is wrong."""

BROKEN_PIPE = 141
"""Exit code where nobody reads the output any more, as of a program that the signal ended: for commands that work."""


@plain_where_wanted
def run(
    main: click.Command,
    interrupted: str = INTERRUPTED_TEXT,
    arguments: Sequence[str] | None = None,
    reader_gone: int = 0,
    failure: int = 0,
) -> int:
    """Runs a click command.

    Args:
        main: the command.
        interrupted: what to say after Ctrl-C or SIGTERM.
        arguments: the command line; this process' own by default.
        reader_gone: exit code where nobody reads the output any more; 0 for commands that do nothing but print.
        failure: exit code of every error; 0 for those below.

    Returns:
        The exit code: 0, 1 for work that failed, 2 for wrong input, 3 and 4 of scans, 130 when interrupted.

    With `--json`, an error is an object on standard output as well: `{"error": …, "remedy": …}`.
    """
    signal.signal(signal.SIGTERM, _terminate)
    _stand_in_for_closed()
    for stream in (sys.stdout, sys.stderr):  # an arrow, or a file's name, that the terminal cannot show
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    given = list(sys.argv[1:] if arguments is None else arguments)
    as_json = "--json" in given
    try:
        with main.make_context(program(), given) as context:
            main.invoke(context)
        if sys.stdout:
            sys.stdout.flush()
    except RosmlError as error:
        # Problems of the matrix begin with file and line, where editors and CI look for them.
        head = "" if isinstance(error, InputError) else ERROR
        return _failed(as_json, error.message, error.remedy, failure or error.exit_code, head)
    except click.exceptions.Exit as error:  # --help, or a command's own answer
        return error.exit_code
    except click.ClickException as error:
        error.show()
        return _told(as_json, error.format_message(), "see --help", failure or error.exit_code)
    except (KeyboardInterrupt, click.Abort):
        terminal.echo(f"\n{interrupted}", err=True)
        return _told(as_json, "interrupted", interrupted, INTERRUPTED)
    except UnicodeDecodeError as error:
        found = error.object[max(0, error.start - 30) : error.start].decode(errors="replace")
        return _failed(as_json, f"a file is not UTF-8, after {found!r}", "", failure or 1)
    except BrokenPipeError:  # the reader of our output is gone: `… --list | head`
        _drop_output()
        return reader_gone
    except OSError as error:
        if error.errno == errno.EBADF:
            _drop_output()
        return _failed(as_json, *_of_the_system(error), failure or 1)
    return 0


def ended(code: int) -> int:
    """The exit code of a command; after Ctrl-C it ends the process, where threads may still wait for a registry."""
    if code == INTERRUPTED:
        for stream in (sys.stdout, sys.stderr):
            with contextlib.suppress(OSError, ValueError):
                stream.flush()
        os._exit(code)
    return code


def say(line: str) -> None:
    """Tells people what begins now."""
    terminal.echo(click.style(f"==> {line}", bold=True), err=True)


def warn(message: str, remedy: str = "") -> None:
    """Tells people, on standard error, what is wrong without ending the command, and what to do about it."""
    _say(f"{click.style('warning:', fg='yellow', bold=True)} ", message, remedy)


def _say(head: str, message: str, remedy: str) -> None:
    """Prints an error or a warning on standard error, and what to do about it."""
    terminal.echo(head + message, err=True)
    if remedy:
        terminal.echo(f"{click.style('remedy:', bold=True)} {remedy}", err=True)


def _failed(as_json: bool, message: str, remedy: str, code: int, head: str = ERROR) -> int:
    """Prints an error and what to do about it; gives the exit code."""
    _say(head, message, remedy)
    return _told(as_json, message, remedy, code)


def _told(as_json: bool, message: str, remedy: str, code: int) -> int:
    """Prints an error as an object where one was asked for; gives the exit code."""
    if as_json and sys.stdout:
        try:
            terminal.echo(json.dumps({"error": click.unstyle(message), "remedy": remedy}, indent=2))
            sys.stdout.flush()
        except OSError:  # its reader is gone, or its disk is full; people were told already
            _drop_output()
    return code


def _stand_in_for_closed() -> None:
    """Opens something in the place of closed output. Otherwise the next file that is opened gets its number, and what is
    printed goes into that file. Writing to standard output fails then; messages are dropped."""
    if sys.stdout is None:
        sys.stdout = io.TextIOWrapper(io.BufferedWriter(io.FileIO(os.open(os.devnull, os.O_RDONLY), "w")), "utf-8")
    if sys.stderr is None:
        sys.stderr = io.TextIOWrapper(io.FileIO(os.devnull, "w"), "utf-8")


def _drop_output() -> None:
    """Sends what was not written yet to nobody: Python would try it again when it ends, and complain."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


_IN_THE_WAY = "move it away, then run it again"


def _of_the_system(error: OSError) -> tuple[str, str]:
    """What a failed call of the system means, and what to do about it."""
    name = os.fsdecode(error.filename) if isinstance(error.filename, (str, bytes)) else ""
    reason = error.strerror or str(error) or type(error).__name__
    if error.errno in (errno.EEXIST, errno.ENOTDIR) and name:
        # The file may be anywhere on the way: a folder could not be made, or be entered.
        path = Path(name)
        culprit = next((x for x in (*reversed(path.parents), path) if x.exists() and not x.is_dir()), path)
        return f"{culprit} is in the way: a folder is needed there", _IN_THE_WAY
    if error.errno == errno.EISDIR and name:
        return f"{name} is in the way: it is a folder, and a file is needed there", _IN_THE_WAY
    if error.errno in (errno.EACCES, errno.EPERM, errno.EROFS) and name:
        return f"{name}: {reason}", "run it as the user who may, or let this one"
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        made = " (rosml setup down; rosml setup clean removes all that was made)" if IN_CHECKOUT else ""
        remedy = f"free some disk space{made}, then run it again"
        return f"{name}: {reason}" if name else reason, remedy
    if error.errno == errno.EBADF and not name:
        return "standard output is closed: nothing can be printed", "send it to a file or a program, or to /dev/null"
    return f"{name}: {reason}" if name else reason, ""


def _terminate(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt
