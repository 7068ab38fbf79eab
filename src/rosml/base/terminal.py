"""Tables on a terminal, one line for each row."""

from __future__ import annotations

import functools
import os
import re
import sys
from collections.abc import Callable, Collection
from typing import TYPE_CHECKING, Concatenate, ParamSpec

import click

Given = ParamSpec("Given")


if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table


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
    return as_it_is(soft_wrap=True) if sys.stdout.isatty() else as_it_is(width=400)


def show(table: Table) -> None:
    """Prints a table, without the spaces that fill its last column up."""
    out = console()
    with out.capture() as captured:
        out.print(table)
    click.echo(_PADDING.sub(r"\1", captured.get()), nl=False)


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
