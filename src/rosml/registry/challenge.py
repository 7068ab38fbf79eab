"""Reads the header `WWW-Authenticate`: which credentials a registry asks for if it answers 401."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

LARGEST = 8 << 10
"""Longer headers, in characters, are ignored. Real ones have some hundred."""

_SCHEME = re.compile(r"[ \t,]*([A-Za-z0-9-]{1,32})(?:[ \t]+|$)")
_PARAMETER = re.compile(r'[ \t,]*([A-Za-z0-9_-]{1,32})[ \t]*=[ \t]*(?:"((?:[^"\\]|\\.)*)"|([^\s,"]+))')


@dataclass(frozen=True)
class Challenge:
    """The credentials that a registry asks for: a name and password, or a `bearer` token from the server at `realm`."""

    bearer: bool
    realm: str = ""
    service: str = ""
    scopes: frozenset[str] = frozenset()


def read(headers: Iterable[str]) -> Challenge | None:
    """The first challenge of a known scheme in an answer's headers; None if there is none. Reads each character once."""
    for text in headers:
        match = _SCHEME.match(text)
        if match is None or len(text) > LARGEST:
            continue
        scheme, fields = match[1].lower(), dict[str, str]()
        while match := _PARAMETER.match(text, match.end()):
            fields[match[1].lower()] = re.sub(r"\\(.)", r"\1", match[2]) if match[3] is None else match[3]
        if scheme == "bearer" and fields.get("realm"):
            scopes = frozenset(fields.get("scope", "").split())
            return Challenge(True, fields["realm"], fields.get("service", ""), scopes)
        if scheme == "basic":
            return Challenge(False)
    return None
