"""`rosml dev`: a container to work on the ROS packages of a folder."""

from __future__ import annotations

import os
import shlex
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING

import click

from rosml.base.errors import RosmlError
from rosml.cli.command import say, warn
from rosml.cli.run import container, questions, run
from rosml.run import words

if TYPE_CHECKING:
    from rosml.containerize.build.dev_folder import ImageRecord
    from rosml.containerize.inputs import Values
    from rosml.run.context import Container, Context, Person
    from rosml.run.engine import Facts
    from rosml.run.plugin import Plugin

KEPT = "interrupted: nothing was started; finished steps are kept, the next call carries on"

LABEL = "io.rosml.dev"
"""The label of a container with a shell of `rosml dev`: the digest of its image's inputs."""

WORKSPACE = "/docker-ros/ws"

RESERVED = ("base-image", "addons", "build")
"""The command's own options, beside those of `rosml run`: no file with defaults may set one."""

BUILT_IN = ("mwd", "mws")
"""Options of `rosml run` that do nothing here, as in the file that `rosml init` writes: the folder is mounted anyway."""


class Dev(run.Run):
    """A command of which the first word that is no option is the folder. The words after `--` are the command in the container."""

    def for_click(self, ctx: click.Context, args: Sequence[str]) -> list[str]:
        end = [*args, "--"].index("--")
        command = tuple(args[end + 1 :])
        if not ctx.resilient_parsing:
            _require_own(args[:end], [name for parameter in self.get_params(ctx) for name in parameter.opts])
        read = super().for_click(ctx, args[:end])
        line: words.Line | None = ctx.meta.get(container.LINE)
        if line is None:  # a shell completes a word, or --help
            return read
        if line.command:
            whole = shlex.join((line.image, *line.command, *command))
            text = f"{line.command[0]} stands after the folder {line.image}"
            raise RosmlError(text, f"a command stands after --: rosml dev -- {whole}", exit_code=2)
        ctx.meta[container.LINE] = replace(line, command=command)
        return read


def _require_own(args: Sequence[str], own_options: Collection[str]) -> None:
    """Checks that no option is an input of `rosml containerize` that this command takes only as a variable."""
    options = {word.partition("=")[0] for word in args if word.startswith("--")}
    if not {option for option in options.difference(own_options) if option[2:] not in words.table().names}:
        return
    from rosml.containerize import inputs as app_inputs  # only needed when something is wrong
    from rosml.containerize.build import dev_folder  # only needed when something is wrong

    inputs = {f"--{item.name}": item for item in app_inputs.TABLE if not item.gone}
    inputs |= {f"--no-{item.name}": item for item in app_inputs.TABLE if item.flag}
    for word, following in pairwise((*args, "")):
        option, equals, value = word.partition("=")
        if option not in inputs or option in own_options or option[2:] in words.table().names:
            continue
        item = inputs[option]
        if item.name in dev_folder.UNUSED:
            remedy = "leave it out: rosml dev makes one image for this machine, without an app"
        else:
            value = value if equals else following
            if item.flag:
                value = str(not option.startswith("--no-")).lower()
            remedy = f"set its variable: {item.variable}={shlex.quote(value) if value else 'VALUE'} rosml dev"
        raise RosmlError(f"{option} is an option of rosml containerize, not of rosml dev", remedy, exit_code=2)


