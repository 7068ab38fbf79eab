"""Output on a terminal: text without control characters, and tables with one line for each row."""

from __future__ import annotations

import functools
import os
import re
import sys
from collections.abc import Callable, Collection, Iterable, Sequence
from typing import TYPE_CHECKING, Any, Concatenate, NamedTuple, ParamSpec, TextIO, cast

import click

Parameters = ParamSpec("Parameters")


if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table


_COLOUR = "(?:[0-79]|2[1-9]|3[1-69]|9[1-6])"
_COLOURS = rf"\x1b\[(?:{_COLOUR}(?:;{_COLOUR})*)?m"
"""Colours as click and rich write them. No such sequence hides text or moves the cursor."""

_CONTROL = re.compile(
    f"({_COLOURS})"
    r"|\x1b\[[0-?]*[ -/]*[@-~]"  # other sequences: https://ecma-international.org/publications-and-standards/standards/ecma-48/
    r"|\x1b[\]PX^_](?:[^\x07\x1b\n]*(?:\x07|\x1b\\))?"  # commands to the terminal, such as one that sets the clipboard
    r"|\x1b[ -/]*[0-~]?"
    r"|[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff]"
)
"""Characters that are commands to a terminal, change the order of others, or are invisible."""

_COMMAND = re.compile(r"^([^\S\n]*):(?=:[\w-]+)|(?<=#)#(?=\[)", re.MULTILINE)
"""Commands to GitHub in the output of a step: https://docs.github.com/actions/reference/workflows-and-actions/workflow-commands.
GitHub trims a line before it looks for `::`, and finds `##[` anywhere."""


def shown(text: str) -> str:
    """A text from outside that is safe to print: without commands to the terminal or to CI."""
    text = _CONTROL.sub(r"\1", text)
    if (":" in text or "#" in text) and os.environ.get("GITHUB_ACTIONS") == "true":
        text = _COMMAND.sub(lambda match: f"{match[1]}: " if match[1] is not None else " #", text)
    return text


def line(text: str) -> str:
    """A text from outside as one line. With more lines, it could look as if the command said them."""
    return " ".join(text.split())


def echo(text: str = "", err: bool = False, nl: bool = True) -> None:
    """Prints a text on standard output or standard error. All commands print by this, since much text comes from outside."""
    click.echo(shown(text), err=err, nl=nl)


class _Shown:
    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        return self._stream.write(shown(text))

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


def table(
    *columns: str, right: Collection[str] = (), wrapped: Collection[str] = (), whole: Collection[str] = ()
) -> Table:
    """Cells of the columns `wrapped` may take several lines; those of `whole` are never cut, however narrow the terminal is."""
    from rich.table import Table  # slow to import, and only needed here

    new = Table(box=None, header_style="bold", pad_edge=False)
    for column in columns:
        new.add_column(
            column,
            justify="right" if column in right else "left",
            overflow="fold" if column in wrapped else "ignore" if column in whole else "ellipsis",
            no_wrap=column not in wrapped,
        )
    return new


def console() -> Console:
    """The console for tables. A row is one line, also if the output has no width. Text may have brackets, which are no markup."""
    from rich.console import Console  # slow to import, and only needed here

    class Output(Console):
        def on_broken_pipe(self) -> None:
            """Raises BrokenPipeError, which `command.run` handles: if the reader stops early, that is no failure."""
            raise BrokenPipeError

    as_it_is = functools.partial(Output, highlight=False, markup=False, emoji=False)
    file = cast(TextIO, _Shown(sys.stdout))
    return as_it_is(file=file, soft_wrap=True) if sys.stdout.isatty() else as_it_is(file=file, width=WIDTH)


class Styled(NamedTuple):
    """A cell in a style of rich, such as `dim`."""

    text: str
    style: str


Cell = str | Styled

WIDTH = 400
"""The width of output that is no terminal, in characters."""


def _text(cell: Cell) -> str:
    return cell.text if isinstance(cell, Styled) else cell


