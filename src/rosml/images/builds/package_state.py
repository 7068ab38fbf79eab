"""Fingerprints of the apt repositories that ROS images are built from. A change triggers a rebuild.

Every image has packages of its operating system, so the apt sources of its base image are asked for their lists of
packages, as apt does in a build. If ROS comes from its own repository, that is asked for its date, by `sync`. Base
images and wheels are pinned, so they are ordinary inputs.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.images.builds import apt_sources, release_file, sync
from rosml.images.builds.apt_sources import Source
from rosml.images.image_set import apt_repository
from rosml.images.matrix.model import Matrix
from rosml.machine.services import Services

MIRROR = "OS_APT_MIRROR"
RELEASE_BYTES = 1 << 22
"""More than any Release file has. Debian's files have some hundred kB."""

ARCHITECTURES = ("all", "amd64", "arm64")

_LISTED = re.compile(r"^ ([0-9a-f]{64}) +\d+ (\S+)$", re.MULTILINE)
_ORIGIN = re.compile(r"^Origin: *(\S.*)$", re.MULTILINE)
_NOT_AUTOMATIC = re.compile(r"^NotAutomatic: *yes$", re.MULTILINE)
"""From a suite with this field, such as backports, apt installs nothing on its own."""

SEPARATOR = ", "
_OF_AN_ARCHIVE = re.compile(r"\S+ \S+ [0-9a-f]{16}")


@dataclass(frozen=True)
class Release:
    """A Release file without its date, which changes several times a day, without other changes."""

    origin: str  # whose packages these are, as one word, such as debian
    lists: str  # digests of the lists of packages


def state(services: Services, matrix: Matrix, distribution: str, environ: Mapping[str, str] = os.environ) -> str:
    """ROS's date, a digest of the system's lists of packages, or both; empty if there is neither. The same on all architectures."""
    source = apt_repository.of(matrix, distribution, environ)
    states = [sync.published(source, environ) if source else "", _archives(services, matrix, distribution, environ)]
    return SEPARATOR.join(filter(None, states))


def lacking(
    services: Services, matrix: Matrix, distribution: str, architecture: str, packages: Iterable[str]
) -> list[str]:
    """The packages that ROS's repository lacks; none if they come from the operating system."""
    source = apt_repository.of(matrix, distribution)
    return sync.lacking(services.state, source, architecture, packages) if source else []


def ros_date(state: str) -> str:
    """The date of ROS's repository in a state; empty if ROS comes from elsewhere."""
    first = state.partition(SEPARATOR)[0]
    return "" if _OF_AN_ARCHIVE.fullmatch(first) else first


def _archives(services: Services, matrix: Matrix, distribution: str, environ: Mapping[str, str]) -> str:
    sources = _sources(services, matrix, distribution)
    releases = [(source, item) for source in sources if (item := release(source, environ))]
    if not releases:
        return ""
    source, first = releases[0]
    digest = hashlib.sha256(" ".join(item.lists for _, item in releases).encode()).hexdigest()[:16]
    return f"{first.origin} {source.suite} {digest}"


def _sources(services: Services, matrix: Matrix, distribution: str) -> tuple[Source, ...]:
    return apt_sources.sources(services, matrix.operating_systems, matrix.distributions[distribution].os)


def repositories(services: Services, matrix: Matrix, distribution: str, state: str) -> list[tuple[str, str]]:
    """Addresses of repositories, each with its state. The system's archives share one. Without readable apt sources, they are left out."""
    source, ros = apt_repository.of(matrix, distribution), ros_date(state)
    states = {source.address: ros} if source and ros else {}
    if archives := state.removeprefix(ros).removeprefix(SEPARATOR):
        with contextlib.suppress(RosmlError):
            states |= {release_file.shown(s.address): archives for s in _sources(services, matrix, distribution)}
    return list(states.items())


def release(source: Source, environ: Mapping[str, str]) -> Release | None:
    """Reads the Release file of a source; None if apt installs nothing from there on its own."""
    url = source.release(release_file.address(source.address, environ, MIRROR))
    return described(source, release_file.read(url, RELEASE_BYTES, MIRROR), url)


def described(source: Source, text: str, url: str) -> Release | None:
    """Parses the text of a Release file; None if apt installs nothing from there on its own."""
    if _NOT_AUTOMATIC.search(text):
        return None
    paths = {f"{part}/binary-{name}/Packages" for part in source.components for name in ARCHITECTURES}
    paths |= {"Packages", "./Packages"} if source.flat else set()
    lists = sorted((path, digest) for digest, path in _LISTED.findall(text) if path in paths)
    if not lists:
        raise RosmlError(f"{release_file.shown(url)} names no lists of packages", "check the mirror")
    origin = _ORIGIN.search(text)
    return Release("-".join(origin[1].lower().split()) if origin else "apt", " ".join(digest for _, digest in lists))
