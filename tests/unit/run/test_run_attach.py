"""`rosml attach`, and `rosml run` where its container runs already: which container is entered, and how."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from fakes.desks import OTHER, OURS, Desk
from rosml.base.errors import RosmlError
from rosml.cli.run import attach as cli
from rosml.run import attach
from rosml.run.context import Container, Image, Person
from rosml.run.plugins import xauthority
from rosml.run.plugins.xauthority import LOCAL, Entry
from rosml.run.words import Line, split

FOLDER = "io.rosml.run.folder"
ENTRYPOINT = ["/tini", "--", "/entrypoint.sh"]


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    """A desk in whose folder nothing runs yet. Its image `ours` is trusted."""
    made = Desk(tmp_path)
    made.command = "attach"
    made.engine()
    made.trust(ours=True)
    return made


def facts(desk: Desk, image: str = "ours", state: str = "running", name: str = "dr", **config: Any) -> list[Any]:
    """A container of the desk's folder, as an engine has it."""
    ours = {"Env": OURS, "Entrypoint": ENTRYPOINT} if image == "ours" else {"Env": OTHER}
    labels = {FOLDER: str(desk.folder)}
    mounts = [{"Destination": place} for place in config.pop("mounts", [])]
    return [state, f"/{name}", f"sha256:{image}", {"Image": image, "Labels": labels, **ours, **config}, mounts]


def entered(desk: Desk) -> list[str]:
    """How the only container was entered."""
    (found,) = [call for call in desk.calls if call[1] in ("exec", "run")]
    assert found[:2] == ["docker", "exec"]
    return found[2:]


# ---- rosml attach ----------------------------------------------------------------------------------------------------


def test_the_container_of_the_folder_is_entered(desk: Desk) -> None:
    """Through the entrypoint, which makes the user and sources ROS; without a terminal where there is none."""
    desk.engine(containers={"dr": facts(desk)})
    done = desk.call()
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert entered(desk) == ["dr", "/entrypoint.sh", "bash"]
    assert ["docker", "ps", "--all", "--quiet", "--no-trunc", "--filter", f"label={FOLDER}"] in desk.calls


def test_on_a_terminal(desk: Desk) -> None:
    desk.engine(containers={"dr": facts(desk)})
    assert desk.on_a_terminal() == (0, b"")
    assert entered(desk) == ["-i", "-t", "dr", "/entrypoint.sh", "bash"]


@pytest.mark.parametrize("words", [["bash", "-c", 'echo "a  b"'], ["ls", "--verbose", "-e", ""], ["a\\b", "*"]])
def test_a_command_arrives_as_it_is(desk: Desk, words: list[str]) -> None:
    desk.engine(containers={"dr": facts(desk)}, code=42)
    assert desk.call("-e", "A=b c", "--workdir=/x", ".", *words).returncode == 42
    assert entered(desk) == ["-e", "A=b c", "--workdir=/x", "dr", "/entrypoint.sh", *words]


def test_a_container_by_its_name(desk: Desk) -> None:
    """Also one that rosml did not start."""
    desk.engine(containers={"x": ["running", "/x", "sha256:y", {"Env": None, "User": "7:8"}, None]})
    assert desk.call("x", "ls").returncode == 0
    assert entered(desk) == ["--user", "7:8", "x", "ls"]
    done = desk.call("y")
    assert done.returncode == 125 and "error: no container named y\nremedy: docker ps --all" in done.stderr


def test_the_images_command_is_the_default(desk: Desk) -> None:
    desk.engine(containers={"dr": facts(desk, "alpine")}, images={"alpine": OTHER}, configs={"alpine": {"Cmd": ["sh"]}})
    assert desk.call().returncode == 0 and entered(desk) == ["dr", "sh"]


def test_what_another_images_entrypoint_takes_is_no_default(desk: Desk) -> None:
    """`sh` may be an argument of it."""
    desk.engine(
        containers={"dr": facts(desk, "alpine", Entrypoint=["/init"])},
        images={"alpine": OTHER},
        configs={"alpine": {"Cmd": ["sh"], "Entrypoint": ["/init"]}},
    )
    assert desk.call().returncode == 0 and entered(desk) == ["dr", "bash"]


