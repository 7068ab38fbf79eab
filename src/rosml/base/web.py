"""HTTP clients, as the environment has it: proxies and certificates that cannot be used are told, and are no traceback.

What servers answer has limits here: addresses that they name are checked, redirects are counted, and a body is read as it was
sent, up to a size. Nothing is unpacked: a few kB of gzip can hold gigabytes.
"""

from __future__ import annotations

import contextlib
import email.utils
import functools
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

PROXIES = ("HTTPS_PROXY", "https_proxy", "HTTP_PROXY", "http_proxy", "ALL_PROXY", "all_proxy")

REDIRECTS = 5
"""How many redirects one request follows."""

EXCERPT = 64 << 10
"""Bytes that are read of an answer that nobody needs as a whole: an error, or a redirect."""


BUSY = (429, 500, 502, 503, 504)
"""Answers that may be other ones a moment later."""

ATTEMPTS = 3
"""How often a server is asked for a list that is busy."""

WAIT, LONGEST_WAIT = 1.0, 30.0
"""Seconds before the second attempt, which double with every further one; and what a server may ask for at most."""

LONGEST = 600.0
"""Seconds that a body may take that is read as a whole."""


class Unfit(ValueError):
    """What a server sent and this program does not take. The message says why, in words."""


class _NoCookies(CookieJar):
    """Keeps nothing: no server that this program asks needs a cookie."""

    def extract_cookies(self, *_: object) -> None:
        pass


def client(**options: Any) -> httpx.Client:
    """A client of httpx, which trusts what `trusted` says unless told otherwise by `verify`. It asks for bodies as they are,
    and keeps no cookies.

    Raises:
        RosmlError: a variable of the environment names a proxy of a kind that is not supported, or certificates that cannot
            be read (exit code 2).
    """
    try:
        if "verify" not in options:  # who speaks plain http reads no certificates
            options["verify"] = trusted()
        headers = {"Accept-Encoding": "identity", **options.pop("headers", {})}
        return httpx.Client(headers=headers, cookies=_NoCookies(), **options)
    except (ImportError, ValueError) as error:
        named = [f"{name}={os.environ[name].rpartition('@')[2]}" for name in PROXIES if os.environ.get(name)]
        text = f"a proxy of the environment cannot be used: {', '.join(named) or error}"
        raise RosmlError(text, "name proxies as http://host:port or https://host:port", exit_code=2) from None
    except OSError as error:
        name = os.environ.get("SSL_CERT_FILE", "")
        raise RosmlError(
            f"SSL_CERT_FILE={name}: {error.strerror or error}", "let it name certificates in PEM", exit_code=2
        ) from None


def is_here(address: str) -> bool:
    """Whether an address, such as `http://host:3142`, names this machine: a socket can be bound to where its host is."""
    try:
        host = urlsplit(address if "//" in address else f"//{address}").hostname
        found = socket.getaddrinfo(host, 0, type=socket.SOCK_STREAM) if host else []
    except (OSError, ValueError):  # no address, or no such host
        return False
    for family, kind, *_others, place in found:
        with contextlib.suppress(OSError), socket.socket(family, kind) as probe:
            probe.bind(place)
            return True
    return False


def trusted() -> ssl.SSLContext:
    """What TLS trusts by SSL_CERT_FILE or SSL_CERT_DIR, by default the usual authorities: for all clients, nobody changes it.

    Reading hundreds of certificates takes 50 ms, more than most requests.

    Raises:
        OSError: the file cannot be read, or has no certificate in PEM.
    """
    return _trusted(os.environ.get("SSL_CERT_FILE", ""), os.environ.get("SSL_CERT_DIR", ""))


@functools.cache
def _trusted(_file: str, _folder: str) -> ssl.SSLContext:
    return httpx.create_ssl_context()


# ---- Answers ---------------------------------------------------------------------------------------------------------


