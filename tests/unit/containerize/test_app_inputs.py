"""What users say about an app: options before the environment before `.env`, and names of docker-ros that mean nothing."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from rosml.base.errors import RosmlError
from rosml.containerize import env_file
from rosml.containerize import inputs as app_inputs
from rosml.containerize.packages import workspace


def test_the_command_line_wins_over_the_environment_and_that_over_the_file(tmp_path: Path) -> None:
    (tmp_path / ".env").write_text("BASE_IMAGE=file\nCOMMAND=file\nIMAGE_TAG=file\n")
    found = app_inputs.values({"base-image": "line"}, tmp_path, {"BASE_IMAGE": "variable", "COMMAND": "variable"})
    assert (found.base_image, found.command, found.image_tag) == ("line", "variable", "file")
    assert found.cmake_args == "-DCMAKE_BUILD_TYPE=Release"


def test_an_empty_value_counts_on_the_command_line_alone(tmp_path: Path) -> None:
    (tmp_path / ".env").write_text("CMAKE_ARGS=-DX=1\nIMAGE_TAG=\nIMAGE=robot:v1\n")
    assert app_inputs.values({"cmake-args": ""}, tmp_path, {}).cmake_args == ""
    assert app_inputs.values({}, tmp_path, {"CMAKE_ARGS": ""}).cmake_args == "-DX=1"
    assert app_inputs.values({"image-name": ""}, tmp_path, {}).image_name == ""


@pytest.mark.parametrize("value", ["-DA=1 -DB='a;b'", '-DA="a b|c"', r"-DA=a\;b", "-DA=${HOME}", "-DA='x'\n-DB=y", ""])
def test_arguments_of_cmake_are_a_shells_words(value: str, tmp_path: Path) -> None:
    assert app_inputs.values({"cmake-args": value}, tmp_path, {}).cmake_args == value


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"cmake-args": "-DA='b"}, "cmake-args: .*: its quotation has no end"),
        ({"cmake-args": '-DA="b'}, "cmake-args: .*: its quotation has no end"),
        ({"cmake-args": "-DA=b\\"}, "cmake-args: .*: its quotation has no end"),
        ({"cmake-args": "-DA=a;b"}, "cmake-args: .*: ; needs quotes"),
        ({"cmake-args": "-DA=1 | id"}, r"cmake-args: .*: \| needs quotes"),
        ({"cmake-args": "-DA=1 & id"}, "cmake-args: .*: & needs quotes"),
        ({"cmake-args": "-DA=1) id ("}, r"cmake-args: .*: \) needs quotes"),
        ({"cmake-args": "-DA=1#2 # three"}, "cmake-args: .*: # needs quotes"),
        ({"ros-distro": "Jazzy"}, "ros-distro: 'Jazzy'"),
        ({"ros-distro": "jazzy; id"}, "ros-distro: 'jazzy; id'"),
        ({"rmw-implementation": "cyclonedds"}, "rmw-implementation: 'cyclonedds'"),
        ({"rmw-implementation": "rmw_a b"}, "rmw-implementation: 'rmw_a b'"),
        ({"colcon-args": "--executor sequential; id"}, "colcon-args: .*: ; needs quotes"),
        ({"parallel-jobs": "0"}, "parallel-jobs: .0.: that is none"),
        ({"parallel-jobs": "many"}, "parallel-jobs: .many."),
    ],
)
def test_a_value_that_a_step_could_not_use_is_refused(given: dict[str, str], says: str, tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        app_inputs.values(given, tmp_path, {})
    assert caught.value.exit_code == 2 and caught.value.remedy


def test_a_file_of_variables_may_begin_with_a_byte_order_mark(tmp_path: Path) -> None:
    (tmp_path / ".env").write_bytes("COMMAND=ros2\n".encode("utf-8-sig"))
    assert env_file.read(tmp_path / ".env") == {"COMMAND": "ros2"}


def test_image_and_tag_may_be_one_variable(tmp_path: Path) -> None:
    """As docker-ros' local script has them."""
    found = app_inputs.values({}, tmp_path, {"IMAGE": "127.0.0.1:5000/me/robot:v1"})
    assert (found.image_name, found.image_tag) == ("127.0.0.1:5000/me/robot", "v1")
    found = app_inputs.values({}, tmp_path, {"IMAGE": "127.0.0.1:5000/me/robot"})
    assert (found.image_name, found.image_tag) == ("127.0.0.1:5000/me/robot", "latest")
    found = app_inputs.values({"image-name": "mine"}, tmp_path, {"IMAGE": "robot:v1"})
    assert (found.image_name, found.image_tag) == ("mine", "latest")


