"""Inputs of an app: options before the environment before `.env`, and names of docker-ros that mean nothing."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from rosml.base.errors import RosmlError
from rosml.containerize import env_file, inputs
from rosml.containerize.packages import workspace


def test_the_command_line_wins_over_the_environment_and_that_over_the_file(tmp_path: Path) -> None:
    (tmp_path / ".env").write_text("BASE_IMAGE=file\nCOMMAND=file\nIMAGE_TAG=file\n")
    values = inputs.values({"base-image": "line"}, tmp_path, {"BASE_IMAGE": "variable", "COMMAND": "variable"})
    assert (values.base_image, values.command, values.image_tag) == ("line", "variable", "file")
    assert values.cmake_args == "-DCMAKE_BUILD_TYPE=Release"


def test_an_empty_value_counts_on_the_command_line_alone(tmp_path: Path) -> None:
    (tmp_path / ".env").write_text("CMAKE_ARGS=-DX=1\nIMAGE_TAG=\nIMAGE=robot:v1\n")
    assert inputs.values({"cmake-args": ""}, tmp_path, {}).cmake_args == ""
    assert inputs.values({}, tmp_path, {"CMAKE_ARGS": ""}).cmake_args == "-DX=1"
    assert inputs.values({"image-name": ""}, tmp_path, {}).image_name == ""


@pytest.mark.parametrize("value", ["-DA=1 -DB='a;b'", '-DA="a b|c"', r"-DA=a\;b", "-DA=${HOME}", "-DA='x'\n-DB=y", ""])
def test_arguments_of_cmake_are_a_shells_words(value: str, tmp_path: Path) -> None:
    assert inputs.values({"cmake-args": value}, tmp_path, {}).cmake_args == value


@pytest.mark.parametrize(
    ("name", "value", "problem"),
    [
        ("cmake-args", "-DA='b", "its quotation has no end"),
        ("cmake-args", "-DA=a;b", "; needs quotes"),
        ("cmake-args", "-DA=1#2 # three", "# needs quotes"),
        ("colcon-args", "--executor sequential; id", "; needs quotes"),
        ("rmw-implementation", "rmw_a b", "that is none"),
        ("parallel-jobs", "0", "that is none"),
        ("tests", "no", "tests is true or false"),
    ],
)
def test_a_value_that_a_step_could_not_use_is_refused(name: str, value: str, problem: str, tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=re.escape(problem)) as caught:
        inputs.values({name: value}, tmp_path, {})
    assert caught.value.exit_code == 2 and caught.value.remedy


@pytest.mark.parametrize(
    ("file", "typed", "environment", "image"),
    [
        ("", {}, {"IMAGE": "127.0.0.1:5000/me/robot:v1"}, "127.0.0.1:5000/me/robot:v1"),
        ("", {}, {"IMAGE": "127.0.0.1:5000/me/robot"}, "127.0.0.1:5000/me/robot:latest"),
        ("", {"image-name": "mine"}, {"IMAGE": "robot:v1"}, "mine:latest"),
        ("IMAGE=theirs:v1", {}, {"IMAGE_NAME": "mine"}, "mine:v1"),
        ("IMAGE=theirs:v1", {}, {"IMAGE": "mine:v2"}, "mine:v2"),
        ("IMAGE=theirs:v1", {}, {}, "theirs:v1"),
    ],
)
def test_image_and_tag_may_be_one_variable(
    file: str, typed: dict[str, str], environment: dict[str, str], image: str, tmp_path: Path
) -> None:
    """As docker-ros' local script has them."""
    (tmp_path / ".env").write_text(file)
    values = inputs.values(typed, tmp_path, environment)
    assert f"{values.image_name}:{values.image_tag}" == image


PASSWORD, KEY, PUSH = {"GIT_HTTPS_PASSWORD": "secret"}, {"GIT_SSH_PRIVATE_KEY": "key"}, {"PUSH": "true"}


