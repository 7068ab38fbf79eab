"""Media types, digests, manifests and configs of the OCI specifications: https://github.com/opencontainers/image-spec"""

from __future__ import annotations

import functools
import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from rosml.base.errors import RosmlError
from rosml.registry import documents
from rosml.registry.documents import Descriptor
from rosml.registry.references import is_digest

IMAGE = "application/vnd.oci.image.manifest.v1+json"
INDEX = "application/vnd.oci.image.index.v1+json"
CONFIG = "application/vnd.oci.image.config.v1+json"
DOCKER_CONFIG = "application/vnd.docker.container.image.v1+json"
EMPTY = "application/vnd.oci.empty.v1+json"
DOCKER_IMAGE = "application/vnd.docker.distribution.manifest.v2+json"
DOCKER_INDEX = "application/vnd.docker.distribution.manifest.list.v2+json"
INDEXES = (INDEX, DOCKER_INDEX)

EMPTY_BLOB = b"{}"
"""The blob of type EMPTY: the config of an artifact without a config."""


_DAMAGED = "it is damaged: push it again"


def digest_of(data: bytes) -> str:
    return f"sha256:{hashlib.sha256(data).hexdigest()}"


def require_digest(digest: str) -> None:
    if not is_digest(digest):
        raise RosmlError(f"{digest[:200]!r} is no digest", "name one as sha256: and 64 digits, or a tag")


def verified(data: bytes, digest: str) -> bytes:
    return b"".join(verified_blocks([data], digest))


def verified_blocks(blocks: Iterable[bytes], digest: str, size: int | None = None) -> Iterator[bytes]:
    """Gives the pieces of a blob. After the last one, it checks the digest. At most `size` bytes may come."""
    require_digest(digest)
    state: Any = hashlib.new(digest.partition(":")[0])
    received = 0
    for block in blocks:
        received += len(block)
        if size is not None and received > size:
            text = f"the registry's content for {digest} has more than the {size} bytes that its manifest says"
            raise RosmlError(text, _DAMAGED)
        state.update(block)
        yield block
    if state.hexdigest() != digest.partition(":")[2]:
        raise RosmlError(f"the registry's content for {digest} has another digest", _DAMAGED)


def encoded(content: Mapping[str, Any]) -> bytes:
    """The same content gives the same bytes on every machine."""
    return json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


def descriptor(media_type: str, data: bytes) -> dict[str, Any]:
    return {"mediaType": media_type, "digest": digest_of(data), "size": len(data)}


def artifact(
    artifact_type: str,
    part: bytes,
    media_type: str,
    annotations: Mapping[str, str] | None = None,
    subject: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """The manifest of an artifact with one layer, `part`. Its blobs are the part and EMPTY_BLOB. `subject` is a descriptor."""
    return {
        "schemaVersion": 2,
        "mediaType": IMAGE,
        "artifactType": artifact_type,
        "config": descriptor(EMPTY, EMPTY_BLOB),
        "layers": [descriptor(media_type, part)],
        **({"subject": {key: subject[key] for key in ("mediaType", "digest", "size")}} if subject else {}),
        **({"annotations": dict(annotations)} if annotations else {}),
    }


@dataclass(frozen=True)
class Manifest:
    """A manifest or index. To read it, use the properties, which are checked and typed; `content` is for passing it on."""

    content: dict[str, Any]
    digest: str
    media_type: str
    size: int

    @functools.cached_property
    def _document(self) -> documents.Image | documents.Index:
        return self.read()

    def read(self) -> documents.Image | documents.Index:
        """The content as a model. Raises ValidationError."""
        return (documents.Index if self.is_index else documents.Image).model_validate(self.content)

    @property
    def is_index(self) -> bool:
        return self.media_type in INDEXES

    @property
    def descriptor(self) -> dict[str, Any]:
        return {"mediaType": self.media_type, "digest": self.digest, "size": self.size}

    @property
    def members(self) -> list[Descriptor]:
        return self._document.manifests or []

    @property
    def layers(self) -> list[Descriptor]:
        """The layers of an image, lowest first; none if this is an index."""
        return self._document.layers or []

    @property
    def config(self) -> Descriptor | None:
        """None if this is an index, and for some artifacts."""
        return self._document.config

    @property
    def annotations(self) -> dict[str, str]:
        return self._document.annotations

    @property
    def subject(self) -> str:
        """The digest of the manifest that this one is attached to; empty if it is attached to none."""
        subject = self._document.subject
        return subject.digest if subject else ""

    @property
    def artifact_type(self) -> str:
        return self._document.artifactType or ""


@dataclass(frozen=True)
class Config:
    """The config of an image. `content` is for passing it on, `facts` for reading."""

    content: dict[str, Any]
    facts: documents.Config

    @property
    def labels(self) -> dict[str, str]:
        return (self.facts.config and self.facts.config.Labels) or {}

    @property
    def environment(self) -> list[str]:
        """As `NAME=value`."""
        return (self.facts.config and self.facts.config.Env) or []

    @property
    def diff_ids(self) -> list[str]:
        """Digests of the layers before they were compressed, lowest first."""
        return (self.facts.rootfs and self.facts.rootfs.diff_ids) or []
