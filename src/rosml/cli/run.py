"""`rosml run`: starts an image, by docker or podman."""

from __future__ import annotations

import os
from collections.abc import Callable

import click

from rosml.base.errors import RosmlError
from rosml.cli import container
from rosml.run import words
from rosml.run.context import Person


def asked(name: str, text: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Adds an option of rosml's own; the line says whether somebody wrote it."""
    return click.option(name, is_flag=True, expose_value=False, help=text)


@click.command(
    "run",
    cls=container.Words,
    alone=True,
    context_settings=container.SETTINGS,
    options_metavar="[OPTIONS OF ROSML, DOCKER OR PODMAN]",
)
@asked("--new", "another container, also where one of this folder runs; the engine names it")
@asked("--no-name", "do not name the container after the current folder")
@asked("--no-rm", "keep the container when it ends")
@asked("--no-it", "neither a terminal nor standard input")
@asked("--no-tz", "not your time zone")
@asked("--no-user", "the image's own user, and not you")
@asked("--no-gpu", "no GPUs, which rosml does not add yet: --gpus all does")
@asked("--no-x11", "no windows, which rosml does not add yet")
@asked("--loc", "your locale, which the image must have")
@asked("--mwd", "mount the current folder at its own path, and begin there")
@asked("--mws", "mount the current folder as $WORKSPACE/src/target")
@container.showing
@click.argument("image", required=False, expose_value=False)
@click.argument("command", nargs=-1, type=click.UNPROCESSED, expose_value=False)
@click.pass_context
def main(context: click.Context, /) -> None:
    """Starts a container of an image: as you, with your time zone, on your terminal, and removed when it ends.

    The first word that is no option is the image. What follows it is the command, and reaches the container as it is. All
    options of `docker run` and `podman run` go to the engine, such as -v, -e, --name and --gpus.

    In a folder whose container runs, the same call opens another shell in it, as does a call without an image.

    The engine is docker, or podman where there is no docker; ROSML_ENGINE names one. Exit codes are the command's.

    \b
    Examples:
      rosml run ghcr.io/me/rosml/ros:jazzy-base
      rosml run --mws ghcr.io/me/rosml/ros:jazzy-base colcon build
      rosml run -e ROS_DOMAIN_ID=7 -v ./bags:/bags IMAGE ros2 bag play /bags/first
      rosml run --dry-run IMAGE
      rosml run
    """
    from rosml.run import engine
    from rosml.run.person import person

    line: words.Line = context.meta[container.LINE]
    if not line.image:
        if line.asks("new"):
            raise RosmlError("--new starts an image, and none is named", "rosml run --new IMAGE", exit_code=2)
        container.enter_folder(line, "rosml run without an image")
        return
    start(engine.program(os.environ), line, person(os.environ))


def start(program: str, line: words.Line, caller: Person) -> None:
    """Starts an image, or shows how. One that is not there is pulled, unless the command is only shown. Where it runs for this
    folder already, enters that container.

    Args:
        program: the engine's command.

    Raises:
        RosmlError: there is no such image, or another container has the name, or the image has no workspace.
    """
    from rosml.run import attach, concerns, engine
    from rosml.run.context import Context

    name = "" if line.has("replace") else concerns.name_of(line, caller)
    facts = engine.ask(program, line.image, name)
    if facts.taken:
        attach.check_same(program, line, caller, facts.taken, facts.image)
        container.enter(program, line, caller, facts.taken)
        return
    if facts.image is None:
        if container.only_shown(line):
            raise engine.lacking(program, line.image)
        engine.pull(program, line)
        facts = engine.ask(program, line.image, "")
    if facts.image is None:
        raise engine.lacking(program, line.image)
    container.perform(line, concerns.argv(Context(line, facts.engine, caller, facts.image)))