def test_the_environment_wins_over_image_in_the_file(tmp_path: Path) -> None:
    (tmp_path / ".env").write_text("IMAGE=theirs:v1\n")
    found = app_inputs.values({}, tmp_path, {"IMAGE_NAME": "mine"})
    assert (found.image_name, found.image_tag) == ("mine", "v1")
    assert app_inputs.values({}, tmp_path, {"IMAGE": "mine:v2"}).image_tag == "v2"
    assert app_inputs.values({}, tmp_path, {}).image_name == "theirs"


PASSWORD, KEY = {"GIT_HTTPS_PASSWORD": "secret"}, {"GIT_SSH_PRIVATE_KEY": "key"}


@pytest.mark.parametrize(
    ("line", "given", "environment", "remedy"),
    [
        ("PUSH=true", {}, {}, "--push"),
        ("export PUSH='TRUE'", {}, {}, "--push"),
        ("CACHE=evil.example/cache", {}, {}, "--cache evil.example/cache"),
        ("ROSDEP_INDEX=~/secrets", {}, {}, "--rosdep-index '~/secrets'"),
        ("ROSDEP_INDEX=../..", {}, {}, r"--rosdep-index \.\./\.\."),
        ("IMAGE_NAME=ghcr.io/me/other", {"push": "true"}, {}, "--image-name ghcr.io/me/other"),
        ("IMAGE=ghcr.io/me/other:1", {}, {"PUSH": "true"}, "--image-name ghcr.io/me/other"),
        ("SLIM_IMAGE_TAG=stable", {"push": "true"}, {}, "--slim-image-tag stable"),
        ("IMAGE_NAME=osrf/ros", {}, {}, "--image-name osrf/ros"),
        ("IMAGE=ghcr.io/me/production:latest", {}, {}, "--image-name ghcr.io/me/production"),
        ("ENABLE_PUSH_AS_LATEST=true", {"push": "true"}, {}, "--enable-push-as-latest"),
        ("GIT_HTTPS_SERVER=evil.example", {}, PASSWORD, "--git-https-server evil.example"),
        ("GIT_HTTPS_SERVER=evil.example\nGIT_HTTPS_PASSWORD=x", {}, PASSWORD, "--git-https-server evil.example"),
        ("GIT_SSH_KNOWN_HOST_KEYS='evil.example ssh-rsa A'", {}, KEY, "--git-ssh-known-host-keys"),
    ],
)
def test_a_repository_does_not_decide_what_a_persons_rights_and_secrets_do(
    line: str, given: dict[str, str], environment: dict[str, str], remedy: str, tmp_path: Path
) -> None:
    (tmp_path / ".env").write_text(f"# settings\nBASE_IMAGE=ros:jazzy\n{line}\n")
    variable = line.removeprefix("export ").partition("=")[0]
    with pytest.raises(RosmlError, match=rf"\.env:3: {variable} is not for a repository to say") as caught:
        app_inputs.values(given, tmp_path, environment)
    assert caught.value.exit_code == 2 and re.search(remedy, caught.value.remedy)
    assert "secret" not in caught.value.message
    pushes = variable == "PUSH" or "true" in (given.get("push"), environment.get("PUSH"))
    assert ("as the images are pushed" in caught.value.message) is pushes


