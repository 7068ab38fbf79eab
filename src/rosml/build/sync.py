"""Where a distribution's packages come from, and of when that apt repository is."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping
from datetime import UTC
from email.utils import parsedate_to_datetime
from pathlib import Path

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.build import release_file
from rosml.images.apt_source import Source

MIRROR = "ROS_APT_MIRROR"
RELEASE_BYTES = 1 << 20
"""More than any InRelease file has; ROS's have some ten kB."""


def published(source: Source, environ: Mapping[str, str] = os.environ) -> str:
    """When a repository was published last, such as 2026-11-20T21:14:09Z.

    The signature is not looked at: the build, which does, fails where it finds another time.

    Raises:
        RosmlError: it does not answer, or says no date.
    """
    address = release_file.address(source.address, environ.get(MIRROR, ""), MIRROR)
    url = f"{address}/dists/{source.codename}/InRelease"
    return date_of(release_file.read(url, RELEASE_BYTES, MIRROR), url)


def date_of(text: str, url: str) -> str:
    """When a repository was published last, as its Release file says it.

    Raises:
        RosmlError: it says no date.
    """
    found = re.search(r"^Date: (.+)$", text, re.MULTILINE)
    try:
        moment = parsedate_to_datetime(found[1] if found else "").astimezone(UTC)
        return moment.strftime("%Y-%m-%dT%H:%M:%SZ")
    except (ArithmeticError, LookupError, TypeError, ValueError):
        raise RosmlError(f"{release_file.shown(url)} says no date", "check the mirror") from None


def remember(state: Path, source: Source, when: str) -> None:
    """Notes when a repository was published, for a time when it does not answer."""
    known = _known(state) | {f"{source.address} {source.codename}": when}
    files.write(state / "ros-sync.json", json.dumps(known, indent=2) + "\n")


def remembered(state: Path, source: Source) -> str:
    """What was noted; empty if nothing was."""
    return _known(state).get(f"{source.address} {source.codename}", "")


def _known(state: Path) -> dict[str, str]:
    try:
        found = untrusted.json_value((state / "ros-sync.json").read_bytes())
    except (OSError, ValueError):
        return {}
    return {str(key): str(value) for key, value in found.items()} if isinstance(found, dict) else {}
