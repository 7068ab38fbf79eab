"""What all commands do at their end: every failure is a message with its remedy and an exit code, never a traceback."""

from __future__ import annotations

import io
import os
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from types import FrameType

import click

from rosml.errors import RosmlError
from rosml.problems import InputError

INTERRUPTED = 130
"""Exit code after Ctrl-C, as shells have it: 128 and the signal's number."""


BROKEN_PIPE = 141
"""Exit code where nobody reads the output any more, as of a program that the signal ended: for commands that work."""


def run(
    main: click.Command,
    interrupted: str = "interrupted",
    arguments: Sequence[str] | None = None,
    reader_gone: int = 0,
) -> int:
    """Runs a click command.

    Args:
        main: the command.
        interrupted: what to say after Ctrl-C or SIGTERM.
        arguments: the command line; this process' own by default.
        reader_gone: exit code where nobody reads the output any more; 0 for commands that do nothing but print.

    Returns:
        The exit code: 0, 1 for work that failed, 2 for wrong input, 130 when interrupted.
    """
    signal.signal(signal.SIGTERM, _terminate)
    for stream in (sys.stdout, sys.stderr):  # an arrow, or a file's name, that the terminal cannot show
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    try:
        with main.make_context(
            Path(sys.argv[0]).name, list(sys.argv[1:] if arguments is None else arguments)
        ) as context:
            main.invoke(context)
        if sys.stdout:
            sys.stdout.flush()
    except RosmlError as error:
        # Problems of the matrix begin with file and line, where editors and CI look for them.
        head = "" if isinstance(error, InputError) else click.style("error: ", fg="red", bold=True)
        click.echo(head + error.message, err=True)
        if error.remedy:
            click.echo(f"{click.style('remedy:', bold=True)} {error.remedy}", err=True)
        return error.exit_code
    except click.exceptions.Exit as error:  # --help
        return error.exit_code
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (KeyboardInterrupt, click.Abort):
        click.echo(f"\n{interrupted}", err=True)
        return INTERRUPTED
    except UnicodeDecodeError as error:
        found = error.object[max(0, error.start - 30) : error.start].decode(errors="replace")
        click.echo(f"{click.style('error:', fg='red', bold=True)} a file is not UTF-8, after {found!r}", err=True)
        return 1
    except BrokenPipeError:  # the reader of our output is gone: `… --list | head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or Python complains when it ends
        return reader_gone
    except OSError as error:
        click.echo(f"{click.style('error:', fg='red', bold=True)} {error}", err=True)
        return 1
    return 0


def _terminate(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt
