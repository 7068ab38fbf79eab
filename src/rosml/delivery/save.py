"""Writes an image of a registry into an OCI archive, without layers that its reader has. Of a layer that replaces one that the reader has, the
archive gets what differs, if that is much smaller. Other layers stream from the registry into it."""

from __future__ import annotations

import contextlib
import hashlib
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import IO, Any, BinaryIO

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.delivery import apply_patch, archive, make_patch
from rosml.delivery.pulled_layers import OlderLayer, replaced, shared, unique
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
    """What goes into an archive. `left_out` has layers that stay out, each with the image that has it; `replaced` those that may go in as a
    patch. `name` is the image's complete reference, as the user gave it."""

    image: Source
    name: str
    left_out: dict[str, Source]
    replaced: dict[str, OlderLayer]

    @property
    def layers(self) -> dict[str, int]:
        """The layers that go into it, with their sizes in bytes."""
        return {name: layer.size for name, layer in unique(self.image).items() if name not in self.left_out}

    @property
    def bytes(self) -> int:
        """What is read from registries: these layers, and those that they replace."""
        return sum(self.layers.values()) + sum(older.size for older in self.replaced.values())


@dataclass(frozen=True)
class Saved:
    """An image in an archive. Sizes are in bytes; `patched_bytes` is the size of the layers that the archive has as patches."""

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


def plan(image: Source, name: str, have: Sequence[Source]) -> Plan:
    if not image.manifest.layers or len(image.manifest.layers) != len(image.diff_ids):
        raise RosmlError(f"{image.name} is incomplete: its config does not list its layers", "push it again")
    return Plan(image, name, shared(image, have), replaced(image, have))


@dataclass(frozen=True)
class _Blob:
    """A blob in a temporary file: a layer, or a patch that makes it."""

    file: IO[bytes]
    digest: str
    size: int
    is_patch: bool

    def send(self, write: archive.Write) -> None:
        archive.send_file(self.file, write)


def write(plan: Plan, registries: Registries, out: BinaryIO, advance: archive.Advance = lambda _: None) -> Saved:
    """Writes an archive into a file or a pipe. The same plan gives the same bytes, with the same version of zstd.

    Raises:
        RosmlError: a layer is damaged; the registry does not answer or refuses.
        OSError: the file cannot be written.
    """
    started, image = time.monotonic(), plan.image
    with contextlib.ExitStack() as stack:
        blobs = {digest: _blob(plan, digest, registries, stack, advance) for digest in plan.replaced}
        patches = {digest: blob for digest, blob in blobs.items() if blob.is_patch}
        registry = registries(image.host)
        writer = archive.Writer(out)
        _write_documents(writer, plan, patches, registry)
        for digest, size in plan.layers.items():
            if blob := blobs.get(digest):
                writer.blob(blob.digest, blob.size, blob.send)
            else:
                writer.blob(digest, size, partial(_fetch, registry, image.repository, digest, size), advance)
        writer.end()
        patch_bytes = sum(blob.size for blob in patches.values())
    layers = [size for digest, size in plan.layers.items() if digest not in patches]
    patched_bytes = sum(plan.layers[digest] for digest in patches)
    absent = [layer.size for digest, layer in unique(image).items() if digest in plan.left_out]
    counts = len(layers), sum(layers), len(patches), patch_bytes, patched_bytes, len(absent), sum(absent)
    return Saved(plan.name, image.digest, image.platform, *counts, time.monotonic() - started)


def _write_documents(writer: archive.Writer, plan: Plan, patches: Mapping[str, _Blob], registry: Registry) -> None:
    """Writes index, manifest and config: all but the layers."""
    image, config = plan.image, plan.image.manifest.config
    assert config  # it has labels and diff IDs
    manifest = registry.raw_manifest(image.repository, image.digest)
    place = references.parse(plan.name)
    name = "" if references.is_digest(place.reference) else str(place)
    left_out: dict[str, list[str]] = {}
    for digest, other in plan.left_out.items():
        left_out.setdefault(_full_name(other), []).append(digest)
    if patches:
        left_out[f"{_full_name(image)} {NEWER}"] = [*patches]
    entries = {digest: _patch_entry(blob, plan.replaced[digest]) for digest, blob in patches.items()}
    writer.text(archive.INDEX, archive.index(image.manifest.descriptor, name, left_out, entries))
    layers = [layer.digest for layer in image.manifest.layers]
    writer.text(archive.DOCKER, archive.for_docker(config.digest, layers, name))
    writer.text(archive.path(image.digest), manifest)
    writer.text(archive.path(config.digest), registry.part(image.repository, config, CONFIG_BYTES))


def _blob(
    plan: Plan, digest: str, registries: Registries, stack: contextlib.ExitStack, advance: archive.Advance
) -> _Blob:
    """The patch that makes a layer of the one that it replaces; or the layer itself, if that is not much larger."""
    image, older, size = plan.image, plan.replaced[digest], plan.layers[digest]
    diff_ids = {layer.digest: diff_id for layer, diff_id in zip(image.manifest.layers, image.diff_ids, strict=True)}
    layer = _Blob(stack.enter_context(files.temporary()), digest, size, False)
    _receive(registries(image.host), image.repository, layer, advance)
    with files.temporary() as older_file, files.temporary() as before, files.temporary() as after:
        older_blob = _Blob(older_file, older.digest, older.size, False)
        _receive(registries(older.image.host), older.image.repository, older_blob, advance)
        patch_file = stack.enter_context(files.temporary())
        state, length = hashlib.sha256(), 0
        try:
            apply_patch.unpack(older_file, older.diff_id, before)
            apply_patch.unpack(layer.file, diff_ids[digest], after)
            for block in make_patch.make(before, after):
                patch_file.write(block)
                state.update(block)
                length += len(block)
                if length > WORTH * size:
                    return layer
        except ValueError:  # whoever unpacks the layer says what is wrong with it
            return layer
    layer.file.close()
    return _Blob(patch_file, f"sha256:{state.hexdigest()}", length, True)


def _receive(registry: Registry, repository: str, blob: _Blob, advance: archive.Advance) -> None:
    send = partial(_fetch, registry, repository, blob.digest, blob.size)
    archive.receive(blob.digest, blob.size, send, blob.file, advance)


def _patch_entry(blob: _Blob, older: OlderLayer) -> dict[str, Any]:
    """As `archive.PATCHES` has it."""
    layer = {"digest": older.digest, "diff_id": older.diff_id, "size": older.size}
    entry = {"mediaType": apply_patch.MEDIA_TYPE, "digest": blob.digest, "size": blob.size}
    return {**entry, "old": layer, "image": _full_name(older.image)}


def _fetch(registry: Registry, repository: str, digest: str, size: int, write: archive.Write) -> None:
    registry.read_blob(repository, digest, write, size)


def _full_name(image: Source) -> str:
    return f"{image.name.partition('@')[0]}@{image.digest}"
