"""The image of an archive of `save`, read as a stranger's word: each blob by its digest, and nothing that the archive does not name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any

from pydantic import ConfigDict, Field, RootModel, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import counted, first_of
from rosml.base.shapes import Shape
from rosml.delivery import apply_patch, archive
from rosml.delivery.archive import Archive
from rosml.images.join import layers as joining
from rosml.registry import documents, oci, references
from rosml.registry.client import CONFIG_BYTES

JSON_BYTES = 4 << 20
"""Largest index and manifest, as registries take them."""

LAYERS = 1000
"""The most layers of an image. Docker allows 127."""

PLAIN_LAYER = {
    oci.IMAGE: "application/vnd.oci.image.layer.v1.tar",
    oci.DOCKER_IMAGE: "application/vnd.docker.image.rootfs.diff.tar",
}
"""The media type of an uncompressed layer, by that of the manifest."""

_AGAIN = "save it again with rosml save"


class _Shape(Shape):
    model_config = ConfigDict(strict=True, frozen=True)


class Layer(_Shape):
    """A layer of an image. `size` is in bytes, compressed."""

    digest: documents.Digest
    diff_id: documents.Digest
    size: documents.Size


class Patch(_Shape):
    """What makes a layer of an older one, of which `image` names an image. `size` is in bytes."""

    mediaType: str
    digest: documents.Digest
    size: documents.Size
    older: Layer = Field(alias="old")
    image: Annotated[str, Field(max_length=1000)]


class _Patches(RootModel[dict[documents.Digest, Patch]], Shape):
    pass


@dataclass(frozen=True)
class Image:
    """An image in an archive, which may lack layers.

    Attributes:
        name: the image's complete reference with a tag; empty if the archive names none.
        digest: of the manifest.
        manifest, config: as they were pushed. content, facts: the same, as they were read.
        layers: by digest, lowest first.
        order: the digests of all layers, lowest first; one may occur twice.
        left_out: the digests that the archive lacks, by the image that has them.
        patches: by the digest of the layer that they make.
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
        return joining.platform(self.facts)

    @property
    def missing(self) -> list[Layer]:
        """The layers that the archive lacks."""
        return [layer for layer in self.layers.values() if self.file.size(layer.digest) is None]

    @property
    def replaced(self) -> list[Layer]:
        """The older layers that patches need."""
        return list({patch.older.digest: patch.older for patch in self.patches.values()}.values())


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
    if entry.mediaType not in PLAIN_LAYER:
        text = f"{file.name} has no image for one platform, but {entry.mediaType[:100]}"
        raise RosmlError(text, "save the image for one platform with rosml save", exit_code=2)
    manifest_text = _blob(file, entry, JSON_BYTES)
    content = _json(file, manifest_text, "its manifest")
    manifest = _model(file, documents.Image, content)
    if manifest.config is None or manifest.config.mediaType not in (oci.CONFIG, oci.DOCKER_CONFIG):
        raise RosmlError(f"{file.name} has an artifact of another kind, no image", _AGAIN, exit_code=2)
    config = _blob(file, manifest.config, CONFIG_BYTES)
    facts = _model(file, documents.Config, _json(file, config, "its config"))
    image = Image(
        file,
        _name(entry.annotations.get(archive.NAME, "")),
        entry.digest,
        manifest_text,
        content,
        entry.mediaType,
        config,
        facts,
        _layers(file, manifest.layers, (facts.rootfs and facts.rootfs.diff_ids) or []),
        [layer.digest for layer in manifest.layers],
        _left_out(file, index.annotations.get(archive.LEFT_OUT, "")),
        _patches(file, index.annotations.get(archive.PATCHES, "")),
    )
    absent = {digest for digests in image.left_out.values() for digest in digests}
    if lost := [layer.digest for layer in image.missing if layer.digest not in absent]:
        raise file.damaged(f"it lacks {lost[0]}, which it does not name as left out")
    return image


def _layers(file: Archive, entries: list[documents.Descriptor], diff_ids: list[str]) -> dict[str, Layer]:
    if not 0 < len(entries) <= LAYERS or len(entries) != len(diff_ids):
        raise file.damaged(f"its manifest has {len(entries)} layers, and its config {len(diff_ids)}")
    layers: dict[str, Layer] = {}
    for entry, diff_id in zip(entries, diff_ids, strict=True):
        layer = Layer(digest=entry.digest, diff_id=diff_id, size=entry.size)
        if layers.setdefault(entry.digest, layer) != layer:
            raise file.damaged(f"it says two things about {entry.digest}")
        if (size := file.size(entry.digest)) is not None and size != entry.size:
            raise file.damaged(f"{entry.digest} has {size} bytes instead of {entry.size}")
    return layers


def _blob(file: Archive, entry: documents.Descriptor, limit: int) -> bytes:
    if file.size(entry.digest) not in (None, entry.size):
        raise file.damaged(f"{entry.digest} has {file.size(entry.digest)} bytes instead of {entry.size}")
    return file.small_blob(entry.digest, limit)


def _json(file: Archive, data: bytes, what: str) -> dict[str, Any]:
    try:
        value = untrusted.json_value(data, CONFIG_BYTES)
    except ValueError as error:
        raise file.damaged(f"{what} is no JSON: {error}") from None
    if not isinstance(value, dict):
        raise file.damaged(f"{what} is no JSON object")
    return value


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
    digests_by_name = _json(file, text.encode(), archive.LEFT_OUT) if text else {}
    for name, digests in digests_by_name.items():
        right = isinstance(digests, list) and all(
            isinstance(item, str) and references.is_digest(item) for item in digests
        )
        if not right or len(name) > 1000:
            raise file.damaged(f"its annotation {archive.LEFT_OUT} is none of rosml")
    return digests_by_name


def _patches(file: Archive, text: str) -> dict[str, Patch]:
    annotation = _json(file, text.encode(), archive.PATCHES) if text else {}
    for entry in annotation.values():
        kind = entry.get("mediaType") if isinstance(entry, dict) else None
        if isinstance(kind, str) and kind != apply_patch.MEDIA_TYPE:
            raise RosmlError(
                f"{file.name} has differences that this rosml does not know: {kind[:100]}", "update rosml", 2
            )
    patches: dict[str, Patch] = _model(file, _Patches, annotation).root
    for patch in patches.values():
        if file.size(patch.digest) != patch.size:
            raise file.damaged(f"it lacks {patch.digest}, or has another size of it")
    return patches
