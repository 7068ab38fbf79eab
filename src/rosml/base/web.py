"""HTTP clients with the environment's proxies and certificates. If these cannot be used, the error says so without a traceback.

Servers' answers have limits: we check addresses in them, count redirects, and read a body as it was sent, up to a size. We unpack
nothing, because a few kB of gzip can hold gigabytes.
"""

from __future__ import annotations

import contextlib
import email.utils
import functools
import logging
import os
import socket
import ssl
import time
from collections.abc import Mapping
from http.cookiejar import CookieJar
from typing import Any
from urllib.parse import urlsplit

import httpx

from rosml.base import units
from rosml.base.errors import RosmlError

# Both log addresses and headers, with passwords of mirrors and signatures of storage. Who turns logging on must not get them.
for _library in ("httpx", "httpcore"):
    logging.getLogger(_library).setLevel(logging.WARNING)

PROXIES = ("HTTPS_PROXY", "https_proxy", "HTTP_PROXY", "http_proxy", "ALL_PROXY", "all_proxy")

REDIRECTS = 5
"""The most redirects of a request."""

EXCERPT = 64 << 10
"""The largest part that is read of an error or a redirect."""

BUSY = (429, 500, 502, 503, 504)
"""Status codes of answers that may differ a moment later."""

ATTEMPTS = 3
"""How often we ask a busy server."""

WAIT, LONGEST_WAIT = 1.0, 30.0
"""Seconds before the second attempt, doubled with every further one; and the longest wait that a server may ask for."""

LONGEST = 600.0
"""Seconds that the whole of a body may take."""


class Unfit(ValueError):
    """A server's answer that we refuse. The message says why."""


class _NoCookies(CookieJar):
    """Keeps no cookie: no server needs one."""

    def extract_cookies(self, *_: object) -> None:
        pass


def client(**options: Any) -> httpx.Client:
    """A client of httpx with the environment's proxies, for unpacked bodies, without cookies. `verify` is `trusted()` by default."""
    try:
        if "verify" not in options:  # plain http needs no certificates
            options["verify"] = trusted()
        headers = {"Accept-Encoding": "identity", **options.pop("headers", {})}
        return httpx.Client(headers=headers, cookies=_NoCookies(), **options)
    except (ImportError, ValueError) as error:
        proxies = [f"{name}={os.environ[name].rpartition('@')[2]}" for name in PROXIES if os.environ.get(name)]
        text = f"a proxy of the environment cannot be used: {', '.join(proxies) or error}"
        raise RosmlError(text, "name proxies as http://host:port or https://host:port", exit_code=2) from None
    except OSError as error:
        name = os.environ.get("SSL_CERT_FILE", "")
        text = f"SSL_CERT_FILE={name}: {error.strerror or error}"
        raise RosmlError(text, "let it name certificates in PEM", exit_code=2) from None


def is_here(address: str) -> bool:
    """Whether an address, such as `http://host:3142`, is this machine's: a socket can be bound to its host."""
    try:
        host = urlsplit(address if "//" in address else f"//{address}").hostname
        addresses = socket.getaddrinfo(host, 0, type=socket.SOCK_STREAM) if host else []
    except (OSError, ValueError):  # no address, or no such host
        return False
    for family, kind, *_others, place in addresses:
        with contextlib.suppress(OSError), socket.socket(family, kind) as probe:
            probe.bind(place)
            return True
    return False


def trusted() -> ssl.SSLContext:
    """TLS' authorities. All clients share the context: reading hundreds of certificates takes 50 ms, more than most requests."""
    return _trusted(os.environ.get("SSL_CERT_FILE", ""), os.environ.get("SSL_CERT_DIR", ""))


@functools.cache
def _trusted(_file: str, _folder: str) -> ssl.SSLContext:
    return httpx.create_ssl_context()


def joined(base: httpx.URL, text: str) -> httpx.URL:
    """The address that a server names, relative to the asked one. Raises Unfit."""
    try:
        return checked(base.join(text))
    except (httpx.InvalidURL, ValueError):
        raise Unfit("it names an address that is none") from None


