"""Commands and groups of `rosml`, and the checkout that most of them need."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from rosml import IN_CHECKOUT
from rosml.base.errors import RosmlError
from rosml.cli import command

PARTS = ("matrix.yaml", "Dockerfile", "components", "scripts/bootstrap.py", "rosml")

SETTINGS = {"help_option_names": ["-h", "--help"]}


def _extra_words(command: click.Command) -> str:
    """What to do about words that a command does not take; empty if it has no such option."""
    options = {option for parameter in command.params for option in parameter.opts}
    places = {"--only": "names of images stand after --only", "--registry": "a registry stands after --registry"}
    return ", and ".join(text for option, text in places.items() if option in options)


_MACHINES = ("--platform", "--architecture", "--arch")


class Command(click.Command):
    """A command of `rosml`."""

    failure = 0  # the exit code of every error; 0 for those of `command.run`

    def __init__(
        self,
        *arguments: Any,
        alone: bool = False,  # it needs no checkout
        prints: bool = False,  # it only prints, so its reader may stop early
        kept: str = command.INTERRUPTED_TEXT,
        before: Sequence[Callable[[], None]] = (),  # functions to call first
        extra: str = "",  # what to do if there are more words than it takes
        **options: Any,
    ) -> None:
        super().__init__(*arguments, **{"context_settings": SETTINGS, **options})
        self.alone, self.prints, self.kept, self.before = alone, prints, kept, before
        self.extra = extra or _extra_words(self)

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        try:
            return super().parse_args(ctx, args)
        except click.NoSuchOption as error:
            options = {option for parameter in self.params for option in parameter.opts}
            if error.option_name in _MACHINES and (same := [name for name in _MACHINES if name in options]):
                raise click.UsageError(f"{error.message} It is {same[0]} here.", ctx) from error
            raise
        except click.UsageError as error:
            if type(error) is click.UsageError and self.extra:  # the others are about an option or a missing word
                raise click.UsageError(f"{error.message}: {self.extra}.", ctx) from error
            raise

    def invoke(self, ctx: click.Context) -> Any:
        if not self.alone:
            require()
        _say_whose_matrix(ctx)
        for check in self.before:
            check()
        return super().invoke(ctx)


class Group(click.Group):
    """A group of such commands."""

    command_class = Command
    prints = False
    failure = 0

    def __init__(
        self,
        *arguments: Any,
        kept: str = command.INTERRUPTED_TEXT,
        elsewhere: Mapping[str, str] | None = None,  # the right command for each word that people may try here
        sections: Mapping[str, Iterable[str]] | None = None,  # the names of commands, by their title in --help
        **options: Any,
    ) -> None:
        super().__init__(*arguments, **{"context_settings": SETTINGS, **options})
        self.kept, self.elsewhere, self.sections = kept, elsewhere or {}, sections

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        try:
            return super().parse_args(ctx, args)
        except click.NoSuchOption as error:
            from difflib import get_close_matches  # only needed when something is wrong

            if near := get_close_matches(error.option_name, error.possibilities or (), cutoff=0.75):
                raise click.NoSuchOption(error.option_name, possibilities=near, ctx=ctx) from error
            raise click.UsageError(f"{error.message} Options of a command stand after it.", ctx) from error

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args and args[0] in self.elsewhere:
            raise click.UsageError(f"No such command '{args[0]}'. It is: {self.elsewhere[args[0]]}", ctx)
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        visible = {name: command for name, command in sorted(self.commands.items()) if not command.hidden}
        width = max(map(len, visible), default=0)
        for title, names in (self.sections or {"Commands": visible}).items():
            if rows := [(name.ljust(width), sentence(visible[name])) for name in names if name in visible]:
                with formatter.section(title):
                    formatter.write_dl(rows)


def sentence(command: click.Command) -> str:
    return command.get_short_help_str(limit=1_000)


def around() -> Path | None:
    """The nearest folder that looks like a checkout. It may be a stranger's, so we only name it."""
    try:
        here = Path.cwd()
    except OSError:  # it was removed, or we may not enter it
        return None
    return next((folder for folder in (here, *here.parents) if _is_checkout(folder)), None)


def _is_checkout(folder: Path) -> bool:
    try:
        return all((folder / name).exists() for name in PARTS)
    except OSError:
        return False


def own_command(folder: Path) -> str:
    """The remedy that names a checkout's own `rosml`."""
    return f"if you trust that checkout, call its own command: {shlex.quote(str(folder / 'rosml'))}"


def require() -> None:
    if IN_CHECKOUT:
        return
    if near := around():
        text = f"the installed rosml runs nothing of a folder that it finds: {near}"
        raise RosmlError(text, own_command(near), exit_code=2)
    text = "not in a checkout: no matrix.yaml, Dockerfile and scripts/bootstrap.py here or above"
    raise RosmlError(text, "git clone the project, or your fork of it, and call ./rosml there", exit_code=2)


def _say_whose_matrix(context: click.Context) -> None:
    """Warns if the matrix is not that of the checkout in the current folder, unless the user named one."""
    if IN_CHECKOUT or context.get_parameter_source("matrix") is not ParameterSource.DEFAULT:
        return
    if near := around():
        text = f"the matrix is the one that came with rosml, and not that of {near}"
        command.warn(text, f"{own_command(near)}; or name its matrix with --matrix")
