"""An app before anything is built: its base image, its manifests and requests, its bake file, and what tests said."""

from __future__ import annotations

import contextlib
import dataclasses
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import time
import tracemalloc
import types
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner
from test_report import APP, DEPENDENCIES

from fakes import archives
from fakes.http_registry import StandIn
from fakes.stubs import script_of_a_build
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.cli import main
from rosml.cli.containerize import containerize
from rosml.containerize import inputs as app_inputs
from rosml.containerize import lock, names
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image import rosdep_index
from rosml.containerize.build import app as build
from rosml.containerize.build import bake_file as app_bake_file
from rosml.containerize.build import dev_folder as desk
from rosml.containerize.build import junit, stage_cache
from rosml.containerize.build.result import Result, ShellImage
from rosml.containerize.packages import manifest, workspace
from rosml.containerize.sources import fetch as sources
from rosml.images.builds import variables
from rosml.images.builds.base_images import native_architecture
from rosml.images.image_set import load
from rosml.machine import buildx, git
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registries, Registry

PACKAGE = "<package><name>{}</name></package>"


@pytest.fixture
def services(stand_in: StandIn, tmp_path: Path) -> Services:
    state = tmp_path / "rosml"
    return Services(state, stand_in.address, ("buildx",), "rosml", "buildkitd", None, "", "", bases=())


def put(
    services: Services,
    name: str,
    *platforms: str,
    labels: Mapping[str, str] | None = None,
    user: str = "",
    starts: Mapping[str, object] | None = None,
    **variables: str,
) -> str:
    """An image for some platforms; gives the digest of its index."""
    repository, _, tag = name.partition(":")
    with Registry(services.registry) as client:
        entries = []
        for platform in platforms:
            system, architecture = platform.split("/")
            config = {
                "os": system,
                "architecture": architecture,
                "config": {
                    "Env": [f"{name}={value}" for name, value in variables.items()],
                    "Labels": labels,
                    "User": user,
                    **(starts or {}),
                },
            }
            blob = oci.encoded(config)
            client.put_blob(repository, blob)
            manifest = oci.encoded(
                {"schemaVersion": 2, "mediaType": oci.IMAGE, "config": oci.descriptor(oci.CONFIG, blob), "layers": []}
            )
            client.put_manifest(repository, "", manifest)
            facts = {"os": system, "architecture": architecture}
            entries.append({**oci.descriptor(oci.IMAGE, manifest), "platform": facts})
        index = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
        return client.put_manifest(repository, tag, index, oci.INDEX)


# ---- The base image --------------------------------------------------------------------------------------------------


def test_a_short_name_is_the_local_registrys_or_docker_hubs(services: Services) -> None:
    local = services.registry
    assert app_base.candidates("ros-tf:jazzy", services) == (
        f"{local}/rosml/ros-tf:jazzy",
        "docker.io/library/ros-tf:jazzy",
    )
    assert app_base.candidates("me/robot", services)[-1] == "docker.io/me/robot"
    assert app_base.candidates("ghcr.io/me/robot:1", services) == ("ghcr.io/me/robot:1",)
    assert app_base.candidates("localhost/robot", services) == ("localhost/robot",)


def test_a_base_image_is_read_and_held_by_its_digest(services: Services) -> None:
    digest = put(services, "rosml/ros:jazzy", "linux/amd64", "linux/arm64", ROS_DISTRO="jazzy")
    found = app_base.find(f"{services.registry}/rosml/ros:jazzy", services, ("linux/arm64",))
    assert found.reference == f"{services.registry}/rosml/ros@{digest}"
    assert found.environment == {"ROS_DISTRO": "jazzy"}
    with pytest.raises(RosmlError, match=r"rosml/ros:jazzy is not for linux/riscv64"):
        app_base.find(f"{services.registry}/rosml/ros:jazzy", services, ("linux/amd64", "linux/riscv64"))
    with pytest.raises(RosmlError, match="there is no image") as caught:
        app_base.find(f"{services.registry}/rosml/ros:jazy", services, ("linux/amd64",))
    assert "rosml list" in caught.value.remedy and "did you mean 'jazzy'?" in caught.value.remedy
    with pytest.raises(RosmlError, match="there is no image") as caught:
        app_base.find(f"{services.registry}/rosml/ros:humble-base", services, ("linux/amd64",))
    assert caught.value.remedy == "build it first: rosml image humble-base"


