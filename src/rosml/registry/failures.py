"""Failures of requests to a registry: which ones may pass, and which ones stay."""

from __future__ import annotations

import contextlib
import random
import re
from collections.abc import Iterator

import httpx

from rosml.base import web
from rosml.base.errors import RosmlError

ATTEMPTS = 7
"""How often a request is sent, in about half a minute."""

ATTEMPTS_UNREACHED = 3
"""The same, if the registry never answered, so that a wrong name fails soon."""

ATTEMPTS_REFUSED = 5
"""The same, if the registry refuses a request that it may accept later, in about eight seconds."""

ATTEMPTS_LIMITED = 2
"""The same, if the registry's first answer is that there were too many requests."""

WAIT, LONGEST_WAIT = 0.5, 30.0
"""Seconds before the second attempt, which double with each further one; and the most that a registry may ask for."""

TOO_LONG = 120.0
"""If a registry asks for a longer wait because of too many requests, nobody waits."""


class Busy(RosmlError):
    pass


class Immutable(RosmlError):
    pass


class Transient(Exception):
    """A failure that may pass.

    Attributes:
        after: seconds that the registry asks to wait.
        connected: a server accepted the connection.
        final: the kind of error if it does not pass.
    """

    def __init__(
        self, message: str, after: float = 0.0, connected: bool = True, final: type[RosmlError] = RosmlError
    ) -> None:
        super().__init__(message)
        self.after = after
        self.connected = connected
        self.final = final


class Refused(Transient):
    """The registry refused what it may accept later: another machine is creating the repository, or a part of the registry
    does not know a new blob yet. `error` is the error if it does not pass.
    """

    def __init__(self, error: RosmlError) -> None:
        super().__init__(error.message)
        self.error = error


class Denied(Refused):
    """The registry denies access to a known account. Perhaps the repository does not exist yet."""


class Limited(Transient):
    """The registry answered 429: an account, or an address without one, has asked too often.

    `from_the_first`: it answered nothing else until now, so the limit is no matter of seconds.
    """

    def __init__(self, message: str, after: float, from_the_first: bool) -> None:
        super().__init__(message, after, final=Busy)
        self.from_the_first = from_the_first


class Untrusted(Transient):
    """Another attempt does not help."""


def pause(error: Transient, attempt: int, reached: bool = True) -> float | None:
    """Seconds to wait before a request is sent again; None if it was sent often enough. `reached`: the registry ever answered."""
    most = ATTEMPTS_REFUSED if isinstance(error, Refused) else ATTEMPTS if reached else ATTEMPTS_UNREACHED
    if isinstance(error, Limited) and error.from_the_first:
        most = ATTEMPTS_LIMITED
    if attempt >= most or (isinstance(error, Limited) and error.after > TOO_LONG):
        return None
    backoff: float = WAIT * 2 ** (attempt - 1) + random.uniform(0, WAIT)
    return min(max(backoff, error.after), LONGEST_WAIT)


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
