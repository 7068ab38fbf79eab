"""`rosml attach`, and `rosml run` whose container runs already: which container is entered, and how."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from fakes.desks import OURS, Desk, docker_desk, folder_container
from rosml.run import attach
from rosml.run.context import Container, Image, Person
from rosml.run.plugins import xauthority
from rosml.run.plugins.xauthority import LOCAL, Entry
from rosml.run.words import split

FOLDER = "io.rosml.run.folder"


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return docker_desk(tmp_path, "attach")


@pytest.fixture
def run_desk(desk: Desk) -> Desk:
    """A desk whose folder's container runs, for calls of `rosml run`."""
    desk.command = "run"
    desk.engine(containers={"dr": folder_container(desk)})
    return desk


def entered(desk: Desk) -> list[str]:
    """The words with which the only container was entered."""
    (call,) = [call for call in desk.calls if call[1] in ("exec", "run")]
    assert call[:2] == ["docker", "exec"]
    return call[2:]


def test_the_container_of_the_folder_is_entered(desk: Desk) -> None:
    """Through the entrypoint, which makes the user and sources ROS; without a terminal where there is none."""
    desk.engine(containers={"dr": folder_container(desk)})
    done = desk.call()
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert entered(desk) == ["dr", "/entrypoint.sh", "bash"]
    assert ["docker", "ps", "--all", "--quiet", "--no-trunc", "--filter", f"label={FOLDER}"] in desk.calls


def test_a_command_arrives_as_it_is(desk: Desk) -> None:
    desk.engine(containers={"dr": folder_container(desk)}, code=42)
    words = ["bash", "-c", 'echo "a  b"', "--verbose", "-e", "", "*"]
    assert "/entrypoint.sh bash -c" in desk.call("--dry-run", ".", *words).stdout and not desk.called("exec")
    assert desk.call("-e", "A=b c", "--workdir=/x", ".", *words).returncode == 42
    assert entered(desk) == ["-e", "A=b c", "--workdir=/x", "dr", "/entrypoint.sh", *words]


def test_a_container_by_its_name(desk: Desk) -> None:
    desk.engine(containers={"x": ["running", "/x", "sha256:y", {"Env": None, "User": "7:8"}, None]})
    assert desk.call("x", "ls").returncode == 0 and entered(desk) == ["--user", "7:8", "x", "ls"]
    done = desk.call("y")
    assert done.returncode == 125 and "error: no container named y\nremedy: docker ps --all" in done.stderr


@pytest.mark.parametrize(
    ("command", "is_shell"),
    [
        ("zsh", True),
        ("/bin/bash -l", True),
        ("roslaunch x", False),
        ("bash -c x", False),
        ("/bin/bash start.sh", False),
    ],
)
def test_a_shell_of_the_image_is_the_shell_and_an_app_is_not_started_again(
    desk: Desk, command: str, is_shell: bool
) -> None:
    desk.engine(containers={"dr": folder_container(desk)}, configs={"ours": {"Cmd": command.split()}})
    words = command.split() if is_shell else ["bash"]
    assert desk.call("dr").returncode == 0 and entered(desk) == ["dr", "/entrypoint.sh", *words]


def test_a_stopped_container_is_started_first(desk: Desk) -> None:
    desk.engine(containers={"dr": folder_container(desk, state="exited")})
    shown = desk.call("--dry-run", ".", "ls")
    assert shown.stderr == "dr is exited: docker start dr comes first\n" and not desk.called("start")
    assert desk.call(".", "ls").returncode == 0
    assert [call[1] for call in desk.calls if call[1] in ("start", "exec")] == ["start", "exec"]
    desk.engine(containers={"dr": folder_container(desk, state="exited")}, started="exited")
    done = desk.call()
    assert done.returncode == 125 and "error: dr has ended at once" in done.stderr and "docker logs dr" in done.stderr


COOKIE = Entry(LOCAL, b"x", b"0", b"k", b"secret")


