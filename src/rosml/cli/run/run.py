"""`rosml run`: starts an image with docker or podman."""

from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import click

from rosml import IN_CHECKOUT, ROOT
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.run import container, questions
from rosml.run import attach, defaults, host, variants
from rosml.run.context import Context, Person
from rosml.run.defaults import Files
from rosml.run.plan import Plan, make_plan
from rosml.run.plugin import Plugin
from rosml.run.plugins import basic_options, gpu
from rosml.run.plugins.discovery import Discovery, discover
from rosml.run.words import HERE, Line

if TYPE_CHECKING:
    from rosml.run.engine import Facts

RESERVED = ("new", "no-defaults", questions.TRUST, "check", "verbose", "dry-run", "json", "export", "add", "help")
"""The command's own options: no plugin may have one of these names, and no file with defaults may set one."""

IMAGE_REMEDY = 'write image = "…" into .rosml.toml'


@cache
def discovered() -> Discovery:
    """The plugins, searched once."""
    return discover(RESERVED)


def default_files(line: Line, reserved: Iterable[str], folder: str) -> Files:
    """The files with defaults that count for a command line: none with --no-defaults."""
    options = [f"--{name}" for plugin in discovered().plugins for name in plugin.options]
    if line.asks("no-defaults"):
        return Files()
    return defaults.files(os.environ, folder, options, [f"--{name}" for name in reserved])


class Run(container.Words):
    """A command with the options of plugins."""

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        """The command's own options, with those of the plugins after the first."""
        first, *others = super().get_params(ctx)
        options = {name: text for plugin in discovered().plugins for name, text in plugin.options.items()}
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
@container.flag("--new", "start another container although one runs; the engine names it")
@container.flag("--no-defaults", "read neither .rosml.toml nor your own run.toml")
@container.flag(f"--{questions.TRUST}", "from now on, let images of this repository start as root, to make your user")
@container.showing
@container.flag("--check", "say what keeps ROS nodes apart from others, and start no command")
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

    The engine is docker, or podman if docker does not answer; ROSML_ENGINE names one. The exit code is the command's, or 125 if
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

    line: Line = context.meta[container.LINE]
    _check_words(line)
    caller = host.person(os.environ)
    files = default_files(line, RESERVED, caller.folder)
    image = files.under(line).image
    purpose = next((name for name in ("new", "check") if line.asks(name)), f"export {export}" if export else "")
    _require_image(line, image, purpose)
    if not line.image and not purpose:
        try:
            enter(line, image)
            return
        except attach.NoContainer:
            if not image:
                raise
    if add is not None and export != "compose":
        raise RosmlError("--add goes with --export compose", "write both, or leave out --add", exit_code=2)
    program = container.engine_program()
    if export:
        export_call(program, line, caller, files, export, add)
    elif line.asks("check"):
        check_ros(program, line, caller, files)
    else:
        start(program, line, caller, files)


def _check_words(line: Line) -> None:
    plugin_options = [name for plugin in discovered().plugins for name in plugin.options]
    if line.late([f"--{name}" for name in (*plugin_options, *RESERVED)]):
        text = f"{line.command[0]} is the command in the container, since it stands after the image"
        command.warn(text, f"options come first: rosml run {line.command[0]} … {line.image}")
    user = line.value("user")
    if user.startswith("--") or "/" in user:  # rocker's --user takes no value
        remedy = "leave --user out: you are you in the container"
        raise RosmlError(f"--user takes a user, and {user} is none", remedy, exit_code=2)


def _require_image(line: Line, image: str, purpose: str) -> None:
    if line.image == HERE and not image:
        raise RosmlError("no file names the image of this folder", f"rosml run IMAGE, or {IMAGE_REMEDY}", exit_code=2)
    if purpose and not image:
        text = f"--{purpose.partition(' ')[0]} needs an image, and none is named"
        raise RosmlError(text, f"rosml run --{purpose} IMAGE, or {IMAGE_REMEDY}", exit_code=2)


def enter(line: Line, image: str) -> None:
    """Enters the container of the current folder, as no image is typed. An option may have taken the image as its value. `image` is
    that of the files with defaults."""
    remedy = "write the image after it: rosml run … IMAGE"
    if line.taken_word and not image and not set(line.engine[-1].names) <= attach.PASSED:
        if line.engine[-1].names[-1] == "name":  # docker-run enters a container so
            remedy += f"; to enter a container that is there: rosml attach {line.engine[-1].value}"
        raise RosmlError(f"no image is named: {line.taken_word}", remedy, exit_code=2)
    try:
        container.enter_folder(line, "rosml run without an image")
    except RosmlError as error:
        if line.taken_word and error.exit_code == 2:
            error.remedy += f"; {line.taken_word}: if it is the image, {remedy}"
        raise


