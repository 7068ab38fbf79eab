"""URLs of git repositories: checks whether they are allowed, and removes secrets."""

from __future__ import annotations

import re

PROTOCOLS = ("https", "http", "ssh", "git", "file")
"""The protocols that git may use. Others, such as `ext::`, start programs."""

_SCP = re.compile(r"(?:(?P<user>[^@:/]+)@)?(?P<host>\[[^]/]+\]|[^@:/\[]+):(?P<path>.+)")


class Refused(ValueError):
    """The error about a URL that is not allowed. Its text has no part of the URL that may be secret."""

    def __init__(self, text: str, remedy: str) -> None:
        super().__init__(text)
        self.remedy = remedy


_WHOLE = "write a URL that begins with https:// or ssh://, or user@host:path"
_NO_PASSWORD = "take it out of the file, and set GIT_HTTPS_USER and GIT_HTTPS_PASSWORD"


def checked(url: str, local: bool) -> str:
    """A URL without its user, except the user of ssh. Refuses passwords, other protocols, and what git could read in another way."""
    if not url or url.startswith("-") or not url.isprintable() or "\\" in url:
        raise Refused("the url is not valid", _WHOLE)
    scheme, separator, rest = url.partition("://")
    if not separator:
        return _without_scheme(url, local)
    if scheme not in PROTOCOLS:
        raise Refused(f"the url begins with {scheme}://, which is not allowed", f"use one of {', '.join(PROTOCOLS)}")
    if scheme == "file":
        return _local(url, local)
    authority, slash, path = rest.partition("/")
    user, at, host = authority.rpartition("@")
    if ":" in user:
        raise Refused("the url holds a password", _NO_PASSWORD)
    if not host or host.startswith(("-", ":")) or user.startswith("-") or not path:
        raise Refused("the url has no host or no path", _WHOLE)
    return f"{scheme}://{user + at if scheme == 'ssh' else ''}{host}{slash}{path}"


def _without_scheme(url: str, local: bool) -> str:
    if re.match(r"[^/:]*::", url):
        raise Refused(f"the url begins with {url.partition('::')[0]}::, which starts a program", _WHOLE)
    if url.startswith("/"):
        return _local(url, local)
    scp = _SCP.fullmatch(url)
    if scp is None or scp["host"].startswith("-") or (scp["user"] or "").startswith("-"):
        raise Refused("the url is not valid", _WHOLE)
    return url


def _local(url: str, local: bool) -> str:
    if not local:
        remedy = "take it from a server; if you trust all .repos files of your folder, add --allow-file-urls"
        raise Refused("the url names a repository of this machine", remedy)
    return url


def is_local(url: str) -> bool:
    """Whether a checked URL names a repository of this machine."""
    return url.startswith(("/", "file://"))


def host(url: str) -> str:
    """The host of a checked URL, with its port; empty if it is local."""
    if "://" in url:
        return url.partition("://")[2].partition("/")[0].rpartition("@")[2]
    return "" if is_local(url) else url.partition(":")[0].rpartition("@")[2]


def key(url: str) -> str:
    """A key that is equal for two spellings of the same repository."""
    return url.rstrip("/").removesuffix(".git")


def below(url: str, relative: str) -> str:
    """The URL of a submodule, resolved as git does: it may be relative to that of the repository around it."""
    if not relative.startswith(("./", "../")):
        return relative
    base, separator = url.rstrip("/"), "/"
    steps = relative.split("/")
    count = next((number for number, step in enumerate(steps) if step not in (".", "..")), len(steps))
    count = min(count, len(steps) - 1)  # a path that ends in `..` keeps it
    for step in steps[:count]:
        if step == "..":
            separator = "/" if "/" in base else ":"
            base = base.rpartition(separator)[0]
    return f"{base}{separator}{'/'.join(steps[count:])}"
