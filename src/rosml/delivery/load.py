"""Completes an archive of `save` with layers that this machine has, for an engine or for a file.

The archive is a stranger's word. An engine gets the list of what is in the image last, so it loads nothing unless each layer had its digest.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import IO, Annotated, Any, BinaryIO, Protocol

from pydantic import ConfigDict, Field, RootModel, ValidationError

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import counted, first_of, some
from rosml.base.shapes import Shape
from rosml.delivery import archive, patch
from rosml.delivery.archive import Archive, Writer
from rosml.images.join import layers as joining
from rosml.registry import documents, oci, references
from rosml.registry.client import CONFIG_BYTES, Registry

JSON_BYTES = 4 << 20
"""Largest index and manifest, as registries take them."""

LAYERS = 1000
"""The most layers of an image. Docker allows 127."""

Send = Callable[[Callable[[Iterable[bytes]], None]], object]
"""Sends the pieces of a blob, as `Writer.blob` has it."""

_PLAIN = {
    oci.IMAGE: "application/vnd.oci.image.layer.v1.tar",
    oci.DOCKER_IMAGE: "application/vnd.docker.image.rootfs.diff.tar",
}
"""The media type of an uncompressed layer, by that of the manifest."""

_AGAIN = "save it again with rosml save"


@dataclass(frozen=True)
class Layer:
    """A layer of an image. `size` is in bytes, compressed.

    Attributes:
        digest: of the compressed layer.
        diff_id: of the uncompressed one.
    """

    digest: str
    diff_id: str
    size: int


@dataclass(frozen=True)
class Found:
    """A layer that a source has, compressed or not.

    Attributes:
        layer: the layer.
        digest: of what is sent: the layer's digest or its diff ID.
        size: of that, in bytes.
        send: sends it.
    """

    layer: Layer
    digest: str
    size: int
    send: Send


class Source(Protocol):
    """Where missing layers come from."""

    @property
    def name(self) -> str:
        """For messages."""

    def has(self, layer: Layer) -> bool:
        """Whether it has a layer."""

    def take(self, wanted: Sequence[Layer]) -> Iterable[Found]:
        """Gives layers that it has. Each must be sent before the next is asked for."""


@dataclass(frozen=True)
class Patch:
    """What makes a layer of an older one.

    Attributes:
        digest: of the patch. size: in bytes.
        old: the older layer.
        image: the name of an image that has it.
    """

    digest: str
    size: int
    old: Layer
    image: str


@dataclass
class Image:
    """An image in an archive, with layers or without.

    Attributes:
        file: the archive.
        name: the image's complete reference with a tag; empty if the archive names none.
        digest: of the manifest.
        manifest: as it was pushed.
        content: the same, as it was read.
        media_type: of the manifest.
        config: as it was pushed.
        facts: the same, as it was read.
        layers: by digest, lowest first.
        order: the digests of all layers, lowest first; one may be there twice.
        left_out: who has the layers that are not in the archive.
        patches: what makes some of these of older layers, by the digest of the new layer.
    """

    file: Archive
    name: str
    digest: str
    manifest: bytes
    content: dict[str, Any]
    media_type: str
    config: bytes
    facts: documents.Config
    layers: dict[str, Layer]
    order: list[str]
    left_out: dict[str, list[str]] = field(default_factory=dict)
    patches: dict[str, Patch] = field(default_factory=dict)

    @property
    def identity(self) -> str:
        """The digest of the config, by which engines know an image."""
        return oci.digest_of(self.config)

    @property
    def platform(self) -> str:
        """Such as `linux/arm64`."""
        return joining.platform(self.facts)

    @property
    def missing(self) -> list[Layer]:
        """The layers that are not in the archive."""
        return [layer for layer in self.layers.values() if self.file.size(layer.digest) is None]

    @property
    def replaced(self) -> list[Layer]:
        """The older layers that patches need."""
        return list({made.old.digest: made.old for made in self.patches.values()}.values())


# ---- Reading ---------------------------------------------------------------------------------------------------------


def read(file: Archive) -> Image:
    """The image of an archive.

    Raises:
        RosmlError: the archive is damaged, has not exactly one image (exit code 2), or lacks a layer that it does not name as left out.
    """
    index = _model(file, documents.Index, _json(file, file.text(archive.INDEX, JSON_BYTES), archive.INDEX))
    entries = index.manifests or []
    if len(entries) != 1:
        raise RosmlError(f"{file.name} has {counted(len(entries), 'image')}, not one", _AGAIN, exit_code=2)
    (entry,) = entries
    if entry.mediaType not in _PLAIN:
        text = f"{file.name} has no image for one platform, but {entry.mediaType[:100]}"
        raise RosmlError(text, "save the image for one platform with rosml save", exit_code=2)
    manifest = _blob(file, entry, JSON_BYTES)
    content = _json(file, manifest, "its manifest")
    known = _model(file, documents.Image, content)
    if known.config is None or known.config.mediaType not in (oci.CONFIG, oci.DOCKER_CONFIG):
        raise RosmlError(f"{file.name} has an artifact of another kind, no image", _AGAIN, exit_code=2)
    config = _blob(file, known.config, CONFIG_BYTES)
    facts = _model(file, documents.Config, _json(file, config, "its config"))
    diff_ids = (facts.rootfs and facts.rootfs.diff_ids) or []
    if not 0 < len(known.layers) <= LAYERS or len(known.layers) != len(diff_ids):
        raise file.damaged(f"its manifest has {len(known.layers)} layers, and its config {len(diff_ids)}")
    layers: dict[str, Layer] = {}
    for found, diff_id in zip(known.layers, diff_ids, strict=True):
        layer = layers.setdefault(found.digest, Layer(found.digest, diff_id, found.size))
        if layer != Layer(found.digest, diff_id, found.size):
            raise file.damaged(f"it says two things about {found.digest}")
        if (size := file.size(found.digest)) is not None and size != found.size:
            raise file.damaged(f"{found.digest} has {size} bytes instead of {found.size}")
    order = [found.digest for found in known.layers]
    name = _name(entry.annotations.get(archive.NAME, ""))
    left_out = _left_out(file, index.annotations.get(archive.LEFT_OUT, ""))
    patches = _patches(file, index.annotations.get(archive.PATCHES, ""))
    head = file, name, entry.digest, manifest, content, entry.mediaType, config
    image = Image(*head, facts, layers, order, left_out, patches)
    told = {digest for digests in left_out.values() for digest in digests}
    if lost := [layer.digest for layer in image.missing if layer.digest not in told]:
        raise file.damaged(f"it lacks {lost[0]}, which it does not name as left out")
    return image


def _blob(file: Archive, entry: documents.Descriptor, limit: int) -> bytes:
    if file.size(entry.digest) not in (None, entry.size):
        raise file.damaged(f"{entry.digest} has {file.size(entry.digest)} bytes instead of {entry.size}")
    return file.small_blob(entry.digest, limit)


def _json(file: Archive, data: bytes, what: str) -> dict[str, Any]:
    try:
        found = untrusted.json_value(data, CONFIG_BYTES)
    except ValueError as error:
        raise file.damaged(f"{what} is no JSON: {error}") from None
    if not isinstance(found, dict):
        raise file.damaged(f"{what} is no JSON object")
    return found


def _model(file: Archive, shape: Any, content: Mapping[str, Any]) -> Any:
    try:
        return shape.model_validate(content)
    except ValidationError as error:
        raise file.damaged(first_of(error)) from None


def _name(text: str) -> str:
    """The name of the image, if it is one that an engine takes."""
    try:
        where = references.parse(text)
    except RosmlError:
        return ""
    return "" if references.is_digest(where.reference) else str(where)


def _left_out(file: Archive, text: str) -> dict[str, list[str]]:
    found = _json(file, text.encode(), archive.LEFT_OUT) if text else {}
    for name, digests in found.items():
        right = isinstance(digests, list) and all(
            isinstance(item, str) and references.is_digest(item) for item in digests
        )
        if not right or len(name) > 1000:
            raise file.damaged(f"its annotation {archive.LEFT_OUT} is none of rosml")
    return found


class _Shape(Shape):
    model_config = ConfigDict(strict=True, frozen=True)


class _Old(_Shape):
    digest: documents.Digest
    diff_id: documents.Digest
    size: documents.Size


class _Patch(_Shape):
    mediaType: str
    digest: documents.Digest
    size: documents.Size
    old: _Old
    image: Annotated[str, Field(max_length=1000)]


class _Patches(RootModel[dict[documents.Digest, _Patch]], Shape):
    pass


def _patches(file: Archive, text: str) -> dict[str, Patch]:
    found = _json(file, text.encode(), archive.PATCHES) if text else {}
    for entry in found.values():
        kind = entry.get("mediaType") if isinstance(entry, dict) else None
        if isinstance(kind, str) and kind != patch.MEDIA_TYPE:
            raise RosmlError(
                f"{file.name} has differences that this rosml does not know: {kind[:100]}", "update rosml", 2
            )
    patches = {}
    for digest, told in _model(file, _Patches, found).root.items():
        if file.size(told.digest) != told.size:
            raise file.damaged(f"it lacks {told.digest}, or has another size of it")
        old = Layer(told.old.digest, told.old.diff_id, told.old.size)
        patches[digest] = Patch(told.digest, told.size, old, told.image)
    return patches


# ---- Completing ------------------------------------------------------------------------------------------------------


def choose(image: Image, sources: Iterable[Source], held: Container[str] = ()) -> list[tuple[Source, list[Layer]]]:
    """Which source gives which of the missing layers: as few sources as possible. If none gives a layer that has a patch, one gives the older
    layer.

    Args:
        held: digests of layers that nobody has to give.

    Raises:
        RosmlError: nobody has one of them (exit code 2).
    """
    there, chosen = list(sources), list[tuple[Source, list[Layer]]]()
    wanted = dict[str, Layer]()
    for layer in image.missing:
        if layer.digest not in held:
            made = image.patches.get(layer.digest)
            needed = made.old if made and not any(source.has(layer) for source in there) else layer
            wanted.setdefault(needed.digest, needed)
    missing = list(wanted.values())
    while missing and there:
        having = [(source, [layer for layer in missing if source.has(layer)]) for source in there]
        source, given = max(having, key=lambda pair: len(pair[1]))
        if not given:
            break
        chosen.append((source, given))
        missing = [layer for layer in missing if layer not in given]
        there = [other for other in there if other is not source]
    if missing:
        raise _lacking(image, missing)
    return chosen


def _lacking(image: Image, missing: Sequence[Layer]) -> RosmlError:
    """The one sentence about what does not fit."""
    digests = {layer.digest for layer in missing}
    named = [name for name, those in image.left_out.items() if digests & {*those}]
    names = list(dict.fromkeys([*named, *(made.image for made in image.patches.values() if made.old in missing)]))
    what = f"{counted(len(missing), 'layer')} of {some(names)}"
    remedy = f"pull {'it' if len(names) == 1 else 'them'} here, say with --from who has them, or save the image again without"
    remedy += " that --have" if len(names) == 1 else " those --have"
    return RosmlError(f"{image.file.name} needs {what}, which this machine lacks", remedy, exit_code=2)


def complete(
    image: Image,
    chosen: Sequence[tuple[Source, Sequence[Layer]]],
    out: BinaryIO,
    advance: Callable[[int], object] = lambda _: None,
    held: Container[str] = (),
) -> str:
    """Writes the whole archive. What makes an image of it comes last.

    Args:
        image: what was read.
        chosen: who gives the missing layers.
        out: where it goes; it may be a pipe.
        advance: is called with numbers of bytes that were written.
        held: digests of layers that whoever reads it has, and that stay out.

    Returns:
        The digest of the image in it. It is another one than before if a source gives a layer uncompressed.

    Raises:
        RosmlError: a layer is damaged, or a source does not give what it has.
        OSError: it cannot be written.
    """
    writer = Writer(out, advance)
    sent: dict[str, Found] = {}
    for digest, layer in image.layers.items():
        if digest in held or image.file.size(digest) is not None:
            sent[digest] = Found(layer, digest, layer.size, partial(_from_file, image.file, digest))
        if digest in sent and digest not in held:
            writer.blob(digest, layer.size, sent[digest].send)
    written = {*sent}
    for found in _given(image, chosen, [layer for layer in image.missing if layer.digest not in held]):
        if found.digest not in written:
            writer.blob(found.digest, found.size, found.send)
            written.add(found.digest)
        sent[found.layer.digest] = found
    manifest = _manifest(image, sent)
    writer.text(archive.path(image.identity), image.config)
    writer.text(archive.path(oci.digest_of(manifest)), manifest)
    named = oci.descriptor(image.media_type, manifest)
    writer.text(archive.INDEX, archive.index(named, image.name, {}))
    layers = [sent[digest].digest for digest in image.order]
    writer.text(archive.DOCKER, archive.for_docker(image.identity, layers, image.name))
    writer.end()
    return oci.digest_of(manifest)


def _given(image: Image, chosen: Sequence[tuple[Source, Sequence[Layer]]], missing: Sequence[Layer]) -> Iterator[Found]:
    """Missing layers, as sources give them, or made of older ones. Each must be sent before the next is asked for."""
    direct = {layer.digest for _, layers in chosen for layer in layers}.intersection(layer.digest for layer in missing)
    for source, wanted in chosen:
        lacking = {layer.digest: layer for layer in wanted}
        for found in source.take(wanted):
            lacking.pop(found.layer.digest, None)
            needing = [
                layer
                for layer in missing
                if layer.digest not in direct and image.patches[layer.digest].old.digest == found.layer.digest
            ]
            if not needing:
                yield found
                continue
            with _unpacked(image.file, found) as (again, old):
                for layer in needing:
                    yield _made(image, layer, old)
                if found.layer.digest in direct:
                    yield again
        if lacking:
            lost = next(iter(lacking.values()))
            raise RosmlError(f"{source.name} does not give {lost.diff_id}, which it has", "run it again")


@contextlib.contextmanager
def _unpacked(file: Archive, found: Found) -> Iterator[tuple[Found, IO[bytes]]]:
    """A layer to send again, and a file of it without its compression."""
    with files.temporary() as packed, files.temporary() as plain:
        archive.verified(found.digest, found.size, found.send, packed)
        try:
            patch.unpack(packed, found.layer.diff_id, plain)
        except ValueError as error:
            raise file.damaged(f"{found.layer.digest}, which it replaces: {error}") from None
        yield replace(found, send=partial(archive.again, packed)), plain


def _made(image: Image, layer: Layer, old: IO[bytes]) -> Found:
    """A layer, made of an older one."""
    made = image.patches[layer.digest]
    try:
        reader = patch.Reader(image.file.blocks(made.digest), old.seek(0, 2))
    except ValueError as error:
        raise image.file.damaged(f"{made.digest}: {error}") from None

    def send(write: Callable[[Iterable[bytes]], None]) -> None:
        try:
            write(reader.apply(old))
        except ValueError as error:
            raise image.file.damaged(f"{made.digest}: {error}") from None

    return Found(layer, layer.diff_id, reader.plan.size, send)


def _from_file(file: Archive, digest: str, write: Callable[[Iterable[bytes]], None]) -> None:
    write(file.blocks(digest))


def _manifest(image: Image, sent: Mapping[str, Found]) -> bytes:
    """The manifest as it was pushed; or one with uncompressed layers, if a source had them so."""
    if all(found.digest == digest for digest, found in sent.items()):
        return image.manifest
    layers = []
    for entry in image.content["layers"]:
        found = sent[entry["digest"]]
        if found.digest != entry["digest"]:
            entry = {"mediaType": _PLAIN[image.media_type], "digest": found.digest, "size": found.size}
        layers.append(entry)
    return oci.encoded({**image.content, "layers": layers})


# ---- Sources ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class InArchive:
    """Layers of another archive."""

    file: Archive

    @property
    def name(self) -> str:
        """The file."""
        return self.file.name

    def has(self, layer: Layer) -> bool:
        """Whether it has a layer, compressed or not."""
        return self._digest(layer) != ""

    def take(self, wanted: Sequence[Layer]) -> Iterable[Found]:
        """Gives layers that it has."""
        for layer in wanted:
            digest = self._digest(layer)
            size = self.file.size(digest)
            assert size is not None
            yield Found(layer, digest, size, partial(_from_file, self.file, digest))

    def _digest(self, layer: Layer) -> str:
        return next((name for name in (layer.digest, layer.diff_id) if self.file.size(name) is not None), "")


@dataclass(frozen=True)
class InRegistry:
    """Layers of a repository."""

    registry: Registry
    repository: str

    @property
    def name(self) -> str:
        """Registry and repository."""
        return f"{self.registry.host}/{self.repository}"

    def has(self, layer: Layer) -> bool:
        """Whether it has a layer."""
        return self.registry.has_blob(self.repository, layer.digest)

    def take(self, wanted: Sequence[Layer]) -> Iterable[Found]:
        """Gives layers that it has."""
        for layer in wanted:
            yield Found(layer, layer.digest, layer.size, partial(self._fetch, layer))

    def _fetch(self, layer: Layer, write: Callable[[Iterable[bytes]], None]) -> None:
        self.registry.read_blob(self.repository, layer.digest, write, layer.size)
