"""Blobs in a registry: layers, configs and the content of artifacts."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from typing import Any, TypeVar
from urllib.parse import urlencode

import httpx
from pydantic import ValidationError

from rosml.base import units, untrusted, web
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.registry import documents
from rosml.registry.answers import Answer
from rosml.registry.documents import Descriptor
from rosml.registry.failures import Transient
from rosml.registry.oci import (
    CONFIG,
    DOCKER_CONFIG,
    Config,
    Manifest,
    digest_of,
    require_digest,
    verified,
    verified_blocks,
)
from rosml.registry.transport import Call, Group, scope

CONFIG_BYTES = 8 << 20
"""Largest config of an image. Real ones have some kB."""

BLOB_BYTES = 64 << 20
"""Default limit of a blob that is read into memory. Layers are read as they arrive."""

_BLOCK = 1 << 20

T = TypeVar("T")


class Blobs(Group):
    def blob(self, repository: str, digest: str, limit: int = BLOB_BYTES) -> bytes:
        """A blob of at most `limit` bytes, checked against its digest."""
        require_digest(digest)
        answer = self.transport.ask(Call("GET", f"{repository}/blobs/{digest}", repository, limit=limit))
        return verified(answer.content, digest)

    def part(self, repository: str, descriptor: Descriptor, limit: int = BLOB_BYTES) -> bytes:
        """The blob of a descriptor, which must not be larger than the descriptor says."""
        if descriptor.size > limit:
            text = f"{self.host}/{repository}: {descriptor.digest} has {units.size(descriptor.size)}, and at most"
            raise RosmlError(f"{text} {units.size(limit)} are read", "push the right content")
        return self.blob(repository, descriptor.digest, descriptor.size)

    def json_blob(self, repository: str, digest: str, limit: int = BLOB_BYTES) -> dict[str, Any]:
        """A blob that is a JSON object, such as an image's config."""
        try:
            content = untrusted.json_value(self.blob(repository, digest, limit), limit)
        except ValueError as error:
            text = f"{self.host}/{repository}: {digest} cannot be read: {error}"
            raise RosmlError(text, "push it again") from None
        if not isinstance(content, dict):
            raise RosmlError(f"{self.host}/{repository}: {digest} is no JSON object", "push it again")
        return content

    def config(self, repository: str, manifest: Manifest, name: str = "") -> Config:
        """The config of an image for one platform. `name` is the user's name of the image, for messages."""
        name = name or f"{self.host}/{repository}@{manifest.digest}"
        if manifest.config is None:
            raise RosmlError(f"{name} is no image: it has no config", "check its name", exit_code=2)
        if manifest.config.mediaType not in (CONFIG, DOCKER_CONFIG):
            raise RosmlError(f"{name} is an artifact of another kind, no image", "check its name", exit_code=2)
        content = self.json_blob(repository, manifest.config.digest, CONFIG_BYTES)
        try:
            return Config(content, documents.Config.model_validate(content))
        except ValidationError as error:
            text = f"{name}: its config is damaged: {first_of(error)}"
            raise RosmlError(text, "build the image again and push it, or name another one") from None

    def read_blob(
        self, repository: str, digest: str, read: Callable[[Iterator[bytes]], T], size: int | None = None
    ) -> T:
        """What `read` returns, from the pieces of a blob as they arrive. If the connection breaks, it is called again, from the beginning.

        If it stops early, the rest is not downloaded, and the digest is not checked. A blob of more than `size` bytes is an error.
        """

        def once() -> T:
            with self.transport.stream(repository, digest) as blocks:
                return read(verified_blocks(blocks, digest, size))

        return self.transport.retried(once)

    def has_blob(self, repository: str, digest: str) -> bool:
        return self.transport.look(Call("HEAD", f"{repository}/blobs/{digest}", repository)) is not None

    def put_blob(self, repository: str, data: bytes) -> str:
        """Puts a blob, unless the repository has it. Returns its digest."""
        digest = digest_of(data)
        if not self.has_blob(repository, digest):
            self.transport.retried(lambda: self._upload(repository, digest, data, len(data)))
        return digest

    def mount(self, repository: str, digest: str, source_repository: str) -> bool:
        """Adds a blob of another repository of this registry without sending it. Returns whether the registry did."""
        query = urlencode({"mount": digest, "from": source_repository})
        path, scopes = f"{repository}/blobs/uploads/?{query}", (scope(source_repository, "pull"),)
        call = Call("POST", path, repository, push=True, more_scopes=scopes, allow=(400, 404, 405))
        answer = self.transport.ask(call)
        if answer.status_code == 202:
            self._cancel(repository, answer)  # the registry began an upload instead
        return answer.status_code == 201

    def copy_blob(self, repository: str, digest: str, size: int, source: Blobs, source_repository: str) -> None:
        """Copies a blob from another repository or registry, without keeping it on this machine."""

        def blocks() -> Iterator[bytes]:
            with source.transport.stream(source_repository, digest, _BLOCK) as pieces:
                yield from verified_blocks(pieces, digest, size)

        self.transport.retried(lambda: self._upload(repository, digest, blocks(), size))

    def may_push(self, repository: str) -> None:
        """Checks write access to a repository: begins an upload and cancels it."""
        self._cancel(repository, self.transport.ask(_begin(repository)))

    def _upload(self, repository: str, digest: str, content: bytes | Iterator[bytes], size: int) -> None:
        location = str(self._location(self.transport.attempt(_begin(repository))))
        address = httpx.URL(f"{location}{'&' if '?' in location else '?'}{urlencode({'digest': digest})}")
        headers = {"Content-Type": "application/octet-stream", "Content-Length": str(size)}
        end = Call("PUT", "", repository, push=True, headers=headers, content=content, allow=(404,))
        if self.transport.attempt(end, address).status_code == 404:
            raise Transient("the registry no longer knows the upload")

    def _location(self, begun: Answer) -> httpx.URL:
        try:
            return web.joined(begun.url, begun.headers.get("location") or "//")
        except web.Unfit:
            text = f"{self.host} does not say where to upload to"
            raise RosmlError(text, "check the configuration of the registry and its proxy") from None

    def _cancel(self, repository: str, begun: Answer) -> None:
        """Cancels an upload. Only the registry itself gets the request, no other host."""
        with contextlib.suppress(RosmlError, Transient):
            address = self._location(begun)
            if web.origin(address) == web.origin(self.transport.base):
                self.transport.send(Call("DELETE", "", repository, push=True), address)


def _begin(repository: str) -> Call:
    return Call("POST", f"{repository}/blobs/uploads/", repository, push=True)
