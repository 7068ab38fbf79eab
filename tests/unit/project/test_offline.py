"""Base images without Docker Hub: what is answered about each, how Debian's are made, what parts are built on instead of
Ubuntu's; nothing half-made is left."""

from __future__ import annotations

import gzip
import json
import os
import shutil
import subprocess
import tarfile
from pathlib import Path

import pytest

from fakes.http_registry import local_registry
from fakes.stubs import OFFLINE, buildx, calls, load
from offline import assembler, debian
from rosml.base.errors import RosmlError
from rosml.images.builds.base_images import native_architecture
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry

DEBIAN, UBUNTU = "docker.io/library/debian:bookworm", "docker.io/library/ubuntu:24.04"
DIGEST = f"sha256:{'a' * 64}"


# ---- The command -----------------------------------------------------------------------------------------------------


def answer(*arguments: str) -> tuple[int, dict[str, str]]:
    done = subprocess.run([*OFFLINE, *arguments], capture_output=True, text=True, check=False)
    return done.returncode, json.loads(done.stdout)


def test_what_can_be_had() -> None:
    assert answer(f"{DEBIAN}@{DIGEST}", "--check") == (0, {"missing": ""})
    assert answer(f"registry.test:5000/copy/ubuntu:24.04@{DIGEST}", "--check") == (0, {"missing": ""})
    assert answer(f"{UBUNTU}@{DIGEST}", "--check") == (
        0,
        {"missing": f"{UBUNTU} is on Docker Hub, which does not answer"},
    )


def test_another_registry_answers_for_itself() -> None:
    image = f"registry.test:5000/copy/ubuntu:24.04@{DIGEST}"
    assert answer(image) == (0, {"reference": image, "python": ""})
    assert answer(image, "--assembler", "3.12") == (0, {"reference": image, "python": "3.12"})