def kept(desk: Desk, source: str) -> list[Any]:
    container = folder_container(desk, state="exited")
    container[3]["Env"] = [*OURS, "DISPLAY=:0"]
    container[4] = [{"Destination": "/run/rosml/xauth", "Source": source}]
    return container


def test_what_logging_out_has_removed_is_written_again(desk: Desk) -> None:
    session = desk.root / f"run/user/{os.geteuid()}"
    session.mkdir(parents=True)
    file = f"/run/user/{os.geteuid()}/rosml/xauth-0"
    (desk.root / "c").write_bytes(xauthority.written([COOKIE]))
    for cookies, secrets in (("/c", [b"secret"]), ("/none", [])):
        desk.engine(containers={"dr": kept(desk, file)})
        done = desk.call(XAUTHORITY=cookies, XDG_RUNTIME_DIR=f"/run/user/{os.geteuid()}")
        assert (done.returncode, done.stderr) == (0, "")
        assert [entry.secret for entry in xauthority.read((session / "rosml/xauth-0").read_bytes())] == secrets


def test_no_other_file_is_written_for_a_container(desk: Desk) -> None:
    """Whoever made the container chose what is mounted there."""
    (desk.root / f"run/user/{os.geteuid()}").mkdir(parents=True)
    desk.engine(containers={"dr": kept(desk, "/home/me/rosml/xauth-0")})
    assert desk.call(XDG_RUNTIME_DIR=f"/run/user/{os.geteuid()}").returncode == 0
    assert not [*desk.root.rglob("xauth-0")]


def test_a_remedy_says_what_is_lost(desk: Desk) -> None:
    desk.engine(containers={"dr": kept(desk, "/run/user/7/gone")}, started="")
    done = desk.call()
    assert "error: docker cannot start dr: /run/user/7/gone, which is mounted in it, is gone\n" in done.stderr
    lost = "docker rm dr removes it with all that was written in it; docker commit dr IMAGE keeps that"
    assert f"remedy: make it again, and try once more; {lost}\n" in done.stderr


@pytest.mark.parametrize(
    ("state", "remedy"),
    [("paused", "docker unpause dr"), ("removing", "wait, or docker rm --force dr"), ("dead", "wait, or")],
)
def test_one_that_cannot_be_entered(desk: Desk, state: str, remedy: str) -> None:
    desk.engine(containers={"dr": folder_container(desk, state=state)})
    done = desk.call()
    assert done.returncode == 125 and f"dr cannot be entered: it is {state}\nremedy: {remedy}" in done.stderr
    assert not desk.called("exec") and not desk.called("start")


def test_several_containers_of_a_folder(desk: Desk) -> None:
    """The one that runs is meant."""
    stopped, running = folder_container(desk, state="exited", name="stopped"), folder_container(desk, name="running")
    other = folder_container(desk, name="other")
    other[3]["Labels"] = {FOLDER: str(desk.folder.parent)}
    desk.engine(containers={"stopped": stopped, "running": running, "other": other})
    assert desk.call(".", "ls").returncode == 0 and entered(desk)[0] == "running"
    desk.engine(containers={"b": folder_container(desk, name="b"), "stopped": stopped, "running": running})
    done = desk.call()
    assert done.returncode == 125 and "remedy: rosml attach b" in done.stderr
    assert "2 containers of this folder: b (ours, running), running (ours, running)" in done.stderr
    desk.engine(containers={"other": other})
    done = desk.call()
    assert done.returncode == 125 and "rosml attach NAME enters one of other folders: other (ours" in done.stderr


@pytest.mark.parametrize("words", [[], ["ours"], ["--name=dr", "--rm", "-it", "ours"]])
def test_the_same_call_enters_its_container(run_desk: Desk, words: list[str]) -> None:
    assert run_desk.on_a_terminal(*words) == (0, b"")
    assert [word for word in entered(run_desk) if word not in ("-i", "-t", "-it")] == ["dr", "/entrypoint.sh", "bash"]


