"""What stops an app's build before it begins, and what stops an image after it."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from typing import Any

import pytest
from click.testing import CliRunner

from fakes.apps import PACKAGE, Robot, leave, robot, services
from rosml.base.errors import RosmlError
from rosml.cli import main
from rosml.cli.containerize import containerize
from rosml.containerize.build import bake_file, junit, step_order
from rosml.containerize.packages import manifest
from rosml.containerize.sources import fetch as sources
from rosml.machine import buildx

__all__ = ["robot", "services"]


# ---- Before the build ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("inputs", "says"),
    [
        ({"base_image": ""}, "there is no base image"),
        ({"command": ""}, "there is no command for the run image"),
        ({"colcon_args": "--merge-install --symlink-install"}, "colcon-args: with --symlink-install"),
        ({"target": "run,slim"}, "'slim' is no target"),
        ({"image_name": "Robot!"}, "'Robot!' is no name of an image"),
        ({"image_name": "rosml/ros"}, "is no name for an app"),
        ({"dev_image_name": "library/debian"}, "is no name for an app"),
        ({"image_name": "ghcr.io/me/robot"}, "there is no Docker here"),
    ],
)
def test_what_is_wrong_is_said_before_anything_is_built(inputs: dict[str, str], says: str, robot: Robot) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        robot.build(**inputs)
    assert caught.value.exit_code == 2 and caught.value.remedy and robot.targets == []


def test_a_mirrors_password_reaches_code_of_the_repository_only_if_the_person_says_so(robot: Robot) -> None:
    robot.build({"OS_APT_MIRROR": "http://mirror.example:3142/?x=@"}, target="run")
    assert "type=env,id=os-apt-mirror,env=OS_APT_MIRROR" in robot.targets.pop(0)["secret"]
    robot.targets.clear()
    for variable in ("OS_APT_MIRROR", "ROS_APT_MIRROR"):
        for user in ("me:secret", "secret"):
            with pytest.raises(RosmlError, match=f"^{variable} has a password") as caught:
                robot.build({variable: f"https://{user}@mirror.example"})
            assert caught.value.exit_code == 2 and "--allow-mirror-password" in caught.value.remedy
            assert "secret" not in caught.value.message + caught.value.remedy and not robot.targets
    robot.build({"ROS_APT_MIRROR": "https://token@x"}, allow_mirror_password="true")
    assert robot.targets


def test_scripts_get_the_password_for_git_only_if_the_person_says_so(robot: Robot) -> None:
    """Steps with it are others than steps without. What it is decides nothing, and is in no file."""
    robot.build(target="run", git_https_password="canary-77")
    assert not [secret for secret in robot.targets[0]["secret"] if "git" in secret] and not robot.messages_with(
        "password"
    )
    robot.build(target="run", git_https_password="canary-77", git_https_user="", allow_script_secrets="true")
    plain, allowed = robot.targets[0], robot.targets[2]
    secrets = {line.partition(",id=")[2] for line in {*allowed["secret"]} - {*plain["secret"]}}
    assert secrets == {f"git-https-{name},env=GIT_HTTPS_{name.upper()}" for name in ("server", "password")}
    assert allowed["args"] == {**plain["args"], "SCRIPT_SECRETS": "true"}
    assert allowed["variables"]["GIT_HTTPS_PASSWORD"] == "canary-77" and robot.messages_with("--allow-script-secrets")
    assert "GIT_HTTPS_PASSWORD" not in plain["variables"] and "canary" not in json.dumps(robot.bake_file)


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
        ("2", {"arm": ROS_1}, "ROS 2, and src/arm/package.xml is for ROS 1$", "--base-image ros:ros1-bookworm-base$"),
        (
            "2",
            {"arm": ROS_1, "leg": ROS_1, "hand": ROS_2},
            "src/arm/package.xml, src/leg/package.xml are for ROS 1; src/hand/package.xml is for ROS 2$",
            "put a file COLCON_IGNORE into their folders",
        ),
        ("1", {"arm": ROS_2, "leg": AMENT}, "src/arm/package.xml is for ROS 2$", "^name a base image with ROS 2"),
        ("1", {"arm": ROS_1, "hand": BOTH, "leg": AMENT}, "", ""),
        ("2", {"arm": ROS_2, "hand": BOTH, "leg": AMENT}, "", ""),
    ],
)
def test_packages_of_another_ros_than_the_base_images_are_named(
    robot: Robot, ros: str, packages: dict[str, str], says: str, remedy: str
) -> None:
    """Before anything is built. A list, a file or a script may leave them out."""
    robot.put(ROS_DISTRO="x", ROS_VERSION=ros)
    for name, text in packages.items():
        robot.write(f"src/{name}/package.xml", text.format(name))
    if "hand" not in packages and says:
        robot.write("src/robot/COLCON_IGNORE")
    if says:
        with pytest.raises(RosmlError, match=says) as caught:
            robot.build()
        assert re.search(remedy, caught.value.remedy) and caught.value.exit_code == 2 and robot.targets == []
        robot.write("src/hand/package.xml", AMENT.format("hand"))
        robot.write("docker/blacklisted-packages.txt", "arm leg\n")
    robot.build()
    assert robot.targets


KIND = "<package><name>{{}}</name><export><build_type>{}</build_type></export></package>"
EITHER = (
    "<package><name>{}</name><export><build_type condition='$ROS_VERSION == 1'>catkin</build_type>"
    "<build_type condition='$ROS_VERSION == 2'>ament_python</build_type></export></package>"
)


@pytest.mark.parametrize(
    ("text", "lacking"),
    [
        (KIND.format("catkin"), "CMakeLists.txt (catkin)"),
        (KIND.format("ament_cmake"), "CMakeLists.txt (ament_cmake)"),
        (KIND.format("cmake"), "CMakeLists.txt (cmake)"),
        (KIND.format("ament_python"), "setup.py (ament_python)"),
        ("<package><name>{}</name></package>", "CMakeLists.txt (catkin)"),
        (EITHER, "setup.py (ament_python)"),
        (KIND.format("bazel"), ""),
    ],
)
def test_a_package_without_the_file_that_builds_it_is_named_before_anything_is_built(
    robot: Robot, text: str, lacking: str
) -> None:
    """colcon ends with a traceback there, after everything was installed. The shell of `rosml dev` needs no such file."""
    robot.put(ROS_VERSION="2")
    robot.write("src/arm/package.xml", text.format("arm"))
    for name in ("CMakeLists.txt", "setup.py"):
        (robot.folder / "src/arm" / name).unlink()
    if lacking:
        with pytest.raises(RosmlError) as caught:
            robot.build()
        says = f"src/arm/package.xml is of a package that colcon builds by {lacking}, and there is none beside it"
        assert (caught.value.message, caught.value.exit_code, robot.targets) == (says, 2, [])
        assert caught.value.remedy.startswith("write one, or correct <build_type>")
        step_order.build_shell_image(robot.call())
        robot.targets.clear()
        (robot.folder / "src/arm" / lacking.partition(" ")[0]).touch()
        robot.write(".dockerignore", lacking.partition(" ")[0].join(("src/arm/", "\n")))
        with pytest.raises(RosmlError, match=r", and \.dockerignore leaves it out") as caught:
            robot.build()
        assert caught.value.remedy == f"bring it back with a line !src/arm/{lacking.partition(' ')[0]}"
        (robot.folder / ".dockerignore").unlink()
        robot.write("docker/blacklisted-packages.txt", "arm\n")
    robot.build()
    assert robot.targets


WHEELS = "ros-torch:jazzy-wheels-core-cu128"


def of_python(*depends: str) -> str:
    needs = "".join(f"<depend>{key}</depend>" for key in depends)
    return (
        f"<package><name>arm</name>{needs}<depend condition='$ROS_VERSION == 1'>std_srvs</depend>"
        "<export><build_type>ament_python</build_type></export></package>"
    )


@pytest.mark.parametrize(
    ("text", "lacks", "tag"),
    [
        (of_python("rclpy", "cv_bridge", "launch"), "cv_bridge and launch", "ros-torch:jazzy-perception-cu128"),
        (of_python("rclpy", "launch"), "launch", "ros-torch:jazzy-base-cu128"),
        (KIND.format("ament_cmake").format("arm"), "ament_cmake", "ros-torch:jazzy-base-cu128"),
        (of_python("rclpy", "python3-numpy"), "", ""),
    ],
)
@pytest.mark.parametrize("build", ["images", "shell"])
def test_what_the_distribution_lacks_is_said_before_anything_is_built(
    robot: Robot, build: str, text: str, lacks: str, tag: str
) -> None:
    facts = {"distribution": "jazzy-wheels", "framework": "torch", "stack": "cu128"}
    labels = {f"io.rosml.{key}": value for key, value in facts.items()}
    for name in (f"rosml/{WHEELS}", "me/mine:1"):
        robot.put(name, ROS_VERSION="2", config={"Labels": labels})
    robot.write("src/arm/package.xml", text)
    robot.write("src/robot/COLCON_IGNORE")
    registry = robot.services.registry

    def build_on(base: str, **inputs: str) -> None:
        robot.targets.clear()
        call = robot.call(base_image=f"{registry}/{base}", **inputs)
        step_order.build_images(call) if build == "images" else step_order.build_shell_image(call)
        assert robot.targets

    if lacks:
        with pytest.raises(RosmlError) as caught:
            build_on(f"rosml/{WHEELS}")
        assert (caught.value.exit_code, robot.targets) == (2, [])
        assert caught.value.message.endswith(f"{WHEELS} lacks {lacks}, which src/arm/package.xml depends on")
        assert caught.value.remedy.startswith(f"take {tag}: --base-image {registry}/rosml/{tag}; or leave out")
    else:
        build_on(f"rosml/{WHEELS}")
    build_on(f"rosml/{WHEELS}", skip_keys=lacks.replace(" and", ","))
    build_on("me/mine:1")  # somebody may have installed it there
    for name in filter(None, lacks.split(" and ")):
        robot.write(f"src/{name}/package.xml", KIND.format("ament_python").format(name))
    build_on(f"rosml/{WHEELS}")  # the workspace has it


SCRIPT = "BEFORE_DEPENDENCY_IDENTIFICATION_SCRIPT=fix\n"


@pytest.mark.parametrize(
    ("files", "says"),
    [
        ({}, "there is no package.xml in"),
        ({"package.xml": "<package>\n<name>x</nam>"}, "package.xml:2:10: no XML: mismatched tag"),
        ({"package.xml": "<package/>", ".env": SCRIPT, "fix": ""}, "parallel-jobs"),
        ({"my.repos": "repositories: {}\n"}, "parallel-jobs"),
        ({"lists/upstream": "repositories: {}\n", ".env": "VCS_IMPORT_FILE=lists/upstream\n"}, "parallel-jobs"),
    ],
)
def test_a_folder_is_looked_at_before_options_and_services(
    robot: Robot, monkeypatch: pytest.MonkeyPatch, files: dict[str, str], says: str
) -> None:
    """A script may correct its manifests, and a list may bring the packages."""
    monkeypatch.setattr(containerize, "services_for_builds", lambda: pytest.fail("services were asked for"))
    shutil.rmtree(robot.folder / "src")
    for name, text in files.items():
        robot.write(name, text)
    error: Any = CliRunner().invoke(main.cli, ["containerize", str(robot.folder), "--parallel-jobs", "many"]).exception
    assert says in error.message and error.exit_code == 2 and error.remedy


def needing(name: str, tag: str, needed: str, condition: str = "") -> str:
    """A manifest with one dependency, on its third line."""
    when = f' condition="{condition}"' if condition else ""
    return f"<package>\n<name>{name}</name>\n<{tag}{when}>{needed}</{tag}></package>"


RING = "".join(f"\nsrc/{one}/package.xml:3: {one} depends on {other}" for one, other in ("ab", "bc", "ca"))


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
    robot: Robot, tag: str, condition: str, early: bool, late: bool
) -> None:
    """colcon orders packages by all dependencies but those of the documentation. Conditions need the base image."""
    robot.put(ROS_VERSION="2")
    manifests = {"a": needing("a", "depend", "b"), "b": needing("b", "build_depend", "c")}
    for name, text in (manifests | {"c": needing("c", tag, "a", condition)}).items():
        robot.write(f"src/{name}/package.xml", text)

    def ring(check: Callable[[], object]) -> str:
        try:
            check()
        except RosmlError as error:
            assert error.exit_code == 2 and error.remedy.startswith("remove one of these dependencies")
            return error.message[error.message.index("\n") :]
        return ""

    def look() -> None:
        manifest.require(robot.folder, {}, {})

    assert ring(look) == (RING if early else "") and ring(robot.build) == (RING if late else "")
    assert bool(robot.targets) is not late
    robot.write("docker/blacklisted-packages.txt", "c\n")
    assert not ring(look) and not ring(robot.build)


def test_a_package_that_apt_lacks_is_named_with_the_rule_that_asks_for_it(
    robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = {"boost": ["libboost-dev", "liba+b1"], "tree": ["tree"]}
    dependencies = {
        "packages": {"robot": {"exec": ["boost"]}, "arm": {"build": ["boost"], "test": ["tree"]}},
        "keys": {key: [{"installer": "apt", "names": names}] for key, names in names.items()},
        "skipped": [],
    }
    log = ""

    def run(_: object, bake: buildx.Bake) -> tuple[None, dict[str, str]]:
        if bake.target == "packages":
            raise RosmlError(log, "of the step")
        target = json.loads(bake.file.read_text())["target"][bake.target]
        leave(target, {"dependencies.json": json.dumps(dependencies)})
        return None, {}

    monkeypatch.setattr(buildx, "run", run)
    for lacking, keys in (("tree", "boost tree"), ("of-nobody", "boost")):
        log = f"E: Unable to locate package {lacking}\nE: Package 'liba+b1' has no installation candidate"
        with pytest.raises(RosmlError) as caught:
            robot.build()
        rules = caught.value.message.removeprefix(f"{log}\n").splitlines()
        assert rules[0] == "  rosdep's rule for boost, which robot, arm asks for, names liba+b1"
        tree = ["  rosdep's rule for tree, which arm asks for, names tree"]
        assert rules[1:] == (tree if lacking == "tree" else [])
        assert f"--skip-keys '{keys}'" in caught.value.remedy
    log = "E: Unable to locate package of-nobody"
    with pytest.raises(RosmlError) as caught:
        robot.build()
    assert (caught.value.message, caught.value.remedy) == (log, "of the step")


# ---- After the packages were built -----------------------------------------------------------------------------------


def test_no_image_is_made_without_a_package_that_has_a_manifest(robot: Robot) -> None:
    """colcon passes over some with a warning, and ends well."""
    robot.dependencies["packages"] = {"robot": {}, "arm": {}, "leg": {}}
    with pytest.raises(RosmlError, match="colcon has not built arm, leg; no image was made"):
        robot.build()
    assert robot.names == ["packages"]
    robot.app["built"] = ["arm", "leg", "of_the_base", "robot"]
    robot.build()


def answer(monkeypatch: pytest.MonkeyPatch, **results: junit.Tests) -> None:
    """What tests came to, by the folder of their reports: `results`, `slim` or `downstream`."""
    monkeypatch.setattr(junit, "read", lambda folder: results.get(folder.name, junit.Tests()))


LACKS_CV3 = "robot: test.a: its tests could not be collected: ModuleNotFoundError: No module named 'cv3'"


@pytest.mark.parametrize(
    ("results", "says", "remedy"),
    [
        ({"results": ["robot: a.bad: 1 is not 2"]}, "1 of 3 tests failed; no image", "^correct the packages or their"),
        ({"results": [LACKS_CV3]}, "1 of 3 tests failed; no image", "^name what has the module .* test_depend; or"),
        ({"results": [], "slim": ["robot: a.bad: no x.so"]}, "1 of 3 tests failed in the slim image", "exec_depend"),
        ({"results": []}, "none of 3 tests ran in the slim image; no image", "--no-enable-slim"),
        ({"downstream": ["user: a"]}, "1 of 3 tests failed in packages that use yours; no image", "correct yours"),
    ],
)
def test_no_image_is_made_if_a_test_failed(
    results: dict[str, list[str]], says: str, remedy: str, robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot.put("small:1")
    answer(monkeypatch, **{name: junit.Tests(3, 1, tuple(lines)) for name, lines in results.items()})
    with pytest.raises(RosmlError, match=says) as caught:
        robot.build(enable_slim="true", slim_base_image=f"{robot.services.registry}/small:1")
    assert re.search(remedy, caught.value.remedy) and robot.names == ["packages"]
    assert all(line in caught.value.message for lines in results.values() for line in lines)


@pytest.mark.parametrize("failures", [("robot: a.bad: 1 is not 2",), ()])
def test_a_build_that_a_failed_test_ended_says_which(
    robot: Robot, monkeypatch: pytest.MonkeyPatch, failures: tuple[str, ...]
) -> None:
    """The reports alone say so: a stage with code of the packages may have left anything."""
    answer(monkeypatch, results=junit.Tests(3, 0, failures))

    def run_all(services: Any, bake: buildx.Bake) -> tuple[Any, dict[str, dict[str, str]]]:
        facts = robot.run_all(services, bake)
        if bake.target == bake_file.PACKAGES:
            assert bake_file.TESTS in robot.bake_file["group"]["packages"]["targets"]
            raise buildx.StepFailed("building packages failed", "", bake_file.PASSED)
        return facts

    monkeypatch.setattr(buildx, "run_all", run_all)
    with pytest.raises(RosmlError, match="1 of 3 tests failed" if failures else "building packages failed"):
        robot.build()
    assert robot.names == [bake_file.PACKAGES, bake_file.FAILED]


def test_packages_that_use_the_apps_are_built_and_tested(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    fetches: list[dict[str, Any]] = []

    def fetch(*_: object, **options: Any) -> list[sources.Repository]:
        fetches.append(options)
        return []

    monkeypatch.setattr(sources, "fetch", fetch)
    uses = {"downstream_workspace": "uses.repos"}
    with pytest.raises(RosmlError, match=r"there is no file uses\.repos"):
        robot.build(**uses)
    (robot.folder.parent / "outside").write_text("repositories: {}\n")
    (robot.folder / "link").symlink_to("../outside")
    for name in ("../outside", "link"):
        with pytest.raises(RosmlError, match=f"{name} leads out of"):
            robot.build(downstream_workspace=name)
    robot.write("uses.repos", "repositories: {}\n")
    with pytest.raises(RosmlError, match=r"the repositories of uses\.repos have no package"):
        robot.build(**uses)
    fetches.clear()
    user = robot.call().state / "downstream/user/package.xml"
    user.parent.mkdir(parents=True)
    user.write_text(PACKAGE.format("user"))
    robot.build(**uses)
    assert robot.targets[0]["args"]["DOWNSTREAM"] == "downstream-results"
    upstream, downstream = (options["options"] for options in fetches)
    assert upstream.without == downstream.file == "uses.repos" and not downstream.recursive
    robot.build(**uses, tests="false")
    assert robot.bake_file["group"]["packages"]["targets"] == ["report", "results"]
    untested = robot.bake_file["target"]["results"]
    assert (untested["target"], untested["output"]) == ("downstream-built", ["type=cacheonly"]), "they are built"