@pytest.mark.parametrize(
    "command",
    [
        ["roslaunch", "stop", "two.launch"],
        ["bash", "-c", "exec bash -c roslaunch"],
        ["/bin/bash", "start.sh"],
        ["bash", "-lc", "x"],
    ],
)
def test_an_app_that_runs_there_is_not_started_again(desk: Desk, command: list[str]) -> None:
    """Neither by its container's folder, nor by its name, nor by `rosml run`."""
    desk.engine(containers={"dr": facts(desk)}, images={"ours": OURS}, configs={"ours": {"Cmd": command}})
    for words in ([], ["dr"]):
        assert desk.call(*words).returncode == 0
    assert [call[2:] for call in desk.calls if call[1] == "exec"] == [["dr", "/entrypoint.sh", "bash"]] * 2


@pytest.mark.parametrize("command", [["zsh"], ["/bin/bash", "-l"], ["bash", "--login", "-i"]])
def test_a_shell_of_the_image_is_the_shell(desk: Desk, command: list[str]) -> None:
    desk.engine(containers={"dr": facts(desk)}, images={"ours": OURS}, configs={"ours": {"Cmd": command}})
    assert desk.call().returncode == 0 and entered(desk) == ["dr", "/entrypoint.sh", *command]


def test_what_would_run_is_shown(desk: Desk) -> None:
    desk.engine(containers={"dr": facts(desk)})
    wanted = ["docker", "exec", "dr", "/entrypoint.sh", "echo", "a  b"]
    assert shlex.split(desk.call("--dry-run", ".", "echo", "a  b").stdout) == wanted
    assert json.loads(desk.call("--json", ".", "echo", "a  b").stdout) == wanted
    assert not [call for call in desk.calls if call[1] == "exec"]
    assert shlex.split(desk.call("--verbose", ".", "echo", "a  b").stderr) == wanted


def test_one_that_has_ended_is_started_first(desk: Desk) -> None:
    desk.engine(containers={"dr": facts(desk, state="exited")})
    shown = desk.call("--dry-run", ".", "ls")
    assert shown.stderr == "dr is exited: docker start dr comes first\n" and not desk.called("start")
    assert desk.call(".", "ls").returncode == 0
    assert [call[1] for call in desk.calls if call[1] in ("start", "exec")] == ["start", "exec"]


COOKIE = Entry(LOCAL, b"x", b"0", b"k", b"secret")


def kept(desk: Desk, source: str) -> list[Any]:
    """A container that has ended, with the cookie of a display mounted."""
    found = facts(desk, state="exited")
    found[3]["Env"] = [*OURS, "DISPLAY=:0"]
    found[4] = [{"Destination": "/run/rosml/xauth", "Source": source}]
    return found


def test_what_logging_out_has_removed_is_written_again(desk: Desk) -> None:
    """The cookie of the display as it is now; without one, a file in its place, so that the container starts."""
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
    """Whoever made the container said what is mounted there."""
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


def test_one_that_ends_again_at_once(desk: Desk) -> None:
    desk.engine(containers={"dr": facts(desk, state="exited")}, started="exited")
    done = desk.call()
    assert done.returncode == 125 and "error: dr has ended at once" in done.stderr and "docker logs dr" in done.stderr
    assert not desk.called("exec")


@pytest.mark.parametrize(
    ("state", "remedy"),
    [("paused", "docker unpause dr"), ("removing", "wait, or docker rm --force dr"), ("dead", "wait, or")],
)
def test_one_that_cannot_be_entered(desk: Desk, state: str, remedy: str) -> None:
    desk.engine(containers={"dr": facts(desk, state=state)})
    done = desk.call()
    assert done.returncode == 125 and f"dr cannot be entered: it is {state}\nremedy: {remedy}" in done.stderr
    assert not desk.called("exec") and not desk.called("start")


def test_several_containers_of_a_folder(desk: Desk) -> None:
    """The one that runs is meant; of several that do, the names are said."""
    old, new = facts(desk, state="exited", name="old"), facts(desk, name="new")
    other = facts(desk, name="other")
    other[3]["Labels"] = {FOLDER: str(desk.folder.parent)}
    desk.engine(containers={"old": old, "new": new, "other": other})
    assert desk.call(".", "ls").returncode == 0 and entered(desk)[0] == "new"
    desk.engine(containers={"b": facts(desk, name="b"), "old": old, "new": new})
    done = desk.call()
    assert done.returncode == 125
    assert "2 containers of this folder: b (ours, running), new (ours, running)" in done.stderr
    assert "remedy: rosml attach b" in done.stderr
    desk.engine(containers={"other": other})
    done = desk.call()
    assert done.returncode == 125 and "rosml attach NAME enters one of other folders: other (ours" in done.stderr


