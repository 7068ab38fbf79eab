"""What goes wrong with a request to a registry: what may be gone a moment later, and what stays."""

from __future__ import annotations

import contextlib
import random
import re
from collections.abc import Iterator

import httpx

from rosml.base import web
from rosml.base.errors import RosmlError

ATTEMPTS = 7
"""How often a request is sent before it counts as failed: over about half a minute."""

ATTEMPTS_UNREACHED = 3
"""The same, while the registry never answered: a name that is wrong is told soon."""

ATTEMPTS_REFUSED = 5
"""The same, while the registry refuses what it may take a moment later: over about eight seconds."""

WAIT, LONGEST_WAIT = 0.5, 30.0
"""Seconds before the second attempt, which double with every further one; and what a registry may ask for at most."""


class Busy(RosmlError):
    """The registry answered each time that it cannot answer now."""


class Transient(Exception):
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


class Refused(Transient):
    """What the registry may take a moment later, as when another machine makes the repository, or when a part of the registry
    has not heard yet of a blob that another part has.

    Attributes:
        error: what is wrong, if it stays.
    """

    def __init__(self, error: RosmlError) -> None:
        super().__init__(error.message)
        self.error = error


class Denied(Refused):
    """What is denied to an account that the registry knows. There may be no such repository yet."""


class Untrusted(Transient):
    """A registry whose certificate is not trusted, or none: sending it again does not help."""


def pause(error: Transient, attempt: int, reached: bool = True) -> float | None:
    """Seconds to wait before a request is sent again; None if it was sent often enough.

    Args:
        attempt: how often it was sent. reached: whether the registry answered at any time.
    """
    most = ATTEMPTS_REFUSED if isinstance(error, Refused) else ATTEMPTS if reached else ATTEMPTS_UNREACHED
    if attempt >= most:
        return None
    backoff: float = WAIT * 2 ** (attempt - 1) + random.uniform(0, WAIT)
    return min(max(backoff, error.after), LONGEST_WAIT)


@contextlib.contextmanager
def transport(method: str, address: httpx.URL) -> Iterator[None]:
    """Turns what goes wrong on the way into something that may be gone a moment later, or into an error.

    Raises:
        Transient: the first. RosmlError: the second, such as an answer that is too large.
    """
    try:
        yield
    except httpx.TransportError as error:
        text = str(error)
        if "CERTIFICATE_VERIFY_FAILED" in text:
            reason = re.sub(r"^.*certificate verify failed: | \(_ssl.*$", "", text)
            raise Untrusted(f"its certificate is not trusted: {reason}") from None
        connected = not isinstance(error, httpx.ConnectError | httpx.ConnectTimeout)
        raise Transient(f"{method} {address.path}: {error or type(error).__name__}", connected=connected) from None
    except (ValueError, httpx.InvalidURL, httpx.TooManyRedirects) as error:
        what = "redirects without end" if isinstance(error, httpx.TooManyRedirects) else type(error).__name__
        raise unfit(method, address, str(error) if isinstance(error, web.Unfit) else what) from None


def unfit(method: str, address: httpx.URL, why: str) -> RosmlError:
    """The error about an answer that no registry gives."""
    remedy = "check the address, and the set-up of the registry and its proxy (HTTPS_PROXY)"
    return RosmlError(f"{method} {named(address)}: {why}", remedy)


def named(address: httpx.URL) -> str:
    """An address for messages: without a user, and without what is asked for."""
    return f"{address.host}{f':{address.port}' if address.port else ''}{address.path}"
