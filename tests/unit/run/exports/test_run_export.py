"""`rosml run --export`: files for docker compose and for editors have the options of `--dry-run`."""

from __future__ import annotations

import json
import os
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import example, given, settings
from hypothesis import strategies as st

from fakes import units
from fakes.desks import Desk, docker_desk
from fakes.exports import PODMAN, ROOTLESS, call, text
from rosml.base.errors import RosmlError
from rosml.cli.run.export import KINDS
from rosml.run import words
from rosml.run.context import Host
from rosml.run.exports import compose, description, devcontainer, kubernetes, quadlet

QUIET = ("--no-tz", "--no-it", "--no-user")


def composed(*line: str, **facts: Any) -> dict[str, Any]:
    return dict(yaml.safe_load(compose.text(call(*line, **facts))))


def service(*line: str, **facts: Any) -> dict[str, Any]:
    (only,) = composed(*line, **facts)["services"].values()
    return dict(only)


def container(*line: str, **facts: Any) -> dict[str, Any]:
    """The file for editors."""
    return dict(json.loads(devcontainer.text(call(*line, kind="devcontainer", **facts))))


def test_a_whole_file_for_compose() -> None:
    """The folder is that of the file, so that it can be moved; files that are written belong to whoever exported it."""
    environment = {"DOCKER_UID": "1234", "DOCKER_GID": "5678", "DOCKER_USER": "jo", "TZ": "Europe/Berlin"}
    bind = {"type": "bind", "source": ".", "target": "/docker-ros/ws/src/target", "bind": {"create_host_path": False}}
    assert composed("--mws", "--rm", "-d", "-v", "data:/data", "me/ros:jazzy", "colcon", "build") == {
        "services": {
            "robot": {
                "image": "me/ros:jazzy",
                "stdin_open": True,
                "tty": True,
                "labels": {"io.rosml.run.folder": "/home/jo/robot"},
                "environment": environment,
                "volumes": [bind, "data:/data"],
                "command": ["colcon", "build"],
            }
        },
        "volumes": {"data": {"name": "data"}},
    }


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        (["-e", "A=1", "-e", "A=2", "-e", "B"], {"environment": {"A": "2", "B": None}}),
        (["-v", "./bags:/bags:ro", "-v", "/x:/y"], {"volumes": ["./bags:/bags:ro", "/x:/y"]}),
        (["--mount", "src=vol,dst=/v,ro"], {"volumes": [{"type": "volume", "source": "vol", "target": "/v", "read_only": True}]}),
        (["--mount", "type=tmpfs,target=/t,tmpfs-mode=1777"], {"volumes": [{"type": "tmpfs", "target": "/t", "tmpfs": {"mode": 0o1777}}]}),
        (["--network", "host", "--net=none"], {"network_mode": "none"}),
        (["-w", "/a", "--workdir=/b", "-u0"], {"working_dir": "/b", "user": "0"}),
        (["--device", "nvidia.com/gpu=all", "--device=/dev/video0"], {"devices": ["nvidia.com/gpu=all", "/dev/video0"]}),
        (["--shm-size=8g", "--ipc", "host", "--memory=1g"], {"shm_size": "8g", "ipc": "host", "mem_limit": "1g"}),
        (["--ulimit", "rtprio=99", "--ulimit=memlock=-1:-1"], {"ulimits": {"rtprio": 99, "memlock": {"soft": -1, "hard": -1}}}),
        (["--privileged", "--init=false", "-it"], {"privileged": True, "init": False, "stdin_open": True, "tty": True}),
        (["--log-driver=local", "--log-opt", "max-size=1m"], {"logging": {"driver": "local", "options": {"max-size": "1m"}}}),
        (["--health-cmd", "curl x", "--health-start-period=5s"], {"healthcheck": {"test": "curl x", "start_period": "5s"}}),
        (["--env-file", "/home/jo/robot/a", "--stop-timeout=5"], {"env_file": [{"path": "./a", "format": "raw"}], "stop_grace_period": "5s"}),
        (["--label-file", "a", "--label-file=../b"], {"label_file": ["./a", "/home/jo/b"]}),
        (["--entrypoint", "a b", "--volumes-from=other"], {"entrypoint": ["a b"], "volumes_from": ["container:other"]}),
    ],
)  # fmt: skip
def test_an_option_as_compose_has_it(typed: list[str], expected: dict[str, Any]) -> None:
    assert service(*QUIET, *typed, "x").items() >= expected.items()


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        ("2", {"count": 2, "capabilities": ["gpu"]}),
        ('"device=0,1"', {"device_ids": ["0", "1"], "capabilities": ["gpu"]}),
        ('all,"capabilities=utility,compute"', {"count": "all", "capabilities": ["gpu", "utility", "compute"]}),
    ],
)
def test_gpus_of_compose(typed: str, expected: dict[str, Any]) -> None:
    (device,) = service("--gpus", typed, "x")["deploy"]["resources"]["reservations"]["devices"]
    assert device == {"driver": "nvidia", **expected}


