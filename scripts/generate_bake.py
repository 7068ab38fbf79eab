#!/usr/bin/env python3
"""Writes docker-bake.hcl (and matrix.schema.json and README.md's table) from matrix.yaml; lists, explains and compares
images, and plans their build in CI.

\b
Examples:
  generate_bake.py                        after a change of matrix.yaml (make generate)
  generate_bake.py --list --group jazzy --group torch
                                          images of jazzy with torch (make list GROUP="jazzy torch")
  generate_bake.py --diff HEAD            what the uncommitted changes would build anew, and why
  generate_bake.py --diff v1.2 --json     the same since a tag, all of it, for machines
  generate_bake.py --diff other.yaml      what differs from another matrix
  generate_bake.py --shards 8             which of eight machines would build what, and how long that takes
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import rosml.environment  # noqa: F401 (first: says what to do where the others are missing)

# isort: split

import click

from rosml import ROOT, command, files
from rosml.errors import RosmlError

COMMAND = "make generate"


@click.command(help=__doc__)
@click.option("--check", is_flag=True, help="Write nothing; exit 1 with a diff if a generated file is stale.")
@click.option("--list", "list_", is_flag=True, help="List every image with its facts.")
@click.option(
    "--group",
    "groups",
    multiple=True,
    metavar="NAME",
    help="With --list: only images of this group; of all, if repeated.",
)
@click.option("--json", "as_json", is_flag=True, help="With --list, --diff and --shards: as JSON.")
@click.option(
    "--diff", metavar="REV", help="Say which images differ from a git revision or another matrix file, and why."
)
@click.option("--explain", metavar="TARGET", help="Say why an image exists, or why it does not.")
@click.option("--shards", metavar="N", type=int, help="Plan the build of all images on N machines.")
@click.option(
    "--matrix", type=click.Path(path_type=Path), default=ROOT / "matrix.yaml", help="Read this matrix instead."
)
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
    if as_json and not list_ and diff is None and shards is None:
        raise click.UsageError("--json belongs to --list, --diff and --shards")
    if groups and not list_:
        raise click.UsageError("--group belongs to --list")
    if output and (list_ or diff is not None or explain is not None):
        raise click.UsageError("--output belongs to writing, --check and --shards")
    if output and output.exists() and output.resolve() == matrix.resolve():
        raise click.UsageError(f"--output {output} would overwrite the matrix; name another file")
    from rosml import expand

    catalogue = expand.load(matrix, ROOT)
    if list_:
        from rosml import inputs, listing

        images = listing.members(catalogue, groups)
        if not images:
            click.echo(listing.none_in(catalogue, groups), err=True)
        if as_json:
            click.echo(listing.as_json(inputs.Inputs(ROOT, catalogue), images), nl=False)
        elif images:
            listing.print_table(images)
    elif diff is not None:
        from rosml import difference, inputs

        found = difference.since(diff, inputs.Inputs(ROOT, catalogue))
        if as_json:
            click.echo(difference.as_json(found), nl=False)
        else:
            difference.print_table(found)
    elif explain is not None:
        from rosml.explain import explain as sentence

        click.echo(sentence(catalogue, explain))
    elif shards is not None:
        from rosml import plan

        planned = plan.plan(catalogue, shards, include=lambda image: image.locked)
        if output:
            write({output: plan.as_json(planned)})
        elif as_json:
            click.echo(plan.as_json(planned), nl=False)
        else:
            plan.print_table(planned, left_out=sum(not image.locked for image in catalogue.images))
    else:
        from rosml import bake, inputs, missing

        inputs.Inputs(ROOT, catalogue).check()
        wanted = {output or ROOT / "docker-bake.hcl": bake.render(catalogue)}
        if output is None:
            from rosml import readme, schema

            wanted[ROOT / "matrix.schema.json"] = schema.render()
            wanted[ROOT / "README.md"] = readme.render((ROOT / "README.md").read_text(encoding="utf-8"), catalogue)
        (verify if check else write)(wanted, missing.lost(catalogue))


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


if __name__ == "__main__":
    sys.exit(command.run(main))