def test_a_call_without_a_terminal_starts_another(run_desk: Desk) -> None:
    """Programs that call it twice at a time get two."""
    assert run_desk.call("ours").returncode == 0 and run_desk.ran[1] == "run"


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["ubuntu"], "dr runs ours, and you ask for ubuntu"),
        (["-itv./a:/a", "ours"], "-itv./a:/a is for a container that starts"),
        (["--mws", "ours"], "dr runs without this folder at /docker-ros/ws/src/target"),
        (["-d", "ours"], "dr runs already"),
    ],
)
def test_a_call_that_asks_for_another_container(run_desk: Desk, words: list[str], says: str) -> None:
    """Both ways out are named, and the second one works."""
    code, screen = run_desk.on_a_terminal(*words)
    assert code and all(text in screen.decode() for text in (says, "rosml attach dr", "--new starts"))
    assert not run_desk.called("exec") and not run_desk.called("run")
    assert run_desk.on_a_terminal("--new", *words)[0] == 0 and run_desk.ran[1] == "run"


def test_an_image_that_was_built_again(run_desk: Desk) -> None:
    container = folder_container(run_desk)
    container[2] = "sha256:before"
    run_desk.engine(containers={"dr": container})
    code, screen = run_desk.on_a_terminal("ours")
    assert code == 125 and b"dr runs an older ours" in screen


def test_a_folder_that_is_mounted(run_desk: Desk) -> None:
    run_desk.engine(containers={"dr": folder_container(run_desk, mounts=["/docker-ros/ws/src/target"])})
    assert run_desk.on_a_terminal("--mws", "ours")[0] == 0
    assert entered(run_desk)[2:] == ["dr", "/entrypoint.sh", "bash"]


@pytest.mark.parametrize("words", [[], ["ours"]])
def test_a_container_without_the_network_for_ros_is_entered_with_a_warning(run_desk: Desk, words: list[str]) -> None:
    networks = [{"NetworkMode": "host", "IpcMode": ipc} for ipc in ("private", "host")]
    run_desk.engine(containers={"dr": [*folder_container(run_desk), networks[0]]})
    code, screen = run_desk.on_a_terminal("--ros-network", *words)
    assert code == 0 and "dr" in entered(run_desk)
    assert b"dr runs without --ros-network: its network is host, its shared memory private" in screen
    run_desk.engine(containers={"dr": [*folder_container(run_desk), networks[1]]})
    assert run_desk.on_a_terminal("--ros-network", *words) == (0, b"")


CONTRACT = {"DOCKER_UID": ""}
ME = Person(1000, 1000, "me", "/home/me")
BUILT_ON_OURS = Container("c", "running", environment=CONTRACT, labels={"io.rosml.component": "base"}, user="7")
FOREIGN = Container("c", "running", environment={"DOCKER_UID": "7"}, user="1000:1000")


@pytest.mark.parametrize(
    ("container", "image", "words", "expected"),
    [
        (BUILT_ON_OURS, Image(command=("zsh",)), [], ["--user", "7", "c", "/entrypoint.sh", "zsh"]),
        (FOREIGN, Image(command=("sh",)), [], ["--user", "1000:1000", "c", "sh"]),
        (FOREIGN, Image(command=("-x",), entrypoint=("/run",)), [], ["--user", "1000:1000", "c", "bash"]),
        (FOREIGN, None, ["--name=x", "--rm"], ["--user", "1000:1000", "c", "bash"]),
        (BUILT_ON_OURS, None, ["-u0", "-deA=b"], ["-u0", "-deA=b", "c", "/entrypoint.sh", "bash"]),
    ],
)
def test_who_enters(container: Container, image: Image | None, words: list[str], expected: list[str]) -> None:
    assert attach.argv("podman", split([*words, "c"], ()), ME, container, image) == ["podman", "exec", *expected]
