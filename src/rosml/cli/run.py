"""`rosml run`: starts an image, by docker or podman."""

from __future__ import annotations

import json
import os
import shlex
import signal
from collections.abc import Sequence
from typing import Any, NoReturn

import click

from rosml.base.errors import RosmlError
from rosml.cli.checkout import Command
from rosml.run import words

LINE = "rosml.run.line"
"""Where the context has the command line, as it was split."""


class Run(Command):
    """A command of which click reads its own options and the image alone."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        return super().parse_args(ctx, self.for_click(ctx, args))

    def for_click(self, ctx: click.Context, args: Sequence[str]) -> list[str]:
        """The words that click reads. The whole line is in the context then.

        Raises:
            RosmlError: an option of the engine is unknown, or lacks its value; not while a shell completes a word.
        """
        own = [name for parameter in self.get_params(ctx) for name in parameter.opts if name.startswith("--")]
        try:
            line = words.split(args, own)
        except RosmlError:
            if not ctx.resilient_parsing:
                raise
            return [*args]
        ctx.meta[LINE] = line
        return [*line.own, *([line.image, *line.command] if line.image else [])]


@click.command(
    "run",
    cls=Run,
    alone=True,
    # -h is the engines' own: the container's host name
    context_settings={"allow_interspersed_args": False, "help_option_names": ["--help"]},
    options_metavar="[OPTIONS OF ROSML, DOCKER OR PODMAN]",
)
@click.option("--no-name", is_flag=True, help="do not name the container after the current folder")
@click.option("--no-rm", is_flag=True, help="keep the container when it ends")
@click.option("--no-it", is_flag=True, help="neither a terminal nor standard input")
@click.option("--no-tz", is_flag=True, help="not your time zone")
@click.option("--no-user", is_flag=True, help="the image's own user, and not you")
@click.option("--no-gpu", is_flag=True, help="no GPUs, which rosml does not add yet: --gpus all does")
@click.option("--no-x11", is_flag=True, help="no windows, which rosml does not add yet")
@click.option("--loc", is_flag=True, help="your locale, which the image must have")
@click.option("--mwd", is_flag=True, help="mount the current folder at its own path, and begin there")
@click.option("--mws", is_flag=True, help="mount the current folder as $WORKSPACE/src/target")
@click.option("--verbose", is_flag=True, help="print the engine's command on standard error, then run it")
@click.option("--dry-run", is_flag=True, help="print the engine's command, and run nothing")
@click.option("--json", "as_json", is_flag=True, help="print its words as JSON, and run nothing")
@click.argument("image", expose_value=False)
@click.argument("command", nargs=-1, type=click.UNPROCESSED, expose_value=False)
@click.pass_context
def main(context: click.Context, /, **options: Any) -> None:
    """Starts a container of an image: as you, with your time zone, on your terminal, and removed when it ends.

    The first word that is no option is the image. What follows it is the command, and reaches the container as it is. All
    options of `docker run` and `podman run` go to the engine, such as -v, -e, --name and --gpus.

    The engine is docker, or podman where there is no docker; ROSML_ENGINE names one. Exit codes are the command's.

    \b
    Examples:
      rosml run ghcr.io/me/rosml/ros:jazzy-base
      rosml run --mws ghcr.io/me/rosml/ros:jazzy-base colcon build
      rosml run -e ROS_DOMAIN_ID=7 -v ./bags:/bags IMAGE ros2 bag play /bags/first
      rosml run --dry-run IMAGE
    """
    line: words.Line = context.meta[LINE]
    shown = {name: options.pop(name) for name in ("verbose", "dry_run", "as_json")}
    only_shown = shown["dry_run"] or shown["as_json"]
    argv = planned(line, options, only_shown)
    if shown["as_json"]:
        click.echo(json.dumps(argv))
    elif only_shown:
        click.echo(shlex.join(argv))
    else:
        if shown["verbose"]:
            click.echo(shlex.join(argv), err=True)
        become(argv)


def planned(line: words.Line, options: dict[str, bool], only_shown: bool) -> list[str]:
    """The engine's command; an image that is not there is pulled, unless the command is only shown.

    Raises:
        RosmlError: there is no engine, or no such image, or the container's name is taken, or the image has no workspace.
    """
    from rosml.run import concerns, engine
    from rosml.run.context import Context, Engine, Flags
    from rosml.run.person import person

    flags = Flags(**{name: value for name, value in options.items() if name not in ("no_gpu", "no_x11")})
    caller = person(os.environ)
    program = engine.program(os.environ)
    name = concerns.name_of(Context(line, flags, Engine(program), caller, {}))
    facts = engine.ask(program, line.image, "" if only_shown or line.has("replace") else name)
    if facts.taken:
        raise engine.taken(program, name, facts.taken)
    if facts.image is None:
        if only_shown:
            raise engine.lacking(program, line.image)
        engine.pull(program, line)
        facts = engine.ask(program, line.image, "")
    if facts.image is None:
        raise engine.lacking(program, line.image)
    return concerns.argv(Context(line, flags, facts.engine, caller, facts.image))


def become(argv: list[str]) -> NoReturn:
    """Becomes the engine: it has the terminal, the signals and the exit code."""
    for number in (signal.SIGPIPE, signal.SIGXFSZ):  # Python ignores them, and what is ignored stays so
        signal.signal(number, signal.SIG_DFL)
    os.execvp(argv[0], argv)
