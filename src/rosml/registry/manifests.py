"""Manifests, indexes and tags in a registry."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import httpx

from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.registry import answers, documents
from rosml.registry.answers import Answer
from rosml.registry.documents import MEDIA_TYPE, TAG
from rosml.registry.failures import Immutable
from rosml.registry.oci import DOCKER_IMAGE, DOCKER_INDEX, IMAGE, INDEX, Manifest, digest_of, encoded, verified
from rosml.registry.references import is_digest
from rosml.registry.transport import Call, Group, Transport, scope

_ACCEPT = {"Accept": ", ".join((INDEX, IMAGE, DOCKER_INDEX, DOCKER_IMAGE))}

_ALLOW_DELETION = (
    "ask its operator to allow it, or delete with its own tools; on ghcr.io, delete versions of the package on its page or by"
    " GitHub's API"
)


class Undeletable(RosmlError):
    pass


class Manifests(Group):
    def __init__(self, transport: Transport) -> None:
        super().__init__(transport)
        self._without_deletion: set[str] = set()  # repositories that refused to discard something

    def manifest(self, repository: str, reference: str) -> Manifest | None:
        answer = self._get(repository, reference)
        if answer is None:
            return None
        if is_digest(reference):
            verified(answer.content, reference)
        digest = reference if is_digest(reference) else digest_of(answer.content)
        content = answers.json_object(self.host, answer)
        media_type = str(content.get("mediaType") or _media_type(answer))
        manifest = Manifest(content, digest, media_type, len(answer.content))
        with answers.well_formed(self.host, answer):
            manifest.read()  # only checks it: a parsed document is kept from its first use on, as a run has thousands
        return manifest

    def raw_manifest(self, repository: str, digest: str) -> bytes:
        """A manifest as it was pushed, byte by byte, to pass it on."""
        answer = self._get(repository, digest)
        if answer is None:
            raise RosmlError(f"{self.host}/{repository}@{digest} is not there any more", "check its name")
        return verified(answer.content, digest)

    def head(self, repository: str, reference: str) -> str:
        """The digest of a tag, or the digest itself; empty if there is no such manifest."""
        answer = self.transport.look(Call("HEAD", _path(repository, reference), repository, headers=_ACCEPT))
        if answer is None:
            return ""
        digest = answer.headers.get("docker-content-digest", "")
        if digest == reference or (is_digest(digest) and not is_digest(reference)):
            return str(digest)
        manifest = self.manifest(repository, reference)
        return manifest.digest if manifest else ""

    def tags(self, repository: str) -> list[str]:
        pages = self.transport.pages(f"{repository}/tags/list?n=1000", repository, documents.Tags)
        return [tag for page in pages for tag in page.get("tags") or []]

    def put_manifest(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str = IMAGE
    ) -> str:
        """Puts a manifest or index under a tag; without a tag if `reference` is empty. Returns its digest."""
        return self._put(repository, reference, content, media_type)[0]

    def _put(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str
    ) -> tuple[str, httpx.Headers]:
        """Returns also the headers of the answer. A registry with immutable tags refuses the same content too, which is no failure."""
        data = content if isinstance(content, bytes) else encoded(content)
        digest = digest_of(data)
        path, headers = _path(repository, reference or digest), {"Content-Type": media_type}
        call = Call("PUT", path, repository, push=True, headers=headers, content=data)
        try:
            answer = self.transport.ask(call)
        except Immutable:
            if self.head(repository, reference) != digest:
                raise
            return digest, httpx.Headers()
        self.transport.existing.add(repository)
        self.transport.login.reconsider(frozenset((scope(repository, "pull"),)))
        return digest, answer.headers

    def tag(self, repository: str, digest: str, name: str) -> None:
        """Moves a tag to a manifest or index of the same repository."""
        answer = self._get(repository, digest)
        if answer is None:
            text = f"{self.host}/{repository}@{digest} is not there, so no tag can point at it"
            raise RosmlError(text, "push it first")
        verified(answer.content, digest)
        self.put_manifest(repository, name, answer.content, _media_type(answer) or IMAGE)

    def delete(self, repository: str, reference: str) -> None:
        """Removes a manifest and the tags that point at it; or only a tag, if the registry can do that. Raises Undeletable."""
        if self._delete(repository, reference).status_code == 405:
            if not is_digest(reference):
                raise RosmlError(f"{self.host} deletes no tag by its name", _ALLOW_DELETION)
            raise Undeletable(f"{self.host} deletes nothing", _ALLOW_DELETION)

    def discard(self, repository: str, digest: str) -> None:
        """Removes a manifest that is out of use, if the registry can. After a first refusal, it is not asked again for that repository."""
        if repository in self._without_deletion:
            return
        try:  # some registries answer 404 to all deletions; a busy registry is not worth a wait
            answer = self._delete(repository, digest, web.BUSY)
            deleted = answer.is_success or not self.head(repository, digest)
        except RosmlError:
            deleted = False
        if not deleted:
            self._without_deletion.add(repository)

    def _delete(self, repository: str, reference: str, allow: tuple[int, ...] = ()) -> Answer:
        path, scopes = _path(repository, reference), (scope(repository, "delete"),)
        call = Call("DELETE", path, repository, push=True, more_scopes=scopes, allow=(404, 405, *allow))
        return self.transport.ask(call)

    def _get(self, repository: str, reference: str) -> Answer | None:
        return self.transport.look(Call("GET", _path(repository, reference), repository, headers=_ACCEPT))


def _path(repository: str, reference: str) -> str:
    if not is_digest(reference) and not re.fullmatch(TAG, reference):
        text = f"{reference[:200]!r} in {repository} is neither a tag nor a digest"
        raise RosmlError(text, "check the reference that leads there", exit_code=2)
    return f"{repository}/manifests/{reference}"


def _media_type(answer: Answer) -> str:
    """Empty if there is none, or it is malformed."""
    media_type = answer.headers.get("content-type", "").partition(";")[0].strip()
    return media_type if re.fullmatch(MEDIA_TYPE, media_type) else ""
