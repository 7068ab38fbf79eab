"""Artifacts in a registry, and those that are attached to a manifest: https://github.com/opencontainers/distribution-spec"""

from __future__ import annotations

import random
import threading
import time
from collections import defaultdict
from collections.abc import Iterable, Mapping
from typing import Any
from urllib.parse import urlencode

from pydantic import ValidationError

from rosml.base import untrusted, web
from rosml.base.errors import RosmlError
from rosml.registry import documents, oci, retries
from rosml.registry.blobs import Blobs
from rosml.registry.failures import Busy
from rosml.registry.manifests import Manifests
from rosml.registry.transport import Call, Transport

_SETTLED = frozenset(range(300, 600)).difference(web.BUSY)


class Referrers(Manifests, Blobs):
    """Without an API for referrers, a registry keeps them in an index under the fallback tag of OCI 1.1."""

    def __init__(self, transport: Transport) -> None:
        super().__init__(transport)
        self._has_api: bool | None = None  # None until the first request
        self._lock = threading.Lock()  # guards the state of this object; never held during a request
        self._attaching: defaultdict[str, threading.Lock] = defaultdict(threading.Lock)  # by the tag of a list

    def referrers(self, repository: str, digest: str, artifact_type: str = "") -> list[dict[str, Any]]:
        """Descriptors of the artifacts attached to a manifest, of one type or of all types."""
        if repository not in self.transport.existing and not self.head(repository, digest):
            return []  # if the repository does not exist, the registry may deny any request
        query = f"?{urlencode({'artifactType': artifact_type})}" if artifact_type else ""
        path = f"{repository}/referrers/{digest}{query}"
        pages: list[dict[str, Any]] = []
        if self._has_referrers(path, repository):
            pages = list(self.transport.pages(path, repository, documents.Referrers))
        if not pages and (fallback := self.manifest(repository, _fallback_tag(digest))):
            pages = [fallback.content]
        entries = [entry for page in pages for entry in page.get("manifests") or []]
        return [entry for entry in entries if artifact_type in ("", entry.get("artifactType"))]

    def _has_referrers(self, path: str, repository: str) -> bool:
        """Whether the registry has the API for referrers. The first request of that kind decides.

        Any answer but an index means no. ghcr.io redirects to a web page, which may be missing, or answer 429 for hours.
        """
        if self._has_api is None:
            try:
                answer = self.transport.ask(Call("GET", path, repository, allow=_SETTLED))
                documents.Referrers.model_validate(untrusted.json_object(answer.content))
                is_index = answer.status_code == 200
            except (Busy, ValidationError):
                is_index = False
            with self._lock:  # if an artifact was attached meanwhile, that answer counts
                self._has_api = self._has_api or is_index
        return self._has_api

    def put_artifact(
        self,
        repository: str,
        tag: str,
        artifact_type: str,
        part: bytes,
        media_type: str,
        annotations: Mapping[str, str] | None = None,
    ) -> str:
        """Puts an artifact with one layer, `part`, under a tag. Returns its digest."""
        for data in (oci.EMPTY_BLOB, part):
            self.put_blob(repository, data)
        return self.put_manifest(repository, tag, oci.artifact(artifact_type, part, media_type, annotations))

    def attach(
        self,
        repository: str,
        subject: Mapping[str, Any],
        artifact_type: str,
        part: bytes,
        media_type: str,
        annotations: Mapping[str, str] | None = None,
    ) -> str:
        """Attaches an artifact with one layer, `part`, to the manifest of a descriptor. Returns its digest. Again, it changes nothing."""
        return self._attach(repository, part, oci.artifact(artifact_type, part, media_type, annotations, subject))

    def attach_with_layers(
        self, repository: str, part: bytes, artifact: Mapping[str, Any], layers: Iterable[Mapping[str, Any]]
    ) -> str:
        """As `attach`, for a manifest of `oci.artifact` with a subject. It gets further layers, whose blobs the repository has."""
        content = {**artifact, "layers": [*artifact["layers"], *map(dict, layers)]}
        return self._attach(repository, part, content)

    def _attach(self, repository: str, part: bytes, artifact: Mapping[str, Any]) -> str:
        for data in (oci.EMPTY_BLOB, part):
            self.put_blob(repository, data)
        data, subject = oci.encoded(artifact), artifact["subject"]["digest"]
        digest, headers = self._put(repository, "", data, oci.IMAGE)
        if headers.get("oci-subject") == subject:
            self._has_api = True
        else:
            fields = {key: artifact[key] for key in ("artifactType", "annotations") if key in artifact}
            self._list(repository, subject, {**oci.descriptor(oci.IMAGE, data), **fields})
        return digest

    def forget(self, repository: str, subject: str) -> None:
        """Removes the list of the artifacts that were attached to a removed manifest, if there is a list."""
        if digest := self.head(repository, _fallback_tag(subject)):
            self.delete(repository, digest)

    def _list(self, repository: str, subject: str, entry: Mapping[str, Any]) -> None:
        """Adds an artifact to the index under the fallback tag.

        The index is read again before and after the write, so that changes of other publishers stay. Only two writes at
        the very same time can still undo each other, since registries have no conditional write.
        """
        tag = _fallback_tag(subject)
        with self._lock:
            turn = self._attaching[f"{repository}:{tag}"]
        with turn:
            for _ in range(retries.ATTEMPTS):
                digest, entries = self._listed(repository, tag)
                if _lists(entries, entry):
                    return
                if self.head(repository, tag) == digest:
                    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [*entries, entry]}
                    self.put_manifest(repository, tag, content, oci.INDEX)
                    if _lists(self._listed(repository, tag)[1], entry):
                        return
                time.sleep(random.uniform(0, retries.WAIT))
        raise RosmlError(f"others keep writing {self.host}/{repository}:{tag}", "run it again")

    def _listed(self, repository: str, tag: str) -> tuple[str, list[Any]]:
        index = self.manifest(repository, tag)
        return (index.digest, list(index.content.get("manifests") or [])) if index else ("", [])


def _lists(entries: list[Any], entry: Mapping[str, Any]) -> bool:
    return entry["digest"] in [item["digest"] for item in entries]


def _fallback_tag(digest: str) -> str:
    return digest.replace(":", "-")
