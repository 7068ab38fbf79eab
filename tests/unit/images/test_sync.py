"""Where a distribution's packages come from, and of when that repository is."""

from __future__ import annotations

import functools
import gzip
import hashlib
import http.server
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from rosml.base.errors import RosmlError
from rosml.images.builds import sync
from rosml.images.image_set import apt_repository
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix.model import Matrix, RosArchive

SOURCE = apt_repository.AptRepository("live", "", "http://live.test/ros2/ubuntu", "noble")


@pytest.fixture
def matrix(real: ImageSet) -> Matrix:
    """Our matrix with ROS's repositories at other addresses."""
    archive = RosArchive(
        live="http://live.test/{generation}/ubuntu",
        testing="http://testing.test/{generation}/ubuntu",
        snapshot="http://old.test/{ros_distro}/{day}",
        apt_source="https://git.test/{version}/{generation}.{codename}.deb",
    )
    return real.matrix.model_copy(update={"ros_archive": archive})


def test_as_the_matrix_says(matrix: Matrix) -> None:
    found = apt_repository.of(matrix, "jazzy", {})
    assert found == SOURCE
    final = apt_repository.of(matrix, "noetic", {})
    assert final == apt_repository.AptRepository("final", "", "http://old.test/noetic/final", "focal")
    assert apt_repository.of(matrix, "ros1-bookworm", {}) is None


def test_otherwise_for_once(matrix: Matrix) -> None:
    found = apt_repository.of(matrix, "foxy", {"ROS_CHANNEL": "live"})
    assert found and found.address == "http://live.test/ros2/ubuntu"
    found = apt_repository.of(matrix, "jazzy", {"ROS_CHANNEL": "snapshot", "ROS_SNAPSHOT": "2026-08-07"})
    assert found and found.address == "http://old.test/jazzy/2026-08-07"
    found = apt_repository.of(matrix, "rolling", {"ROS_CHANNEL": "testing"})
    assert found and found.address == "http://testing.test/ros2/ubuntu"
    without = (
        RosArchive.model_validate({**matrix.ros_archive.model_dump(), "testing": None}) if matrix.ros_archive else None
    )
    with pytest.raises(RosmlError, match="ROS's testing repository has no address"):
        apt_repository.of(matrix.model_copy(update={"ros_archive": without}), "rolling", {"ROS_CHANNEL": "testing"})


@pytest.mark.parametrize(
    ("name", "environ", "words"),
    [
        ("jazzy", {"ROS_CHANNEL": "fina"}, "no channel 'fina'"),
        ("jazzy", {"ROS_CHANNEL": "snapshot"}, "a snapshot is of a day"),
        ("jazzy", {"ROS_CHANNEL": "snapshot", "ROS_SNAPSHOT": "yesterday"}, "no day 'yesterday'"),
        ("jazzy", {"ROS_CHANNEL": "snapshot", "ROS_SNAPSHOT": "20260807"}, "no day '20260807'"),
        ("jazzy", {"ROS_SNAPSHOT": "2026-08-07"}, "the channel live has no days"),
        ("jazzy", {"ROS_CHANNEL": "snapshot", "ROS_SNAPSHOT": "2999-01-01"}, "still to come"),
        ("rolling", {"ROS_CHANNEL": "final"}, "until further notice: it has no final snapshot yet"),
        ("ros1-bookworm", {"ROS_CHANNEL": "final"}, "the ROS packages of ros1-bookworm are bookworm's own"),
    ],
)
def test_what_there_is_not(real: ImageSet, name: str, environ: dict[str, str], words: str) -> None:
    with pytest.raises(RosmlError, match=words) as caught:
        apt_repository.of(real.matrix, name, environ)
    assert caught.value.exit_code == 2
    assert caught.value.remedy


ANSWERS = {
    "good": "Origin: ROS\nDate: Fri, 20 Nov 2026 22:14:09 +0100\nCodename: noble\n",
    "protected": "Date: Fri, 20 Nov 2026 21:14:09 UTC\n",
    "dateless": "Origin: ROS\n",
    "odd": "Date: some day\n",
}


@pytest.fixture(scope="module")
def mirror() -> Iterator[str]:
    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            name, _, path = self.path.lstrip("/").partition("/")
            known = name in ANSWERS and path == "live.test/ros2/ubuntu/dists/noble/InRelease"
            closed = name == "protected" and self.headers["Authorization"] != "Basic dXNlcjpzZWNyZXQ="
            self.send_response(401 if closed else 200 if known else 404)
            self.end_headers()
            self.wfile.write(ANSWERS[name].encode() if known else b"")

        def log_message(self, format: str, *args: object) -> None:
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()


def test_of_when_it_is(mirror: str) -> None:
    assert sync.published(SOURCE, {"ROS_APT_MIRROR": f"{mirror}/good/"}) == "2026-11-20T21:14:09Z"


@pytest.mark.parametrize(
    ("name", "words"), [("absent", "does not answer"), ("dateless", "has no date"), ("odd", "has no date")]
)
def test_nobody_knows(mirror: str, name: str, words: str) -> None:
    with pytest.raises(RosmlError, match=words):
        sync.published(SOURCE, {"ROS_APT_MIRROR": f"{mirror}/{name}"})


