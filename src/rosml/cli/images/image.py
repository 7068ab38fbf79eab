"""`rosml image`: one image, from its build to a tag in the local registry."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import completion
from rosml.cli.checkout import Command
from rosml.cli.command import say
from rosml.cli.images.call import KEPT, Call, sharing
from rosml.cli.machine import setup

if TYPE_CHECKING:
    from rosml.images.image_set.model import Image, ImageSet
    from rosml.machine.services import Services

LONGEST_TAG = 128
"""In characters, by the OCI distribution specification."""


@click.command("image", short_help="Builds and tests an image on this machine.", cls=Command, kept=KEPT)
@click.argument("target", default="", type=completion.Name("targets"))
@sharing("matrix", "namespace")
@click.option(
    "--platform",
    default="",
    metavar="PLATFORM",
    help="build and test for this one, such as linux/arm64; no tag moves if it is not this machine's own",
)
@click.option(
    "--on",
    default="",
    metavar="IMAGE",
    help="install the ROS of TARGET on IMAGE, not on the base image that matrix.yaml names",
)
@click.option(
    "--all-tests", is_flag=True, help="run all tests, also those that other images with the same parts passed"
)
@sharing("force", "json")
def main(
    target: str, matrix: Path, namespace: str, platform: str, on: str, all_tests: bool, force: bool, as_json: bool
) -> None:
    """Builds TARGET, runs its structure tests, and moves its tags in the local registry. TARGET is a name or a tag of an image.

    Builds also the images and parts that TARGET needs, if they are missing or out of date. Sets this machine up first,
    if necessary. 'rosml status' and the catalogue show the image afterwards.

    Without TARGET, builds the first of matrix.yaml's defaults that this machine can build.

    \b
    Examples:
      rosml image jazzy-base-torch-cu130
      rosml image ros-torch:jazzy-base-cu130
      rosml image ros1-bookworm-base --json
      rosml image jazzy-base --on nvidia/cuda:13.0.1-cudnn-runtime-ubuntu24.04
    """
    from rosml.cli.images import summary
    from rosml.images.builds import default, disk
    from rosml.images.builds.base_images import native_architecture
    from rosml.images.builds.maker import require_buildable
    from rosml.images.image_set import apt_repository, explain, selection
    from rosml.images.publish.steps.build import build
    from rosml.images.publish.steps.index import index
    from rosml.images.publish.steps.join import join
    from rosml.images.publish.steps.promote import promote
    from rosml.images.publish.steps.test import test
    from rosml.machine.services import Services

    call = Call(matrix=matrix, force=force, all_tests=all_tests)
    image_set = call.image_set
    # A typo ends the command before anything else happens.
    native = native_architecture()
    architecture = selection.architecture_of(image_set, platform) if platform else native
    named = explain.image(image_set, target) if target else None
    if named:
        require_buildable(named, architecture)
        apt_repository.of(image_set.matrix, named.distribution)
    if on and (named is None or named.stack):
        text = "--on installs the ROS of one target" + (f", and {target} has a framework" if named else "")
        raise RosmlError(text, "name a ROS image, such as jazzy-base; 'rosml join' adds parts", exit_code=2)
    if not setup.is_up(ROOT):
        setup.bring_up(ROOT)
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder("" if architecture == native else image_set.matrix.architectures[architecture].platform)
    if on:
        assert named
        found = _on(on, named, image_set, services, image_set.matrix.architectures[architecture].platform, namespace)
        terminal.echo(json.dumps(found, indent=2) if as_json else f"image    {found['reference']}")
        return
    wanted = named or default.default(services, image_set, architecture, say)
    call.registry, call.only = f"{services.registry}/{namespace}", (wanted.target,)
    call.architectures = call.serve = (architecture,)
    run = call.run()
    run.whole = True
    summary.require_makeable(run, wanted, architecture)
    there = {target.removeprefix("part-") for target, name in run.state.by_key if run.state.made((target, name))}
    disk.require(services.state, disk.needed_mb(run.state.forecast, wanted, there), wanted.target, say)
    build(run)
    join(run)
    test(run, [wanted.target])
    moves = None
    if architecture == native and not run.failed:
        index(run)
        moves = promote(run)
    made = summary.of_image(run, wanted, architecture, moves)
    terminal.echo(json.dumps(made.to_json(), indent=2) if as_json else made.text())


def _on(
    name: str, image: Image, image_set: ImageSet, services: Services, platform: str, namespace: str
) -> dict[str, str]:
    """Installs the ROS of an image on another one, and pushes the result into the local registry.

    Raises:
        RosmlError: the image is missing or has ROS already, no ROS of the matrix fits it, or a step failed.
    """
    from rosml.containerize.base_image import base as app_base
    from rosml.containerize.build import adopt
    from rosml.containerize.inputs import Values
    from rosml.images.builds.push import COMPRESSION
    from rosml.registry import references

    found = app_base.find(name, services, (platform,))
    values = Values(ros_distro=image.distribution, ros_component=image.component)
    onto = adopt.with_ros(found, services, values, (platform,), say, image_set)
    if not onto.adopted:
        has = found.environment.get("ROS_DISTRO") or "in /opt/ros"
        raise RosmlError(f"{found.name} has ROS already: {has}", "build on it as it is", exit_code=2)
    place = references.parse(found.name)
    tag = re.sub(r"^sha256:(.{12}).*", r"\1", place.reference)
    if len(tag) + 1 + len(image.target) > LONGEST_TAG:
        tag = found.digest[7:19]
    # The whole path: two owners may have images of the same name, and `records` is one of our repositories.
    reference = f"{services.registry}/{namespace}/on/{place.repository}:{tag}-{image.target}"
    output = f"type=image,push=true,{COMPRESSION}"
    digest = adopt.make(onto, services, os.environ, (platform,), reference, output)
    return {"target": image.target, "on": found.reference, "reference": reference, "digest": digest}
