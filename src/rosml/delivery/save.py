"""Writes an image of a registry into an OCI archive, without layers that its reader has. Of a layer that replaces one that the reader has, the
archive gets what differs, if that is much smaller. Other layers stream from the registry into it."""

from __future__ import annotations

import contextlib
import hashlib
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from typing import IO, Any, BinaryIO

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.delivery import archive, patch
from rosml.delivery.delta import Old, replaced, shared, unique
from rosml.images.join.layers import Source
from rosml.registry import references
from rosml.registry.client import CONFIG_BYTES, Registries, Registry

WORTH = 0.8
"""The largest patch beside its layer. Above, the layer itself is in the archive."""

NEWER = "or a newer rosml"
"""What follows the name of an image in the annotation about left out layers, if there are patches for these. An older rosml says in its
message that it needs one of the two."""


@dataclass(frozen=True)
class Plan:
    """What goes into an archive.

    Attributes:
        image: for one platform.
        named: the image's complete reference, as it was named.
        left_out: the layers that stay out, each with the image that has it.
        replaced: layers that go into it, as a patch if that is much smaller; each with the layer that it replaces.
    """

    image: Source
    named: str
    left_out: dict[str, Source]
    replaced: dict[str, Old]

    @property
    def layers(self) -> dict[str, int]:
        """The layers that go into it, with their sizes in bytes."""
        return {name: layer.size for name, layer in unique(self.image).items() if name not in self.left_out}

    @property
    def bytes(self) -> int:
        """The size of these layers, and of those that they replace: what is read from registries."""
        return sum(self.layers.values()) + sum(old.size for old in self.replaced.values())


@dataclass(frozen=True)
class Saved:
    """An image in an archive. Sizes are in bytes.

    Attributes:
        image: its complete reference. digest: of its manifest. platform: such as `linux/arm64`.
        layers: how many layers are in the archive. bytes: their size.
        patches: how many layers are in it as what differs from an older one. patch_bytes: the size of that. patched_bytes: that of the layers.
        left_out: how many are not. left_out_bytes: their size.
        seconds: wall time.
    """

    image: str
    digest: str
    platform: str
    layers: int
    bytes: int
    patches: int
    patch_bytes: int
    patched_bytes: int
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
    return Plan(image, named, shared(image, have), replaced(image, have))


@dataclass(frozen=True)
class _Kept:
    """A blob in a file that goes away. `patched` says whether it is a patch instead of the layer."""

    file: IO[bytes]
    digest: str
    size: int
    patched: bool

    def send(self, write: Callable[[Iterable[bytes]], None]) -> None:
        """Sends it, as `Writer.blob` asks for it."""
        archive.again(self.file, write)


def write(
    wanted: Plan, registries: Registries, out: BinaryIO, advance: Callable[[int], object] = lambda _: None
) -> Saved:
    """Writes an archive. The same plan gives the same bytes, with the same version of zstd.

    Args:
        wanted: what goes into it.
        registries: gives the client of a host.
        out: where it goes; nothing is sought in it, so it may be a pipe.
        advance: is called with numbers of bytes of layers that were read.

    Raises:
        RosmlError: a layer is damaged; the registry does not answer or refuses.
        OSError: it cannot be written.
    """
    with contextlib.ExitStack() as stack:
        return _write(wanted, registries, out, advance, stack)


