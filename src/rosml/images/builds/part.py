"""Builds parts for all their architectures, pushes them by digest, and tags them.

A part is built on an operating system that has its Python, which compiles the bytecode. If this machine uses another
base image, that may have another release of Python, or no Python and so no bytecode. Such a part has other digests than
the published one, and the result says so.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.images.builds import base_images
from rosml.images.builds.push import push_by_digest, write_excerpt
from rosml.images.image_set import restricted
from rosml.images.image_set.model import ImageSet, Part
from rosml.images.image_set.restricted import Declared
from rosml.images.join.layers import platform as platform_of
from rosml.images.matrix import names
from rosml.images.matrix.model import ANY_PYTHON
from rosml.machine import buildx
from rosml.machine.services import NAMESPACE, Services
from rosml.registry import references
from rosml.registry.client import Registry


@dataclass(frozen=True)
class Assembled:
    """A part in the registry.

    Attributes:
        name: such as `torch-cu128-py311`.
        reference: with the digest, and with the tag if that was moved.
        digest: of the index, or of the manifest if there is one platform.
        layers: digest and size in bytes of the part's one layer, by platform.
        assembled_on: the base image, in words.
        bytecode: the version of Python that compiled it; empty if there is no bytecode.
        seconds: wall time.
    """

    name: str
    reference: str
    digest: str
    layers: Mapping[str, tuple[str, int]]
    assembled_on: str
    bytecode: str
    seconds: float

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)


def find(image_set: ImageSet, name: str) -> Part:
    """The part with a name or bake target.

    Raises:
        RosmlError: there is no such part (exit code 2).
    """
    part = image_set.part_by_name.get(name.removeprefix("part-"))
    if part is None:
        text = unknown("part", name, image_set.part_by_name)
        raise RosmlError(text, "see all with: rosml part", exit_code=2)
    return part


def publish(
    services: Services,
    image_set: ImageSet,
    part: Part,
    say: Callable[[str], None],
    namespace: str = NAMESPACE,
    again: bool = False,
    platform: str = "",
) -> Assembled:
    """Builds a part for all architectures whose lock is up to date. Moves its tag if these are all its architectures.

    Args:
        services: registry and builder.
        image_set: all that the matrix describes.
        part: the part to build.
        say: prints a line of progress.
        namespace: first part of the repository's name.
        again: build without the builder's cache. The same inputs give the same digests.
        platform: build only for this one. Then no tag moves.

    Raises:
        RosmlError: a lock is missing, the base image is not available, a service is down, or the build failed.
    """
    started = time.monotonic()
    if platform and platform not in part.platforms:
        known = ", ".join(part.platforms)
        raise RosmlError(f"part {part.name} is for {known}", f"choose one of them, not {platform}", exit_code=2)
    platforms = [
        name
        for name, lock in zip(part.platforms, part.locks, strict=True)
        if platform in ("", name) and lock not in part.unlocked
    ]
    if not platforms:
        text = f"part {part.name} has no lock for the present matrix.yaml: {listed(part.unlocked)}"
        raise RosmlError(text, "run 'rosml locks'")
    prefix = f"{services.registry}/{namespace}"
    repository = f"{prefix}/part"
    base, digest = push(services, image_set, part, say, prefix, platforms, again)
    reference = f"{repository}@{digest}"
    with Registry(services.registry, ca_bundle=services.ca_bundle) as client:
        layers = dict(_layers(client, f"{namespace}/part", digest, platforms))
        if len(platforms) == len(part.platforms):  # a tag is for all platforms
            client.tag(f"{namespace}/part", digest, part.name)
            reference = f"{repository}:{part.name}@{digest}"
    python = base.python if part.python != ANY_PYTHON else ""
    said = _said(part, base)
    return Assembled(part.name, reference, digest, layers, said, python, time.monotonic() - started)


def push(
    services: Services,
    image_set: ImageSet,
    part: Part,
    say: Callable[[str], None],
    prefix: str,
    platforms: list[str],
    again: bool = False,
) -> tuple[base_images.Assembler, str]:
    """Builds a part for some platforms, and pushes it by digest into the repository `part` below a prefix.

    Returns:
        The image that it was built on, and the digest of the index; of the manifest, if there is one platform.

    Raises:
        RosmlError: the base image is not available, or the build failed; the part is restricted, and may not go there (exit code 2).
    """
    base, call = bake(services, image_set, part, say, prefix, platforms, again)
    _, digest = push_by_digest(services, call, f"{prefix}/part")
    return base, digest


def bake(
    services: Services,
    image_set: ImageSet,
    part: Part,
    say: Callable[[str], None],
    prefix: str,
    platforms: list[str],
    again: bool = False,
) -> tuple[base_images.Assembler, buildx.Bake]:
    """The call that builds a part, as in `push`, and the image that it is built on.

    Raises:
        RosmlError: the base image is not available; the part is restricted, and may not go there (exit code 2).
    """
    place = references.parse(f"{prefix}/part")
    kinds = restricted.of(image_set.matrix, [part.kind])
    told = restricted.require(kinds, part.name, place.host, place.repository, Declared.of(image_set.matrix))
    if told:
        say(told)
    base = base_images.assembler(services, image_set.matrix.operating_systems, part.os, part.python)
    file = write_excerpt(services, image_set, part.target)
    sets = [
        f"{part.target}.tags=",
        f"{part.target}.platform={','.join(platforms)}",
    ]
    if not base.python and part.python != ANY_PYTHON:
        sets.append(f"{part.target}.args.BYTECODE=none")
    if again:
        sets.append(f"{part.target}.no-cache=true")
    variables = {"REGISTRY": prefix, names.os_variable(part.os): f"docker-image://{base.reference}"}
    say(f"part {part.name} for {', '.join(platforms)}, built on {_said(part, base)}")
    return base, buildx.Bake(part.target, part.target, file, tuple(sets), variables, shares=buildx.IMAGES)


def _said(part: Part, base: base_images.Assembler) -> str:
    """The base image that a part is built on, in words."""
    without = f", without bytecode: it has no Python {part.python}"
    return base.reference + ("" if base.python or part.python == ANY_PYTHON else without)


def _layers(
    registry: Registry, repository: str, digest: str, platforms: list[str]
) -> Iterator[tuple[str, tuple[str, int]]]:
    """The layer of each platform, as digest and size in bytes.

    Raises:
        RosmlError: the manifest in the registry is not that of a part.
    """
    found = registry.manifest(repository, digest)
    images = {platforms[0]: found}  # one platform only
    if found and found.is_index:
        images = {platform_of(entry.platform): registry.manifest(repository, entry.digest) for entry in found.members}
    for platform, manifest in images.items():
        if manifest is None or len(manifest.layers) != 1:
            text = f"{registry.host}/{repository}@{digest} is not a part with one layer for each platform"
            raise RosmlError(text, "run it again")
        yield platform, (manifest.layers[0].digest, manifest.layers[0].size)


def markdown(found: Iterable[Assembled]) -> str:
    """A table of parts with their digests, for docs/digests.md."""
    lines = ["| part | platform | layer | MB | bytecode |", "| --- | --- | --- | ---: | --- |"]
    for item in found:
        for platform, (digest, size) in item.layers.items():
            bytecode = item.bytecode or ("none" if "-py" in item.name else "no Python in it")
            lines.append(f"| `{item.name}` | {platform} | `{digest}` | {size / 1e6:.1f} | {bytecode} |")
    return "\n".join(lines) + "\n"
