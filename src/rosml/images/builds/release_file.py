"""Reads files of apt repositories, such as Release files, directly or from a mirror."""

from __future__ import annotations

import re
from collections.abc import Mapping

import httpx

from rosml.base import web
from rosml.base.errors import RosmlError

SECONDS = 20.0
MIRROR = re.compile(r"https?://[A-Za-z0-9._~:@/-]+")
"""The same pattern as in components/build/network.sh and components/ros/apt.sh."""


def address(official: str, environ: Mapping[str, str], variable: str) -> str:
    """The address of a repository, or of its copy on the mirror of a variable, which has a folder for each host."""
    if not (mirror := environ.get(variable, "")):
        return official
    if not MIRROR.fullmatch(mirror):
        raise RosmlError(f"{variable} is not an address", "set it to one such as http://host:3142", exit_code=2)
    return f"{mirror.rstrip('/')}/{re.sub('^https?://', '', official)}"


def read(url: str, limit: int, variable: str) -> str:
    return fetched(url, limit, variable).decode(errors="replace")


def fetched(url: str, limit: int, variable: str) -> bytes:
    """A file of a repository, of at most `limit` bytes. A password in its address is sent, but appears in no message."""
    try:
        with web.client(timeout=SECONDS) as client:
            answer = web.fetched(client, url)
            content = web.excerpt(answer, limit)
    except (httpx.HTTPError, httpx.InvalidURL, ValueError) as error:
        reason = str(error) or type(error).__name__
    else:
        if answer.is_success:
            return content
        reason = f"HTTP Error {answer.status_code}"
    raise RosmlError(f"{shown(url)} does not answer ({reason})", f"check the network, HTTP_PROXY and {variable}")


def shown(url: str) -> str:
    """An address without users and passwords. On a mirror, the path has another address, which may have them, too."""
    return re.sub("/[^/]*@", "/", url)
