"""Of when Debian's packages are: by its lists of packages, and not by the date that it writes several times a day."""

from __future__ import annotations

import http.server
import threading
from collections.abc import Iterator

import pytest
from conftest import WHEELS, changed, parse

from rosml import sync, upstream
from rosml.errors import RosmlError
from rosml.model import Matrix

RELEASE = """\
Origin: Debian
Date: {date}
SHA256:
 {amd64} 12345678 main/binary-amd64/Packages
 {arm64} 12345677 main/binary-arm64/Packages
 {other} 3456 main/binary-amd64/Packages.xz
 {other} 12345676 main/binary-armhf/Packages
 {other} 3456 contrib/binary-amd64/Packages
"""
FACTS = {"date": "Sat, 21 Nov 2026 10:00:00 UTC", "amd64": "a" * 64, "arm64": "b" * 64, "other": "c" * 64}
PATHS = [
    "/debian/dists/bookworm/Release",
    "/debian/dists/bookworm-updates/Release",
    "/debian-security/dists/bookworm-security/Release",
]


class Mirror(http.server.ThreadingHTTPServer):
    """Debian's archive, of which there are the Release files: by path, what they say."""

    files: dict[str, bytes]
    asked: list[str]

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.server_port}"


class Handler(http.server.BaseHTTPRequestHandler):
    server: Mirror

    def do_GET(self) -> None:
        self.server.asked.append(self.path)
        body = self.server.files.get(self.path)
        self.send_response(200 if body is not None else 404)
        self.end_headers()
        self.wfile.write(body or b"")

    def log_message(self, format: str, *args: object) -> None:
        pass


@pytest.fixture
def mirror(monkeypatch: pytest.MonkeyPatch) -> Iterator[Mirror]:
    for name in ("no_proxy", "NO_PROXY"):
        monkeypatch.setenv(name, "127.0.0.1")
    with Mirror(("127.0.0.1", 0), Handler) as server:
        server.files, server.asked = {path: RELEASE.format(**FACTS).encode() for path in PATHS}, []
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        yield server
        server.shutdown()


def at(address: str, image: str = "docker.io/library/ubuntu:26.04") -> Matrix:
    """A matrix with a live row, one from wheels, and omega, whose ROS is the system's own: of an archive at that address."""
    text = WHEELS.replace("http://debian.test", address).replace("docker.io/library/ubuntu:26.04", image)
    text = changed("    codename: resolute\n", "    archive: debian\n    suite: bookworm\n", text)
    return parse(changed("    apt: {channel: snapshot, date: 2026-11-01}\n", "", text)).matrix


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("what", ["amd64", "arm64"])
def test_another_list_of_packages_is_another_state(mirror: Mirror, path: str, what: str) -> None:
    """Of the release, its updates and its security, for either architecture."""
    before = upstream.state(at(mirror.address), "omega", {})
    assert before.startswith("debian bookworm ") and sorted(mirror.asked) == sorted(PATHS)
    assert upstream.state(at(mirror.address), "omega", {}) == before
    mirror.files[path] = RELEASE.format(**FACTS | {what: "d" * 64}).encode()
    assert upstream.state(at(mirror.address), "omega", {}) != before


def test_another_date_alone_is_none(mirror: Mirror) -> None:
    """Nor are the lists of packages that no image is installed from."""
    before = upstream.state(at(mirror.address), "omega", {})
    mirror.files = {
        path: RELEASE.format(**FACTS | {"date": "Sun, 22 Nov 2026 16:00:00 UTC", "other": "e" * 64}).encode()
        for path in PATHS
    }
    assert upstream.state(at(mirror.address), "omega", {}) == before


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize(
    ("body", "words"),
    [
        (None, r"does not answer \(HTTP Error 404"),
        (b"Origin: Debian\n", "names no lists of packages"),
        (b"\xff", "names"),
    ],
)
def test_what_is_not_there_is_an_error(mirror: Mirror, path: str, body: bytes | None, words: str) -> None:
    """And no state, as which it would have everything built anew."""
    mirror.files.pop(path)
    if body is not None:
        mirror.files[path] = body
    with pytest.raises(RosmlError, match=words) as caught:
        upstream.state(at(mirror.address), "omega", {})
    assert path in caught.value.message and caught.value.remedy


def test_a_mirror_is_asked_in_the_place_of_the_archive(mirror: Mirror) -> None:
    before = upstream.state(at(mirror.address), "omega", {})
    mirror.files = {f"/debian.test{path}": body for path, body in mirror.files.items()}
    assert upstream.state(at("http://debian.test"), "omega", {"OS_APT_MIRROR": f"{mirror.address}/"}) == before


def test_nobody_who_answers() -> None:
    with pytest.raises(RosmlError, match="does not answer"):
        upstream.state(at("http://127.0.0.1:1"), "omega", {})


def test_a_copy_of_the_base_image_is_watched_too(mirror: Mirror) -> None:
    """The archive is the system's, wherever its base image is."""
    copied = at(mirror.address, image="registry.test/mirror/system:1")
    assert upstream.state(copied, "omega", {}) == upstream.state(at(mirror.address), "omega", {})


def test_what_packages_come_from() -> None:
    """As the provenance of an image names it."""
    assert upstream.repository(at("http://debian.test"), "omega") == "http://debian.test"
    assert upstream.repository(at("http://debian.test"), "alpha") == "http://ros.test/ros2/ubuntu"


def test_where_no_repository_decides(mirror: Mirror) -> None:
    """Wheels are locked: nobody is asked."""
    assert upstream.state(at(mirror.address), "sigma", {}) == ""
    assert mirror.asked == []


def test_ros_repositories_say_their_date(monkeypatch: pytest.MonkeyPatch, mirror: Mirror) -> None:
    monkeypatch.setattr(sync, "published", lambda source, _: f"the date of {source.address}")
    assert upstream.state(at(mirror.address), "alpha", {}) == "the date of http://ros.test/ros2/ubuntu"
    assert mirror.asked == []
