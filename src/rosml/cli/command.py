"""Runs commands: every failure becomes a message with its remedy and an exit code, never a traceback."""

from __future__ import annotations

import contextlib
import errno
import io
import json
import os
import re
import shlex
import signal
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import FrameType

import click

from rosml import IN_CHECKOUT, MATRIX, ROOT
from rosml.base import terminal
from rosml.base.environment import program
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.base.terminal import obeying_no_color
from rosml.cli import MODULES

INTERRUPTED_TEXT = "interrupted"

INTERRUPTED = 130
"""The exit code after Ctrl-C, as in shells: 128 plus the signal's number."""

ERROR = click.style("error: ", fg="red", bold=True)

BROKEN_PIPE = 141
"""The exit code of commands that work if the reader of their output is gone: as if SIGPIPE had ended them."""


@obeying_no_color
def run(
    main: click.Command,
    interrupted: str = INTERRUPTED_TEXT,
    arguments: Sequence[str] | None = None,
    reader_gone: int = 0,
    failure: int = 0,
) -> int:
    """Runs a click command, by default with this process' own command line.

    Args:
        interrupted: what to say after Ctrl-C or SIGTERM.
        reader_gone: the exit code if the reader of the output is gone; 0 for commands that only print.
        failure: the exit code of every error; 0 for those below.

    Returns:
        The exit code: 0, 1 for work that failed, 2 for wrong input, 3 and 4 of scans, 130 after Ctrl-C.

    With `--json`, an error is also an object on standard output: `{"error": …, "remedy": …}`.
    """
    signal.signal(signal.SIGTERM, _interrupt)
    _open_closed_streams()
    for stream in (sys.stdout, sys.stderr):  # the terminal may be unable to show an arrow or a file's name
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    words = list(sys.argv[1:] if arguments is None else arguments)
    as_json = "--json" in words
    try:
        with main.make_context(program(), words) as context:
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
        text = io.StringIO()
        error.show(text)
        terminal.echo(as_called(text.getvalue()), err=True, nl=False)
        return _print_json_error(as_json, error.format_message(), "see --help", failure or error.exit_code)
    except (KeyboardInterrupt, click.Abort):
        terminal.echo(f"\n{interrupted}", err=True)
        return _print_json_error(as_json, interrupted, "run it again", INTERRUPTED)
    except UnicodeDecodeError as error:
        before = error.object[max(0, error.start - 30) : error.start].decode(errors="replace")
        return _failed(as_json, f"a file is not UTF-8, after {before!r}", "", failure or 1)
    except BrokenPipeError:  # the reader of our output is gone: `… --list | head`
        _drop_output()
        return reader_gone
    except OSError as error:
        if error.errno == errno.EBADF:
            _drop_output()
        return _failed(as_json, *_explain_os_error(error), failure or 1)
    return 0


def ended(code: int) -> int:
    """Returns the exit code of a command. After Ctrl-C it ends the process at once: threads may still wait for a registry."""
    if code == INTERRUPTED:
        for stream in (sys.stdout, sys.stderr):
            with contextlib.suppress(OSError, ValueError):
                stream.flush()
        os._exit(code)
    return code


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Drops what is written to standard error meanwhile, also by programs that are called."""
    sys.stderr.flush()
    terminal_number = os.dup(2)
    with open(os.devnull, "w") as nowhere, contextlib.redirect_stderr(nowhere):
        os.dup2(nowhere.fileno(), 2)
        try:
            yield
        finally:
            os.dup2(terminal_number, 2)
            os.close(terminal_number)


CALLED_IN = "ROSML_CALLED_IN"
"""The variable with the user's folder. scripts/bootstrap.py sets it, since it goes to the checkout."""


def call(folder: Path | None = None) -> str:
    """This rosml as somebody calls it in a folder: `rosml` if it is on PATH, `./rosml` in the checkout or the set, else its path."""
    if not IN_CHECKOUT:
        return "rosml"
    import shutil  # only needed here

    home = MATRIX.parent if MATRIX.name == "set.yaml" else ROOT
    script = home / "rosml"
    with contextlib.suppress(OSError):  # the current folder may be gone
        if (folder or Path(os.environ.get(CALLED_IN) or Path.cwd())).samefile(home):
            return "./rosml"
        if (program := shutil.which("rosml")) and Path(program).samefile(script):
            return "rosml"
    return shlex.quote(str(script))