def _plain() -> bool:
    """Whether the output has neither a width nor colours, so that it needs no rich."""
    forced = any(os.environ.get(name) for name in ("FORCE_COLOR", "TTY_COMPATIBLE"))
    return not sys.stdout.isatty() and not forced


def width() -> int:
    return WIDTH if _plain() else console().width


def say(text: str, style: str) -> None:
    """Prints a line in a style of rich. Where nothing has a style, rich is not imported."""
    if _plain() and len(text) <= WIDTH and _is_simple(text):
        echo(text)
    else:
        console().print(text, style=style)


def widths(columns: Sequence[str], rows: Iterable[Sequence[Cell]]) -> list[int]:
    return [max(len(_text(cell)) for cell in cells) for cells in zip(columns, *rows, strict=True)]


def show_rows(
    columns: Sequence[str],
    rows: Sequence[Sequence[Cell]],
    right: Collection[str] = (),
    wrapped: Collection[str] = (),
    whole: Collection[str] = (),
) -> None:
    """Prints a table. rich takes a millisecond for each row, so it draws only rows with a style, and tables that are wider than a line."""
    wide = widths(columns, rows)
    if sum(wide) + 2 * (len(wide) - 1) > width() or not all(_is_simple(_text(cell)) for row in rows for cell in row):
        echo("".join(_drawn(table(*columns, right=right, wrapped=wrapped, whole=whole), rows)), nl=False)
        return

    aligned = [str.rjust if name in right and name not in whole else str.ljust for name in columns]  # as rich does

    def joined(row: Sequence[Cell]) -> str:
        cells = (align(_text(cell), number) for align, cell, number in zip(aligned, row, wide, strict=True))
        return "  ".join(cells).rstrip(" ") + "\n"

    if _plain():
        echo("".join(map(joined, (columns, *rows))), nl=False)
        return
    styled = [row for row in rows if any(isinstance(cell, Styled) for cell in row)]
    widest = ["x" * number for number in wide]  # a row that gives the columns their widths
    head, _, *others = _drawn(table(*columns, right=right, wrapped=wrapped, whole=whole), [widest, *styled])
    drawn = dict(zip(map(id, styled), others, strict=True))
    echo("".join([head, *(drawn.get(id(row)) or joined(row) for row in rows)]), nl=False)


def _is_simple(text: str) -> bool:
    """Whether each character takes one column, and none is a command."""
    return text.isascii() and text.isprintable()


def _drawn(empty: Table, rows: Iterable[Sequence[Cell]]) -> list[str]:
    from rich.text import Text  # slow to import, and only needed here

    for row in rows:
        empty.add_row(*(Text(*cell) if isinstance(cell, Styled) else cell for cell in row))
    return _lines(empty).splitlines(keepends=True)


def show(table: Table) -> None:
    echo(_lines(table), nl=False)


def _lines(table: Table) -> str:
    """As rich draws it, without spaces at the ends of lines."""
    out = console()
    for column in table.columns:
        if column.overflow == "ignore":
            column.min_width = max(out.measure(cell).maximum for cell in column.cells)
    with out.capture() as captured:
        out.print(table)
    return _PADDING.sub(r"\1", captured.get())


_PADDING = re.compile(r" +((?:\x1b\[[0-9;]*m)*)$", re.MULTILINE)
"""Spaces at the end of a line, with the codes after them that end a colour."""


def obeying_no_color(
    function: Callable[Concatenate[click.Command, Parameters], int],
) -> Callable[Concatenate[click.Command, Parameters], int]:
    """Decorates a function that runs a command. rich, which prints tables, knows https://no-color.org; click only checks for a terminal."""

    @functools.wraps(function)
    def run(main: click.Command, /, *arguments: Parameters.args, **options: Parameters.kwargs) -> int:
        if not os.environ.get("NO_COLOR"):
            return function(main, *arguments, **options)
        before = main.context_settings
        main.context_settings = {**before, "color": False}  # for the command's output
        try:
            with click.Context(main, color=False):  # for the message if it fails
                return function(main, *arguments, **options)
        finally:
            main.context_settings = before

    return run
