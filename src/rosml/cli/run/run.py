"""`rosml run`: starts an image with docker or podman."""

from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import click

from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.run import container, defaults, trust
from rosml.run import words
from rosml.run.context import Context, Person
from rosml.run.defaults import HERE, Files
from rosml.run.plugin import Plugin
from rosml.run.plugins import apply as plugins

if TYPE_CHECKING:
    from rosml.run import engine

RESERVED = ("new", "no-defaults", trust.OPTION, "check", "verbose", "dry-run", "json", "export", "add", "help")
"""The command's own options: no plugin may have one of these names, and no file with defaults may set one."""

IMAGE = 'write image = "…" into .rosml.toml'
"""The remedy that gives a folder an image."""


@cache
def found() -> plugins.Found:
    """The plugins, searched once."""
    return plugins.found(RESERVED)


class Run(container.Words):
    """A command with the options of plugins."""

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        """The command's own options, with those of the plugins after the first."""
        first, *others = super().get_params(ctx)
        options = {name: text for plugin in found().plugins for name, text in plugin.options.items()}
        added = (click.Option([f"--{x}"], is_flag=True, expose_value=False, help=options[x]) for x in options)
        return [first, *added, *others]


@click.command(
    "run",
    cls=Run,
    short_help="Starts a container of an image, as you and with your GPUs.",
    alone=True,
    context_settings=container.SETTINGS,
    options_metavar="[OPTIONS OF ROSML, DOCKER OR PODMAN]",
)
@click.option(
    "--new", is_flag=True, expose_value=False, help="start another container although one runs; the engine names it"
)
@click.option("--no-defaults", is_flag=True, expose_value=False, help="read neither .rosml.toml nor your own run.toml")
@click.option(
    f"--{trust.OPTION}",
    is_flag=True,
    expose_value=False,
    help="from now on, let images of this repository start as root, to make your user",
)
@container.showing
@click.option(
    "--check",
    is_flag=True,
    expose_value=False,
    help="say what keeps ROS nodes apart from others, and start no command",
)
@click.option(
    "--export",
    metavar="FORMAT",
    type=click.Choice(["devcontainer", "compose", "quadlet", "kubernetes"]),
    help="print a file for editors, for docker compose, for podman and systemd, or for a cluster, and run nothing",
)
@click.option(
    "--add",
    metavar="FILE",
    type=click.Path(),
    help="with --export compose: add the service to this file, and print nothing",
)
@click.argument("image", required=False, expose_value=False)
@click.argument("command", nargs=-1, type=click.UNPROCESSED, expose_value=False)
@click.pass_context
def main(context: click.Context, /, export: str | None, add: str | None) -> None:
    """Starts a container of an image: as you, on your terminal, with your time zone, your GPUs and your display. It is removed
    when it ends.

    The first word that is no option is the image. The words after it are the command, and reach the container unchanged. All
    options of `docker run` and `podman run` go to the engine, such as -v, -e, --name and -p.

    If the folder's container runs, the same call opens another shell in it; so does a call without an image.

    Defaults are in .rosml.toml of the project, and in ~/.config/rosml/run.toml. A point is the image that they name.

    The engine is docker, or podman if there is no docker; ROSML_ENGINE names one. The exit code is the command's, or 125 if
    nothing starts.

    \b
    Examples:
      rosml run ghcr.io/me/rosml/ros:jazzy-base
      rosml run --mws ghcr.io/me/rosml/ros:jazzy-base colcon build
      rosml run -e ROS_DOMAIN_ID=7 -v ./bags:/bags IMAGE ros2 bag play /bags/first
      rosml run --ros-network IMAGE ros2 topic list
      rosml run --check --ros-network IMAGE
      rosml run --dry-run IMAGE
      rosml run --export compose IMAGE >compose.yaml
      rosml run --export quadlet IMAGE ros2 launch PACKAGE FILE
      rosml run
      rosml run . colcon build
    """
    from rosml.run import attach, engine
    from rosml.run.person import person

    line: words.Line = context.meta[container.LINE]
    own, reserved = [f"--{name}" for plugin in found().plugins for name in plugin.options], [f"--{x}" for x in RESERVED]
    if line.late([*own, *reserved]):
        text = f"{line.command[0]} is the command in the container, since it stands after the image"
        command.warn(text, f"options come first: rosml run {line.command[0]} … {line.image}")
    user = line.value("user")
    if user.startswith("--") or "/" in user:  # rocker's --user takes no value
        remedy = "leave --user out: you are you in the container"
        raise RosmlError(f"--user takes a user, and {user} is none", remedy, exit_code=2)
    caller = person(os.environ)
    files = defaults.read(line, own, reserved, caller.folder)
    image = files.under(line).image
    if line.image == HERE and not image:
        raise RosmlError("no file names the image of this folder", f"rosml run IMAGE, or {IMAGE}", exit_code=2)
    asked = next((x for x in ("new", "check") if line.asks(x)), f"export {export}" if export else "")
    if asked and not image:
        text = f"--{asked.partition(' ')[0]} needs an image, and none is named"
        raise RosmlError(text, f"rosml run --{asked} IMAGE, or {IMAGE}", exit_code=2)
    if not line.image and not asked:
        try:
            enter(line, image)
            return
        except attach.NoContainer:
            if not image:
                raise
    if add is not None and export != "compose":
        raise RosmlError("--add goes with --export compose", "write both, or leave out --add", exit_code=2)
    program = engine.program(os.environ)
    if export:
        exported(program, line, caller, files, export, add)
    elif line.asks("check"):
        check_ros(program, line, caller, files)
    else:
        start(program, line, caller, files)


