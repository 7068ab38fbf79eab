"""`rosml attach`: enters a container with docker or podman."""

from __future__ import annotations

import os

import click

from rosml.base.errors import RosmlError
from rosml.cli.run import container
from rosml.run import host, words


@click.command(
    "attach",
    short_help="Opens another shell in a container that runs.",
    cls=container.Words,
    alone=True,
    context_settings=container.SETTINGS,
    options_metavar="[OPTIONS]",
)
@container.flag("--no-it", "neither a terminal nor standard input")
@container.showing
@click.argument("name", required=False, expose_value=False)
@click.argument("command", nargs=-1, type=click.UNPROCESSED, expose_value=False)
@click.pass_context
def main(context: click.Context, /) -> None:
    """Opens another shell in a container that runs: with ROS, and as the same user. Without NAME, it is the container that
    `rosml run` started in this folder. If the container has stopped, it starts again.

    The first word that is no option is the container's name, or a point for that of this folder. The words after it are the
    command, and reach the container unchanged. Options of `docker exec`, such as -e and --workdir, go to the engine.

    \b
    Examples:
      rosml attach
      rosml attach . ros2 topic list
      rosml attach robot htop
    """
    from rosml.run import engine

    line: words.Line = context.meta[container.LINE]
    if line.image in ("", words.HERE):
        container.enter_folder(line, "rosml attach")
        return
    program = container.engine_program()
    entered = engine.container(program, line.image)
    if entered is None:
        remedy = f"{program} ps --all lists them; rosml attach . COMMAND runs a command in the container of this folder"
        raise RosmlError(f"no container named {line.image}", remedy)
    container.enter(program, line, host.person(os.environ), entered)
