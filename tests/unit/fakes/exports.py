"""Calls of `rosml run --export`, as somebody makes them on a machine with nothing."""

from __future__ import annotations

from typing import Any

import click

from fakes.desks import BARE, OTHER, OURS
from rosml.cli.run import run
from rosml.cli.run.export import KINDS
from rosml.run.context import Context, Engine, Host, Image, Person
from rosml.run.exports.description import Call, describe
from rosml.run.plan import make_plan
from rosml.run.words import split

ME = Person(1234, 5678, "jo", "/home/jo/robot", "Europe/Berlin")
ROSML_OPTIONS = [
    name for option in run.main.get_params(click.Context(run.main)) for name in option.opts if name.startswith("--")
]
DOCKER, ROOTLESS = Engine(), Engine(rootless=True)
PODMAN = Engine("podman", podman=True, rootless=True)


def call(
    *line: str,
    kind: str = "compose",
    ours: bool = True,
    engine: Engine = DOCKER,
    host: Host = BARE,
    trusted: bool = True,
    person: Person = ME,
    place: str = "",
    **facts: Any,
) -> Call:
    """The described call of a command line that has an image. `facts` are those of the image."""
    variables = dict(entry.partition("=")[::2] for entry in (OURS if ours else OTHER))
    image = Image(**{"environment": variables, "command": ("bash",), **facts})
    context = KINDS[kind].seen(Context(split(line, ROSML_OPTIONS), engine, person, image, host, trusted))
    context = KINDS[kind].settled(context)
    return describe(context, make_plan(context).argv, place)


def text(*line: str, kind: str, **facts: Any) -> str:
    """The file of a command line that has an image."""
    return KINDS[kind].text(call(*line, kind=kind, **facts))
