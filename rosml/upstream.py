"""Of when the repositories are that ROS images are built from: when they move, images are built anew.

ROS's own repositories are asked as `sync` does; the rows whose ROS comes from the operating system depend on Debian's.
What is pinned (base images, wheels) is an input like any other, and not asked for.
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Mapping

from rosml import base_images, release_file, sync
from rosml.errors import RosmlError
from rosml.model import Matrix

SUITES = ("debian/dists/{suite}", "debian/dists/{suite}-updates", "debian-security/dists/{suite}-security")
"""What Debian's images install from: the release, its updates, its security."""

DEBIAN = "http://deb.debian.org"
MIRROR = "OS_APT_MIRROR"
RELEASE_BYTES = 1 << 22
"""More than any Release file has; Debian's have some hundred kB."""

INDEXES = re.compile(r"^ ([0-9a-f]{64}) +\d+ (main/binary-(?:all|amd64|arm64)/Packages)$", re.MULTILINE)
"""The digests of the lists of packages in a Release file. Its date changes several times a day, with nothing else."""


def state(matrix: Matrix, distribution: str, environ: Mapping[str, str] = os.environ) -> str:
    """Of when a distribution's packages are: a date, or a digest of Debian's lists of packages; empty where no
    repository decides (wheels are locked).

    Raises:
        RosmlError: a repository does not answer, or with something else.
    """
    facts = matrix.distributions[distribution]
    if facts.wheels:
        return ""
    if source := sync.source(matrix, distribution, environ):
        return sync.published(source, environ)
    suite = base_images.debian_suite(matrix.operating_systems[facts.os].image)
    if not suite:
        return ""
    archive = release_file.address(DEBIAN, environ.get(MIRROR, ""), MIRROR)
    found = [packages(f"{archive}/{path.format(suite=suite)}/Release") for path in SUITES]
    return f"debian {suite} {hashlib.sha256(' '.join(found).encode()).hexdigest()[:16]}"


def packages(url: str) -> str:
    """What a Release file says of the lists of packages.

    Raises:
        RosmlError: it does not answer, or with something else.
    """
    text = release_file.read(url, RELEASE_BYTES, MIRROR)
    if not (found := INDEXES.findall(text)):
        raise RosmlError(f"{release_file.shown(url)} names no lists of packages", "check the mirror")
    return " ".join(digest for digest, _ in sorted(found, key=lambda item: item[1]))
