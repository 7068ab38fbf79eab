"""`rosml join`: joins a ROS image and parts in a registry. It needs no Docker and no builder, and pulls no layer."""

from __future__ import annotations

import json
import os
from functools import partial

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import options
from rosml.cli.checkout import Command
from rosml.cli.command import say

KEPT = "interrupted: no tag was moved; the next call finds again what was pushed"


@click.command("join", short_help="Joins a ROS image and parts in a registry.", cls=Command, alone=True, kept=KEPT)
@click.argument("ros_image")
@click.argument("parts", nargs=-1, required=True, metavar="PART...")
@click.option("--tag", required=True, metavar="REFERENCE", help="the image to make: registry, repository and tag")
@click.option(
    "--platform", "platforms", multiple=True, metavar="PLATFORM", help="only this one, such as linux/arm64; repeatable"
)
@click.option("--allow-unlisted", is_flag=True, help="continue if an image has no list of files to compare")
@options.JSON
def main(
    ros_image: str, parts: tuple[str, ...], tag: str, platforms: tuple[str, ...], allow_unlisted: bool, as_json: bool
) -> None:
    """Joins ROS_IMAGE and PARTs, and moves a tag to the result.

    Give complete references, in any registry. env:NAME is the environment NAME for the Python of ROS_IMAGE, beside it or in the
    local registry. The result has every platform that all of them have. rosml mounts layers
    from the registry of the tag, and copies layers from other registries. Credentials are those of 'docker login'.

    \b
    Example:
      rosml join ghcr.io/me/rosml/ros:ros1-bookworm-core \\
        ghcr.io/me/rosml/part:{common-cpu-py311,grpc-cpu-py311,tensorflow-cc-cpu} \\
        ghcr.io/me/rosml/part:tensorflow-cpu-py311 --tag ghcr.io/me/mine:latest
    """
    from rosml.base.units import duration, size
    from rosml.images.join.joiner import Joiner
    from rosml.images.scan import together
    from rosml.machine.services import Services
    from rosml.registry.client import Registries

    services = Services.load(ROOT, required=False)
    local = services.place if services.registry else ""
    with (
        Registries(os.environ.get("SSL_CERT_FILE", "")) as clients,
        Joiner(
            clients, allow_unlisted=allow_unlisted, say=say, describe=partial(together.attach, clients, say)
        ) as joiner,
    ):
        report = joiner.join(ros_image, parts, tag, platforms, local)
    if as_json:
        terminal.echo(json.dumps(report.to_json(), indent=2))
        return
    terminal.echo(f"{report.reference}@{report.digest}")
    counts = ((report.mounted, "mounted"), (report.present, "there already"), (report.copied, "copied"))
    ways = ", ".join(f"{number} {what}" for number, what in counts if number)
    terminal.echo(f"{', '.join(report.manifests)}: {report.layers} layers ({ways})")
    terminal.echo(f"{size(report.uploaded)} uploaded in {duration(report.seconds)}")