def test_an_error_is_an_answer(tmp_path: Path) -> None:
    for name in ("src", "tools/offline"):
        shutil.copytree(Path(OFFLINE[1]).parents[1] / name, tmp_path / name)
    done = subprocess.run(
        [OFFLINE[0], str(tmp_path / "tools/offline"), f"{UBUNTU}@{DIGEST}"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 1, done.stderr
    assert json.loads(done.stdout) == {
        "error": "the local registry and the builder are not up",
        "remedy": "run 'rosml setup'",
    }


# ---- Debian's images -------------------------------------------------------------------------------------------------


def test_no_foreign_architecture(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(debian, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(debian, "BINFMT", tmp_path)
    with pytest.raises(RosmlError, match="arm64 cannot be made on amd64"):
        debian.ensure(load(tmp_path), DEBIAN, "arm64")


def test_a_foreign_architecture_under_emulation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The image has both: parts are built on the machine's own architecture."""
    monkeypatch.setattr(debian, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(debian, "BINFMT", tmp_path)
    (tmp_path / "qemu-aarch64").touch()
    calls: list[tuple[str, str]] = []

    def one(_services: Services, suite: str, architecture: str) -> str:
        calls.append((suite, architecture))
        return f"sha256:{architecture}"

    with local_registry() as registry, Registry(registry.address) as client:
        digests = {
            name: client.put_manifest("library/debian", "", {"schemaVersion": 2, "annotations": {"of": name}})
            for name in ("amd64", "arm64")
        }
        monkeypatch.setattr(debian, "debian", lambda *arguments: digests[one(*arguments).removeprefix("sha256:")])
        reference = debian.ensure(load(tmp_path, registry=registry.address), DEBIAN, "arm64")["reference"]
        index = client.manifest("library/debian", reference.rpartition("@")[2])
    assert index and [(member.digest, member.platform.architecture) for member in index.members if member.platform] == [
        (digest, name) for name, digest in digests.items()
    ]
    assert calls == [("bookworm", "amd64"), ("bookworm", "arm64")]
    assert debian.ensure(load(tmp_path), DEBIAN) == {"reference": f"{DEBIAN}@{digests['amd64']}"}


@pytest.mark.parametrize("image", ["ubuntu:24.04", "other/debian:bookworm", "library/debian:bookworm-slim"])
def test_no_image_but_debians(tmp_path: Path, image: str) -> None:
    with pytest.raises(RosmlError, match="only Debian images can be made here") as caught:
        debian.ensure(load(tmp_path), f"docker.io/{image}")
    assert caught.value.remedy


def test_command_names_no_mirror() -> None:
    argv = debian.command("bookworm", "amd64", Path("/with space/files"), Path("/out.tar"))
    assert argv[-2:] == ["bookworm", "/out.tar"]
    assert "--customize-hook=sync-in '/with space/files' /" in argv
    assert not any("http" in argument for argument in argv)


def test_a_mirror_of_a_suite_that_moves_may_be_old(tmp_path: Path) -> None:
    for suite, lenient in (("sid", True), ("bookworm", False)):
        argv = debian.command(suite, "amd64", tmp_path, tmp_path)
        assert any("Check-Valid-Until" in word for word in argv) == lenient
        assert any("Check-Valid-Until" in text for _, text in debian.added_files(suite).values()) == lenient
    assert debian.recipe("bookworm", "amd64") == debian.recipe("trixie", "amd64") != debian.recipe("sid", "amd64")


def test_image(tmp_path: Path) -> None:
    tar = tmp_path / "root.tar"
    tar.write_bytes(b"content" * 1000)
    manifest, blobs = debian.build_image(tar, "bookworm", "amd64")
    config, layer = blobs
    facts = json.loads(manifest)
    assert [part["digest"] for part in (facts["config"], *facts["layers"])] == [oci.digest_of(blob) for blob in blobs]
    assert gzip.decompress(layer) == tar.read_bytes()
    facts = json.loads(config)
    assert facts["rootfs"]["diff_ids"] == [oci.digest_of(tar.read_bytes())]
    assert (facts["created"], facts["architecture"]) == ("2026-01-01T00:00:00Z", "amd64")
    os.utime(tar, (1, 1))
    assert debian.build_image(tar, "bookworm", "amd64") == (manifest, blobs)


def fake_mmdebstrap(folder: Path, text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    path = folder / "fake" / "mmdebstrap"
    path.parent.mkdir()
    path.write_text(f"#!/bin/bash\n{text}\n")
    path.chmod(0o755)
    monkeypatch.setenv("PATH", f"{path.parent}:/usr/bin:/bin")


FOLDER = ".state/base/bookworm"


def make(root: Path, **facts: str) -> str:
    return debian.make(load(root, **facts), "bookworm", "amd64", root / FOLDER, "bookworm")


def test_failed_mmdebstrap_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fake_mmdebstrap(tmp_path, "echo E: no mirror >&2; exit 7", monkeypatch)
    with pytest.raises(RosmlError, match="E: no mirror"):
        make(tmp_path)
    assert not (tmp_path / FOLDER).exists()


def test_no_mmdebstrap(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(RosmlError, match="not installed") as caught:
        make(tmp_path)
    assert caught.value.remedy == "run 'rosml setup'"


def test_push_that_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fake_mmdebstrap(tmp_path, 'tar --create --file "${@: -1}" --files-from /dev/null', monkeypatch)
    with local_registry() as registry, pytest.raises(RosmlError, match="405"):
        registry.fault("PUT", "/manifests/", 405)
        make(tmp_path, registry=registry.address)
    assert not (tmp_path / FOLDER).exists()


def test_an_image_is_made_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As long as its recipe is the same, and the registry has all of it."""
    fake_mmdebstrap(
        tmp_path, f'echo >>{tmp_path}/calls; tar --create --file "${{@: -1}}" --files-from /dev/null', monkeypatch
    )
    with local_registry() as registry:
        services = load(tmp_path, registry=registry.address)
        digests = {debian.debian(services, "bookworm", native_architecture()) for _ in range(2)}
        assert len(digests) == 1 and len(calls(tmp_path)) == 1
        monkeypatch.setattr(debian, "EPOCH", debian.EPOCH + 1)
        assert debian.debian(services, "bookworm", native_architecture()) not in digests
        registry.blobs.clear()
        debian.debian(services, "bookworm", native_architecture())
    assert len(calls(tmp_path)) == 3


def test_files_are_the_same_under_any_umask(tmp_path: Path) -> None:
    before = os.umask(0o077)
    try:
        debian.write_files(tmp_path / "files", debian.added_files("bookworm"))
    finally:
        os.umask(before)
    modes = {str(path.relative_to(tmp_path)): path.stat().st_mode & 0o777 for path in tmp_path.rglob("*")}
    assert modes["files/usr/sbin"] == 0o755
    assert modes["files/usr/sbin/policy-rc.d"] == 0o755
    assert modes["files/etc/apt/apt.conf.d/docker-clean"] == 0o644


def test_folders_that_are_left_out(tmp_path: Path) -> None:
    tar = tmp_path / "root.tar"
    with tarfile.open(tar, "w") as archive:
        archive.addfile(tarfile.TarInfo("./etc"))
    debian.add_folder(tar)
    with tarfile.open(tar) as archive:
        entries = {entry.name: (entry.isdir(), entry.mode, entry.mtime) for entry in archive}
    assert list(entries) == ["./etc", "./dev"]
    assert entries["./dev"] == (True, 0o755, debian.EPOCH)


# ---- What parts are built on -----------------------------------------------------------------------------------------


@pytest.fixture
def versions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(assembler, "VERSIONS", str(tmp_path / "versions"))
    monkeypatch.setattr(debian, "debian", lambda *_: "sha256:made")
    return tmp_path / "versions"


def python(versions: Path, release: str) -> None:
    home = versions / release
    (home / "lib/python3.12/test").mkdir(parents=True)
    (home / "bin").mkdir()
    for file in ("bin/python3.12", "lib/python3.12/os.py", "lib/python3.12/test/test_os.py"):
        (home / file).write_text(release)


@pytest.mark.usefixtures("versions")
def test_debian_has_its_own_python(tmp_path: Path) -> None:
    base = assembler.ensure(load(tmp_path), "docker.io/library/debian:trixie", "3.13")
    assert base == {"reference": "docker.io/library/debian:trixie@sha256:made", "python": "3.13"}


@pytest.mark.parametrize("version", ["3.14", "any"])
def test_debian_takes_the_place_of_others(tmp_path: Path, versions: Path, version: str) -> None:
    python(versions, "3.12.1")
    base = assembler.ensure(load(tmp_path), UBUNTU, version)
    assert base == {"reference": f"{DEBIAN}@sha256:made", "python": ""}


def test_the_newest_python_of_the_machine(tmp_path: Path, versions: Path) -> None:
    for release in ("3.12.1", "3.12.10", "3.12.9"):
        python(versions, release)
    build = """
for word; do last=$word; done
cat "$last/Dockerfile" "$last/bin/python3.12" >>"$here/calls"; (cd "$last" && find lib -type f) >>"$here/calls"
printf '{"containerimage.digest": "sha256:with-python"}' >"$metadata"
"""
    services = load(tmp_path, buildx=list(buildx(tmp_path, build)))
    base = assembler.ensure(services, UBUNTU, "3.12")
    assert base == {"reference": "127.0.0.1:1/library/assembler@sha256:with-python", "python": "3.12.10"}
    lines = calls(tmp_path)
    assert f"FROM {DEBIAN}@sha256:made" in lines
    assert "3.12.10lib/python3.12/os.py" in lines
    assert not any("test_os.py" in line for line in lines)


def test_a_python_that_cannot_be_added(tmp_path: Path, versions: Path) -> None:
    python(versions, "3.12.1")
    services = load(tmp_path, buildx=list(buildx(tmp_path, "echo no space >&2; exit 1")))
    with pytest.raises(RosmlError, match=r"cannot add Python 3\.12 to .*\s*no space"):
        assembler.ensure(services, UBUNTU, "3.12")