@click.command(
    "dev",
    cls=Dev,
    short_help="Opens a shell to build, test and debug your ROS packages.",
    alone=True,
    kept=KEPT,
    context_settings=container.SETTINGS,
    options_metavar="[OPTIONS OF ROSML, DOCKER OR PODMAN]",
)
@click.option("--base-image", default="", metavar="IMAGE", help="the image to build on, as for rosml containerize")
@click.option("--addons", default="", metavar="NAMES", help="add-ons for it, such as onnx,devel")
@click.option("--build", is_flag=True, help="make the image again, with the newest base image and .repos")
@click.option("--no-defaults", is_flag=True, expose_value=False, help="read neither .rosml.toml nor your own run.toml")
@click.option(
    f"--{questions.TRUST}",
    is_flag=True,
    expose_value=False,
    help="from now on, let images of this folder start as root",
)
@container.showing
@click.argument("folder", default=".")
@click.pass_context
def main(context: click.Context, /, folder: str, base_image: str, addons: str, build: bool) -> None:
    """Opens a shell in a container with all that the ROS packages of FOLDER need, as you. FOLDER is mounted there as
    /docker-ros/ws/src/target. The words after -- are a command instead of the shell, and the exit code is its own.

    The image has the dependencies of your packages, as rosml containerize finds them, with ccache, gdb and debugpy.
    It is made again if a package.xml or another input changes.

    What you build stays in FOLDER/.rosml/dev for the next call. colcon builds and tests as in CI. A second call enters the
    container of the first.

    The inputs of rosml containerize count, such as BASE_IMAGE in .env. All options of docker run go to the engine. The exit
    code is 125 if nothing starts.

    \b
    Examples:
      rosml dev --base-image ghcr.io/us/ros:jazzy-base
      rosml dev -- colcon build
      rosml dev -- colcon test --packages-select my_package
      rosml dev -p 127.0.0.1:5678:5678 ~/my_robot
    """
    from rosml.containerize.build import dev_folder
    from rosml.run import paths
    from rosml.run.host import person

    line: words.Line = context.meta[container.LINE]
    caller = person(os.environ)
    place = _place(folder)
    if line.has("platform"):
        raise RosmlError("--platform: the image is for this machine", "leave it out", exit_code=2)
    line = replace(line, engine=tuple(paths.resolved(option, caller.folder) for option in line.engine))
    caller = replace(caller, folder=str(place))
    values = _values(place, {"base-image": base_image, "addons": addons})
    program = container.engine_program()
    dev_folder.require_owner(place, caller.uid)
    key = dev_folder.inputs_digest(place, values)
    if not build and (running := _running(program, caller.folder)):
        _enter(program, line, caller, running, key)
        return
    _require_here(program, caller.folder)
    files = run.default_files(line, (*run.RESERVED, *RESERVED), caller.folder)
    questions.allow(replace(line, image=dev_folder.image_name(place)), files.project)
    record, facts = _image(program, place, values, key, line, build)
    started = files.under(replace(line, image=record.image))
    _start(
        replace(started, rosml=tuple(word for word in started.rosml if word[2:] not in BUILT_IN)), caller, facts, record
    )


def _place(folder: str) -> Path:
    place = Path(folder).expanduser()
    if not place.is_dir():
        remedy = f"name a folder; a command stands after --: rosml dev -- {shlex.quote(folder)}"
        raise RosmlError(f"there is no folder {folder}", remedy, exit_code=2)
    return place.resolve()


def _values(folder: Path, options: Mapping[str, str]) -> Values:
    """The inputs of the image. Empty options do not count."""
    from rosml.containerize import inputs as app_inputs
    from rosml.containerize.build import dev_folder
    from rosml.containerize.packages import manifest

    inputs = {name: value for name, value in options.items() if value}
    manifest.require(folder, inputs, os.environ)
    return dev_folder.image_values(app_inputs.values({**inputs, "push": "false"}, folder, os.environ), folder)


def _require_here(program: str, folder: str) -> None:
    """Checks that the engine is not one of another machine, where it would mount a folder of the same name, or make an empty one."""
    from rosml.base import web
    from rosml.machine import docker

    address = docker.address(program)
    if address.startswith(("ssh:", "tcp:")) and not web.is_here(address):
        remedy = "take this machine's (unset DOCKER_HOST; docker context use default), or call rosml dev there"
        raise RosmlError(f"{program} asks the one at {address}, which does not have {folder}", remedy)


def _running(program: str, folder: str) -> Container | None:
    """The container of a folder in which a shell runs; None if there is none."""
    from rosml.run import engine
    from rosml.run.plugins import basic_options

    running = (it for it in engine.containers(program, LABEL) if it.state == "running")
    return next((it for it in running if it.labels.get(basic_options.FOLDER_LABEL) == folder), None)