def enter(line: words.Line, image: str) -> None:
    """Enters the container of the current folder, as no image is typed. An option may have taken the image as its value.

    Args:
        image: the image that the files with defaults name; empty if they name none.

    Raises:
        RosmlError: the folder has no container or several, or it cannot be entered.
    """
    from rosml.run import attach

    remedy = "write the image after it: rosml run … IMAGE"
    if line.taken and not image and not set(line.engine[-1].names) <= attach.PASSED:
        if line.engine[-1].names[-1] == "name":  # docker-run enters a container so
            remedy += f"; to enter a container that is there: rosml attach {line.engine[-1].value}"
        raise RosmlError(f"no image is named: {line.taken}", remedy, exit_code=2)
    try:
        container.enter_folder(line, "rosml run without an image")
    except RosmlError as error:
        if line.taken and error.exit_code == 2:
            error.remedy += f"; {line.taken}: if it is the image, {remedy}"
        raise


def start(program: str, line: words.Line, caller: Person, files: Files) -> None:
    """Starts an image, or shows how. If the image is missing, it is pulled, unless the command is only shown. If it runs for
    this folder already, enters that container.

    Args:
        program: the engine's command.
        line: the command line as typed.
        files: the files with defaults. A container that runs has their options already.

    Raises:
        RosmlError: there is no such image, or another container has the name, or the image has no workspace, or a file of
            defaults wants what is not allowed.
    """
    from rosml.run import attach, engine
    from rosml.run.host import host
    from rosml.run.plugins import concerns

    if line.asks("verbose"):
        for text in files.said(line):
            terminal.echo(text, err=True)
    typed, line = line, files.under(line)
    named = line.image
    name = "" if line.has("replace") else concerns.name_of(line, caller)
    facts = engine.ask(program, line.image, name)
    line, facts = of_machine(program, line, caller, facts, name)
    if facts.taken:
        attach.check_same(program, line, caller, facts.taken, facts.image)
        container.enter(program, typed, caller, facts.taken)
        return
    defaults.require(typed, files.project)
    if facts.image is None and container.only_shown(line):
        raise engine.lacking(program, line.image)
    if facts.image is None and line.image == named:
        engine.pull(program, line)
        line, facts = of_machine(program, line, caller, engine.ask(program, line.image, ""), "")
    if facts.image is None and line.image != named:
        engine.pull(program, line)
        facts = engine.ask(program, line.image, "")
    if facts.image is None:
        raise engine.still_lacking(program, line.image)
    begin(Context(line, facts.engine, caller, facts.image, host(os.environ)))


