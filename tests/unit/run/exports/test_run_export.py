"""`rosml run --export`: what would run, as a file for docker compose or for an editor, says what `--dry-run` says."""

from __future__ import annotations

import json
import os
import shlex
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from fakes import units
from fakes.desks import BARE, Desk
from fakes.exports import DOCKER, ME, OWN, PODMAN, ROOTLESS, call, text
from fakes.stubs import HOSTILE
from rosml.base.errors import RosmlError
from rosml.cli.run.export import KINDS
from rosml.run import words
from rosml.run.context import Context, Host, Image
from rosml.run.exports import compose, description, devcontainer
from rosml.run.plan import make_plan
from rosml.run.words import split

QUIET = ("--no-tz", "--no-it", "--no-user")


def service(*line: str, **facts: Any) -> dict[str, Any]:
    """The service of compose."""
    (found,) = yaml.safe_load(compose.text(call(*line, **facts)))["services"].values()
    return dict(found)


def container(*line: str, **facts: Any) -> dict[str, Any]:
    """The file for editors."""
    return dict(json.loads(devcontainer.text(call(*line, kind="devcontainer", **facts))))


def test_time_to_save_is_in_the_file() -> None:
    """An editor replaces the entrypoint, which would hand a stop on."""
    label = {"io.rosml.component": "base"}
    assert service(*QUIET, "me/ros", labels=label)["stop_grace_period"] == "30s"
    assert "--stop-timeout=30" not in container(*QUIET, "me/ros", labels=label).get("runArgs", [])


# ---- Compose ---------------------------------------------------------------------------------------------------------


def test_a_whole_file_for_compose() -> None:
    """The folder is where the file is, so that it can be moved; files that are written belong to whoever exported it."""
    found = yaml.safe_load(
        compose.text(call("--mws", "--rm", "-d", "-v", "data:/data", "me/ros:jazzy", "colcon", "build"))
    )
    assert found == {
        "services": {
            "robot": {
                "image": "me/ros:jazzy",
                "stdin_open": True,
                "tty": True,
                "labels": {"io.rosml.run.folder": "/home/jo/robot"},
                "environment": {"DOCKER_UID": "1234", "DOCKER_GID": "5678", "DOCKER_USER": "jo", "TZ": "Europe/Berlin"},
                "volumes": [
                    {
                        "type": "bind",
                        "source": ".",
                        "target": "/docker-ros/ws/src/target",
                        "bind": {"create_host_path": False},
                    },
                    "data:/data",
                ],
                "command": ["colcon", "build"],
            }
        },
        "volumes": {"data": {"name": "data"}},
    }


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        (["-e", "A=1", "-e", "A=2", "-e", "B"], {"environment": {"A": "2", "B": None}}),
        (["-v", "./bags:/bags:ro", "-v", "/x:/y"], {"volumes": ["./bags:/bags:ro", "/x:/y"]}),
        (["-v", "/home/jo/robot2:/x", "-v", "/x"], {"volumes": ["/home/jo/robot2:/x", "/x"]}),
        (["--mount", "src=vol,dst=/v,ro"], {"volumes": [{"type": "volume", "source": "vol", "target": "/v", "read_only": True}]}),
        (
            ["--mount", "type=tmpfs,target=/t,tmpfs-mode=1777"],
            {"volumes": [{"type": "tmpfs", "target": "/t", "tmpfs": {"mode": 0o1777}}]},
        ),
        (["--network", "host", "--net=none"], {"network_mode": "none"}),
        (["--network=robots"], {"networks": {"robots": {}}}),
        (["-w", "/a", "--workdir=/b", "-u0"], {"working_dir": "/b", "user": "0"}),
        (["--device", "nvidia.com/gpu=all", "--device=/dev/video0"], {"devices": ["nvidia.com/gpu=all", "/dev/video0"]}),
        (["--group-add", "44", "--group-add", "44"], {"group_add": ["44"]}),
        (["--shm-size=8g", "--ipc", "host", "--memory=1g"], {"shm_size": "8g", "ipc": "host", "mem_limit": "1g"}),
        (["--ulimit", "rtprio=99", "--ulimit=memlock=-1:-1"], {"ulimits": {"rtprio": 99, "memlock": {"soft": -1, "hard": -1}}}),
        (["--privileged", "--init=false", "-it"], {"privileged": True, "init": False, "stdin_open": True, "tty": True}),
        (["--cap-add", "SYS_NICE", "--security-opt", "seccomp=unconfined"], {"cap_add": ["SYS_NICE"], "security_opt": ["seccomp=unconfined"]}),
        (["-p", "22:22", "--expose", "80"], {"ports": ["22:22"], "expose": ["80"]}),
        (["--log-driver=local", "--log-opt", "max-size=1m"], {"logging": {"driver": "local", "options": {"max-size": "1m"}}}),
        (["--health-cmd", "curl x", "--health-interval=5s"], {"healthcheck": {"test": "curl x", "interval": "5s"}}),
        (["--env-file", "./a", "--stop-timeout=5"], {"env_file": [{"path": "./a", "format": "raw"}], "stop_grace_period": "5s"}),
        (["--env-file", "/home/jo/robot/a"], {"env_file": [{"path": "./a", "format": "raw"}]}),
        (["--label-file", "a", "--label-file=../b"], {"label_file": ["./a", "/home/jo/b"]}),
        (["--restart=no", "--name=xy", "--userns=host"], {"restart": "no", "container_name": "xy", "userns_mode": "host"}),
        (["--entrypoint", "a b", "--volumes-from=other"], {"entrypoint": ["a b"], "volumes_from": ["container:other"]}),
    ],
)  # fmt: skip
def test_an_option_as_compose_has_it(written: list[str], expected: dict[str, Any]) -> None:
    assert service(*QUIET, *written, "x").items() >= expected.items()