_BEFORE = r"^|['`(]|[:;,|&] |\b(?:and|call|or|run|then|with) |\b[A-Z_]+=\w+ "
_CALL = re.compile(rf"({_BEFORE})(?:\./)?rosml(?= (?:(?:{'|'.join(MODULES)}|--help)\b|\[OPTIONS\]))", re.MULTILINE)


def as_called(text: str) -> str:
    """A message whose calls of rosml begin as the user can call it here: `'rosml setup'` becomes `'./rosml setup'`."""
    return _CALL.sub(lambda match: f"{match[1]}{call()}", text)


def say(line: str) -> None:
    terminal.echo(click.style(f"==> {line}", bold=True), err=True)


def warn(message: str, remedy: str = "") -> None:
    _say(f"{click.style('warning:', fg='yellow', bold=True)} ", message, remedy)


LONGEST = 10_000
"""Characters of a line of a message, which may quote what others wrote, such as a label of megabytes."""


def _shorten(text: str) -> str:
    long = "{}… ({:,} characters more)"
    lines = text.split("\n")
    return "\n".join(x if len(x) <= LONGEST else long.format(x[:LONGEST], len(x) - LONGEST) for x in lines)


def _say(head: str, message: str, remedy: str) -> None:
    message, remedy = as_called(_shorten(message)), as_called(_shorten(remedy))
    terminal.echo(head + message, err=True)
    if remedy:
        terminal.echo(f"{click.style('remedy:', bold=True)} {remedy}", err=True)


def _failed(as_json: bool, message: str, remedy: str, code: int, head: str = ERROR) -> int:
    _say(head, message, remedy)
    return _print_json_error(as_json, message, remedy, code)


def _print_json_error(as_json: bool, message: str, remedy: str, code: int) -> int:
    if as_json and sys.stdout:
        try:
            error, remedy = (as_called(_shorten(text)) for text in (click.unstyle(message), remedy))
            terminal.echo(json.dumps({"error": error, "remedy": remedy}, indent=2))
            sys.stdout.flush()
        except OSError:  # the reader is gone, or the disk is full; the message is printed already
            _drop_output()
    return code


def _open_closed_streams() -> None:
    """Opens /dev/null for closed output: otherwise the next file that is opened would get its number, and the output."""
    if sys.stdout is None:
        sys.stdout = io.TextIOWrapper(io.BufferedWriter(io.FileIO(os.open(os.devnull, os.O_RDONLY), "w")), "utf-8")
    if sys.stderr is None:
        sys.stderr = io.TextIOWrapper(io.FileIO(os.devnull, "w"), "utf-8")


def _drop_output() -> None:
    """Drops unwritten output. Otherwise Python tries again when it ends, and complains."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _explain_os_error(error: OSError) -> tuple[str, str]:
    name = os.fsdecode(error.filename) if isinstance(error.filename, (str, bytes)) else ""
    reason = error.strerror or str(error) or type(error).__name__
    if error.errno in (errno.EEXIST, errno.ENOTDIR) and name:
        # The file may be any part of the path: a folder could not be made or entered.
        path = Path(name)
        culprit = next((x for x in (*reversed(path.parents), path) if x.exists() and not x.is_dir()), path)
        return f"{culprit} is in the way: a folder is needed there", "move it away, then run it again"
    if error.errno == errno.EISDIR and name:
        return f"{name} is in the way: it is a folder, and a file is needed there", "move it away, then run it again"
    if error.errno in (errno.EACCES, errno.EPERM, errno.EROFS) and name:
        return f"{name}: {reason}", "run it as a user with access, or give this one access"
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        how = " (rosml setup down; rosml setup clean removes all that was made)" if IN_CHECKOUT else ""
        return f"{name}: {reason}" if name else reason, f"free some disk space{how}, then run it again"
    if error.errno == errno.EBADF and not name:
        return "standard output is closed: nothing can be printed", "send it to a file or a program, or to /dev/null"
    return f"{name}: {reason}" if name else reason, ""


def _interrupt(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt
