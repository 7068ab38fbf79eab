"""`rosml list`: images, with their versions, platforms and tags."""

from __future__ import annotations

from pathlib import Path

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.base.problems import counted, listed
from rosml.cli import command, completion, options
from rosml.cli.checkout import Command


@click.command("list", short_help="Lists all images, or those of some groups.", cls=Command, alone=True, prints=True)
@click.argument("groups", nargs=-1, type=completion.Name("groups"), metavar="[GROUP]...")
@options.MATRIX
@options.JSON
def main(groups: tuple[str, ...], matrix: Path, as_json: bool) -> None:
    """Lists all images, with their versions, platforms and tags. With GROUPs, lists the images that are in all of them. A word that
    people use for it does as well: noble, rtx 4090, driver 550, libtorch, cv_bridge.

    \b
    Examples:
      rosml list
      rosml list ros1-trixie tensorflow --json
      rosml list ubuntu 24.04 rtx 4090
    """
    from rosml.base import clock
    from rosml.cli.images import tables
    from rosml.images.image_set import load, search, selection
    from rosml.images.matrix import lacks, support

    image_set = load.load(matrix, ROOT)
    images = search.search(image_set, groups)
    if not images:
        terminal.echo(command.as_called(selection.none_in(image_set, groups)), err=True)
    if as_json:
        from rosml.images.bake.inputs import Inputs

        inputs = Inputs(ROOT, image_set)
        inputs.check()
        terminal.echo(tables.images_as_json(inputs, images), nl=False)
    elif images:
        tagged_images = [image for image in images if image.tags]
        tables.print_images(tagged_images or images)
        for line in support.ends(image_set.matrix, (image.distribution for image in images), clock.today()):
            terminal.say(line, "yellow")
        for line in lacks.sentences(image_set.matrix, (image.distribution for image in images)):
            terminal.say(line, "yellow")
        if tests := [image for image in images if not image.tags]:
            addons = list(dict.fromkeys(addon for image in tests for addon in image.addons))
            which = "tests" if len(tests) == 1 else "test"
            more = f"{counted(len(tests), 'more image')} without a tag, which {which}"
            text = more if tagged_images else "these have no tag, and test"
            one = addons[0] if len(addons) == 1 else "NAME"
            line = f"{text} {listed(addons)}: rosml explain {one}"
            terminal.echo(command.as_called(line))
