"""What a build reads of a repository: manifests, and what its files ask for. Nothing outside of it, and nothing secret."""

from __future__ import annotations

import os
import re
import sys
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from fakes.apps import PACKAGE, Robot, robot, services
from fakes.stubs import script_of_a_build
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.containerize import inputs as app_inputs
from rosml.containerize import lock
from rosml.containerize.packages import workspace

__all__ = ["robot", "services"]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "robot/docker").mkdir(parents=True)
    return tmp_path / "robot"


def write(folder: Path, names: list[str] | tuple[str, ...]) -> None:
    """Packages in folders, each called as its folder."""
    for name in names:
        (folder / name).mkdir(parents=True, exist_ok=True)
        (folder / name / "package.xml").write_text(PACKAGE.format(name.rpartition("/")[2]))


def requests(folder: Path, inputs: dict[str, str], environment: dict[str, str] | None = None) -> dict[str, str]:
    values, out = app_inputs.values(inputs, folder, {}), folder.parent / "requests"
    workspace.write_requests(values, folder, folder.parent / "upstream", environment or {}, out)
    return {str(path.relative_to(out)): path.read_text() for path in out.rglob("*") if path.is_file()}


# ---- Manifests -------------------------------------------------------------------------------------------------------


def test_manifests_are_those_that_colcon_finds(folder: Path, tmp_path: Path) -> None:
    write(folder, ("a", "a/inner", "b/c", "hidden/d", ".git/e"))
    (folder / "hidden/COLCON_IGNORE").touch()
    for path in ("a", "b", "hidden"):
        (folder / path / "CMakeLists.txt").write_text("# its name\nproject(b CXX)\nadd_library(b b.cpp)\n")
    (folder / "CMakeLists.txt").symlink_to("/opt/ros/noetic/share/catkin/cmake/toplevel.cmake")
    (tmp_path / "none").mkdir()
    out = tmp_path / "out"
    assert workspace.write_manifests({"target": folder, "upstream": tmp_path / "none"}, out) == {
        "target": 2,
        "upstream": 0,
    }
    assert sorted(str(path.relative_to(out / "target")) for path in out.rglob("*") if path.is_file()) == [
        "a/package.xml",
        "b/CMakeLists.txt",
        "b/c/package.xml",
        "hidden/COLCON_IGNORE",
    ]
    text = (out / "target/b/CMakeLists.txt").read_text()
    assert text == "project(b)\n", "nothing else decides what is installed"
    with pytest.raises(RosmlError, match=r"there is no package\.xml"):
        workspace.write_manifests({"target": tmp_path / "none"}, out)


def test_packages_behind_links_are_those_that_colcon_finds(folder: Path, tmp_path: Path) -> None:
    """Once each, and within the repository; a link that leads out is named."""
    outside, messages = tmp_path / "outside", list[str]()
    write(folder, ("third_party/tp", "src/main", ".git/secret"))
    write(outside, ("x",))
    (folder / "third_party/COLCON_IGNORE").touch()
    links = {"tp": "../third_party/tp", "again": str(folder / "third_party/tp"), "up": "..", "out": str(outside)}
    for name, leads in {**links, "nowhere": "nothing", "git": "../.git"}.items():
        (folder / "src" / name).symlink_to(leads)
    assert workspace.write_manifests({"target": folder}, tmp_path / "out", messages.append) == {"target": 2}
    assert list(workspace.names(folder)) == ["tp", "main"]
    assert sorted(line.partition(" leads")[0] for line in messages) == [
        f"{folder}/src/{name}" for name in ("git", "out")
    ]
    manifests = {str(path.relative_to(tmp_path / "out/target")) for path in (tmp_path / "out/target").rglob("*.xml")}
    assert manifests == {"src/again/package.xml", "src/main/package.xml"}

    workspace.stage(folder, tmp_path / "staged")
    assert os.readlink(tmp_path / "staged/src/again") == "../third_party/tp", "there is no such path in a step"
    assert os.readlink(tmp_path / "staged/src/out") == str(outside)


def test_a_package_behind_a_link_can_be_left_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    catkin_pkg: Any = types.ModuleType("catkin_pkg.package")  # a base image has it
    catkin_pkg.parse_package = lambda path: types.SimpleNamespace(name=ElementTree.parse(path).findtext("name"))
    monkeypatch.setitem(sys.modules, "catkin_pkg", types.ModuleType("catkin_pkg"))
    monkeypatch.setitem(sys.modules, "catkin_pkg.package", catkin_pkg)
    script = script_of_a_build("containerize/manifests.py")
    write(tmp_path, ("src/target/third_party/tp", "src/target/main", "outside"))
    (tmp_path / "src/target/third_party/COLCON_IGNORE").touch()
    (tmp_path / "src/target/tp").symlink_to("third_party/tp")
    (tmp_path / "src/target/out").symlink_to(tmp_path / "outside")
    assert sorted(script.all_packages(tmp_path / "src")) == ["main", "tp"]
    (tmp_path / "left_out").write_text("tp\n")
    script.main(tmp_path / "src", tmp_path / "left_out")
    assert sorted(script.all_packages(tmp_path / "src")) == ["main"]


