"""The base image of an app: how it is found, what of it is refused, and which slim one belongs to it."""

from __future__ import annotations

import dataclasses
import json
import tarfile
import time
import tracemalloc
import zlib
from pathlib import Path

import pytest

from fakes.apps import NATIVE, Robot, put, robot, services
from fakes.stubs import executable
from rosml.base.errors import RosmlError
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image import rosdep_index
from rosml.containerize.base_image.base import Base
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registries, Registry

__all__ = ["robot", "services"]

BOTH = ("linux/amd64", "linux/arm64")


def test_a_short_name_is_the_local_registrys_or_docker_hubs(services: Services) -> None:
    local = f"{services.registry}/rosml/ros-tf:jazzy"
    assert app_base.candidates("ros-tf:jazzy", services) == (local, "docker.io/library/ros-tf:jazzy")
    assert app_base.candidates("me/robot", services)[-1] == "docker.io/me/robot"
    for name in ("ghcr.io/me/robot:1", "localhost/robot"):
        assert app_base.candidates(name, services) == (name,)


def test_a_base_image_is_read_and_held_by_its_digest(services: Services) -> None:
    name = f"{services.registry}/rosml/ros"
    digest = put(services, "rosml/ros:jazzy", *BOTH, ROS_DISTRO="jazzy")
    base = app_base.find(f"{name}:jazzy", services, BOTH[1:])
    assert (base.reference, base.environment) == (f"{name}@{digest}", {"ROS_DISTRO": "jazzy"})
    with pytest.raises(RosmlError, match=r"rosml/ros:jazzy is not for linux/riscv64"):
        app_base.find(f"{name}:jazzy", services, ("linux/amd64", "linux/riscv64"))
    for tag, remedy in (("jazy", "did you mean 'jazzy'?"), ("humble-base", "build it first: rosml image humble-base")):
        with pytest.raises(RosmlError, match="there is no image") as caught:
            app_base.find(f"{name}:{tag}", services, ("linux/amd64",))
        assert remedy in caught.value.remedy


