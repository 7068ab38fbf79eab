"""Options that several commands have, and the registry that one of them names."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from rosml import IN_CHECKOUT
from rosml import MATRIX as MATRIX_FILE
from rosml.base.errors import RosmlError
from rosml.cli import checkout

if TYPE_CHECKING:
    from rosml.registry.place import Place

Function = TypeVar("Function", bound=Callable[..., Any])


def _lower(_context: click.Context, _parameter: click.Parameter, value: str) -> str:
    """Registries allow no capitals, names of repositories on forges do."""
    return value.lower()


def words(_context: click.Context, _parameter: click.Parameter, values: tuple[str, ...]) -> tuple[str, ...]:
    """Values, of which one text may have several: a job in CI has one field for all, and it may be empty."""
    return tuple(word for value in values for word in value.split())


MATRIX = click.option(
    "--matrix", type=click.Path(path_type=Path), default=MATRIX_FILE, help="another matrix.yaml, or a set.yaml"
)
ONLY = click.option(
    "--only", multiple=True, metavar="GLOB", callback=words, help="images by target, tag, pattern or group; repeatable"
)
JSON = click.option("--json", "as_json", is_flag=True, help="print the result as JSON on standard output")


def registry(where: str) -> Callable[[Function], Function]:
    text = f"{where}, such as ghcr.io/me/rosml; a set's own, or the local registry's rosml, if left out"
    return click.option("--registry", default="", metavar="PREFIX", callback=_lower, help=text)


def registry_of_set(matrix: Path) -> str:
    """Where a set's images go; empty if the matrix is no set, or the set has no registry."""
    from rosml.images.matrix import extends, source

    data = source.read(matrix).data
    registry = data.get("registry") if isinstance(data, Mapping) and extends.KEY in data else ""
    return registry.lower() if isinstance(registry, str) else ""


def unnamed(error: RosmlError) -> RosmlError:
    """The error if no registry is named, and there is no local one. Only a checkout can have a local one."""
    remedy = "name a registry with --registry"
    if IN_CHECKOUT:
        return RosmlError(error.message, f"{remedy}, or {error.remedy}")
    near = checkout.around()
    return RosmlError("no registry is named", f"{remedy}; or, {checkout.own_command(near)}" if near else remedy)


def place_of(name: str, root: Path) -> Place:
    """The place with this name, for commands that build nothing; without a name, that of a set, or the local one."""
    from rosml.machine.services import Services
    from rosml.registry.place import Place

    if name := name or registry_of_set(MATRIX_FILE):
        return Place.at(name, os.environ.get("SSL_CERT_FILE", ""))
    try:
        services = Services.load(root)
        return Place.at(services.place, services.ca_bundle)
    except RosmlError as error:
        raise unnamed(error) from None