@pytest.mark.parametrize(
    ("line", "environment", "remedy"),
    [
        ("PUSH=true", {}, "--push"),
        ("CACHE=evil.example/cache", {}, "--cache evil.example/cache"),
        ("ROSDEP_INDEX=~/secrets", {}, "--rosdep-index '~/secrets'"),
        ("ALLOW_SCRIPT_SECRETS=true", PASSWORD, "--allow-script-secrets"),
        ("IMAGE_NAME=ghcr.io/me/other", PUSH, "--image-name ghcr.io/me/other"),
        ("IMAGE=ghcr.io/me/other:1", PUSH, "--image-name ghcr.io/me/other"),
        ("ENABLE_PUSH_AS_LATEST=true", PUSH, "--enable-push-as-latest"),
        ("IMAGE_NAME=osrf/ros", {}, "--image-name osrf/ros"),
        ("GIT_HTTPS_SERVER=evil.example", PASSWORD, "--git-https-server evil.example"),
        ("GIT_HTTPS_SERVER=evil.example\nGIT_HTTPS_PASSWORD=x", PASSWORD, "--git-https-server evil.example"),
        ("GIT_SSH_KNOWN_HOST_KEYS='evil.example ssh-rsa A'", KEY, "--git-ssh-known-host-keys"),
    ],
)
def test_a_repository_does_not_decide_what_a_persons_rights_and_secrets_do(
    line: str, environment: dict[str, str], remedy: str, tmp_path: Path
) -> None:
    (tmp_path / ".env").write_text(f"# settings\nBASE_IMAGE=ros:jazzy\n{line}\n")
    variable = line.removeprefix("export ").partition("=")[0]
    with pytest.raises(RosmlError, match=rf"\.env:3: {variable} is not for a repository to say") as caught:
        inputs.values({}, tmp_path, environment)
    assert caught.value.exit_code == 2 and remedy in caught.value.remedy
    assert "secret" not in caught.value.message
    assert ("as the images are pushed" in caught.value.message) is (variable == "PUSH" or environment == PUSH)


@pytest.mark.parametrize(
    ("text", "typed", "environment"),
    [
        ("PUSH=false\nCACHE=\nENABLE_PUSH_AS_LATEST=true\nIMAGE=robot:1\nDEV_IMAGE_NAME=robot-dev", {}, {}),
        ("GIT_HTTPS_SERVER=git.example.org\nGIT_HTTPS_USER=me\nGIT_HTTPS_PASSWORD=own", {}, {}),
        ("GIT_HTTPS_SERVER=github.com", {}, PASSWORD),
        ("GIT_HTTPS_SERVER=evil.example", {"git-https-server": "git.example.org"}, PASSWORD),
        ("GIT_SSH_PRIVATE_KEY=own\nGIT_SSH_KNOWN_HOST_KEYS=own", {}, {}),
        ("IMAGE_NAME=theirs\nPUSH=true\nCACHE=theirs", {"image-name": "mine", "push": "true"}, {"CACHE": "mine"}),
    ],
)
def test_allowed_lines_of_a_repository_count(
    text: str, typed: dict[str, str], environment: dict[str, str], tmp_path: Path
) -> None:
    """And a person's value in their place is no error."""
    (tmp_path / ".env").write_text(f"{text}\n")
    values, variables = inputs.values(typed, tmp_path, environment), inputs.of_file(tmp_path)
    for item in inputs.TABLE:
        value = typed.get(item.name) or environment.get(item.variable) or variables.get(item.variable)
        assert not value or item.gone or values.text(item.name) == value


@pytest.mark.parametrize(
    ("line", "value"),
    [
        ("export COMMAND=ros2", "ros2"),
        ("  COMMAND=ros2  # starts it", "ros2"),
        ("COMMAND='echo $HOME # all'", "echo $HOME # all"),
        ('COMMAND="costs \\$5"', "costs $5"),
        ("COMMAND=", ""),
        ("# COMMAND=no\nCOMMAND='one\ntwo'", "one\ntwo"),
        ('COMMAND="one\\\ntwo"', "onetwo"),
        ("COMMAND='one\\\ntwo'", "one\\\ntwo"),
        ("COMMAND=a'b c'\"d e\"\\ f#g # h", "ab cd e f#g"),
        # These characters end no line and are no blanks.
        ("COMMAND='a\u2028b'", "a\u2028b"),
        ("COMMAND=a\u2028b\x0cb\x1cc\x85d\xa0e", "a\u2028b\x0cb\x1cc\x85d\xa0e"),
    ],
)
def test_a_file_of_variables_is_read_as_a_shell_reads_it(line: str, value: str, tmp_path: Path) -> None:
    (tmp_path / ".env").write_text(f"\n{line}\n")
    assert env_file.read(tmp_path / ".env", {"COMMAND"}) == {"COMMAND": value}
    shell = ["sh", "-c", '. ./.env; printf %s "$COMMAND"']
    assert subprocess.run(shell, cwd=tmp_path, capture_output=True, check=True).stdout.decode() == value