def test_debians_image_if_docker_hub_does_not_answer(
    services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HTTPS_PROXY", "http://127.0.0.1:1")
    monkeypatch.setattr(time, "sleep", lambda _seconds: None)
    monkeypatch.delenv("OS_BOOKWORM", raising=False)
    digest = put(services, "library/debian:bookworm", "linux/amd64")
    answer = f'{{"reference": "docker.io/library/debian:bookworm@{digest}"}}'
    with_copy = dataclasses.replace(services, bases=(executable(tmp_path / "bases", f"echo '{answer}'"),))
    for pinned in ("", digest):
        base = app_base.find("debian:bookworm", with_copy, ("linux/amd64",), pinned)
        assert base.name == "docker.io/library/debian:bookworm"
        assert base.reference == f"docker.io/library/debian@{digest}"
    monkeypatch.setenv("PATH", str(tmp_path))  # no image of the machine's own Docker counts
    engine = dataclasses.replace(with_copy, builder_kind="engine")
    base = app_base.find("debian:bookworm", engine, ("linux/amd64",))
    assert base.name == "docker.io/library/debian:bookworm"
    assert base.reference == f"{services.registry}/library/debian@{digest}", "Docker knows no mirror on loopback"
    for name, machine in (("debian:bookwrom", with_copy), ("debian:bookworm", services)):
        with pytest.raises(RosmlError, match=f"there is no image {name} in the local registry, and docker.io: "):
            app_base.find(name, machine, ("linux/amd64",))


OURS = {"io.rosml.distribution": "jazzy", "io.rosml.runtime": "base-run"}
STACK = {**OURS, "io.rosml.stack": "cpu"}
VERSIONED = {**STACK, "io.rosml.component": "base", "org.opencontainers.image.version": "jazzy-base-cpu-tf2.20.0"}

WITH_A = {"io.rosml.environments": "a", "org.opencontainers.image.version": "jazzy-base-cpu-tf2.20.0-env-a"}


@pytest.mark.parametrize(
    ("name", "labels", "runtime"),
    [
        ("ghcr.io/me/ros:jazzy", OURS, "ghcr.io/me/ros:jazzy-base-run"),
        ("127.0.0.1:5000/ros-tf:jazzy-desktop-cpu", STACK, "127.0.0.1:5000/ros-tf:jazzy-base-run-cpu"),
        ("ghcr.io/me/ros:jazzy-base-20261124", OURS, "ghcr.io/me/ros:jazzy-base-run-20261124"),
        ("ghcr.io/me/ros:jazzy", {"io.rosml.distribution": "jazzy"}, ""),
        ("ghcr.io/me/ros-tf:jazzy-base-cpu-tf2.20.0", VERSIONED, "ghcr.io/me/ros-tf:jazzy-base-run-cpu-tf2.20.0"),
        ("ghcr.io/me/ros-tf:jazzy-base-cpu-env-a", VERSIONED | WITH_A, "ghcr.io/me/ros-tf:jazzy-base-run-cpu"),
        ("me/ros-tf:jazzy-base-cpu-tf2.20.0-env-a", VERSIONED | WITH_A, "me/ros-tf:jazzy-base-run-cpu-tf2.20.0"),
        ("ghcr.io/me/ros@sha256:0123", OURS, "ghcr.io/me/ros:jazzy-base-run"),
    ],
)
def test_a_base_image_says_which_one_has_no_compilers(name: str, labels: dict[str, str], runtime: str) -> None:
    assert app_base.runtime(Base(name, "sha256:1", {}, labels)) == runtime


def test_a_slim_image_is_of_the_same_versions() -> None:
    shared = {"io.rosml.os": "x"}
    base = shared | {
        "io.rosml.environments": "a",
        "io.rosml.component": "base",
        "io.rosml.runtime": "base-run",
        "io.rosml.torch": "2.10.0",
    }
    slim = shared | {"io.rosml.component": "base-run", "io.rosml.torch": "2.11.0", "io.rosml.cuda": "12"}
    assert app_base.differing(Base("a", "", {}, base), Base("b", "", {}, slim)) == ["cuda", "torch"]


def test_a_base_image_of_a_lock_file_is_found_wherever_its_tag_is(services: Services) -> None:
    first = put(services, "rosml/ros:jazzy", DAY="1")
    newer = put(services, "rosml/ros:jazzy", DAY="2")
    assert app_base.find("ros:jazzy", services, ()).digest == newer
    base = app_base.find("ros:jazzy", services, (), first)
    assert (base.digest, base.environment["DAY"], base.name) == (first, "1", f"{services.registry}/rosml/ros:jazzy")


@pytest.mark.parametrize("short", [True, False])
def test_a_wrong_digest_is_answered_with_the_tags_digest(services: Services, short: bool) -> None:
    digest = put(services, "rosml/ros:jazzy")
    wrong = f"sha256:{'0' * 64}"
    name = "ros" if short else f"{services.registry}/rosml/ros"
    for tag, says, remedy in (
        (":jazzy", f"not with the digest {wrong}", f"{name}:jazzy@{digest}"),
        ("", f"has no image with the digest {wrong}", "take one of its tags: jazzy"),
        (":typo", f"there is no image {name}:typo@{wrong}", "check its name and its digest"),
    ):
        with pytest.raises(RosmlError) as caught:
            app_base.find(f"{name}{tag}@{wrong}", services, ())
        assert says in caught.value.message and remedy in caught.value.remedy
        assert ("docker.io/library/ros:typo@" in caught.value.message) is (short and tag == ":typo")


def test_an_image_that_docker_alone_has(services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where Docker builds; another builder could not have it."""
    facts = {"Id": "sha256:7", "Os": "linux", "Architecture": "amd64", "Config": {"Env": ["ROS_DISTRO=jazzy"]}}
    executable(tmp_path / "docker", f"echo '{json.dumps([facts])}'")
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    name = f"{services.registry}/mine:1"
    with_docker = dataclasses.replace(services, builder_kind="user")
    for digest in ("", "sha256:7"):
        base = app_base.find(name, with_docker, ("linux/amd64",), digest)
        assert (base.reference, base.digest, base.environment) == (name, "sha256:7", {"ROS_DISTRO": "jazzy"})
    with pytest.raises(RosmlError):  # a lock file names another one
        app_base.find(name, with_docker, ("linux/amd64",), "sha256:8")
    with pytest.raises(RosmlError, match="there is no image"):
        app_base.find(name, services, ("linux/amd64",))
    executable(tmp_path / "docker", f"echo '{json.dumps([{**facts, 'Config': {'OnBuild': ['RUN x']}}])}'")
    with pytest.raises(RosmlError, match="mine:1 has ONBUILD"):
        app_base.find(name, with_docker, ("linux/amd64",))


ONBUILD = {"OnBuild": ["RUN true", "ADD http://127.0.0.1:8099/secret \n /"]}
"""Settings of an image from which each build reads from this machine's own network, by the builder itself."""

PLATFORMS = {name: {"os": "linux", "architecture": name} for name in ("amd64", "arm64", "386")}


@pytest.mark.parametrize("architecture", [*PLATFORMS, ""])
def test_a_base_image_with_onbuild_is_refused(services: Services, architecture: str) -> None:
    """Whichever image of an index a builder may take: a repository names the base image."""
    put(services, "rosml/ros:plain", "linux/amd64")
    put(services, "rosml/ros:fetch", "linux/amd64", config=ONBUILD)
    with Registry(services.registry) as client:
        [plain, fetch] = (client.manifest("rosml/ros", tag) for tag in ("plain", "fetch"))
        assert plain and fetch
        [entry] = fetch.content["manifests"]
        entries = [*plain.content["manifests"], {**entry, "platform": PLATFORMS.get(architecture)}]
        client.put_manifest("rosml/ros", "both", {**plain.content, "manifests": entries}, oci.INDEX)
    for tag, platforms in (("fetch", BOTH[:1]), ("both", BOTH if architecture == "arm64" else BOTH[:1])):
        with pytest.raises(RosmlError, match=r"has ONBUILD.*: RUN true, ADD http://127.0.0.1:8099/secret /$") as caught:
            app_base.find(f"{services.registry}/rosml/ros:{tag}", services, platforms)
        assert caught.value.exit_code == 2 and caught.value.remedy


def test_a_stage_with_onbuild_is_refused(robot: Robot) -> None:
    """Whoever may push to the cache knows all that decides a stage's tag."""
    robot.build(cache=robot.cache)
    [output] = robot.bake_file["target"]["keep-environment"]["output"]
    tag = output.partition("/me/cache:")[2].partition(",")[0]
    robot.put(f"me/cache:{tag}", config=ONBUILD)
    with pytest.raises(RosmlError, match=rf"cache:{tag} has ONBUILD"):
        robot.build(cache=robot.cache)


def test_a_tag_loses_no_platform(robot: Robot) -> None:
    """Whoever pulls it on the other one would get nothing."""
    for name in ("rosml/ros:jazzy", "me/robot:both"):
        robot.put(name, *BOTH)
    robot.put("me/robot:one", "linux/amd64")
    local = f"{robot.services.registry}/me/robot"
    inputs = {"image_name": local, "target": "run", "push": "true"}
    with pytest.raises(RosmlError, match=f"^{local}:both is for .*, and would be for linux/amd64 alone") as caught:
        robot.build(**inputs, image_tag="both", platform="amd64")
    assert "--platform linux/amd64,linux/arm64" in caught.value.remedy
    assert "--image-tag both-amd64" in caught.value.remedy and caught.value.exit_code == 2 and not robot.targets
    for tag, platform in (("one", "amd64"), ("new", "arm64")):
        robot.build(**inputs, image_tag=tag, platform=platform)
    with Registries() as registries:
        app_base.require_kept(registries, [f"{local}:{tag}" for tag in ("both", "one", "none")], BOTH[::-1])
        with pytest.raises(RosmlError, match="robot:one is for linux/amd64, and would be for linux/arm64 alone"):
            app_base.require_kept(registries, [f"{local}:one"], BOTH[1:])
    robot.put("me/robot:latest", *BOTH)
    with pytest.raises(RosmlError, match="robot:latest is for"):
        robot.build(**inputs, image_tag="new", platform="amd64", enable_push_as_latest="true")


@pytest.mark.parametrize(
    "user",
    [
        "a\nRUN touch /x",
        "-x",
        "a:b:c",
    ],
)
def test_a_user_of_a_base_image_is_a_name(services: Services, user: str) -> None:
    put(services, "rosml/ros:jazzy", config={"User": user})
    with pytest.raises(RosmlError, match="starts as a user of no name"):
        app_base.find("ros:jazzy", services, (NATIVE,))


@pytest.mark.parametrize("kind", [tarfile.XHDTYPE, tarfile.GNUTYPE_LONGNAME])
def test_a_header_of_an_archive_takes_no_memory(kind: bytes, tmp_path: Path) -> None:
    """A few MB of gzip hold gigabytes of it."""
    header = tarfile.TarInfo("a")
    header.type, header.size = kind, 300 << 20
    packer = zlib.compressobj(1, wbits=31)
    blocks = [packer.compress(block) for block in (header.tobuf(), *[bytes(1 << 20)] * 300)]
    tracemalloc.start()
    with pytest.raises(RosmlError, match="a header has"):
        rosdep_index.unpack(b"".join([*blocks, packer.flush()]), tmp_path / "out", "the lists")
    assert tracemalloc.get_traced_memory()[1] < 50 << 20
    tracemalloc.stop()
