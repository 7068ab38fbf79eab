"""rosdep's lists in a registry: published from a checkout of ros/rosdistro, and found beside base images."""

from __future__ import annotations

import dataclasses
import gzip
import io
import shutil
import tarfile
from pathlib import Path

import pytest

from fakes.apps import services
from fakes.stubs import executable
from rosml.base.errors import RosmlError
from rosml.containerize.base_image import rosdep_index
from rosml.containerize.base_image.base import Base
from rosml.containerize.base_image.rosdep_index import Finder
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry

__all__ = ["services"]

OURS = {"io.rosml.distribution": "jazzy"}


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    folder = tmp_path / "rosdistro"
    for name, text in (
        ("rosdep/base.yaml", "boost: {ubuntu: [libboost-dev]}\n"),
        ("index-v4.yaml", "distributions: {jazzy: {distribution: [jazzy/distribution.yaml]}}\n"),
        ("jazzy/distribution.yaml", "repositories: {}\n"),
        ("jazzy/other.yaml", "of no use\n"),
    ):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def published(services: Services, checkout: Path) -> str:
    with Registry(services.registry) as client:
        return rosdep_index.publish(checkout, client, "rosml/rosdep", ("20261125", "latest"))


def base(services: Services, **labels: str) -> Base:
    return Base(f"{services.registry}/rosml/ros:jazzy-base", "sha256:1", {}, labels or OURS)


@pytest.fixture
def finder(services: Services, tmp_path: Path) -> Finder:
    return Finder(services, tmp_path, lambda text: None)


def test_the_newest_lists_beside_a_base_image_are_taken(services: Services, checkout: Path, tmp_path: Path) -> None:
    sentences: list[str] = []
    finder = Finder(services, tmp_path, sentences.append)
    assert finder.find("", base(services), "", False) is None, "nobody has published any"
    digest = published(services, checkout)
    lists = finder.find("", base(services), "", False)
    assert lists and lists[1] == digest and sentences == [f"rosdep's lists {services.registry}/rosml/rosdep:latest"]
    names = sorted(str(path.relative_to(lists[0])) for path in lists[0].rglob("*.yaml"))
    assert names == ["index-v4.yaml", "jazzy/distribution.yaml", "rosdep/base.yaml"]
    assert finder.find("", base(services, other="x"), "", False) is None, "it is not ours"


def test_the_same_lists_have_the_same_digest(services: Services, checkout: Path, tmp_path: Path) -> None:
    first = published(services, checkout)
    again = shutil.copytree(checkout, tmp_path / "again")
    assert published(services, again) == first
    (again / "rosdep/base.yaml").write_text("")
    assert published(services, again) != first


def test_a_lock_file_names_the_lists(services: Services, checkout: Path, finder: Finder) -> None:
    first = published(services, checkout)
    (checkout / "rosdep/base.yaml").write_text("")
    published(services, checkout)
    for name in ("", "rosdep:latest", f"{services.registry}/rosml/rosdep:20261125"):
        lists = finder.find(name, base(services), first, True)
        assert lists and "boost" in (lists[0] / "rosdep/base.yaml").read_text()
    away = Finder(dataclasses.replace(services, registry="127.0.0.1:9"), checkout, lambda text: None)
    assert away.find("", Base("127.0.0.1:9/rosml/ros:x", "sha256:1", {}, OURS), first, True) == lists
    assert finder.find("", base(services), "", True) is None, "there were none"
    with pytest.raises(RosmlError, match="the lock file has no lists of rosdep"):
        finder.find("rosdep:latest", base(services), "", True)
    with pytest.raises(RosmlError, match="there are no lists of rosdep sha256:0"):
        finder.find("", base(services), f"sha256:{'0' * 64}", True)


def test_lists_that_a_user_names_must_exist(services: Services, checkout: Path, finder: Finder) -> None:
    assert finder.find("rosdistro", base(services), "", False) == (checkout, "")
    with Registry(services.registry) as client:
        client.put_blob("rosml/rosdep", oci.EMPTY_BLOB)
        client.put_manifest("rosml/rosdep", "image", oci.artifact("text/plain", oci.EMPTY_BLOB, "text/plain"))
    option = "^--rosdep-index, or its variable ROSDEP_INDEX, names"
    for name, problem in (
        ("typo", rf"{option} typo: there is no folder .*/typo$"),
        (f"{services.registry}/rosml/rosdep:typo", rf"{option} .*:typo: there are no lists of rosdep .* \(looked for"),
        ("rosdep:image", ":image has no lists of rosdep"),
    ):
        with pytest.raises(RosmlError, match=problem):
            finder.find(name, base(services), "", False)