def begin(context: Context, *more: Plugin) -> None:
    """Starts a container, or shows how.

    Args:
        more: plugins of the caller, after all others.

    Raises:
        RosmlError: a plugin cannot do what the user asks for.
    """
    from rosml.run.host import write

    plan, machine = planned(trust.settled(context), *more), context.host

    def prepare() -> None:
        for folder in plan.folders:
            if not machine.has(folder):
                with suppress(OSError):  # then the engine does what it can
                    machine.path(folder).mkdir(parents=True)
        for file, content in plan.files.items():
            write(machine.path(file), content)

    container.perform(context.line, plan.argv, prepare)


def of_machine(
    program: str, line: words.Line, caller: Person, facts: engine.Facts, name: str, elsewhere: bool = False
) -> tuple[words.Line, engine.Facts]:
    """The command line with the image for a machine, if the named one is there for several accelerators, and the facts about it.

    Args:
        facts: about the named image.
        name: the wanted name of a container, or an empty text.
        elsewhere: it is for another machine than this one.
    """
    from rosml.run import engine, variants
    from rosml.run.host import host

    if facts.image is None or variants.LABEL not in facts.image.labels:
        return line, facts
    context = Context(line, facts.engine, caller, facts.image, host(os.environ))
    other = variants.asked(context) if elsewhere else variants.chosen(context)
    if not other:
        return line, facts
    why = "what the call asks for" if elsewhere else "this machine"
    terminal.echo(f"rosml: {line.image} is there for several accelerators; {other} is the one for {why}", err=True)
    line = replace(line, image=other)
    return line, engine.ask(program, other, name)


def planned(context: Context, *more: Plugin) -> plugins.Plan:
    """The plan of all plugins, and of those of the caller. Prints their warnings."""
    plan = plugins.plan(context, (*found().plugins, *more))
    for text, remedy in (*found().notes, *plan.notes):
        command.warn(text, remedy)
    return plan


def looked_at(program: str, line: words.Line, caller: Person, elsewhere: bool = False) -> Context:
    """The context of an image that is not started.

    Args:
        program: the engine's command.
        elsewhere: it will start on another machine.

    Raises:
        RosmlError: the engine does not have the image.
    """
    from rosml.run import engine
    from rosml.run.host import host

    line, facts = of_machine(program, line, caller, engine.ask(program, line.image, ""), "", elsewhere)
    if facts.image is None:
        raise engine.lacking(program, line.image)
    return Context(line, facts.engine, caller, facts.image, host(os.environ))


def check_ros(program: str, line: words.Line, caller: Person, files: Files) -> None:
    """Shows what ROS in a container of the image depends on. If a project's file names the image, we look into it only after
    the user allows that.

    Args:
        program, line, files: as in `start`.

    Raises:
        RosmlError: the engine does not have the image, or it has no ROS.
    """
    from rosml.cli.run import check

    context = looked_at(program, files.under(line), caller)
    allowed = defaults.require(line, files.project)
    context, typed = trust.settled(context), line.image not in ("", HERE)
    check.show(context, plugins.plan(context, found().plugins).argv, into=typed or allowed)


def exported(program: str, line: words.Line, caller: Person, files: Files, kind: str, add: str | None) -> None:
    """Shows what would run, as a file; or adds it to one.

    Args:
        program, line, files: as in `start`.
        kind: the kind of file.
        add: the file to which the service is added.

    Raises:
        RosmlError: the engine does not have the image, or such a file cannot express the call, or another option shows
            something else.
    """
    from rosml.cli.run import export
    from rosml.run.plugins import gpu

    if other := next((x for x in ("check", "dry-run", "json") if line.asks(x)), ""):
        raise RosmlError(f"--export does not go with --{other}", "leave out one of them", exit_code=2)
    whole = files.under(line)
    if kind == "devcontainer":
        whole = replace(whole, command=line.command)  # an editor has its own instead of a default
    # A file of compose is for this machine, unless it asks for other GPUs.
    elsewhere = kind in ("quadlet", "kubernetes") or (kind == "compose" and gpu.is_theirs(whole))
    context = looked_at(program, whole, caller, elsewhere)
    context = export.KINDS[kind].seen(context)
    defaults.require(line, files.project)
    context = trust.settled(context)
    export.write(context, planned, kind, add)
