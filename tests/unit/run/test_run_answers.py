"""The answers of docker and podman: engines and images as they describe themselves, and answers that cannot be read."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from fakes.desks import DOCKER, OURS, PODMAN, ROOTLESS, UID, Desk, docker_desk
from rosml.run import attach, engine
from rosml.run.context import Image

UNREADABLE = "error: docker answers with something that rosml does not understand: "


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return docker_desk(tmp_path)


@pytest.mark.parametrize(
    ("info", "podman", "rootless"),
    [(DOCKER, False, False), (ROOTLESS, False, True), (PODMAN, True, True), ({"host": {}}, True, False)],
)
def test_the_kind_of_an_engine(desk: Desk, info: Any, podman: bool, rootless: bool) -> None:
    """podman may have the name of docker, as Debian's package podman-docker has it."""
    desk.engine(info=info)
    facts = engine.ask(str(desk.bin / "docker"), "ours", "").engine
    assert (facts.podman, facts.rootless) == (podman, rootless)


@pytest.mark.parametrize(("name", "podman", "rootless"), [("docker", False, False), ("podman", True, UID != 0)])
def test_an_engine_without_information(desk: Desk, name: str, podman: bool, rootless: bool) -> None:
    (desk.bin / name).write_text('#!/bin/sh\n[ $1 != image ] || echo \'{"Id": "x", "Config": {}}\'\n')
    (desk.bin / name).chmod(0o755)
    facts = engine.ask(str(desk.bin / name), "ours", "")
    assert (facts.engine.podman, facts.engine.rootless, facts.image) == (podman, rootless, Image("x"))


@pytest.mark.parametrize(
    ("version", "expected"),
    [("3.4.4", False), ("4.0.3", False), ("4.1.0-rc1", True), ("4.10", True), ("10.0", True), (None, True), (5, True)],
)
def test_podman_writes_no_entry_since_4_1(desk: Desk, version: object, expected: bool) -> None:
    desk.engine(info={**PODMAN, "version": {"Version": version}})
    assert ("--passwd=false" in json.loads(desk.call("--json", "--mwd", "ours").stdout)) == expected


@pytest.mark.parametrize(
    ("info", "selinux"),
    [
        (DOCKER, False),
        ({**DOCKER, "SecurityOptions": ["name=selinux"]}, True),
        ({"host": {"security": {"rootless": True, "selinuxEnabled": True}}}, True),
    ],
)
def test_an_engine_with_selinux(desk: Desk, info: dict[str, Any], selinux: bool) -> None:
    desk.engine(info=info)
    assert ("label=disable" in desk.call("--dry-run", "--mwd", "ubuntu").stdout) == selinux


def test_a_docker_that_is_a_snap(desk: Desk) -> None:
    desk.engine(info={**DOCKER, "DockerRootDir": "/var/snap/docker/common/var-lib-docker"})
    assert "docker is a snap" in desk.call("--dry-run", "ubuntu", DISPLAY=":0").stderr
    assert desk.call("--dry-run", "ubuntu").stderr == "", "without a display, nobody misses it"


@pytest.mark.parametrize(
    "info",
    [
        *({"host": {"security": None}}, {"host": 5}, {"host": {}, "version": 5}, 5, [1, 2], None),
        *({**DOCKER, "SecurityOptions": value} for value in ([5], "rootless", {"a": 1})),
        *({**DOCKER, "CDISpecDirs": 5}, {**DOCKER, "Runtimes": 5}),
    ],
)
def test_information_that_cannot_be_read(desk: Desk, info: Any) -> None:
    desk.engine(info=info)
    done = desk.call("ours")
    assert (done.returncode, done.stdout) == (125, "") and done.stderr.startswith(UNREADABLE), done.stderr
    assert done.stderr.endswith("\nremedy: try `docker info --format '{{json .}}'`\n") and not desk.called("run")


