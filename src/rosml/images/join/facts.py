"""Facts of images that say whether an app can move to another base: packages with their relations, and symbols of libraries.

components/containerize/facts.py writes them: for ROS images and parts, and for the one layer of an app. They are attached to images.
"""

from __future__ import annotations

import base64
import functools
import hashlib
import re
from collections.abc import Iterable, Mapping
from typing import Annotated

from pydantic import ConfigDict, Field, ValidationError

from rosml.base import archives, untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import Shape
from rosml.images.image_set.labels import COVERED, JOINED
from rosml.images.image_set.model import ENVIRONMENTS, PARTS
from rosml.images.join.file_lists import attached
from rosml.images.matrix import names
from rosml.registry import references
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest

ARTIFACT = "application/vnd.rosml.facts.v1"
MEDIA_TYPE = "application/vnd.rosml.facts.v1+gzip"

LARGEST, PACKED = 64 << 20, 32 << 20
"""The most bytes of facts, unpacked and as they are stored."""

COMPONENTS = 32
"""The most images that one is joined from."""

_REMEDY = "attach them again: publish the image again"
_SBOM = re.compile(r"([a-z0-9]+(?:[._/-]+[a-z0-9]+)*)@(sha256:[0-9a-f]{64})")

Text = Annotated[str, Field(max_length=4096)]
Relation = Annotated[str, Field(max_length=1 << 17)]
Symbol = Annotated[str, Field(max_length=1 << 17)]
Number = Annotated[int, Field(ge=0, lt=1 << 16)]


class _Model(Shape):
    model_config = ConfigDict(strict=True, frozen=True)


class Package(_Model):
    """A package of the operating system, with dpkg's own words."""

    name: Text
    architecture: Text
    version: Text
    provides: Relation = ""
    depends: Relation = ""  # Pre-Depends and Depends
    conflicts: Relation = ""  # Conflicts and Breaks
    files: list[Text] = []  # of an app's package, its files in the app's layer, without a slash at the beginning


class Library(_Model):
    """A library; of an app, also a program."""

    path: Text  # without a slash at the beginning
    soname: Text  # empty if it has none
    id: str = Field(pattern=r"^[0-9a-f]{8,64}$")  # the same for the same file: its build ID, or a digest
    names: list[Text] = []  # of links to it, if they are neither its own nor its soname
    machine: list[Number] = Field(min_length=3, max_length=3)  # class, byte order and machine, as ELF has them
    needed: list[Text]  # sonames of the libraries that it loads
    symbols: str = Field(pattern=r"^([A-Za-z0-9_-]{4})*$")  # what it exports; ask `exports`
    uses: list[Symbol] = []  # `name` or `name@VERSION`: those that no file of the app exports. Weak ones do not count

    @functools.cached_property
    def groups(self) -> frozenset[str]:
        """The symbols that it exports, as `hashed` has them."""
        return frozenset(self.symbols[place : place + 4] for place in range(0, len(self.symbols), 4))


class Import(_Model):
    """A module of the base image that an app imports."""

    module: Text  # its first name, such as `torch`
    file: Text  # the first file of the app that imports it in any case, below the install space


class Facts(_Model):
    """The facts of an image. Those of an app are about its layer alone."""

    packages: list[Package]
    libraries: list[Library]  # of a base image or a part, libraries that export something; of an app also programs
    files: list[Text] = []  # of an app, those of none of its packages, without a slash at the beginning
    imports: list[Import] | None = (
        None  # of an app, by its Python, of its base image; None if an older version built it
    )
    asks: list[Text] = []  # of an app, packages of apt that it asks for by name and that its base image has
    asks_pip: list[Text] = []  # the same of pip, by their normalized names


def parse(data: bytes) -> Facts:
    try:
        return Facts.model_validate(untrusted.json_value(archives.gunzipped(data, LARGEST), LARGEST))
    except ValueError as error:
        reason = first_of(error) if isinstance(error, ValidationError) else error
        raise RosmlError(f"the facts of an image are damaged: {reason}", _REMEDY) from None


