"""`rosml env`: environments of Python packages beside ROS."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rosml import ROOT
from rosml.base import files, terminal
from rosml.cli import options
from rosml.cli.checkout import Group
from rosml.cli.command import say
from rosml.cli.images.call import KEPT, sharing

if TYPE_CHECKING:
    from rosml.images.environments.add import Sized
    from rosml.images.environments.declaration import Declaration
    from rosml.images.image_set.model import ImageSet


@dataclass(frozen=True)
class _Call:
    name: str
    requirements: tuple[str, ...]
    images: tuple[str, ...]
    without: tuple[str, ...]
    apart: bool
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
@click.option(
    "--image",
    "images",
    multiple=True,
    metavar="IMAGE",
    help="the bake target that it stands on, such as jazzy-base; repeatable, for several Pythons",
)
@click.option(
    "--without",
    multiple=True,
    metavar="PACKAGE",
    help="leave it out, although another package needs it; repeatable",
    callback=options.words,
)
@click.option("--apart", is_flag=True, help="take nothing of the image: its own PyTorch, although the image has one")
@click.option("--upgrade", is_flag=True, help="take the newest versions; otherwise those of the earlier lock stay")
@_FOLDER
@sharing("matrix", "json")
def add(**options: Any) -> None:
    """Resolves the environment NAME on images, and writes its lock for each Python and architecture.

    A REQUIREMENT is a package as pip writes it, a requirements.txt, a pyproject.toml or a uv.lock. Without any, those of the earlier call
    count, and --without leaves out more. Images of earlier calls stay, one for each Python. Only wheels are installed.
    """
    from rosml.images.environments import add as adding
    from rosml.images.environments import declaration, uv_lock
    from rosml.images.image_set import load
    from rosml.images.join import short_names

    call = _Call(**options)
    place = call.folder / short_names.require(call.name)
    words = call.requirements
    image_set = load.load(call.matrix, ROOT)
    earlier = _earlier(place, call.name, image_set) if not words or (place / declaration.FILE).exists() else None
    wish = declaration.changed(earlier, words, call.without, call.apart)
    wish = adding.with_images(wish, call.images, image_set)
    preferences = "".join(uv_lock.preferences(Path(word)) for word in words if word.endswith(uv_lock.SUFFIX))
    request = adding.Request(call.name, wish, place, call.upgrade, preferences)
    files.require_writable(place)
    locks = [it for target in wish.images for it in adding.resolved(request, image_set, target, say)]
    is_new = wish != earlier or not (place / declaration.FILE).exists()
    adding.write(place, (it.lock for it in locks), wish if is_new else None)
    if earlier and wish.requirements != earlier.requirements:
        say(f"{place / declaration.FILE} had other requirements: {', '.join(earlier.requirements)}")
    _show(place, locks, call.as_json)


def _earlier(place: Path, name: str, image_set: ImageSet) -> Declaration:
    """The declaration of before; in a set of somebody's own, that of rosml, for the images that are in the set."""
    from rosml.images.environments import declaration
    from rosml.images.matrix.names import ENVIRONMENTS

    ours = ROOT / ENVIRONMENTS / name
    if (place / declaration.FILE).exists() or not (ours / declaration.FILE).exists():
        return declaration.read(place)
    earlier = declaration.read(ours)
    images = [target for target in earlier.images if target in image_set.by_target]
    return earlier.model_copy(update={"images": images})


def _show(place: Path, locks: Sequence[Sized], as_json: bool) -> None:
    from rosml.base.problems import counted, listed
    from rosml.base.units import size
    from rosml.images.environments.lock import file_of

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
        file = file_of(place, lock.python, lock.architecture)
        terminal.echo(f"{file}: {counted(len(lock.pins), 'package')}, {size(bytes_)} to download")
        if lock.takes:
            taken = [f"{package} {version}" for package, version in sorted(lock.takes.items())]
            terminal.echo(f"  from the image: {listed(taken)}")


@dataclass(frozen=True)
class _Build:
    name: str
    registry: str
    python: str
    folder: Path
    matrix: Path
    namespace: str
    as_json: bool


@main.command("build", short_help="Builds an environment into a registry.")
@click.argument("name")
@click.option(
    "--registry",
    default="",
    metavar="PREFIX",
    help="push it there, beside your base images, such as ghcr.io/me/rosml; into the local registry if left out",
)
@click.option(
    "--python", default="", metavar="VERSION", help="only for this one, such as 3.12; for all with a lock if left out"
)
@_FOLDER
@sharing("matrix", "namespace", "json")
def build(**options: Any) -> None:
    """Builds the environment NAME for all Pythons and architectures that have a lock, without emulation, and pushes it into the local registry,
    or another one.

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

    call = _Build(**options)
    name = short_names.require(call.name)
    place = str(Place.at(call.registry.lower())) if call.registry else ""
    image_set = load.load(call.matrix, ROOT)
    locks = building.read(call.folder / name, name, image_set.matrix.architectures, call.python)
    services = Services.load(ROOT)
    services.require_registry()
    services.require_builder()
    prefix = place or f"{services.registry}/{call.namespace}"
    every = [building.publish(services, image_set, same, prefix, say) for same in locks]
    if call.as_json:
        terminal.echo(json.dumps([built.to_json() for built in every], indent=2))
        return
    for built in every:
        terminal.echo(f"{built.reference}  {built.seconds:.0f} s")
        for platform, bytes_ in built.layers.items():
            terminal.echo(f"  {platform}  {bytes_ / 1e6:.1f} MB")
    terminal.echo(f"join it to an image: rosml join IMAGE {short_names.KIND}{name} --tag REFERENCE")
