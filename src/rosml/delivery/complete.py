"""Completes an archive of `save` with layers that this machine has, for an engine or for a file.

An engine gets the list of what is in the image last, so it loads nothing unless each layer had its digest.
"""

from __future__ import annotations

import contextlib
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import IO, BinaryIO

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.problems import counted, some
from rosml.delivery import apply_patch, archive
from rosml.delivery.archive import Advance, Archive, Write, Writer
from rosml.delivery.image import PLAIN_LAYER, Image, Layer
from rosml.delivery.sources import LayerBlob, Source, send_blob
from rosml.registry import oci

Choice = Sequence[tuple[Source, Sequence[Layer]]]
"""Which source gives which layers."""


def choose(image: Image, sources: Iterable[Source], held: Container[str] = ()) -> Choice:
    """Which source gives which of the missing layers: as few sources as possible. If none gives a layer that has a patch, one gives the older
    layer.

    Args:
        held: digests of layers that nobody has to give.

    Raises:
        RosmlError: nobody has one of them (exit code 2).
    """
    unused, choice = list(sources), list[tuple[Source, Sequence[Layer]]]()
    needed = dict[str, Layer]()
    for layer in image.missing:
        if layer.digest not in held:
            layer_patch = image.patches.get(layer.digest)
            if layer_patch and not any(source.has(layer) for source in unused):
                layer = layer_patch.older
            needed.setdefault(layer.digest, layer)
    missing = list(needed.values())
    while missing and unused:
        offers = [(source, [layer for layer in missing if source.has(layer)]) for source in unused]
        source, layers = max(offers, key=lambda pair: len(pair[1]))
        if not layers:
            break
        choice.append((source, layers))
        missing = [layer for layer in missing if layer not in layers]
        unused = [other for other in unused if other is not source]
    if missing:
        raise _lacking(image, missing)
    return choice


def _lacking(image: Image, missing: Sequence[Layer]) -> RosmlError:
    digests = {layer.digest for layer in missing}
    owners = [name for name, absent in image.left_out.items() if digests & {*absent}]
    names = list(dict.fromkeys([*owners, *(item.image for item in image.patches.values() if item.older in missing)]))
    what = f"{counted(len(missing), 'layer')} of {some(names)}"
    remedy = f"pull {'it' if len(names) == 1 else 'them'} here, say with --from who has them, or save the image again without"
    remedy += " that --have" if len(names) == 1 else " those --have"
    return RosmlError(f"{image.file.name} needs {what}, which this machine lacks", remedy, exit_code=2)


def complete(
    image: Image, choice: Choice, out: BinaryIO, advance: Advance = lambda _: None, held: Container[str] = ()
) -> str:
    """Writes the whole archive into a file or a pipe. What makes an image of it comes last.

    Args:
        held: digests of layers that the reader has, and that stay out.

    Returns:
        The digest of the image in it. It is another one than before if a source gives a layer uncompressed.

    Raises:
        RosmlError: a layer is damaged, or a source does not give what it has.
        OSError: it cannot be written.
    """
    writer = Writer(out)
    blobs: dict[str, LayerBlob] = {}
    for digest, layer in image.layers.items():
        if digest in held or image.file.size(digest) is not None:
            blobs[digest] = LayerBlob(layer, digest, layer.size, partial(send_blob, image.file, digest))
        if digest in blobs and digest not in held:
            writer.blob(digest, layer.size, blobs[digest].send, advance)
    written = {*blobs}
    for blob in _missing_blobs(image, choice, [layer for layer in image.missing if layer.digest not in held]):
        if blob.digest not in written:
            writer.blob(blob.digest, blob.size, blob.send, advance)
            written.add(blob.digest)
        blobs[blob.layer.digest] = blob
    manifest = _manifest(image, blobs)
    writer.text(archive.path(image.identity), image.config)
    writer.text(archive.path(oci.digest_of(manifest)), manifest)
    writer.text(archive.INDEX, archive.index(oci.descriptor(image.media_type, manifest), image.name, {}))
    layers = [blobs[digest].digest for digest in image.order]
    writer.text(archive.DOCKER, archive.for_docker(image.identity, layers, image.name))
    writer.end()
    return oci.digest_of(manifest)


def _missing_blobs(image: Image, choice: Choice, missing: Sequence[Layer]) -> Iterator[LayerBlob]:
    """Missing layers, as sources give them, or made of older ones. Each must be sent before the next is asked for."""
    digests = {layer.digest for layer in missing}
    direct = {layer.digest for _, layers in choice for layer in layers} & digests
    for source, layers in choice:
        pending = {layer.digest: layer for layer in layers}
        for blob in source.take(layers):
            pending.pop(blob.layer.digest, None)
            patched = [
                layer
                for layer in missing
                if layer.digest not in direct and image.patches[layer.digest].older.digest == blob.layer.digest
            ]
            if not patched:
                yield blob
                continue
            with _unpacked(image.file, blob) as (packed, older):
                for layer in patched:
                    yield _patched(image, layer, older)
                if blob.layer.digest in direct:
                    yield packed
        if pending:
            lost = next(iter(pending.values()))
            raise RosmlError(f"{source.name} does not give {lost.diff_id}, which it has", "run it again")


@contextlib.contextmanager
def _unpacked(file: Archive, blob: LayerBlob) -> Iterator[tuple[LayerBlob, IO[bytes]]]:
    """A layer to send again, and a file of it without its compression."""
    with files.temporary() as packed, files.temporary() as plain:
        archive.receive(blob.digest, blob.size, blob.send, packed)
        try:
            apply_patch.unpack(packed, blob.layer.diff_id, plain)
        except ValueError as error:
            raise file.damaged(f"{blob.layer.digest}, which it replaces: {error}") from None
        yield replace(blob, send=partial(archive.send_file, packed)), plain


def _patched(image: Image, layer: Layer, older: IO[bytes]) -> LayerBlob:
    digest = image.patches[layer.digest].digest
    try:
        reader = apply_patch.Reader(image.file.blocks(digest), older.seek(0, 2))
    except ValueError as error:
        raise image.file.damaged(f"{digest}: {error}") from None

    def send(write: Write) -> None:
        try:
            write(reader.apply(older))
        except ValueError as error:
            raise image.file.damaged(f"{digest}: {error}") from None

    return LayerBlob(layer, layer.diff_id, reader.plan.size, send)


def _manifest(image: Image, blobs: Mapping[str, LayerBlob]) -> bytes:
    """The manifest as it was pushed; or one with uncompressed layers, if a source had them so."""
    if all(blob.digest == digest for digest, blob in blobs.items()):
        return image.manifest
    layers = []
    for entry in image.content["layers"]:
        blob = blobs[entry["digest"]]
        if blob.digest != entry["digest"]:
            entry = {"mediaType": PLAIN_LAYER[image.media_type], "digest": blob.digest, "size": blob.size}
        layers.append(entry)
    return oci.encoded({**image.content, "layers": layers})