def _write(
    wanted: Plan,
    registries: Registries,
    out: BinaryIO,
    advance: Callable[[int], object],
    stack: contextlib.ExitStack,
) -> Saved:
    started, image = time.monotonic(), wanted.image
    registry = registries(image.host)
    config = image.manifest.config
    assert config  # it has labels and diff IDs
    manifest = registry.raw_manifest(image.repository, image.digest)
    facts = registry.part(image.repository, config, CONFIG_BYTES)
    where = references.parse(wanted.named)
    name = "" if references.is_digest(where.reference) else str(where)
    left_out: dict[str, list[str]] = {}
    for digest, other in wanted.left_out.items():
        left_out.setdefault(_known_as(other), []).append(digest)
    kept = {digest: _patch(wanted, digest, registries, stack, advance) for digest in wanted.replaced}
    patches = {digest: made for digest, made in kept.items() if made.patched}
    if patches:
        left_out[f"{_known_as(image)} {NEWER}"] = [*patches]
    told = {digest: _told(made, wanted.replaced[digest]) for digest, made in patches.items()}
    writer = archive.Writer(out)
    writer.text(archive.INDEX, archive.index(image.manifest.descriptor, name, left_out, told))
    layers = [layer.digest for layer in image.manifest.layers]
    writer.text(archive.DOCKER, archive.for_docker(config.digest, layers, name))
    writer.text(archive.path(image.digest), manifest)
    writer.text(archive.path(config.digest), facts)
    for digest, size in wanted.layers.items():
        if made := kept.get(digest):
            writer.blob(made.digest, made.size, made.send)
        else:
            writer.advance = advance
            writer.blob(digest, size, partial(_fetch, registry, image.repository, digest, size))
            writer.advance = _nothing
    writer.end()
    whole = [size for digest, size in wanted.layers.items() if digest not in patches]
    left = [layer.size for name, layer in unique(image).items() if name in wanted.left_out]
    counts = len(whole), sum(whole), len(patches), sum(made.size for made in patches.values())
    patched = sum(wanted.layers[digest] for digest in patches)
    seconds = time.monotonic() - started
    return Saved(wanted.named, image.digest, image.platform, *counts, patched, len(left), sum(left), seconds)


def _patch(
    wanted: Plan,
    digest: str,
    registries: Registries,
    stack: contextlib.ExitStack,
    advance: Callable[[int], object],
) -> _Kept:
    """What makes a layer of the one that it replaces; or the layer itself, if that is not much larger."""
    image, old, size = wanted.image, wanted.replaced[digest], wanted.layers[digest]
    diff_ids = {layer.digest: diff_id for layer, diff_id in zip(image.manifest.layers, image.diff_ids, strict=True)}
    layer = _Kept(stack.enter_context(files.temporary()), digest, size, False)
    _receive(registries(image.host), image.repository, layer, advance)
    with files.temporary() as older, files.temporary() as before, files.temporary() as after:
        _receive(registries(old.image.host), old.image.repository, _Kept(older, old.digest, old.size, False), advance)
        made = stack.enter_context(files.temporary())
        state, length = hashlib.sha256(), 0
        try:
            patch.unpack(older, old.diff_id, before)
            patch.unpack(layer.file, diff_ids[digest], after)
            for block in patch.make(before, after):
                made.write(block)
                state.update(block)
                length += len(block)
                if length > WORTH * size:
                    return layer
        except ValueError:  # whoever unpacks the layer says what is wrong with it
            return layer
    layer.file.close()
    return _Kept(made, f"sha256:{state.hexdigest()}", length, True)


def _receive(registry: Registry, repository: str, kept: _Kept, advance: Callable[[int], object]) -> None:
    send = partial(_fetch, registry, repository, kept.digest, kept.size)
    archive.verified(kept.digest, kept.size, send, kept.file, advance)


def _told(made: _Kept, old: Old) -> dict[str, Any]:
    """The entry about a patch, as `archive.PATCHES` has it."""
    below = {"digest": old.digest, "diff_id": old.diff_id, "size": old.size}
    entry = {"mediaType": patch.MEDIA_TYPE, "digest": made.digest, "size": made.size}
    return {**entry, "old": below, "image": _known_as(old.image)}


def _nothing(_: int) -> None:
    """Tells nobody."""


def _fetch(
    registry: Registry, repository: str, digest: str, size: int, write: Callable[[Iterable[bytes]], None]
) -> None:
    registry.read_blob(repository, digest, write, size)


def _known_as(image: Source) -> str:
    """The name of an image with its digest, for people on the other machine."""
    return f"{image.name.partition('@')[0]}@{image.digest}"