@pytest.mark.parametrize(
    ("typed", "remove"),
    [
        (["--gpus", "all"], "remove deploy and what is below it, "),
        (["--device", "nvidia.com/gpu=all"], "remove - nvidia.com/gpu=all from devices, "),
        (["--runtime", "nvidia"], "remove runtime, "),
        (["--device", "/dev/dri"], ""),
    ],
)
def test_a_file_of_compose_says_what_to_do_without_a_gpu(typed: list[str], remove: str) -> None:
    comment, rest = "".join(compose.text(call(*typed, "x"))).split("services:", 1)
    assert rest and bool(comment) == bool(remove)
    assert comment.startswith("# For a machine with an NVIDIA GPU") == bool(remove) and remove in comment


def test_podmans_entry_has_no_word_in_compose() -> None:
    ids = {"user": "1234:5678", "userns_mode": "keep-id"}
    assert ids.items() <= service("--mwd", "x", engine=PODMAN, ours=False).items()
    assert service("--mwd", "x", engine=PODMAN)["user"] == "0:0"
    assert "--passwd-entry=jo:*:1234:5678::/tmp:/bin/sh" in container("x", engine=PODMAN)["runArgs"]


def test_networks_and_volumes_are_those_of_the_engine() -> None:
    """Compose would put the project's name before theirs."""
    document = composed("--network=robots", "-v", "data:/d", "--mount", "src=more,dst=/m", "-v", ".:/x", "x")
    assert document["networks"] == {"robots": {"name": "robots", "external": True}}
    assert document["volumes"] == {"data": {"name": "data"}, "more": {"name": "more"}}


VALUES = {
    **dict.fromkeys(("user", "group-add", "stop-timeout", "cpus", "memory", "memory-reservation", "shm-size"), "78"),
    **dict.fromkeys(("hostname", "runtime", "health-retries"), "78"),
    **dict.fromkeys(("health-interval", "health-timeout", "health-start-period"), "78s"),
    **{"name": "n78", "gpus": "8", "mount": "type=bind,source=/78,target=/x", "publish": "78:78", "env": "A=78"},
    **{"platform": "linux/78", "volume": "/78:/78", "tmpfs": "/78", "add-host": "a:78", "restart": "always"},
    **{"cgroupns": "private", "pull": "missing"},
}
DROPPED = {
    "compose": (),
    "devcontainer": (*devcontainer.DROPPED, "entrypoint"),
    "quadlet": (*quadlet.DROPPED, "restart"),
    "kubernetes": (*kubernetes.DROPPED, "init", "no-healthcheck", "restart"),
}


@pytest.mark.parametrize("kind", KINDS)
def test_no_option_gets_lost(kind: str) -> None:
    """It is in the file, or an error names it. Some have no meaning there."""
    for name in sorted(words.table().names):
        value = VALUES.get(name, "78=9") if name in words.table().values else ""
        health = ["--health-cmd=x"] if name.startswith("health-") and name != "health-cmd" else []
        without = text(*QUIET, *health, "x", kind=kind)
        try:
            document = text(*QUIET, *health, f"--{name}={value}" if value else f"--{name}", "x", kind=kind)
        except RosmlError as error:
            assert description.SYNONYMS.get(name, name) in error.message or f"-{name[0]} " in error.message, name
            assert error.remedy and name not in description.OF_A_CALL
            continue
        if name in description.OF_A_CALL:
            assert document == without, name
        elif name not in DROPPED[kind]:
            assert document != without and ("78" in document or "78" not in value), name


