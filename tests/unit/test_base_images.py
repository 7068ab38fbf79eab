"""Base images: which one is used, how one is made, and that nothing half-made is left."""

from __future__ import annotations

import gzip
import hashlib
import json
import os
import tarfile
from dataclasses import dataclass
from pathlib import Path

import pytest
from stubs import load

from rosml.base.errors import RosmlError
from rosml.machine import base_images, regctl

DIGEST = f"sha256:{'a' * 64}"


@dataclass(frozen=True)
class System:
    image: str = "docker.io/library/debian:bookworm"
    digest: str = DIGEST


def test_official_image_where_docker_hub_answers(tmp_path: Path) -> None:
    services = load(tmp_path, mirror=False, docker_hub=True)
    assert base_images.ensure(services, System()) == f"docker.io/library/debian:bookworm@{DIGEST}"
    ubuntu = System("docker.io/library/ubuntu:24.04")
    assert base_images.ensure(services, ubuntu, "arm64") == f"docker.io/library/ubuntu:24.04@{DIGEST}"


def test_no_ubuntu_without_docker_hub(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=r"ubuntu:24\.04 is on Docker Hub, which does not answer") as caught:
        base_images.ensure(load(tmp_path), System("docker.io/library/ubuntu:24.04"))
    assert caught.value.remedy


def test_no_foreign_architecture_without_docker_hub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(base_images, "BINFMT", tmp_path)
    with pytest.raises(RosmlError, match="arm64 cannot be made on amd64"):
        base_images.ensure(load(tmp_path), System(), "arm64")


def test_a_foreign_architecture_under_emulation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The image has both: parts are assembled on the machine's own architecture."""
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(base_images, "BINFMT", tmp_path)
    (tmp_path / "qemu-aarch64").touch()
    made: list[tuple[str, ...]] = []

    def debian(_services: object, *wanted: object) -> str:
        made.append(tuple(str(item) for item in wanted[:2]))
        return f"sha256:{wanted[1]}"

    def index(_services: object, repository: str, digests: list[str], _annotations: object) -> str:
        assert digests == ["sha256:amd64", "sha256:arm64"]
        return f"sha256:of-{repository.rpartition('/')[2]}"

    monkeypatch.setattr(base_images, "debian", debian)
    monkeypatch.setattr(regctl, "create_index", index)
    assert base_images.ensure(load(tmp_path), System(), "arm64") == "docker.io/library/debian:bookworm@sha256:of-debian"
    assert made == [("bookworm", "amd64"), ("bookworm", "arm64")]
    assert base_images.ensure(load(tmp_path), System()) == "docker.io/library/debian:bookworm@sha256:amd64"


@pytest.mark.parametrize(
    ("image", "suite"),
    [
        ("docker.io/library/debian:bookworm", "bookworm"),
        ("debian:trixie", "trixie"),
        ("docker.io/library/ubuntu:24.04", ""),
        ("docker.io/other/debian:bookworm", ""),
        ("debian:bookworm-slim", ""),
    ],
)
def test_debian_suite(image: str, suite: str) -> None:
    assert base_images.debian_suite(image) == suite


def test_command_names_no_mirror() -> None:
    argv = base_images.command("bookworm", "amd64", Path("/with space/files"), Path("/out.tar"))
    assert argv[-2:] == ["bookworm", "/out.tar"]
    assert "--customize-hook=sync-in '/with space/files' /" in argv
    assert not any("http" in argument for argument in argv)


def write_tar(tar: Path) -> None:
    """Something to put into a layer."""
    tar.parent.mkdir(parents=True, exist_ok=True)
    tar.write_bytes(b"content" * 1000)


