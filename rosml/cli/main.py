"""The command `rosml`: one word for each thing that people do with images."""

from __future__ import annotations

import functools
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click
from click.core import ParameterSource

from rosml import FOREIGN, IN_CHECKOUT, ROOT, __version__
from rosml.base.errors import RosmlError
from rosml.base.words import in_words
from rosml.cli import catalogue, command, completion, generate, join, locks, options, publish, setup

SETTINGS = {"help_option_names": ["-h", "--help"]}


@click.group(context_settings=SETTINGS)
@click.version_option(__version__, prog_name="rosml")
def cli() -> None:
    """ROS base images with machine learning inside.

    list, explain and join need neither Docker nor root nor a checkout; nor do status, catalogue, publish undo and publish
    prune where --registry names a registry. What builds needs a checkout, and what 'rosml setup' starts there.

    \b
    Examples:
      rosml list jazzy torch
      rosml explain jazzy-robot
      rosml image bookworm-core-torch-cu128
      rosml status --registry ghcr.io/me/rosml

    \b
    Completion in bash; in zsh and fish likewise:
      eval "$(_ROSML_COMPLETE=bash_source rosml)"
    """


@cli.command(name="list")
@click.argument("groups", nargs=-1, type=completion.Name("groups"), metavar="[GROUP]...")
@options.MATRIX
@options.JSON
def list_(groups: tuple[str, ...], matrix: Path, as_json: bool) -> None:
    """Lists every image with its facts; with GROUPs, those that are in all of them.

    \b
    Examples:
      rosml list
      rosml list trixie tensorflow --json
    """
    from rosml.bake.inputs import Inputs
    from rosml.cli import tables
    from rosml.images import load, selection

    image_set = load.load(matrix, ROOT)
    images = selection.members(image_set, groups)
    if not images:
        click.echo(in_words(selection.none_in(groups)), err=True)
    if as_json:
        inputs = Inputs(ROOT, image_set)
        inputs.check()
        click.echo(tables.images_as_json(inputs, images), nl=False)
    elif images:
        tables.print_images(images)


@cli.command()
@click.argument("name", type=completion.Name("targets"))
@options.MATRIX
@options.JSON
def explain(name: str, matrix: Path, as_json: bool) -> None:
    """Says why an image exists, or why it does not. NAME is a target or a tag, with the registry or without. Dated tags
    are not in the matrix: leave the date out.

    \b
    Examples:
      rosml explain jazzy-robot
      rosml explain ros-torch:jazzy-base-cu128
    """
    from rosml.images import load
    from rosml.images.explain import explained

    found = explained(load.load(matrix, ROOT), name)
    click.echo(in_words(json.dumps(found.to_json(), indent=2, ensure_ascii=False) if as_json else found.text))


@cli.command()
@click.argument("version", metavar="REVISION")
@options.MATRIX
@options.JSON
def diff(version: str, matrix: Path, as_json: bool) -> None:
    """Says which images differ from a git revision or another matrix file, and why.

    \b
    Examples:
      rosml diff HEAD          what the uncommitted changes would build anew
      rosml diff v1.2 --json   all of it since a tag, for machines
    """
    from rosml.bake import diff as changes
    from rosml.bake.inputs import Inputs
    from rosml.base import ci
    from rosml.cli import tables
    from rosml.images import load
    from rosml.machine import revision

    found = revision.since(version, Inputs(ROOT, load.load(matrix, ROOT)))
    ci.summary(changes.markdown(found))
    if as_json:
        click.echo(changes.as_json(found), nl=False)
    else:
        tables.print_difference(found)


TOP = ("image", "part", "plan", "status")
"""Commands of a publishing run that are words of their own."""

cli.add_command(publish.cli, "publish")
for name in TOP:
    cli.add_command(publish.cli.commands[name])
cli.add_command(join.main, "join")
cli.add_command(locks.main, "locks")
cli.add_command(catalogue.main, "catalogue")
cli.add_command(generate.main, "generate")
cli.add_command(setup.main, "setup")


def _require_checkout() -> None:
    """Says that a command needs a checkout, where there is none."""
    if not IN_CHECKOUT and FOREIGN:
        raise RosmlError(*_foreign(FOREIGN), exit_code=2)
    if not IN_CHECKOUT:
        text = "there is no checkout here: no folder of yours, this one or one above it, has matrix.yaml, Dockerfile and scripts/bootstrap.py"
        raise RosmlError(text, "git clone the project, or your fork of it, and call it there", exit_code=2)


def _foreign(folder: Path) -> tuple[str, str]:
    """Why a checkout is not used, and what to do about it."""
    owner = folder.stat().st_uid
    text = f"the checkout {folder} is not used: it belongs to user {owner}, and not to you or root"
    return text, f"chown -R {os.geteuid()} {folder}, or call this as its owner"


def _say_whose_matrix() -> None:
    """Says that the matrix is not that of the folder where somebody works, unless they named it."""
    source = click.get_current_context().get_parameter_source("matrix")
    if FOREIGN and source is ParameterSource.DEFAULT:
        text, remedy = _foreign(FOREIGN)
        which = str(ROOT / "matrix.yaml") if IN_CHECKOUT else "the one that came with rosml"
        command.warn(f"{text}; the matrix is {which}", f"{remedy}; or name its matrix with --matrix")


def _begin_with(check: Callable[[], None], step: click.Command) -> None:
    """Has a command check something before it does anything else."""
    callback = step.callback
    assert callback

    @functools.wraps(callback)
    def called(*arguments: Any, **options: Any) -> Any:
        check()
        return callback(*arguments, **options)

    step.callback = called


ALONE = {"explain", "join", "list", "catalogue", "status", "undo", "prune"}
"""Commands that need no checkout."""

for step in setup.main.commands.values():
    _begin_with(setup.bootstrap, step)
    _begin_with(_require_checkout, step)
for name, step in {**cli.commands, **publish.cli.commands}.items():
    if isinstance(step, click.Group):
        continue
    _begin_with(_say_whose_matrix, step)
    if name not in ALONE:
        _begin_with(_require_checkout, step)

KEPT = {"join": join.KEPT, "setup": setup.KEPT} | dict.fromkeys(("image", "part", "publish"), publish.KEPT)
"""What is said after Ctrl-C, by the first word."""


def run(word: str = "") -> int:
    """What the installed command calls; gives its exit code. Shells ask it how words go on (`rosml --help` says how).

    Args:
        word: the only one of its commands that a script calls.
    """
    if (answered := completion.answer(cli)) is not None:
        return answered
    called, first = (cli.commands[word], word) if word else (cli, next(iter(sys.argv[1:]), ""))
    prints = first in ("list", "explain", "diff") or word not in ("", "publish")  # who reads a script's output may stop
    code = command.run(called, KEPT.get(first, "interrupted"), reader_gone=0 if prints else command.BROKEN_PIPE)
    return command.ended(code)