@pytest.mark.parametrize(
    ("typed", "says"),
    [
        *((["--name", name], f"--name '{name}' is no name") for name in ("a b", "", "x")),
        (["-e", "=1"], "--env '=1' has no name"),
        (["-l", ""], "--label '' has no name"),
        (["--brand-new=5"], "--brand-new has no counterpart"),
        (["--pull=newer"], "--pull=newer has no counterpart"),
        (["--network", "name=x,alias=y"], "--network name=x"),
        (["--mount", "type=bind,source=/a,target=/b,bind-nonrecursive"], "bind-nonrecursive of --mount"),
        (["--mount", '"type=bind'], "quotes do not close"),
        (["--ssh-agent"], "--ssh-agent does not go with --export"),
        (["-e", os.fsdecode(b"\xff")], "is no text"),
    ],
)
def test_options_that_compose_refuses(typed: list[str], says: str) -> None:
    with pytest.raises(RosmlError) as caught:
        compose.text(call(*typed, "x"))
    assert says in caught.value.message and caught.value.remedy and caught.value.exit_code == 2


def test_a_whole_file_for_editors() -> None:
    """The editor's command is in the place of the entrypoint: the bare ids run, and the group 0 writes to the workspace."""
    line = [
        "--mws",
        "-it",
        "--rm",
        "-v",
        "./bags:/bags",
        "-e",
        "ROBOT",
        "--privileged",
        "--gpus",
        "all",
        "me/ros:jazzy",
    ]
    ids = {"HOME": "/tmp", "USER": "jo", "LOGNAME": "jo", "TZ": "Europe/Berlin"}
    label = "--label=io.rosml.run.folder=${localWorkspaceFolder}"
    assert container(*line) == {
        "name": "robot",
        "image": "me/ros:jazzy",
        "workspaceMount": "type=bind,source=${localWorkspaceFolder},target=/docker-ros/ws/src/target",
        "workspaceFolder": "/docker-ros/ws/src/target",
        "containerUser": "1234:5678",
        "updateRemoteUserUID": False,
        "containerEnv": {**ids, "ROBOT": "${localEnv:ROBOT}"},
        "privileged": True,
        "securityOpt": ["no-new-privileges"],
        "runArgs": [label, "--group-add=0", "--volume=${localWorkspaceFolder}/bags:/bags", "--gpus=all"],
    }


@pytest.mark.parametrize(
    ("typed", "folder", "others"),
    [
        ([], None, []),
        (["--mwd"], "/home/jo/robot", []),
        (["-v", ".:/ws"], "/ws", []),
        (["--mount", "type=bind,src=.,dst=/ws"], "/ws", []),
        (["-v", ".:/ws:ro"], None, []),
        (["--mwd", "--mws"], "/home/jo/robot", ["type=bind,source=${localWorkspaceFolder},target=/docker-ros/ws/src/target"]),
        (["--mount", "type=bind,src=./a,dst=/a"], None, ["type=bind,source=${localWorkspaceFolder}/a,target=/a"]),
    ],
)  # fmt: skip
def test_the_folder_that_is_opened(typed: list[str], folder: str | None, others: list[str]) -> None:
    written = container(*typed, "x")
    assert written.get("workspaceFolder") == folder and ("workspaceMount" in written) == (folder is not None)
    assert written.get("mounts", []) == others


@pytest.mark.parametrize(
    ("facts", "typed", "user", "group"),
    [
        ({}, [], "1234:5678", True),
        ({"ours": False}, [], "1234:5678", False),
        ({"trusted": False}, [], "1234:5678", False),
        ({}, ["--user", "robot"], "robot", False),
        ({}, ["--no-user"], None, False),
        ({"engine": ROOTLESS}, [], "root", False),
        ({"engine": PODMAN}, [], "1234:5678", True),
    ],
)
def test_who_runs_in_an_editor(facts: dict[str, Any], typed: list[str], user: str | None, group: bool) -> None:
    written = container(*typed, "x", **facts)
    assert written.get("containerUser") == user and ("--group-add=0" in written["runArgs"]) == group
    assert ("--userns=keep-id" in written["runArgs"]) == (facts.get("engine") is PODMAN)
    locked = ["no-new-privileges"] if user == "1234:5678" and "engine" not in facts else None
    assert written.get("securityOpt") == locked and "DOCKER_UID" not in written.get("containerEnv", {})