def test_layout(tmp_path: Path) -> None:
    write_tar(tmp_path / "root.tar")
    layout = tmp_path / "layout"
    digest = base_images.write_layout(layout, tmp_path / "root.tar", "bookworm", "amd64")
    for blob in (layout / "blobs" / "sha256").iterdir():
        assert hashlib.sha256(blob.read_bytes()).hexdigest() == blob.name
    index = json.loads((layout / "index.json").read_text())
    assert index["manifests"][0]["digest"] == digest
    manifest = json.loads((layout / "blobs/sha256" / digest.removeprefix("sha256:")).read_text())
    config = json.loads((layout / "blobs/sha256" / manifest["config"]["digest"].removeprefix("sha256:")).read_text())
    layer = layout / "blobs/sha256" / manifest["layers"][0]["digest"].removeprefix("sha256:")
    content = gzip.decompress(layer.read_bytes())
    assert config["rootfs"]["diff_ids"] == [f"sha256:{hashlib.sha256(content).hexdigest()}"]
    assert config["created"] == "2026-01-01T00:00:00Z"
    assert config["architecture"] == "amd64"


def test_same_content_same_digest(tmp_path: Path) -> None:
    write_tar(tmp_path / "root.tar")
    first = base_images.write_layout(tmp_path / "a", tmp_path / "root.tar", "bookworm", "amd64")
    os.utime(tmp_path / "root.tar", (1, 1))
    assert base_images.write_layout(tmp_path / "b", tmp_path / "root.tar", "bookworm", "amd64") == first


def fake_mmdebstrap(folder: Path, text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Puts a stand-in for mmdebstrap on PATH. Its last argument is the file to write."""
    path = folder / "fake" / "mmdebstrap"
    path.parent.mkdir()
    path.write_text(f"#!/bin/bash\n{text}\n")
    path.chmod(0o755)
    monkeypatch.setenv("PATH", f"{path.parent}:/usr/bin:/bin")


def test_failed_mmdebstrap_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fake_mmdebstrap(tmp_path, "echo E: no mirror >&2; exit 7", monkeypatch)
    folder = tmp_path / ".state/base/bookworm"
    with pytest.raises(RosmlError, match="E: no mirror"):
        base_images.make(load(tmp_path), "bookworm", "amd64", folder, print)
    assert not folder.exists()


def test_no_mmdebstrap(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(RosmlError, match="not installed") as caught:
        base_images.make(load(tmp_path), "bookworm", "amd64", tmp_path / "x", print)
    assert caught.value.remedy == "run 'make up'"


def test_push_that_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fake_mmdebstrap(tmp_path, 'tar --create --file "${@: -1}" --files-from /dev/null', monkeypatch)
    regctl = tmp_path / "regctl"
    regctl.write_text("#!/bin/sh\n[ $1 = registry ] || { echo refused >&2; exit 1; }\n")
    regctl.chmod(0o755)
    folder = tmp_path / ".state/base/bookworm"
    with pytest.raises(RosmlError, match="refused"):
        base_images.make(load(tmp_path, regctl=str(regctl)), "bookworm", "amd64", folder, print)
    assert not folder.exists()


def test_files_are_the_same_under_any_umask(tmp_path: Path) -> None:
    before = os.umask(0o077)
    try:
        base_images.write_files(tmp_path / "files")
    finally:
        os.umask(before)
    modes = {str(path.relative_to(tmp_path)): path.stat().st_mode & 0o777 for path in tmp_path.rglob("*")}
    assert modes["files/usr/sbin"] == 0o755
    assert modes["files/usr/sbin/policy-rc.d"] == 0o755
    assert modes["files/etc/apt/apt.conf.d/docker-clean"] == 0o644


def test_folders_that_are_left_out(tmp_path: Path) -> None:
    """With a fixed time; what is there stays."""
    tar = tmp_path / "root.tar"
    with tarfile.open(tar, "w") as archive:
        archive.addfile(tarfile.TarInfo("./etc"))
    base_images.add_folders(tar)
    with tarfile.open(tar) as archive:
        found = {entry.name: (entry.isdir(), entry.mode, entry.mtime) for entry in archive}
    assert list(found) == ["./etc", "./dev"]
    assert found["./dev"] == (True, 0o755, base_images.EPOCH)