def joined(base: httpx.URL, text: str) -> httpx.URL:
    """The address that a server names, as seen from the address that it was asked at.

    Raises:
        Unfit: it is none that can be asked.
    """
    try:
        return checked(base.join(text))
    except (httpx.InvalidURL, ValueError):
        raise Unfit("it names an address that is none") from None


def checked(address: httpx.URL) -> httpx.URL:
    """An address, if it can be asked.

    Raises:
        Unfit: it has another scheme than http and https, or a host that is no name.
    """
    try:
        address.host.encode("idna")  # as the look-up of the name does it
    except UnicodeError:
        raise Unfit("it names a host that is no name") from None
    port = 80 if address.port is None else address.port
    if address.scheme not in ("http", "https") or not address.host or not 0 < port < 1 << 16:
        raise Unfit("it names an address that is none")
    return address


def origin(address: httpx.URL) -> tuple[str, str, int | None]:
    """Scheme, host and port: who is asked."""
    return address.scheme, address.host, address.port


def followed(client: httpx.Client, request: httpx.Request, elsewhere: bool) -> httpx.Response:
    """Sends a request, and follows its redirects if it only reads. `Authorization` goes to no other origin. Nothing of the
    answer's body is read yet.

    Args:
        elsewhere: follow redirects to other origins too. Otherwise such a redirect is the answer.

    Raises:
        Unfit: there are too many redirects, or one leads to no address.
        httpx.HTTPError: nobody answers, or in no form that is HTTP.
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
    """Seconds that a server asks to wait: `Retry-After` has them, or a date. 0 if it asks for nothing that can be read."""
    text = headers.get("retry-after", "")[:64]
    if text.isdecimal():
        return float(text)
    try:
        return email.utils.parsedate_to_datetime(text).timestamp() - time.time()
    except (TypeError, ValueError, IndexError, OverflowError):
        return 0.0


def waited(attempt: int, seconds: float = 0.0) -> bool:
    """Waits before a server that was too busy is asked again; false, without a wait, if it was asked often enough.

    Args:
        attempt: how often it was asked. seconds: that it asks to wait.
    """
    if attempt >= ATTEMPTS:
        return False
    time.sleep(min(max(WAIT * 2 ** (attempt - 1), seconds), LONGEST_WAIT))
    return True


def asked(client: httpx.Client, url: str) -> httpx.Response:
    """Asks for a file, again if the server is too busy or breaks off. Nothing of the answer's body is read yet.

    Raises:
        Unfit: there are too many redirects, or one leads to no address.
        httpx.HTTPError: nobody answers, or in no form that is HTTP.
    """
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
    """The body of an answer, as it was sent, up to its end.

    Args:
        limit: its largest size, in bytes.

    Raises:
        Unfit: it is larger, or takes longer than `LONGEST`.
        httpx.HTTPError: it does not arrive.
    """
    said = answer.headers.get("content-length", "")
    if said.isdecimal() and (len(said) > 18 or int(said) > limit) and answer.request.method != "HEAD":
        answer.close()
        raise Unfit(f"it has more than {units.size(limit)}")
    blocks = _blocks(answer, limit)
    if sum(map(len, blocks)) > limit:
        raise Unfit(f"it has more than {units.size(limit)}")
    return b"".join(blocks)


def excerpt(answer: httpx.Response, limit: int = EXCERPT) -> bytes:
    """The beginning of an answer's body, as it was sent. The rest is not read.

    Raises:
        httpx.HTTPError: it does not arrive.
    """
    return b"".join(_blocks(answer, limit))[:limit]


def _blocks(answer: httpx.Response, limit: int) -> list[bytes]:
    """The pieces of a body until they are more than `limit` bytes."""
    found, room, end = [], limit, time.monotonic() + LONGEST
    with contextlib.closing(answer):
        for block in answer.iter_raw():
            found.append(block)
            room -= len(block)
            if room < 0:
                break
            if time.monotonic() > end:
                raise Unfit(f"it takes longer than {units.duration(LONGEST)}")
    return found