@pytest.mark.parametrize(
    ("asked", "expected"),
    [
        ("all", {"count": "all"}),
        ("2", {"count": 2}),
        ("device=0", {"device_ids": ["0"]}),
        ('"device=0,1"', {"device_ids": ["0", "1"]}),
        ('all,"capabilities=utility,compute"', {"count": "all", "capabilities": ["gpu", "utility", "compute"]}),
    ],
)
def test_gpus_of_compose(asked: str, expected: dict[str, Any]) -> None:
    (found,) = service("--gpus", asked, "x")["deploy"]["resources"]["reservations"]["devices"]
    assert found == {"driver": "nvidia", "capabilities": ["gpu"], **expected}


@pytest.mark.parametrize(
    ("written", "says"),
    [
        (["--name", "a b"], "--name 'a b' is no name"),
        (["--name="], "--name '' is no name"),
        (["--name", "x"], "--name 'x' is no name"),
        (["-e", "=1"], "--env '=1' has no name"),
        (["-l", ""], "--label '' has no name"),
    ],
)
def test_names_that_the_engines_refuse(written: list[str], says: str) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        call(*written, "x")
    assert caught.value.remedy and caught.value.exit_code == 2


def test_podmans_entry_has_no_word_in_compose() -> None:
    """An editor hands it to podman."""
    ids = {"user": "1234:5678", "userns_mode": "keep-id"}
    assert ids.items() <= service("--mwd", "x", engine=PODMAN, ours=False).items()
    assert service("--mwd", "x", engine=PODMAN)["user"] == "0:0"
    assert "--passwd-entry=jo:*:1234:5678::/tmp:/bin/sh" in container("x", engine=PODMAN)["runArgs"]


def test_networks_and_volumes_are_those_that_the_engine_has() -> None:
    """Compose would put the project's name before theirs."""
    found = yaml.safe_load(
        compose.text(call("--network=robots", "-v", "data:/d", "--mount", "src=more,dst=/m", "-v", ".:/x", "x"))
    )
    assert found["networks"] == {"robots": {"name": "robots", "external": True}}
    assert found["volumes"] == {"data": {"name": "data"}, "more": {"name": "more"}}


VALUES = {"name": "n78", "gpus": "device=78", "mount": "source=78,target=/x", "cgroupns": "private", "pull": "missing"}