def test_debians_image_if_docker_hub_does_not_answer(
    services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The builder has it from the local registry, and people call it as ever."""
    monkeypatch.setenv("HTTPS_PROXY", "http://127.0.0.1:1")
    monkeypatch.setattr(time, "sleep", lambda _seconds: None)
    monkeypatch.delenv("OS_BOOKWORM", raising=False)
    digest = put(services, "library/debian:bookworm", "linux/amd64")
    made = tmp_path / "bases"
    made.write_text(f'#!/bin/sh\necho \'{{"reference": "docker.io/library/debian:bookworm@{digest}"}}\'\n')
    made.chmod(0o755)
    behind = dataclasses.replace(services, bases=(str(made),))
    for pinned in ("", digest):
        found = app_base.find("debian:bookworm", behind, ("linux/amd64",), pinned)
        assert (found.name, found.reference) == (
            "docker.io/library/debian:bookworm",
            f"docker.io/library/debian@{digest}",
        )
    for name, machine in (("debian:bookwrom", behind), ("debian:bookworm", services)):
        with pytest.raises(RosmlError, match=f"there is no image {name} in the local registry, and docker.io: "):
            app_base.find(name, machine, ("linux/amd64",))


OURS = {"io.rosml.distribution": "jazzy", "io.rosml.runtime": "base-run"}
STACK = {**OURS, "io.rosml.stack": "cpu"}
SPELLED = {**STACK, "io.rosml.component": "base", "org.opencontainers.image.version": "jazzy-base-cpu-tf2.20.0"}


@pytest.mark.parametrize(
    ("name", "labels", "runtime"),
    [
        ("ghcr.io/me/ros:jazzy", OURS, "ghcr.io/me/ros:jazzy-base-run"),
        ("127.0.0.1:5000/ros-tf:jazzy-desktop-cpu", STACK, "127.0.0.1:5000/ros-tf:jazzy-base-run-cpu"),
        ("ghcr.io/me/ros:jazzy-base-20261124", OURS, "ghcr.io/me/ros:jazzy-base-run-20261124"),
        ("ghcr.io/me/ros:jazzy", {"io.rosml.distribution": "jazzy"}, ""),
        ("ghcr.io/me/ros-tf:jazzy-base-cpu-tf2.20.0", SPELLED, "ghcr.io/me/ros-tf:jazzy-base-run-cpu-tf2.20.0"),
        ("ghcr.io/me/ros-tf:jazzy-base-cpu", SPELLED, "ghcr.io/me/ros-tf:jazzy-base-run-cpu"),
        ("ghcr.io/me/ros@sha256:0123", OURS, "ghcr.io/me/ros:jazzy-base-run"),
        ("debian:bookworm", {}, ""),
    ],
)
def test_a_base_image_says_which_one_has_no_compilers(name: str, labels: dict[str, str], runtime: str) -> None:
    assert app_base.runtime(app_base.Base(name, "sha256:1", {}, labels)) == runtime


def test_a_slim_image_is_of_the_same_versions() -> None:
    labels = {
        "io.rosml.component": "base",
        "io.rosml.runtime": "base-run",
        "io.rosml.torch": "2.10.0",
        "io.rosml.os": "x",
    }
    other = {"io.rosml.component": "base-run", "io.rosml.torch": "2.11.0", "io.rosml.os": "x", "io.rosml.cuda": "12"}
    assert app_base.differing(app_base.Base("a", "", {}, labels), app_base.Base("b", "", {}, other)) == [
        "cuda",
        "torch",
    ]


@pytest.mark.parametrize(
    "name", ["localhost:5000/ros:1", "localhost:5000/ros@sha256:0", "localhost:5000/ros:1@sha256:0"]
)
def test_a_base_image_is_named_by_its_digest_alone(name: str) -> None:
    assert app_base.Base(name, "sha256:1", {}).reference == "localhost:5000/ros@sha256:1"


def test_a_base_image_of_a_lock_file_is_found_wherever_its_tag_is(services: Services) -> None:
    platform = f"linux/{native_architecture()}"
    first = put(services, "rosml/ros:jazzy", platform, ROS_DISTRO="jazzy", DAY="1")
    newer = put(services, "rosml/ros:jazzy", platform, ROS_DISTRO="jazzy", DAY="2")
    assert app_base.find("ros:jazzy", services, ()).digest == newer
    found = app_base.find("ros:jazzy", services, (), first)
    assert (found.digest, found.environment["DAY"], found.name) == (first, "1", f"{services.registry}/rosml/ros:jazzy")


@pytest.mark.parametrize("short", [True, False])
def test_a_wrong_digest_is_told_with_the_one_that_the_tag_has(services: Services, short: bool) -> None:
    digest = put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    place, wrong = f"{services.registry}/rosml/ros", f"sha256:{'0' * 64}"
    name = "ros" if short else place

    def said(text: str) -> tuple[str, str]:
        with pytest.raises(RosmlError) as caught:
            app_base.find(text, services, ())
        return caught.value.message, caught.value.remedy

    message, remedy = said(f"{name}:jazzy@{wrong}")
    assert message == f"{place}:jazzy is there, but not with the digest {wrong}"
    assert remedy == f"take {name}:jazzy, or the digest that it has now: {name}:jazzy@{digest}"
    message, remedy = said(f"{name}@{wrong}")
    assert message == f"{place} has no image with the digest {wrong}" and remedy == "take one of its tags: jazzy"
    message, remedy = said(f"{name}:typo@{wrong}")
    assert message.startswith(f"there is no image {name}:typo@{wrong}") and "check its name and its digest" in remedy
    assert (f"(looked for {place}:typo@{wrong}, docker.io/library/ros:typo@{wrong}); docker.io: " in message) is short


def test_an_image_that_docker_alone_has(services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where Docker builds; another builder could not have it."""
    facts = {"Id": "sha256:7", "Os": "linux", "Architecture": "amd64", "Config": {"Env": ["ROS_DISTRO=jazzy"]}}
    docker = tmp_path / "docker"
    docker.write_text(f"#!/bin/sh\necho '{json.dumps([facts])}'\n")
    docker.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    name = f"{services.registry}/mine:1"
    builds = dataclasses.replace(services, builder_kind="user")
    for wanted in ("", "sha256:7"):
        found = app_base.find(name, builds, ("linux/amd64",), wanted)
        assert (found.reference, found.digest, found.environment) == (name, "sha256:7", {"ROS_DISTRO": "jazzy"})
    with pytest.raises(RosmlError):  # a lock file names another one
        app_base.find(name, builds, ("linux/amd64",), "sha256:8")
    with pytest.raises(RosmlError, match="there is no image"):
        app_base.find(name, services, ("linux/amd64",))
    docker.write_text(f"#!/bin/sh\necho '{json.dumps([{**facts, 'Config': {'OnBuild': ['RUN x']}}])}'\n")
    with pytest.raises(RosmlError, match="mine:1 has ONBUILD"):
        app_base.find(name, builds, ("linux/amd64",))


FETCH = {"OnBuild": ["RUN true", "ADD http://127.0.0.1:8099/secret \n /"]}
"""Settings of an image from which each build reads from this machine's own network, by the builder itself."""


AMD64, ARM64, I386 = ({"os": "linux", "architecture": name} for name in ("amd64", "arm64", "386"))


@pytest.mark.parametrize("platform", [AMD64, ARM64, I386, None], ids=["twice", "another", "in its place", "unsaid"])
def test_a_base_image_with_onbuild_is_refused(services: Services, platform: dict[str, str] | None) -> None:
    """Whichever image of an index a builder may take: a repository names the base image."""
    put(services, "rosml/ros:plain", "linux/amd64", ROS_DISTRO="jazzy")
    put(services, "rosml/ros:fetch", "linux/amd64", starts=FETCH, ROS_DISTRO="jazzy")
    with Registry(services.registry) as client:
        [plain, fetch] = (client.manifest("rosml/ros", tag) for tag in ("plain", "fetch"))
        assert plain and fetch
        [fetching] = fetch.content["manifests"]
        entries = [*plain.content["manifests"], {**fetching, "platform": platform}]
        client.put_manifest("rosml/ros", "both", {**plain.content, "manifests": entries}, oci.INDEX)
    needed = ("linux/amd64", "linux/arm64") if platform == ARM64 else ("linux/amd64",)
    for tag in ("fetch", "both"):
        with pytest.raises(RosmlError, match=r"has ONBUILD.*: RUN true, ADD http://127.0.0.1:8099/secret /$") as caught:
            app_base.find(f"{services.registry}/rosml/ros:{tag}", services, needed[: 1 if tag == "fetch" else 2])
        assert caught.value.exit_code == 2 and "name an image without ONBUILD" in caught.value.remedy


def test_a_stage_with_onbuild_is_refused(repository: Path, services: Services, calls: list[dict[str, Any]]) -> None:
    """Whoever may push to the cache knows all that decides a stage's tag."""
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    given = {"base_image": "ros:jazzy", "command": "true", "cache": f"{services.registry}/me/cache"}
    app(repository, services, **given).build()
    [file] = services.state.rglob("bake.json")
    [output] = json.loads(file.read_text())["target"]["keep-environment"]["output"]
    tag = output.partition("/me/cache:")[2].partition(",")[0]
    put(services, f"me/cache:{tag}", f"linux/{native_architecture()}", starts=FETCH)
    with pytest.raises(RosmlError, match=rf"cache:{tag} has ONBUILD"):
        app(repository, services, **given).build()


def test_a_tag_loses_no_platform(repository: Path, services: Services, calls: list[dict[str, Any]]) -> None:
    """Whoever pulls it on the other one would get nothing."""
    native, other = "linux/amd64", "linux/arm64"
    for name in ("rosml/ros:jazzy", "me/robot:both"):
        put(services, name, native, other, ROS_DISTRO="jazzy")
    put(services, "me/robot:one", native)
    local = f"{services.registry}/me/robot"
    given = {"base_image": "ros:jazzy", "command": "x", "image_name": local, "target": "run", "push": "true"}
    with pytest.raises(RosmlError) as caught:
        app(repository, services, **given, image_tag="both", platform="amd64").build()
    assert caught.value.message.startswith(
        f"{local}:both is for linux/amd64, linux/arm64, and would be for linux/amd64 alone"
    )
    assert (
        "--platform linux/amd64,linux/arm64" in caught.value.remedy and "--image-tag both-amd64" in caught.value.remedy
    )
    assert caught.value.exit_code == 2 and not calls
    for tag, platform in (("one", "amd64"), ("new", "arm64")):
        app(repository, services, **given, image_tag=tag, platform=platform).build()
    with Registries() as registries:
        app_base.require_kept(registries, [f"{local}:both", f"{local}:one", f"{local}:none"], (other, native))
        with pytest.raises(RosmlError, match="robot:one is for linux/amd64, and would be for linux/arm64 alone"):
            app_base.require_kept(registries, [f"{local}:one"], (other,))
    with pytest.raises(RosmlError, match=r"robot:latest is for"):
        latest = {"image_tag": "new", "platform": "amd64"}
        put(services, "me/robot:latest", native, other)
        app(repository, services, **given, **latest, enable_push_as_latest="true").build()


# ---- Sources ---------------------------------------------------------------------------------------------------------


def test_manifests_are_those_that_colcon_finds(tmp_path: Path) -> None:
    repository = tmp_path / "robot"
    for path in ("a", "a/inner", "b/c", "hidden/d", ".git/e"):
        (repository / path).mkdir(parents=True)
        (repository / path / "package.xml").write_text(PACKAGE.format(path[-1]))
    (repository / "hidden/COLCON_IGNORE").touch()
    (repository / "a/node.cpp").touch()
    for path in ("a", "b", "hidden"):
        (repository / path / "CMakeLists.txt").write_text("# its name\nproject(b CXX)\nadd_library(b b.cpp)\n")
    (repository / "CMakeLists.txt").symlink_to("/opt/ros/noetic/share/catkin/cmake/toplevel.cmake")
    (tmp_path / "none").mkdir()
    counts = workspace.write_manifests({"target": repository, "upstream": tmp_path / "none"}, tmp_path / "out")
    assert counts == {"target": 2, "upstream": 0}
    written = sorted(
        str(path.relative_to(tmp_path / "out")) for path in (tmp_path / "out").rglob("*") if path.is_file()
    )
    assert written == [
        "target/a/package.xml",
        "target/b/CMakeLists.txt",
        "target/b/c/package.xml",
        "target/hidden/COLCON_IGNORE",
    ]
    assert (tmp_path / "out/target/b/CMakeLists.txt").read_text() == "project(b)\n", (
        "nothing else decides what is installed"
    )
    with pytest.raises(RosmlError, match=r"there is no package\.xml"):
        workspace.write_manifests({"target": tmp_path / "none"}, tmp_path / "out")


def test_packages_behind_links_are_those_that_colcon_finds(tmp_path: Path) -> None:
    """Once each, and within the repository; a link that leads out is named."""
    repository, outside, said = tmp_path / "robot", tmp_path / "outside", list[str]()
    for path in (repository / "third_party/tp", repository / "src/main", repository / ".git/secret", outside / "x"):
        path.mkdir(parents=True)
        (path / "package.xml").write_text(PACKAGE.format(path.name))
    (repository / "third_party/COLCON_IGNORE").touch()
    for name, leads in (
        ("tp", "../third_party/tp"), ("again", repository / "third_party/tp"), ("up", ".."), ("out", outside),
        ("nowhere", "nothing"), ("git", "../.git"),
    ):  # fmt: skip
        (repository / "src" / name).symlink_to(leads)
    counts = workspace.write_manifests({"target": repository}, tmp_path / "out", said.append)
    assert counts == {"target": 2} and list(workspace.names(repository)) == ["tp", "main"]
    assert sorted(line.partition(" leads")[0] for line in said) == [
        f"{repository}/src/{name}" for name in ("git", "out")
    ]
    written = {str(path.relative_to(tmp_path / "out/target")) for path in (tmp_path / "out/target").rglob("*.xml")}
    assert written == {"src/again/package.xml", "src/main/package.xml"}

    workspace.stage(repository, tmp_path / "staged")
    assert os.readlink(tmp_path / "staged/src/again") == "../third_party/tp", "there is no such path in a step"
    assert os.readlink(tmp_path / "staged/src/out") == str(outside)


def test_a_package_behind_a_link_can_be_left_out(tmp_path: Path, catkin_pkg: None) -> None:
    script = script_of_a_build("containerize/manifests.py")
    for path in ("src/target/third_party/tp", "src/target/main", "outside"):
        (tmp_path / path).mkdir(parents=True)
        (tmp_path / path / "package.xml").write_text(PACKAGE.format(path.rpartition("/")[2]))
    (tmp_path / "src/target/third_party/COLCON_IGNORE").touch()
    (tmp_path / "src/target/tp").symlink_to("third_party/tp")
    (tmp_path / "src/target/out").symlink_to(tmp_path / "outside")
    assert sorted(script.all_packages(tmp_path / "src")) == ["main", "tp"]
    (tmp_path / "left_out").write_text("tp\n")
    script.main(tmp_path / "src", tmp_path / "left_out")
    assert sorted(script.all_packages(tmp_path / "src")) == ["main"]


@pytest.fixture
def catkin_pkg(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a base image has: its parser of manifests, as far as names go."""
    package = types.ModuleType("catkin_pkg.package")

    def parse_package(path: str) -> Any:
        return types.SimpleNamespace(name=ElementTree.parse(path).findtext("name"))

    package.parse_package = parse_package  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "catkin_pkg", types.ModuleType("catkin_pkg"))
    monkeypatch.setitem(sys.modules, "catkin_pkg.package", package)


def requests(folder: Path, given: dict[str, str], environment: dict[str, str]) -> dict[str, str]:
    values = app_inputs.values(given, folder, {})
    out = folder.parent / "requests"
    workspace.write_requests(values, folder, folder.parent / "upstream", environment, out)
    return {path.name: path.read_text() for path in out.iterdir()}


def test_what_a_repository_asks_for_is_written_down(tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    (folder / "docker").mkdir(parents=True)
    (folder / "docker/additional-debs.txt").write_text("htop  # to look around\nnano=7.2-1\n")
    (folder / "docker/custom.sh").write_text("echo done")
    given = {"rmw-implementation": "rmw_cyclonedds_cpp"}
    found = requests(folder, given, {"ROS_VERSION": "2", "ROS_DISTRO": "jazzy"})
    assert found.pop("apt") == "htop\nnano=7.2-1\nros-jazzy-rmw-cyclonedds-cpp\n"
    assert found.pop("after.sh") == "echo done\n"
    assert set(found.values()) == {""}
    assert requests(folder, given, {"ROS_VERSION": "1", "ROS_DISTRO": "noetic"})["apt"] == "htop\nnano=7.2-1\n"


def test_a_file_that_is_named_must_be_there(tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    with pytest.raises(RosmlError, match=r"additional-debs-file: there is no file debs\.txt"):
        requests(tmp_path / "robot", {"additional-debs-file": "debs.txt"}, {})


def test_what_is_no_package_of_apt_is_refused(tmp_path: Path) -> None:
    (tmp_path / "robot/docker").mkdir(parents=True)
    (tmp_path / "robot/docker/additional-debs.txt").write_text("htop; rm -rf /\n")
    with pytest.raises(RosmlError, match="'htop; rm -rf /' is no package of apt"):
        requests(tmp_path / "robot", {}, {})


def link_out(place: Path) -> None:
    place.symlink_to("/etc")


def link_to_nothing(place: Path) -> None:
    place.symlink_to("nothing")


def link_to_itself(place: Path) -> None:
    place.symlink_to(place.name)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (link_out, "leads out of"),
        (link_to_nothing, "a link to nothing"),
        (link_to_itself, "a link to nothing"),
        (Path.mkdir, "a folder instead of a file"),
    ],
)
@pytest.mark.parametrize("recursive", ["true", "false"])
def test_what_a_file_of_the_repository_is_not_is_said(
    make: Callable[[Path], None], says: str, recursive: str, tmp_path: Path
) -> None:
    (tmp_path / "robot/docker").mkdir(parents=True)
    make(tmp_path / "robot/docker/custom.sh")
    given = {"enable-recursive-after-dependency-installation-script": recursive}
    with pytest.raises(RosmlError, match=f"docker/custom.sh:? {says}") as caught:
        requests(tmp_path / "robot", given, {})
    assert caught.value.exit_code == 2 and caught.value.remedy


def test_nothing_outside_a_repository_is_read(tmp_path: Path) -> None:
    repository = tmp_path / "robot"
    (repository / "arm").mkdir(parents=True)
    (tmp_path / "package.xml").write_text(PACKAGE.format("arm"))
    (repository / "arm/package.xml").symlink_to("../../package.xml")
    with pytest.raises(RosmlError, match=r"arm/package\.xml leads out of"):
        workspace.write_manifests({"target": repository}, tmp_path / "out")
    (repository / "files").symlink_to("..")
    with pytest.raises(RosmlError, match=r"robot/files leads out of"):
        workspace.additional_files("files", repository)
    with pytest.raises(RosmlError, match=r"leads out of"):
        requests(repository, {"additional-debs-file": "../package.xml"}, {})


@pytest.mark.parametrize("place", ["docker/custom.sh", "docker/additional-debs.txt", "robot/package.xml"])
@pytest.mark.parametrize("secret", [".git/config", ".env"])
def test_no_link_brings_what_is_secret_into_a_build(place: str, secret: str, tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    for name in (".git/config", ".env", place):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / ".git/config").write_text("[secret]\n")
    (folder / ".env").write_text("SECRET=1\n")
    (folder / place).symlink_to(os.path.relpath(folder / secret, (folder / place).parent))
    with pytest.raises(RosmlError, match=rf"{place} leads to {secret}, which gets into no image") as caught:
        requests(folder, {}, {})
        workspace.write_manifests({"target": folder}, tmp_path / "out")
    assert caught.value.exit_code == 2 and caught.value.remedy


@pytest.mark.parametrize(("target", "given"), [("..", {}), ("", {"additional_files_dir": "."}), ("../.git", {})])
def test_additional_files_have_nothing_secret(
    target: str, given: dict[str, str], repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    for name in (".git/config", "src/sub/.git", ".env", "docker/hello"):
        (repository / name).parent.mkdir(parents=True, exist_ok=True)
        (repository / name).write_text("SECRET=1\n" if "." in name else "hello")
    if target:
        (repository / "docker/additional-files").symlink_to(target)
    try:
        app(repository, services, base_image="ros:jazzy", command="true", **given).build()
    except RosmlError as error:
        assert target == "../.git" and "leads to .git" in error.message
        return
    given_to_builder = Path(calls[0]["contexts"]["additional"])
    found = {path.name for path in given_to_builder.rglob("*")}
    assert "hello" in found and found.isdisjoint((".git", ".env"))


def test_an_install_space_is_never_read_through_a_link(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Code of the packages may leave one; the step that reads it is rosml's own, and says what is in the images."""
    monkeypatch.syspath_prepend(str(ROOT / "components/containerize"))
    script = script_of_a_build("containerize/app_files.py")
    names = ("base", "runtime", "environment", "workspace", "outside")
    for name in (*names, "workspace/docker-ros/ws", "elsewhere"):
        (tmp_path / name).mkdir(parents=True, exist_ok=True)
    (tmp_path / "elsewhere/file").write_text("x")
    (tmp_path / "workspace/docker-ros/ws/install").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(SystemExit, match="error: /docker-ros/ws/install is no folder"):
        script.main(*(tmp_path / name for name in names), tmp_path / "out")
    assert not [path for path in (tmp_path / "out").rglob("*") if path.is_file()]


def test_no_file_is_copied_below_a_link(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "components/containerize"))
    script = script_of_a_build("containerize/app_files.py")
    (tmp_path / "source/a").mkdir(parents=True)
    (tmp_path / "source/a/file").write_text("x")
    (tmp_path / "source/b").symlink_to("a")
    (tmp_path / "out").mkdir()
    (tmp_path / "out/c").symlink_to(tmp_path / "source/a")
    (tmp_path / "source/c").mkdir()
    (tmp_path / "source/c/new").write_text("x")
    for path in ("b/file", "c/new"):
        with pytest.raises(SystemExit, match="is no folder"):
            script.copy(tmp_path / "source", path, tmp_path / "out")
    assert sorted(path.name for path in (tmp_path / "source/a").iterdir()) == ["file"]


@pytest.mark.parametrize("name", [".env", "containerize.lock", "docker/additional-debs.txt", "a/package.xml"])
def test_a_pipe_in_a_folder_is_said(name: str, tmp_path: Path) -> None:
    """Whoever reads it would wait for ever."""
    (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
    os.mkfifo(tmp_path / name)
    with pytest.raises(RosmlError, match=r"neither a file nor a folder|it is no file") as caught:
        app_inputs.values({}, tmp_path, {})
        lock.read(tmp_path / "containerize.lock", tmp_path)
        requests(tmp_path, {}, {})
        workspace.write_manifests({"target": tmp_path}, tmp_path / "out")
    assert caught.value.exit_code == 2 and caught.value.remedy


def test_variables_are_read_through_no_link(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("ROS_DISTRO=secret\n")
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/.env").symlink_to("../secret")
    with pytest.raises(RosmlError, match="it is a link"):
        app_inputs.values({}, tmp_path / "robot", {})


def test_a_lock_file_is_not_written_into_gits_folder(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    with pytest.raises(RosmlError, match=r"leads to \.git/index\.lock"):
        lock.place(tmp_path, ".git/index.lock", renew=True)


@pytest.mark.parametrize("kind", [tarfile.XHDTYPE, tarfile.XGLTYPE, tarfile.GNUTYPE_LONGNAME, tarfile.GNUTYPE_LONGLINK])
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


def test_additional_files_are_a_folder(tmp_path: Path) -> None:
    assert workspace.additional_files("docker/additional-files", tmp_path) is None
    assert workspace.additional_files("", tmp_path) is None
    (tmp_path / "files").touch()
    with pytest.raises(RosmlError, match="files: a file instead of a folder"):
        workspace.additional_files("files", tmp_path)
    with pytest.raises(RosmlError, match="additional-files-dir: there is no folder file in"):
        workspace.additional_files("file", tmp_path)


def test_no_file_is_one_that_is_named_empty(tmp_path: Path) -> None:
    (tmp_path / "robot/docker").mkdir(parents=True)
    (tmp_path / "robot/docker/custom.sh").write_text("true")
    assert requests(tmp_path / "robot", {"after-dependency-installation-script": ""}, {})["after.sh"] == ""


SLIM = dict(APP)
FAILED = junit.Tests(2, 0, ("user: a",))


# ---- The build -------------------------------------------------------------------------------------------------------


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    folder = tmp_path / "Robot"
    (folder / "src/robot").mkdir(parents=True)
    (folder / "src/robot/package.xml").write_text(PACKAGE.format("robot"))
    return folder


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, Any]]:
    """What the builder is told, target by target; it leaves a report, and no test."""
    seen: list[dict[str, Any]] = []

    def run(services: Services, bake: buildx.Bake) -> tuple[None, dict[str, str]]:
        content = json.loads(bake.file.read_text())
        wanted = content["target"]
        if bake.target == "system":
            seen.append({"name": bake.target, **wanted["system"]})
            archives.write(Path(wanted["system"]["output"][0].partition("dest=")[2]), NOBLE)
            return None, {}
        seen.append({"name": bake.target, "variables": bake.variables, **(wanted.get(bake.target) or wanted["report"])})
        if bake.target == "packages":
            said = {"dependencies.json": DEPENDENCIES, "app.json": APP, "slim.json": SLIM}
            left = {name: json.dumps(content) for name, content in said.items()}
            archives.write(Path(wanted["report"]["output"][0].partition("dest=")[2]), left)
            if "dest=" in wanted.get("results", {}).get("output", [""])[0]:
                archives.write(Path(wanted["results"]["output"][0].partition("dest=")[2]), {})
        return None, {"containerimage.digest": "sha256:1"}

    def run_all(services: Services, bake: buildx.Bake) -> tuple[None, dict[str, dict[str, str]]]:
        one = {target: dataclasses.replace(bake, target=target) for target in (bake.target, *bake.beside)}
        return None, {target: run(services, call)[1] for target, call in one.items()}

    monkeypatch.setattr(buildx, "run_all", run_all)
    monkeypatch.setattr(sources, "fetch", lambda *_, **__: [])
    return seen


class App:
    """A call that a test makes."""

    def __init__(self, *args: Any, **options: Any) -> None:
        self.call = build.new_call(*args, **options)
        self.report = self.call.reports

    def build(self) -> Result:
        return build.build_images(self.call)


def app(folder: Path, services: Services, **given: str) -> App:
    values = app_inputs.values({name.replace("_", "-"): value for name, value in given.items()}, folder, {})
    return App(folder, values, {}, services, lambda line: None)


def test_images_are_joined_after_the_report_is_read(
    repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    digest = put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    command = 'ros2 run robot "a $b" \\\n${HOME} %{x}'
    built = app(
        repository, services, base_image="ros:jazzy", command=command, rmw_implementation="rmw_zenoh_cpp"
    ).build()
    local = services.registry
    assert [image.reference for image in built.images] == [f"{local}/robot:latest", f"{local}/robot:latest-dev"]
    report, run, dev = calls
    assert report["contexts"]["base"] == f"docker-image://{local}/rosml/ros@{digest}"
    assert report["args"]["ROS_DISTRO"] == "jazzy"
    assert (run["name"], dev["name"]) == ("run", "dev")
    assert run["contexts"].keys() == {"base", "app"}, "the builder makes all contexts, also those that no line names"
    assert dev["contexts"].keys() == {"base", "workspace"}
    lines = run["dockerfile-inline"].splitlines()
    assert lines[:2] == ["FROM base", "COPY --link --from=app / /"]
    assert not [line for line in lines if line.startswith("RUN")]
    assert "ENV DEFAULT_CMD=$${APP_DEFAULT_CMD}" in lines, "bake makes one $ of it"
    assert run["args"]["APP_DEFAULT_CMD"] == command.replace("${", "$${").replace("%{", "%%{")
    assert run["args"]["APP_RMW_IMPLEMENTATION"] == "rmw_zenoh_cpp"
    assert run["labels"][app_bake_file.BASE_DIGEST] == digest
    assert dev["dockerfile-inline"].startswith("FROM workspace\n")


def test_an_image_to_work_in_is_the_same_for_each_commit(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is no reason to leave a container that runs. The packages are neither built nor tested for it."""
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    seen = []
    for commit in ("a", "b"):
        monkeypatch.setattr(git, "commit", lambda *_, commit=commit: git.Commit(commit, ord(commit)))
        said = app_inputs.values({"base-image": "ros:jazzy", "command": "true"}, repository, {})
        values = desk.image_values(dataclasses.replace(said, image_name="ghcr.io/me/robot", push=True), repository)
        made = build.build_shell_image(build.new_call(repository, values, {}, services, lambda line: None))
        assert made == ShellImage(f"{services.registry}/{desk.image_name(repository)}@sha256:1", False, None)
        seen.append(calls.pop())
    assert calls == [] and seen[0] == seen[1]
    assert seen[0]["name"] == names.DESK and seen[0]["dockerfile-inline"].startswith(f"FROM {names.DESK}\n")
    assert "APP_DEFAULT_CMD" not in seen[0]["args"]


def test_a_name_to_leave_out_that_no_package_has_is_a_warning(
    repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    """Unless a script may make such a package."""
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    (repository / "docker").mkdir()
    (repository / "docker/blacklisted-packages.txt").write_text("robott # once\nrobot\nof_another_time\n")
    values = app_inputs.values({"base-image": "ros:jazzy", "command": "true", "target": "run"}, repository, {})
    said: list[str] = []
    App(repository, values, {}, services, said.append).build()
    told = "no package is called {}, which is to be left out; {}"
    assert [line for line in said if "left out" in line] == [
        told.format("robott", "did you mean 'robot'?"),
        told.format("of_another_time", "known: robot"),
    ]
    (repository / "docker/before_dependency_identification.sh").write_text("true\n")
    said.clear()
    App(repository, values, {}, services, said.append).build()
    assert not [line for line in said if "left out" in line]


def test_submodules_that_nobody_fetched_are_named(
    repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    """As `git clone` alone leaves them: a package in them is one that rosdep does not know."""
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    said: list[str] = []
    (repository / "src/empty").mkdir()
    sections = "".join(
        f'[submodule "{name}"]\n\tpath = {name}\n' for name in ("src/robot", "src/empty", "src/gone away")
    )
    (repository / ".gitmodules").write_text(f"{sections}\turl = ../x\n")
    values = app_inputs.values({"base-image": "ros:jazzy", "command": "true", "target": "run"}, repository, {})
    App(repository, values, {}, services, said.append).build()
    told = [line for line in said if "submodule" in line]
    remedy = "is not there: git submodule update --init --recursive"
    assert told == [f"the submodule {name} {remedy}" for name in ("src/empty", "src/gone away")]


def test_files_of_git_lfs_that_nobody_fetched_are_named(
    repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    """As `git clone` leaves them where git-lfs is not installed: a mesh is a line of text then."""
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    said: list[str] = []
    for name in ("arm.dae", "leg.dae"):
        (repository / name).write_text("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 12345\n")
    (repository / "hand.dae").write_text("<COLLADA/>")
    values = app_inputs.values({"base-image": "ros:jazzy", "command": "true", "target": "run"}, repository, {})
    App(repository, values, {}, services, said.append).build()
    assert not [line for line in said if "Git LFS" in line], "a test of something that reads pointers, perhaps"
    (repository / ".gitattributes").write_text("*.dae filter=lfs diff=lfs merge=lfs -text\n")
    App(repository, values, {}, services, said.append).build()
    told = "arm.dae and 1 file more of Git LFS: only a pointer is there, and gets into the images: git lfs pull"
    assert [line for line in said if "Git LFS" in line] == [told]


def test_the_number_of_compilers_is_no_part_of_what_a_step_is_made_from(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Who lowers it after a failure goes on from there."""
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    given = {"base_image": "ros:jazzy", "command": "true", "target": "run"}
    app(repository, services, **given).build()
    app(repository, services, **given, parallel_jobs="3").build()
    plain, limited = calls[0], calls[2]
    secret = "type=env,id=parallel-jobs,env=PARALLEL_JOBS"
    assert (secret in limited["secret"], secret in plain["secret"], limited["variables"]) == (
        True,
        False,
        {"PARALLEL_JOBS": "3"},
    )
    assert {**limited, "secret": []} == {**plain, "secret": [], "variables": limited["variables"]}


def test_scripts_that_run_code_of_packages_are_those_of_the_build() -> None:
    """Their output is not searched for reasons of ours. Those that colcon, tests or CMake run in."""
    dockerfile = (app_bake_file.SCRIPTS / "containerize/Dockerfile").read_text()
    called = set(re.findall(r"/run/(scripts/containerize/\w+\.sh)(?= \w+$| /tests)", dockerfile, re.M))
    runs = {name for name in called if re.search(r"^ *colcon (build|test)\b", _script(name), re.M)}
    assert runs == set(app_bake_file.FOREIGN)


def _script(name: str) -> str:
    return (app_bake_file.SCRIPTS / name.removeprefix("scripts/")).read_text()


def test_a_run_image_starts_from_its_packages_where_they_replace_some_of_the_base(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", user="robot:1000", ROS_DISTRO="jazzy")
    monkeypatch.setitem(APP, "replaced", ["libbar:amd64"])
    built = app(repository, services, base_image="ros:jazzy", command="true").build()
    lines = calls[1]["dockerfile-inline"].splitlines()
    assert lines[:3] == ["FROM runtime", "COPY --link --from=app / /", "USER robot:1000"], "as the base image starts"
    assert calls[1]["contexts"].keys() == {"base", "runtime", "app"}
    assert "libbar:amd64" in dict(built.summary())[""]


def test_a_slim_image_starts_from_the_base_image_without_compilers(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    platform = f"linux/{native_architecture()}"
    put(services, "rosml/ros:jazzy", platform, labels=OURS, ROS_DISTRO="jazzy")
    labels = {"io.rosml.distribution": "jazzy", "io.rosml.component": "base-run"}
    digest = put(services, "rosml/ros:jazzy-base-run", platform, labels=labels, ROS_DISTRO="jazzy")
    given = {"base_image": "ros:jazzy", "command": "true", "target": "run", "enable_slim": "true"}
    built = app(repository, services, **given).build()
    assert [image.reference for image in built.images] == [f"{services.registry}/robot:{tag}" for tag in TAGS]
    slim = calls[-1]
    assert slim["contexts"]["slim"] == f"docker-image://{services.registry}/rosml/ros@{digest}"
    assert slim["dockerfile-inline"].splitlines()[:2] == ["FROM slim", "COPY --link --from=slim-app / /"]
    assert slim["args"]["APP_DEFAULT_CMD"] == "true" and slim["labels"][app_bake_file.BASE_DIGEST] == digest
    assert calls[0]["target"] == "slim-report"

    monkeypatch.setitem(SLIM, "removed", ["usr/bin/less"])
    built = app(repository, services, **given, slim_image_name="small", slim_image_tag="1").build()
    assert calls[-1]["dockerfile-inline"].splitlines()[0] == "FROM slim-runtime"
    assert calls[-2]["dockerfile-inline"].splitlines()[0] == "FROM base"
    assert calls[-1]["tags"] == [f"{services.registry}/small:1"]
    assert "the slim one, of which its packages change 1 thing: usr/bin/less" in dict(built.summary())[""]


TAGS = ("latest", "latest-slim")


def test_no_slim_image_is_made_where_no_base_image_is_found(
    repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    """It is said. Where somebody names one, it is an error."""
    platform = f"linux/{native_architecture()}"
    put(services, "rosml/ros:jazzy", platform, labels=OURS, ROS_DISTRO="jazzy")
    put(services, "plain:1", platform, ROS_DISTRO="jazzy")
    said: list[str] = []
    local = services.registry
    for name, why in (
        ("ros:jazzy", f"there is no {local}/rosml/ros:jazzy-base-run"),
        (f"{local}/plain:1", f"{local}/plain:1 does not say which base image has no compilers"),
    ):
        given = {"base-image": name, "command": "true", "target": "run", "enable-slim": "true"}
        App(repository, app_inputs.values(given, repository, {}), {}, services, said.append).build()
        assert calls[-1]["name"] == "run"
        assert f"no slim image: {why}; name one with --slim-base-image" in said
    with pytest.raises(RosmlError, match="there is no image typo"):
        app(
            repository, services, base_image="ros:jazzy", command="x", enable_slim="true", slim_base_image="typo"
        ).build()


def test_tests_that_fail_in_the_slim_image_alone_are_named(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("rosml/ros:jazzy", "small:1"):
        put(services, name, f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    failures = {"results": (), "slim": ("robot: a.bad: no libfoo.so.1",)}
    monkeypatch.setattr(junit, "read", lambda folder: junit.Tests(3, 1, failures.get(folder.name, ())))
    with pytest.raises(RosmlError, match=r"1 of 3 tests failed in the slim image.*no image was made") as caught:
        app(
            repository,
            services,
            base_image="ros:jazzy",
            command="x",
            enable_slim="true",
            slim_base_image=f"{services.registry}/small:1",
        ).build()
    assert "robot: a.bad: no libfoo.so.1" in caught.value.message and "exec_depend" in caught.value.remedy
    assert [call["name"] for call in calls] == ["packages"]


def test_a_lock_file_that_is_written_anew_takes_nothing_from_a_cache(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    monkeypatch.setattr(stage_cache.Cache, "stages", lambda *_: pytest.fail("what is there may be old"))
    given = {"base-image": "ros:jazzy", "command": "true", "cache": f"{services.registry}/me/cache"}
    App(repository, app_inputs.values(given, repository, {}), {}, services, lambda _: None, renew=True).build()


def test_another_ros_than_the_base_images_is_not_used(
    repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    for name, said in (("humble", ["ROS_DISTRO=humble is not used: the base image has jazzy"]), ("jazzy", [])):
        given = {"base-image": "ros:jazzy", "command": "true", "ros-distro": name}
        told: list[str] = []
        App(repository, app_inputs.values(given, repository, {}), {}, services, told.append).build()
        assert [line for line in told if line.startswith("ROS_DISTRO")] == said


def test_a_lock_file_is_written_then_followed(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(APP, "apt", {"tree": "2.1"})
    platform = f"linux/{native_architecture()}"
    digest = put(services, "rosml/ros:jazzy", platform, ROS_DISTRO="jazzy")
    options = {"base_image": "ros:jazzy", "command": "true"}
    values = app_inputs.values({name.replace("_", "-"): value for name, value in options.items()}, repository, {})
    said: list[str] = []

    built = App(repository, values, {}, services, said.append, renew=True).build()
    assert (Path(calls[0]["contexts"]["requests"]) / "renewed").exists(), "no step of an earlier build counts"
    file = repository / "containerize.lock"
    assert dict(built.summary())["lock"] == str(file)
    label = calls[1]["labels"][app_bake_file.LOCK]
    put(services, "rosml/ros:jazzy", platform, ROS_DISTRO="jazzy", NEWER="1")
    calls.clear()
    again = App(repository, values, {}, services, said.append).build()
    report, run, _ = calls
    assert not (Path(report["contexts"]["requests"]) / "renewed").exists()
    assert report["contexts"]["base"].endswith(f"@{digest}") and run["labels"][app_bake_file.LOCK] == label
    requests = Path(report["contexts"]["requests"])
    assert (requests / "lock/amd64/apt").read_text() == "tree 2.1\n"
    assert not (Path(report["contexts"]["target"]) / "target/containerize.lock").exists(), "it is no source"
    assert again.lock_file == ""

    put(services, "small:1", platform, ROS_DISTRO="jazzy")
    slim = dataclasses.replace(values, enable_slim=True, slim_base_image=f"{services.registry}/small:1")
    with pytest.raises(RosmlError, match="the lock file has no slim image"):
        App(repository, slim, {}, services, said.append).build()

    file.write_text("<<<<<<< HEAD\n")
    App(repository, values, {}, services, said.append, renew=True).build()
    assert any("is no lock file" in text for text in said) and lock.read(file, repository), "what is damaged is mended"

    values = dataclasses.replace(values, base_image="ros:other")
    with pytest.raises(RosmlError, match="the lock file is of ros:jazzy, and not of ros:other"):
        App(repository, values, {}, services, said.append).build()


def test_packages_that_use_the_apps_are_tested_before_there_is_an_image(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    fetched: list[dict[str, Any]] = []

    def fetch(*_: object, **options: object) -> list[sources.Repository]:
        fetched.append(options)
        return []

    monkeypatch.setattr(sources, "fetch", fetch)
    tested = app(repository, services, base_image="ros:jazzy", command="true", downstream_workspace="uses.repos")
    with pytest.raises(RosmlError, match=r"there is no file uses\.repos"):
        tested.build()
    (repository.parent / "outside").write_text("repositories: {}\n")
    (repository / "link").symlink_to("../outside")
    for name in ("../outside", "link"):
        with pytest.raises(RosmlError, match=f"{name} leads out of"):
            app(repository, services, base_image="ros:jazzy", command="true", downstream_workspace=name).build()
    (repository / "uses.repos").write_text("repositories: {}\n")
    with pytest.raises(RosmlError, match=r"the repositories of uses\.repos have no package"):
        tested.build()
    fetched.clear()
    user = tested.report.parent / "downstream/user/package.xml"
    user.parent.mkdir(parents=True)
    user.write_text(PACKAGE.format("user"))
    monkeypatch.setattr(junit, "read", lambda folder: FAILED if folder.name == "downstream" else junit.Tests())
    with pytest.raises(
        RosmlError, match=r"1 of 2 tests failed in packages that use yours; no image was made\n    user: a"
    ):
        tested.build()
    [report] = calls
    assert report["args"]["DOWNSTREAM"] == "downstream-results"
    upstream, downstream = (call["options"] for call in fetched)
    assert upstream.without == downstream.file == "uses.repos" and not downstream.recursive
    calls.clear()
    options = {"base_image": "ros:jazzy", "command": "true", "downstream_workspace": "uses.repos"}
    with contextlib.suppress(RosmlError):
        app(repository, services, tests="false", **options).build()
    [file] = services.state.rglob("bake.json")
    untested = json.loads(file.read_text())
    assert untested["group"]["packages"]["targets"] == ["report", "results"]
    built = untested["target"]["results"]
    assert (built["target"], built["output"]) == ("downstream-built", ["type=cacheonly"]), "they are built all the same"


def test_a_relative_index_of_rosdep_is_one_of_the_folder(
    repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    (repository / "lists/rosdep").mkdir(parents=True)
    (repository / "lists/rosdep/own.yaml").write_text("a: {}\n")
    app(repository, services, base_image="ros:jazzy", command="true", rosdep_index="lists").build()
    assert (Path(calls[0]["contexts"]["rosdep"]) / "rosdep/own.yaml").read_text() == "a: {}\n"
    (repository / "lists/rosdep/secret.yaml").symlink_to("/etc/hostname")
    with pytest.raises(RosmlError, match=r"secret\.yaml leads out of"):
        app(repository, services, base_image="ros:jazzy", command="true", rosdep_index="lists").build()


def test_a_cache_that_knows_the_dependencies_is_asked_for_no_lists_of_rosdep(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    asked: list[str] = []
    monkeypatch.setattr(rosdep_index.Finder, "find", lambda _self, named, *_: asked.append(named))
    known: dict[str, str] = {}
    monkeypatch.setattr(stage_cache.Cache, "stages", lambda *_: known)
    given = {"base_image": "ros:jazzy", "command": "true", "cache": f"{services.registry}/me/cache"}
    app(repository, services, **given).build()
    known["identified"] = f"{services.registry}/me/cache@sha256:{'1' * 64}"
    app(repository, services, **given).build()
    assert asked == [""]
    app(repository, services, **given, rosdep_index="rosdep:1").build()
    assert asked == ["", "rosdep:1"], "its digest is a part of the key"


def test_a_stage_that_a_cache_has_lost_is_built_although_its_report_is_there(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Somebody pruned the registry."""
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    given = {"base_image": "ros:jazzy", "command": "true", "cache": f"{services.registry}/me/cache", "tests": "false"}
    there: set[str] = set()

    def found(_: stage_cache.Cache, keys: stage_cache.Keys) -> dict[str, str]:
        return {name: f"{services.registry}/me/cache@sha256:{'1' * 64}" for name in keys.stages if name in there}

    monkeypatch.setattr(stage_cache.Cache, "stages", found)
    app(repository, services, **given).build()
    there |= {"identified", "environment", "runtime", "upstream-built", "app", "workspace"}
    app(repository, services, **given).build()
    there.remove("app")
    app(repository, services, **given).build()
    assert [call["name"] for call in calls] == ["packages", "run", "dev", "run", "dev", "packages", "run", "dev"]


@pytest.mark.parametrize(
    ("mirrors", "named"),
    [
        ({"OS_APT_MIRROR": "http://mirror.example:3142"}, []),
        ({"OS_APT_MIRROR": "https://me:secret@mirror.example"}, ["OS_APT_MIRROR"]),
        (dict.fromkeys(("OS_APT_MIRROR", "ROS_APT_MIRROR"), "https://token@x"), ["OS_APT_MIRROR", "ROS_APT_MIRROR"]),
    ],
)
def test_a_mirrors_password_reaches_code_of_the_repository_only_if_the_person_says_so(
    mirrors: dict[str, str], named: list[str], repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    given = {"base-image": "ros:jazzy", "command": "true"}
    if named:
        with pytest.raises(RosmlError, match=f"^{' and '.join(named)} has a password") as caught:
            App(repository, app_inputs.values(given, repository, {}), mirrors, services, lambda _: None).build()
        assert caught.value.exit_code == 2 and "--allow-mirror-password" in caught.value.remedy and not calls
        assert "secret" not in caught.value.message + caught.value.remedy
    values = app_inputs.values({**given, "allow-mirror-password": "true"} if named else given, repository, {})
    App(repository, values, mirrors, services, lambda _: None).build()
    assert calls


def test_names_and_tags_are_those_of_docker_ros(
    repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    name = f"{services.registry}/me/robot"
    given = {"base_image": "ros:jazzy", "command": "true", "image_name": name, "image_tag": "v1"}
    app(repository, services, **given, push="true", enable_push_as_latest="true").build()
    assert calls[1]["tags"] == [f"{name}:v1", f"{name}:latest"]
    assert calls[2]["tags"] == [f"{name}:v1-dev", f"{name}:latest-dev"]


def test_a_package_that_apt_lacks_is_told_with_the_rule_that_names_it(
    repository: Path, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    monkeypatch.setattr(sources, "fetch", lambda *_, **__: [])
    tail = "E: Unable to locate package {}\nE: Package 'liba+b1' has no installation candidate\n  the whole log: x"
    names = {"boost": ["libboost-dev", "liba+b1"], "tree": ["tree"]}
    said = {
        "packages": {"robot": {"exec": ["boost"]}, "arm": {"build": ["boost"], "test": ["tree"]}},
        "keys": {key: [{"installer": "apt", "names": names}] for key, names in names.items()},
        "skipped": [],
    }
    lacking = ""

    def run(services: Services, bake: buildx.Bake) -> tuple[None, dict[str, str]]:
        if bake.target == "packages":
            raise RosmlError(tail.format(lacking), "of the step")
        content = json.loads(bake.file.read_text())["target"][bake.target]
        archives.write(Path(content["output"][0].partition("dest=")[2]), {"dependencies.json": json.dumps(said)})
        return None, {}

    monkeypatch.setattr(buildx, "run", run)
    for lacking in ("tree", "of-nobody"):
        with pytest.raises(RosmlError) as caught:
            app(repository, services, base_image="ros:jazzy", command="true").build()
        rules = caught.value.message.partition("  the whole log: x\n")[2].splitlines()
        assert rules[0] == "  rosdep's rule for boost, which robot, arm asks for, names liba+b1"
        tree = lacking == "tree"
        assert rules[1:] == (["  rosdep's rule for tree, which arm asks for, names tree"] if tree else [])
        assert f"--skip-keys '{'boost tree' if tree else 'boost'}'" in caught.value.remedy
    tail = "E: Unable to locate package of-nobody"
    with pytest.raises(RosmlError) as caught:
        app(repository, services, base_image="ros:jazzy", command="true").build()
    assert (caught.value.message, caught.value.remedy) == (tail, "of the step")


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"command": "true"}, "there is no base image"),
        ({"base_image": "ros:jazzy"}, "there is no command for the run image"),
        (
            {"base_image": "ros:jazzy", "command": "x", "colcon_args": "--merge-install --symlink-install"},
            "colcon-args: with --symlink-install",
        ),
        ({"base_image": "ros:jazzy", "command": "true", "target": "run,slim"}, "'slim' is no target"),
        ({"base_image": "ros:jazzy", "command": "true", "image_name": "Robot!"}, "'Robot!' is no name of an image"),
        ({"base_image": "ros:jazzy", "command": "true", "image_tag": "a b"}, "'a b' is no tag"),
        ({"base_image": "ros:jazzy", "command": "true", "image_name": "rosml/ros"}, "is no name for an app"),
        ({"base_image": "ros:jazzy", "command": "true", "dev_image_name": "library/debian"}, "is no name for an app"),
        ({"base_image": "ros:jazzy", "command": "true", "image_name": "ghcr.io/me/robot"}, "there is no Docker here"),
    ],
)
def test_what_is_wrong_is_said_before_anything_is_built(
    given: dict[str, str], says: str, repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        app(repository, services, **given).build()
    assert caught.value.exit_code == 2 and caught.value.remedy
    assert calls == []


ROS_1 = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>"
ROS_2 = "<package><name>{}</name><depend>rclpy</depend><export><build_type>ament_python</build_type></export></package>"
BOTH = (
    "<package><name>{}</name><buildtool_depend condition='$ROS_VERSION == 1'>catkin</buildtool_depend>"
    "<buildtool_depend condition='$ROS_VERSION == 2'>ament_cmake</buildtool_depend><depend>rclpy</depend></package>"
)
AMENT = "<package><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
"""Debian's ROS 1 has ament_cmake, too."""


@pytest.mark.parametrize(
    ("ros", "packages", "says", "remedy"),
    [
        (
            "2",
            {"arm": ROS_1},
            "x has ROS 2, and src/arm/package.xml is for ROS 1$",
            "--base-image ros:ros1-bookworm-base$",
        ),
        ("1", {"arm": ROS_2}, "x has ROS 1, and src/arm/package.xml is for ROS 2$", "--base-image ros:jazzy-base$"),
        (
            "2",
            {"arm": ROS_1, "leg": ROS_1, "hand": ROS_2},
            "src/arm/package.xml, src/leg/package.xml are for ROS 1; src/hand/package.xml is for ROS 2$",
            "put a file COLCON_IGNORE into their folders",
        ),
        (
            "1",
            {"arm": ROS_2, "leg": AMENT},
            "src/arm/package.xml is for ROS 2$",
            "^name a base image with ROS 2, such as",
        ),
        ("1", {"arm": ROS_1, "hand": BOTH, "leg": AMENT}, "", ""),
        ("2", {"arm": ROS_2, "hand": BOTH, "leg": AMENT}, "", ""),
        ("", {"arm": ROS_1, "hand": ROS_2}, "", ""),
    ],
)
def test_packages_of_another_ros_than_the_base_images_are_named(
    repository: Path,
    services: Services,
    calls: list[dict[str, Any]],
    ros: str,
    packages: dict[str, str],
    says: str,
    remedy: str,
) -> None:
    """Before anything is built. A list, a file or a script may leave them out."""
    put(
        services,
        "rosml/ros:x",
        f"linux/{native_architecture()}",
        ROS_DISTRO="x",
        ROS_VERSION=ros,
    )
    for name, text in packages.items():
        (repository / "src" / name).mkdir()
        (repository / "src" / name / "package.xml").write_text(text.format(name))
    if "hand" not in packages and says:
        (repository / "src/robot/COLCON_IGNORE").touch()

    def built() -> None:
        app(repository, services, base_image="ros:x", command="true").build()

    if says:
        with pytest.raises(RosmlError, match=says) as caught:
            built()
        assert re.search(remedy, caught.value.remedy) and caught.value.exit_code == 2 and calls == []
        (repository / "src/hand").mkdir(exist_ok=True)
        (repository / "src/hand/package.xml").write_text(AMENT.format("hand"))
        (repository / "docker").mkdir()
        (repository / "docker/blacklisted-packages.txt").write_text("arm leg\n")
    built()
    assert calls


def test_examples_of_base_images_are_tags() -> None:
    images = load.load(ROOT / "matrix.yaml")
    assert {ros: images.image(tag).ros for ros, tag in manifest.EXAMPLES.items()} == {1: 1, 2: 2}


@pytest.mark.parametrize(
    ("files", "says"),
    [
        ({}, "there is no package.xml in"),
        ({"src/CMakeLists.txt": "project(x)"}, "there is no package.xml in"),
        ({"package.xml": "<package>\n<name>x</nam>"}, "package.xml:2:10: no XML: mismatched tag"),
        (
            {"a/package.xml": PACKAGE.format("a"), "b/package.xml": "<package/>"},
            "no manifest of a ROS package: no <name>",
        ),
        ({"package.xml": "<package/>", ".env": "x y"}, "no manifest of a ROS package"),
        (
            {"package.xml": "<package/>", ".env": "BEFORE_DEPENDENCY_IDENTIFICATION_SCRIPT=fix\n", "fix": ""},
            "parallel-jobs",
        ),
        ({"my.repos": "repositories: {}\n"}, "parallel-jobs"),
        ({"lists/upstream": "repositories: {}\n", ".env": "VCS_IMPORT_FILE=lists/upstream\n"}, "parallel-jobs"),
    ],
)
def test_a_folder_is_looked_at_before_options_and_services(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, files: dict[str, str], says: str
) -> None:
    """A script may mend its manifests, and a list may bring the packages."""
    monkeypatch.setattr(containerize, "services_for_builds", lambda: pytest.fail("services were asked for"))
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    error: Any = CliRunner().invoke(main.cli, ["containerize", str(tmp_path), "--parallel-jobs", "many"]).exception
    assert says in error.message and error.exit_code == 2 and error.remedy


def needing(name: str, tag: str, needed: str, condition: str = "") -> str:
    """A manifest with one dependency, on its third line."""
    when = f' condition="{condition}"' if condition else ""
    return f"<package>\n<name>{name}</name>\n<{tag}{when}>{needed}</{tag}></package>"


RING = """packages depend on each other in a ring, so none of them can be built first:
src/a/package.xml:3: a depends on b
src/b/package.xml:3: b depends on c
src/c/package.xml:3: c depends on a"""


@pytest.mark.parametrize(
    ("tag", "condition", "early", "late"),
    [
        ("exec_depend", "", True, True),
        ("test_depend", "", True, True),
        ("doc_depend", "", False, False),
        ("depend", "$ROS_VERSION == 2", False, True),
        ("depend", "$ROS_VERSION == 1", False, False),
    ],
)
def test_a_ring_of_packages_is_named_before_anything_is_built(
    repository: Path, services: Services, calls: list[dict[str, Any]], tag: str, condition: str, early: bool, late: bool
) -> None:
    """colcon orders packages by all dependencies but those of the documentation. Conditions need the base image."""
    put(services, "rosml/ros:x", f"linux/{native_architecture()}", ROS_DISTRO="x", ROS_VERSION="2")
    manifests = {"a": needing("a", "depend", "b"), "b": needing("b", "build_depend", "c")}
    for name, text in (manifests | {"c": needing("c", tag, "a", condition)}).items():
        (repository / "src" / name).mkdir()
        (repository / "src" / name / "package.xml").write_text(text)

    def ring(check: Callable[[], object]) -> str:
        try:
            check()
        except RosmlError as error:
            assert error.exit_code == 2 and error.remedy.startswith("remove one of these dependencies")
            return error.message
        return ""

    def build() -> None:
        app(repository, services, base_image="ros:x", command="true").build()

    assert ring(lambda: manifest.require(repository, {}, {})) == (RING if early else "")
    assert ring(build) == (RING if late else "")
    assert bool(calls) is not late
    (repository / "docker").mkdir()
    (repository / "docker/blacklisted-packages.txt").write_text("c\n")
    assert not ring(lambda: manifest.require(repository, {}, {})) and not ring(build)


@pytest.mark.parametrize(
    ("base_has", "named", "compared"),
    [
        ("Debian", "", "noetic"),
        ("Debian", "Debian", "noetic"),
        ("Debian", "melodic", "melodic"),
        ("jazzy", "humble", "jazzy"),
    ],
)
def test_conditions_compare_with_a_release(
    base_has: str, named: str, compared: str, repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    """No manifest compares with what Debian calls its own ROS."""
    put(services, "rosml/ros:x", f"linux/{native_architecture()}", ROS_DISTRO=base_has)
    app(repository, services, base_image="ros:x", command="true", ros_distro=named).build()
    arguments = calls[0]["args"]
    assert (arguments["ROS_DISTRO"], arguments["CONDITIONS"]) == (base_has, compared)


NOBLE = {
    "etc/os-release": "ID=ubuntu\nVERSION_ID=24.04\n",
    "bin/bash": "",
    "bin/apt-get": "",
    "dpkg/status": "",
    "apt/ubuntu.sources": "Types: deb\n",
    "entrypoint/0/start.sh": '#!/bin/sh\nexec "$@"\n',
}
"""What is copied out of an image of Ubuntu."""


def test_ros_is_installed_on_a_base_that_has_none(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """By the steps of our own images, on it by its digest, and kept as a stage of its own. An image is looked at once."""
    starts = {"WorkingDir": "/opt/sdk", "Entrypoint": ["./start.sh"]}
    digest = put(
        services, "rosml/plain:1", f"linux/{native_architecture()}", LANG="de", CUDA_VERSION="13.0.1", starts=starts
    )
    monkeypatch.setattr(variables, "sync_date", lambda *_: "2026-11-20T21:14:09Z")
    given = {"base_image": "plain:1", "command": "true", "cache": f"{services.registry}/me/cache"}
    said: list[str] = []
    for _ in range(2):
        found_values = app_inputs.values(
            {name.replace("_", "-"): value for name, value in given.items()}, repository, {}
        )
        App(repository, found_values, {}, services, said.append).build()
    assert "its entrypoint runs before each command: /opt/sdk/start.sh" in said
    assert [call["name"] for call in calls].count("system") == 1
    [file] = services.state.rglob("bake.json")
    targets = json.loads(file.read_text())["target"]
    assert targets["report"]["contexts"]["base"] == targets["run"]["contexts"]["base"] == "target:base"
    names = [found := "base"]
    while found := targets[found]["contexts"][next(iter(targets[found]["contexts"]))].partition("target:")[2]:
        names.append(found)
    assert names == ["base", "base-jazzy-core", "base-os-ubuntu-24-04", "base-system"]
    reference = f"docker-image://{services.registry}/rosml/plain@{digest}"
    assert targets["base-system"]["contexts"] == {"os": reference}
    assert targets["base-jazzy-core"]["args"]["ROS_SYNC_DATE"] == "2026-11-20T21:14:09Z"
    assert targets["base"]["args"] == {"KEPT_LANG": "de"}
    entrypoint = '"/entrypoint.sh", "/opt/sdk/start.sh"'
    assert f'ENTRYPOINT ["/tini", "--", {entrypoint}]' in targets["base"]["dockerfile-inline"].splitlines()
    assert targets["base"]["labels"]["io.rosml.own"] == "CUDA_VERSION"
    assert targets["base"]["labels"]["io.rosml.distribution"] == "jazzy"
    kept = targets["keep-base"]["output"][0]
    monkeypatch.setattr(variables, "sync_date", lambda *_: "2026-11-27T21:14:09Z")
    app(repository, services, **given).build()
    assert json.loads(file.read_text())["target"]["keep-base"]["output"][0] != kept, "ROS has other packages"
    App(repository, found_values, {}, services, said.append, renew=True).build()
    assert "it has no versions of the ROS that was installed" in said[-1]


@pytest.mark.parametrize("user", ["a\nRUN touch /x", "-x", "$HOME", "a:b:c", "a b"])
def test_a_user_of_a_base_image_is_a_name(repository: Path, services: Services, user: str) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", user=user, ROS_DISTRO="jazzy")
    with pytest.raises(RosmlError, match="starts as a user of no name"):
        app(repository, services, base_image="ros:jazzy", command="true").build()


def test_a_base_without_ros_stays_without_if_somebody_says_so(
    repository: Path, services: Services, calls: list[dict[str, Any]]
) -> None:
    put(services, "rosml/plain:1", f"linux/{native_architecture()}")
    given = {"base_image": "plain:1", "command": "true", "disable_ros_installation": "true"}
    with pytest.raises(RosmlError, match="does not say which ROS it has") as caught:
        app(repository, services, **given).build()
    assert "--ros-distro" in caught.value.remedy
    app(repository, services, **given, ros_distro="jazzy").build()
    assert calls[-1]["args"]["APP_ROS_DISTRO"] == "jazzy" and calls[0]["name"] == "packages"


def test_each_script_that_a_build_calls_decides_what_a_cache_has(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    scripts = repository.parent / "components"
    shutil.copytree(app_bake_file.SCRIPTS, scripts)
    monkeypatch.setattr(app_bake_file, "SCRIPTS", scripts)
    given = {"base_image": "ros:jazzy", "command": "true", "cache": f"{services.registry}/me/cache"}

    def kept() -> str:
        app(repository, services, **given).build()
        [file] = services.state.rglob("bake.json")
        return json.dumps(json.loads(file.read_text())["target"]["keep-runtime"]["output"])

    seen = {kept()}
    dockerfile = (scripts / "containerize/Dockerfile").read_text()
    called = sorted(set(re.findall(r"from=scripts,source=([a-z_/]+\.(?:sh|py))", dockerfile)))
    for name in called:
        (scripts / name).write_text("changed")
        seen.add(kept())
    assert len(seen) == 1 + len(called)


# ---- Tests of the app ------------------------------------------------------------------------------------------------

COLCON = """#!/bin/sh
case $1 in
list) printf '%s\n' robot arm bare ;;
test)
  sleep 0.05 # times of files are not exact
  mkdir -p "$COLCON_LOG_PATH/latest_test"
  for name in robot arm bare; do mkdir -p "$COLCON_LOG_PATH/latest_test/$name"; done
  cd "$COLCON_LOG_PATH/latest_test"
  printf "[0.1] (robot) JobStarted: {}\n[0.2] (robot) TestFailure: {'identifier': 'robot'}\n" >events.log
  printf "[0.2] (robot) JobEnded: {'identifier': 'robot', 'rc': 0}\n" >>events.log
  printf "[0.3] (arm) JobEnded: {'identifier': 'arm', 'rc': 1}\n" >>events.log # as with tests of Python's unittest
  printf "[0.3] (bare) JobEnded: {'identifier': 'bare', 'rc': 5}\n" >>events.log
  echo 'core dumped' >robot/stdout_stderr.log
  echo '1 != 2' >arm/stdout_stderr.log
  printf 'Ran 0 tests in 0.000s\n\nNO TESTS RAN\n' >bare/stdout_stderr.log
  cd "$OLDPWD"
  echo '<testsuite/>' >build/robot/new.xml
  echo '<Site><TestList></TestList></Site>' >build/robot/Test.xml
  echo '<other/>' >build/robot/other.xml
  exit 1 ;;
esac
"""


def test_what_a_build_wrote_is_no_result_of_tests(tmp_path: Path) -> None:
    work, out = tmp_path / "ws", tmp_path / "results"
    for name in ("robot/data", "arm", "bare"):
        (work / "build" / name).mkdir(parents=True)
    (work / "build/robot/data/sample.xml").write_text("<testsuite/>")
    (tmp_path / "colcon").write_text(COLCON)
    (tmp_path / "colcon").chmod(0o755)
    environment = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(work), "TMPDIR": str(tmp_path)}
    subprocess.run([ROOT / "components/containerize/test.sh", out], env=environment, check=True)
    left = sorted(str(path.relative_to(out)) for path in out.rglob("*") if path.is_file())
    assert left == ["arm/output.log", "failed", "robot/Test.xml", "robot/new.xml", "robot/output.log"]
    text = "{0}: its tests failed and left no report; {0}/output.log has what they printed\n"
    assert (out / "failed").read_text() == text.format("arm") + text.format("robot")
    assert (out / "arm/output.log").read_text() == "1 != 2\n"


@pytest.mark.parametrize("script", ["workspace.sh target", "test.sh out"])
def test_a_colcon_that_cannot_list_is_no_empty_workspace(script: str, tmp_path: Path) -> None:
    """As with few of its extensions: an image without one file of the app would be made."""
    (tmp_path / "ws").mkdir()
    (tmp_path / "colcon").write_text("#!/bin/sh\n[ $1 != list ] || { echo \"invalid choice: 'list'\" >&2; exit 2; }\n")
    (tmp_path / "colcon").chmod(0o755)
    (tmp_path / "cp").symlink_to("/bin/true")  # /run/sources is a mount of the build
    environment = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(tmp_path / "ws")}
    name, argument = script.split()
    command = [str(ROOT / "components/containerize" / name), argument]
    done = subprocess.run(command, env=environment, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode != 0 and "invalid choice: 'list'" in done.stderr


@pytest.mark.parametrize(
    ("files", "hides"),
    [
        (["setup.py", "ros/a/package.xml"], "src/target/ros/a"),
        (["CMakeLists.txt", "a/COLCON_IGNORE", "a/b/package.xml", ".git/package.xml"], ""),
        (["package.xml", "templates/a/package.xml"], ""),
    ],
)
def test_a_package_of_another_kind_hides_none_with_a_manifest(files: list[str], hides: str, tmp_path: Path) -> None:
    """As a setup.py beside the folder with ROS packages: colcon builds that alone, and ends well."""
    for name in files:
        place = tmp_path / "ws/src/target" / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.touch()
    (tmp_path / "colcon").write_text("#!/bin/sh\n[ $1 != list ] || echo src/target\n")
    (tmp_path / "colcon").chmod(0o755)
    (tmp_path / "cp").symlink_to("/bin/true")
    environment = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(tmp_path / "ws")}
    command = [str(ROOT / "components/containerize/workspace.sh"), "target"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert (done.returncode != 0) == bool(hides) and (f"does not build {hides} inside" in done.stderr) == bool(hides)


def test_no_image_is_made_without_a_package_that_has_a_manifest(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    """colcon passes over some with a warning, and ends well."""
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    monkeypatch.setitem(DEPENDENCIES, "packages", {"robot": {}, "arm": {}, "leg": {}})
    with pytest.raises(RosmlError, match="colcon has not built arm, leg; no image was made"):
        app(repository, services, base_image="ros:jazzy", command="true").build()
    assert [call["name"] for call in calls] == ["packages"]
    monkeypatch.setitem(APP, "built", ["arm", "leg", "of_the_base", "robot"])
    app(repository, services, base_image="ros:jazzy", command="true").build()


def test_no_slim_image_is_made_in_which_no_test_ran(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("rosml/ros:jazzy", "small:1"):
        put(services, name, f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    monkeypatch.setattr(junit, "read", lambda folder: junit.Tests(0 if folder.name == "slim" else 3, 1))
    small = f"{services.registry}/small:1"
    with pytest.raises(RosmlError, match="none of 3 tests ran in the slim image; no image was made"):
        app(
            repository, services, base_image="ros:jazzy", command="x", enable_slim="true", slim_base_image=small
        ).build()
    assert [call["name"] for call in calls] == ["packages"]


def test_no_image_is_made_where_a_test_failed(
    repository: Path, services: Services, calls: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    monkeypatch.setattr(junit, "read", lambda folder: junit.Tests(3, 1, ("robot: a.bad: 1 is not 2",)))
    with pytest.raises(RosmlError, match=r"1 of 3 tests failed; no image was made") as caught:
        app(repository, services, base_image="ros:jazzy", command="true").build()
    assert "robot: a.bad: 1 is not 2" in caught.value.message
    assert caught.value.remedy.startswith("correct the packages or their tests")
    assert [call["name"] for call in calls] == ["packages"]
    failure = "robot: test.a: its tests could not be collected: ModuleNotFoundError: No module named 'cv3'"
    monkeypatch.setattr(junit, "read", lambda folder: junit.Tests(1, 0, (failure,)))
    with pytest.raises(RosmlError, match="No module named 'cv3'") as caught:
        app(repository, services, base_image="ros:jazzy", command="true").build()
    assert caught.value.remedy.startswith("name what has the module in package.xml, as test_depend; or correct")


@pytest.mark.parametrize("failures", [("robot: a.bad: 1 is not 2",), ()])
def test_a_build_that_a_failed_test_ended_says_which(
    repository: Path,
    services: Services,
    calls: list[dict[str, Any]],
    monkeypatch: pytest.MonkeyPatch,
    failures: tuple[str, ...],
) -> None:
    """The reports alone say so: a stage with code of the packages may have left anything."""
    put(services, "rosml/ros:jazzy", f"linux/{native_architecture()}", ROS_DISTRO="jazzy")
    monkeypatch.setattr(junit, "read", lambda folder: junit.Tests(3, 0, failures))
    leaving = buildx.run_all

    def run_all(services: Services, bake: buildx.Bake) -> tuple[Any, dict[str, dict[str, str]]]:
        done = leaving(services, bake)
        if bake.target == app_bake_file.PACKAGES:
            wanted = json.loads(bake.file.read_text())
            assert app_bake_file.TESTS in wanted["group"]["packages"]["targets"]
            raise buildx.StepFailed("building packages failed", "", app_bake_file.PASSED)
        return done

    monkeypatch.setattr(buildx, "run_all", run_all)
    expected = "1 of 3 tests failed; no image was made" if failures else "building packages failed"
    with pytest.raises(RosmlError, match=expected):
        app(repository, services, base_image="ros:jazzy", command="true").build()
    assert [call["name"] for call in calls] == [app_bake_file.PACKAGES, app_bake_file.FAILED]


NAMES = ["robot", "me/robot", "me/a.b_c__d---e/f", "ghcr.io/me/robot", "localhost/robot", "127.0.0.1:5000/me/robot"]


@pytest.mark.parametrize("name", NAMES)
def test_names_are_those_that_registries_take(name: str, services: Services) -> None:
    values = app_inputs.values({"image-name": name}, services.state, {})
    assert names.Names(values, "robot", services_without_registry(services)).app == name


@pytest.mark.parametrize(
    "name",
    [".", "..", "a/../b", "a//b", "/a", "a/", "-a", "a-", "a..b", "a___b", "a._b", "a:5000", "ghcr.io:x/a", "my robot"],
)
def test_other_names_are_refused(name: str, services: Services) -> None:
    for given in ({"image-name": name}, {"image-name": "robot", "dev-image-name": name}):
        values = app_inputs.values(given, services.state, {})
        with pytest.raises(RosmlError, match="is no name of an image") as caught:
            names.Names(values, "robot", services_without_registry(services))
        assert caught.value.exit_code == 2


def services_without_registry(services: Services) -> Services:
    """Those of a user's Docker."""
    return dataclasses.replace(services, registry="", builder_kind="user")


@pytest.mark.parametrize(("version", "raw"), [("20.10.24+dfsg1", True), ("23.0.1", False), ("", False)])
def test_an_old_docker_gets_layers_that_it_can_read(
    version: str, raw: bool, services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "docker").write_text(f"#!/bin/sh\necho {version}\n")
    (tmp_path / "docker").chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    found = names.Names(app_inputs.values({}, services.state, {}), "robot", services_without_registry(services))
    assert found.loads and ("compression=uncompressed" in found.loading) is raw


def test_images_go_to_docker_where_there_is_one(
    repository: Path, services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    values = app_inputs.values({"image-name": "ghcr.io/me/robot"}, repository, {})
    monkeypatch.setattr(shutil, "which", lambda name: f"/usr/bin/{name}")
    users = dataclasses.replace(services, builder_kind="user")
    found = names.Names(values, "robot", users)
    assert found.loads and found.reference("run") == "ghcr.io/me/robot:latest"
    with pytest.raises(RosmlError, match="Docker holds images of one platform"):
        names.Names(dataclasses.replace(values, platform="amd64,arm64"), "robot", users)
    with pytest.raises(RosmlError, match="robot names no registry"):
        nowhere = dataclasses.replace(users, registry="")
        names.Names(dataclasses.replace(values, image_name="robot", push=True), "robot", nowhere)
    monkeypatch.setattr(shutil, "which", lambda name: None)
    own = names.Names(dataclasses.replace(values, image_name="robot"), "robot", users)
    assert own.reference("run").startswith(services.registry)


def test_it_says_where_images_are_that_nobody_pushed() -> None:
    lines = [*containerize.where("127.0.0.1:5000", ["127.0.0.1:5000/robot:1", "127.0.0.1:5000/robot:1-dev"])]
    assert "in the local registry, as setup found no Docker" in lines[0]
    assert lines[1].endswith(" save 127.0.0.1:5000/robot:1 -o image.tar writes one into a file")
    for registry, images in (("127.0.0.1:5000", ["robot:1"]), ("", ["robot:1"]), ("127.0.0.1:5000", [])):
        assert not [*containerize.where(registry, images)]
