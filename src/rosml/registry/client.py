"""A client of container registries: the part of the OCI distribution API that the publisher needs.

A request is sent again if its failure may pass. If it does not pass, the error has a remedy. No message, log line or
repr holds a password, a token or a signed address.
"""

from __future__ import annotations

import contextlib
import hashlib
import logging
import random
import re
import threading
import time
from collections import defaultdict
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from typing import Any, TypeVar

import httpx
from pydantic import ValidationError

from rosml.base import untrusted, web
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import Shape
from rosml.base.units import size as in_words
from rosml.registry import answers, certificates, documents, failures, login
from rosml.registry import credentials as docker
from rosml.registry.answers import Answer, codes, reason
from rosml.registry.credentials import DOCKER_HUB, Credentials
from rosml.registry.documents import MEDIA_TYPE, TAG, Descriptor
from rosml.registry.failures import (
    Busy,
    Denied,
    Immutable,
    Limited,
    Refused,
    Transient,
    Untrusted,
    named,
    transport,
    unfit,
)
from rosml.registry.oci import (
    CONFIG,
    DOCKER_CONFIG,
    DOCKER_IMAGE,
    DOCKER_INDEX,
    EMPTY_BLOB,
    IMAGE,
    INDEX,
    Config,
    Manifest,
    artifact,
    descriptor,
    digest_of,
    encoded,
)
from rosml.registry.references import is_digest

_ACCEPT = ", ".join((INDEX, IMAGE, DOCKER_INDEX, DOCKER_IMAGE))

ANSWER_SECONDS = 60.0
"""Time limit in seconds for the next bytes of an answer."""

CONNECTIONS = 32
"""Open connections to one registry."""

CONFIG_BYTES = 8 << 20
"""Largest config of an image. Real ones have some kB."""

BLOB_BYTES = 64 << 20
"""Default limit of a blob that is read into memory. Layers are read as they arrive."""

PAGES = 1000
"""Limit of a list. Registries give 100 to 1,000 tags on each page."""

LIST_BYTES = 64 << 20
"""Largest list, of all its pages together."""

_IMMUTABLE = re.compile(r"\bimmutable\b|cannot be overwritten", re.IGNORECASE)
"""What registries say if a tag may not move: Amazon's, Google's, Harbor and Quay."""

_SETTLED = frozenset(range(300, 600)).difference(web.BUSY)
_UNKNOWN = {"BLOB_UNKNOWN", "MANIFEST_BLOB_UNKNOWN", "MANIFEST_UNKNOWN"}
_BLOCK = 1 << 20

# httpx logs whole addresses, and the addresses of a registry's storage contain signatures.
logging.getLogger("httpx").setLevel(logging.WARNING)
_LOG = logging.getLogger(__name__)

T = TypeVar("T")


class Registries:
    """The clients of registries by host, each made once. Safe to share among threads; use it in a `with`."""

    def __init__(self, ca_bundle: str = "") -> None:
        self._ca_bundle = ca_bundle
        self._known: dict[str, Registry] = {}
        self._lock = threading.Lock()

    def __call__(self, host: str) -> Registry:
        with self._lock:
            if host not in self._known:
                self._known[host] = Registry(host, ca_bundle=self._ca_bundle)
            return self._known[host]

    def __enter__(self) -> Registries:
        return self

    def __exit__(self, *_: object) -> None:
        for registry in self._known.values():
            registry.close()


REMEDY = (
    "ask its operator to allow it, or delete with its own tools; on ghcr.io, delete versions of the package on its page or by"
    " GitHub's API"
)
"""The remedy if a registry deletes nothing."""


class Undeletable(RosmlError):
    """The registry deletes no manifest at all."""


