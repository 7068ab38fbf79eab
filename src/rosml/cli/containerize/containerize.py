"""`rosml containerize`: images of a repository with ROS packages."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from rosml import IN_CHECKOUT, ROOT, STATE
from rosml.base import terminal
from rosml.cli import command, options
from rosml.cli.checkout import Command
from rosml.cli.command import say
from rosml.cli.options import Function
from rosml.containerize import inputs as app_inputs

if TYPE_CHECKING:
    from rosml.machine.services import Services

KEPT = "interrupted: no image was made; finished steps are kept, the next call carries on"


def _options(function: Function) -> Function:
    for item in reversed(app_inputs.TABLE):
        if item.gone or item.name in app_inputs.SECRET:
            continue
        text = f"{item.help} [{item.default}]" if item.default else item.help
        name, kind = (f"--{item.name}/--no-{item.name}", _Flag) if item.flag else (f"--{item.name}", click.Option)
        names = [name, f"--{item.repeatable}"] if item.repeatable else [name]
        more = {"multiple": True} if item.repeatable else {"default": None}
        text += "; repeatable" if item.repeatable else ""
        function = click.option(*names, item.variable, cls=kind, help=text, **more)(function)
    return function


class _Flag(click.Option):
    """An input that is on or off. Help names it once, since two long names do not fit on a line."""

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        return self.opts[0].replace("--", "--[no-]", 1), self.help or ""


def services_for_builds() -> Services:
    """The builder and the registry: those of the checkout; the user's Docker if `rosml` is installed."""
    from rosml.cli.machine import setup
    from rosml.machine.services import Services

    if not IN_CHECKOUT:
        return Services.of_docker(STATE)
    if not setup.is_up(ROOT):
        setup.bring_up(ROOT)
    services = Services.load(ROOT)
    services.require_registry()
    return services


@click.command(
    "containerize", short_help="Builds images of the ROS packages in a folder.", cls=Command, alone=True, kept=KEPT
)
@click.argument("folder", type=click.Path(exists=True, file_okay=False, path_type=Path), default=".")
@click.option("--lock", is_flag=True, help="take the newest versions, and write the lock file")
@_options
@options.JSON
def main(folder: Path, lock: bool, as_json: bool, **options_by_variable: str | bool | tuple[str, ...] | None) -> None:
    """Builds images of the ROS packages in FOLDER: one to run them, and one to work on them.

    \b
    NAME:TAG      the base image with your packages built, and what they need to run; starts --command
    NAME:TAG-dev  the base image with all dependencies and your sources
    NAME:TAG-slim with --enable-slim: the first one without compilers and headers

    If FOLDER has a file containerize.lock, which --lock writes, the build takes base image, repositories and packages from it.

    Each option can be a variable instead, such as BASE_IMAGE, in the environment or in a file .env in FOLDER. Passwords and
    keys can only be variables: GIT_HTTPS_PASSWORD, GIT_SSH_PRIVATE_KEY.

    \b
    Example:
      rosml containerize --base-image ghcr.io/us/ros-torch:jazzy-base-cu130 \\
        --command "ros2 launch my_package all.launch.py"
    """
    from rosml.containerize.build import step_order
    from rosml.containerize.packages import manifest

    folder = folder.resolve()
    inputs = {
        item.name: ",".join(value) if isinstance(value, tuple) else str(value).lower() if item.flag else str(value)
        for item in app_inputs.TABLE
        if (value := options_by_variable.get(item.variable)) not in (None, ())
    }
    manifest.require(folder, inputs, os.environ)  # before anything is said of options, and any service is asked
    values = app_inputs.values(inputs, folder, os.environ)
    for sentence in app_inputs.answers(folder, os.environ):
        say(sentence)
    services = services_for_builds()
    services.require_builder()
    result = step_order.build_images(step_order.new_call(folder, values, os.environ, services, say, renew=lock))
    if as_json:
        terminal.echo(json.dumps(result.to_json(), indent=2))
        return
    for image in result.images:
        terminal.echo(f"{image.target:<5}  {image.reference}")
    for name, text in result.summary():
        terminal.echo(f"{name:<5}  {text}")
    for line in [] if values.push else where(services.registry, [image.reference for image in result.images]):
        terminal.echo(line)
    for image in result.images[:1]:
        terminal.echo(f"try    {command.call()} run {image.reference}")


def where(registry: str, images: Sequence[str]) -> Iterator[str]:
    """Lines that say where images are, if nobody named a registry, and Docker does not have them."""
    if registry and images and images[0].startswith(f"{registry}/"):
        yield "where  in the local registry, as setup found no Docker; with --push, in the registry that --image-name names"
        yield f"       {command.call()} save {images[0]} -o image.tar writes one into a file"
