"""Reads what an apt repository says of itself: its Release file, directly or from a mirror."""

from __future__ import annotations

import re

import httpx

from rosml.base import web
from rosml.base.errors import RosmlError

SECONDS = 20.0
MIRROR = re.compile(r"https?://[A-Za-z0-9._~:@/-]+")
"""As components/build/network.sh and components/ros/apt.sh take it."""


def address(official: str, mirror: str, variable: str) -> str:
    """Where a repository is asked: below a mirror, each host is a folder.

    Args:
        official: its address. mirror: of the mirror; none if empty. variable: what names it.

    Raises:
        RosmlError: the mirror is no address (exit code 2).
    """
    if not mirror:
        return official
    if not MIRROR.fullmatch(mirror):
        raise RosmlError(f"{variable} is not an address", "set it to one such as http://host:3142", exit_code=2)
    return f"{mirror.rstrip('/')}/{re.sub('^https?://', '', official)}"


def read(url: str, limit: int, variable: str) -> str:
    """The text of a Release file, or its beginning; as `fetched`."""
    return fetched(url, limit, variable).decode(errors="replace")


def fetched(url: str, limit: int, variable: str) -> bytes:
    """A file of a repository. A user and password in its address are sent, and never told.

    Args:
        url: where it is. limit: bytes of it that are read. variable: what names a mirror.

    Raises:
        RosmlError: it does not answer.
    """
    try:
        with web.client(timeout=SECONDS) as client:
            answer = web.asked(client, url)
            content = web.excerpt(answer, limit)
    except (httpx.HTTPError, httpx.InvalidURL, ValueError) as error:
        reason = str(error) or type(error).__name__
    else:
        if answer.is_success:
            return content
        reason = f"HTTP Error {answer.status_code}"
    raise RosmlError(f"{shown(url)} does not answer ({reason})", f"check the network, HTTP_PROXY and {variable}")


def shown(url: str) -> str:
    """An address without the users and passwords in it: below a mirror, another address is a part of the path."""
    return re.sub("/[^/]*@", "/", url)
