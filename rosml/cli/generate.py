"""Writes docker-bake.hcl (and schemas, and the tables of README.md) from matrix.yaml; lists, explains and compares
images, and plans their build in CI.

\b
Examples:
  rosml generate                        after a change of matrix.yaml (make generate)
  rosml generate --list --group jazzy --group torch
                                          images of jazzy with torch (make list GROUP="jazzy torch")
  rosml generate --diff HEAD            what the uncommitted changes would build anew, and why
  rosml generate --diff v1.2 --json     the same since a tag, all of it, for machines
  rosml generate --diff other.yaml      what differs from another matrix
  rosml generate --explain jazzy-robot  why there is no such image; with --json for machines
  rosml generate --shards 8             which of eight machines would build what, and how long that takes
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import click

from rosml import ROOT
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.cli import command, options

if TYPE_CHECKING:  # imported where it is needed: what is fast stays fast
    from rosml.images.image_set import ImageSet

COMMAND = "make generate"


@click.command(help=__doc__, context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--check", is_flag=True, help="Write nothing; exit 1 with a diff if a generated file is stale.")
@click.option("--list", "list_", is_flag=True, help="List every image with its facts.")
@click.option(
    "--group",
    "groups",
    multiple=True,
    metavar="NAME",
    help="With --list: only images of this group; of all, if repeated.",
)
@click.option("--json", "as_json", is_flag=True, help="With --list, --diff, --explain and --shards: as JSON.")
@click.option(
    "--diff", metavar="REV", help="Say which images differ from a git revision or another matrix file, and why."
)
@click.option("--explain", metavar="TARGET", help="Say why an image exists, or why it does not.")
@click.option("--shards", metavar="N", type=int, help="Plan the build of all images on N machines.")
@options.MATRIX
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    help="Write this bake file instead, and nothing else; with --shards: this plan, as JSON.",
)
def main(
    check: bool,
    list_: bool,
    groups: tuple[str, ...],
    as_json: bool,
    diff: str | None,
    explain: str | None,
    shards: int | None,
    matrix: Path,
    output: Path | None,
) -> None:
    if check + list_ + (diff is not None) + (explain is not None) + (shards is not None) > 1:
        raise click.UsageError("--check, --list, --diff, --explain and --shards do different things; use one of them")
    if as_json and not list_ and diff is None and explain is None and shards is None:
        raise click.UsageError("--json belongs to --list, --diff, --explain and --shards")
    if groups and not list_:
        raise click.UsageError("--group belongs to --list")
    if output and (list_ or diff is not None or explain is not None):
        raise click.UsageError("--output belongs to writing, --check and --shards")
    if output and output.exists() and output.resolve() == matrix.resolve():
        raise click.UsageError(f"--output {output} would overwrite the matrix; name another file")
    from rosml.images import load

    image_set = load.load(matrix, ROOT)
    if list_:
        list_images(image_set, groups, as_json)
    elif diff is not None:
        compare(image_set, diff, as_json)
    elif explain is not None:
        say_why(image_set, explain, as_json)
    elif shards is not None:
        deal_out(image_set, shards, as_json, output)
    else:
        from rosml.images import missing

        wanted, lost = generated(image_set, output), missing.lost(image_set)
        if check:
            verify(wanted, lost)
            return
        write(wanted, lost)


def list_images(image_set: ImageSet, groups: tuple[str, ...], as_json: bool) -> None:
    """Prints the images that are in all of some groups; all images where none is named."""
    from rosml.bake import inputs
    from rosml.cli import tables
    from rosml.images import selection

    images = selection.members(image_set, groups)
    if not images:
        click.echo(command.in_words(selection.none_in(image_set, groups)), err=True)
    if as_json:
        click.echo(tables.images_as_json(inputs.Inputs(ROOT, image_set), images), nl=False)
    elif images:
        tables.print_images(images)


def say_why(image_set: ImageSet, name: str, as_json: bool) -> None:
    """Prints why an image exists, or why it does not."""
    from rosml.images.explain import explained

    found = explained(image_set, name)
    click.echo(json.dumps(found.to_json(), indent=2, ensure_ascii=False) if as_json else command.in_words(found.text))


def compare(image_set: ImageSet, other: str, as_json: bool) -> None:
    """Prints which images differ from another version: a git revision, or another matrix file."""
    from rosml.bake import diff, inputs
    from rosml.base import ci
    from rosml.cli import tables
    from rosml.machine import revision

    found = revision.since(other, inputs.Inputs(ROOT, image_set))
    ci.summary(diff.markdown(found))
    if as_json:
        click.echo(diff.as_json(found), nl=False)
    else:
        tables.print_difference(found)


def deal_out(image_set: ImageSet, shards: int, as_json: bool, output: Path | None) -> None:
    """Prints which of some machines builds what, or writes it into a file."""
    from rosml.cli import tables
    from rosml.publish import shards as dealing

    planned = dealing.deal(image_set, shards, include=lambda image: image.locked)
    if output:
        write({output: dealing.as_json(planned)})
    elif as_json:
        click.echo(dealing.as_json(planned), nl=False)
    else:
        tables.print_shards(planned, left_out=sum(not image.locked for image in image_set.images))


def generated(image_set: ImageSet, output: Path | None) -> dict[Path, str]:
    """Every generated file with its content; nothing but the bake file where that is to be written elsewhere."""
    from rosml.bake import bake_file, inputs

    inputs.Inputs(ROOT, image_set).check()
    if output:
        return {output: bake_file.render(image_set)}
    from rosml.catalogue import readme
    from rosml.catalogue.model import Published
    from rosml.matrix import schema

    return {
        ROOT / "docker-bake.hcl": bake_file.render(image_set),
        ROOT / "matrix.schema.json": schema.render(),
        ROOT / "catalogue.schema.json": schema.render(Published, "rosml/catalogue/model.py", read=True),
        ROOT / "README.md": readme.render((ROOT / "README.md").read_text(encoding="utf-8"), image_set),
    }


def write(wanted: dict[Path, str], lost: RosmlError | None = None) -> None:
    """Writes the files that changed. `lost`: locks that should be there; images without them are in no group."""
    for file, content in wanted.items():
        changed = files.write(file, content)
        click.echo(f"{files.shown(file)}: {'written' if changed else 'is up to date'}", err=True)
    if lost:
        click.echo(f"{click.style('warning:', fg='yellow', bold=True)} {lost.message}", err=True)
        click.echo(f"{click.style('remedy:', bold=True)} {lost.remedy}", err=True)


def verify(wanted: dict[Path, str], lost: RosmlError | None) -> None:
    """Compares the files; raises RosmlError if one is stale, or if locks are lost: whoever then generates and commits
    would commit the loss."""
    differences = {file: files.difference(file, content) for file, content in wanted.items()}
    stale = [files.shown(file) for file, text in differences.items() if text]
    click.echo("".join(differences.values()), nl=False)
    problems = [f"{', '.join(stale)}: stale"] if stale else []
    remedies = [f"run '{COMMAND}' and commit the result"] if stale else []
    if lost:
        problems, remedies = [lost.message, *problems], [lost.remedy, *remedies]
    if problems:
        raise RosmlError("\n".join(problems), remedy="; then ".join(remedies))