@pytest.mark.parametrize("words", [[], ["x"]])
def test_an_engine_that_does_not_answer(desk: Desk, words: list[str]) -> None:
    desk.engine(complaint="Cannot connect to the Docker daemon", info={"ServerErrors": ["x"]})
    done = desk.call(*words)
    assert done.returncode == 125 and "error: docker does not answer: Cannot connect" in done.stderr


@pytest.mark.parametrize(
    ("what", "answer", "words"),
    [
        *(("container", answer, ["x"]) for answer in ("[1, 2]", "5", "null", '"x" "y"', '5 5 5 5 5')),
        *(("container", f'"/x" "running" "sha256:y" {config} {mounts}', ["x"]) for config, mounts in [
            ("5", "null"), ('{"Env": [5]}', "null"), ('{"Labels": [5]}', "null"), ("{}", "5"), ("{}", "[5]"),
            ('{"Labels": {"a": 5}}', "null"),
        ]),
        ("container", "[1, 2]", []),
        ("ps", "[1, 2]", []),
    ],
)  # fmt: skip
def test_containers_that_are_described_oddly(desk: Desk, what: str, answer: str, words: list[str]) -> None:
    desk.engine(containers={"x": ["running", "/x"]}, answers={what: answer})
    done = desk.call(*words)
    assert done.returncode == 125, done.stderr
    assert done.stderr.startswith("error: docker answers with something that rosml does not understand: ")
    assert f"\nremedy: try `docker {what} " in done.stderr and done.stderr.count("\n") == 2


def test_options_that_only_a_start_takes(desk: Desk) -> None:
    desk.engine(containers={"dr": facts(desk)})
    done = desk.call("-itv./a:/a", ".")
    assert (
        done.returncode == 125 and "-itv./a:/a is for a container that starts, and dr is there already" in done.stderr
    )
    assert not desk.called("exec")


# ---- rosml run -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("words", [[], ["ours"], ["--name=dr", "--rm", "-it", "ours"], ["--no-tz", "ours"]])
def test_the_same_call_enters_what_it_has_started(desk: Desk, words: list[str]) -> None:
    desk.command = "run"
    desk.engine(containers={"dr": facts(desk)})
    assert desk.on_a_terminal(*words) == (0, b"")
    assert [word for word in entered(desk) if word not in ("-i", "-t", "-it")] == ["dr", "/entrypoint.sh", "bash"]


def test_a_call_without_a_terminal_starts_another(desk: Desk) -> None:
    """Programs that call it twice at a time get two."""
    desk.command = "run"
    desk.engine(containers={"dr": facts(desk)})
    assert desk.call("ours").returncode == 0 and desk.ran[1] == "run"


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["ubuntu"], "dr runs ours, and you ask for ubuntu"),
        (["-v", "./a:/a", "ours"], "-v is for a container that starts"),
        (["--mws", "ours"], "dr runs without this folder at /docker-ros/ws/src/target"),
        (["-d", "ours"], "dr runs already"),
    ],
)
def test_a_call_that_asks_for_another_container(desk: Desk, words: list[str], says: str) -> None:
    """Both ways out are named, and the second one works."""
    desk.command = "run"
    desk.engine(containers={"dr": facts(desk)})
    code, told = desk.on_a_terminal(*words)
    assert code and says in told.decode() and "rosml attach dr" in told.decode() and "--new starts" in told.decode()
    assert not desk.called("exec") and not desk.called("run")
    assert desk.on_a_terminal("--new", *words)[0] == 0 and desk.ran[1] == "run"


def test_an_image_that_was_built_again(desk: Desk) -> None:
    found = facts(desk)
    found[2] = "sha256:before"
    desk.command = "run"
    desk.engine(containers={"dr": found})
    code, told = desk.on_a_terminal("ours")
    assert code == 125 and b"dr runs an older ours" in told


def test_a_container_of_another_folder_has_the_name(desk: Desk) -> None:
    desk.command = "run"
    found = facts(desk)
    found[3]["Labels"][FOLDER] = "/other/dr"
    desk.engine(containers={"dr": found})
    code, told = desk.on_a_terminal("ours")
    assert code == 125 and b"dr runs, and it belongs to the folder /other/dr" in told and b"--new starts" in told


