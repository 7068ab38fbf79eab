"""Failures of requests to a registry: which ones may pass, and which ones stay."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterator

import httpx

from rosml.base import web
from rosml.base.errors import RosmlError


class Busy(RosmlError):
    pass


class Immutable(RosmlError):
    pass


class Transient(Exception):
    """A failure that may pass."""

    def __init__(
        self,
        message: str,
        after: float = 0.0,  # seconds that the registry asks to wait
        connected: bool = True,  # a server accepted the connection
        final: type[RosmlError] = RosmlError,  # the error if it does not pass
    ) -> None:
        super().__init__(message)
        self.after, self.connected, self.final = after, connected, final


class Refused(Transient):
    """The registry refused what it may accept later: another machine creates the repository, or a new blob is not yet known everywhere."""

    def __init__(self, error: RosmlError) -> None:
        super().__init__(error.message)
        self.error = error


class Denied(Refused):
    """The registry denies access to a known account. Perhaps the repository does not exist yet."""


class Limited(Transient):
    """The registry answered 429: an account, or an address without one, has asked too often."""

    def __init__(self, message: str, after: float, from_the_first: bool) -> None:
        super().__init__(message, after, final=Busy)
        self.from_the_first = from_the_first  # it answered nothing else until now, so the limit is no matter of seconds


class Untrusted(Transient):
    """Another attempt does not help."""


@contextlib.contextmanager
def http_errors(method: str, address: httpx.URL) -> Iterator[None]:
    """Turns httpx's errors into Transient, or into RosmlError if they do not pass."""
    try:
        yield
    except httpx.TransportError as error:
        text = str(error)
        if "CERTIFICATE_VERIFY_FAILED" in text:
            reason = re.sub(r"^.*certificate verify failed: | \(_ssl.*$", "", text)
            raise Untrusted(f"its certificate is not trusted: {reason}") from None
        connected = not isinstance(error, httpx.ConnectError | httpx.ConnectTimeout)
        raise Transient(f"{method} {address.path}: {error or type(error).__name__}", connected=connected) from None
    except (ValueError, httpx.InvalidURL) as error:
        raise unfit(method, address, str(error) if isinstance(error, web.Unfit) else type(error).__name__) from None


def unfit(method: str, address: httpx.URL, why: str) -> RosmlError:
    """The error if an answer does not come from a registry."""
    remedy = "check the address, and the configuration of the registry and its proxy (HTTPS_PROXY)"
    return RosmlError(f"{method} {without_query(address)}: {why}", remedy)


def without_query(address: httpx.URL) -> str:
    """An address for messages, without user and query."""
    return f"{address.host}{f':{address.port}' if address.port else ''}{address.path}"
