"""A distribution whose ROS comes from Python wheels: its images, its lock, and what its target is built from."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner
from conftest import ROOT, WHEELS, changed, parse, write_locks

from rosml.base.errors import RosmlError
from rosml.base.problems import InputError
from rosml.cli.images import listing
from rosml.images.bake import targets
from rosml.images.bake.inputs import TARGET, Inputs
from rosml.images.builds.maker import require_buildable
from rosml.images.image_set import apt_repository, missing_locks
from rosml.images.image_set.explain import explained, why_not
from rosml.images.image_set.load import load
from rosml.images.image_set.locked import with_locks
from rosml.images.image_set.model import ImageSet
from rosml.images.locks import requests, resolve
from rosml.images.matrix import combinations, lacks

LOCK = "locks/sigma/amd64/3.12/ros.txt"
ROW = "distributions.sigma"


@pytest.fixture(scope="module")
def wheels() -> ImageSet:
    return parse(WHEELS)


# ---- Images ----------------------------------------------------------------------------------------------------------


def test_images(wheels: ImageSet) -> None:
    image = wheels.image("sigma-core")
    assert (image.packages, image.wheels) == ("", ("ros-alpha-rclpy[fastrtps]==7.1.6", "ros-std-msgs==5.3.6"))
    assert (image.parent, image.ros_distro, image.locks) == ("_os-ubuntu-24-04", "alpha", (LOCK,))
    assert image.tests == ("contract", "tools", "ros2-wheels", "pip")
    joined = wheels.image("sigma-core-ml-cu1")
    assert (joined.parent, joined.wheels, joined.locks[0]) == ("sigma-core", (), LOCK)
    assert joined.locks[1:] == wheels.image("alpha-core-ml-cu1").locks
    assert joined.tests == ("contract", "tools", "ros2-wheels", "cuda", "torch", "tensorflow", "torch-build", "pip")


def test_it_never_gets_latest(wheels: ImageSet) -> None:
    with_base = parse(changed("components: [core]\n", "components: [base]\n", WHEELS))
    assert with_base.image("sigma-base").tags == ("ros:sigma-base", "ros:sigma")
    assert with_base.by_tag("ros:latest") == with_base.image("alpha-base")


def test_a_row_may_exist_for_fewer_architectures_than_its_system(wheels: ImageSet) -> None:
    assert combinations.built_for(wheels.matrix, "alpha") == ("amd64", "arm64")
    assert combinations.built_for(wheels.matrix, "sigma") == ("amd64",)
    assert wheels.image("sigma-core").platforms == ("linux/amd64",)
    assert "\n  - not for arm64: sigma exists for amd64 only\n" in explained(wheels, "sigma-core").text
    assert why_not(wheels, "sigma-core-torch-cpu") == (
        "sigma-core-torch-cpu does not exist: torch 2.10.0 has cpu wheels for arm64 only, and sigma is built for amd64."
    )
    assert wheels.part_by_name == parse(WHEELS.replace("    architectures: [amd64]\n", "")).part_by_name


def test_explain_says_where_ros_comes_from(wheels: ImageSet) -> None:
    lines = explained(wheels, "sigma-core").text.splitlines()
    assert "  - sigma is experimental: docs/limits.md says what it has, and it never gets the tag latest" in lines
    wheel_names = "ros-alpha-rclpy[fastrtps]==7.1.6 and ros-std-msgs==5.3.6"
    assert f"  - it is ubuntu-24.04 with ROS from wheels: {wheel_names}, and what they need, by {LOCK}" in lines
    assert "experimental" not in explained(wheels, "alpha-core").text
    experimental = parse(changed("    apt: {channel: live}", "    apt: {channel: live}\n    experimental: true"))
    text = explained(experimental, "alpha-core").text
    assert "\n  - alpha is experimental: it never gets the tag latest\n" in text, "the page is about ROS 2 from wheels"


LACKS = WHEELS.replace(
    "    lts: true\n    experimental: true\n", "    experimental: true\n    lacks: [launch, seen, cli, more, last]\n"
)
TAKE = "take ros{0}:alpha-base{1}"


def test_what_it_lacks_is_said_with_what_to_take_instead(tmp_path: Path) -> None:
    """It has the same framework on the same stack, if there is such an image."""
    image_set = parse(LACKS)
    without = "sigma has ROS 2 for Python alone, without launch, seen, cli, more, last; "
    assert f"{without}{TAKE.format('', '')}" in explained(image_set, "sigma-core").reasons
    assert f"{without}{TAKE.format('-torch', '-cu1')}" in explained(image_set, "sigma-core-torch-cu1").reasons
    assert explained(image_set, "sigma").text.endswith(f"rosml list sigma\n{without}{TAKE.format('', '')}")
    assert "without" not in explained(image_set, "alpha-core").text
    assert why_not(image_set, "sigma-base") == (
        "sigma-base does not exist: sigma (ROS 2) has no base metapackage; it has core; alpha has it."
    )
    (tmp_path / "matrix.yaml").write_text(LACKS)
    for row, expected in (("sigma", [f"{without}{TAKE.format('', '')}"]), ("alpha", [])):
        output = CliRunner().invoke(listing.main, [row, "--matrix", str(tmp_path / "matrix.yaml")]).output
        assert [line for line in output.splitlines() if "without launch" in line] == expected


def test_labels_of_a_base_image_may_say_anything() -> None:
    """They choose the framework and the stack of the image to take instead."""
    matrix = parse(LACKS).matrix
    for framework, stack in (("torch", "cu9"), ("x", "cu1"), ("torch", ""), ("none", "")):
        assert lacks.instead(matrix, "sigma", ["launch"], framework, stack) == "ros:alpha-base"
    assert lacks.instead(matrix, "sigma", ["launch"], "torch", "cu1") == "ros-torch:alpha-base-cu1"


def test_a_lock_has_nothing_of_what_a_row_lacks(real: ImageSet) -> None:
    """In the matrix, and there is another row that has it: perception for what people search there."""
    for name, row in real.matrix.distributions.items():
        image = next(it for it in real.images if it.distribution == name)
        texts = [(ROOT / lock).read_text() for lock in (image.locks if image.wheels else ())]
        wheels = {
            wheel.replace("-", "_") for text in texts for wheel in re.findall("^ros-([a-z0-9-]+)==", text, re.MULTILINE)
        }
        assert wheels.isdisjoint(row.lacks), name
        assert bool(row.lacks) == bool(row.wheels), "people expect all of ROS of others"
    assert lacks.instead(real.matrix, "jazzy-wheels") == "ros:jazzy-base"
    assert lacks.instead(real.matrix, "jazzy-wheels", ["launch", "cv_bridge"]) == "ros:jazzy-perception"


def test_no_other_channel(wheels: ImageSet) -> None:
    with pytest.raises(RosmlError, match="the ROS packages of sigma are wheels: there is no other channel"):
        apt_repository.of(wheels.matrix, "sigma", {"ROS_CHANNEL": "final"})


# ---- Mistakes --------------------------------------------------------------------------------------------------------

PACKAGES = "    packages: ros-{ros_distro}-{metapackage}\n"
SOURCE = '    wheels: ["ros-alpha-rclpy[fastrtps]==7.1.6", ros-std-msgs==5.3.6]\n'
WRONG = {
    "neither": (SOURCE, "", f"{ROW}: nothing says what ROS comes from"),
    "both": (SOURCE, SOURCE + PACKAGES, f"{ROW}.wheels: ROS comes from 'packages' already"),
    "not pinned": ("ros-std-msgs==5.3.6", "ros-std-msgs", f"{ROW}.wheels[1]: expected a Python package with its version"),
    "ROS 1": ("    ros: 2\n    ros_distro", "    ros: 1\n    ros_distro", f"{ROW}.wheels: there are no wheels of ROS 1"),
    "two components": ("components: [core]\n", "components: [core, base]\n", f"{ROW}.components: the wheels of sigma are one"),
    "an apt source": (SOURCE, SOURCE + "    apt: {channel: live}\n", f"{ROW}.apt: 'apt' is about Debian packages"),
    "another RMW": (SOURCE, SOURCE + "    rmw: [rmw_cyclonedds_cpp]\n", f"{ROW}.rmw: 'rmw' is about Debian packages"),
    "unknown architecture": ("    architectures: [amd64]\n", "    architectures: [amd46]\n", f"{ROW}.architectures[0]: no architecture named 'amd46'"),
    "an option": ("tools: colcon python3-numpy", "tools: colcon -y", f"{ROW}.tools: no package is called '-y'"),
    "an architecture of another system": ("architectures: [amd64, arm64]\n    tools: colcon\n    codename: noble", "architectures: [arm64]\n    tools: colcon\n    codename: noble", "ubuntu-24.04 is built for arm64 only; remove amd64"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_mistakes(name: str) -> None:
    before, after, problem = WRONG[name]
    with pytest.raises(InputError) as caught:
        parse(WHEELS.replace(before, after))
    assert problem in " ".join(f"{item.path}: {item.text}" for item in caught.value.problems)


# ---- The bake file and inputs ----------------------------------------------------------------------------------------


def test_targets(wheels: ImageSet) -> None:
    bake_targets = targets.of(wheels)
    core = bake_targets["sigma-core"]
    texts = {name: value for name, value in core.arguments.items() if isinstance(value, str)}
    ros = {"ROS_DISTRO": "alpha", "ROS_VERSION": "2", "ROS_ROW": "sigma"}
    assert (core.stage, texts) == ("ros-wheels", ros | {"PYTHON": "3.12", "ROS_TOOLS": "colcon python3-numpy"})
    assert core.contexts["os"] == targets.Overridable(
        "OS_UBUNTU_24_04", f"docker-image://docker.io/library/ubuntu:24.04@sha256:{'1' * 64}"
    )
    assert core.platforms == ("linux/amd64",)
    assert core.labels["io.rosml.experimental"] == "true"
    assert "io.rosml.experimental" not in bake_targets["alpha-core"].labels
    expected = str(bake_targets["sigma-core-torch-cu1-test"].arguments["EXPECT"]).split()
    assert "wheels=ros-alpha-rclpy==7.1.6,ros-std-msgs==5.3.6" in expected


def test_images_that_are_joined_alike_may_differ_in_platforms() -> None:
    """The order of the rows does not matter."""
    text = WHEELS.replace("wheels: {cu1: [amd64], cpu: [arm64]}", "wheels: {cu1: [amd64], cpu: [amd64, arm64]}")
    rows, row = text.split("  alpha:\n    os")[0], text[text.index("  sigma:\n") : text.index("disk:\n")]
    first = rows + row + text[len(rows) :].replace(row, "")
    for image_set in (parse(text), parse(first)):
        bake_targets = targets.of(image_set)
        assert bake_targets["sigma-core-torch-cpu"].platforms == ("linux/amd64",)
        assert bake_targets["alpha-core-torch-cpu"].platforms == ("linux/amd64", "linux/arm64")


def test_inputs(real: ImageSet) -> None:
    """A change of the lock, of the script or of the tools builds the row anew, and what stands on it."""
    inputs = Inputs(ROOT, real)
    names = inputs.of("jazzy-wheels-core", "amd64")
    assert {"locks/jazzy-wheels/amd64/3.11/ros.txt", "components/ros/wheels.sh", "argument ROS_TOOLS"} <= names.keys()
    assert {"components/part/bytecode.sh", "tools/requirements.txt"} <= names.keys()
    assert f"{TARGET}jazzy-wheels-core" in inputs.of("jazzy-wheels-core-torch-cu128", "amd64")
    assert not any("jazzy-wheels" in name for name in inputs.of("ros1-bookworm-core", "amd64"))


# ---- The lock --------------------------------------------------------------------------------------------------------


def test_a_missing_lock_is_named_like_others(wheels: ImageSet) -> None:
    image_set = with_locks(wheels, wheels.locks - {LOCK})
    images = [image for image in image_set.images if not image.locked]
    assert {image.distribution for image in images} == {"sigma"}
    assert all(image.unlocked == image.lost == (LOCK,) for image in images)
    assert "sigma" not in image_set.groups
    problem = missing_locks.lost(image_set)
    assert problem is not None
    assert problem.message.endswith(f"): {LOCK} is missing")
    assert problem.remedy == missing_locks.RESTORE
    assert explained(image_set, "sigma-core").text.endswith(f"\n  - {LOCK} is missing; run 'rosml locks'")
    assert targets.of(image_set)["sigma-core"].description == "cannot be built yet: no lock; run 'rosml locks'"
    with pytest.raises(RosmlError, match=f"sigma-core cannot be built yet: {LOCK} is missing"):
        require_buildable(image_set.image("sigma-core"), "amd64")


def test_a_lock_of_other_wheels_is_none(wheels: ImageSet, tmp_path: Path) -> None:
    (tmp_path / "matrix.yaml").write_text(WHEELS)
    write_locks(tmp_path, wheels)
    whole = (tmp_path / LOCK).read_text()
    assert all(image.locked for image in load(tmp_path / "matrix.yaml", tmp_path).images)
    for before, after in (("7.1.6", "7.1.5"), ("of sigma", "of alpha"), ("amd64", "arm64"), ("    --hash", "--hash")):
        (tmp_path / LOCK).write_text(whole.replace(before, after))
        assert not load(tmp_path / "matrix.yaml", tmp_path).image("sigma-core").locked, after


def test_the_lock_is_resolved_for_its_python_and_numpy(wheels: ImageSet) -> None:
    (request,) = [item for item in requests.requests(wheels) if item.ros]
    assert (request.stack, request.architecture, request.python, request.numpy) == ("sigma", "amd64", "3.12", "<2")
    roots = {"ros-alpha-rclpy": "ros-alpha-rclpy[fastrtps]==7.1.6", "ros-std-msgs": "ros-std-msgs==5.3.6"}
    assert request.roots == roots


def test_the_committed_lock_has_nothing_that_the_system_has(real: ImageSet) -> None:
    (item,) = real.wheels
    text = (ROOT / item.locks[0]).read_text()
    pins = {pin.name for pin in resolve.parse(text)}
    assert not pins & {"numpy", *real.matrix.operating_systems[item.os].provides}
    assert {"ros-rclpy", "ros-rmw-fastrtps-cpp", "ros-sensor-msgs"} <= pins
    assert not re.search(r"https?://|--(extra-)?index-url", text)