@pytest.mark.parametrize(
    "answer",
    [
        *("nonsense", "", "null", "[]", "[1]", "[{}, {}]", "5", '{"Id": "x"}', '{"Config": {}}', '{"Id": 5, "Config": {}}'),
        *(f'{{"Id": "x", "Config": {config}}}' for config in ("5", "null", '{"Env": 5}', '{"Env": [5]}', '{"Labels": [1]}')),
        *(f'{{"Id": "x", "Config": {config}}}' for config in ('{"Cmd": 5}', '{"Entrypoint": [5]}')),
        '{"Id": "x", "Config": {}} {}',
    ],
)  # fmt: skip
def test_an_image_that_cannot_be_read(desk: Desk, answer: str) -> None:
    """It may be one of ours, and would run as the wrong user."""
    desk.engine(answers={"image": answer})
    done = desk.call("ours")
    assert (done.returncode, done.stdout) == (125, "") and done.stderr.startswith(UNREADABLE), done.stderr
    assert "docker image inspect ours" in done.stderr and not desk.called("run") and not desk.called("pull")


@pytest.mark.parametrize(
    ("command", "answer", "words"),
    [
        *(("container", answer, ["x"]) for answer in ("[1, 2]", "5", "null", '"x" "y"', '5 5 5 5 5')),
        *(("container", f'"/x" "running" "sha256:y" {config} {mounts}', ["x"]) for config, mounts in [
            ("5", "null"), ('{"Env": [5]}', "null"), ('{"Labels": {"a": 5}}', "null"), ("{}", "5"), ("{}", "[5]"),
        ]),
        ("container", "[1, 2]", []),
        ("ps", "[1, 2]", []),
    ],
)  # fmt: skip
def test_containers_that_cannot_be_read(desk: Desk, command: str, answer: str, words: list[str]) -> None:
    desk.command = "attach"
    desk.engine(containers={"x": ["running", "/x"]}, answers={command: answer})
    done = desk.call(*words)
    assert done.returncode == 125 and done.stderr.startswith(UNREADABLE), done.stderr
    assert f"\nremedy: try `docker {command} " in done.stderr and done.stderr.count("\n") == 2


@pytest.mark.parametrize(
    ("healthcheck", "readable"),
    [
        (None, True),
        *(({"Test": test}, True) for test in ([], ["NONE"], ["CMD-SHELL"])),
        *(({"Test": test}, False) for test in ("CMD x", [1])),
        *(({"Test": ["CMD", "x"], **more}, False) for more in ({"Retries": "3"}, {"Interval": -1}, {"Timeout": 2**64})),
    ],
)
def test_an_image_without_a_healthcheck(desk: Desk, healthcheck: object, readable: bool) -> None:
    desk.engine(configs={"ours": {"Healthcheck": healthcheck}})
    done = desk.call("--export", "kubernetes", "ours", "ls")
    assert done.returncode == (0 if readable else 125) and "livenessProbe" not in done.stdout
    assert done.stderr.startswith(UNREADABLE) != readable


def test_a_warning_before_the_answer(desk: Desk) -> None:
    image = f"WARNING: x\n{json.dumps({'Id': 'sha256:x', 'Config': {'Env': OURS}})}"
    desk.engine(answers={"image": image, "info": f"WARNING: y\n{json.dumps(DOCKER, indent=1)}"})
    assert desk.call("ours").returncode == 0 and f"DOCKER_UID={UID}" in desk.ran


def test_podmans_containers(desk: Desk) -> None:
    """No slash, no kind of digest, and the entrypoint as text."""
    config = {"Env": OURS, "Entrypoint": "/tini -- /entrypoint.sh", "Labels": None}
    desk.engine("podman", containers={"x": ["running", "x", "0f", config, None]})
    container = engine.container(str(desk.bin / "podman"), "x")
    assert container and (container.name, container.image_id) == ("x", "0f") and attach.is_ours(container)
    assert container.entrypoint == ("/tini", "--", "/entrypoint.sh")