def test_damaged_lists_leave_no_folder(services: Services, tmp_path: Path) -> None:
    blob = gzip.compress(b"no tar file" * 100)
    with Registry(services.registry) as client:
        for content in (blob, oci.EMPTY_BLOB):
            client.put_blob("rosml/rosdep", content)
        client.put_manifest("rosml/rosdep", "latest", oci.artifact(rosdep_index.TYPE, blob, rosdep_index.LAYER))
    sentences: list[str] = []
    finder = Finder(services, tmp_path, sentences.append)
    with pytest.raises(RosmlError, match="cannot be unpacked"):
        finder.find(f"{services.registry}/rosml/rosdep:latest", base(services), "", False)
    assert finder.find("", base(services), "", False) is None, "without a name, the build goes on without lists"
    assert "cannot be unpacked" in sentences[0]
    assert not list((services.state / "cache/rosdep").iterdir())


def test_lists_are_written_into_their_folder_alone(tmp_path: Path) -> None:
    """A registry's artifact is a stranger's: a name that leads out, or a link, is left out."""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w:gz") as tar:
        for name in ("rosdep/base.yaml", "../out.yaml", "rosdep/../../out.yaml", f"{tmp_path}/out.yaml", ".git"):
            member = tarfile.TarInfo(name)
            member.size = 2
            tar.addfile(member, io.BytesIO(b"{}"))
        link = tarfile.TarInfo("rosdep/link")
        link.type, link.linkname = tarfile.SYMTYPE, "/etc/hostname"
        tar.addfile(link)
    (tmp_path / "lists").mkdir()
    rosdep_index.unpack(packed.getvalue(), tmp_path / "lists", "the lists")
    assert [file for file in tmp_path.rglob("*") if not file.is_dir()] == [tmp_path / "lists/rosdep/base.yaml"]


def test_without_a_checkout_github_is_cloned(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    executable(tmp_path / "git", 'for folder; do :; done\nmkdir -p "$folder"\necho "$@" >"$folder/arguments"')
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    with rosdep_index.checkout(None) as folder:
        assert "--depth 1 https://github.com/ros/rosdistro" in (folder / "arguments").read_text()
    assert not folder.exists()
    executable(tmp_path / "git", "echo 'fatal: no network' >&2\nexit 128")
    with pytest.raises(RosmlError, match="cannot be cloned: no network"), rosdep_index.checkout(None):
        pass


def test_few_states_are_kept(services: Services, checkout: Path, finder: Finder) -> None:
    for number in range(8):
        (checkout / "rosdep/base.yaml").write_text(f"a{number}: {{}}\n")
        published(services, checkout)
        lists = finder.find("", base(services), "", False)
        assert lists and f"a{number}" in (lists[0] / "rosdep/base.yaml").read_text()
    assert len(list((services.state / "cache/rosdep").iterdir())) == rosdep_index.KEPT


def test_lists_that_would_break_builds_are_not_published(checkout: Path) -> None:
    (checkout / "rosdep/base.yaml").write_text("x: [")
    with pytest.raises(RosmlError, match=r"rosdep/base\.yaml is no YAML"):
        rosdep_index.packed(checkout)
    (checkout / "rosdep/base.yaml").write_text("x: {}")
    (checkout / "rosdep/link.yaml").symlink_to("/etc/hostname")
    with pytest.raises(RosmlError, match="leads out of"):
        rosdep_index.packed(checkout)
    (checkout / "rosdep/link.yaml").unlink()
    for path in ("index-v4.yaml", "rosdep/base.yaml", "jazzy/distribution.yaml"):
        content = (checkout / path).read_text()
        (checkout / path).unlink()
        with pytest.raises(RosmlError) as caught:
            rosdep_index.packed(checkout)
        assert caught.value.exit_code == 2
        (checkout / path).write_text(content)


def test_a_clone_has_the_same_lists_as_another(checkout: Path, tmp_path: Path) -> None:
    (checkout / ".git").mkdir()
    (checkout / ".git/index").write_text("another one in each clone")
    out = rosdep_index.copied(checkout, tmp_path / "out")
    assert sorted(path.name for path in out.iterdir()) == ["index-v4.yaml", "jazzy", "rosdep"]
    with pytest.raises(RosmlError, match=r"has no rosdep/\*\.yaml"):
        rosdep_index.copied(checkout / "jazzy", tmp_path / "out")
