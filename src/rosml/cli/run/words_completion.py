"""Completion of `rosml run` and `rosml attach`: options of rosml and of the engine, images, containers, files."""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence

import click
from click.shell_completion import CompletionItem

from rosml.base.errors import RosmlError
from rosml.run import attach, engine, paths, words

FILES = frozenset(("volume", "mount", "device", *paths.FILES))
ENTERS = "attach"


def items(command: click.Command, args: Sequence[str], incomplete: str) -> list[CompletionItem[str]]:
    """The completions of the last word after `args`; none if the words before it are wrong."""
    context = click.Context(command)
    options = {x.opts[0]: x for x in command.get_params(context) if isinstance(x, click.Option)}
    with_value = {name: option for name, option in options.items() if not option.is_flag}
    try:
        line = words.split(args, options, with_value)
    except RosmlError:
        if option := with_value.get(args[-1]):
            return option.shell_complete(context, incomplete)
        return _value(_waiting(args, options), incomplete)
    if line.image:
        return _file(incomplete)
    if incomplete.startswith("--") and "=" in incomplete:
        name, _, value = incomplete.partition("=")
        if option := with_value.get(name):
            return [CompletionItem(f"{name}={x.value}") for x in option.shell_complete(context, value)]
        return _value(name.removeprefix("--"), value)
    if incomplete.startswith("-"):
        engine_names = attach.PASSED if command.name == ENTERS else words.table().names
        helps = {name: option.help for name, option in options.items()} | {
            f"--{name}": None for name in sorted(engine_names)
        }
        return [CompletionItem(name, help=text) for name, text in helps.items() if name.startswith(incomplete)]
    return [CompletionItem(name) for name in _engine_names(command.name == ENTERS) if name.startswith(incomplete)]


def _waiting(args: Sequence[str], options: Collection[str]) -> str:
    """The option of the engine that waits for its value; empty if none does."""
    try:
        return words.split([*args, "value"], options).engine[-1].names[-1]
    except RosmlError:
        return ""


def _value(name: str, incomplete: str) -> list[CompletionItem[str]]:
    return _file(incomplete) if name in FILES else []


def _file(incomplete: str) -> list[CompletionItem[str]]:
    """Lets the shell look for files."""
    return [CompletionItem(incomplete, type="file")]


def _engine_names(containers: bool) -> list[str]:
    """The engine's containers or images; none if there is no engine, or it takes long."""
    try:
        program = engine.program(os.environ)
    except RosmlError:
        return []
    return sorted(engine.container_names(program) if containers else engine.image_names(program))
