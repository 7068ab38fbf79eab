"""A client of container registries: the OCI distribution API, as far as the publisher needs it.

Everything that fails for a moment is tried again; what stays wrong is an error with a remedy. No message, log line or
repr holds a password, a token or a signed address.
"""

from __future__ import annotations

import base64
import contextlib
import email.utils
import hashlib
import json
import logging
import random
import re
import threading
import time
from collections import defaultdict
from collections.abc import Callable, Container, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeVar

import httpx
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of, listed
from rosml.registry import certificates
from rosml.registry import credentials as docker
from rosml.registry.credentials import DOCKER_HUB, Credentials

IMAGE = "application/vnd.oci.image.manifest.v1+json"
INDEX = "application/vnd.oci.image.index.v1+json"
CONFIG = "application/vnd.oci.image.config.v1+json"
DOCKER_CONFIG = "application/vnd.docker.container.image.v1+json"
EMPTY = "application/vnd.oci.empty.v1+json"
DOCKER_IMAGE = "application/vnd.docker.distribution.manifest.v2+json"
DOCKER_INDEX = "application/vnd.docker.distribution.manifest.list.v2+json"
INDEXES = (INDEX, DOCKER_INDEX)
_ACCEPT = ", ".join((INDEX, IMAGE, DOCKER_INDEX, DOCKER_IMAGE))

EMPTY_BLOB = b"{}"
"""The blob that the descriptor of type EMPTY points at: the config of an artifact that has none."""

ATTEMPTS = 7
"""How often a request is sent before it counts as failed: over about half a minute."""

ATTEMPTS_UNREACHED = 3
"""The same, while the registry never answered: a name that is wrong is told soon."""

WAIT, LONGEST_WAIT = 0.5, 30.0
"""Seconds before the second attempt, which double with every further one; and what a registry may ask for at most."""

ATTEMPTS_REFUSED = 5
"""The same, while the registry refuses what it may take a moment later: over about eight seconds."""

ANSWER_SECONDS = 60.0
"""Longest pause within an answer, and before it."""

CONNECTIONS = 32
"""Open connections to one registry."""

_TRANSIENT = (429, 500, 502, 503, 504)
_SETTLED = frozenset(range(300, 600)).difference(_TRANSIENT)
_UNKNOWN = {"BLOB_UNKNOWN", "MANIFEST_BLOB_UNKNOWN", "MANIFEST_UNKNOWN"}
_REDIRECTS = 5
_BLOCK = 1 << 20
_TAG = r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,127}"
_DIGEST = r"sha256:[0-9a-f]{64}|sha512:[0-9a-f]{128}"
_HOST = r"(?:[A-Za-z0-9](?:[A-Za-z0-9.-]*[A-Za-z0-9])?|\[[0-9A-Fa-f:]+\])(?::[0-9]{1,5})?"
_PATH = r"[a-z0-9]+(?:(?:[._]|__|-+)[a-z0-9]+)*(?:/[a-z0-9]+(?:(?:[._]|__|-+)[a-z0-9]+)*)*"
_REFERENCE = re.compile(rf"({_HOST})/({_PATH})(?::({_TAG}))?(?:@({_DIGEST}))?")
_CHALLENGE = re.compile(r'(\w+)\s*=\s*(?:"([^"]*)"|([^\s,"]+))')

# httpx logs whole addresses, and those of a registry's storage are signed.
logging.getLogger("httpx").setLevel(logging.WARNING)
_LOG = logging.getLogger(__name__)

T = TypeVar("T")


class Reference(NamedTuple):
    """Where something is: the registry, the repository, and a tag or digest."""

    host: str
    repository: str
    reference: str

    def __str__(self) -> str:
        return f"{self.host}/{self.repository}{'@' if is_digest(self.reference) else ':'}{self.reference}"


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


def parse(reference: str) -> Reference:
    """The parts of a complete reference, ``ghcr.io/me/ros:jazzy-base``. The tag is `latest` where there is none, and a
    digest counts more than a tag.

    Raises:
        RosmlError: it is none, or names no registry (exit code 2).
    """
    found = _REFERENCE.fullmatch(reference)
    host = found[1] if found else ""
    if found is None or not is_place(host, found[2]) or not has_registry(reference):
        text = f"{reference!r} is no reference with a registry, a repository and a tag or digest"
        raise RosmlError(text, "write it in full, such as ghcr.io/me/ros:jazzy-base", exit_code=2)
    return Reference(found[1], found[2], found[4] or found[3] or "latest")


def has_registry(name: str) -> bool:
    """Whether the name of an image begins with a registry; Docker tells it so from a path of Docker Hub's."""
    host, slash, _ = name.partition("/")
    return bool(slash) and (re.search(r"[.:]", host) is not None or host == "localhost")


def complete(name: str) -> str:
    """The name of an image with its registry: without one, it is Docker Hub's."""
    if has_registry(name):
        return name
    return f"{DOCKER_HUB}/{name}" if "/" in name else f"{DOCKER_HUB}/library/{name}"


