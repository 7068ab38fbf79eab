"""The workflows as they are written, and whether a command takes the options that it is called with."""

from __future__ import annotations

from typing import Any

import click
import yaml
from conftest import ROOT

from rosml.cli.run.container import Words

FOLDER = ROOT / ".github/workflows"


def text(name: str) -> str:
    return (FOLDER / f"{name}.yml").read_text()


def load(name: str) -> dict[str, Any]:
    content: dict[str, Any] = yaml.safe_load(text(name))
    return content


def accepted(command: click.Command, arguments: list[str]) -> None:
    """Has click's own parser read a command line; nothing is checked for being there, and nothing runs."""
    if isinstance(command, click.Group):
        if not arguments and command.invoke_without_command:
            return None
        assert arguments[0] in command.commands, f"no command {arguments[0]}"
        return accepted(command.commands[arguments[0]], arguments[1:])
    context = click.Context(command, **command.context_settings)
    if isinstance(command, Words):
        arguments = command.for_click(context, arguments)
    _, rest, _ = command.make_parser(context).parse_args(list(arguments))
    assert not rest, f"unexpected words: {' '.join(rest)}"
    return None
