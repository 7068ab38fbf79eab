"""`rosml image`: one image, from nothing to a tag in the local registry."""

from __future__ import annotations

import json
from pathlib import Path

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import completion, setup
from rosml.cli.call import KEPT, Call, say, sharing, wait_for_turn
from rosml.cli.checkout import Command


@click.command("image", cls=Command, kept=KEPT)
@click.argument("target", default="", type=completion.Name("targets"))
@sharing("matrix", "namespace")
@click.option(
    "--platform",
    default="",
    metavar="PLATFORM",
    help="build and test for it, such as linux/arm64; no tag moves where it is not the machine's own",
)
@sharing("force", "json")
def main(target: str, matrix: Path, namespace: str, platform: str, force: bool, as_json: bool) -> None:
    """Builds TARGET and what it stands on, runs its structure tests, and moves its tags in the local registry.

    Sets this machine up first, if it is not. Makes only what is missing or out of date. 'status' and the catalogue know the
    image afterwards.

    Without TARGET: the first of matrix.yaml's defaults that this machine can build.

    \b
    Examples:
      rosml image jazzy-base-torch-cu130
      rosml image ros1-bookworm-base --json
    """
    from rosml.build import default
    from rosml.build.maker import require_buildable
    from rosml.cli import summary
    from rosml.images import apt_source, explain, selection
    from rosml.machine import disk
    from rosml.machine.base_images import native_architecture
    from rosml.machine.services import Services
    from rosml.publish import promote

    call = Call(matrix=matrix, force=force)
    image_set = call.image_set
    # A typo is told before anything else happens.
    native = native_architecture()
    architecture = selection.architecture_of(image_set, platform) if platform else native
    named = explain.image(image_set, target) if target else None
    if named:
        require_buildable(named, architecture)
        apt_source.source(image_set.matrix, named.distribution)
    if not setup.is_up(ROOT):
        setup.bring_up(ROOT)
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder("" if architecture == native else image_set.matrix.architectures[architecture].platform)
    wanted = named or default.default(services, image_set, architecture, say)
    call.registry, call.only = f"{services.registry}/{namespace}", (wanted.target,)
    call.architectures = call.serve = (architecture,)
    wait_for_turn()
    run = call.pipeline()
    there = {target.removeprefix("part-") for target, name in run.plan.by_key if run.plan.made((target, name))}
    disk.require(services.state, disk.needed_mb(run.plan.forecast, wanted, there), wanted.target)
    run.build()
    run.join()
    run.test([wanted.target])
    moves = None
    if architecture == native and not run.failed:
        run.index()
        moves = promote.Promotion(run).run()
    found = summary.of_image(run, wanted, architecture, moves)
    terminal.echo(json.dumps(found.to_json(), indent=2) if as_json else found.text())
