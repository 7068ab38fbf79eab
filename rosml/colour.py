"""Colour on a terminal only, and not where somebody does not want it."""

from __future__ import annotations

import functools
import os
from collections.abc import Callable
from typing import Concatenate, ParamSpec

import click

Given = ParamSpec("Given")


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