def checked(address: httpx.URL) -> httpx.URL:
    """Raises Unfit if an address cannot be asked: its scheme is not http or https, or its host is no name."""
    try:
        address.host.encode("idna")  # as the look-up of the name does it
    except UnicodeError:
        raise Unfit("it names a host that is no name") from None
    port = 80 if address.port is None else address.port
    if address.scheme not in ("http", "https") or not address.host or not 0 < port < 1 << 16:
        raise Unfit("it names an address that is none")
    return address


def origin(address: httpx.URL) -> tuple[str, str, int | None]:
    """Scheme, host and port."""
    return address.scheme, address.host, address.port


def followed(client: httpx.Client, request: httpx.Request, elsewhere: bool) -> httpx.Response:
    """Sends a request, and follows its redirects if it only reads. `Authorization` goes to no other origin. Does not read the body.

    Unless `elsewhere` is set, a redirect to another origin is the answer. Raises Unfit and httpx.HTTPError.
    """
    answer = client.send(request, stream=True, follow_redirects=False)
    for _ in range(REDIRECTS):
        following = answer.next_request
        if following is None or request.method not in ("GET", "HEAD"):
            return answer
        if not elsewhere and origin(following.url) != origin(request.url):
            return answer
        excerpt(answer)
        checked(following.url)
        answer = client.send(following, stream=True, follow_redirects=False)
    answer.close()
    raise Unfit("redirects without end")


def after(headers: Mapping[str, str]) -> float:
    """Seconds that a server asks to wait, from `Retry-After`, which has seconds or a date. 0 if it has neither."""
    text = headers.get("retry-after", "")[:64]
    if text.isdecimal():
        return float(text)
    try:
        return email.utils.parsedate_to_datetime(text).timestamp() - time.time()
    except (TypeError, ValueError, IndexError, OverflowError):
        return 0.0


def waited(attempt: int, seconds: float = 0.0) -> bool:
    """Waits before asking a busy server again. Returns False, without a wait, if it was asked `attempt` times and that is enough."""
    if attempt >= ATTEMPTS:
        return False
    time.sleep(min(max(WAIT * 2 ** (attempt - 1), seconds), LONGEST_WAIT))
    return True


def fetched(client: httpx.Client, url: str) -> httpx.Response:
    """Asks for a file, again if the server is too busy or breaks off. Does not read the body. Raises as `followed`."""
    attempt = 0
    while True:
        attempt += 1
        try:
            answer = followed(client, client.build_request("GET", url), elsewhere=True)
        except (httpx.ReadError, httpx.RemoteProtocolError):
            if not waited(attempt):
                raise
        else:
            if answer.status_code not in BUSY or not waited(attempt, after(answer.headers)):
                return answer
            answer.close()


def read(answer: httpx.Response, limit: int) -> bytes:
    """The whole body of an answer, as it was sent. Raises Unfit if it has more than `limit` bytes, or takes longer than `LONGEST`."""
    length = answer.headers.get("content-length", "")
    if length.isdecimal() and (len(length) > 18 or int(length) > limit) and answer.request.method != "HEAD":
        answer.close()
        raise Unfit(f"it has more than {units.size(limit)}")
    blocks = _blocks(answer, limit)
    if sum(map(len, blocks)) > limit:
        raise Unfit(f"it has more than {units.size(limit)}")
    return b"".join(blocks)


def excerpt(answer: httpx.Response, limit: int = EXCERPT) -> bytes:
    """The beginning of an answer's body, as it was sent. The rest is not read."""
    return b"".join(_blocks(answer, limit))[:limit]


def _blocks(answer: httpx.Response, limit: int) -> list[bytes]:
    """The pieces of a body until they are more than `limit` bytes."""
    blocks, room, end = [], limit, time.monotonic() + LONGEST
    with contextlib.closing(answer):
        for block in answer.iter_raw():
            blocks.append(block)
            room -= len(block)
            if room < 0:
                break
            if time.monotonic() > end:
                raise Unfit(f"it takes longer than {units.duration(LONGEST)}")
    return blocks