class Registry:
    """One registry. Safe to share among threads; close it, or use it in a `with`.

    Attributes:
        host: as in references, such as `ghcr.io` or `127.0.0.1:5000`.
        base: the address of its root.
        uploaded: bytes of bodies sent so far, including failed attempts.
    """

    def __init__(
        self,
        host: str,
        *,
        plain: bool | None = None,
        ca_bundle: str = "",
        credentials: Callable[[str], Credentials | None] = docker.from_docker,
    ) -> None:
        """
        Args:
            host: as in references.
            plain: speak http. By default, only a registry on this machine without certificates in certs.d gets plain
                http.
            ca_bundle: a file with the certificates to trust; by default the file that SSL_CERT_FILE names, or the usual
                one.
            credentials: gives the credentials of a host; it is called once, when the registry asks for them.
        """
        self.host = host
        local = login.is_local(host)
        trusted = certificates.of(host)
        scheme = "http" if (local and not trusted if plain is None else plain) else "https"
        self.base = httpx.URL(f"{scheme}://{'registry-1.docker.io' if host == DOCKER_HUB else host}")
        self._client = web.client(
            headers={"User-Agent": "rosml"},
            timeout=httpx.Timeout(ANSWER_SECONDS, connect=10.0, pool=None),
            limits=httpx.Limits(max_connections=CONNECTIONS, max_keepalive_connections=CONNECTIONS),
            verify=scheme == "https" and certificates.context(ca_bundle, trusted),
            trust_env=not local,  # a proxy could not reach this machine
        )
        self._login = login.Login(host, self.base, self._client, credentials)
        self._lock = threading.Lock()  # guards the state of this object; never held during a request
        self._attaching: defaultdict[str, threading.Lock] = defaultdict(threading.Lock)  # by the tag of a list
        self._reached = False
        self._answered = False  # whether an answer was another than 429
        self.uploaded = 0
        self._sent = threading.local()
        self._keeping: set[str] = set()  # repositories that refused to discard something
        self._there: set[str] = set()  # repositories that have, or had, a manifest
        self._warned = False
        self._keeps_account: bool | None = None  # whether it has the referrers API; None until the first request

    def __repr__(self) -> str:
        return f"Registry({self.host!r})"

    def __enter__(self) -> Registry:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Closes its connections."""
        self._client.close()

    @property
    def sent_by_this_thread(self) -> int:
        """As `uploaded`, of this thread alone."""
        return int(getattr(self._sent, "bytes", 0))

    # ---- Manifests ---------------------------------------------------------------------------------------------------

    def manifest(self, repository: str, reference: str) -> Manifest | None:
        """The manifest of a tag or digest; None if there is none.

        Raises:
            RosmlError: the registry does not answer or refuses, or the manifest is damaged.
        """
        answer = self._look("GET", _manifest(repository, reference), repository)
        if answer is None:
            return None
        if is_digest(reference):
            _verified(answer.content, reference)
        digest = reference if is_digest(reference) else digest_of(answer.content)
        content = self._object(answer)
        media_type = str(content.get("mediaType") or _media_type(answer))
        found = Manifest(content, digest, media_type, len(answer.content))
        with self._shaped(answer):
            found.read()  # only checks it: a parsed document is kept from its first use on, since a run has thousands
        return found

    def raw_manifest(self, repository: str, digest: str) -> bytes:
        """A manifest as it was pushed, byte by byte, to pass it on.

        Raises:
            RosmlError: there is no such manifest, or it is damaged; the registry does not answer or refuses.
        """
        answer = self._look("GET", _manifest(repository, digest), repository)
        if answer is None:
            raise RosmlError(f"{self.host}/{repository}@{digest} is not there any more", "check its name")
        return _verified(answer.content, digest)

    def put_manifest(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str = IMAGE
    ) -> str:
        """Puts a manifest or index under a tag; without a tag if `reference` is empty. Gives its digest.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        return self.send_manifest(repository, reference, content, media_type)[0]

    def send_manifest(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str
    ) -> tuple[str, httpx.Headers]:
        """Puts a manifest like `put_manifest`; gives also the headers of the answer. All manifests are sent here. A registry with immutable tags
        refuses the same content, too, which is no failure."""
        data = content if isinstance(content, bytes) else encoded(content)
        digest = digest_of(data)
        try:
            answer = self._ask(
                "PUT",
                _manifest(repository, reference or digest),
                repository,
                headers={"Content-Type": media_type},
                content=data,
                push=True,
            )
        except Immutable:
            if self.head(repository, reference) != digest:
                raise
            return digest, httpx.Headers()
        self._there.add(repository)
        self._login.reconsider(self._scopes(repository))
        return digest, answer.headers

    def tag(self, repository: str, digest: str, name: str) -> None:
        """Moves a tag to a manifest or index of the same repository.

        Raises:
            RosmlError: the manifest is missing; the registry does not answer or refuses.
        """
        answer = self._look("GET", _manifest(repository, digest), repository)
        if answer is None:
            raise RosmlError(
                f"{self.host}/{repository}@{digest} is not there, so no tag can point at it", "push it first"
            )
        _verified(answer.content, digest)
        self.put_manifest(repository, name, answer.content, _media_type(answer) or IMAGE)

    def head(self, repository: str, reference: str) -> str:
        """The digest of a tag, or the digest itself; empty if there is no such manifest.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        answer = self._look("HEAD", _manifest(repository, reference), repository)
        if answer is None:
            return ""
        digest = answer.headers.get("docker-content-digest", "")
        if digest == reference or (is_digest(digest) and not is_digest(reference)):
            return str(digest)
        found = self.manifest(repository, reference)
        return found.digest if found else ""

    def tags(self, repository: str) -> list[str]:
        """All tags of a repository; none if there is no such repository.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        found: list[str] = []
        for page in self._pages(f"{repository}/tags/list?n=1000", repository, documents.Tags):
            found += page.get("tags") or []
        return found

    def delete(self, repository: str, reference: str) -> None:
        """Removes a manifest by its digest, and the tags that point at it; or only a tag, if the registry can do that.

        Raises:
            Undeletable: the registry deletes no manifests.
            RosmlError: the registry deletes no tags, does not answer or refuses.
        """
        answer = self._deletion(repository, reference, (404, 405))
        if answer.status_code == 405:
            if not is_digest(reference):
                raise RosmlError(f"{self.host} deletes no tag by its name", REMEDY)
            raise Undeletable(f"{self.host} deletes nothing", REMEDY)

    def discard(self, repository: str, digest: str) -> None:
        """Removes a manifest that is out of use. If the registry cannot, the manifest stays, which is no error.

        Many registries delete nothing. After a first refusal, this client does not ask again for that repository.
        """
        if repository in self._keeping:
            return
        try:  # some registries answer 404 to all deletions; a busy registry is not worth a wait
            answer = self._deletion(repository, digest, (404, 405, *web.BUSY))
            gone = answer.is_success or not self.head(repository, digest)
        except RosmlError:
            gone = False
        if not gone:
            self._keeping.add(repository)

    def _deletion(self, repository: str, reference: str, allow: tuple[int, ...]) -> Answer:
        path, also = _manifest(repository, reference), (_scope(repository, "delete"),)
        return self._ask("DELETE", path, repository, allow=allow, push=True, also=also)

    # ---- Blobs -------------------------------------------------------------------------------------------------------

    def blob(self, repository: str, digest: str, limit: int = BLOB_BYTES) -> bytes:
        """A small blob, checked against its digest.

        Args:
            repository: its path.
            digest: of the blob.
            limit: its largest size, in bytes.

        Raises:
            RosmlError: there is no such blob, it is larger, or it has another digest; the registry does not answer or
                refuses.
        """
        _hash(digest)
        return _verified(self._ask("GET", f"{repository}/blobs/{digest}", repository, limit=limit).content, digest)

    def part(self, repository: str, descriptor: Descriptor, limit: int = BLOB_BYTES) -> bytes:
        """Reads the blob of a descriptor like `blob`, with the size in the descriptor as the limit."""
        if descriptor.size > limit:
            text = f"{self.host}/{repository}: {descriptor.digest} has {in_words(descriptor.size)}, and at most"
            raise RosmlError(f"{text} {in_words(limit)} are read", "push the right content")
        return self.blob(repository, descriptor.digest, descriptor.size)

    def json_blob(self, repository: str, digest: str, limit: int = BLOB_BYTES) -> dict[str, Any]:
        """A blob that is a JSON object, such as an image's config.

        Raises:
            RosmlError: as in `blob`; or the blob is no JSON object.
        """
        try:
            content = untrusted.json_value(self.blob(repository, digest, limit), limit)
        except ValueError as error:
            text = f"{self.host}/{repository}: {digest} cannot be read: {error}"
            raise RosmlError(text, "push it again") from None
        if not isinstance(content, dict):
            raise RosmlError(f"{self.host}/{repository}: {digest} is no JSON object", "push it again")
        return content

    def config(self, repository: str, manifest: Manifest, name: str = "") -> Config:
        """The config of an image for one platform.

        Args:
            repository: its path.
            manifest: of the image.
            name: the user's name of the image, for messages; by default its place and digest.

        Raises:
            RosmlError: it is no image (exit code 2), or its config does not follow OCI's specification; or as in
                `blob`.
        """
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
        """Calls a function that reads a blob while it arrives. If the function stops early, the rest is not downloaded.

        Args:
            repository: its path.
            digest: of the blob.
            read: gets the blob in pieces. If the connection breaks, it is called again, from the beginning. The digest
                is checked only if the function reads to the end.
            size: of the blob, in bytes; None if unknown.

        Returns:
            What the function returns.

        Raises:
            RosmlError: as in `blob`; or the blob is larger than `size`.
        """

        def once() -> T:
            with self._stream(repository, digest) as blocks:
                return read(_checked(blocks, digest, size))

        return self._retried(once)

    def has_blob(self, repository: str, digest: str) -> bool:
        """Whether a blob is in a repository.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        return self._look("HEAD", f"{repository}/blobs/{digest}", repository) is not None

    def put_blob(self, repository: str, data: bytes) -> str:
        """Puts a blob, unless it is there. Gives its digest.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        digest = digest_of(data)
        if not self.has_blob(repository, digest):
            self._retried(lambda: self._upload(repository, digest, data, len(data)))
        return digest

    def mount(self, repository: str, digest: str, source_repository: str) -> bool:
        """Adds a blob of another repository of this registry to a repository, without sending it.

        Returns:
            Whether the registry did that.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        path = f"{repository}/blobs/uploads/?mount={_quoted(digest)}&from={_quoted(source_repository)}"
        also = (_scope(source_repository, "pull"),)
        answer = self._ask("POST", path, repository, push=True, also=also, allow=(202, 400, 404, 405))
        if answer.status_code == 202:
            self._give_up(repository, answer)  # the registry began an upload instead
        return answer.status_code == 201

    def copy_blob(self, repository: str, digest: str, size: int, source: Registry, source_repository: str) -> None:
        """Copies a blob from another repository or registry, without keeping it on this machine.

        Raises:
            RosmlError: the blob is damaged; a registry does not answer or refuses.
        """

        def blocks() -> Iterator[bytes]:
            with source._stream(source_repository, digest, _BLOCK) as found:
                yield from _checked(found, digest, size)

        self._retried(lambda: self._upload(repository, digest, blocks(), size))

    def _upload(self, repository: str, digest: str, content: bytes | Iterator[bytes], size: int) -> None:
        scopes = self._scopes(repository, push=True)
        begun = self._send("POST", self._address(f"{repository}/blobs/uploads/"), scopes)
        self._expect(begun, (202,), repository, push=True)
        location = str(self._location(begun))
        address = httpx.URL(f"{location}{'&' if '?' in location else '?'}digest={_quoted(digest)}")
        headers = {"Content-Type": "application/octet-stream", "Content-Length": str(size)}
        ended = self._send("PUT", address, scopes, headers=headers, content=content)
        if ended.status_code == 404:  # the registry forgot the upload: another attempt may work
            raise Transient("the registry no longer knows the upload")
        self._expect(ended, (), repository, push=True)

    def may_push(self, repository: str) -> None:
        """Checks write access to a repository: begins an upload and cancels it.

        Raises:
            RosmlError: there is no write access; the registry does not answer.
        """
        self._give_up(repository, self._ask("POST", f"{repository}/blobs/uploads/", repository, push=True))

    def _location(self, begun: Answer) -> httpx.URL:
        """The address of an upload that was begun."""
        try:
            return web.joined(begun.url, begun.headers.get("location") or "//")
        except web.Unfit:
            text = f"{self.host} does not say where to upload to"
            raise RosmlError(text, "check the configuration of the registry and its proxy") from None

    def _give_up(self, repository: str, begun: Answer) -> None:
        """Cancels an upload. Only the registry itself gets the request, no other host."""
        with contextlib.suppress(RosmlError, Transient):
            address = self._location(begun)
            if web.origin(address) == web.origin(self.base):
                self._send("DELETE", address, self._scopes(repository, push=True))

    # ---- Referrers ---------------------------------------------------------------------------------------------------

    def referrers(self, repository: str, digest: str, artifact_type: str = "") -> list[dict[str, Any]]:
        """Descriptors of the artifacts attached to a manifest, of one type or of all types.

        If the registry has no API for referrers, they are in an index under the fallback tag of OCI 1.1.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        if repository not in self._there and not self.head(repository, digest):
            return []  # if the repository does not exist, the registry may deny any request
        query = f"?artifactType={_quoted(artifact_type)}" if artifact_type else ""
        path = f"{repository}/referrers/{digest}{query}"
        pages = (
            list(self._pages(path, repository, documents.Referrers)) if self._has_referrers(path, repository) else []
        )
        if not pages and (fallback := self.manifest(repository, _fallback_tag(digest))):
            pages = [fallback.content]
        found = [entry for page in pages for entry in page.get("manifests") or []]
        return [entry for entry in found if artifact_type in ("", entry.get("artifactType"))]

    def _has_referrers(self, path: str, repository: str) -> bool:
        """Whether the registry has the API for referrers. The first request of that kind decides.

        Any answer but an index means that it has not. ghcr.io redirects to a web page, which may be missing, or answer
        429 for hours.
        """
        if self._keeps_account is None:
            try:
                answer = self._ask("GET", path, repository, allow=_SETTLED)
                content = untrusted.json_object(answer.content) if answer.status_code == 200 else None
                found = content is not None and not answers.misfit(content, documents.Referrers)
            except Busy:
                found = False
            with self._lock:  # if an artifact was attached meanwhile, that answer counts
                self._keeps_account = self._keeps_account or found
        return self._keeps_account

    def put_artifact(
        self,
        repository: str,
        tag: str,
        artifact_type: str,
        part: bytes,
        media_type: str,
        annotations: Mapping[str, str] | None = None,
    ) -> str:
        """Puts an artifact with one layer under a tag. Gives its digest.

        Args:
            repository: its path.
            tag: the tag.
            artifact_type: of the artifact.
            part: the content of the layer.
            media_type: of the layer.
            annotations: of the manifest.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        for data in (EMPTY_BLOB, part):
            self.put_blob(repository, data)
        return self.put_manifest(repository, tag, artifact(artifact_type, part, media_type, annotations))

    def attach(
        self,
        repository: str,
        subject: Mapping[str, Any],
        artifact_type: str,
        part: bytes,
        media_type: str,
        annotations: Mapping[str, str] | None = None,
        more: Sequence[Mapping[str, Any]] = (),
    ) -> str:
        """Attaches an artifact to a manifest of the repository. Attaching the same artifact again changes nothing.

        Args:
            repository: its path.
            subject: descriptor of the manifest.
            artifact_type: of the artifact.
            part: the content of the layer.
            media_type: of the layer.
            annotations: of the artifact's manifest.
            more: descriptors of further layers, whose blobs the repository has.

        Returns:
            Digest of the artifact's manifest.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        for data in (EMPTY_BLOB, part):
            self.put_blob(repository, data)
        content = artifact(artifact_type, part, media_type, annotations, subject)
        content["layers"] += [dict(layer) for layer in more]
        data = encoded(content)
        digest, headers = self.send_manifest(repository, "", data, IMAGE)
        if headers.get("oci-subject") == subject["digest"]:
            self._keeps_account = True
        else:  # this registry has no API for referrers
            noted = {"annotations": dict(annotations)} if annotations else {}
            self._list(
                repository, subject["digest"], {**descriptor(IMAGE, data), "artifactType": artifact_type, **noted}
            )
        return digest

    def forget(self, repository: str, subject: str) -> None:
        """Removes the list of the artifacts that were attached to a removed manifest, if the registry has no API for
        referrers.

        Raises:
            RosmlError: the registry does not delete, does not answer or refuses.
        """
        if there := self.head(repository, _fallback_tag(subject)):
            self.delete(repository, there)

    def _list(self, repository: str, subject: str, entry: Mapping[str, Any]) -> None:
        """Adds an artifact to the index under the fallback tag.

        The index is read again before and after the write, so that changes of other publishers stay. Only two writes at
        the very same time can still undo each other, since registries have no conditional write.

        Raises:
            RosmlError: others keep writing the index; the registry does not answer or refuses.
        """
        tag = _fallback_tag(subject)

        def read() -> tuple[str, list[Any], bool]:
            found = self.manifest(repository, tag)
            there = list(found.content.get("manifests") or []) if found else []
            return found.digest if found else "", there, entry["digest"] in [item["digest"] for item in there]

        with self._lock:
            turn = self._attaching[f"{repository}:{tag}"]
        with turn:
            for _ in range(failures.ATTEMPTS):
                digest, there, known = read()
                if known:
                    return
                if self.head(repository, tag) == digest:
                    content = {"schemaVersion": 2, "mediaType": INDEX, "manifests": [*there, entry]}
                    self.put_manifest(repository, tag, content, INDEX)
                    if read()[2]:
                        return
                time.sleep(random.uniform(0, failures.WAIT))
        raise RosmlError(f"others keep writing {self.host}/{repository}:{tag}", "run it again")

    # ---- Requests ----------------------------------------------------------------------------------------------------

    def _address(self, path: str) -> httpx.URL:
        try:
            return self.base.join(f"/v2/{path}")
        except httpx.InvalidURL:
            raise RosmlError(f"{self.host}: {path!r} is no address", "check the reference that leads there") from None

    def _scopes(self, repository: str, push: bool = False, also: Iterable[str] = ()) -> frozenset[str]:
        return frozenset((_scope(repository, "pull,push" if push else "pull"), *also))

    def _ask(
        self,
        method: str,
        path: str,
        repository: str,
        *,
        headers: Mapping[str, str] | None = None,
        content: bytes | None = None,
        allow: Container[int] = (),
        push: bool = False,
        also: Iterable[str] = (),
        limit: int = answers.JSON_BYTES,
    ) -> Answer:
        """Sends a request, again if that may help. Gives the answer if it is a success, or has a status of `allow`."""
        scopes = self._scopes(repository, push, also)

        def once() -> Answer:
            answer = self._send(method, self._address(path), scopes, headers=headers, content=content, limit=limit)
            return self._expect(answer, allow, repository, push)

        return self._retried(once)

    def _look(self, method: str, path: str, repository: str) -> Answer | None:
        """Sends a request for something that may be missing; None if it is.

        ghcr.io may deny access to a repository that does not exist yet. If it denies a known account, the content
        counts as missing, and a warning says so. A later push shows whether the account lacks a right. This does not
        hold for a repository with a manifest that this client saw or put: such a repository exists, and a wrong
        "missing" would move a tag without a record of where it was.
        """
        scopes, accept = self._scopes(repository), {"Accept": _ACCEPT} if "/manifests/" in path else {}

        def once() -> Answer | None:
            try:
                answer = self._send(method, self._address(path), scopes, headers=accept)
                return self._expect(answer, (404,), repository, push=False)
            except Denied as denied:
                if repository in self._there:
                    raise
                self._warn(denied)
                return None

        answer = self._retried(once)
        if answer is None or answer.status_code == 404:
            return None
        if not path.startswith(f"{repository}/blobs/"):  # blobs may be there before the repository is
            self._there.add(repository)
        return answer

    def _warn(self, denied: Denied) -> None:
        """Warns once that denied content counts as missing."""
        with self._lock:
            warned, self._warned = self._warned, True
        if not warned:
            _LOG.warning("%s: taken for a repository that does not exist yet; this warning comes once", denied)

    def _pages(self, path: str, repository: str, shape: type[Shape]) -> Iterator[dict[str, Any]]:
        """All pages of a list; none if the registry knows no such list.

        Raises:
            RosmlError: the list has no end, or continues on another host; or a page does not follow the specification.
        """
        seen: set[str] = set()
        room = LIST_BYTES
        while path and path not in seen:  # if a page links to an earlier one, the list would never end
            seen.add(path)
            answer = self._look("GET", path, repository)
            if answer is None:
                return
            room -= len(answer.content)
            if len(seen) > PAGES or room < 0:
                raise unfit("GET", answer.url, "a list without end")
            content = self._object(answer)
            with self._shaped(answer):
                shape.model_validate(content)
            yield content
            path = self._next(answer)

    def _next(self, answer: Answer) -> str:
        """The path of the page after this one; empty if it is the last."""
        found = re.match(r"\s*<([^<>\s]{1,8192})>((?:\s*;[^;,]{0,256}){1,8})", answer.headers.get("link", ""))
        if found is None or not re.search(r';\s*rel\s*=\s*"?next"?\s*(?:;|$)', found[2]):
            return ""
        try:
            address = web.joined(answer.url, found[1])
        except web.Unfit as error:
            raise unfit("GET", answer.url, f"the next page: {error}") from None
        path = address.raw_path.decode()
        if address.host != self.base.host or not path.startswith("/v2/"):  # no other host gets the request
            raise unfit("GET", answer.url, f"the next page is elsewhere: {named(address)}")
        return path.removeprefix("/v2/")

    def _retried(self, work: Callable[[], T]) -> T:
        """Does some work, again if that may help, with longer pauses each time or those that the registry asks for."""
        attempt = 0
        while True:
            try:
                return work()
            except Untrusted as error:
                raise RosmlError(f"{self.host}: {error}", certificates.remedy(self.host, str(error))) from None
            except Transient as error:
                attempt += 1
                self._reached = self._reached or error.connected
                seconds = failures.pause(error, attempt, self._reached)
                if seconds is None and isinstance(error, Refused):
                    raise error.error from None
                if seconds is None:
                    remedy = "run it again; what is finished is kept"
                    if not self._reached:
                        remedy = "check its name, the network and the proxies (HTTPS_PROXY)"
                    if isinstance(error, Limited):
                        remedy = self._login.slower(error.after)
                    raise error.final(f"{self.host}: {error}", remedy) from None
                time.sleep(seconds)

    def _send(
        self,
        method: str,
        address: httpx.URL,
        scopes: frozenset[str],
        *,
        headers: Mapping[str, str] | None = None,
        content: bytes | Iterator[bytes] | None = None,
        limit: int = answers.JSON_BYTES,
    ) -> Answer:
        """Sends one request with credentials; once more if the registry answers with a challenge."""
        request = self._client.build_request(method, address, headers=dict(headers or {}), content=content)
        again = not isinstance(content, Iterator)
        with self._open(request, scopes, again) as answer, transport(method, answer.url):
            return answers.whole(answer, limit)

    @contextlib.contextmanager
    def _stream(self, repository: str, digest: str, block: int | None = None) -> Iterator[Iterator[bytes]]:
        """The pieces of a blob while it arrives, of `block` bytes each if that is set."""
        address = self._address(f"{repository}/blobs/{digest}")
        request = self._client.build_request("GET", address)

        def blocks() -> Iterator[bytes]:
            with transport("GET", address):
                yield from answer.iter_raw(block)

        with self._open(request, self._scopes(repository)) as answer:
            if not answer.is_success:
                with transport("GET", address):
                    failed = answers.whole(answer, 0)
                self._expect(failed, (), repository, push=False)
            yield blocks()

    @contextlib.contextmanager
    def _open(self, request: httpx.Request, scopes: frozenset[str], again: bool = True) -> Iterator[httpx.Response]:
        answer, sent = self._exchange(request, scopes, "")
        if self._login.challenged(answer):
            with transport(request.method, request.url):
                web.excerpt(answer)
            if not again:
                raise Transient("the registry asked again who uploads")
            answer, _ = self._exchange(request, scopes, sent)
        try:
            yield answer
        finally:
            answer.close()

    def _exchange(self, request: httpx.Request, scopes: frozenset[str], refused: str) -> tuple[httpx.Response, str]:
        """Sends a request with credentials. Gives the answer, and the header `Authorization` that it sent.

        For a blob, redirects to any host are followed; for other requests, only within the registry, because another
        host would answer that a manifest is missing.
        """
        header = self._login.header(request.url, scopes, refused)
        request.headers.pop("authorization", None)
        if header:
            request.headers["Authorization"] = header
        with transport(request.method, request.url):
            blob = request.url.path.rpartition("/")[0].endswith("/blobs")
            answer = web.followed(self._client, request, elsewhere=blob)
        with self._lock:
            self._reached = True
            self.uploaded += int(request.headers.get("content-length", 0))
        self._sent.bytes = self.sent_by_this_thread + int(request.headers.get("content-length", 0))
        return answer, header

    def _expect(self, answer: Answer, allow: Container[int], repository: str, push: bool) -> Answer:
        """The answer, if it is a success or has a status of `allow`.

        Raises:
            Transient: the next attempt may succeed.
            RosmlError: it will not.
        """
        code = answer.status_code
        limited = code == httpx.codes.TOO_MANY_REQUESTS
        self._answered = self._answered or not limited
        if answer.is_success or code in allow:
            return answer
        own = web.origin(answer.url) == web.origin(self.base)
        said = f"{answer.method} {answer.url.path if own else named(answer.url)}: {code}{reason(answer)}"
        if limited:
            raise Limited(said, web.after(answer.headers), from_the_first=not self._answered)
        if code in web.BUSY:
            raise Transient(said, web.after(answer.headers), final=Busy)
        if answer.redirect and not push:
            raise Transient(f"{said}: a redirect to {answer.redirect}")
        if code in (401, 403):
            error = self._login.denied(f"{'push to' if push else 'pull from'} {repository}", said)
            passing = code == 403 and self._login.known and answer.method != "DELETE"
            raise Denied(error) if passing else error
        if self.base.scheme == "http" and code == 400 and b"https" in answer.content.lower():
            raise RosmlError(f"{self.host} does not speak plain http", certificates.remedy(self.host, ""))
        if push and _IMMUTABLE.search(said):
            tag = f"{self.host}/{repository}:{answer.url.path.rpartition('/')[2]}"
            raise Immutable(
                f"{tag} is there with other content, and the registry lets no tag move: {said}", "choose another tag"
            )
        missing = "check the reference"
        refused = RosmlError(
            f"{self.host}: {said}", missing if code == 404 else "ask the registry's operator, or look into its log"
        )
        if push and answer.method != "DELETE" and (code in (404, 409) or codes(answer) & _UNKNOWN):
            raise Refused(refused)
        raise refused

    def _object(self, answer: Answer) -> dict[str, Any]:
        try:
            content = untrusted.json_value(answer.content)
        except ValueError as error:
            content, why = None, str(error)
        else:
            why = "it is another value"
        if not isinstance(content, dict):
            raise RosmlError(
                f"{self.host}: the answer to GET {named(answer.url)} is no JSON object, so no registry gave it: {why}",
                "check the address, and HTTPS_PROXY: a proxy may answer instead, for example with a sign-in page",
            )
        return content

    @contextlib.contextmanager
    def _shaped(self, answer: Answer) -> Iterator[None]:
        """Turns the validation error of an answer into an error for people."""
        try:
            yield
        except ValidationError as error:
            text = f"{self.host} does not answer as a registry: GET {answer.url.path}: {first_of(error)}"
            remedy = "check its name and the proxies (HTTPS_PROXY); if they are right, push the damaged content again"
            raise RosmlError(text, remedy) from None