@pytest.mark.parametrize("name", sorted(words.table().names - {*description.OF_A_CALL}))
def test_no_option_gets_lost(name: str) -> None:
    """It is in the file, or an error names it; a terminal and an entrypoint are the editor's."""
    value = VALUES.get(name, "78=9") if name in words.table().values else ""
    option = f"--{name}={value}" if value else f"--{name}"
    try:
        assert service(*QUIET, option, "x") != service(*QUIET, "x")
        assert ("78" if "78" in value else value) in compose.text(call(*QUIET, option, "x"))
    except RosmlError as error:
        assert error.message.startswith(f"--{name}") and error.remedy
    if name not in ("entrypoint", *devcontainer.DROPPED):
        assert container(*QUIET, option, "x") != container(*QUIET, "x")
        assert ("78" if "78" in value else value) in json.dumps(container(*QUIET, option, "x"))


@pytest.mark.parametrize("name", description.OF_A_CALL)
def test_what_is_of_one_call(name: str) -> None:
    option = f"--{name}" + ("=78" if name in words.table().values else "")
    assert service(*QUIET, option, "x") == service(*QUIET, "x")
    assert container(*QUIET, option, "x") == container(*QUIET, "x")


@pytest.mark.parametrize(
    ("written", "named"),
    [
        (["--blkio-weight", "5"], "--blkio-weight"),
        (["--brand-new=5"], "--brand-new"),
        (["-P"], "--publish-all"),
        (["--pull=newer"], "--pull=newer"),
        (["--network", "name=x,alias=y"], "--network name=x"),
        (["--mount", "type=bind,source=/a,target=/b,bind-nonrecursive"], "bind-nonrecursive of --mount"),
        (["--gpus", "all,options=x"], "options of --gpus"),
    ],
)
def test_an_option_that_compose_does_not_have(written: list[str], named: str) -> None:
    with pytest.raises(RosmlError, match="has no counterpart in") as caught:
        compose.text(call(*written, "x"))
    assert caught.value.message.startswith(named) and "leave out" in caught.value.remedy


def test_quotes_that_do_not_close() -> None:
    with pytest.raises(RosmlError, match="quotes do not close"):
        compose.text(call("--mount", '"type=bind', "x"))


TEXT = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"))


@settings(max_examples=300, deadline=None)
@given(st.lists(TEXT), TEXT)
@example(["$HOME", "$$"], "a ${b}")
def test_words_are_the_same_in_the_file(command: list[str], value: str) -> None:
    """`$`, quotes, spaces, numbers and letters of any language; compose reads two `$` as one."""
    assume(command[:1] != [""])
    found = service("-e", f"A={value}", "x", *command)
    assert [word.replace("$$", "$") for word in found.get("command", [])] == command
    assert found["environment"]["A"].replace("$$", "$") == value
    assert "$" not in found["environment"]["A"].replace("$$", "")
    assert container("-e", f"A={value}", "x")["containerEnv"]["A"] == value


def test_what_another_reader_of_yaml_takes_for_a_number() -> None:
    text = compose.text(call("x", "1e3", "0o7", "no", "~", "0x1", ".5", "1:30", "-1"))
    assert [line for line in text.splitlines() if line.startswith("    - ") and line[6] not in "\"'"] == []


# ---- Editors ---------------------------------------------------------------------------------------------------------


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
    assert container(*line) == {
        "name": "robot",
        "image": "me/ros:jazzy",
        "workspaceMount": "type=bind,source=${localWorkspaceFolder},target=/docker-ros/ws/src/target",
        "workspaceFolder": "/docker-ros/ws/src/target",
        "containerUser": "1234:5678",
        "updateRemoteUserUID": False,
        "containerEnv": {
            "HOME": "/tmp",
            "USER": "jo",
            "LOGNAME": "jo",
            "TZ": "Europe/Berlin",
            "ROBOT": "${localEnv:ROBOT}",
        },
        "privileged": True,
        "securityOpt": ["no-new-privileges"],
        "runArgs": [
            "--label=io.rosml.run.folder=${localWorkspaceFolder}",
            "--group-add=0",
            "--volume=${localWorkspaceFolder}/bags:/bags",
            "--gpus=all",
        ],
    }


