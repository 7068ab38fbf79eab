"""Of when the repositories are that ROS images are built from: when they move, images are built anew.

ROS's own repositories are asked as `sync` does; the rows whose ROS comes from the operating system depend on the archive
that matrix.yaml names for it.
What is pinned (base images, wheels) is an input like any other, and not asked for.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterator, Mapping

from rosml import release_file, sync
from rosml.errors import RosmlError
from rosml.model import Matrix

MIRROR = "OS_APT_MIRROR"
RELEASE_BYTES = 1 << 22
"""More than any Release file has; Debian's have some hundred kB."""

INDEXES = re.compile(r"^ ([0-9a-f]{64}) +\d+ (main/binary-(?:all|amd64|arm64)/Packages)$", re.MULTILINE)
"""The digests of the lists of packages in a Release file. Its date changes several times a day, with nothing else."""


def state(matrix: Matrix, distribution: str, environ: Mapping[str, str] = os.environ) -> str:
    """Of when a distribution's packages are: a date, or a digest of the lists of packages in its system's archive; empty
    where no repository decides (wheels are locked), and where matrix.yaml names no archive.

    Raises:
        RosmlError: a repository does not answer, or with something else.
    """
    facts = matrix.distributions[distribution]
    if facts.wheels:
        return ""
    if source := sync.source(matrix, distribution, environ):
        return sync.published(source, environ)
    system = matrix.operating_systems[facts.os]
    found = [packages(url) for url in releases(matrix, facts.os, environ)]
    if not found:
        return ""
    return f"{system.archive} {system.suite} {hashlib.sha256(' '.join(found).encode()).hexdigest()[:16]}"


def releases(matrix: Matrix, os: str, environ: Mapping[str, str]) -> Iterator[str]:
    """The addresses of the Release files that an operating system's packages are listed in; none where it names no archive.

    Raises:
        RosmlError: the mirror is no address (exit code 2).
    """
    system = matrix.operating_systems[os]
    for host, folders in matrix.archives[system.archive].items() if system.archive else ():
        address = release_file.address(host, environ.get(MIRROR, ""), MIRROR)
        yield from (f"{address}/{folder.format(suite=system.suite)}/Release" for folder in folders)


def repository(matrix: Matrix, distribution: str) -> str:
    """The address of the archive that a distribution's ROS packages come from; empty where nobody knows it."""
    if source := sync.source(matrix, distribution):
        return source.address
    archive = matrix.operating_systems[matrix.distributions[distribution].os].archive
    return next(iter(matrix.archives[archive])) if archive else ""


def packages(url: str) -> str:
    """What a Release file says of the lists of packages.

    Raises:
        RosmlError: it does not answer, or with something else.
    """
    text = release_file.read(url, RELEASE_BYTES, MIRROR)
    if not (found := INDEXES.findall(text)):
        raise RosmlError(f"{release_file.shown(url)} names no lists of packages", "check the mirror")
    return " ".join(digest for digest, _ in sorted(found, key=lambda item: item[1]))