def start(program: str, typed: Line, caller: Person, files: Files) -> None:
    """Starts an image, or shows how. If the image is missing, it is pulled, unless the command is only shown. If it runs for
    this folder already, enters that container, which has the options of the files already."""
    from rosml.run import engine

    if typed.asks("verbose"):
        for text in files.summary(typed):
            terminal.echo(text, err=True)
    line = files.under(typed)
    name = "" if line.has("replace") else basic_options.name_of(line, caller)
    line, facts = _with_variant(program, line, caller, name)
    if facts.container:
        attach.check_same(program, line, caller, facts.container, facts.image)
        container.enter(program, typed, caller, facts.container)
        return
    questions.allow(typed, files.project)
    if facts.image is None and container.only_shown(line):
        raise engine.lacking(program, line.image)
    if facts.image is None:
        engine.pull(program, line)
        pulled = line.image
        line, facts = _with_variant(program, line, caller)
        if facts.image is None and line.image != pulled:
            engine.pull(program, line)
            facts = engine.ask(program, line.image, "")
    if facts.image is None:
        raise engine.still_lacking(program, line.image)
    begin(Context(line, facts.engine, caller, facts.image, host.host(os.environ)))


def begin(context: Context, *more: Plugin) -> None:
    """Starts a container, or shows how. `more` are plugins of the caller, after all others."""
    if not container.only_shown(context.line):
        gpu.require_present(context)
    plan, machine = planned(questions.settle_trust(context), *more), context.host

    def prepare() -> None:
        for folder in plan.folders:
            if not machine.has(folder):
                with suppress(OSError):  # then the engine does what it can
                    machine.path(folder).mkdir(parents=True)
        for file, content in plan.files.items():
            host.write(machine.path(file), content)

    container.perform(context.line, plan.argv, prepare)


def _with_variant(
    program: str, line: Line, caller: Person, name: str = "", elsewhere: bool = False
) -> tuple[Line, Facts]:
    """The command line with the image for this machine, or one elsewhere, if the typed one exists for several accelerators, and the facts
    about it, also those of the container with the name."""
    from rosml.run import engine

    facts = engine.ask(program, line.image, name)
    is_here = facts.engine.is_on(host.host(os.environ))
    if facts.image is None and is_here and (local := _in_local_registry(line.image)):
        line = replace(line, image=local)
        facts = engine.ask(program, local, name)
    if facts.image is None or variants.LABEL not in facts.image.labels:
        return line, facts
    context = Context(line, facts.engine, caller, facts.image, host.host(os.environ))
    variant = variants.for_another_machine(context) if elsewhere else variants.for_this_machine(context)
    if not variant:
        return line, facts
    why = "what the call asks for" if elsewhere else "this machine"
    terminal.echo(f"rosml: {line.image} is there for several accelerators; {variant} is the one for {why}", err=True)
    return replace(line, image=variant), engine.ask(program, variant, name)


def _in_local_registry(image: str) -> str:
    """The complete name of an image that the local registry of a checkout has; empty if it has none, or the name names a registry."""
    if not IN_CHECKOUT:
        return ""
    from rosml.delivery import pulled_layers  # only for an image that the engine lacks
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    with suppress(RosmlError), Registries() as registries:
        services = Services.load(ROOT)
        name = pulled_layers.complete(image, services, registries)
        return name if services.registry and name.startswith(f"{services.registry}/") and name != image else ""
    return ""


def planned(context: Context, *more: Plugin) -> Plan:
    """The plan of all plugins, and of those of the caller. Prints their warnings."""
    plan = make_plan(context, (*discovered().plugins, *more))
    for text, remedy in (*discovered().notes, *plan.notes):
        command.warn(text, remedy)
    return plan


def _context(program: str, line: Line, caller: Person, elsewhere: bool = False) -> Context:
    """The context of an image that the engine must have, as it is not started. `elsewhere`: it will start on another machine."""
    from rosml.run import engine

    line, facts = _with_variant(program, line, caller, elsewhere=elsewhere)
    if facts.image is None:
        raise engine.lacking(program, line.image)
    return Context(line, facts.engine, caller, facts.image, host.host(os.environ))


def check_ros(program: str, line: Line, caller: Person, files: Files) -> None:
    """Shows what ROS in a container of the image depends on. If a project's file names the image, we look into it only after
    the user allows that."""
    from rosml.cli.run import check

    context = _context(program, files.under(line), caller)
    allowed = questions.allow(line, files.project)
    context, typed = questions.settle_trust(context), line.image not in ("", HERE)
    check.show(context, make_plan(context, discovered().plugins).argv, into=typed or allowed)


def export_call(program: str, line: Line, caller: Person, files: Files, kind: str, add: str | None) -> None:
    """Shows what would run, as a file of this kind; or adds it to the file `add`."""
    from rosml.cli.run import export

    if other := next((name for name in ("check", "dry-run", "json") if line.asks(name)), ""):
        raise RosmlError(f"--export does not go with --{other}", "leave out one of them", exit_code=2)
    whole = files.under(line)
    if kind == "devcontainer":
        whole = replace(whole, command=line.command)  # an editor has its own instead of a default
    # A file of compose is for this machine, unless it asks for other GPUs.
    elsewhere = kind in ("quadlet", "kubernetes") or (kind == "compose" and gpu.is_theirs(whole))
    context = export.KINDS[kind].seen(_context(program, whole, caller, elsewhere))
    questions.allow(line, files.project)
    export.write(questions.settle_trust(context), planned, kind, add)