def _enter(program: str, line: words.Line, caller: Person, running: Container, key: str) -> None:
    """Enters a container that runs. `key`: the digest of the present inputs of its image."""
    from rosml.run import attach

    again = f"end its shells, or call {program} stop {running.name}; then call this again"
    if late := next((x.words[0] for x in line.engine if not {*x.names} <= attach.PASSED), ""):
        raise RosmlError(f"{late} is for a container that starts, and {running.name} runs already", again, exit_code=2)
    if running.labels[LABEL] != key:
        warn(
            f"{running.name} has the dependencies of before: a package.xml or another input of its image changed", again
        )
    container.enter(program, line, caller, running)


def _image(
    program: str, folder: Path, values: Values, key: str, line: words.Line, renew: bool
) -> tuple[ImageRecord, Facts]:
    """The image, and what the engine says of it. If its inputs changed, it is made."""
    from rosml import STATE
    from rosml.cli.containerize import containerize
    from rosml.containerize.build import dev_folder, step_order
    from rosml.run import engine

    file = dev_folder.record_file(folder, STATE)
    record = dev_folder.read_record(file)
    if record and record.key == key and not renew:
        facts = engine.ask(program, record.image, "")
        if facts.image and facts.image.id == record.id:
            return record, facts
    if container.only_shown(line):
        raise RosmlError("the image of this folder is not made, or its inputs changed", "call rosml dev first")
    podman = engine.answering(program).podman
    services = containerize.services_for_builds()
    services.require_builder()
    call = step_order.new_call(folder, values, os.environ, services, say)
    image = step_order.build_shell_image(call.for_podman() if podman else call)
    facts = engine.ask(program, image.reference, "")
    if facts.image is None and image.loaded:
        text = f"the image is in Docker, and {program} does not have it"
        raise RosmlError(text, "set ROSML_ENGINE=docker; check DOCKER_HOST and docker context ls")
    if facts.image is None:
        engine.pull(program, replace(line, image=image.reference))
        facts = engine.ask(program, image.reference, "")
    if facts.image is None:
        raise engine.still_lacking(program, image.reference)
    record = dev_folder.ImageRecord(
        key=key, image=image.reference, id=facts.image.id, upstream=str(image.upstream or "")
    )
    dev_folder.write_record(file, record)
    return record, facts


def _start(line: words.Line, caller: Person, facts: Facts, record: ImageRecord) -> None:
    from rosml.containerize.build import dev_folder
    from rosml.run import engine
    from rosml.run.context import Context
    from rosml.run.host import host
    from rosml.run.plugins import basic_options

    assert facts.image
    if not line.command and caller.terminal and not line.has("name") and not line.asks("no-name"):
        name = f"{basic_options.as_name(Path(caller.folder).name) or 'workspace'}-dev"
        if engine.container(facts.engine.program, name) is None:
            line = replace(line, engine=(*line.engine, words.TypedOption(("--name", name), ("name",), name)))
    line = line if line.has("name") else replace(line, rosml=(*line.rosml, "--no-name"))
    if not container.only_shown(line):
        dev_folder.make(Path(caller.folder))
    context = Context(line, facts.engine, caller, facts.image, host(os.environ))
    run.begin(context, _plugin(record))


def _plugin(record: ImageRecord) -> Plugin:
    from rosml.containerize.build import dev_folder
    from rosml.run import paths
    from rosml.run.plugin import Plugin

    def mounted(context: Context) -> list[str]:
        folder = context.person.folder
        added = ["--mount", paths.bind(f"{folder}/{dev_folder.KEPT}", WORKSPACE)]
        added += ["--mount", paths.bind(folder, f"{WORKSPACE}/src/target")]
        if record.upstream:
            added += ["--mount", f"{paths.bind(record.upstream, f'{WORKSPACE}/src/upstream')},readonly"]
        if not context.line.command:
            added += ["--label", f"{LABEL}={record.key}"]
        if not context.line.has("workdir"):
            added += ["--workdir", WORKSPACE]
        return [*added, "-e", f"ROSML_DEV_FOLDER={folder}"]

    return Plugin("dev", mounted)