def test_paths_of_this_machine_work_from_anywhere() -> None:
    files = container("--env-file", "../a", "--env-file=./b", "--label-file=/c", "x")["runArgs"]
    assert files[-3:] == ["--env-file=/home/jo/a", "--env-file=${localWorkspaceFolder}/b", "--label-file=/c"]
    mounts = container("-v", ".:/ws:ro", "-v", "/home/jo/robot/x", "-w", "/home/jo/robot", "x")["runArgs"]
    volumes = ["--volume=${localWorkspaceFolder}:/ws:ro", "--volume=/home/jo/robot/x"]
    assert mounts[-3:] == [*volumes, "--workdir=/home/jo/robot"], "paths in the container stay"


def test_windows_are_those_of_whoever_starts_it(tmp_path: Path) -> None:
    """Neither the cookie, nor today's display."""
    (tmp_path / "tmp/.X11-unix").mkdir(parents=True)
    (tmp_path / "tmp/.X11-unix/X1").touch()
    host = Host(tmp_path, {"DISPLAY": ":1"}, connects=lambda address: True)
    written = service("x", host=host)
    assert written["environment"].items() >= {"DISPLAY": None, "QT_X11_NO_MITSHM": "1"}.items()
    assert written["volumes"] == ["/tmp/.X11-unix:/tmp/.X11-unix"]
    assert container("x", host=host)["containerEnv"]["DISPLAY"] == "${localEnv:DISPLAY}"
    for typed, display in ((["--no-x11"], ":1"), ([], "localhost:10.0"), ([], ":2"), (["-e", "DISPLAY=:7"], ":1")):
        written = service(*typed, "x", host=replace(host, environment={"DISPLAY": display}))
        assert "volumes" not in written and written["environment"].get("DISPLAY") in (None, ":7")
        assert "network_mode" not in written


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return docker_desk(tmp_path)


@pytest.mark.parametrize("kind", ["quadlet", "kubernetes"])
def test_a_service_that_would_end_at_once(desk: Desk, kind: str) -> None:
    """The image starts a shell. And podman makes no folder that is mounted."""
    health = {"Test": ["CMD", "check"], "Interval": 5_000_000_000}
    desk.engine(configs={"ours": {"Cmd": ["bash"], "Healthcheck": health}})
    done = desk.call("--export", kind, "-v", "./missing:/bags", "ours")
    assert done.returncode == 0 and "starts 'bash', which ends at once without a terminal" in done.stderr, done.stderr
    assert ("missing is missing here" in done.stderr) == (kind == "quadlet")
    assert ("\n          periodSeconds: 5\n" in done.stdout) == (kind == "kubernetes")
    done = desk.call("--export", kind, "ours", "sleep", "1")
    assert (done.returncode, done.stderr) == (0, "") and done.stdout.startswith("# dr ")


def test_a_service_is_added(desk: Desk) -> None:
    file = desk.folder / "compose.yaml"
    file.write_text("# mine\nservices:\n  a:\n    image: x\n")
    options = ["--export=compose", "--add=compose.yaml", "--name=arm", "ours"]
    done = desk.call(*options, "ls")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "compose.yaml: added the service arm\n")
    content = file.read_text()
    assert content.startswith("# mine\nservices:\n  a:\n    image: x\n  arm:\n") and not desk.called("run")
    assert "has the service arm already" in desk.call(*options, "ls").stderr
    again = desk.call(*options, "pwd")
    assert again.returncode == 125 and "a service arm already, with other content" in again.stderr
    assert file.read_text() == content


@pytest.mark.parametrize(
    ("line", "says"),
    [
        (["--export", "compose"], "--export needs an image"),
        (["--export"], "the option --export lacks its value"),
        (["--export", "helm", "ours"], "'helm' is not one of 'devcontainer', 'compose', 'quadlet', 'kubernetes'"),
        (["--add", "compose.yaml", "ours"], "--add goes with --export compose"),
        (["--export", "compose", "--add", "compose.yaml", "ours"], "there is no such file"),
        (["--export", "compose", "--add", "", "ours"], "it is no file"),
        (["--export", "compose", "--check", "ours"], "--export does not go with --check"),
        (["--export", "compose", "no/such:image"], "no image no/such:image here"),
    ],
)
def test_a_wrong_export(desk: Desk, line: list[str], says: str) -> None:
    done = desk.call(*line)
    assert done.returncode == 125 and done.stdout == "" and says in done.stderr, done.stderr
    assert not desk.called("run") and not desk.called("pull")


