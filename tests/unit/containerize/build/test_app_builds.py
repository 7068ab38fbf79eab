"""An app's build: what the builder gets, what a cache and a lock file decide, and what stops an image."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from fakes.apps import PACKAGE, Robot, leave, robot, services
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.cli import main
from rosml.cli.containerize import containerize
from rosml.containerize import lock
from rosml.containerize.base_image import rosdep_index
from rosml.containerize.build import app, bake_file, dev_folder, junit, stage_cache
from rosml.containerize.build.result import ShellImage
from rosml.containerize.names import DESK
from rosml.containerize.packages import manifest
from rosml.containerize.sources import fetch as sources
from rosml.images.builds import variables
from rosml.images.image_set import load
from rosml.machine import buildx, git

__all__ = ["robot", "services"]

Results = Callable[[junit.Tests], None]


def answer(monkeypatch: pytest.MonkeyPatch, **results: junit.Tests) -> None:
    """What tests came to, by the folder of their reports: `results`, `slim` or `downstream`."""
    monkeypatch.setattr(junit, "read", lambda folder: results.get(folder.name, junit.Tests()))


# ---- What the builder gets -------------------------------------------------------------------------------------------


def test_images_are_joined_after_the_report_is_read(robot: Robot) -> None:
    digest = robot.put()
    command = 'ros2 run robot "a $b" \\\n${HOME} %{x}'
    result = robot.build(command=command, rmw_implementation="rmw_zenoh_cpp")
    local = robot.services.registry
    assert [image.reference for image in result.images] == [f"{local}/robot:latest", f"{local}/robot:latest-dev"]
    report, run, dev = robot.targets
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
    assert run["labels"][bake_file.BASE_DIGEST] == digest
    assert dev["dockerfile-inline"].startswith("FROM workspace\n")


def test_json_has_the_fields_of_the_result_and_of_its_outcome(robot: Robot) -> None:
    fields = json.loads(json.dumps(robot.build().to_json()))
    assert fields["images"][0] == {
        "target": "run",
        "reference": f"{robot.services.registry}/robot:latest",
        "digest": "sha256:1",
    }
    assert {"tests", "slim_tests", "downstream_tests", "reports", "locked", "described", "waited"} <= fields.keys()
    assert fields["tests"] == {"count": 0, "skipped": 0, "failures": []}
    assert (fields["packages"], fields["installed"], fields["lock"]["format"]) == (["robot"], ["libfoo:all"], 1)


def test_the_image_for_rosml_dev_is_the_same_for_each_commit(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is no reason to leave a container that runs. The packages are neither built nor tested for it."""
    values = replace(robot.values(), image_name="ghcr.io/me/robot", push=True)
    for commit in ("a", "b"):
        monkeypatch.setattr(git, "commit", lambda *_, commit=commit: git.Commit(commit, ord(commit)))
        call = app.new_call(robot.folder, dev_folder.image_values(values, robot.folder), {}, robot.services, print)
        name = f"{robot.services.registry}/{dev_folder.image_name(robot.folder)}"
        assert app.build_shell_image(call) == ShellImage(f"{name}@sha256:1", False, None)
    first, second = robot.targets
    assert first == second and first["name"] == DESK and first["dockerfile-inline"].startswith(f"FROM {DESK}\n")
    assert "APP_DEFAULT_CMD" not in first["args"]


def test_the_number_of_compilers_is_no_part_of_what_a_step_is_made_from(robot: Robot) -> None:
    """Who lowers it after a failure goes on from there."""
    for jobs in ("", "3"):
        robot.build(target="run", parallel_jobs=jobs)
    plain, limited = robot.targets[0], robot.targets[2]
    secret = "type=env,id=parallel-jobs,env=PARALLEL_JOBS"
    assert secret in limited["secret"] and secret not in plain["secret"]
    assert limited["variables"] == {"PARALLEL_JOBS": "3"}
    assert {**limited, "secret": [], "variables": {}} == {**plain, "secret": [], "variables": {}}


def test_scripts_that_run_code_of_packages_are_those_of_the_build() -> None:
    """Their output is not searched for reasons of ours."""
    dockerfile = (bake_file.SCRIPTS / "containerize/Dockerfile").read_text()
    called = set(re.findall(r"/run/(scripts/containerize/\w+\.sh)(?= \w+$| /tests)", dockerfile, re.M))
    texts = {name: (bake_file.SCRIPTS / name.removeprefix("scripts/")).read_text() for name in called}
    runs = {name for name, text in texts.items() if re.search(r"^ *colcon (build|test)\b", text, re.M)}
    assert runs == set(bake_file.FOREIGN)