# ---- Requests --------------------------------------------------------------------------------------------------------


def test_what_a_repository_asks_for_is_written_down(folder: Path) -> None:
    (folder / "docker/additional-debs.txt").write_text("htop nano=7.2-1 # to look around\n")
    (folder / "docker/custom.sh").write_text("echo done")
    inputs = {"rmw-implementation": "rmw_cyclonedds_cpp"}
    texts = requests(folder, inputs, {"ROS_VERSION": "2", "ROS_DISTRO": "jazzy"})
    assert texts.pop("apt") == "htop\nnano=7.2-1\nros-jazzy-rmw-cyclonedds-cpp\n"
    assert texts.pop("after/0000") == "echo done\n" and set(texts.values()) == {""}
    assert requests(folder, inputs, {"ROS_VERSION": "1", "ROS_DISTRO": "noetic"})["apt"] == "htop\nnano=7.2-1\n"
    texts = requests(folder, {"after-dependency-installation-script": ""})
    assert "after/0000" not in texts, "nobody wants the default"


def test_a_request_that_cannot_be_is_refused(folder: Path) -> None:
    with pytest.raises(RosmlError, match=r"additional-debs-file: there is no file debs\.txt"):
        requests(folder, {"additional-debs-file": "debs.txt"})
    for word in ("htop;", "ros-$ROS_DISTROS-gps-msgs", "$(id)"):
        (folder / "docker/additional-debs.txt").write_text(f"{word}\n")
        with pytest.raises(RosmlError, match=f"'{re.escape(word)}' is no package of apt"):
            requests(folder, {}, {"ROS_DISTRO": "jazzy"})


def test_packages_of_apt_may_name_the_distribution(folder: Path) -> None:
    """As in docker-ros, where a shell reads them."""
    (folder / "docker/additional-debs.txt").write_text("ros-$ROS_DISTRO-gps-msgs # a\nros-${ROS_DISTRO}-rviz2\n")
    debs = "ros-humble-gps-msgs\nros-humble-rviz2\n"
    assert requests(folder, {}, {"ROS_DISTRO": "humble"})["apt"] == debs
    assert requests(folder, {"ros-distro": "humble"}, {})["apt"] == debs, "the base image has no ROS yet"


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda place: place.symlink_to("/etc"), "leads out of"),
        (lambda place: place.symlink_to("nothing"), "a link to nothing"),
        (lambda place: place.symlink_to(place.name), "a link to nothing"),
        (Path.mkdir, "a folder instead of a file"),
    ],
)
@pytest.mark.parametrize("recursive", ["true", "false"])
def test_what_is_no_file_of_the_repository_is_refused(
    make: Callable[[Path], None], says: str, recursive: str, folder: Path
) -> None:
    make(folder / "docker/custom.sh")
    with pytest.raises(RosmlError, match=f"docker/custom.sh:? {says}") as caught:
        requests(folder, {"enable-recursive-after-dependency-installation-script": recursive})
    assert caught.value.exit_code == 2 and caught.value.remedy


def test_nothing_outside_a_repository_is_read(folder: Path, tmp_path: Path) -> None:
    (folder / "arm").mkdir()
    (tmp_path / "package.xml").write_text(PACKAGE.format("arm"))
    (folder / "arm/package.xml").symlink_to("../../package.xml")
    with pytest.raises(RosmlError, match=r"arm/package\.xml leads out of"):
        workspace.write_manifests({"target": folder}, tmp_path / "out")
    (folder / "files").symlink_to("..")
    with pytest.raises(RosmlError, match=r"robot/files leads out of"):
        workspace.additional_files("files", folder)
    with pytest.raises(RosmlError, match=r"leads out of"):
        requests(folder, {"additional-debs-file": "../package.xml"})
    (tmp_path / "secret").write_text("ROS_DISTRO=secret\n")
    (folder / ".env").symlink_to("../secret")
    with pytest.raises(RosmlError, match="it is a link"):
        app_inputs.values({}, folder, {})


@pytest.mark.parametrize("place", ["docker/custom.sh", "docker/additional-debs.txt", "robot/package.xml"])
@pytest.mark.parametrize("secret", [".git/config", ".env"])
def test_no_link_brings_what_is_secret_into_a_build(place: str, secret: str, folder: Path, tmp_path: Path) -> None:
    for name in (".git/config", ".env", place):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / ".git/config").write_text("[secret]\n")
    (folder / ".env").write_text("SECRET=1\n")
    (folder / place).symlink_to(os.path.relpath(folder / secret, (folder / place).parent))
    with pytest.raises(RosmlError, match=rf"{place} leads to {secret}, which gets into no image") as caught:
        requests(folder, {})
        workspace.write_manifests({"target": folder}, tmp_path / "out")
    assert caught.value.exit_code == 2 and caught.value.remedy


