"""`rosml env`: environments of Python packages beside ROS."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rosml import ROOT
from rosml.base import terminal
from rosml.cli import options
from rosml.cli.checkout import Group
from rosml.cli.command import say
from rosml.cli.images.call import KEPT, sharing

if TYPE_CHECKING:
    from rosml.images.environments.add import Sized


@dataclass(frozen=True)
class _Call:
    name: str
    requirements: tuple[str, ...]
    image: str
    without: tuple[str, ...]
    upgrade: bool
    folder: Path
    matrix: Path
    as_json: bool


_FOLDER = click.option(
    "--folder",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("environments"),
    show_default=True,
    help="where environments have their folders",
)


@click.group("env", cls=Group, short_help="Makes environments of Python packages beside ROS.", kept=KEPT)
def main() -> None:
    """Makes environments of Python packages, which have their own numpy and setuptools beside those of ROS.

    \b
    Examples:
      rosml env add lerobot 'lerobot==0.4.4' --image ros1-bookworm-core-torch-cu128
      rosml env build lerobot
    """


@main.command("add", short_help="Writes the lock of an environment.")
@click.argument("name")
@click.argument("requirements", nargs=-1, metavar="[REQUIREMENT]...")
@click.option("--image", required=True, metavar="IMAGE", help="the bake target that it stands on, such as jazzy-base")
@click.option(
    "--without",
    multiple=True,
    metavar="PACKAGE",
    help="leave it out, although another package needs it; repeatable",
    callback=options.words,
)
@click.option("--upgrade", is_flag=True, help="take the newest versions; otherwise those of the earlier lock stay")
@_FOLDER
@sharing("matrix", "json")
def add(**options: Any) -> None:
    """Resolves the environment NAME on an image, and writes its lock for each architecture.

    A REQUIREMENT is a package as pip writes it, a requirements.txt or a pyproject.toml. Without any, those of the earlier call
    count, and --without leaves out more. Only wheels are installed.
    """
    from rosml.images.environments import add as adding
    from rosml.images.environments import declaration
    from rosml.images.image_set import load
    from rosml.images.join import short_names

    call = _Call(**options)
    place = call.folder / short_names.require(call.name)
    words = call.requirements
    earlier = None if words else declaration.read(place)
    request = declaration.leaving_out(earlier, call.without) if earlier else declaration.declared(words, call.without)
    image_set = load.load(call.matrix, ROOT)
    locks = adding.resolved(adding.Request(call.name, request, place, call.upgrade), image_set, call.image, say)
    changed = request if request != earlier else None
    adding.write(place, (it.lock for it in locks), image_set.matrix.architectures, changed)
    _show(place, locks, call.as_json)


def _show(place: Path, locks: Sequence[Sized], as_json: bool) -> None:
    from rosml.base.problems import listed
    from rosml.base.units import size

    if as_json:
        facts = [
            {
                "architecture": lock.architecture,
                "python": lock.python,
                "takes": dict(lock.takes),
                "packages": {pin.name: pin.version for pin in lock.pins},
                "bytes": bytes_,
            }
            for lock, bytes_ in locks
        ]
        terminal.echo(json.dumps(facts, indent=2))
        return
    for lock, bytes_ in locks:
        terminal.echo(f"{place / lock.architecture}.txt: {len(lock.pins)} packages, {size(bytes_)} to download")
        if lock.takes:
            taken = [f"{package} {version}" for package, version in sorted(lock.takes.items())]
            terminal.echo(f"  from the image: {listed(taken)}")


@main.command("build", short_help="Builds an environment into a registry.")
@click.argument("name")
@click.option(
    "--registry",
    default="",
    metavar="PREFIX",
    help="push it there, beside your base images, such as ghcr.io/me/rosml; into the local registry if left out",
)
@_FOLDER
@sharing("matrix", "namespace", "json")
def build(name: str, registry: str, folder: Path, matrix: Path, namespace: str, as_json: bool) -> None:
    """Builds the environment NAME for all architectures that have a lock, without emulation, and pushes it into the local registry, or another
    one.

    'rosml join' puts it onto an image, 'rosml containerize --env NAME' below an app.

    \b
    Examples:
      rosml env build lerobot
      rosml env build lerobot --registry ghcr.io/me/rosml
    """
    from rosml.images.environments import build as building
    from rosml.images.image_set import load
    from rosml.images.join import short_names
    from rosml.machine.services import Services
    from rosml.registry.place import Place

    short_names.require(name)
    place = str(Place.at(registry.lower())) if registry else ""
    image_set = load.load(matrix, ROOT)
    locks = building.read(folder / name, name, image_set.matrix.architectures)
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder()
    built = building.publish(services, image_set, locks, place or f"{services.registry}/{namespace}", say)
    if as_json:
        terminal.echo(json.dumps(built.to_json(), indent=2))
        return
    terminal.echo(f"{built.reference}  {built.seconds:.0f} s")
    for platform, bytes_ in built.layers.items():
        terminal.echo(f"  {platform}  {bytes_ / 1e6:.1f} MB")
    terminal.echo(f"join it to an image: rosml join IMAGE {short_names.KIND}{name} --tag REFERENCE")
