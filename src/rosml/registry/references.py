"""References of images: a registry, a repository, and a tag or digest."""

from __future__ import annotations

import re
from typing import NamedTuple

import httpx

from rosml.base.errors import RosmlError
from rosml.registry.credentials import DOCKER_HUB
from rosml.registry.documents import DIGEST, TAG

_HOST = r"(?:[A-Za-z0-9](?:[A-Za-z0-9.-]*[A-Za-z0-9])?|\[[0-9A-Fa-f:]+\])(?::[0-9]{1,5})?"
_PATH = r"[a-z0-9]+(?:(?:[._]|__|-+)[a-z0-9]+)*(?:/[a-z0-9]+(?:(?:[._]|__|-+)[a-z0-9]+)*)*"
_REFERENCE = re.compile(rf"({_HOST})/({_PATH})(?::({TAG}))?(?:@({DIGEST}))?")


LONGEST_TAG = 128
"""The most characters of a tag, as `TAG` has it."""


class Reference(NamedTuple):
    host: str
    repository: str
    reference: str

    def __str__(self) -> str:
        return f"{self.host}/{self.repository}{'@' if is_digest(self.reference) else ':'}{self.reference}"


def parse(reference: str) -> Reference:
    """Splits a reference such as ``ghcr.io/me/ros:jazzy-base``. If it has a tag and a digest, the digest counts."""
    match = _REFERENCE.fullmatch(reference)
    host = match[1] if match else ""
    if match is None or not is_place(host, match[2]) or not has_registry(reference):
        text = f"{reference!r} is no reference with a registry, a repository and a tag or digest"
        raise RosmlError(text, "write it in full, such as ghcr.io/me/ros:jazzy-base", exit_code=2)
    return Reference(match[1], match[2], match[4] or match[3] or "latest")


def has_registry(name: str) -> bool:
    """Whether the name of an image begins with a registry, by Docker's rule; otherwise it is a path on Docker Hub."""
    host, slash, _ = name.partition("/")
    return bool(slash) and (re.search(r"[.:]", host) is not None or host == "localhost")


def complete(name: str) -> str:
    """The name of an image with its registry, which is Docker Hub if the name has none."""
    if has_registry(name):
        return name
    return f"{DOCKER_HUB}/{name}" if "/" in name else f"{DOCKER_HUB}/library/{name}"


def is_place(host: str, path: str) -> bool:
    if not re.fullmatch(_HOST, host) or not re.fullmatch(_PATH, path):
        return False
    try:
        port = httpx.URL(f"https://{host}").port
        host.encode("idna")
    except (httpx.InvalidURL, UnicodeError):
        return False
    return port is None or 0 < port < 1 << 16


GONE = "check its digest; the registry may have removed it: take the image's tag, or the digest that it has now"


def is_digest(reference: str) -> bool:
    return re.fullmatch(DIGEST, reference) is not None