@pytest.mark.parametrize(
    ("text", "given", "environment"),
    [
        ("PUSH=false\nCACHE=\nENABLE_PUSH_AS_LATEST=true\nIMAGE=robot:1\nDEV_IMAGE_NAME=robot-dev", {}, {}),
        ("GIT_HTTPS_SERVER=git.example.org\nGIT_HTTPS_USER=me\nGIT_HTTPS_PASSWORD=own", {}, {}),
        ("GIT_HTTPS_SERVER=git.example.org", {}, {}),
        ("GIT_HTTPS_SERVER=github.com", {}, PASSWORD),
        ("GIT_HTTPS_SERVER=evil.example", {"git-https-server": "git.example.org"}, PASSWORD),
        ("GIT_SSH_PRIVATE_KEY=own\nGIT_SSH_KNOWN_HOST_KEYS=own", {}, {}),
        ("IMAGE_NAME=theirs\nPUSH=true\nCACHE=theirs", {"image-name": "mine", "push": "true"}, {"CACHE": "mine"}),
    ],
)
def test_what_a_repository_may_say_counts(
    text: str, given: dict[str, str], environment: dict[str, str], tmp_path: Path
) -> None:
    """And what a person says in its place is no error."""
    (tmp_path / ".env").write_text(f"{text}\n")
    found = app_inputs.values(given, tmp_path, environment)
    file = env_file.read(tmp_path / ".env")
    for item in app_inputs.TABLE:
        told = given.get(item.name) or environment.get(item.variable) or file.get(item.variable)
        assert not told or item.gone or found.text(item.name) == told


@pytest.mark.parametrize(
    ("line", "value"),
    [
        ("COMMAND=ros2", "ros2"),
        ("export COMMAND=ros2", "ros2"),
        ("  COMMAND=ros2  # starts it", "ros2"),
        ("COMMAND='ros2 run a b'", "ros2 run a b"),
        ('COMMAND="ros2 run a b"', "ros2 run a b"),
        ("COMMAND='echo $HOME # all'", "echo $HOME # all"),
        ('COMMAND="costs \\$5"', "costs $5"),
        ("COMMAND=", ""),
        ("# COMMAND=no\nCOMMAND='one\ntwo'", "one\ntwo"),
        ("COMMAND=one\\\ntwo", "onetwo"),
        ('COMMAND="one\\\ntwo"', "onetwo"),
        ("COMMAND='one\\\ntwo'", "one\\\ntwo"),
        ("COMMAND=one\\\\", "one\\"),
        ("COMMAND=a'b c'\"d e\"\\ f#g # h", "ab cd e f#g"),
        # These characters end no line and are no blanks.
        ("COMMAND='a\u2028b'", "a\u2028b"),
        ("COMMAND=a\u2028b", "a\u2028b"),
        ("COMMAND=a\x0cb\x1cc\x85d\xa0e", "a\x0cb\x1cc\x85d\xa0e"),
    ],
)
def test_a_file_of_variables_is_read_as_a_shell_reads_it(line: str, value: str, tmp_path: Path) -> None:
    (tmp_path / ".env").write_text(f"\n{line}\n")
    assert env_file.read(tmp_path / ".env") == {"COMMAND": value}
    shell = ["sh", "-c", '. ./.env; printf %s "$COMMAND"']
    assert subprocess.run(shell, cwd=tmp_path, capture_output=True, check=True).stdout.decode() == value


def test_a_file_of_variables_from_windows(tmp_path: Path) -> None:
    (tmp_path / ".env").write_bytes(b"A=1\r\nB='2\r\n3'\r\n")
    assert env_file.read(tmp_path / ".env") == {"A": "1", "B": "2\n3"}


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("A=1\nCOMMAND=ros2 run", ".env:2: a value with blanks needs quotes"),
        ('COMMAND="echo $HOME"', ".env:1: a shell would expand it"),
        ("COMMAND=`id`", ".env:1: a shell would expand it"),
        ("COMMAND='ros2", ".env:1: its quotation has no end"),
        ("command: ros2", ".env:1: it is not NAME=VALUE"),
        ("A=1\nCOMMAND=ros2\\", ".env:2: its quotation has no end"),
        ("A=\0", ".env: it has a NUL character"),
        ("A=" + "1" * (1 << 18), ".env: has more than 262,144 bytes"),
    ],
)
def test_what_a_shell_would_be_needed_for_is_refused(text: str, says: str, tmp_path: Path) -> None:
    (tmp_path / ".env").write_text(text)
    with pytest.raises(RosmlError, match=says.replace(".", r"\.")) as caught:
        env_file.read(tmp_path / ".env")
    assert caught.value.exit_code == 2


def test_a_flag_is_true_or_false(tmp_path: Path) -> None:
    assert app_inputs.values({}, tmp_path, {"TESTS": "False"}).tests is False
    with pytest.raises(RosmlError, match="tests is true or false, not 'no'"):
        app_inputs.values({}, tmp_path, {"TESTS": "no"})