@pytest.mark.parametrize(
    ("written", "folder", "others"),
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
def test_the_folder_that_is_opened(written: list[str], folder: str | None, others: list[str]) -> None:
    found = container(*written, "x")
    assert found.get("workspaceFolder") == folder and ("workspaceMount" in found) == (folder is not None)
    assert found.get("mounts", []) == others


@pytest.mark.parametrize(
    ("facts", "written", "user", "group"),
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
def test_who_runs_in_an_editor(facts: dict[str, Any], written: list[str], user: str | None, group: bool) -> None:
    found = container(*written, "x", **facts)
    assert found.get("containerUser") == user and ("--group-add=0" in found["runArgs"]) == group
    assert ("--userns=keep-id" in found["runArgs"]) == (facts.get("engine") is PODMAN)
    locked = ["no-new-privileges"] if user == "1234:5678" and "engine" not in facts else None
    assert found.get("securityOpt") == locked
    assert "DOCKER_UID" not in found.get("containerEnv", {})


@pytest.mark.parametrize(
    ("line", "says"),
    [(["x", "colcon", "build"], "such as colcon"), (["--entrypoint", "sh", "x"], "leave out --entrypoint")],
)
def test_what_an_editor_does_itself(line: list[str], says: str) -> None:
    with pytest.raises(RosmlError) as caught:
        container(*line)
    assert says in f"{caught.value.message} {caught.value.remedy}"


def test_places_of_this_machine_are_found_from_anywhere() -> None:
    """And those of the container stay."""
    files = container("--env-file", "../a", "--env-file=./b", "--label-file=/c", "x")["runArgs"]
    assert files[-3:] == ["--env-file=/home/jo/a", "--env-file=${localWorkspaceFolder}/b", "--label-file=/c"]
    mounts = container("-v", ".:/ws:ro", "-v", "/home/jo/robot/x", "-w", "/home/jo/robot", "x")["runArgs"]
    assert mounts[-3:] == [
        "--volume=${localWorkspaceFolder}:/ws:ro",
        "--volume=/home/jo/robot/x",
        "--workdir=/home/jo/robot",
    ]


# ---- What lasts ------------------------------------------------------------------------------------------------------


@pytest.fixture
def shown(tmp_path: Path) -> Host:
    """A machine with a display."""
    (tmp_path / "tmp/.X11-unix").mkdir(parents=True)
    (tmp_path / "tmp/.X11-unix/X1").touch()
    return Host(tmp_path, {"DISPLAY": ":1"}, connects=lambda address: True)


def test_windows_are_those_of_whoever_starts_it(shown: Host) -> None:
    """Not the cookie, nor today's display."""
    found = service("x", host=shown)
    assert found["environment"].items() >= {"DISPLAY": None, "QT_X11_NO_MITSHM": "1"}.items()
    assert found["volumes"] == ["/tmp/.X11-unix:/tmp/.X11-unix"]
    assert container("x", host=shown)["containerEnv"]["DISPLAY"] == "${localEnv:DISPLAY}"


@pytest.mark.parametrize(
    ("written", "display"),
    [(["--no-x11"], ":1"), ([], ""), ([], "localhost:10.0"), ([], ":2"), (["-e", "DISPLAY=:7"], ":1")],
)
def test_no_windows(shown: Host, written: list[str], display: str) -> None:
    found = service(*written, "x", host=replace(shown, environment={"DISPLAY": display}))
    assert "volumes" not in found and found["environment"].get("DISPLAY") in (None, ":7")
    assert "network_mode" not in found


def test_the_agent_of_ssh_is_of_one_session() -> None:
    with pytest.raises(RosmlError, match="--ssh-agent does not go with --export"):
        call("--ssh-agent", "x")


# ---- The command -----------------------------------------------------------------------------------------------------


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    """A desk with docker, whose image `ours` is trusted."""
    made = Desk(tmp_path)
    made.engine()
    made.trust(ours=True)
    return made


@pytest.mark.parametrize("option", [["--export", "compose"], ["--export=compose"]])
def test_a_file_is_printed_and_nothing_runs(desk: Desk, option: list[str]) -> None:
    done = desk.call(*option, "-e", "A=ü", "ours", "echo", "--export")
    assert (done.returncode, done.stderr) == (0, "")
    assert yaml.safe_load(done.stdout)["services"]["dr"]["command"] == ["echo", "--export"]
    assert {call[1] for call in desk.calls} == {"info", "image"}


@pytest.mark.parametrize("kind", ["quadlet", "kubernetes"])
def test_a_service_that_would_end_at_once(desk: Desk, kind: str) -> None:
    """The image starts a shell. And podman makes no folder that is mounted."""
    desk.engine(
        configs={"ours": {"Cmd": ["bash"], "Healthcheck": {"Test": ["CMD", "check"], "Interval": 5_000_000_000}}}
    )
    done = desk.call("--export", kind, "-v", "./missing:/bags", "ours")
    assert done.returncode == 0 and "starts 'bash', which ends at once without a terminal" in done.stderr, done.stderr
    assert ("missing is missing here" in done.stderr) == (kind == "quadlet")
    assert ("\n          periodSeconds: 5\n" in done.stdout) == (kind == "kubernetes")
    done = desk.call("--export", kind, "ours", "sleep", "1")
    assert (done.returncode, done.stderr) == (0, "") and done.stdout.startswith("# dr ")


def test_a_service_is_added(desk: Desk) -> None:
    (desk.folder / "compose.yaml").write_text("# mine\nservices:\n  a:\n    image: x\n")
    done = desk.call("--export", "compose", "--add", "compose.yaml", "--name", "arm", "ours", "ls")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "compose.yaml: added the service arm\n")
    found = (desk.folder / "compose.yaml").read_text()
    assert found.startswith("# mine\nservices:\n  a:\n    image: x\n  arm:\n") and not desk.called("run")
    assert (
        "has the service arm already"
        in desk.call("--export=compose", "--add=compose.yaml", "--name=arm", "ours", "ls").stderr
    )
    again = desk.call("--export=compose", "--add=compose.yaml", "--name=arm", "ours", "pwd")
    assert again.returncode == 125 and "a service arm already, with other content" in again.stderr
    assert (desk.folder / "compose.yaml").read_text() == found


@pytest.mark.parametrize(
    "said",
    [
        {"Test": "CMD x"},
        {"Test": [1]},
        {"Test": ["CMD", "x"], "Interval": -1},
        {"Test": ["CMD", "x"], "Retries": "3"},
        {"Test": ["CMD", "x"], "Timeout": 2**64},
        ["CMD"],
    ],
)
def test_a_healthcheck_that_is_none(desk: Desk, said: object) -> None:
    desk.engine(configs={"ours": {"Healthcheck": said}})
    done = desk.call("--export", "kubernetes", "ours", "ls")
    assert done.returncode == 125 and "answers with something that rosml does not understand" in done.stderr


@pytest.mark.parametrize("said", [None, {}, {"Test": []}, {"Test": ["NONE"]}, {"Test": ["CMD-SHELL"]}, {"Interval": 5}])
def test_an_image_without_a_healthcheck(desk: Desk, said: object) -> None:
    desk.engine(configs={"ours": {"Healthcheck": said}})
    done = desk.call("--export", "kubernetes", "ours", "ls")
    assert done.returncode == 0 and "livenessProbe" not in done.stdout


def test_it_says_what_a_dry_run_says(desk: Desk) -> None:
    code, told = desk.on_a_terminal("--dry-run", "--no-name", "--mws", "--mwd", "-e", "A=b c", "ours", "ls", "-l")
    exported = yaml.safe_load(desk.call("--export=compose", "--mws", "--mwd", "-e", "A=b c", "ours", "ls", "-l").stdout)
    line = split(shlex.split(told.decode())[2:], ())
    found = exported["services"]["dr"]
    assert code == 0 and [*line.command] == found["command"] and line.image == found["image"]
    assert dict(x.split("=", 1) for x in line.values("env")) == found["environment"]
    assert line.value("workdir") == found["working_dir"] == str(desk.folder)
    mounted = [dict(field.split("=") for field in mount.split(",")) for mount in line.values("mount")]
    assert [mount["target"] for mount in mounted] == [mount["target"] for mount in found["volumes"]]
    assert {*line.values("label")} == {f"{key}={value}" for key, value in found["labels"].items()}
    assert {name for option in line.engine for name in option.names} == {
        *("rm", "interactive", "tty", "label", "env", "mount", "workdir"), *(["user"] if "user" in found else []),
    }  # fmt: skip


@pytest.mark.parametrize(
    ("line", "says"),
    [
        (["--export", "compose"], "--export needs an image"),
        (["--export"], "the option --export lacks its value"),
        (["--export", "helm", "ours"], "'helm' is not one of 'devcontainer', 'compose', 'quadlet', 'kubernetes'"),
        (["--add", "compose.yaml", "ours"], "--add goes with --export compose"),
        (["--export", "quadlet", "--add", "compose.yaml", "ours"], "--add goes with --export compose"),
        (["--export", "compose", "--add", "compose.yaml", "ours"], "there is no such file"),
        (["--export", "compose", "--add", "", "ours"], "it is no file"),
        (["--export", "quadlet", "ours", "a", ""], "the word '' does not go with --export quadlet"),
        (["--export", "kubernetes", "-v", "data:/d", "ours"], "-v data:/d has no counterpart"),
        (["--export", "compose", "--check", "ours"], "--export does not go with --check"),
        (["--export", "compose", "no/such:image"], "no image no/such:image here"),
        (["--export", "compose", "--blkio-weight=5", "ours"], "--blkio-weight has no counterpart"),
    ],
)
def test_a_call_that_is_wrong(desk: Desk, line: list[str], says: str) -> None:
    done = desk.call(*line)
    assert done.returncode == 125 and done.stdout == "" and says in done.stderr, done.stderr
    assert "Traceback" not in done.stderr and not desk.called("run") and not desk.called("pull")


def test_bytes_that_are_no_text() -> None:
    with pytest.raises(RosmlError, match="is no text"):
        call("x", os.fsdecode(b"\xff"))


def of_compose(text: str) -> tuple[list[str], str, str]:
    (found,) = yaml.safe_load(text)["services"].values()
    assert "$" not in str(found).replace("$$", "")
    words = [word.replace("$$", "$") for word in (*found["command"], found["environment"]["A"], found["labels"]["l"])]
    return words[:-2], words[-2], words[-1]


def of_editors(text: str) -> tuple[list[str], str, str]:
    found = json.loads(text)
    assert "Env:" not in found["containerEnv"]["A"]
    (label,) = [word[len("--label=l=") :] for word in found["runArgs"] if word.startswith("--label=l=")]
    return [], found["containerEnv"]["A"], label


def of_systemd(text: str) -> tuple[list[str], str, str]:
    found = units.argv(text)
    value, label = (next(w for w in found if w.startswith(name))[len(name) :] for name in ("--env=A=", "--label=l="))
    return found[-2:], value, label


def of_kubernetes(text: str) -> tuple[list[str], str, str]:
    template = yaml.safe_load(text)["spec"]["template"]
    (found,) = template["spec"]["containers"]
    (value,) = [item["value"] for item in found["env"] if item["name"] == "A"]
    words = [*found["args"], value, value]
    assert "$" not in "".join(words).replace("$$", "")
    words = [word.replace("$$", "$") for word in words]
    return words[:-2], words[-2], words[-1]


READERS = {"compose": of_compose, "devcontainer": of_editors, "quadlet": of_systemd, "kubernetes": of_kubernetes}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("written", HOSTILE)
def test_texts_that_mean_something_in_a_file_are_only_texts(written: str, kind: str) -> None:
    """Read as the file's system reads it, or refused. A cluster has no labels of containers, and an editor starts no command."""
    label = () if kind == "kubernetes" else ("--label", f"l={written}")
    command = [] if kind == "devcontainer" else ["ros2", written]
    try:
        found = text("-e", f"A={written}", *label, "img", *command, kind=kind)
    except RosmlError as error:
        assert kind == "devcontainer" and "${" in written and error.remedy
        return
    assert READERS[kind](found) == (command, written, written)


@pytest.mark.parametrize(
    "text", ["${localEnv:TOKEN}", "a${ localEnv:TOKEN}", "${env:A}", "${containerEnv:PATH}", "${localWorkspaceFolder}"]
)
def test_a_variable_of_editors_in_a_strangers_text_is_refused(text: str) -> None:
    """Editors put in something of the desk, and have no escape."""
    kind, image = (
        KINDS["devcontainer"],
        Image(environment={"DOCKER_UID": "", "WORKSPACE": f"/x/{text}"}, command=("bash",)),
    )
    context = kind.settled(kind.seen(Context(split(["--mws", "img"], OWN), DOCKER, ME, image, BARE, True)))
    with pytest.raises(RosmlError, match="an editor puts in something of your machine"):
        kind.text(description.describe(context, make_plan(context).argv, ""))
