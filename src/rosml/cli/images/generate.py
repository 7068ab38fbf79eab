"""Writes docker-bake.hcl from matrix.yaml; also schemas, tables of the documentation, and files for CI.

\b
Examples:
  rosml generate          after a change of matrix.yaml
  rosml generate --check  whether a generated file is outdated
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from rosml import ROOT
from rosml.base import files, terminal
from rosml.base.errors import RosmlError
from rosml.cli import command, options
from rosml.cli.checkout import Command

if TYPE_CHECKING:  # imported by the functions that need it, so that other commands start fast
    from rosml.images.image_set.model import ImageSet

COMMAND = "rosml generate"


@click.command(
    "generate",
    short_help="Writes docker-bake.hcl and other files from matrix.yaml.",
    cls=Command,
    prints=True,
    help=__doc__,
)
@click.option("--check", is_flag=True, help="Write nothing; exit 1 with a diff if a generated file is outdated.")
@options.MATRIX
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    help="Write only the bake file, to this path.",
)
def main(check: bool, matrix: Path, output: Path | None) -> None:
    if output and output.exists() and output.resolve() == matrix.resolve():
        raise click.UsageError(f"--output {output} would overwrite the matrix; name another file")
    from rosml.images.image_set import load, missing_locks

    image_set = load.load(matrix, ROOT)
    contents, lost = generated(image_set, output), missing_locks.lost(image_set)
    if check:
        verify(contents, lost)
    else:
        write(contents, lost, None if output else ROOT)


def generated(image_set: ImageSet, output: Path | None) -> dict[Path, str]:
    """Every generated file with its content; only the bake file if `output` says where to write it."""
    from rosml.images.bake import bake_file, inputs

    target_inputs = inputs.Inputs(ROOT, image_set)
    target_inputs.check()
    bake_files = bake_file.render(image_set, target_inputs.targets)
    if output:
        return {output: bake_files[bake_file.NAME]}
    from rosml.containerize.ci import files as ci_files
    from rosml.images.catalogue import layers_picture, tags_page
    from rosml.images.catalogue.model import Published
    from rosml.images.matrix import schema

    return {
        **{ROOT / name: content for name, content in bake_files.items()},
        ROOT / "matrix.schema.json": schema.render(),
        ROOT / "catalogue.schema.json": schema.render(Published, "src/rosml/images/catalogue/model.py", read=True),
        ROOT / "docs/tags.md": tags_page.render(files.text(ROOT / "docs/tags.md"), image_set),
        ROOT / "docs/licences.md": tags_page.render_licences(files.text(ROOT / "docs/licences.md"), image_set),
        ROOT / "docs/images/layers.svg": layers_picture.render(image_set),
        ROOT / "docs/images/rebase.svg": layers_picture.render_rebase(image_set),
        **{ROOT / path: ci_files.render(path, files.text(ROOT / path)) for path in ci_files.FILES},
    }


def write(contents: dict[Path, str], lost: RosmlError | None = None, within: Path | None = None) -> None:
    """Writes the files that changed, and warns of lost locks: images without locks are in no group. `within` is the folder that links may
    not lead out of; None for a file that the user named."""
    changed = files.write_all(contents, within)
    for file in contents:
        terminal.echo(f"{files.shown(file)}: {'written' if file in changed else 'is up to date'}", err=True)
    if lost:
        command.warn(lost.message, lost.remedy)


def verify(contents: dict[Path, str], lost: RosmlError | None) -> None:
    """Compares the files with what would be generated. Lost locks are an error too: a commit after 'rosml generate' would include the loss."""
    differences = {file: files.difference(file, content) for file, content in contents.items()}
    stale = [files.shown(file) for file, text in differences.items() if text]
    terminal.echo("".join(differences.values()), nl=False)
    problems = [(lost.message, lost.remedy)] if lost else []
    problems += [(f"{', '.join(stale)}: outdated", f"run '{COMMAND}' and commit the result")] if stale else []
    if problems:
        messages, remedies = zip(*problems, strict=True)
        raise RosmlError("\n".join(messages), remedy="; then ".join(remedies))