def test_names_that_lost_their_meaning_are_answered(tmp_path: Path) -> None:
    (tmp_path / ".env").write_text("CUSTOM_SCRIPT_FILE=docker/custom.sh\nTARGTE=dev\n")
    said = list(app_inputs.answers(tmp_path, {"SLIM_BUILD_ARGS": "--http-probe=false"}))
    assert len(said) == 3 and "TARGTE in .env is not used: there is no such input" in said
    assert "CUSTOM_SCRIPT_FILE is not used: it is after-dependency-installation-script" in said


def test_variables_of_industrial_ci_count_where_it_is_on(tmp_path: Path) -> None:
    (tmp_path / ".env").write_text("ROSDEP_SKIP_KEYS='a b'\nNOT_TEST_BUILD=true\n")
    for on, expected in (("true", ("a b", False)), ("", ("", True))):
        found = app_inputs.values({}, tmp_path, {"ENABLE_INDUSTRIAL_CI": on})
        assert (found.skip_keys, found.tests) == expected
    own = {"ENABLE_INDUSTRIAL_CI": "true", "SKIP_KEYS": "c", "TESTS": "true"}
    assert app_inputs.values({}, tmp_path, own).skip_keys == "c" and app_inputs.values({}, tmp_path, own).tests
    [said] = app_inputs.answers(tmp_path, own)
    assert said.startswith("ENABLE_INDUSTRIAL_CI is not used: tests run here without it; its ROSDEP_SKIP_KEYS")


def test_every_name_of_docker_ros_is_known() -> None:
    """Of its action and of its local script, but for those that its workflow has for itself."""
    known = {item.variable for item in app_inputs.TABLE} | {"IMAGE"}
    theirs = (
        "ADDITIONAL_DEBS_FILE ADDITIONAL_FILES_DIR ADDITIONAL_PIP_FILE ADDITIONAL_SLIM_BUILD_ARGS"
        " AFTER_DEPENDENCY_INSTALLATION_SCRIPT BASE_IMAGE BEFORE_DEPENDENCY_IDENTIFICATION_SCRIPT"
        " BEFORE_DEPENDENCY_INSTALLATION_SCRIPT BLACKLISTED_PACKAGES_FILE CMAKE_ARGS COMMAND CUSTOM_SCRIPT_FILE"
        " DEV_IMAGE_NAME DEV_IMAGE_TAG DISABLE_ROS_INSTALLATION ENABLE_INDUSTRIAL_CI ENABLE_PUSH_AS_LATEST"
        " ENABLE_RECURSIVE_ADDITIONAL_DEBS ENABLE_RECURSIVE_ADDITIONAL_PIP"
        " ENABLE_RECURSIVE_AFTER_DEPENDENCY_INSTALLATION_SCRIPT ENABLE_RECURSIVE_BEFORE_DEPENDENCY_INSTALLATION_SCRIPT"
        " ENABLE_RECURSIVE_BLACKLISTED_PACKAGES ENABLE_RECURSIVE_VCS_IMPORT ENABLE_SLIM GIT_HTTPS_PASSWORD"
        " GIT_HTTPS_SERVER GIT_HTTPS_USER GIT_SSH_KNOWN_HOST_KEYS GIT_SSH_PRIVATE_KEY IMAGE IMAGE_NAME IMAGE_TAG"
        " PLATFORM RMW_IMPLEMENTATION ROS_DISTRO SLIM_BUILD_ARGS SLIM_IMAGE_NAME SLIM_IMAGE_TAG TARGET VCS_IMPORT_FILE"
    )
    assert set(theirs.split()) <= known


def test_lists_lose_comments_and_files_of_one_name_come_together(tmp_path: Path) -> None:
    for folder, text in (("a", "htop # tools\n"), ("b/c", "\n# none\nnano"), (".git/d", "no\n")):
        (tmp_path / folder).mkdir(parents=True)
        (tmp_path / folder / "debs.txt").write_text(text)
    every = workspace.text_of(tmp_path, "docker/debs.txt", (tmp_path,))
    assert workspace.lines_of("nano\u2028htop # a\u2028b\n") == ["nano\u2028htop"], (
        "a line ends where git and apt see its end"
    )
    assert workspace.lines_of(every) == ["htop", "nano"]
    assert workspace.lines_of(workspace.text_of(tmp_path, "a/debs.txt")) == ["htop"]
    assert workspace.text_of(tmp_path, "docker/debs.txt") == ""
