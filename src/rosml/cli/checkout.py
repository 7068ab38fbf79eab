"""What a command needs before it begins: a checkout, or none; and what is said where it belongs to another user."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from rosml import FOREIGN, IN_CHECKOUT, ROOT
from rosml.base.errors import RosmlError
from rosml.cli import command

SETTINGS = {"help_option_names": ["-h", "--help"]}


class Command(click.Command):
    """A command of `rosml`.

    Attributes:
        alone: it needs no checkout. prints: it does nothing but print, so that whoever reads it may stop.
        kept: what is said after Ctrl-C. before: what is called before it begins.
        failure: the exit code of every error; 0 for that of `command.run`.
    """

    failure = 0

    def __init__(
        self,
        *arguments: Any,
        alone: bool = False,
        prints: bool = False,
        kept: str = command.INTERRUPTED_TEXT,
        before: Sequence[Callable[[], None]] = (),
        **options: Any,
    ) -> None:
        super().__init__(*arguments, **{"context_settings": SETTINGS, **options})
        self.alone, self.prints, self.kept, self.before = alone, prints, kept, before

    def invoke(self, ctx: click.Context) -> Any:
        if not self.alone:
            require()
        _say_whose_matrix(ctx)
        for check in self.before:
            check()
        return super().invoke(ctx)


class Group(click.Group):
    """A group of such commands.

    Attributes:
        kept: what is said after Ctrl-C, for all of them. elsewhere: words that people look for here, and where they are.
    """

    command_class = Command
    prints = False
    failure = 0

    def __init__(
        self,
        *arguments: Any,
        kept: str = command.INTERRUPTED_TEXT,
        elsewhere: Mapping[str, str] | None = None,
        **options: Any,
    ) -> None:
        super().__init__(*arguments, **{"context_settings": SETTINGS, **options})
        self.kept, self.elsewhere = kept, elsewhere or {}

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args and args[0] in self.elsewhere:
            raise click.UsageError(f"No such command '{args[0]}'. It is: {self.elsewhere[args[0]]}", ctx)
        return super().resolve_command(ctx, args)


def require() -> None:
    """Says that a command needs a checkout, where there is none.

    Raises:
        RosmlError: there is none, or it belongs to another user.
    """
    if not IN_CHECKOUT and FOREIGN:
        raise RosmlError(*_foreign(FOREIGN), exit_code=2)
    if not IN_CHECKOUT:
        text = "not in a checkout: no matrix.yaml, Dockerfile and scripts/bootstrap.py here or above"
        raise RosmlError(text, "git clone the project, or your fork of it, and call it there", exit_code=2)


def _foreign(folder: Path) -> tuple[str, str]:
    """Why a checkout is not used, and what to do about it."""
    owner = folder.stat().st_uid
    text = f"the checkout {folder} is not used: it belongs to user {owner}, and not to you or root"
    return text, f"chown -R {os.geteuid()} {folder}, or call this as its owner"


def _say_whose_matrix(context: click.Context) -> None:
    """Says that the matrix is not that of the folder where somebody works, unless they named it."""
    if FOREIGN and context.get_parameter_source("matrix") is ParameterSource.DEFAULT:
        text, remedy = _foreign(FOREIGN)
        which = str(ROOT / "matrix.yaml") if IN_CHECKOUT else "the one that came with rosml"
        command.warn(f"{text}; the matrix is {which}", f"{remedy}; or name its matrix with --matrix")