def together(images: Iterable[Facts]) -> Facts:
    """The facts of several images as one, such as of a ROS image and its parts, without duplicates."""
    every = list(images)
    imports = {item.module: item for facts in every for item in facts.imports or ()}
    return Facts.model_construct(
        packages=[*{item.model_dump_json(): item for facts in every for item in facts.packages}.values()],
        libraries=[*{item.model_dump_json(): item for facts in every for item in facts.libraries}.values()],
        files=[*dict.fromkeys(file for facts in every for file in facts.files)],
        imports=None if any(facts.imports is None for facts in every) else [*imports.values()],
        asks=[*dict.fromkeys(name for facts in every for name in facts.asks)],
        asks_pip=[*dict.fromkeys(name for facts in every for name in facts.asks_pip)],
    )


# ---- Symbols ---------------------------------------------------------------------------------------------------------


def exports(library: Library, symbol: str) -> bool:
    """Whether a library exports `name`, or `name@VERSION`. For each of its symbols, one in 17 million others counts as there, too."""
    group = hashed(symbol)
    place = library.symbols.find(group)
    while place % 4 and place > 0:  # between two others
        place = library.symbols.find(group, place + 1)
    return place >= 0


def lacking(symbols: Iterable[str], libraries: Iterable[Library]) -> list[str]:
    """The symbols that no library exports, in order."""
    missing = {hashed(symbol): symbol for symbol in symbols}
    for library in libraries:
        if not missing:
            break
        for group in missing.keys() & library.groups:
            del missing[group]
    return sorted(missing.values())


def hashed(symbol: str) -> str:
    """The four characters that stand for a symbol."""
    return base64.urlsafe_b64encode(hashlib.sha256(symbol.encode()).digest()[:3]).decode()


# ---- In a registry ---------------------------------------------------------------------------------------------------


def of(registry: Registry, repository: str, digest: str) -> Facts | None:
    """The facts that are attached to an image manifest, by all publishers together."""
    artifacts = attached(registry, repository, digest, ARTIFACT, "documents of facts")
    parts = {artifact.layers[0].digest: artifact.layers[0] for artifact in artifacts if artifact.layers}
    every = [parse(registry.part(repository, part, PACKED)) for part in parts.values()]
    return together(every) if len(every) > 1 else next(iter(every), None)


def components(
    registry: Registry, repository: str, digest: str, annotations: Mapping[str, str], near: Iterable[str] = ()
) -> list[tuple[str, str]]:
    """Repositories and digests of the ROS image and parts that an image was joined from, by annotations in its index; empty if unknown."""
    sboms = [text for name, text in sorted(annotations.items()) if name.startswith(COVERED)]
    digests = annotations.get(JOINED, "").split()
    if not (sboms or digests) or max(len(sboms), len(digests)) > COMPONENTS:
        return []
    prefix = repository.rpartition("/")[0]
    if digests:
        beside = [f"{prefix}/{name}" if prefix else name for name in (names.ROS, PARTS, ENVIRONMENTS)]
        places = [_in(registry, dict.fromkeys([*near, *beside, repository]), item) for item in digests]
    else:
        places = [_described(registry, prefix, item) for item in sboms]
    parts = [item for item in places if item]
    image = registry.manifest(repository, digest)
    # An index that was made after a part changed lacks the annotation of that part.
    layers = sorted(layer.digest for _, part in parts for layer in part.layers)
    whole = image and len(parts) == len(places) and layers == sorted(layer.digest for layer in image.layers)
    return [(path, part.digest) for path, part in parts] if whole else []


def _in(registry: Registry, repositories: Iterable[str], digest: str) -> tuple[str, Manifest] | None:
    if not references.is_digest(digest):
        return None
    every = ((path, registry.manifest(path, digest)) for path in repositories)
    return next(((path, part) for path, part in every if part), None)


def _described(registry: Registry, prefix: str, text: str) -> tuple[str, Manifest] | None:
    """The manifest to which an SBOM is attached, by the SBOM's repository and digest."""
    if not (match := _SBOM.fullmatch(text)):
        return None
    path = f"{prefix}/{match[1]}" if prefix else match[1]
    artifact = registry.manifest(path, match[2])
    part = registry.manifest(path, artifact.subject) if artifact and artifact.subject else None
    return (path, part) if part else None


def of_member(registry: Registry, repository: str, digest: str, annotations: Mapping[str, str]) -> Facts | None:
    """The facts of a base image, or of its ROS image and parts together; None if one has none: it would look like an image without it."""
    if direct := of(registry, repository, digest):
        return direct
    places = components(registry, repository, digest, annotations)
    parts = [of(registry, *place) for place in places if place[1] != digest]
    present = [facts for facts in parts if facts]
    return together(present) if present and len(present) == len(parts) else None
