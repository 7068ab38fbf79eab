"""The apt repository of a distribution's ROS packages: which one it is, its sync date, and the packages that it lacks."""

from __future__ import annotations

import gzip
import hashlib
from collections.abc import Iterator
from pathlib import Path

import pytest

from fakes.apt_mirror import AptMirror, serving
from rosml.base.errors import RosmlError
from rosml.images.builds import sync
from rosml.images.image_set import apt_repository
from rosml.images.image_set.apt_repository import AptRepository
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix.model import Matrix, RosArchive

SOURCE = AptRepository("live", "", "http://live.test/ros2/ubuntu", "noble")
SUITE = "/live.test/ros2/ubuntu/dists/noble"
DATE = "2026-11-20T21:14:09Z"
GOOD = b"Origin: ROS\nDate: Fri, 20 Nov 2026 22:14:09 +0100\nCodename: noble\n"


@pytest.fixture
def matrix(real: ImageSet) -> Matrix:
    """Our matrix with ROS's repositories at other addresses."""
    live, testing = (f"http://{name}.test/{{generation}}/ubuntu" for name in ("live", "testing"))
    source = "https://git.test/{version}/{generation}.{codename}.deb"
    archive = RosArchive(live=live, testing=testing, snapshot="http://old.test/{ros_distro}/{day}", apt_source=source)
    return real.matrix.model_copy(update={"ros_archive": archive})


@pytest.mark.parametrize(
    ("name", "environ", "address"),
    [
        ("jazzy", {}, SOURCE.address),
        ("noetic", {}, "http://old.test/noetic/final"),
        ("ros1-bookworm", {}, ""),
        ("foxy", {"ROS_CHANNEL": "live"}, SOURCE.address),
        ("jazzy", {"ROS_CHANNEL": "snapshot", "ROS_SNAPSHOT": "2026-08-07"}, "http://old.test/jazzy/2026-08-07"),
        ("rolling", {"ROS_CHANNEL": "testing"}, "http://testing.test/ros2/ubuntu"),
    ],
)
def test_the_repository_of_a_distribution(matrix: Matrix, name: str, environ: dict[str, str], address: str) -> None:
    source = apt_repository.of(matrix, name, environ)
    assert (source.address if source else "") == address


@pytest.mark.parametrize(
    ("name", "environ", "words"),
    [
        ("jazzy", {"ROS_CHANNEL": "fina"}, "no channel 'fina'"),
        ("jazzy", {"ROS_CHANNEL": "snapshot"}, "a snapshot is of a day"),
        ("jazzy", {"ROS_CHANNEL": "snapshot", "ROS_SNAPSHOT": "20260807"}, "no day '20260807'"),
        ("jazzy", {"ROS_SNAPSHOT": "2026-08-07"}, "the channel live has no days"),
        ("jazzy", {"ROS_CHANNEL": "snapshot", "ROS_SNAPSHOT": "2999-01-01"}, "still to come"),
        ("rolling", {"ROS_CHANNEL": "final"}, "it has no final snapshot yet"),
        ("ros1-bookworm", {"ROS_CHANNEL": "final"}, "the ROS packages of ros1-bookworm are bookworm's own"),
    ],
)
def test_what_there_is_not(real: ImageSet, name: str, environ: dict[str, str], words: str) -> None:
    with pytest.raises(RosmlError, match=words) as caught:
        apt_repository.of(real.matrix, name, environ)
    assert caught.value.exit_code == 2 and caught.value.remedy


@pytest.fixture
def mirror(monkeypatch: pytest.MonkeyPatch) -> Iterator[AptMirror]:
    with serving() as server:
        monkeypatch.setenv("ROS_APT_MIRROR", server.address)
        server.files[f"{SUITE}/InRelease"] = GOOD
        yield server


def test_when_a_repository_was_published(mirror: AptMirror) -> None:
    assert sync.published(SOURCE, {"ROS_APT_MIRROR": f"{mirror.address}/"}) == DATE


@pytest.mark.parametrize("release", [b"Origin: ROS\n", b"Date: some day\n", b""])
def test_a_repository_without_a_date(mirror: AptMirror, release: bytes) -> None:
    mirror.files[f"{SUITE}/InRelease"] = release
    with pytest.raises(RosmlError, match="has no date"):
        sync.published(SOURCE)


