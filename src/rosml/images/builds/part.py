"""Builds parts for all their architectures, pushes them by digest, and tags them.

A part is built on an operating system that has its Python, which compiles the bytecode. If this machine uses another
base image, that may have another release of Python, or no Python and so no bytecode. Such a part has other digests than
the published one, and the result says so.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.images.builds import base_images
from rosml.images.builds.push import Push, push, write_excerpt
from rosml.images.image_set import restricted
from rosml.images.image_set.model import ImageSet, Part
from rosml.images.image_set.restricted import Declared
from rosml.images.join.layers import platform as platform_of
from rosml.images.matrix import names
from rosml.images.matrix.model import ANY_PYTHON
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registry
from rosml.registry.references import Reference


@dataclass(frozen=True)
class BuiltPart:
    """A part in the registry."""

    name: str
    reference: str  # with the digest, and with the tag if that was moved
    digest: str  # of the index, or of the manifest if there is one platform
    layers: Mapping[str, tuple[str, int]]  # digest and size in bytes of the part's one layer, by platform
    assembled_on: str  # the base image, in words
    bytecode: str  # the version of Python that compiled it; empty if there is no bytecode
    seconds: float

    def to_json(self) -> dict[str, Any]:
        return asdict(self)


def by_name(image_set: ImageSet, name: str) -> Part:
    """The part with a name or bake target; exit code 2 if there is none."""
    part = next((part for part in image_set.parts if name in (part.name, part.target)), None)
    if part is None:
        text = unknown("part", name, image_set.part_by_name)
        raise RosmlError(text, "see all with: rosml part", exit_code=2)
    return part


@dataclass(frozen=True)
class PartBuilder:
    """Builds parts into a registry, each into its repository."""

    services: Services
    image_set: ImageSet
    prefix: str  # the registry, and the path before `part`
    say: Callable[[str], None]
    again: bool = False  # build without the builder's cache. The same inputs give the same digests

    def _place(self, part: Part) -> Reference:
        return references.parse(f"{self.prefix}/{part.repository}")

    def publish(self, part: Part, platform: str = "") -> BuiltPart:
        """Builds a part for one platform, or all whose lock is up to date. Moves its tag if these are all that it has."""
        started = time.monotonic()
        platforms = _platforms(part, platform)
        base, call = self.bake(part, platforms)
        repository = f"{self.prefix}/{part.repository}"
        digest = push(self.services, Push(call, repository, self.image_set.matrix.compression))
        reference, path = f"{repository}@{digest}", self._place(part).repository
        with Registry(self.services.registry, ca_bundle=self.services.ca_bundle) as client:
            layers = dict(_layers(client, path, digest, platforms))
            if len(platforms) == len(part.platforms):  # a tag is for all platforms
                client.tag(path, digest, part.tag)
                reference = f"{repository}:{part.tag}@{digest}"
        python = base.python if part.python != ANY_PYTHON else ""
        seconds = time.monotonic() - started
        return BuiltPart(part.name, reference, digest, layers, _built_on(part, base), python, seconds)

    def bake(self, part: Part, platforms: Sequence[str]) -> tuple[base_images.Assembler, buildx.Bake]:
        """The image that a part is built on, and the call that builds it, if it is not restricted or may go there."""
        kinds = restricted.of(self.image_set.matrix, [part.kind])
        declared, place = Declared.of(self.image_set.matrix), self._place(part)
        if notice := restricted.require(kinds, part.name, place.host, place.repository, declared):
            self.say(notice)
        base = base_images.assembler(self.services, self.image_set.matrix.operating_systems, part.os, part.python)
        file = write_excerpt(self.services, self.image_set, part.target)
        sets = [f"{part.target}.tags=", f"{part.target}.platform={','.join(platforms)}"]
        if not base.python and part.python != ANY_PYTHON:
            sets.append(f"{part.target}.args.BYTECODE=none")
        if self.again:
            sets.append(f"{part.target}.no-cache=true")
        variables = {"REGISTRY": self.prefix, names.os_variable(part.os): f"docker-image://{base.reference}"}
        self.say(f"part {part.name} for {', '.join(platforms)}, built on {_built_on(part, base)}")
        return base, buildx.Bake(part.target, part.target, file, tuple(sets), variables, shares=buildx.IMAGES)


def _platforms(part: Part, platform: str) -> list[str]:
    """The platforms of a part that have a lock, or the one that the user chose."""
    if platform and platform not in part.platforms:
        text = f"part {part.name} is for {', '.join(part.platforms)}"
        raise RosmlError(text, f"choose one of them, not {platform}", exit_code=2)
    platforms = [
        name
        for name, lock in zip(part.platforms, part.locks, strict=True)
        if platform in ("", name) and lock not in part.unlocked
    ]
    if not platforms:
        text = f"part {part.name} has no lock for the present matrix.yaml: {listed(part.unlocked)}"
        raise RosmlError(text, "run 'rosml locks'")
    return platforms


def _built_on(part: Part, base: base_images.Assembler) -> str:
    without = f", without bytecode: it has no Python {part.python}"
    return base.reference + ("" if base.python or part.python == ANY_PYTHON else without)


def _layers(
    registry: Registry, repository: str, digest: str, platforms: Sequence[str]
) -> Iterator[tuple[str, tuple[str, int]]]:
    """Digest and size in bytes of each platform's layer."""
    manifest = registry.manifest(repository, digest)
    images = {platforms[0]: manifest}  # one platform only
    if manifest and manifest.is_index:
        images = {
            platform_of(entry.platform): registry.manifest(repository, entry.digest) for entry in manifest.members
        }
    for platform, image in images.items():
        if image is None or len(image.layers) != 1:
            text = f"{registry.host}/{repository}@{digest} is not a part with one layer for each platform"
            raise RosmlError(text, "run it again")
        yield platform, (image.layers[0].digest, image.layers[0].size)


def markdown(parts: Iterable[BuiltPart]) -> str:
    """A table of parts with their digests, for docs/digests.md."""
    lines = ["| part | platform | layer | MB | bytecode |", "| --- | --- | --- | ---: | --- |"]
    for part in parts:
        for platform, (digest, size) in part.layers.items():
            bytecode = part.bytecode or ("none" if "-py" in part.name else "no Python in it")
            lines.append(f"| `{part.name}` | {platform} | `{digest}` | {size / 1e6:.1f} | {bytecode} |")
    return "\n".join(lines) + "\n"
