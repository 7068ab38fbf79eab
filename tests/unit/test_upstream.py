"""Of when Debian's packages are: by its lists of packages, and not by the date that it writes several times a day."""

from __future__ import annotations

import http.server
import threading
from collections.abc import Iterator

import pytest

from rosml import sync, upstream
from rosml.errors import RosmlError
from rosml.expand import Catalogue
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


def at(address: str, matrix: Matrix) -> Matrix:
    """Our matrix with Debian's archive at another address."""
    ((_, folders),) = matrix.archives["debian"].items()
    return matrix.model_copy(update={"archives": {"debian": {address: folders}}})


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("what", ["amd64", "arm64"])
def test_another_list_of_packages_is_another_state(mirror: Mirror, real: Catalogue, path: str, what: str) -> None:
    """Of the release, its updates and its security, for either architecture."""
    before = upstream.state(at(mirror.address, real.matrix), "bookworm", {})
    assert before.startswith("debian bookworm ") and sorted(mirror.asked) == sorted(PATHS)
    assert upstream.state(at(mirror.address, real.matrix), "bookworm", {}) == before
    mirror.files[path] = RELEASE.format(**FACTS | {what: "d" * 64}).encode()
    assert upstream.state(at(mirror.address, real.matrix), "bookworm", {}) != before


def test_another_date_alone_is_none(mirror: Mirror, real: Catalogue) -> None:
    """Nor are the lists of packages that no image is installed from."""
    before = upstream.state(at(mirror.address, real.matrix), "bookworm", {})
    mirror.files = {
        path: RELEASE.format(**FACTS | {"date": "Sun, 22 Nov 2026 16:00:00 UTC", "other": "e" * 64}).encode()
        for path in PATHS
    }
    assert upstream.state(at(mirror.address, real.matrix), "bookworm", {}) == before


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize(
    ("body", "words"),
    [
        (None, r"does not answer \(HTTP Error 404"),
        (b"Origin: Debian\n", "names no lists of packages"),
        (b"\xff", "names"),
    ],
)
def test_what_is_not_there_is_an_error(
    mirror: Mirror, real: Catalogue, path: str, body: bytes | None, words: str
) -> None:
    """And no state, as which it would have everything built anew."""
    mirror.files.pop(path)
    if body is not None:
        mirror.files[path] = body
    with pytest.raises(RosmlError, match=words) as caught:
        upstream.state(at(mirror.address, real.matrix), "bookworm", {})
    assert path in caught.value.message and caught.value.remedy


def test_a_mirror_is_asked_in_the_place_of_the_archive(mirror: Mirror, real: Catalogue) -> None:
    before = upstream.state(at(mirror.address, real.matrix), "bookworm", {})
    (host,) = real.matrix.archives["debian"]
    mirror.files = {f"/{host.removeprefix('http://')}{path}": body for path, body in mirror.files.items()}
    assert upstream.state(real.matrix, "bookworm", {"OS_APT_MIRROR": f"{mirror.address}/"}) == before


def test_nobody_who_answers(real: Catalogue) -> None:
    with pytest.raises(RosmlError, match="does not answer"):
        upstream.state(at("http://127.0.0.1:1", real.matrix), "trixie", {})


def test_a_copy_of_the_base_image_is_watched_too(mirror: Mirror, real: Catalogue) -> None:
    """The archive is the system's, wherever its base image is."""
    matrix = at(mirror.address, real.matrix)
    here = upstream.state(matrix, "bookworm", {})
    copied = matrix.operating_systems["bookworm"].model_copy(update={"image": "registry.test/mirror/debian:bookworm"})
    systems = {**matrix.operating_systems, "bookworm": copied}
    assert upstream.state(matrix.model_copy(update={"operating_systems": systems}), "bookworm", {}) == here


def test_what_packages_come_from(real: Catalogue) -> None:
    """As the provenance of an image names it."""
    assert [upstream.repository(real.matrix, "bookworm")] == list(real.matrix.archives["debian"])
    assert real.matrix.ros_archive
    assert upstream.repository(real.matrix, "jazzy") == real.matrix.ros_archive.live.format(generation="ros2")


def test_where_no_repository_decides(real: Catalogue, mirror: Mirror) -> None:
    """Wheels are locked: nobody is asked."""
    assert upstream.state(real.matrix, "jazzy-wheels", {}) == ""
    assert mirror.asked == []


def test_ros_repositories_say_their_date(real: Catalogue, monkeypatch: pytest.MonkeyPatch, mirror: Mirror) -> None:
    monkeypatch.setattr(sync, "published", lambda source, _: f"the date of {source.address}")
    assert real.matrix.ros_archive
    live = real.matrix.ros_archive.live.format(generation="ros2")
    assert upstream.state(real.matrix, "jazzy", {}) == f"the date of {live}"
    assert mirror.asked == []