def test_a_folder_that_is_mounted(desk: Desk) -> None:
    desk.command = "run"
    desk.engine(containers={"dr": facts(desk, mounts=["/docker-ros/ws/src/target"])})
    assert desk.on_a_terminal("--mws", "ours")[0] == 0
    assert entered(desk)[2:] == ["dr", "/entrypoint.sh", "bash"]


@pytest.mark.parametrize("words", [[], ["ours"]])
def test_a_container_without_the_network_for_ros(desk: Desk, words: list[str]) -> None:
    """It is entered, and a note says what it lacks."""
    desk.command = "run"
    desk.engine(containers={"dr": [*facts(desk), {"NetworkMode": "host", "IpcMode": "private"}]})
    code, told = desk.on_a_terminal("--ros-network", *words)
    assert code == 0 and "dr" in entered(desk)
    assert b"dr runs without --ros-network: its network is host, its shared memory private" in told
    assert b"--new starts another container with it" in told
    desk.engine(containers={"dr": [*facts(desk), {"NetworkMode": "host", "IpcMode": "host"}]})
    assert desk.on_a_terminal("--ros-network", *words) == (0, b"")


# ---- The words -------------------------------------------------------------------------------------------------------

CONTRACT = {"DOCKER_UID": ""}
ME = Person(1000, 1000, "me", "/home/me")
OWN = [name for option in cli.main.params for name in option.opts if name.startswith("--")]
BUILT_ON_OURS = Container("c", "running", environment=CONTRACT, labels={"io.rosml.component": "base"}, user="7")
FOREIGN = Container("c", "running", environment={"DOCKER_UID": "7"}, user="1000:1000")


def line(*words: str) -> Line:
    return split([*words, "c"], OWN)


@pytest.mark.parametrize(
    ("container", "image", "words", "expected"),
    [
        (BUILT_ON_OURS, Image(command=("zsh",)), [], ["--user", "7", "c", "/entrypoint.sh", "zsh"]),
        (BUILT_ON_OURS, None, ["-u0"], ["-u0", "c", "/entrypoint.sh", "bash"]),
        (FOREIGN, Image(command=("sh",)), [], ["--user", "1000:1000", "c", "sh"]),
        (FOREIGN, Image(command=("-x",), entrypoint=("/run",)), [], ["--user", "1000:1000", "c", "bash"]),
        (FOREIGN, None, ["--name=x", "--rm"], ["--user", "1000:1000", "c", "bash"]),
    ],
)
def test_who_enters(container: Container, image: Image | None, words: list[str], expected: list[str]) -> None:
    assert attach.argv("podman", line(*words), ME, container, image) == ["podman", "exec", *expected]


@pytest.mark.parametrize("words", [["--privileged"], ["--env-file=x"], ["--detach-keys", "x"], ["-de", "A=b"]])
def test_options_of_both(words: list[str]) -> None:
    assert attach.argv("docker", line(*words), ME, Container("c", "running"), None)[2:-2] == words
    with pytest.raises(RosmlError, match="--gpus is for a container that starts"):
        attach.argv("docker", line(*words, "--gpus", "all"), ME, Container("c", "running"), None)


def test_podmans_words(desk: Desk) -> None:
    """No slash, no kind of digest, and the entrypoint as text."""
    from rosml.run import engine

    config = {"Env": OURS, "Entrypoint": "/tini -- /entrypoint.sh", "Labels": None}
    desk.engine("podman", containers={"x": ["running", "x", "0f", config, None]})
    found = engine.container(str(desk.bin / "podman"), "x")
    assert found and (found.name, found.image_id, found.entrypoint) == ("x", "0f", tuple(ENTRYPOINT))
    assert attach.is_ours(found)


@pytest.mark.parametrize("engine", ["docker", "podman"])
def test_the_engine_on_this_machine_has_these_options(engine: str) -> None:
    """Where there is one; and an option that only a start takes is none of them."""
    assert not attach.PASSED & {"volume", "name", "rm"}
    if shutil.which(engine):
        told = subprocess.run([engine, "exec", "--help"], capture_output=True, text=True, check=True).stdout
        assert set(re.findall(r"--([a-z-]+)", told)) >= attach.PASSED and "--volume" not in told