def is_place(host: str, path: str) -> bool:
    """Whether they can be a registry and a path in it."""
    if not re.fullmatch(_HOST, host) or not re.fullmatch(_PATH, path):
        return False
    try:
        port = httpx.URL(f"https://{host}").port
        host.encode("idna")
    except (httpx.InvalidURL, UnicodeError):
        return False
    return port is None or 0 < port < 1 << 16


def is_digest(reference: str) -> bool:
    """Whether it is a digest; a tag otherwise."""
    return re.fullmatch(_DIGEST, reference) is not None


def digest_of(data: bytes) -> str:
    """The digest of some bytes."""
    return f"sha256:{hashlib.sha256(data).hexdigest()}"


def encoded(content: Mapping[str, Any]) -> bytes:
    """A JSON object as it is stored: the same bytes for the same content, on any machine."""
    return json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


def descriptor(media_type: str, data: bytes) -> dict[str, Any]:
    """What a manifest says of a blob."""
    return {"mediaType": media_type, "digest": digest_of(data), "size": len(data)}


def artifact(
    artifact_type: str,
    part: bytes,
    media_type: str,
    annotations: Mapping[str, str] | None = None,
    subject: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """The manifest of an artifact with one layer. Its blobs are the part and EMPTY_BLOB.

    Args:
        media_type: of the part. subject: descriptor of the manifest that it is attached to, if to one.
    """
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
    """A manifest or index as a registry holds it. `size` is in bytes."""

    content: dict[str, Any]
    digest: str
    media_type: str
    size: int

    @property
    def is_index(self) -> bool:
        """Whether it lists manifests, one for each platform."""
        return self.media_type in INDEXES

    @property
    def descriptor(self) -> dict[str, Any]:
        """What points at it: as subject, or in an index."""
        return {"mediaType": self.media_type, "digest": self.digest, "size": self.size}


class _Shape(BaseModel):
    """What this program reads of an answer, in the form that the distribution API gives it; it may have more. Annotations are
    in none: anybody may write anything there."""

    model_config = ConfigDict(strict=True)


class _Platform(_Shape):
    os: str = ""
    architecture: str = ""
    variant: str | None = None


class _Descriptor(_Shape):
    mediaType: str
    digest: str = Field(pattern=r"^[a-z0-9+._-]+:[A-Za-z0-9=_-]+$")
    size: int = Field(ge=0)
    platform: _Platform | None = None


class _Image(_Shape):
    schemaVersion: int
    config: _Descriptor | None = None
    layers: list[_Descriptor] = []


class _Index(_Shape):
    schemaVersion: int
    manifests: list[_Descriptor] | None


class _Referrers(_Shape):
    manifests: list[_Descriptor] | None


class _Tags(_Shape):
    tags: list[str] | None


REMEDY = (
    "let its operator allow it, or delete with its own tools; on ghcr.io these are the versions of the package, on GitHub's"
    " page of it or by GitHub's API"
)
"""What to do about a registry that deletes nothing."""


class Undeletable(RosmlError):
    """The registry deletes no manifest, whichever it is."""


class _Busy(RosmlError):
    """The registry answered each time that it cannot answer now."""


class _Transient(Exception):
    """Something that may be gone a moment later.

    Attributes:
        after: seconds that the registry asks to wait. connected: whether there was somebody at all.
        final: the kind of error that it is, if it stays.
    """

    def __init__(
        self, message: str, after: float = 0.0, connected: bool = True, final: type[RosmlError] = RosmlError
    ) -> None:
        super().__init__(message)
        self.after = after
        self.connected = connected
        self.final = final


class _Refused(_Transient):
    """What the registry may take a moment later, as when another machine makes the repository, or when a part of the registry
    has not heard yet of a blob that another part has.

    Attributes:
        error: what is wrong, if it stays.
    """

    def __init__(self, error: RosmlError) -> None:
        super().__init__(error.message)
        self.error = error


class _Denied(_Refused):
    """What is denied to an account that the registry knows. There may be no such repository yet."""


class _Untrusted(_Transient):
    """A registry whose certificate is not trusted, or none: sending it again does not help."""


@dataclass(frozen=True)
class _Challenge:
    """How a registry wants to be told who asks."""

    bearer: bool
    realm: str
    service: str
    scopes: frozenset[str]


class Registry:
    """One registry. Safe to share among threads; close it, or use it in a `with`.

    Attributes:
        host: as references have it, e.g. `ghcr.io` or `127.0.0.1:5000`.
        base: the address of its root.
        uploaded: bytes of bodies that were sent so far, those of attempts that failed included.
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
            plain: speak http; by default only to this machine itself, and not where it has certificates in certs.d.
            ca_bundle: a file with the certificates to trust; by default what SSL_CERT_FILE says, or the usual ones.
            credentials: gives those of a host; they are asked for once, when the registry wants them.
        """
        self.host = host
        local = _is_local(host)
        trusted = certificates.of(host)
        scheme = "http" if (local and not trusted if plain is None else plain) else "https"
        self.base = httpx.URL(f"{scheme}://{'registry-1.docker.io' if host == DOCKER_HUB else host}")
        self._client = web.client(
            headers={"User-Agent": "rosml", "Accept-Encoding": "identity"},  # bytes as they are stored
            timeout=httpx.Timeout(ANSWER_SECONDS, connect=10.0, pool=None),
            limits=httpx.Limits(max_connections=CONNECTIONS, max_keepalive_connections=CONNECTIONS),
            verify=scheme == "https" and certificates.context(ca_bundle, trusted),
            trust_env=not local,  # a proxy could not reach this machine
        )
        self._find_credentials = credentials
        self._credentials: Credentials | None = None
        self._asked = False
        self._challenge: _Challenge | None = None
        self._tokens: dict[frozenset[str], tuple[str, float]] = {}
        self._lock = threading.Lock()  # of its own state; never held while somebody is asked
        self._asking = threading.Lock()
        self._attaching: defaultdict[str, threading.Lock] = defaultdict(threading.Lock)  # by the tag of a list
        self._reached = False
        self.uploaded = 0
        self._keeping: set[str] = set()  # repositories that did not discard something
        self._there: set[str] = set()  # repositories that have a manifest, or had
        self._logged_in = False  # it has taken the credentials
        self._warned = False
        self._keeps_account: bool | None = None  # of referrers; None until it was asked

    def __repr__(self) -> str:
        return f"Registry({self.host!r})"

    def __enter__(self) -> Registry:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Closes its connections."""
        self._client.close()

    # ---- Manifests ---------------------------------------------------------------------------------------------------

    def manifest(self, repository: str, reference: str) -> Manifest | None:
        """What is behind a tag or digest; None if there is nothing.

        Raises:
            RosmlError: the registry does not answer or refuses; or what it sends is damaged.
        """
        answer = self._look("GET", f"{repository}/manifests/{reference}", repository)
        if answer is None:
            return None
        if is_digest(reference):
            _verified(answer.content, reference)
        digest = reference if is_digest(reference) else digest_of(answer.content)
        content = self._object(answer)
        kind = answer.headers.get("content-type", "").partition(";")[0].strip()
        media_type = str(content.get("mediaType") or kind)
        self._shaped(answer, content, _Index if media_type in INDEXES else _Image)
        return Manifest(content, digest, media_type, len(answer.content))

    def put_manifest(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str = IMAGE
    ) -> str:
        """Puts a manifest or index under a tag, or by its digest alone if `reference` is empty. Gives its digest.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        return self.send_manifest(repository, reference, content, media_type)[0]

    def send_manifest(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str
    ) -> tuple[str, httpx.Headers]:
        """As `put_manifest`, with the headers of the registry's answer. All manifests go this way."""
        data = content if isinstance(content, bytes) else encoded(content)
        digest = digest_of(data)
        answer = self._ask(
            "PUT",
            f"{repository}/manifests/{reference or digest}",
            repository,
            headers={"Content-Type": media_type},
            content=data,
            push=True,
        )
        self._there.add(repository)
        return digest, answer.headers

    def tag(self, repository: str, digest: str, name: str) -> None:
        """Moves a tag to a manifest or index that is in the repository already.

        Raises:
            RosmlError: it is not there; the registry does not answer or refuses.
        """
        answer = self._look("GET", f"{repository}/manifests/{digest}", repository)
        if answer is None:
            raise RosmlError(f"{self.host}/{repository}@{digest} is not there, so no tag can point at it")
        _verified(answer.content, digest)
        self.put_manifest(repository, name, answer.content, answer.headers.get("content-type", IMAGE))

    def head(self, repository: str, reference: str) -> str:
        """The digest behind a tag or digest; empty if there is nothing.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        answer = self._look("HEAD", f"{repository}/manifests/{reference}", repository)
        if answer is None:
            return ""
        if digest := answer.headers.get("docker-content-digest", ""):
            return str(digest)
        found = self.manifest(repository, reference)
        return found.digest if found else ""

    def tags(self, repository: str) -> list[str]:
        """All tags of a repository; none if there is no such repository.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        found: list[str] = []
        for page in self._pages(f"{repository}/tags/list?n=1000", repository, _Tags):
            found += page["tags"] or []
        return found

    def delete(self, repository: str, reference: str) -> None:
        """Removes a manifest by its digest, and the tags that point at it; or, where the registry can, a tag.

        Raises:
            RosmlError: the registry does not delete, does not answer or refuses.
        """
        answer = self._deletion(repository, reference, (404, 405))
        if answer.status_code == 405:
            if not is_digest(reference):
                raise RosmlError(f"{self.host} deletes no tag by its name", REMEDY)
            raise Undeletable(f"{self.host} deletes nothing", REMEDY)

    def discard(self, repository: str, digest: str) -> None:
        """Removes a manifest that nothing leads to any more, where the registry can; elsewhere it stays, which is no error.

        Many registries delete nothing. One that did not once is not asked again by this client, for that repository.
        """
        if repository in self._keeping:
            return
        try:  # 404 may also be how a registry says that it knows no such request; nobody waits for one that is busy
            answer = self._deletion(repository, digest, (404, 405, *_TRANSIENT))
            gone = answer.is_success or not self.head(repository, digest)
        except RosmlError:
            gone = False
        if not gone:
            self._keeping.add(repository)

    def _deletion(self, repository: str, reference: str, allow: tuple[int, ...]) -> httpx.Response:
        path, also = f"{repository}/manifests/{reference}", (_scope(repository, "delete"),)
        return self._ask("DELETE", path, repository, allow=allow, push=True, also=also)

    # ---- Blobs -------------------------------------------------------------------------------------------------------

    def blob(self, repository: str, digest: str) -> bytes:
        """A blob, checked against its digest; for small ones.

        Raises:
            RosmlError: there is none, or it has another digest; the registry does not answer or refuses.
        """
        return _verified(self._ask("GET", f"{repository}/blobs/{digest}", repository).content, digest)

    def json_blob(self, repository: str, digest: str) -> dict[str, Any]:
        """A blob that is a JSON object, as an image's config is.

        Raises:
            RosmlError: as in `blob`; or it is no JSON object.
        """
        content = docker.json_object(self.blob(repository, digest))
        if content is None:
            raise RosmlError(f"{self.host}/{repository}: {digest} is no JSON object", "push it anew")
        return content

    def read_blob(self, repository: str, digest: str, read: Callable[[Iterator[bytes]], T]) -> T:
        """Has a function read a blob while it arrives. It may stop early: the rest is not downloaded.

        Args:
            read: gets the blob in pieces; from the beginning again if the connection breaks. Who reads to the end knows that
                the digest is right.

        Returns:
            What the function returns.

        Raises:
            RosmlError: as in `blob`.
        """

        def once() -> T:
            with self._stream(repository, digest) as answer:
                return read(_checked(answer.iter_bytes(), digest))

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
        """Makes a blob of another repository of this registry one of this repository, without moving it.

        Returns:
            False if the registry did not.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        path = f"{repository}/blobs/uploads/?mount={_quoted(digest)}&from={_quoted(source_repository)}"
        also = (_scope(source_repository, "pull"),)
        answer = self._ask("POST", path, repository, push=True, also=also, allow=(202,))
        if answer.status_code == 201:
            return True
        self._give_up(repository, answer)  # it began an upload instead
        return False

    def copy_blob(self, repository: str, digest: str, size: int, source: Registry, source_repository: str) -> None:
        """Copies a blob from another repository or registry, without keeping it here.

        Raises:
            RosmlError: it is damaged there; a registry does not answer or refuses.
        """

        def blocks() -> Iterator[bytes]:
            with source._stream(source_repository, digest) as answer:
                yield from _checked(answer.iter_bytes(_BLOCK), digest)

        self._retried(lambda: self._upload(repository, digest, blocks(), size))

    def _upload(self, repository: str, digest: str, content: bytes | Iterator[bytes], size: int) -> None:
        scopes = self._scopes(repository, push=True)
        begun = self._send("POST", self._address(f"{repository}/blobs/uploads/"), scopes)
        self._expect(begun, (202,), repository, push=True)
        if not begun.headers.get("location"):
            raise RosmlError(f"{self.host} does not say where to upload to", "check the registry's set-up")
        location = str(begun.url.join(begun.headers["location"]))
        address = httpx.URL(f"{location}{'&' if '?' in location else '?'}digest={_quoted(digest)}")
        headers = {"Content-Type": "application/octet-stream", "Content-Length": str(size)}
        ended = self._send("PUT", address, scopes, headers=headers, content=content)
        if ended.status_code == 404:  # the registry forgot the upload: another one may hold
            raise _Transient("the registry no longer knows the upload")
        self._expect(ended, (), repository, push=True)

    def may_push(self, repository: str) -> None:
        """Asks whether blobs may be put into a repository, by an upload that is begun and given up.

        Raises:
            RosmlError: they may not; the registry does not answer.
        """
        self._give_up(repository, self._ask("POST", f"{repository}/blobs/uploads/", repository, push=True))

    def _give_up(self, repository: str, begun: httpx.Response) -> None:
        """Ends an upload that nobody wants."""
        if location := begun.headers.get("location"):
            with contextlib.suppress(RosmlError, _Transient):
                self._send("DELETE", begun.url.join(location), self._scopes(repository, push=True))

    # ---- Referrers ---------------------------------------------------------------------------------------------------

    def referrers(self, repository: str, digest: str, artifact_type: str = "") -> list[dict[str, Any]]:
        """Descriptors of the artifacts that are attached to a manifest: of one type, or of all.

        Where the registry has no API for that, they are in an index under the tag that OCI 1.1 names for it.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        if repository not in self._there and not self.head(repository, digest):
            return []  # in a repository that does not exist, the registry may deny anything
        query = f"?artifactType={_quoted(artifact_type)}" if artifact_type else ""
        path = f"{repository}/referrers/{digest}{query}"
        pages = list(self._pages(path, repository, _Referrers)) if self._has_referrers(path, repository) else []
        if not pages and (fallback := self.manifest(repository, _fallback_tag(digest))):
            pages = [fallback.content]
        found = [entry for page in pages for entry in page.get("manifests") or []]
        return [entry for entry in found if artifact_type in ("", entry.get("artifactType"))]

    def _has_referrers(self, path: str, repository: str) -> bool:
        """Whether the registry has the API for what is attached. It is asked once, by the first request of that kind.

        Anything but an index says that it has not. ghcr.io redirects to a page for people, which may be missing, or
        answer 429 for hours.
        """
        if self._keeps_account is None:
            try:
                answer = self._ask("GET", path, repository, allow=_SETTLED)
                content = docker.json_object(answer.content) if answer.status_code == 200 else None
                found = content is not None and not _misfit(content, _Referrers)
            except _Busy:
                found = False
            with self._lock:  # an artifact that was put meanwhile knows it better
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
            media_type: of the part.

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
    ) -> str:
        """Attaches an artifact to a manifest of the repository; the same one again changes nothing.

        Args:
            subject: descriptor of the manifest. media_type: of the part.

        Returns:
            Digest of the artifact's manifest.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        for data in (EMPTY_BLOB, part):
            self.put_blob(repository, data)
        data = encoded(artifact(artifact_type, part, media_type, annotations, subject))
        digest, headers = self.send_manifest(repository, "", data, IMAGE)
        if headers.get("oci-subject") == subject["digest"]:
            self._keeps_account = True
        else:  # this registry keeps no account of referrers
            noted = {"annotations": dict(annotations)} if annotations else {}
            self._list(
                repository, subject["digest"], {**descriptor(IMAGE, data), "artifactType": artifact_type, **noted}
            )
        return digest

    def forget(self, repository: str, subject: str) -> None:
        """Removes the list of what was attached to a manifest that is gone, from a registry that has no API for it.

        Raises:
            RosmlError: the registry does not delete, does not answer or refuses.
        """
        if there := self.head(repository, _fallback_tag(subject)):
            self.delete(repository, there)

    def _list(self, repository: str, subject: str, entry: Mapping[str, Any]) -> None:
        """Adds an artifact to the index under the fallback tag, which is read again before it is written and after: what
        another publisher wrote in between stays. Only two requests to write it at the very same time can still undo each
        other, since registries have no conditional write.

        Raises:
            RosmlError: others write it all the time; the registry does not answer or refuses.
        """
        tag = _fallback_tag(subject)

        def read() -> tuple[str, list[Any], bool]:
            found = self.manifest(repository, tag)
            there = list(found.content.get("manifests") or []) if found else []
            return found.digest if found else "", there, entry["digest"] in [item["digest"] for item in there]

        with self._lock:
            turn = self._attaching[f"{repository}:{tag}"]
        with turn:
            for _ in range(ATTEMPTS):
                digest, there, known = read()
                if known:
                    return
                if self.head(repository, tag) == digest:
                    content = {"schemaVersion": 2, "mediaType": INDEX, "manifests": [*there, entry]}
                    self.put_manifest(repository, tag, content, INDEX)
                    if read()[2]:
                        return
                time.sleep(random.uniform(0, WAIT))
        raise RosmlError(f"{self.host}/{repository}:{tag} is written by others all the time", "run it again")

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
    ) -> httpx.Response:
        """A request, sent again as long as that may help. Any success is an answer, and what `allow` lists."""
        scopes = self._scopes(repository, push, also)

        def once() -> httpx.Response:
            answer = self._send(method, self._address(path), scopes, headers=headers, content=content)
            return self._expect(answer, allow, repository, push)

        return self._retried(once)

    def _look(self, method: str, path: str, repository: str) -> httpx.Response | None:
        """A request for what may not be there; None where it is not.

        ghcr.io may deny what is in a repository that does not exist yet, instead of saying so. What is denied to an account
        that it knows is not there either, therefore, and people are warned: a push says whether the account lacks a right. Not
        so in a repository of which this client saw, or put, a manifest: it exists, and what is taken for missing there would
        have its tag moved without a look at where it was.
        """
        scopes, accept = self._scopes(repository), {"Accept": _ACCEPT} if "/manifests/" in path else {}

        def once() -> httpx.Response | None:
            try:
                answer = self._send(method, self._address(path), scopes, headers=accept)
                return self._expect(answer, (404,), repository, push=False)
            except _Denied as denied:
                if repository in self._there:
                    raise
                self._warn(denied)
                return None

        answer = self._retried(once)
        if answer is None or answer.status_code == 404:
            return None
        if not path.startswith(f"{repository}/blobs/"):  # those may be there before the repository is
            self._there.add(repository)
        return answer

    def _warn(self, denied: _Denied) -> None:
        """Tells people once that what is denied counts as missing."""
        with self._lock:
            warned, self._warned = self._warned, True
        if not warned:
            _LOG.warning("%s: taken for a repository that does not exist yet, as others like it", denied)

    def _pages(self, path: str, repository: str, shape: type[_Shape]) -> Iterator[dict[str, Any]]:
        """All pages of a list; none if the registry knows no such list."""
        seen: set[str] = set()
        while path and path not in seen:  # a registry that links to where we were would never end
            seen.add(path)
            answer = self._look("GET", path, repository)
            if answer is None:
                return
            yield self._shaped(answer, self._object(answer), shape)
            following = answer.links.get("next", {}).get("url", "")
            path = answer.url.join(following).raw_path.decode().partition("/v2/")[2] if following else ""

    def _retried(self, work: Callable[[], T]) -> T:
        """Does some work, again as long as that may help: later each time, or when the registry asks for it."""
        attempt = 0
        while True:
            try:
                return work()
            except _Untrusted as error:
                raise RosmlError(f"{self.host}: {error}", certificates.remedy(self.host, str(error))) from None
            except _Transient as error:
                attempt += 1
                self._reached = self._reached or error.connected
                if isinstance(error, _Refused) and attempt >= ATTEMPTS_REFUSED:
                    raise error.error from None
                if attempt >= (ATTEMPTS if self._reached else ATTEMPTS_UNREACHED):
                    remedy = "run it again; what is finished is kept"
                    if not self._reached:
                        remedy = "check its name, the network and the proxies (HTTPS_PROXY)"
                    raise error.final(f"{self.host}: {error}", remedy) from None
                backoff = WAIT * 2 ** (attempt - 1) + random.uniform(0, WAIT)
                time.sleep(min(max(backoff, error.after), LONGEST_WAIT))

    def _send(
        self,
        method: str,
        address: httpx.URL,
        scopes: frozenset[str],
        *,
        headers: Mapping[str, str] | None = None,
        content: bytes | Iterator[bytes] | None = None,
    ) -> httpx.Response:
        """One request, with who asks: again, once, if the registry then says how it wants to be told."""
        request = self._client.build_request(method, address, headers=dict(headers or {}), content=content)
        with self._open(request, scopes, again=not isinstance(content, Iterator)) as answer:
            with _transport(method, address):
                answer.read()
            return answer

    @contextlib.contextmanager
    def _stream(self, repository: str, digest: str) -> Iterator[httpx.Response]:
        """A blob while it arrives."""
        address = self._address(f"{repository}/blobs/{digest}")
        request = self._client.build_request("GET", address)
        with self._open(request, self._scopes(repository)) as answer:
            if not answer.is_success:
                answer.read()
                self._expect(answer, (), repository, push=False)
            with _transport("GET", address):
                yield answer

    @contextlib.contextmanager
    def _open(self, request: httpx.Request, scopes: frozenset[str], again: bool = True) -> Iterator[httpx.Response]:
        answer, sent = self._exchange(request, scopes, "")
        if answer.status_code == 401 and (challenge := _challenge(answer)):
            answer.close()
            with self._lock:
                self._challenge = challenge
            if not again:
                raise _Transient("the registry asked anew who uploads")
            answer, _ = self._exchange(request, scopes, sent)
        try:
            yield answer
        finally:
            answer.close()

    def _exchange(self, request: httpx.Request, scopes: frozenset[str], refused: str) -> tuple[httpx.Response, str]:
        """Sends a request with who asks. Gives the answer, and what it was sent with."""
        header = ""
        if _origin(request.url) == _origin(self.base):  # nobody else is told who asks
            header = self._authorization(scopes, refused)
        request.headers.pop("authorization", None)
        if header:
            request.headers["Authorization"] = header
        with _transport(request.method, request.url):
            answer = self._followed(request)
        with self._lock:
            self._reached = True
            self.uploaded += int(request.headers.get("content-length", 0))
        return answer, header

    def _followed(self, request: httpx.Request) -> httpx.Response:
        """Sends a request, and follows redirects: of a blob to any storage, of anything else within the registry. Who else
        answers knows nothing of manifests, and would say that one is missing."""
        reads = request.method in ("GET", "HEAD")
        if reads and request.url.path.rpartition("/")[0].endswith("/blobs"):
            return self._client.send(request, stream=True, follow_redirects=True)
        answer = self._client.send(request, stream=True)
        for _ in range(_REDIRECTS):
            following = answer.next_request
            if not reads or following is None or _origin(following.url) != _origin(request.url):
                break
            answer.close()
            answer = self._client.send(following, stream=True)
        return answer

    def _expect(self, answer: httpx.Response, allow: Container[int], repository: str, push: bool) -> httpx.Response:
        """An answer, if it is a success or one of `allow`.

        Raises:
            _Transient: it may be another one soon.
            RosmlError: it will not.
        """
        code = answer.status_code
        if answer.is_success or code in allow:
            return answer
        said = f"{answer.request.method} {answer.request.url.path}: {code}{_reason(answer)}"
        if code in _TRANSIENT:
            raise _Transient(said, _after(answer), final=_Busy)
        if answer.has_redirect_location and not push:
            raise _Transient(f"{said}: a redirect to {httpx.URL(answer.headers['location']).host or 'another place'}")
        if code in (401, 403):
            error = self._denied(f"{'push to' if push else 'pull from'} {repository}", said)
            passing = code == 403 and self._credentials and answer.request.method != "DELETE"
            raise _Denied(error) if passing else error
        if self.base.scheme == "http" and code == 400 and "https" in answer.text.lower():
            raise RosmlError(f"{self.host} does not speak plain http", certificates.remedy(self.host, ""))
        refused = RosmlError(
            f"{self.host}: {said}", "check that this is there: see the reference" if code == 404 else ""
        )
        if push and answer.request.method != "DELETE" and (code in (404, 409) or _codes(answer) & _UNKNOWN):
            raise _Refused(refused)
        raise refused

    def _denied(self, what: str, said: str) -> RosmlError:
        known = "with the account that is logged in" if self._credentials else "without an account"
        remedy = f"docker login {self.host}, with an account that may; or check that there is such a repository"
        return RosmlError(f"{self.host}: access denied: cannot {what} {known} ({said})", remedy)

    def _object(self, answer: httpx.Response) -> dict[str, Any]:
        content = docker.json_object(answer.content)
        if content is None:
            asked = answer.request.url
            raise RosmlError(
                f"{self.host}: the answer to GET {_named(asked)} is no JSON object, so no registry gave it",
                "check the address, and HTTPS_PROXY: a proxy may answer in its place, such as with a page to sign in",
            )
        return content

    def _shaped(self, answer: httpx.Response, content: dict[str, Any], shape: type[_Shape]) -> dict[str, Any]:
        """An answer, if it has what this program reads of it, in the form that the distribution API gives it.

        Raises:
            RosmlError: it has not.
        """
        if wrong := _misfit(content, shape):
            text = f"{self.host} does not answer as a registry: GET {answer.request.url.path}: {wrong}"
            remedy = "check its name and the proxies (HTTPS_PROXY); if they are right, push anew what is damaged there"
            raise RosmlError(text, remedy) from None
        return content

    # ---- Who asks ----------------------------------------------------------------------------------------------------

    def _authorization(self, scopes: frozenset[str], refused: str) -> str:
        """The header that says who asks; empty as long as the registry did not want to know.

        Args:
            refused: the header that the registry just refused.
        """
        with self._lock:
            challenge = self._challenge
        if challenge is None:
            return ""
        if challenge.bearer and (header := self._kept(scopes, refused)):
            return header
        with self._asking:  # one thread at a time runs the program that keeps passwords, and asks for tokens
            if not self._asked:
                self._credentials, self._asked = self._find_credentials(self.host), True
            known = self._credentials
            if not challenge.bearer:
                if known is None:
                    raise self._denied("log in", "it asks for a user's name and a password")
                return "Basic " + base64.b64encode(f"{known.username}:{known.password}".encode()).decode()
            if header := self._kept(scopes, refused):
                return header
            token, seconds = self._token(challenge, scopes | challenge.scopes if refused else scopes, known)
            with self._lock:
                self._tokens[scopes] = (token, time.monotonic() + 0.8 * seconds)
            return f"Bearer {token}"

    def _kept(self, scopes: frozenset[str], refused: str) -> str:
        """The header with the token that is there for some scopes; empty where there is none, or it does not hold."""
        with self._lock:
            token, end = self._tokens.get(scopes, ("", 0.0))
        header = f"Bearer {token}"
        return header if token and header != refused and time.monotonic() <= end else ""

    def _token(self, challenge: _Challenge, scopes: frozenset[str], known: Credentials | None) -> tuple[str, float]:
        """A Bearer token for some scopes, and for how many seconds it holds."""
        try:
            realm = self.base.join(challenge.realm)
        except httpx.InvalidURL:
            raise RosmlError(
                f"{self.host} does not say where to ask for a token", "check the registry's set-up"
            ) from None
        if realm.scheme != "https" and self.base.scheme == "https":
            raise RosmlError(f"{self.host} wants passwords sent in the clear, to {realm.host}", "take another registry")
        fields = {"service": challenge.service} if challenge.service else {}
        with _transport("asking for a token at", realm):
            if known and known.identity_token:
                grant = {"grant_type": "refresh_token", "refresh_token": known.identity_token, "client_id": "rosml"}
                answer = self._client.post(realm, data={**fields, **grant, "scope": " ".join(sorted(scopes))})
            else:
                query = [*realm.params.multi_items(), *fields.items(), *(("scope", item) for item in sorted(scopes))]
                password = httpx.BasicAuth(known.username, known.password) if known else None
                answer = self._client.get(realm.copy_with(params=query), auth=password)
        if answer.status_code in _TRANSIENT:
            raise _Transient(f"asking for a token: {answer.status_code}", _after(answer))
        said = f"asking for a token: {answer.status_code}"
        if answer.status_code == 403 and known and scopes:
            if not self._logged_in:  # without a repository, it is the log-in alone that can be refused
                self._token(challenge, frozenset(), known)
            raise _Denied(self._denied(f"have {' '.join(sorted(scopes))}", said))
        if not answer.is_success:
            raise self._denied("log in", said)
        self._logged_in = True
        content = self._object(answer)
        token = content.get("token") or content.get("access_token")
        if not isinstance(token, str) or not token:
            raise RosmlError(f"{self.host} gave no token, although it asks for one", "run it again")
        seconds = content.get("expires_in")
        return token, float(seconds) if isinstance(seconds, (int, float)) and seconds > 0 else 60.0


# ---- Helpers ---------------------------------------------------------------------------------------------------------


@contextlib.contextmanager
def _transport(method: str, address: httpx.URL) -> Iterator[None]:
    """Turns what goes wrong on the way into something that may be gone a moment later."""
    try:
        yield
    except httpx.TransportError as error:
        text = str(error)
        if "CERTIFICATE_VERIFY_FAILED" in text:
            reason = re.sub(r"^.*certificate verify failed: | \(_ssl.*$", "", text)
            raise _Untrusted(f"its certificate is not trusted: {reason}") from None
        connected = not isinstance(error, httpx.ConnectError | httpx.ConnectTimeout)
        raise _Transient(f"{method} {address.path}: {error or type(error).__name__}", connected=connected) from None
    except (httpx.TooManyRedirects, httpx.DecodingError, httpx.InvalidURL) as error:
        what = "redirects without end" if isinstance(error, httpx.TooManyRedirects) else type(error).__name__
        raise RosmlError(
            f"{method} {_named(address)}: {what}", "check the address, and the set-up of the registry and its proxy"
        ) from None


def _named(address: httpx.URL) -> str:
    """An address for messages: without a user, and without what is asked for."""
    return f"{address.host}{f':{address.port}' if address.port else ''}{address.path}"


def _is_local(host: str) -> bool:
    name = host.rpartition(":")[0] if re.search(r":[0-9]+$", host) else host
    return name in ("localhost", "[::1]") or re.fullmatch(r"127(\.[0-9]+){3}", name) is not None


def _origin(address: httpx.URL) -> tuple[str, str, int | None]:
    return address.scheme, address.host, address.port


def _scope(repository: str, actions: str) -> str:
    return f"repository:{repository}:{actions}"


def _quoted(text: str) -> str:
    return str(httpx.QueryParams({"x": text}))[2:]


def _fallback_tag(digest: str) -> str:
    return digest.replace(":", "-")


def _challenge(answer: httpx.Response) -> _Challenge | None:
    """What a registry that answered 401 asks for; None if it does not say so in a way that is known."""
    for text in answer.headers.get_list("www-authenticate"):
        scheme, _, rest = text.partition(" ")
        fields = {name.lower(): quoted or bare for name, quoted, bare in _CHALLENGE.findall(rest)}
        if scheme.lower() == "bearer" and fields.get("realm"):
            scopes = frozenset(fields.get("scope", "").split())
            return _Challenge(True, fields["realm"], fields.get("service", ""), scopes)
        if scheme.lower() == "basic":
            return _Challenge(False, "", "", frozenset())
    return None


def _reason(answer: httpx.Response) -> str:
    """What a registry says about an error, in brackets; nothing if it says nothing."""
    try:
        errors = json.loads(answer.content)["errors"]
        said = listed(list(dict.fromkeys(str(error.get("message") or error["code"]) for error in errors)))
    except (AttributeError, KeyError, TypeError, ValueError, httpx.ResponseNotRead):
        return ""
    return f" ({said[:300]})"


def _codes(answer: httpx.Response) -> set[str]:
    """The codes of the errors of an answer."""
    errors = (docker.json_object(answer.content) or {}).get("errors")
    return (
        {str(error.get("code")) for error in errors if isinstance(error, dict)} if isinstance(errors, list) else set()
    )


def _after(answer: httpx.Response) -> float:
    """Seconds that a registry asks to wait: `Retry-After` has them, or a date."""
    text = answer.headers.get("retry-after", "")
    if text.isdecimal():
        return float(text)
    try:
        return email.utils.parsedate_to_datetime(text).timestamp() - time.time()
    except (TypeError, ValueError):
        return 0.0


def _misfit(content: Mapping[str, Any], shape: type[_Shape]) -> str:
    """What of an answer has another form than the distribution API gives it; empty where nothing has."""
    try:
        shape.model_validate(content)
    except ValidationError as error:
        return first_of(error)
    return ""


def _hash(digest: str) -> Any:
    algorithm = digest.partition(":")[0]
    if algorithm not in ("sha256", "sha512"):
        raise RosmlError(f"{digest} is a digest of a kind that is not known")
    return hashlib.new(algorithm)


def _check(found: str, digest: str) -> None:
    if found != digest.partition(":")[2]:
        raise RosmlError(f"what the registry has as {digest} has another digest", "it is damaged there: push it anew")


def _checked(blocks: Iterable[bytes], digest: str) -> Iterator[bytes]:
    """The pieces of a blob; after the last one, an error if the whole has another digest."""
    state = _hash(digest)
    for block in blocks:
        state.update(block)
        yield block
    _check(state.hexdigest(), digest)


def _verified(data: bytes, digest: str) -> bytes:
    """The data, if it has the digest.

    Raises:
        RosmlError: it has another one.
    """
    state = _hash(digest)
    state.update(data)
    _check(state.hexdigest(), digest)
    return data
