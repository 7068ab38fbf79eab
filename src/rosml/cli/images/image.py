"""`rosml image`: one image, from its build to a tag in the local registry."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

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
    from rosml.cli.images.summary import Summary
    from rosml.images.environments.lock import Lock
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
    "--env",
    "environments",
    multiple=True,
    metavar="NAME",
    help="join this environment of the folder environments to it as well, under a tag of their own; repeatable",
)
@click.option(
    "--all-tests", is_flag=True, help="run all tests, also those that other images with the same parts passed"
)
@sharing("force", "json")
def main(**arguments: Any) -> None:
    """Builds TARGET, runs its structure tests, and moves its tags in the local registry. TARGET is a name or a tag of an image.

    Builds also the images and parts that TARGET needs, if they are missing or out of date. Sets this machine up first,
    if necessary. 'rosml status' and the catalogue show the image afterwards.

    Without TARGET, builds the first of matrix.yaml's defaults that this machine can build.

    \b
    Examples:
      rosml image jazzy-base-torch-cu130
      rosml image ros-torch:jazzy-base-cu130
      rosml image ros1-bookworm-base --json
      rosml image ros1-bookworm-core-torch-cu128 --env lerobot
      rosml image jazzy-base --on nvidia/cuda:13.0.1-cudnn-runtime-ubuntu24.04
    """
    from rosml.machine.services import Services

    options = _Options(**arguments)
    plan = _plan(options)  # a typo ends the command before anything else happens
    if not setup.is_up(ROOT):
        setup.bring_up(ROOT)
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder(plan.platform if plan.foreign else "")
    if options.on:
        image = _install_on(options, plan, services)
        terminal.echo(json.dumps(image, indent=2) if options.as_json else f"image    {image['reference']}")
        return
    built = _build(options, plan, services)
    if not plan.locks:
        terminal.echo(json.dumps(built.to_json(), indent=2) if options.as_json else built.text())
        return
    from rosml.images.environments import image as environments

    report = environments.join(services, plan.call.image_set, built.reference, plan.locks, say)
    facts = {**built.to_json(), "with_environments": report.to_json()}
    terminal.echo(
        json.dumps(facts, indent=2) if options.as_json else f"{built.text()}\n\nwith environments  {report.reference}"
    )


@dataclass(frozen=True)
class _Options:
    target: str
    matrix: Path
    namespace: str
    platform: str
    on: str
    environments: tuple[str, ...]
    all_tests: bool
    force: bool
    as_json: bool


@dataclass(frozen=True)
class _Plan:
    """What to build: None for the image means one of the matrix's defaults. `foreign`: not for this machine. `locks`: of environments."""

    call: Call
    image: Image | None
    architecture: str
    foreign: bool
    locks: Mapping[str, Sequence[Lock]]

    @property
    def platform(self) -> str:
        return self.call.image_set.matrix.architectures[self.architecture].platform


def _plan(options: _Options) -> _Plan:
    from rosml.base import clock
    from rosml.images.builds.base_images import native_architecture
    from rosml.images.builds.maker import require_buildable
    from rosml.images.image_set import apt_repository, explain, selection
    from rosml.images.matrix import support

    call = Call(matrix=options.matrix, force=options.force, all_tests=options.all_tests, even_ended=True)
    image_set = call.image_set
    native = native_architecture()
    architecture = selection.architecture_of(image_set, options.platform) if options.platform else native
    image = explain.image(image_set, options.target) if options.target else None
    if image:
        require_buildable(image, architecture)
        apt_repository.of(image_set.matrix, image.distribution)
        for line in support.ends(image_set.matrix, [image.distribution], clock.today()):
            say(line)
    if options.on and (image is None or image.stack):
        text = "--on installs the ROS of one target" + (f", and {options.target} has a framework" if image else "")
        raise RosmlError(text, "name a ROS image, such as jazzy-base; 'rosml join' adds parts", exit_code=2)
    locks = _locks(options, image, image_set, architecture != native) if options.environments else {}
    return _Plan(call, image, architecture, architecture != native, locks)


def _locks(options: _Options, image: Image | None, image_set: ImageSet, foreign: bool) -> Mapping[str, Sequence[Lock]]:
    """The locks of environments for an image that will have a tag."""
    from rosml.images.environments import image as environments

    if image is None or not image.tags or options.on or foreign:
        text = "--env joins environments to a named image of this machine's platform that gets a tag"
        raise RosmlError(text, "name one, without --on and --platform; 'rosml join' takes any image", exit_code=2)
    return environments.read(image, options.environments, Path("environments"), image_set.matrix.architectures)


def _build(options: _Options, plan: _Plan, services: Services) -> Summary:
    """Builds, joins and tests the image; moves its tags, if it is for this machine."""
    from rosml.cli.images import summary
    from rosml.images.builds import default, disk
    from rosml.images.publish.steps import build, index, join, promote, test

    call, architecture = plan.call, plan.architecture
    image = plan.image or default.default(services, call.image_set, architecture, say)
    call.registry, call.only = f"{services.registry}/{options.namespace}", (image.target,)
    call.architectures = call.serve = (architecture,)
    run = call.run()
    run.whole = True
    summary.require_makeable(run, image, architecture)
    present = {
        target.removeprefix("part-") for target, name in run.state.by_key if run.state.is_current((target, name))
    }
    disk.require(services.state, disk.needed_mb(run.state.forecast, image, present), image.target, say)
    build.build(run)
    join.join(run)
    test.test(run, [image.target])
    moves = None
    if not plan.foreign and not run.failed:
        index.index(run)
        moves = promote.promote(run)
    return summary.of_image(run, image, architecture, moves)


def _install_on(options: _Options, plan: _Plan, services: Services) -> dict[str, str]:
    """Installs the ROS of an image on another one, and pushes the result into the local registry."""
    from rosml.containerize.base_image import base as app_base
    from rosml.containerize.build import adopt
    from rosml.containerize.inputs import Values
    from rosml.images.builds import contents
    from rosml.images.builds.push import compression
    from rosml.registry import references
    from rosml.registry.client import Registry

    image, platforms = plan.image, (plan.platform,)
    assert image
    base = app_base.find(options.on, services, platforms)
    values = Values(ros_distro=image.distribution, ros_component=image.component)
    adopted = adopt.with_ros(base, services, values, platforms, say, plan.call.image_set)
    if not adopted.adopted:
        ros = base.environment.get("ROS_DISTRO") or "in /opt/ros"
        raise RosmlError(f"{base.name} has ROS already: {ros}", "build on it as it is", exit_code=2)
    place = references.parse(base.name)
    tag = re.sub(r"^sha256:(.{12}).*", r"\1", place.reference)
    if len(tag) + 1 + len(image.target) > LONGEST_TAG:
        tag = base.digest[7:19]
    # The whole path: two owners may have images of the same name, and `records` is one of our repositories.
    reference = f"{services.registry}/{options.namespace}/on/{place.repository}:{tag}-{image.target}"
    output = f"type=image,push=true,{compression(plan.call.image_set.matrix.compression)}"
    digest = adopt.make(adopted, services, os.environ, platforms, reference, output)
    with Registry(services.registry, ca_bundle=services.ca_bundle) as registry:
        pushed = [(references.parse(reference).repository, digest)]
        contents.attach(services, plan.call.image_set, registry, pushed, say)
    return {"target": image.target, "on": base.reference, "reference": reference, "digest": digest}