@pytest.mark.parametrize(("target", "inputs"), [("..", {}), ("", {"additional_files_dir": "src"}), ("../.git", {})])
def test_additional_files_have_nothing_secret(target: str, inputs: dict[str, str], robot: Robot) -> None:
    for name in (".git/config", "src/sub/.git", "src/.env", ".env"):
        robot.write(name, "SECRET=1\n")
    robot.write("src/hello")
    if target:
        robot.write("docker/here")
        (robot.folder / "docker/additional-files").symlink_to(target)
    if target == "../.git":
        with pytest.raises(RosmlError, match=r"leads to \.git"):
            robot.build(**inputs)
        return
    robot.build(**inputs)
    names = {path.name for path in Path(robot.targets[0]["contexts"]["additional"]).rglob("*")}
    assert "hello" in names and names.isdisjoint((".git", ".env"))


def test_additional_files_are_those_whose_paths_begin_with_the_name(robot: Robot) -> None:
    """As `ADD docker/additional-files*` takes them: of folders what is in them, without what `.dockerignore` names."""
    for name in ("additional-files/a/x", "additional-files/y.bag", "additional-files.tgz", "additional-files-2/b", "z"):
        robot.write(f"docker/{name}")
    robot.write("docker/additional-files-linked/c")
    (robot.folder / "docker/additional-files.link").symlink_to("z")
    robot.write(".dockerignore", "**/*.bag\n")
    robot.build()
    staged = Path(robot.targets[0]["contexts"]["additional"])
    files = {str(path.relative_to(staged)) for path in staged.rglob("*") if path.is_file()}
    assert {name for name in files if name.startswith("folders")} == {
        f"folders/{name}" for name in ("0000/a/x", "0001/b", "0002/c")
    }
    assert {name for name in files if name.startswith("files")} == {
        f"files/{name}" for name in ("0003/additional-files.link", "0004/additional-files.tgz")
    }
    assert not (staged / "files/0003/additional-files.link").is_symlink()
    robot.build(additional_files_dir="docker/additional-files/")
    staged = Path(robot.targets[-1]["contexts"].get("additional", staged))
    assert sorted(str(path.relative_to(staged)) for path in staged.rglob("*") if path.is_file()) == ["folders/0000/x"]


def test_additional_files_may_be_missing(tmp_path: Path) -> None:
    for name in ("docker/additional-files", ""):
        assert workspace.additional_files(name, tmp_path) == []
    (tmp_path / "files").touch()
    assert workspace.additional_files("file", tmp_path) == [tmp_path / "files"]
    with pytest.raises(RosmlError, match=r"additional-files-dir: there is no folder\* in"):
        workspace.additional_files("folder", tmp_path)


@pytest.mark.parametrize("name", [".env", "containerize.lock", "docker/additional-debs.txt", "a/package.xml"])
def test_a_pipe_in_a_folder_is_refused(name: str, tmp_path: Path) -> None:
    """Whoever reads it would wait for ever."""
    (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
    os.mkfifo(tmp_path / name)
    with pytest.raises(RosmlError, match=r"neither a file nor a folder|it is no file") as caught:
        app_inputs.values({}, tmp_path, {})
        lock.read(tmp_path / "containerize.lock", tmp_path)
        requests(tmp_path, {})
        workspace.write_manifests({"target": tmp_path}, tmp_path / "out")
    assert caught.value.exit_code == 2 and caught.value.remedy


def test_a_lock_file_is_not_written_into_gits_folder(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    with pytest.raises(RosmlError, match=r"leads to \.git/index\.lock"):
        lock.place(tmp_path, ".git/index.lock", renew=True)


# ---- In the build ----------------------------------------------------------------------------------------------------


def test_an_install_space_is_never_read_through_a_link(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Code of the packages may leave one; the step that reads it is rosml's own, and says what is in the images."""
    monkeypatch.syspath_prepend(str(ROOT / "components/containerize"))
    script = script_of_a_build("containerize/app_files.py")
    folders = [tmp_path / name for name in ("base", "runtime", "environment", "workspace", "outside")]
    for place in (*folders, tmp_path / "workspace/docker-ros/ws", tmp_path / "elsewhere"):
        place.mkdir(parents=True, exist_ok=True)
    (tmp_path / "elsewhere/file").write_text("x")
    (tmp_path / "workspace/docker-ros/ws/install").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(SystemExit, match="error: /docker-ros/ws/install is no folder"):
        script.main(*folders, tmp_path / "out")
    assert not [path for path in (tmp_path / "out").rglob("*") if path.is_file()]


def test_no_file_is_copied_below_a_link(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "components/containerize"))
    script = script_of_a_build("containerize/app_files.py")
    for name in ("source/a", "source/c", "out"):
        (tmp_path / name).mkdir(parents=True)
    for name in ("source/a/file", "source/c/new"):
        (tmp_path / name).write_text("x")
    (tmp_path / "source/b").symlink_to("a")
    (tmp_path / "out/c").symlink_to(tmp_path / "source/a")
    for path in ("b/file", "c/new"):
        with pytest.raises(SystemExit, match="is no folder"):
            script.copy(tmp_path / "source", path, tmp_path / "out")
    assert sorted(path.name for path in (tmp_path / "source/a").iterdir()) == ["file"]
