"""Writes an image of a registry into an OCI archive, without layers that its reader has. Layers stream from the registry into it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any, BinaryIO

from rosml.base.errors import RosmlError
from rosml.containerize.delivery import archive
from rosml.containerize.delivery.delta import shared, unique
from rosml.images.join.layers import Source
from rosml.registry import references
from rosml.registry.client import CONFIG_BYTES, Registry


@dataclass(frozen=True)
class Plan:
    """What goes into an archive.

    Attributes:
        image: for one platform.
        named: the image's complete reference, as it was named.
        left_out: the layers that stay out, each with the image that has it.
    """

    image: Source
    named: str
    left_out: dict[str, Source]

    @property
    def layers(self) -> dict[str, int]:
        """The layers that go into it, with their sizes in bytes."""
        return {name: layer.size for name, layer in unique(self.image).items() if name not in self.left_out}

    @property
    def bytes(self) -> int:
        """The size of these layers."""
        return sum(self.layers.values())


@dataclass(frozen=True)
class Saved:
    """An image in an archive. Sizes are in bytes.

    Attributes:
        image: its complete reference. digest: of its manifest. platform: such as `linux/arm64`.
        layers: how many layers are in the archive. bytes: their size.
        left_out: how many are not. left_out_bytes: their size.
        seconds: wall time.
    """

    image: str
    digest: str
    platform: str
    layers: int
    bytes: int
    left_out: int
    left_out_bytes: int
    seconds: float

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)


def plan(image: Source, named: str, have: Sequence[Source]) -> Plan:
    """Computes what goes into an archive.

    Args:
        image: for one platform.
        named: its complete reference, as it was named.
        have: images of the machine that will read it.

    Raises:
        RosmlError: the image's config does not list its layers.
    """
    if not image.manifest.layers or len(image.manifest.layers) != len(image.diff_ids):
        raise RosmlError(f"{image.name} is incomplete: its config does not list its layers", "push it again")
    return Plan(image, named, shared(image, have))


def write(wanted: Plan, registry: Registry, out: BinaryIO, advance: Callable[[int], object] = lambda _: None) -> Saved:
    """Writes an archive. The same plan gives the same bytes.

    Args:
        wanted: what goes into it.
        registry: of the image.
        out: where it goes; nothing is sought in it, so it may be a pipe.
        advance: is called with numbers of bytes of layers that were written.

    Raises:
        RosmlError: a layer is damaged; the registry does not answer or refuses.
        OSError: it cannot be written.
    """
    started, image = time.monotonic(), wanted.image
    config = image.manifest.config
    assert config  # it has labels and diff IDs
    manifest = registry.raw_manifest(image.repository, image.digest)
    told = registry.part(image.repository, config, CONFIG_BYTES)
    where = references.parse(wanted.named)
    name = "" if references.is_digest(where.reference) else str(where)
    left_out: dict[str, list[str]] = {}
    for digest, other in wanted.left_out.items():
        left_out.setdefault(_known_as(other), []).append(digest)
    writer = archive.Writer(out)
    writer.text(archive.INDEX, archive.index(image.manifest.descriptor, name, left_out))
    layers = [layer.digest for layer in image.manifest.layers]
    writer.text(archive.DOCKER, archive.for_docker(config.digest, layers, name))
    writer.text(archive.path(image.digest), manifest)
    writer.text(archive.path(config.digest), told)
    writer.advance = advance
    for digest, size in wanted.layers.items():
        writer.blob(digest, size, partial(_fetch, registry, image.repository, digest, size))
    writer.end()
    left = sum(layer.size for name, layer in unique(image).items() if name in wanted.left_out)
    counts = len(wanted.layers), wanted.bytes, len(wanted.left_out), left
    return Saved(wanted.named, image.digest, image.platform, *counts, time.monotonic() - started)


def _fetch(
    registry: Registry, repository: str, digest: str, size: int, write: Callable[[Iterable[bytes]], None]
) -> None:
    registry.read_blob(repository, digest, write, size)


def _known_as(image: Source) -> str:
    """The name of an image with its digest, for people on the other machine."""
    return f"{image.name.partition('@')[0]}@{image.digest}"