def test_a_run_image_starts_from_its_packages_if_they_replace_some_of_the_base(robot: Robot) -> None:
    robot.put(config={"User": "robot:1000"})
    robot.app["replaced"] = ["libbar:amd64"]
    result = robot.build()
    lines = robot.targets[1]["dockerfile-inline"].splitlines()
    assert lines[:3] == ["FROM runtime", "COPY --link --from=app / /", "USER robot:1000"], "as the base image starts"
    assert robot.targets[1]["contexts"].keys() == {"base", "runtime", "app"}
    assert "libbar:amd64" in dict(result.summary())[""]


OURS = {"io.rosml.distribution": "jazzy", "io.rosml.runtime": "base-run"}


def test_a_slim_image_starts_from_the_base_image_without_compilers(robot: Robot) -> None:
    robot.put(config={"Labels": OURS})
    labels = {"io.rosml.distribution": "jazzy", "io.rosml.component": "base-run"}
    digest = robot.put("rosml/ros:jazzy-base-run", config={"Labels": labels})
    local = robot.services.registry
    result = robot.build(target="run", enable_slim="true")
    assert [image.reference for image in result.images] == [f"{local}/robot:{tag}" for tag in ("latest", "latest-slim")]
    slim = robot.targets[-1]
    assert slim["contexts"]["slim"] == f"docker-image://{local}/rosml/ros@{digest}"
    assert slim["dockerfile-inline"].splitlines()[:2] == ["FROM slim", "COPY --link --from=slim-app / /"]
    assert slim["args"]["APP_DEFAULT_CMD"] == "true" and slim["labels"][bake_file.BASE_DIGEST] == digest
    assert robot.targets[0]["target"] == "slim-report"

    robot.slim_app["removed"] = ["usr/bin/less"]
    result = robot.build(target="run", enable_slim="true", slim_image_name="small", slim_image_tag="1")
    run, slim = robot.targets[-2:]
    assert [target["dockerfile-inline"].splitlines()[0] for target in (run, slim)] == ["FROM base", "FROM slim-runtime"]
    assert slim["tags"] == [f"{local}/small:1"]
    assert "the slim one, of which its packages change 1 thing: usr/bin/less" in dict(result.summary())[""]


def test_no_slim_image_is_made_if_no_base_image_is_found(robot: Robot) -> None:
    """It is said. If somebody names one, it is an error."""
    local = robot.services.registry
    robot.put(config={"Labels": OURS})
    robot.put("plain:1")
    for name, why in (
        ("ros:jazzy", f"there is no {local}/rosml/ros:jazzy-base-run"),
        (f"{local}/plain:1", f"{local}/plain:1 does not say which base image has no compilers"),
    ):
        robot.build(base_image=name, target="run", enable_slim="true")
        assert robot.names[-1] == "run" and robot.said(f"no slim image: {why}; name one with --slim-base-image")
    with pytest.raises(RosmlError, match="there is no image typo"):
        robot.build(enable_slim="true", slim_base_image="typo")


def test_names_and_tags_are_those_of_docker_ros(robot: Robot) -> None:
    name = f"{robot.services.registry}/me/robot"
    robot.build(image_name=name, image_tag="v1", push="true", enable_push_as_latest="true")
    assert robot.targets[1]["tags"] == [f"{name}:v1", f"{name}:latest"]
    assert robot.targets[2]["tags"] == [f"{name}:v1-dev", f"{name}:latest-dev"]


