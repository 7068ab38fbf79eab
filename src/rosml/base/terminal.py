"""Tables on a terminal, one line for each row."""

from __future__ import annotations

import functools
import os
import re
import sys
from collections.abc import Callable, Collection
from typing import TYPE_CHECKING, Any, Concatenate, ParamSpec, TextIO, cast

import click

Given = ParamSpec("Given")


if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table


_COLOUR = "(?:[0-79]|2[1-9]|3[1-69]|9[1-6])"
_COLOURS = rf"\x1b\[(?:{_COLOUR}(?:;{_COLOUR})*)?m"
"""What click and rich write for colours: nothing that hides text, and nothing that moves the cursor."""

_CONTROL = re.compile(
    f"({_COLOURS})"
    r"|\x1b\[[0-?]*[ -/]*[@-~]"  # other sequences: https://ecma-international.org/publications-and-standards/standards/ecma-48/
    r"|\x1b[\]PX^_](?:[^\x07\x1b\n]*(?:\x07|\x1b\\))?"  # commands to the terminal, such as one that sets the clipboard
    r"|\x1b[ -/]*[0-~]?"
    r"|[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff]"
)
"""Characters that a terminal takes for a command, that change the order of others, or that nobody sees."""

_COMMAND = re.compile(r"^([^\S\n]*):(?=:[\w-]+)|(?<=#)#(?=\[)", re.MULTILINE)
"""What GitHub takes for a command in the output of a step: https://docs.github.com/actions/reference/workflows-and-actions/workflow-commands.
It trims a line before it looks for `::`, and finds `##[` anywhere."""


def shown(text: str) -> str:
    """A text as it can be printed, whoever wrote it: without commands to the terminal, or to CI that reads the output."""
    text = _CONTROL.sub(r"\1", text)
    if os.environ.get("GITHUB_ACTIONS") == "true":
        text = _COMMAND.sub(lambda found: f"{found[1]}: " if found[1] is not None else " #", text)
    return text


def echo(text: str = "", err: bool = False, nl: bool = True) -> None:
    """Prints a text, on standard output or standard error: the way of all commands to print, since much of it comes from outside."""
    click.echo(shown(text), err=err, nl=nl)


class _Shown:
    """A stream that gets all of a text as `shown` has it."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        return self._stream.write(shown(text))

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


def table(*columns: str, right: Collection[str] = (), wrapped: Collection[str] = ()) -> Table:
    """An empty table.

    Args:
        columns: their heads. right: those whose cells stand at the right, such as numbers.
        wrapped: those whose cells may take several lines.
    """
    from rich.table import Table  # slow to import, and only needed here

    made = Table(box=None, header_style="bold", pad_edge=False)
    for column in columns:
        made.add_column(
            column,
            justify="right" if column in right else "left",
            overflow="fold" if column in wrapped else "ellipsis",
            no_wrap=column not in wrapped,
        )
    return made


def console() -> Console:
    """Where tables go: one line for each row, also where nobody watches and the terminal's width is unknown.

    All text is printed as it is: much of it comes from outside, and may have brackets that rich would take for markup.
    """
    from rich.console import Console  # slow to import, and only needed here

    class Output(Console):
        def on_broken_pipe(self) -> None:
            """Raises BrokenPipeError, which `command.run` knows: a reader that has seen enough is no failure."""
            raise BrokenPipeError

    as_it_is = functools.partial(Output, highlight=False, markup=False, emoji=False)
    file = cast(TextIO, _Shown(sys.stdout))
    return as_it_is(file=file, soft_wrap=True) if sys.stdout.isatty() else as_it_is(file=file, width=400)


def show(table: Table) -> None:
    """Prints a table, without the spaces that fill its last column up."""
    out = console()
    with out.capture() as captured:
        out.print(table)
    echo(_PADDING.sub(r"\1", captured.get()), nl=False)


_PADDING = re.compile(r" +((?:\x1b\[[0-9;]*m)*)$", re.MULTILINE)
"""Spaces at the end of a line, before codes that end a colour."""


def plain_where_wanted(
    function: Callable[Concatenate[click.Command, Given], int],
) -> Callable[Concatenate[click.Command, Given], int]:
    """Has a function that runs a command colour nothing where NO_COLOR is set (https://no-color.org).

    click itself looks only whether there is a terminal; rich, which prints tables, knows NO_COLOR.
    """

    @functools.wraps(function)
    def run(main: click.Command, /, *given: Given.args, **named: Given.kwargs) -> int:
        if not os.environ.get("NO_COLOR"):
            return function(main, *given, **named)
        before = main.context_settings
        main.context_settings = {**before, "color": False}  # what the command says
        try:
            with click.Context(main, color=False):  # what is said of its failure
                return function(main, *given, **named)
        finally:
            main.context_settings = before

    return run
