"""The command `rosml`."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from importlib import import_module

import click

from rosml import __version__
from rosml.base import terminal
from rosml.base.environment import LACKING
from rosml.base.errors import RosmlError
from rosml.cli import MODULES, SECTIONS, command, completion
from rosml.cli.checkout import Command, Group

TRIED = {name: f"rosml setup {name}" for name in ("clean", "client", "down", "scanner", "signer")} | {
    "up": "rosml setup",
    "all": "rosml publish all",
    "bash": "rosml attach",
    "build": "rosml image, for a base image; rosml containerize, for your packages",
    "check": "rosml doctor",
    "deploy": "rosml publish",
    "exec": "rosml attach",
    "images": "rosml list",
    "info": "rosml explain",
    "inspect": "rosml explain",
    "install": "rosml setup, for this machine; pip or apt-get in your Dockerfile, for an image",
    "login": "docker login, which rosml follows",
    "logs": "docker logs",
    "ls": "rosml list",
    "prune": "rosml publish prune",
    "ps": "docker ps",
    "pull": "docker pull, with a tag that rosml list prints",
    "push": "rosml publish, for base images; rosml containerize --push, for images of your packages",
    "rm": "docker rm",
    "sbom": "rosml dossier",
    "scan": "rosml publish scan",
    "search": "rosml list",
    "shell": "rosml attach; rosml dev, for the packages of a folder",
    "show": "rosml explain",
    "start": "rosml run",
    "stop": "docker stop, for a container; rosml setup down, for the local registry and the builder",
    "tags": "rosml list",
    "test": "rosml dev -- colcon test, for your packages; rosml image, which tests what it builds; make test, for this project",
    "undo": "rosml publish undo",
    "update": "git pull, for rosml; rosml image, for an image that you built; docker pull, for one that others publish",
    "version": "rosml --version",
}
"""Words that people try, from other tools or from make, and the command for each."""


class Rosml(Group):
    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args[:1] == ["help"]:
            args = [*args[1:], "--help"]
            if args[0] == "--help":
                terminal.echo(ctx.get_help())
                ctx.exit()
        if LACKING and args and args[0] not in self.commands:
            text = f"no command {args[0]} here: not installed: {', '.join(LACKING)}"
            raise RosmlError(text, "pipx install --force . in a checkout, or uv tool install --force .", exit_code=2)
        return super().resolve_command(ctx, args)

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        from rosml.base.project_addresses import (
            help_lines,  # only needed here, and `rosml run` starts sooner without it
        )

        with formatter.section("Help"):
            for line in help_lines():
                formatter.write_text(line)


@click.group(cls=Rosml, elsewhere=TRIED, sections=SECTIONS)
@click.version_option(__version__, "-V", "--version", prog_name="rosml")
@click.option("-q", "--quiet", is_flag=True, help="Print results and errors, and no progress; not for run and attach.")
@click.pass_context
def cli(context: click.Context, quiet: bool) -> None:
    """ROS base images with machine learning inside.

    list, explain, init, join and doctor need neither Docker nor root nor a checkout; nor do status, catalogue, publish undo and publish
    prune with --registry. run and attach need docker or podman, containerize needs Docker. The others need a checkout: call
    its own ./rosml.

    \b
    Examples:
      rosml list jazzy torch
      rosml explain jazzy-robot
      rosml image jazzy-base-torch-cu130
      rosml run ghcr.io/me/rosml/ros:jazzy-base
      rosml status --registry ghcr.io/me/rosml

    \b
    Completion in bash; in zsh and fish likewise:
      eval "$(_ROSML_COMPLETE=bash_source rosml)"
    """
    if quiet and context.invoked_subcommand not in QUICK:
        context.with_resource(command.quiet())


QUICK = completion.OF_WORDS
"""Commands that import no others: every shell in a container waits for them, and imports take longer than their work."""


def needed() -> Iterable[str]:
    if completion.question().endswith("_source"):
        return ()
    first = completion.first_word() if completion.question() else next(iter(sys.argv[1:]), "")
    installed = QUICK if LACKING else MODULES
    return (first,) if first in installed else installed


def _add(name: str) -> None:
    cli.add_command(import_module(f"rosml.cli.{MODULES[name]}").main)


for name in needed():
    _add(name)


def _absolute(path: str) -> str:
    """A PATH without relative entries: in an empty one or `.`, a stranger's repository may have a program `git` or `docker`."""
    return os.pathsep.join(filter(os.path.isabs, path.split(os.pathsep))) or os.defpath


def run(word: str = "") -> int:
    """Runs `rosml`, or its command `word` alone, or answers a shell that completes its words. Returns the exit code."""
    os.environ["PATH"] = _absolute(os.environ.get("PATH", os.defpath))
    if (answered := completion.answer(cli)) is not None:
        return answered
    if word and word not in cli.commands:
        _add(word)
    first = cli.commands.get(word or next(iter(sys.argv[1:]), ""))
    settings = first if isinstance(first, Command | Group) else cli
    gone = 0 if settings.prints else command.BROKEN_PIPE
    code = command.run(settings if word else cli, settings.kept, reader_gone=gone, failure=settings.failure)
    return command.ended(code)
