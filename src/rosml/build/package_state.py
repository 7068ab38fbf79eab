"""Fingerprints of the apt repositories that ROS images are built from. A change triggers a rebuild.

Every image has packages of its operating system, whatever its ROS comes from: the archive that matrix.yaml names for it is
asked for its lists of packages, and ROS's own repository for its date, as `sync` does.
What is pinned (base images, wheels) is an input like any other, and not asked for.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterator, Mapping

from rosml.base.errors import RosmlError
from rosml.build import release_file, sync
from rosml.images import apt_source
from rosml.matrix.model import Matrix

MIRROR = "OS_APT_MIRROR"
RELEASE_BYTES = 1 << 22
"""More than any Release file has; Debian's have some hundred kB."""

INDEXES = re.compile(r"^ ([0-9a-f]{64}) +\d+ ((?:main|universe)/binary-(?:all|amd64|arm64)/Packages)$", re.MULTILINE)
"""The digests of the lists of packages in a Release file. Its date changes several times a day, with nothing else. ROS's
packages need Ubuntu's universe; Debian has none."""


SEPARATOR = ", "
_OF_AN_ARCHIVE = re.compile(r"\S+ \S+ [0-9a-f]{16}")


def state(matrix: Matrix, distribution: str, environ: Mapping[str, str] = os.environ) -> str:
    """Of when a distribution's packages are: the date of ROS's repository, a digest of the lists of packages in its
    operating system's archive, or both; empty where matrix.yaml names neither.

    Raises:
        RosmlError: a repository does not answer, or with something else.
    """
    source = apt_source.source(matrix, distribution, environ)
    found = [sync.published(source, environ) if source else "", _archive(matrix, distribution, environ)]
    return SEPARATOR.join(filter(None, found))


def ros_date(state: str) -> str:
    """The date of ROS's repository in a state; empty where ROS is not from there."""
    first = state.partition(SEPARATOR)[0]
    return "" if _OF_AN_ARCHIVE.fullmatch(first) else first


def _archive(matrix: Matrix, distribution: str, environ: Mapping[str, str]) -> str:
    os = matrix.distributions[distribution].os
    system = matrix.operating_systems[os]
    found = [packages(url) for url in releases(matrix, os, environ)]
    digest = hashlib.sha256(" ".join(found).encode()).hexdigest()[:16]
    return f"{system.archive} {system.suite} {digest}" if found else ""


def releases(matrix: Matrix, os: str, environ: Mapping[str, str]) -> Iterator[str]:
    """The addresses of the Release files that an operating system's packages are listed in; none where it names no archive.

    Raises:
        RosmlError: the mirror is no address (exit code 2).
    """
    system = matrix.operating_systems[os]
    for host, folders in matrix.archives[system.archive].items() if system.archive else ():
        address = release_file.address(host, environ.get(MIRROR, ""), MIRROR)
        yield from (f"{address}/{folder.format(suite=system.suite)}/Release" for folder in folders)


def repositories(matrix: Matrix, distribution: str, state: str) -> list[tuple[str, str]]:
    """The addresses of the repositories that a state is of, with the state of each."""
    source, ros = apt_source.source(matrix, distribution), ros_date(state)
    found = [(source.address, ros)] if source and ros else []
    name = matrix.operating_systems[matrix.distributions[distribution].os].archive
    archive = state.removeprefix(ros).removeprefix(SEPARATOR)
    return [*found, (next(iter(matrix.archives[name])), archive)] if name and archive else found


def packages(url: str) -> str:
    """What a Release file says of the lists of packages.

    Raises:
        RosmlError: it does not answer, or with something else.
    """
    text = release_file.read(url, RELEASE_BYTES, MIRROR)
    if not (found := INDEXES.findall(text)):
        raise RosmlError(f"{release_file.shown(url)} names no lists of packages", "check the mirror")
    return " ".join(digest for digest, _ in sorted(found, key=lambda item: item[1]))