@pytest.mark.parametrize("mirror", ["nonsense", "http://a b", "ftp://mirror"])
def test_a_mirror_that_is_no_address(mirror: str) -> None:
    with pytest.raises(RosmlError, match="ROS_APT_MIRROR is not an address") as caught:
        sync.published(SOURCE, {"ROS_APT_MIRROR": mirror})
    assert caught.value.exit_code == 2 and caught.value.remedy


def test_a_mirrors_password_is_sent_and_never_told(mirror: str) -> None:
    closed = mirror.replace("http://", "http://user:secret@")
    assert sync.published(SOURCE, {"ROS_APT_MIRROR": f"{closed}/protected"}) == "2026-11-20T21:14:09Z"
    for name in ("absent", "dateless"):
        with pytest.raises(RosmlError) as caught:
            sync.published(SOURCE, {"ROS_APT_MIRROR": f"{closed}/{name}"})
        assert "secret" not in caught.value.message + caught.value.remedy and "127.0.0.1" in caught.value.message
    with pytest.raises(RosmlError, match="401"):
        sync.published(SOURCE, {"ROS_APT_MIRROR": f"{mirror}/protected"})


@pytest.fixture
def archive(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder that is served as a mirror: a repository with two packages."""
    folder = tmp_path / "mirror/live.test/ros2/ubuntu/dists/noble"
    write_list(
        folder, "Package: ros-jazzy-ros-core\nVersion: 1\n\nPackage: ros-jazzy-ros-base\nDepends: ros-jazzy-desktop\n"
    )
    quiet = type("Quiet", (http.server.SimpleHTTPRequestHandler,), {"log_message": lambda *_: None})
    handler = functools.partial(quiet, directory=str(tmp_path / "mirror"))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True).start()
        monkeypatch.setenv("ROS_APT_MIRROR", f"http://127.0.0.1:{server.server_port}")
        yield folder
        server.shutdown()


def write_list(folder: Path, text: str) -> Path:
    """A list of packages, and the Release file that names it."""
    file = folder / "main/binary-amd64/Packages.gz"
    file.parent.mkdir(parents=True, exist_ok=True)
    half = len(text) // 2
    file.write_bytes(b"".join(gzip.compress(piece.encode(), mtime=0) for piece in (text[:half], text[half:])))
    digest = hashlib.sha256(file.read_bytes()).hexdigest()
    (folder / "InRelease").write_text(
        f"Origin: ROS\nSHA256:\n {digest} {file.stat().st_size} main/binary-amd64/Packages.gz\n"
    )
    return file


def test_packages_that_a_repository_does_not_have(archive: Path, tmp_path: Path) -> None:
    """A list that was read before is not fetched again; a new one is."""
    wanted = ["ros-jazzy-ros-core", "ros-jazzy-desktop", "ros-jazzy-ros-base"]
    assert sync.lacking(tmp_path, SOURCE, "amd64", wanted) == ["ros-jazzy-desktop"]
    (archive / "main/binary-amd64/Packages.gz").unlink()
    assert sync.lacking(tmp_path, SOURCE, "amd64", wanted) == ["ros-jazzy-desktop"]
    write_list(archive, "Package: ros-jazzy-desktop\n")
    assert sync.lacking(tmp_path, SOURCE, "amd64", wanted) == ["ros-jazzy-ros-core", "ros-jazzy-ros-base"]


def test_a_list_that_cannot_be_read_says_nothing_of_packages(archive: Path, tmp_path: Path) -> None:
    assert sync.lacking(tmp_path, SOURCE, "arm64", ["x"]) == []
    file = archive / "main/binary-amd64/Packages.gz"
    whole = file.read_bytes()
    for content in (b"", whole[:-9], b"<html>"):
        file.write_bytes(content)
        with pytest.raises(RosmlError, match="does not match its Release file"):
            sync.lacking(tmp_path, SOURCE, "amd64", ["x"])
    broken = whole[:-9]
    digest = hashlib.sha256(broken).hexdigest()
    file.write_bytes(broken)
    (archive / "InRelease").write_text(f"SHA256:\n {digest} 9 main/binary-amd64/Packages.gz\n")
    with pytest.raises(RosmlError, match="cannot be unpacked"):
        sync.lacking(tmp_path, SOURCE, "amd64", ["x"])


def test_remembered(tmp_path: Path) -> None:
    assert sync.remembered(tmp_path, SOURCE) == ""
    sync.remember(tmp_path, SOURCE, "2026-11-20T21:14:09Z")
    assert sync.remembered(tmp_path, SOURCE) == "2026-11-20T21:14:09Z"
    other = apt_repository.AptRepository("final", "", "http://old.test/noetic/final", "focal")
    assert sync.remembered(tmp_path, other) == ""
    (tmp_path / "ros-sync.json").write_text("[1]")
    assert sync.remembered(tmp_path, SOURCE) == ""
