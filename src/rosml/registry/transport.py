"""Requests to one registry: connections, credentials, redirects, limits, and attempts.

A request is sent again if its failure may pass. If it does not pass, the error has a remedy. No message, log line or
repr holds a password, a token or a signed address.
"""

from __future__ import annotations

import contextlib
import logging
import re
import threading
import time
from collections.abc import Callable, Container, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

import httpx

from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.registry import answers, certificates, login, retries
from rosml.registry.answers import Answer, codes, reason
from rosml.registry.credentials import DOCKER_HUB, Credentials
from rosml.registry.failures import (
    Busy,
    Denied,
    Immutable,
    Limited,
    Refused,
    Transient,
    Untrusted,
    http_errors,
    unfit,
    without_query,
)

ANSWER_SECONDS = 60.0
"""Time limit for the next bytes of an answer."""

CONNECTIONS = 32

PAGES = 1000
"""The most pages of a list. Registries give 100 to 1,000 tags on each page."""

LIST_BYTES = 64 << 20
"""Largest list, of all its pages together."""

_IMMUTABLE = re.compile(r"\bimmutable\b|cannot be overwritten", re.IGNORECASE)
"""What registries say if a tag may not move: Amazon's, Google's, Harbor and Quay."""

_UNKNOWN = {"BLOB_UNKNOWN", "MANIFEST_BLOB_UNKNOWN", "MANIFEST_UNKNOWN"}

_LOG = logging.getLogger(__name__)

T = TypeVar("T")


def scope(repository: str, actions: str) -> str:
    """A right that a token server grants: https://distribution.github.io/distribution/spec/auth/scope/"""
    return f"repository:{repository}:{actions}"


@dataclass(frozen=True)
class Call:
    """A request to a path below `/v2/`."""

    method: str
    path: str
    repository: str
    push: bool = False
    headers: Mapping[str, str] = field(default_factory=dict)
    content: bytes | Iterator[bytes] | None = None
    more_scopes: tuple[str, ...] = ()
    allow: Container[int] = ()  # statuses that are no failure, as those of success
    limit: int = answers.JSON_BYTES  # the largest body of a success

    @property
    def scopes(self) -> frozenset[str]:
        return frozenset((scope(self.repository, "pull,push" if self.push else "pull"), *self.more_scopes))