# ---- Helpers ---------------------------------------------------------------------------------------------------------


def _scope(repository: str, actions: str) -> str:
    return f"repository:{repository}:{actions}"


def _manifest(repository: str, reference: str) -> str:
    """The path of a manifest.

    Raises:
        RosmlError: the reference is neither a tag nor a digest (exit code 2).
    """
    if not is_digest(reference) and not re.fullmatch(TAG, reference):
        text = f"{reference[:200]!r} in {repository} is neither a tag nor a digest"
        raise RosmlError(text, "check the reference that leads there", exit_code=2)
    return f"{repository}/manifests/{reference}"


def _media_type(answer: Answer) -> str:
    """The media type of an answer; empty if there is none, or it is malformed."""
    said = answer.headers.get("content-type", "").partition(";")[0].strip()
    return said if re.fullmatch(MEDIA_TYPE, said) else ""


def _quoted(text: str) -> str:
    return str(httpx.QueryParams({"x": text}))[2:]


def _fallback_tag(digest: str) -> str:
    return digest.replace(":", "-")


def _hash(digest: str) -> Any:
    if not is_digest(digest):
        raise RosmlError(f"{digest[:200]!r} is no digest", "name one as sha256: and 64 digits, or a tag")
    return hashlib.new(digest.partition(":")[0])


def _check(found: str, digest: str) -> None:
    if found != digest.partition(":")[2]:
        raise RosmlError(f"the registry's content for {digest} has another digest", "it is damaged: push it again")


def _checked(blocks: Iterable[bytes], digest: str, size: int | None) -> Iterator[bytes]:
    """The pieces of a blob. After the last piece, the digest is checked."""
    state, found = _hash(digest), 0
    for block in blocks:
        found += len(block)
        if size is not None and found > size:
            text = f"the registry's content for {digest} has more than the {size} bytes that its manifest says"
            raise RosmlError(text, "it is damaged: push it again")
        state.update(block)
        yield block
    _check(state.hexdigest(), digest)


def _verified(data: bytes, digest: str) -> bytes:
    """Gives the data if it has the digest.

    Raises:
        RosmlError: it has another one.
    """
    state = _hash(digest)
    state.update(data)
    _check(state.hexdigest(), digest)
    return data
