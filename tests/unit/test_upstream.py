"""Of when packages are: by an archive's lists of packages, and not by the date that it writes several times a day; of ROS's
own repository by its date."""

from __future__ import annotations

import http.server
import itertools
import threading
from collections.abc import Iterator

import pytest
from conftest import WHEELS, changed, parse

from rosml.base.errors import RosmlError
from rosml.build import package_state
from rosml.images import apt_source
from rosml.images.image_set import ImageSet
from rosml.matrix.model import Matrix

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
ROWS = {"omega": "bookworm", "alpha": "noble", "sigma": "noble"}
"""Rows whose ROS is the system's own, from ROS's repository, and from wheels: the suite that their system is of."""
PATHS = {
    suite: [
        f"/debian/dists/{suite}/Release",
        f"/debian/dists/{suite}-updates/Release",
        f"/debian-security/dists/{suite}-security/Release",
    ]
    for suite in ("bookworm", "noble")
}
EVERY = [(row, path) for row, suite in ROWS.items() for path in PATHS[suite]]


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
        lists = RELEASE.format(**FACTS).encode()
        server.files, server.asked = {path: lists for paths in PATHS.values() for path in paths}, []
        server.files[SYNC] = b"Suite: noble\nDate: Fri, 20 Nov 2026 21:14:09 UTC\n"
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        yield server
        server.shutdown()


def at(address: str, image: str = "docker.io/library/ubuntu:26.04") -> Matrix:
    """A matrix with a live row, one from wheels, and omega, whose ROS is the system's own: of an archive at that address."""
    text = changed("    codename: noble\n", "    codename: noble\n    archive: debian\n    suite: noble\n", WHEELS)
    text = (
        text.replace("http://debian.test", address)
        .replace("http://ros.test", address)
        .replace("docker.io/library/ubuntu:26.04", image)
    )
    text = changed("    codename: resolute\n", "    archive: debian\n    suite: bookworm\n", text)
    return parse(changed("    apt: {channel: snapshot, date: 2026-11-01}\n", "", text)).matrix


@pytest.mark.parametrize("row", ROWS)
def test_another_list_of_packages_is_another_state(mirror: Mirror, row: str) -> None:
    """Of the release, its updates and its security, for either architecture; wherever a row's ROS is from, its images have
    packages of the system."""
    matrix, paths = at(mirror.address), PATHS[ROWS[row]]
    before = package_state.state(matrix, row, {})
    assert f"debian {ROWS[row]} " in before
    assert sorted(mirror.asked) == sorted([*paths, *([SYNC] if row == "alpha" else [])])
    for path, what in itertools.product(paths, ("amd64", "arm64", "universe")):
        whole = mirror.files[path]
        mirror.files[path] = RELEASE.format(**FACTS | {what: "d" * 64}).encode()
        assert package_state.state(matrix, row, {}) != before, (path, what)
        mirror.files[path] = whole
        assert package_state.state(matrix, row, {}) == before


@pytest.mark.parametrize("row", ROWS)
def test_another_date_alone_is_none(mirror: Mirror, row: str) -> None:
    """Nor are the lists of packages that no image is installed from."""
    before = package_state.state(at(mirror.address), row, {})
    later = RELEASE.format(**FACTS | {"date": "Sun, 22 Nov 2026 16:00:00 UTC", "other": "e" * 64}).encode()
    mirror.files |= {path: later for paths in PATHS.values() for path in paths}
    assert package_state.state(at(mirror.address), row, {}) == before


@pytest.mark.parametrize(("row", "path"), EVERY)
@pytest.mark.parametrize(
    ("body", "words"),
    [
        (None, r"does not answer \(HTTP Error 404"),
        (b"Origin: Debian\n", "names no lists of packages"),
        (b"\xff", "names"),
    ],
)
def test_what_is_not_there_is_an_error(mirror: Mirror, row: str, path: str, body: bytes | None, words: str) -> None:
    """And no state, as which it would have everything built anew."""
    mirror.files.pop(path)
    if body is not None:
        mirror.files[path] = body
    with pytest.raises(RosmlError, match=words) as caught:
        package_state.state(at(mirror.address), row, {})
    assert path in caught.value.message and caught.value.remedy


def test_a_mirror_is_asked_in_the_place_of_the_archive(mirror: Mirror) -> None:
    before = package_state.state(at(mirror.address), "omega", {})
    mirror.files = {f"/debian.test{path}": body for path, body in mirror.files.items()}
    assert package_state.state(at("http://debian.test"), "omega", {"OS_APT_MIRROR": f"{mirror.address}/"}) == before


def test_nobody_who_answers() -> None:
    with pytest.raises(RosmlError, match="does not answer"):
        package_state.state(at("http://127.0.0.1:1"), "omega", {})


def test_a_copy_of_the_base_image_is_watched_too(mirror: Mirror) -> None:
    """The archive is the system's, wherever its base image is."""
    copied = at(mirror.address, image="registry.test/mirror/system:1")
    assert package_state.state(copied, "omega", {}) == package_state.state(at(mirror.address), "omega", {})


def test_each_repository_has_its_own_state(mirror: Mirror) -> None:
    """As the provenance of an image names them; the build fails where ROS's is of another date by then."""
    matrix = at(mirror.address)
    found = package_state.state(matrix, "alpha", {})
    ros, archive = found.split(", ")
    assert package_state.ros_date(found) == package_state.ros_date(DATE) == ros == DATE
    assert package_state.repositories(matrix, "alpha", found) == [
        (f"{mirror.address}/ros2/ubuntu", DATE),
        (mirror.address, archive),
    ]
    own = package_state.state(matrix, "omega", {})
    assert package_state.ros_date(own) == package_state.ros_date("") == ""
    assert package_state.repositories(matrix, "omega", own) == [(mirror.address, own)]
    assert package_state.repositories(matrix, "omega", "") == []


def test_a_system_without_an_archive(mirror: Mirror) -> None:
    """Nobody is asked for it, and ROS's own repository decides alone."""
    matrix = parse(WHEELS.replace("http://ros.test", mirror.address)).matrix
    assert package_state.state(matrix, "alpha", {}) == DATE
    assert package_state.state(matrix, "sigma", {}) == ""
    assert mirror.asked == [SYNC]


def test_a_fixed_package_reaches_every_row(real: ImageSet, mirror: Mirror) -> None:
    """Security's lists, those of updates and the release are asked for, for each row whose system names an archive."""
    lists = mirror.files[PATHS["noble"][0]]
    for row, facts in real.matrix.distributions.items():
        mirror.files, mirror.asked = {}, []
        environ = dict.fromkeys(("OS_APT_MIRROR", "ROS_APT_MIRROR"), mirror.address)
        system = real.matrix.operating_systems[facts.os]
        urls = list(package_state.releases(real.matrix, facts.os, environ))
        mirror.files |= {url.removeprefix(mirror.address): lists for url in urls}
        if source := apt_source.source(real.matrix, row, {}):
            path = source.address.removeprefix("http:/")
            mirror.files[f"{path}/dists/{source.codename}/InRelease"] = b"Date: Fri, 20 Nov 2026 21:14:09 UTC\n"
        assert package_state.state(real.matrix, row, environ), row
        asked = {path.split("/dists/")[1] for path in mirror.asked if path.endswith("/Release")}
        wanted = {f"{system.suite}{pocket}/Release" for pocket in ("", "-updates", "-security")}
        assert asked == (wanted if system.archive else set()), row
