"""How shells complete what people type: names of images and groups."""

from __future__ import annotations

import os

import click
from click.shell_completion import CompletionItem, shell_complete

from rosml import ROOT
from rosml.base.errors import RosmlError

VARIABLE = "_ROSML_COMPLETE"
"""How a shell asks, as click has it."""


class Name(click.ParamType[str]):
    """A name of one kind: of `targets`, `parts` or `groups`."""

    name = "name"

    def __init__(self, kind: str) -> None:
        self.kind = kind

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:
        """Names that begin so; none where the matrix cannot be read."""
        from rosml.images import load, selection

        try:
            images = load.load(ROOT / "matrix.yaml", ROOT)
        except RosmlError:
            return []
        groups = selection.groups_of(images)
        names = {"targets": [*images.by_target], "parts": [*images.part_by_name], "groups": groups}
        return [CompletionItem(name) for name in names[self.kind] if name.startswith(incomplete)]


def answer(cli: click.Command) -> int | None:
    """Answers a shell that asks; None where none does, or where what is set asks nothing."""
    asked = os.environ.get(VARIABLE, "")
    if not asked.endswith(("_source", "_complete")):
        return None
    try:
        return shell_complete(cli, {}, "rosml", VARIABLE, asked)
    except (KeyError, ValueError, IndexError):  # a shell that says too little
        return 1