class Transport:
    """The connections to one registry. Safe to share among threads."""

    def __init__(
        self, host: str, plain: bool | None, ca_bundle: str, credentials: Callable[[str], Credentials | None]
    ) -> None:
        self.host = host
        local = login.is_local(host)
        authorities = certificates.of(host)
        scheme = "http" if (local and not authorities if plain is None else plain) else "https"
        self.base = httpx.URL(f"{scheme}://{'registry-1.docker.io' if host == DOCKER_HUB else host}")
        self.client = web.client(
            headers={"User-Agent": "rosml"},
            timeout=httpx.Timeout(ANSWER_SECONDS, connect=10.0, pool=None),
            limits=httpx.Limits(max_connections=CONNECTIONS, max_keepalive_connections=CONNECTIONS),
            verify=scheme == "https" and certificates.context(ca_bundle, authorities),
            trust_env=not local,  # a proxy could not reach this machine
        )
        self.login = login.Login(host, self.base, self.client, credentials)
        self.uploaded = 0  # bytes of bodies sent so far, including failed attempts
        self.existing: set[str] = set()  # repositories that have, or had, a manifest
        self._lock = threading.Lock()  # guards the state of this object; never held during a request
        self._sent = threading.local()
        self._reached = False
        self._answered = False  # whether an answer was another than 429
        self._warned = False

    @property
    def sent_by_this_thread(self) -> int:
        """As `uploaded`, of this thread alone."""
        return int(getattr(self._sent, "bytes", 0))

    # ---- Calls -------------------------------------------------------------------------------------------------------

    def ask(self, call: Call) -> Answer:
        """Sends a request, again if that may help."""
        return self.retried(lambda: self.attempt(call))

    def look(self, call: Call) -> Answer | None:
        """Sends a request for something that may be missing; None if it is.

        ghcr.io may deny access to a repository that does not exist yet. If it denies a known account, the content counts as missing, with
        a warning; a later push shows whether the account lacks a right. In a repository with a manifest that this client read or put, a
        denial is an error: a wrong "missing" would move a tag without a record of where it was.
        """

        def once() -> Answer | None:
            try:
                return self.attempt(replace(call, allow=(404,)))
            except Denied as denied:
                if call.repository in self.existing:
                    raise
                with self._lock:
                    warned, self._warned = self._warned, True
                if not warned:
                    _LOG.warning("%s: taken for a repository that does not exist yet; this warning comes once", denied)
                return None

        answer = self.retried(once)
        if answer is None or answer.status_code == 404:
            return None
        if not call.path.startswith(f"{call.repository}/blobs/"):  # a blob may come before the repository exists
            self.existing.add(call.repository)
        return answer

    def pages(self, path: str, repository: str, shape: type[Shape]) -> Iterator[dict[str, Any]]:
        """All pages of a list; none if the registry has no such list."""
        visited: set[str] = set()
        room = LIST_BYTES
        while path and path not in visited:  # if a page links to an earlier one, the list would never end
            visited.add(path)
            answer = self.look(Call("GET", path, repository))
            if answer is None:
                return
            room -= len(answer.content)
            if len(visited) > PAGES or room < 0:
                raise unfit("GET", answer.url, "a list without end")
            content = answers.json_object(self.host, answer)
            with answers.well_formed(self.host, answer):
                shape.model_validate(content)
            yield content
            path = self._next(answer)

    def _next(self, answer: Answer) -> str:
        """The path of the page after this one; empty if it is the last."""
        link = re.match(r"\s*<([^<>\s]{1,8192})>((?:\s*;[^;,]{0,256}){1,8})", answer.headers.get("link", ""))
        if link is None or not re.search(r';\s*rel\s*=\s*"?next"?\s*(?:;|$)', link[2]):
            return ""
        try:
            address = web.joined(answer.url, link[1])
        except web.Unfit as error:
            raise unfit("GET", answer.url, f"the next page: {error}") from None
        path = address.raw_path.decode()
        if address.host != self.base.host or not path.startswith("/v2/"):  # no other host gets the request
            raise unfit("GET", answer.url, f"the next page is elsewhere: {without_query(address)}")
        return path.removeprefix("/v2/")

    # ---- Attempts ----------------------------------------------------------------------------------------------------

    def retried(self, work: Callable[[], T]) -> T:
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
                self._answered = self._answered or (error.connected and not isinstance(error, Limited))
                seconds = retries.pause(error, attempt, self._reached)
                if seconds is None:
                    raise self._final(error) from None
                time.sleep(seconds)

    def _final(self, error: Transient) -> RosmlError:
        if isinstance(error, Refused):
            return error.error
        remedy = "run it again; what is finished is kept"
        if not self._reached:
            remedy = "check its name, the network and the proxies (HTTPS_PROXY)"
        if isinstance(error, Limited):
            remedy = self.login.slower(error.after)
        return error.final(f"{self.host}: {error}", remedy)

    def attempt(self, call: Call, address: httpx.URL | None = None) -> Answer:
        """Sends a request once, to an address if it is not that of its path. Raises Transient if the next attempt may succeed."""
        return self._judge(self.send(call, address), call)

    def send(self, call: Call, address: httpx.URL | None = None) -> Answer:
        """Sends a request once, and gives any answer. If that is a challenge, the request is sent with credentials."""
        with self._open(call, address) as answer, http_errors(call.method, answer.url):
            return answers.whole(answer, call.limit)

    @contextlib.contextmanager
    def stream(self, repository: str, digest: str, block: int | None = None) -> Iterator[Iterator[bytes]]:
        """The pieces of a blob while it arrives, of `block` bytes each if that is set."""
        call = Call("GET", f"{repository}/blobs/{digest}", repository)
        address = self._address(call.path)

        def blocks() -> Iterator[bytes]:
            with http_errors("GET", address):
                yield from answer.iter_raw(block)

        with self._open(call) as answer:
            if not answer.is_success:
                with http_errors("GET", address):
                    failed = answers.whole(answer, 0)
                self._judge(failed, call)
            yield blocks()

    @contextlib.contextmanager
    def _open(self, call: Call, address: httpx.URL | None = None) -> Iterator[httpx.Response]:
        target = address or self._address(call.path)
        request = self.client.build_request(call.method, target, headers=dict(call.headers), content=call.content)
        answer, sent_header = self._exchange(request, call.scopes, "")
        if self.login.challenged(answer):
            with http_errors(request.method, request.url):
                web.excerpt(answer)
            if isinstance(call.content, Iterator):
                raise Transient("the registry asked again who uploads")
            answer, _ = self._exchange(request, call.scopes, sent_header)
        try:
            yield answer
        finally:
            answer.close()

    def _address(self, path: str) -> httpx.URL:
        try:
            return self.base.join(f"/v2/{path}")
        except httpx.InvalidURL:
            raise RosmlError(f"{self.host}: {path!r} is no address", "check the reference that leads there") from None

    def _exchange(self, request: httpx.Request, scopes: frozenset[str], refused: str) -> tuple[httpx.Response, str]:
        """Sends a request with credentials. Gives the answer, and the header `Authorization` that it sent."""
        header = self.login.header(request.url, scopes, refused)
        request.headers.pop("authorization", None)
        if header:
            request.headers["Authorization"] = header
        with http_errors(request.method, request.url):
            is_blob = request.url.path.rpartition("/")[0].endswith("/blobs")  # another host would miss any manifest
            answer = web.followed(self.client, request, elsewhere=is_blob)
        size = int(request.headers.get("content-length", 0))
        with self._lock:
            self._reached = True
            self.uploaded += size
        self._sent.bytes = self.sent_by_this_thread + size
        return answer, header

    # ---- Answers -----------------------------------------------------------------------------------------------------

    def _judge(self, answer: Answer, call: Call) -> Answer:
        """Gives an answer that is a success, or that the call allows."""
        code = answer.status_code
        limited = code == httpx.codes.TOO_MANY_REQUESTS
        self._answered = self._answered or not limited
        if answer.is_success or code in call.allow:
            return answer
        is_own = web.origin(answer.url) == web.origin(self.base)
        place = answer.url.path if is_own else without_query(answer.url)
        text = f"{answer.method} {place}: {code}{reason(answer)}"
        if limited:
            raise Limited(text, web.after(answer.headers), from_the_first=not self._answered)
        if code in web.BUSY:
            raise Transient(text, web.after(answer.headers), final=Busy)
        if answer.redirect and not call.push:
            raise Transient(f"{text}: a redirect to {answer.redirect}")
        raise self._refusal(answer, call, text)

    def _refusal(self, answer: Answer, call: Call, text: str) -> Exception:
        code = answer.status_code
        if code in (401, 403):
            error = self.login.denied(f"{'push to' if call.push else 'pull from'} {call.repository}", text)
            may_pass = code == 403 and self.login.credentials and answer.method != "DELETE"
            return Denied(error) if may_pass else error
        if self.base.scheme == "http" and code == 400 and b"https" in answer.content.lower():
            return RosmlError(f"{self.host} does not speak plain http", certificates.remedy(self.host, ""))
        if call.push and _IMMUTABLE.search(text):
            tag = f"{self.host}/{call.repository}:{answer.url.path.rpartition('/')[2]}"
            message = f"{tag} is there with other content, and the registry lets no tag move: {text}"
            return Immutable(message, "choose another tag")
        remedy = "check the reference" if code == 404 else "ask the registry's operator, or look into its log"
        error = RosmlError(f"{self.host}: {text}", remedy)
        if call.push and answer.method != "DELETE" and (code in (404, 409) or codes(answer) & _UNKNOWN):
            return Refused(error)
        return error


class Group:
    def __init__(self, transport: Transport) -> None:
        self.transport = transport
        self.host = transport.host