@pytest.mark.parametrize("address", ["nonsense", "http://a b", "ftp://mirror"])
def test_a_mirror_that_is_no_address(address: str) -> None:
    with pytest.raises(RosmlError, match="ROS_APT_MIRROR is not an address") as caught:
        sync.published(SOURCE, {"ROS_APT_MIRROR": address})
    assert caught.value.exit_code == 2


def test_a_mirrors_password_is_sent_and_in_no_message(mirror: AptMirror) -> None:
    mirror.authorization = "Basic dXNlcjpzZWNyZXQ="
    with pytest.raises(RosmlError, match="401"):
        sync.published(SOURCE)
    environ = {"ROS_APT_MIRROR": mirror.address.replace("http://", "http://user:secret@")}
    assert sync.published(SOURCE, environ) == DATE
    for files in ({}, {f"{SUITE}/InRelease": b"Origin: ROS\n"}):
        mirror.files = files
        with pytest.raises(RosmlError) as caught:
            sync.published(SOURCE, environ)
        assert "secret" not in caught.value.message + caught.value.remedy and "127.0.0.1" in caught.value.message


def put_list(mirror: AptMirror, *names: str) -> bytes:
    """A list of packages in two gzip members, and the Release file that names it."""
    text = "".join(f"Package: {name}\nDepends: ros-jazzy-desktop\n\n" for name in names)
    packed = b"".join(gzip.compress(half.encode(), mtime=0) for half in (text[:20], text[20:]))
    publish(mirror, packed)
    return packed


def publish(mirror: AptMirror, packed: bytes) -> None:
    path = "main/binary-amd64/Packages.gz"
    line = f"SHA256:\n {hashlib.sha256(packed).hexdigest()} {len(packed)} {path}\n"
    mirror.files |= {f"{SUITE}/{path}": packed, f"{SUITE}/InRelease": line.encode()}


def test_packages_that_a_repository_lacks(mirror: AptMirror, tmp_path: Path) -> None:
    """A list that was read before is not fetched again; a new one is."""
    packages = ["ros-jazzy-ros-core", "ros-jazzy-desktop", "ros-jazzy-ros-base"]
    put_list(mirror, "ros-jazzy-ros-core", "ros-jazzy-ros-base")
    for _ in range(2):
        assert sync.lacking(tmp_path, SOURCE, "amd64", packages) == ["ros-jazzy-desktop"]
    assert len([path for path in mirror.requests if path.endswith(".gz")]) == 1
    put_list(mirror, "ros-jazzy-desktop")
    assert sync.lacking(tmp_path, SOURCE, "amd64", packages) == ["ros-jazzy-ros-core", "ros-jazzy-ros-base"]
    assert sync.lacking(tmp_path, SOURCE, "arm64", ["x"]) == [], "there is no list"


def test_a_list_that_cannot_be_read_says_nothing_of_packages(mirror: AptMirror, tmp_path: Path) -> None:
    whole = put_list(mirror, "x")
    for content in (b"", whole[:-9], b"<html>"):
        mirror.files[f"{SUITE}/main/binary-amd64/Packages.gz"] = content
        with pytest.raises(RosmlError, match="does not match its Release file"):
            sync.lacking(tmp_path, SOURCE, "amd64", ["x"])
    publish(mirror, whole[:-9])
    with pytest.raises(RosmlError, match="cannot be unpacked"):
        sync.lacking(tmp_path, SOURCE, "amd64", ["x"])


def test_the_saved_date_of_a_repository(tmp_path: Path) -> None:
    assert sync.remembered(tmp_path, SOURCE) == ""
    sync.remember(tmp_path, SOURCE, DATE)
    other = AptRepository("final", "", "http://old.test/noetic/final", "focal")
    assert (sync.remembered(tmp_path, SOURCE), sync.remembered(tmp_path, other)) == (DATE, "")
    (tmp_path / "ros-sync.json").write_text("[1]")
    assert sync.remembered(tmp_path, SOURCE) == ""
