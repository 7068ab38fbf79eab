"""ROS's apt repository: its sync date, when it was last published, and the packages that it lacks."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from datetime import UTC
from email.utils import parsedate_to_datetime
from pathlib import Path

from pydantic import ValidationError

from rosml.base import archives, files
from rosml.base.errors import RosmlError
from rosml.base.shapes import adapter
from rosml.images.builds import release_file
from rosml.images.image_set.apt_repository import AptRepository

MIRROR = "ROS_APT_MIRROR"
RELEASE_BYTES = 1 << 20
"""More than any InRelease file has. ROS's files have some ten kB."""

LIST_BYTES, LIST_UNPACKED = 64 << 20, 128 << 20
"""More than any list of packages has, packed and unpacked. ROS's lists have some MB, Debian's own has 50 MB."""

NAMES, LINE = 200_000, 1 << 20
"""The most packages of a list, and the most bytes of a line. Debian's own list has 70,000 packages."""

_NAME = re.compile(rb"^Package: (\S{1,200})$", re.MULTILINE)


def published(source: AptRepository, environ: Mapping[str, str] = os.environ) -> str:
    """When a repository was last published, such as 2026-11-20T21:14:09Z. The build verifies the signature."""
    url = f"{_suite(source, environ)}/InRelease"
    return date_of(release_file.read(url, RELEASE_BYTES, MIRROR), url)


def _suite(source: AptRepository, environ: Mapping[str, str]) -> str:
    """The address of a repository's Release file and lists."""
    return f"{release_file.address(source.address, environ, MIRROR)}/dists/{source.codename}"


def date_of(text: str, url: str) -> str:
    """When a repository was last published, from the text of its Release file."""
    date_line = re.search(r"^Date: (.+)$", text, re.MULTILINE)
    try:
        date = parsedate_to_datetime(date_line[1] if date_line else "").astimezone(UTC)
        return date.strftime("%Y-%m-%dT%H:%M:%SZ")
    except (ArithmeticError, LookupError, TypeError, ValueError):
        raise RosmlError(f"{release_file.shown(url)} has no date", "check the mirror") from None


def lacking(state: Path, source: AptRepository, architecture: str, packages: Iterable[str]) -> list[str]:
    """The packages that a repository lacks, by its list in gzip; none if it has no such list. A build would fail an hour later."""
    suite = _suite(source, os.environ)
    release = release_file.read(f"{suite}/InRelease", RELEASE_BYTES, MIRROR)
    present: set[str] = set()
    for component in source.components:
        path = f"{component}/binary-{architecture}/Packages.gz"
        entry = re.search(rf"^ ([0-9a-f]{{64}}) +\d+ {re.escape(path)}$", release, re.MULTILINE)
        if entry is None:
            return []
        present |= _names(state / "apt-names" / entry[1], f"{suite}/{path}", entry[1])
    return [name for name in packages if name not in present]


def _names(cache_file: Path, url: str, digest: str) -> set[str]:
    with contextlib.suppress(OSError, UnicodeDecodeError):
        return set(cache_file.read_text(encoding="utf-8").split("\n"))
    packed = release_file.fetched(url, LIST_BYTES, MIRROR)
    if hashlib.sha256(packed).hexdigest() != digest:
        remedy = "run it again: the repository may be in the middle of an update"
        raise RosmlError(f"{release_file.shown(url)} does not match its Release file", remedy)
    try:
        names = set(_package_names(archives.unpacked([packed])))
    except ValueError:
        text = f"{release_file.shown(url)} cannot be unpacked, or is too large"
        raise RosmlError(text, "check the mirror") from None
    cache_file.parent.mkdir(parents=True, exist_ok=True)
    files.write(cache_file, "\n".join(sorted(names)))
    return names


def _package_names(pieces: Iterable[bytes]) -> Iterator[str]:
    size = count = 0
    rest = b""
    for piece in pieces:
        size += len(piece)
        text, _, rest = (rest + piece).rpartition(b"\n")
        packages = _NAME.findall(text)
        count += len(packages)
        if size > LIST_UNPACKED or len(rest) > LINE or count > NAMES:
            raise ValueError("it is too large")
        yield from (name.decode(errors="replace") for name in packages)
    yield from (name.decode(errors="replace") for name in _NAME.findall(rest))


def remember(state: Path, source: AptRepository, when: str) -> None:
    """Saves when a repository was published, in case it does not answer later."""
    dates = _saved_dates(state) | {f"{source.address} {source.codename}": when}
    files.write(state / "ros-sync.json", json.dumps(dates, indent=2) + "\n")


def remembered(state: Path, source: AptRepository) -> str:
    """The saved date of a repository; empty if there is none."""
    return _saved_dates(state).get(f"{source.address} {source.codename}", "")


def _saved_dates(state: Path) -> dict[str, str]:
    try:
        return _DATES.validate_json((state / "ros-sync.json").read_bytes())
    except (OSError, ValidationError):
        return {}


_DATES = adapter(dict[str, str])
