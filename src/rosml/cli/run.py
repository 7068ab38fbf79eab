"""`rosml run`: starts an image, by docker or podman."""

from __future__ import annotations

import os
from functools import cache

import click

from rosml.base.errors import RosmlError
from rosml.cli import command, container
from rosml.run import plugins, words
from rosml.run.context import Context, Person

RESERVED = ("new", "check", "verbose", "dry-run", "json", "export", "help")
"""Options of the command itself: no plugin can have one of these names."""


@cache
def found() -> plugins.Found:
    """The plugins; they are looked for once."""
    return plugins.found(RESERVED)


class Run(container.Words):
    """A command that has the options of plugins as well."""

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        """The command's own options, with those of the plugins after the first."""
        first, *others = super().get_params(ctx)
        options = {name: text for plugin in found().plugins for name, text in plugin.options.items()}
        added = (click.Option([f"--{x}"], is_flag=True, expose_value=False, help=options[x]) for x in options)
        return [first, *added, *others]


@click.command(
    "run",
    cls=Run,
    alone=True,
    context_settings=container.SETTINGS,
    options_metavar="[OPTIONS OF ROSML, DOCKER OR PODMAN]",
)
@click.option(
    "--new", is_flag=True, expose_value=False, help="another container, although one runs; the engine names it"
)
@click.option(
    "--check",
    is_flag=True,
    expose_value=False,
    help="say what keeps nodes of ROS apart from others, and start no command",
)
@container.showing
@click.option(
    "--export",
    metavar="FORMAT",
    type=click.Choice(["devcontainer", "compose"]),
    help="print a file for editors (devcontainer) or for docker compose (compose), and run nothing",
)
@click.argument("image", required=False, expose_value=False)
@click.argument("command", nargs=-1, type=click.UNPROCESSED, expose_value=False)
@click.pass_context
def main(context: click.Context, /, export: str | None) -> None:
    """Starts a container of an image: as you, on your terminal, with your time zone, your GPUs and your display. It is removed
    when it ends.

    The first word that is no option is the image. What follows it is the command, and reaches the container as it is. All
    options of `docker run` and `podman run` go to the engine, such as -v, -e, --name and -p.

    In a folder whose container runs, the same call opens another shell in it, as does a call without an image.

    The engine is docker, or podman where there is no docker; ROSML_ENGINE names one. Exit codes are the command's.

    \b
    Examples:
      rosml run ghcr.io/me/rosml/ros:jazzy-base
      rosml run --mws ghcr.io/me/rosml/ros:jazzy-base colcon build
      rosml run -e ROS_DOMAIN_ID=7 -v ./bags:/bags IMAGE ros2 bag play /bags/first
      rosml run --ros-network IMAGE ros2 topic list
      rosml run --check --ros-network IMAGE
      rosml run --dry-run IMAGE
      rosml run --export compose IMAGE >compose.yaml
      rosml run
    """
    from rosml.run import engine
    from rosml.run.person import person

    line: words.Line = context.meta[container.LINE]
    if not line.image:
        if line.asks("new"):
            raise RosmlError("--new starts an image, and none is named", "rosml run --new IMAGE", exit_code=2)
        if line.asks("check"):
            raise RosmlError("--check is about an image, and none is named", "rosml run --check IMAGE", exit_code=2)
        if export:
            raise RosmlError("--export needs an image", f"rosml run --export {export} IMAGE", exit_code=2)
        enter(line)
        return
    if export:
        show(engine.program(os.environ), line, person(os.environ), export)
        return
    start(engine.program(os.environ), line, person(os.environ))


def enter(line: words.Line) -> None:
    """Enters the container of the current folder, as no image is named. An option may have taken the image as its value.

    Raises:
        RosmlError: there is none, or there are several, or it cannot be entered.
    """
    from rosml.run import attach

    remedy = "write the image after it: rosml run … IMAGE"
    if line.taken and not set(line.engine[-1].names) <= attach.PASSED:
        raise RosmlError(f"no image is named: {line.taken}", remedy, exit_code=2)
    try:
        container.enter_folder(line, "rosml run without an image")
    except RosmlError as error:
        if line.taken and error.exit_code == 2:
            error.remedy += f"; {line.taken}: if it is the image, {remedy}"
        raise


def start(program: str, line: words.Line, caller: Person) -> None:
    """Starts an image, or shows how. One that is not there is pulled, unless the command is only shown. Where it runs for this
    folder already, enters that container.

    Args:
        program: the engine's command.

    Raises:
        RosmlError: there is no such image, or another container has the name, or the image has no workspace.
    """
    from rosml.run import attach, concerns, engine
    from rosml.run.host import host, write

    checks = line.asks("check")
    name = "" if checks or line.has("replace") else concerns.name_of(line, caller)
    facts = engine.ask(program, line.image, name)
    if facts.taken:
        attach.check_same(program, line, caller, facts.taken, facts.image)
        container.enter(program, line, caller, facts.taken)
        return
    if facts.image is None:
        if checks or container.only_shown(line):
            raise engine.lacking(program, line.image)
        engine.pull(program, line)
        facts = engine.ask(program, line.image, "")
    if facts.image is None:
        raise engine.still_lacking(program, line.image)
    machine = host(os.environ)
    known = Context(line, facts.engine, caller, facts.image, machine)
    if checks:
        from rosml.cli import check

        check.show(known, plugins.plan(known, found().plugins).argv)
        return
    plan = planned(known)

    def prepare() -> None:
        for file, content in plan.files.items():
            write(machine.path(file), content)

    container.perform(line, plan.argv, prepare)


def planned(context: Context) -> plugins.Plan:
    """What the plugins add; what people should know is said."""
    plan = plugins.plan(context, found().plugins)
    for text, remedy in (*found().notes, *plan.notes):
        command.warn(text, remedy)
    return plan


def show(program: str, line: words.Line, caller: Person, kind: str) -> None:
    """Shows what would run, as a file.

    Args:
        program: the engine's command. kind: of file.

    Raises:
        RosmlError: the engine does not have the image, or such a file cannot say that.
    """
    from rosml.run import compose, devcontainer, engine, export
    from rosml.run.host import host

    facts = engine.ask(program, line.image, "")
    if facts.image is None:
        raise engine.lacking(program, line.image)
    context = export.lasting(Context(line, facts.engine, caller, facts.image, host(os.environ)))
    if kind == "devcontainer":
        context = devcontainer.bare(context)
    plan = planned(context)
    for file in plan.files:
        command.warn(f"the export does not make {file}", "rosml run makes it whenever it starts a container")
    call = export.call(context, plan.argv)
    text = devcontainer.text(call) if kind == "devcontainer" else compose.text(call)
    with container.printing():
        click.echo(text, nl=False)