def of_compose(document: str) -> list[str]:
    (only,) = yaml.safe_load(document)["services"].values()
    assert "$" not in str(only).replace("$$", "")
    texts = (*only["command"], only["environment"]["A"], only["labels"]["l"])
    return [word.replace("$$", "$") for word in texts]


def of_editors(document: str) -> list[str]:
    written = json.loads(document)
    assert "Env:" not in written["containerEnv"]["A"]
    (label,) = [word[len("--label=l=") :] for word in written["runArgs"] if word.startswith("--label=l=")]
    return [written["containerEnv"]["A"], label]


def of_systemd(document: str) -> list[str]:
    argv = units.argv(document)
    values = (next(word for word in argv if word.startswith(name))[len(name) :] for name in ("--env=A=", "--label=l="))
    return [*argv[argv.index("docker.io/library/img") + 1 :], *values]


def of_kubernetes(document: str) -> list[str]:
    (only,) = yaml.safe_load(document)["spec"]["template"]["spec"]["containers"]
    (value,) = [item["value"] for item in only["env"] if item["name"] == "A"]
    assert not any("$(" in text.replace("$$", "") for text in (*only["args"], value))
    return [word.replace("$$", "$") for word in (*only["args"], value)]


READERS = {"compose": of_compose, "devcontainer": of_editors, "quadlet": of_systemd, "kubernetes": of_kubernetes}


def check_texts(kind: str, command: list[str], value: str) -> None:
    """Read as the file's system reads it, or refused. A cluster has no labels of containers, and an editor starts no command."""
    label = [] if kind == "kubernetes" else ["--label", f"l={value}"]
    command = [] if kind == "devcontainer" else ["ros2", *command]
    try:
        document = text("-e", f"A={value}", *label, "img", *command, kind=kind)
    except RosmlError as error:
        texts = "".join([value, *command])
        assert error.remedy and ("${" in value if kind == "devcontainer" else kind == "quadlet")
        assert kind != "quadlet" or {"", ";"} & {*command} or any(map(quadlet.is_lost, texts)), error
        return
    assert READERS[kind](document) == [*command, *[value] * (1 + len(label) // 2)]


TEXT = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"))
HARD = st.text(
    st.sampled_from("$%\\\"'; \n\t\r{}()hn0xa:,=#[]é\x7f\x01\x80\x85\xa0\u2028\ufeff\ufffe~`@!+-"), max_size=8
)


@pytest.mark.parametrize("kind", KINDS)
@settings(max_examples=200, deadline=None)
@given(st.lists(HARD | TEXT, max_size=5), HARD | TEXT)
@example(["y", "on", "0x1", "1e3", "1:30", "$(HOME)", "~", "null", "- a", "#", "$$"], "a: ${b}\n$$(X)")
@example(["%h%%", "a;", "-x", "\\", "'", '"', "${X}", "$$(X)", "`id`"], "a\n[Service]\nExecStart=/bin/sh %n \\")
@example(["a"], "${localEnv:TOKEN}")
def test_any_text_is_the_same_in_the_file(kind: str, command: list[str], value: str) -> None:
    check_texts(kind, command, value)


@pytest.mark.parametrize("variable", ["${localEnv:TOKEN}", "a${ localEnv:A}", "${env:A}", "${containerEnv:PATH}"])
def test_a_variable_of_editors_in_a_strangers_text_is_refused(variable: str) -> None:
    """Editors put in something of the desk, and have no escape."""
    environment = {"DOCKER_UID": "", "WORKSPACE": f"/x/{variable}"}
    with pytest.raises(RosmlError, match="an editor puts in something of your machine"):
        text("--mws", "img", kind="devcontainer", environment=environment)


@pytest.mark.parametrize(
    ("environments", "python"),
    [
        ("lerobot", "/opt/env/lerobot/bin/python"),
        ("", ""),
        ("lerobot vision", ""),
        ("../../tmp", ""),
        ("${localEnv:X}", ""),
    ],
)
def test_an_editor_takes_the_python_of_the_environment(environments: str, python: str) -> None:
    settings = {"vscode": {"settings": {"python.defaultInterpreterPath": python}}}
    document = container("ours", labels={"io.rosml.environments": environments})
    assert document.get("customizations") == (settings if python else None)