def test_ros_is_installed_on_a_base_that_has_none(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    """By the steps of our own images, on it by its digest, and kept as a stage of its own. An image is looked at once."""
    starts = {"WorkingDir": "/opt/sdk", "Entrypoint": ["./start.sh"], "Env": ["LANG=de", "CUDA_VERSION=13.0.1"]}
    digest = robot.put("rosml/plain:1", config=starts)
    monkeypatch.setattr(variables, "sync_date", lambda *_: "2026-11-20T21:14:09Z")
    inputs = {"base_image": "plain:1", "cache": robot.cache}
    for _ in range(2):
        robot.build(**inputs)
    assert robot.said("its entrypoint runs before each command: /opt/sdk/start.sh")
    assert robot.names.count("system") == 1
    targets = robot.bake_file["target"]
    assert targets["report"]["contexts"]["base"] == targets["run"]["contexts"]["base"] == "target:base"
    names = [name := "base"]
    while name := targets[name]["contexts"][next(iter(targets[name]["contexts"]))].partition("target:")[2]:
        names.append(name)
    assert names == ["base", "base-jazzy-core", "base-os-ubuntu-24-04", "base-system"]
    reference = f"docker-image://{robot.services.registry}/rosml/plain@{digest}"
    assert targets["base-system"]["contexts"] == {"os": reference}
    assert targets["base-jazzy-core"]["args"]["ROS_SYNC_DATE"] == "2026-11-20T21:14:09Z"
    assert targets["base"]["args"] == {"KEPT_LANG": "de"}
    entrypoint = 'ENTRYPOINT ["/tini", "--", "/entrypoint.sh", "/opt/sdk/start.sh"]'
    assert entrypoint in targets["base"]["dockerfile-inline"].splitlines()
    assert targets["base"]["labels"]["io.rosml.own"] == "CUDA_VERSION"
    assert targets["base"]["labels"]["io.rosml.distribution"] == "jazzy"
    monkeypatch.setattr(variables, "sync_date", lambda *_: "2026-11-27T21:14:09Z")
    robot.build(**inputs)
    kept = [content["target"]["keep-base"]["output"] for content in ({"target": targets}, robot.bake_file)]
    assert kept[0] != kept[1], "ROS has other packages"
    robot.build(renew=True, **inputs)
    assert "it has no versions of the ROS that was installed" in robot.messages[-1]


def test_a_base_without_ros_stays_without_if_somebody_says_so(robot: Robot) -> None:
    robot.put("rosml/plain:1", config={"Env": []})
    inputs = {"base_image": "plain:1", "disable_ros_installation": "true"}
    with pytest.raises(RosmlError, match="does not say which ROS it has") as caught:
        robot.build(**inputs)
    assert "--ros-distro" in caught.value.remedy
    robot.build(**inputs, ros_distro="jazzy")
    assert robot.targets[-1]["args"]["APP_ROS_DISTRO"] == "jazzy" and robot.names[0] == "packages"


# ---- What is said of the sources -------------------------------------------------------------------------------------


def test_a_name_to_leave_out_that_no_package_has_is_a_warning(robot: Robot) -> None:
    robot.write("docker/blacklisted-packages.txt", "robott # once\nrobot\nof_another_time\n")
    robot.build()
    first, second = robot.said("which is to be left out")
    assert "called robott" in first and "did you mean 'robot'?" in first and "of_another_time" in second
    robot.messages.clear()
    robot.write("docker/before_dependency_identification.sh", "true\n")
    robot.build()
    assert not robot.said("left out"), "a script may make such a package"


def test_submodules_that_nobody_fetched_are_named(robot: Robot) -> None:
    """As `git clone` alone leaves them: a package in them is one that rosdep does not know."""
    (robot.folder / "src/empty").mkdir()
    names = ("src/robot", "src/empty", "src/gone away")
    sections = "".join(f'[submodule "{name}"]\n\tpath = {name}\n' for name in names)
    robot.write(".gitmodules", f"{sections}\turl = ../x\n")
    robot.build()
    said = robot.said("is not there: git submodule update --init --recursive")
    assert [line.partition(" is not")[0] for line in said] == [f"the submodule {name}" for name in names[1:]]


def test_files_of_git_lfs_that_nobody_fetched_are_named(robot: Robot) -> None:
    """As `git clone` leaves them where git-lfs is not installed: a mesh is a line of text then."""
    for name in ("arm.dae", "leg.dae"):
        robot.write(name, "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 12345\n")
    robot.write("hand.dae", "<COLLADA/>")
    robot.build()
    assert not robot.said("Git LFS"), "a test of something that reads pointers, perhaps"
    robot.write(".gitattributes", "*.dae filter=lfs diff=lfs merge=lfs -text\n")
    robot.build()
    [line] = robot.said("Git LFS")
    assert line.startswith("arm.dae and 1 file more") and "git lfs pull" in line


def test_another_ros_than_the_base_images_is_not_used(robot: Robot) -> None:
    robot.build(ros_distro="jazzy")
    assert not robot.said("ROS_DISTRO")
    robot.build(ros_distro="humble")
    assert robot.said("ROS_DISTRO=humble is not used: the base image has jazzy")


@pytest.mark.parametrize(
    ("base_has", "ros_distro", "compared"),
    [
        ("Debian", "", "noetic"),
        ("Debian", "Debian", "noetic"),
        ("Debian", "melodic", "melodic"),
        ("jazzy", "humble", "jazzy"),
    ],
)
def test_conditions_compare_with_a_release(base_has: str, ros_distro: str, compared: str, robot: Robot) -> None:
    """No manifest compares with what Debian calls its own ROS."""
    robot.put(ROS_DISTRO=base_has)
    robot.build(ros_distro=ros_distro)
    arguments = robot.targets[0]["args"]
    assert (arguments["ROS_DISTRO"], arguments["CONDITIONS"]) == (base_has, compared)


# ---- Lock files and caches -------------------------------------------------------------------------------------------


def test_a_lock_file_is_written_then_followed(robot: Robot) -> None:
    robot.app["apt"] = {"tree": "2.1"}
    digest = robot.put()
    result = robot.build(renew=True)
    assert (Path(robot.targets[0]["contexts"]["requests"]) / "renewed").exists(), "no step of an earlier build counts"
    file = robot.folder / "containerize.lock"
    assert dict(result.summary())["lock"] == str(file)
    label = robot.targets[1]["labels"][bake_file.LOCK]
    robot.put(NEWER="1")
    robot.targets.clear()
    assert robot.build().lock_file == ""
    report, run, _ = robot.targets
    requests = Path(report["contexts"]["requests"])
    assert not (requests / "renewed").exists() and (requests / "lock/amd64/apt").read_text() == "tree 2.1\n"
    assert report["contexts"]["base"].endswith(f"@{digest}") and run["labels"][bake_file.LOCK] == label
    assert not (Path(report["contexts"]["target"]) / "target/containerize.lock").exists(), "it is no source"

    robot.put("small:1")
    with pytest.raises(RosmlError, match="the lock file has no slim image"):
        robot.build(enable_slim="true", slim_base_image=f"{robot.services.registry}/small:1")
    file.write_text("<<<<<<< HEAD\n")
    robot.build(renew=True)
    assert robot.said("is no lock file") and lock.read(file, robot.folder), "a damaged file is written again"
    with pytest.raises(RosmlError, match="the lock file is of ros:jazzy, and not of ros:other"):
        robot.build(base_image="ros:other")


def test_a_lock_file_that_is_renewed_takes_nothing_from_a_cache(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stage_cache.Cache, "stages", lambda *_: pytest.fail("what is there may be outdated"))
    robot.build(renew=True, cache=robot.cache)


def test_a_relative_index_of_rosdep_is_one_of_the_folder(robot: Robot) -> None:
    robot.write("lists/rosdep/own.yaml", "a: {}\n")
    robot.build(rosdep_index="lists")
    assert (Path(robot.targets[0]["contexts"]["rosdep"]) / "rosdep/own.yaml").read_text() == "a: {}\n"
    (robot.folder / "lists/rosdep/secret.yaml").symlink_to("/etc/hostname")
    with pytest.raises(RosmlError, match=r"secret\.yaml leads out of"):
        robot.build(rosdep_index="lists")


def cached(robot: Robot, monkeypatch: pytest.MonkeyPatch, *stages: str) -> None:
    """A cache that has these stages, and no report."""
    present = dict.fromkeys(stages, f"{robot.cache}@sha256:{'1' * 64}")
    monkeypatch.setattr(stage_cache.Cache, "stages", lambda *_: present)


def test_a_cache_with_the_dependencies_needs_no_lists_of_rosdep(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    names: list[str] = []
    monkeypatch.setattr(rosdep_index.Finder, "find", lambda _self, name, *_: names.append(name))
    cached(robot, monkeypatch)
    robot.build(cache=robot.cache)
    cached(robot, monkeypatch, "identified")
    robot.build(cache=robot.cache)
    assert names == [""]
    robot.build(cache=robot.cache, rosdep_index="rosdep:1")
    assert names == ["", "rosdep:1"], "its digest is a part of the key"


def test_a_stage_that_a_cache_has_lost_is_built_although_its_report_is_there(
    robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Somebody pruned the registry."""
    stages = ("identified", "environment", "runtime", "upstream-built", "workspace", "app")
    for present in ((), stages, stages[:-1]):
        cached(robot, monkeypatch, *present)
        robot.build(cache=robot.cache, tests="false")
    assert robot.names == ["packages", "run", "dev", "run", "dev", "packages", "run", "dev"]
    assert robot.said("nothing to build")


def test_each_script_that_a_build_calls_decides_what_a_cache_has(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    scripts = robot.folder.parent / "components"
    shutil.copytree(bake_file.SCRIPTS, scripts)
    monkeypatch.setattr(bake_file, "SCRIPTS", scripts)

    def runtime() -> str:
        robot.build(cache=robot.cache)
        return json.dumps(robot.bake_file["target"]["keep-runtime"]["output"])

    tags = {runtime()}
    dockerfile = (scripts / "containerize/Dockerfile").read_text()
    called = sorted(set(re.findall(r"from=scripts,source=([a-z_/]+\.(?:sh|py))", dockerfile)))
    for name in called:
        (scripts / name).write_text("changed")
        tags.add(runtime())
    assert len(tags) == 1 + len(called)


# ---- What stops a build before it begins -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("inputs", "says"),
    [
        ({"base_image": ""}, "there is no base image"),
        ({"command": ""}, "there is no command for the run image"),
        ({"colcon_args": "--merge-install --symlink-install"}, "colcon-args: with --symlink-install"),
        ({"target": "run,slim"}, "'slim' is no target"),
        ({"image_name": "Robot!"}, "'Robot!' is no name of an image"),
        ({"image_tag": "a b"}, "'a b' is no tag"),
        ({"image_name": "rosml/ros"}, "is no name for an app"),
        ({"dev_image_name": "library/debian"}, "is no name for an app"),
        ({"image_name": "ghcr.io/me/robot"}, "there is no Docker here"),
    ],
)
def test_what_is_wrong_is_said_before_anything_is_built(inputs: dict[str, str], says: str, robot: Robot) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        robot.build(**inputs)
    assert caught.value.exit_code == 2 and caught.value.remedy and robot.targets == []


@pytest.mark.parametrize(
    ("mirrors", "secret"),
    [
        ({"OS_APT_MIRROR": "http://mirror.example:3142"}, []),
        ({"OS_APT_MIRROR": "https://me:secret@mirror.example"}, ["OS_APT_MIRROR"]),
        (dict.fromkeys(("OS_APT_MIRROR", "ROS_APT_MIRROR"), "https://token@x"), ["OS_APT_MIRROR", "ROS_APT_MIRROR"]),
    ],
)
def test_a_mirrors_password_reaches_code_of_the_repository_only_if_the_person_says_so(
    mirrors: dict[str, str], secret: list[str], robot: Robot
) -> None:
    if secret:
        with pytest.raises(RosmlError, match=f"^{' and '.join(secret)} has a password") as caught:
            robot.build(mirrors)
        assert caught.value.exit_code == 2 and "--allow-mirror-password" in caught.value.remedy and not robot.targets
        assert "secret" not in caught.value.message + caught.value.remedy
    robot.build(mirrors, allow_mirror_password=str(bool(secret)).lower())
    assert robot.targets


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
        ("1", {"arm": ROS_2}, "ROS 1, and src/arm/package.xml is for ROS 2$", "--base-image ros:jazzy-base$"),
        (
            "2",
            {"arm": ROS_1, "leg": ROS_1, "hand": ROS_2},
            "src/arm/package.xml, src/leg/package.xml are for ROS 1; src/hand/package.xml is for ROS 2$",
            "put a file COLCON_IGNORE into their folders",
        ),
        ("1", {"arm": ROS_2, "leg": AMENT}, "src/arm/package.xml is for ROS 2$", "^name a base image with ROS 2"),
        ("1", {"arm": ROS_1, "hand": BOTH, "leg": AMENT}, "", ""),
        ("2", {"arm": ROS_2, "hand": BOTH, "leg": AMENT}, "", ""),
        ("", {"arm": ROS_1, "hand": ROS_2}, "", ""),
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


def test_examples_of_base_images_are_tags() -> None:
    images = load.load(ROOT / "matrix.yaml")
    assert {ros: images.image(tag).ros for ros, tag in manifest.EXAMPLES.items()} == {1: 1, 2: 2}


SCRIPT = "BEFORE_DEPENDENCY_IDENTIFICATION_SCRIPT=fix\n"


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
            return error.message
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


# ---- What stops an image ---------------------------------------------------------------------------------------------


def test_no_image_is_made_without_a_package_that_has_a_manifest(robot: Robot) -> None:
    """colcon passes over some with a warning, and ends well."""
    robot.dependencies["packages"] = {"robot": {}, "arm": {}, "leg": {}}
    with pytest.raises(RosmlError, match="colcon has not built arm, leg; no image was made"):
        robot.build()
    assert robot.names == ["packages"]
    robot.app["built"] = ["arm", "leg", "of_the_base", "robot"]
    robot.build()


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
    monkeypatch.setattr(sources, "fetch", lambda *_, **options: fetches.append(options) or [])
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
    assert fetches[0]["without"] == fetches[1]["file"] == "uses.repos" and not fetches[1]["recursive"]
    robot.build(**uses, tests="false")
    assert robot.bake_file["group"]["packages"]["targets"] == ["report", "results"]
    untested = robot.bake_file["target"]["results"]
    assert (untested["target"], untested["output"]) == ("downstream-built", ["type=cacheonly"]), "they are built"
