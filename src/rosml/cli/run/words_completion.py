"""Completion of `rosml run` and `rosml attach`: options of rosml and of the engine, images, containers, files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import suppress

import click
from click.shell_completion import CompletionItem

from rosml.base.errors import RosmlError
from rosml.run import attach, engine, paths, words

FILES = frozenset(("volume", "mount", "device", *paths.FILES))
ENTERS = "attach"


def items(command: click.Command, args: Sequence[str], incomplete: str) -> list[CompletionItem[str]]:
    """The completions of the last word after `args`; none if the words before it are wrong. The shell itself looks for files."""
    context, enters = click.Context(command), command.name == ENTERS
    options = {x.opts[0]: x for x in command.get_params(context) if isinstance(x, click.Option)}
    with_value = {name: option for name, option in options.items() if not option.is_flag}
    files = [CompletionItem(incomplete, type="file")]
    try:
        line = words.split(args, options, with_value)
    except RosmlError:
        if option := with_value.get(args[-1]):
            return option.shell_complete(context, incomplete)
        with suppress(RosmlError):  # an option of the engine waits for its value
            return files if words.split([*args, "value"], options).engine[-1].names[-1] in FILES else []
        return []
    if line.image:
        return files
    if incomplete.startswith("--") and "=" in incomplete:
        name, _, value = incomplete.partition("=")
        if option := with_value.get(name):
            return [CompletionItem(f"{name}={x.value}") for x in option.shell_complete(context, value)]
        return [CompletionItem(value, type="file")] if name.removeprefix("--") in FILES else []
    if incomplete.startswith("-"):
        engine_options = attach.PASSED if enters else words.table().names
        helps = {**{name: option.help for name, option in options.items()}}
        helps |= {f"--{name}": None for name in sorted(engine_options)}
        return [CompletionItem(name, help=text) for name, text in helps.items() if name.startswith(incomplete)]
    try:
        program = engine.program(os.environ)
    except RosmlError:
        return []
    names = engine.container_names(program) if enters else engine.image_names(program)
    return [CompletionItem(name) for name in sorted(names) if name.startswith(incomplete)]