def test_a_file_of_variables_from_windows(tmp_path: Path) -> None:
    (tmp_path / ".env").write_bytes(b"A=1\r\nB='2\r\n3'\r\n".decode().encode("utf-8-sig"))
    assert env_file.read(tmp_path / ".env", {"COMMAND"}) == {"A": "1", "B": "2\n3"}


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("A=1\nCOMMAND=ros2 run", ".env:2: a value with blanks needs quotes"),
        ('COMMAND="echo $HOME"', ".env:1: a shell would expand it"),
        ("COMMAND='ros2", ".env:1: its quotation has no end"),
        ("command: ros2", ".env:1: it is not NAME=VALUE"),
        ("A=\0", ".env: it has a NUL character"),
        ("A=" + "1" * (1 << 18), ".env: has more than 262,144 bytes"),
    ],
)
def test_a_line_that_needs_a_shell_is_refused(text: str, problem: str, tmp_path: Path) -> None:
    (tmp_path / ".env").write_text(text)
    with pytest.raises(RosmlError, match=re.escape(problem)) as caught:
        env_file.read(tmp_path / ".env", {"COMMAND"})
    assert caught.value.exit_code == 2


def test_lines_that_are_for_docker_compose_are_passed_over(tmp_path: Path) -> None:
    """They may need a shell: what docker-ros builds in CI does not depend on them."""
    others = ("COMPOSE_FILE=${DIR:-.}/a.yml", "TITLE=two words", "OPEN='no end", "DURATION=20 # s")
    (tmp_path / ".env").write_text("\n".join(["COMMAND=ros2", *others, "IMAGE=robot:1"]))
    values = inputs.values({}, tmp_path, {})
    assert (values.command, values.image_name, values.image_tag) == ("ros2", "robot", "1")
    assert [line.split()[0] for line in inputs.answers(tmp_path, {})] == ["COMPOSE_FILE", "TITLE", "OPEN", "DURATION"]


def test_names_that_lost_their_meaning_are_answered(tmp_path: Path) -> None:
    (tmp_path / ".env").write_text("CUSTOM_SCRIPT_FILE=docker/custom.sh\nTARGTE=dev\n")
    sentences = list(inputs.answers(tmp_path, {"SLIM_BUILD_ARGS": "--http-probe=false"}))
    assert len(sentences) == 3 and "TARGTE in .env is not used: there is no such input" in sentences
    assert "CUSTOM_SCRIPT_FILE is not used: it is after-dependency-installation-script" in sentences


def test_variables_of_industrial_ci_count_where_it_is_on(tmp_path: Path) -> None:
    (tmp_path / ".env").write_text("ROSDEP_SKIP_KEYS='a b'\nNOT_TEST_BUILD=true\n")
    both = {"ENABLE_INDUSTRIAL_CI": "true", "SKIP_KEYS": "c", "TESTS": "True"}
    for environment, expected in (
        ({"ENABLE_INDUSTRIAL_CI": "true"}, ("a b", False)),
        ({}, ("", True)),
        (both, ("c", True)),
    ):
        values = inputs.values({}, tmp_path, environment)
        assert (values.skip_keys, values.tests) == expected
    [sentence] = inputs.answers(tmp_path, both)
    assert sentence.startswith("ENABLE_INDUSTRIAL_CI is not used: tests run here without it; its ROSDEP_SKIP_KEYS")


def test_lists_lose_comments_and_files_of_one_name_come_together(tmp_path: Path) -> None:
    for folder, text in (("a", "htop # tools\n"), ("b/c", "\n# none\nnano"), (".git/d", "no\n")):
        (tmp_path / folder).mkdir(parents=True)
        (tmp_path / folder / "debs.txt").write_text(text)
    every = workspace.texts_of(tmp_path, "docker/debs.txt", (tmp_path,))
    assert workspace.lines_of("".join(every)) == ["htop", "nano"]
    assert workspace.lines_of("nano\u2028htop # a\u2028b\n") == ["nano\u2028htop"], "as for git and apt"
    assert workspace.texts_of(tmp_path, "a/debs.txt") == ["htop # tools\n"]
    assert workspace.texts_of(tmp_path, "docker/debs.txt") == []
