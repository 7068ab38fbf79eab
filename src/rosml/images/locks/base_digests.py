"""Moves the digests of base images in matrix.yaml to those of their tags.

An image is built from the digest in the matrix, even if the tag moves. So a renewed base image comes in as a change of the matrix,
which is an input of everything that depends on it.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.base.side_by_side import side_by_side
from rosml.images.matrix.model import Matrix, OperatingSystem
from rosml.images.matrix.source import Document
from rosml.registry import bases, references
from rosml.registry.client import Registry
from rosml.registry.credentials import DOCKER_HUB

SECTION = "operating_systems"

WITHOUT_HUB = "ROSML_DOCKER_HUB"
"""The variable with 0 if Docker Hub does not answer, as in setup."""


@dataclass(frozen=True)
class Pin:
    """A base image whose tag has another digest: the system, the image with its tag, the digest in the matrix, and the new one."""

    system: str
    image: str
    before: str
    after: str


@dataclass(frozen=True)
class Pins:
    """Base images that moved, and the reason for each that could not be checked."""

    moved: Sequence[Pin] = ()
    left_out: Mapping[str, str] = field(default_factory=dict)


def pinned(document: Document) -> list[str]:
    """The systems whose digests a file pins: a set has those of the matrix that it extends, if it names no others."""
    return [str(path[1]) for path in document.places if path[0:1] == (SECTION,) and path[2:] == ("digest",)]


def look(matrix: Matrix, names: Iterable[str], registries: Callable[[str], Registry]) -> Pins:
    """Asks the registries for the digests of the base images of some systems."""
    systems = {name: matrix.operating_systems[name] for name in names}

    def current_digest(name: str) -> str | RosmlError:
        try:
            return _current(matrix, systems[name], registries)
        except RosmlError as error:
            return error

    answers = dict(zip(systems, side_by_side(current_digest, systems), strict=True))
    return Pins(
        [
            Pin(name, systems[name].image, systems[name].digest, answer)
            for name, answer in answers.items()
            if isinstance(answer, str) and answer != systems[name].digest
        ],
        {name: answer.message for name, answer in answers.items() if isinstance(answer, RosmlError)},
    )


def _current(matrix: Matrix, system: OperatingSystem, registries: Callable[[str], Registry]) -> str:
    where = references.parse(system.image)
    if where.host == DOCKER_HUB and os.environ.get(WITHOUT_HUB) == "0":
        raise RosmlError(f"{WITHOUT_HUB}=0 says that Docker Hub does not answer")
    registry = registries(where.host)
    manifest = registry.manifest(where.repository, where.reference)
    if manifest is None:
        raise RosmlError(f"{system.image} is not there any more")
    if not manifest.is_index:
        raise RosmlError(f"{system.image} is for one platform only: its tag points at no index")
    places = [entry.platform for entry in manifest.members if entry.platform]
    offered = {f"{place.os}/{place.architecture}" for place in places}
    platforms = [matrix.architectures[name].platform for name in system.architectures]
    if lost := [platform for platform in platforms if platform not in offered]:
        raise RosmlError(f"{system.image} is not there for {listed(lost)} now")
    bases.configs(registry, where.repository, manifest, system.image, system.architectures)
    return manifest.digest


def rewritten(text: str, document: Document, pins: Iterable[Pin]) -> str:
    """The text of a matrix with new digests. Everything else stays, including comments."""
    lines = text.splitlines(keepends=True)
    for pin in pins:
        place = document.places[(SECTION, pin.system, "digest")]
        start = sum(map(len, lines[: place.line - 1])) + place.column - 1
        whole = "".join(lines)
        at = whole.index(pin.before, start)  # the value may stand on the next line
        lines = (whole[:at] + pin.after + whole[at + len(pin.before) :]).splitlines(keepends=True)
    return "".join(lines)


def rows(moved: Iterable[Pin]) -> list[tuple[str, str, str, str]]:
    return [(pin.system, pin.image, pin.before[:19], pin.after[:19]) for pin in moved]


def reasons(left_out: Mapping[str, str]) -> list[str]:
    """A line for each base image that could not be checked."""
    return [f"{name}: its base image stays as it is: {reason}" for name, reason in left_out.items()]
