"""An archive of packages, of which there are only the Release files."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from fakes.apt_mirror import AptMirror, serving

RELEASE = """\
Origin: Debian
Date: {date}
SHA256:
 {amd64} 12345678 main/binary-amd64/Packages
 {arm64} 12345677 main/binary-arm64/Packages
 {universe} 12345675 universe/binary-amd64/Packages
 {other} 3456 main/binary-amd64/Packages.xz
 {other} 12345676 main/binary-armhf/Packages
 {other} 3456 contrib/binary-amd64/Packages
"""
FACTS = {"date": "Sat, 21 Nov 2026 10:00:00 UTC"} | {
    name: letter * 64 for name, letter in (("amd64", "a"), ("arm64", "b"), ("other", "c"), ("universe", "f"))
}
DATE = "2026-11-20T21:14:09Z"
SYNC = "/ros2/ubuntu/dists/noble/InRelease"
PATHS = {
    suite: [
        f"/debian/dists/{suite}/Release",
        f"/debian/dists/{suite}-updates/Release",
        f"/debian-security/dists/{suite}-security/Release",
    ]
    for suite in ("bookworm", "noble")
}


@contextmanager
def release_server(monkeypatch: pytest.MonkeyPatch) -> Iterator[AptMirror]:
    """A mirror that has only the Release files."""
    for name in ("no_proxy", "NO_PROXY"):
        monkeypatch.setenv(name, "127.0.0.1")
    with serving() as server:
        lists = RELEASE.format(**FACTS).encode()
        server.files = {path: lists for paths in PATHS.values() for path in paths}
        server.files[SYNC] = b"Suite: noble\nDate: Fri, 20 Nov 2026 21:14:09 UTC\n"
        yield server
