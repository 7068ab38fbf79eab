"""What an image promises at run time, with a real container engine: `docker run` as users type it."""

from __future__ import annotations

import os
import re
import subprocess
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest

from rosml.machine.services import Services
from tests.e2e import engine
from tests.e2e.calls import Run, wait_until
from tests.e2e.images import Publish
from tests.e2e.person import Person, enters, somebody, starts

TARGET = "ros1-bookworm-core"
WORKSPACE = "/docker-ros/ws"


def env(environment: Mapping[str, str]) -> tuple[str, ...]:
    """Options of `docker run`."""
    return tuple(item for name, value in environment.items() for item in ("--env", f"{name}={value}"))


@dataclass(frozen=True)
class Container:
    """The image in the engine."""

    docker: engine.Engine
    image: str

    def run(self, *command: str, options: tuple[str, ...] = (), **environment: str) -> Run:
        """`docker run IMAGE COMMAND`, with options and environment."""
        return self.docker.run(self.image, *command, options=(*options, *env(environment)))

    @contextmanager
    def started(self, *words: str) -> Iterator[str]:
        """A container in the background; gives its identity."""
        done = self.docker.docker("run", "--detach", "--network", "none", *words)
        assert done.code == 0, done.err
        try:
            yield done.out.strip()
        finally:
            self.docker.docker("rm", "--force", done.out.strip())

    def bash(self, script: str, options: tuple[str, ...] = (), **environment: str) -> str:
        """What a script says; it must not fail."""
        done = self.run("bash", "-euc", script, options=(*options, *env(environment)))
        assert done.code == 0, done.out + done.err
        return done.out.strip()


@pytest.fixture(scope="module")
def loaded(
    services: Services, published: Publish, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Callable[[str], Container]]:
    """Loads a published image into the engine, once."""
    done: dict[str, Container] = {}
    with engine.running() as docker:

        def load(target: str) -> Container:
            if target not in done:
                image = published(target)
                folder = tmp_path_factory.mktemp("load")
                done[target] = Container(docker, docker.image(services, image.reference, target, folder))
            return done[target]

        yield load


@pytest.fixture(scope="module")
def container(loaded: Callable[[str], Container]) -> Container:
    return loaded(TARGET)


def mount(source: Path, target: str) -> tuple[str, str]:
    source.chmod(0o755)  # pytest's own are nobody else's
    return "--volume", f"{source}:{target}"


# ---- The command -----------------------------------------------------------------------------------------------------


USER = {"DOCKER_UID": "1000", "DOCKER_GID": "1001"}

ROOT_AND_USER = pytest.mark.parametrize("environment", [{}, USER], ids=["root", "user"])


@pytest.mark.parametrize("options", [(), env(USER), ("--read-only", *env(USER))], ids=["root", "user", "read-only"])
def test_exit_codes_and_arguments_pass_through(container: Container, options: tuple[str, ...]) -> None:
    assert container.run("bash", "-c", "exit 37", options=options).code == 37
    done = container.run("printf", "<%s>", "a b", "", 'c"d', "e'f", "$HOME", "*", "-n", options=options)
    assert done.out == "<a b><><c\"d><e'f><$HOME><*><-n>"
    assert container.run("no-such-command", options=options).code == 127
    assert container.run("/etc/passwd", options=options).code == 126
    for command in (("--help",), ("-c", "env"), ("-l", "bash"), ("A=1", "id")):  # no options of ours, nor of exec
        done = container.run(*command, options=options)
        assert (done.code, done.out) == (127, ""), done
    done = container.run("rospack list", options=options)
    assert done.code == 127 and "leave out the quotes" in done.err


@ROOT_AND_USER
def test_standard_streams(container: Container, tmp_path: Path, environment: dict[str, str]) -> None:
    """They can be opened by their names, and what a setup file reads is not the command's."""
    done = container.run("bash", "-c", "echo out >/dev/stdout; echo err >/dev/stderr", options=env(environment))
    assert (done.code, done.out, done.err) == (0, "out\n", "err\n")
    (tmp_path / "setup.bash").write_text("read -r line || true\n")
    options = ("run", "--rm", "--interactive", "--network", "none", *mount(tmp_path, f"{WORKSPACE}/install"))
    command = ["docker", *options, *env(environment), container.image, "cat"]
    variables, lines = container.docker.variables(), "first\nsecond\n"
    assert subprocess.run(command, env=variables, input=lines, capture_output=True, text=True).stdout == lines


@ROOT_AND_USER
def test_signals_reach_the_process(container: Container, environment: dict[str, str]) -> None:
    """`docker stop` ends what waits for SIGTERM at once and with its own exit code, and an orphan is reaped by tini."""
    script = "trap 'echo ended; exit 9' TERM; echo ready; while :; do sleep 0.1; done"
    docker = container.docker.docker
    with container.started(*env(environment), container.image, "bash", "-c", script) as identity:
        wait_until(lambda: "ready" in docker("logs", identity).out, 30, lambda: docker("logs", identity))
        assert docker("stop", "--time", "20", identity).code == 0
        assert "ended" in docker("logs", identity).out
        assert docker("inspect", "--format", "{{.State.ExitCode}}", identity).out.strip() == "9"
        # The same container once more: its user exists already.
        assert docker("start", identity).code == 0
        assert docker("stop", "--time", "20", identity).code == 0
        assert "entrypoint:" not in docker("logs", identity).err


@pytest.mark.parametrize(
    "options", [(), ("--tty", *env({"DOCKER_UID": "70000", "DOCKER_GID": "70000"}))], ids=["root", "user"]
)
def test_a_stop_reaches_what_is_behind_a_shell(container: Container, options: tuple[str, ...]) -> None:
    """`docker stop` waits for a node in a pipe and for one behind `&`, and a shell with a terminal ends at once."""
    node = "import signal, time; signal.signal(15, lambda *_: (time.sleep(1), print('saved'), exit()))\nwhile True: time.sleep(1)"
    script = f'python3 -c "{node}" | cat & python3 -c "{node}"; echo further'
    docker = container.docker.docker
    for command, lines in ((("bash", "-c", script), ["saved", "saved"]), (("bash",), [])):
        if not lines and not options:
            continue  # a shell without a terminal reads nothing, and ends by itself
        words = (*(() if lines else ("--interactive",)), *options, "--env", "ROSML_BANNER=off")
        with container.started(*words, container.image, *command) as identity:
            time.sleep(5)
            begin = time.monotonic()
            assert docker("stop", "--time", "30", identity).code == 0
            assert time.monotonic() - begin < 20
            logged = docker("logs", identity)
            assert not lines or (logged.out.split(), logged.err) == (lines, ""), logged


# ---- The user --------------------------------------------------------------------------------------------------------

WHO = 'echo "$(id -u):$(id -g) $(id -un) $(id -Gn) home=$HOME ws=$(readlink ~/ws) pwd=$PWD"; touch ~/mine "$WORKSPACE/mine"'


@pytest.mark.parametrize(
    ("uid", "gid", "expected"),
    [
        ("", "", "0:0 root root home=/root"),
        ("00", "1000", "0:0 root root home=/root"),
        ("1", "1000", r"1:1000 daemon dockeruser sudo video home=/home/daemon"),  # whose home is /usr/sbin
        ("1000", "1000", r"1000:1000 dockeruser dockeruser sudo video home=/home/dockeruser"),
        ("1234", "2345", r"1234:2345 dockeruser dockeruser sudo video home=/home/dockeruser"),
        ("01000", "1000", r"1000:1000 dockeruser dockeruser sudo video home=/home/dockeruser"),
        ("1000", "44", r"1000:44 dockeruser video sudo home=/home/dockeruser"),  # a gid that is taken
        ("1000", "0", r"1000:0 dockeruser root sudo video home=/home/dockeruser"),
        ("33", "1000", r"33:1000 www-data dockeruser .*sudo.*video.* home=/\S+"),  # a uid that is taken
        ("65534", "65534", r"65534:65534 nobody nogroup sudo video home=/home/nobody"),  # and has no home
        ("4294967294", "4294967294", r"4294967294:4294967294 dockeruser .* home=/home/dockeruser"),
    ],
)
def test_becomes_the_user(container: Container, uid: str, gid: str, expected: str) -> None:
    words = container.bash(WHO, DOCKER_UID=uid, DOCKER_GID=gid)
    link = "" if expected.startswith("0:0") else WORKSPACE
    assert re.fullmatch(rf"{expected} ws={link} pwd={WORKSPACE}", words), words


def test_groups_that_were_added_stay(container: Container) -> None:
    """For serial ports and GPUs."""
    for options in ((), ("--read-only",)):
        done = container.run("id", "-G", options=(*options, "--group-add", "dialout", "--group-add", "992", *env(USER)))
        assert {"20", "992", "1001"} <= set(done.out.split()) and "0" not in done.out.split(), done


def test_setup_files_are_read_as_the_user(container: Container, tmp_path: Path) -> None:
    """Nothing of a workspace runs as root on the way, and what it says about users changes nothing."""
    (tmp_path / "setup.bash").write_text(
        'export WHO="$(id -u) $HOME"; unset DOCKER_UID DOCKER_GID; export DOCKER_UID=0; readonly uid=0 user=root home=/\n'
    )
    options = (*mount(tmp_path, f"{WORKSPACE}/install"), *env(USER))
    done = container.run("bash", "-c", 'echo "$WHO $(id -u)"', options=options)
    assert (done.code, done.out, done.err) == (0, "1000 /home/dockeruser 1000\n", "")


def test_another_name(container: Container) -> None:
    assert container.bash("id -un; echo $HOME", options=env(USER | {"DOCKER_USER": "ada"})) == "ada\n/home/ada"
    # The group's name is taken: it gets another one.
    assert container.bash("id -un; id -gn", options=env(USER | {"DOCKER_USER": "nogroup"})) == "nogroup\nnogroup-1001"


@pytest.mark.parametrize(
    ("environment", "words"),
    [
        ({"DOCKER_UID": "abc", "DOCKER_GID": "1"}, "take numbers, not 'abc' and '1'"),
        ({"DOCKER_UID": "-1", "DOCKER_GID": "1"}, "take numbers"),
        ({"DOCKER_UID": "1000", "DOCKER_GID": "1 0"}, "take numbers"),
        ({"DOCKER_UID": "4294967295", "DOCKER_GID": "1"}, "take numbers"),
        ({"DOCKER_UID": "18446744073709551616", "DOCKER_GID": "1"}, "take numbers"),
        ({"DOCKER_USER": "games"}, "the user name games is taken"),
        *(
            ({"DOCKER_USER": name}, "DOCKER_USER is no user name")
            for name in ("a:b", "1234", "../../etc", "..", "-r", "--help", "a b", "*", "x" * 33)
        ),
    ],
)
def test_a_user_that_cannot_be_is_no_reason_to_start_as_another(
    container: Container, environment: dict[str, str], words: str
) -> None:
    done = container.run("echo", "started", options=env(USER | environment))
    assert (done.code, done.out) == (64, "") and words in done.err, done


def test_without_the_capabilities_nobody_is_made(container: Container) -> None:
    for dropped in ("ALL", "DAC_OVERRIDE", "SETUID"):
        done = container.run("true", options=("--cap-drop", dropped, *env(USER)))
        assert done.code == 71, done
        assert "SETGID and SETUID nobody can become another user; add these capabilities" in done.err


def test_one_of_both_is_told_and_changes_nothing(container: Container) -> None:
    done = container.run("id", "-u", DOCKER_UID="1000")
    assert (done.code, done.out) == (0, "0\n")
    assert "only work together; running as root" in done.err


def test_sudo_without_a_password_and_no_password_at_all(container: Container) -> None:
    identity, *shadow = container.bash("sudo -n id -u; sudo -n cat /etc/shadow", options=env(USER)).splitlines()
    assert identity == "0"
    fields = [line.split(":")[1] for line in shadow]
    assert len(fields) > 10 and set(fields) <= {"*", "!", "!*", "!!"}


@ROOT_AND_USER
def test_an_arbitrary_user(container: Container, environment: dict[str, str]) -> None:
    """`--user 12345:0`, as OpenShift does: a home that can be written, the workspace too, and ROS runs."""
    script = f"{WHO.replace('$(id -un) ', '')} 2>&1; roscore --help >/dev/null; timeout 3 roscore >/dev/null 2>&1 || [[ $? == 124 ]]"
    script += "; python3 -c 'import getpass; print(getpass.getuser())'"
    words = container.bash(script, options=("--user", "12345:0"), **environment)
    assert words.startswith("12345:0 root home=/tmp ws= pwd=") and words.endswith("\ndockeruser")


@ROOT_AND_USER
def test_a_read_only_root(container: Container, environment: dict[str, str]) -> None:
    options = ("--read-only", "--tmpfs", "/tmp", "--tmpfs", "/root")
    script = 'echo "$(id -u):$(id -g) home=$HOME"; touch ~/mine; timeout 3 roscore >/tmp/log 2>&1 || [[ $? == 124 ]] || { cat /tmp/log; false; }'
    who = container.bash(script, options=options, **environment)
    assert who == ("1000:1001 home=/tmp" if environment else "0:0 home=/root")


# ---- The workspace ---------------------------------------------------------------------------------------------------


def owners(folder: Path) -> set[tuple[int, int]]:
    return {(path.stat().st_uid, path.stat().st_gid) for path in (folder, *folder.rglob("*"))}


@pytest.fixture
def sources(tmp_path: Path) -> Path:
    """A folder of a user's, with something of root's in it."""
    package = tmp_path / "sources" / "package"
    package.mkdir(parents=True)
    (package / "package.xml").write_text("<package/>")
    os.chown(package.parent, 4321, 5432)
    tmp_path.chmod(0o755)
    for folder in tmp_path.parents:
        if folder.name.startswith("pytest-"):
            folder.chmod(0o755)
    return package.parent


@pytest.mark.parametrize("where", [f"{WORKSPACE}/src", f"{WORKSPACE}/src/mine", WORKSPACE])
def test_mounted_sources_keep_their_owner(container: Container, sources: Path, where: str) -> None:
    before = owners(sources)
    assert len(before) == 2
    script = f"test -e {where}/package/package.xml; test ~/ws -ef {WORKSPACE}; stat --format %u:%g {WORKSPACE}"
    owner = container.bash(script, options=mount(sources, where), **USER)
    assert owners(sources) == before
    # The workspace around them is the image's own: the user can build in it.
    assert owner == ("4321:5432" if where == WORKSPACE else "1000:1001")


@pytest.mark.parametrize(
    ("where", "workspace"),
    [
        ("/docker-ros", WORKSPACE),
        ("/work", "/work/ws"),
        (WORKSPACE, f"{WORKSPACE}/"),
        (WORKSPACE, "."),
        ("/work/ros ws", "/work/ros ws"),
        (r"/wo\040rk", r"/wo\040rk"),
        (f"{WORKSPACE}/src/a*b[x]?", WORKSPACE),
        ("/etc/mine", "/etc"),
    ],
)
def test_mounts_keep_their_owner_however_the_workspace_is_spelt(
    container: Container, sources: Path, where: str, workspace: str
) -> None:
    (sources / "ws").mkdir()
    before = owners(sources)
    options = ("--mount", f"type=bind,source={sources},target={where}", *env({**USER, "WORKSPACE": workspace}))
    done = container.run("id", "-u", options=options)
    assert (done.code, done.out, done.err) == (0, "1000\n", "")
    assert owners(sources) == before


def test_a_workspace_behind_a_link_becomes_the_users(container: Container, sources: Path) -> None:
    script = "mkdir -p /data/ws/src && touch /data/ws/roots && ln -s /data/ws /link"
    inside = f"{script} && WORKSPACE=/link/ DOCKER_UID=1000 DOCKER_GID=1001 /entrypoint.sh bash -c 'touch /link/mine ~/ws/too'"
    before = owners(sources)
    container.bash(f"{inside}; stat --format %u /data/ws/roots", options=mount(sources, "/data/ws/src"))
    assert owners(sources) == before


@pytest.mark.parametrize("user", ["dockeruser", "robot"])
def test_a_home_with_something_mounted_in_it_becomes_the_users(container: Container, sources: Path, user: str) -> None:
    """The engine makes the folders on the way, for root: of a new user, and of one who has no home yet."""
    before = owners(sources)
    uid = "DOCKER_UID=1000 DOCKER_GID=1001 /entrypoint.sh"
    inside = "[[ $HOME == ~+ && -O ~ && -O ~/.config && -O ~/.bashrc && ~/ws -ef /docker-ros/ws ]]; id -un"
    taken = "useradd --no-create-home --uid 1000 robot; " if user == "robot" else ""
    script = f"{taken}{uid} bash -c 'cd; touch new; {inside}'"
    done = container.run("bash", "-euc", script, options=mount(sources, f"/home/{user}/.config/mine"))
    assert (done.code, done.out, done.err) == (0, f"{user}\n", "")
    assert owners(sources) == before
    container.bash("test ! -L ~/ws", options=mount(sources, f"/home/{user}"), DOCKER_USER=user, **USER)
    assert {path.name for path in sources.iterdir()} == {"package"}, "nothing is left in a home of this machine"


def test_homes_and_workspaces_in_odd_places(container: Container) -> None:
    """A workspace whose name begins like a folder of the system; one that is the home; a home behind a link; a home that is a
    link to a folder of the system, which stays root's; a ~/ws that leads nowhere."""
    user = "DOCKER_UID=1000 DOCKER_GID=1001 /entrypoint.sh bash -euc"
    for script in (
        f"mkdir /dev_ws; WORKSPACE=/dev_ws {user} 'touch /dev_ws/mine; test ~/ws -ef /dev_ws'",
        f"mkdir -p /home/dockeruser; WORKSPACE=/home/dockeruser {user} 'touch ~/mine; test ! -e ~/ws'",
        f"mkdir -p /srv/homes; rmdir /home; ln -s srv/homes /home; {user} 'cd; test -O .bashrc; touch mine'",
        f"mkdir -p /srv/mine; ln -s /srv/mine /home/dockeruser; {user} 'cd; test -O .bashrc; touch mine'",
        f"ln -s /etc /home/dockeruser; {user} 'cd; touch mine; test $HOME = /tmp; test ! -O /etc; test ! -e /etc/.bashrc'",
        f"mkdir /home/dockeruser; ln -s /nowhere /home/dockeruser/ws; {user} 'cd; touch mine'",
        f"{user} 'rm -rf /docker-ros/ws/src; test -L ~/ws'; {user} 'cd; touch mine'",
    ):
        done = container.run("bash", "-euc", script)
        assert (done.code, done.out, done.err) == (0, "", ""), (script, done)


def test_files_that_come_and_go_keep_nobody_out(container: Container) -> None:
    """`docker exec CONTAINER /entrypoint.sh …`, while something works in the workspace."""
    busy = "while :; do mkdir -p a/b; touch a/b/{1..200}; rm -rf a; done"
    user = "DOCKER_UID=1000 DOCKER_GID=1001 /entrypoint.sh"
    script = (
        f"bash -c '{busy}' & {user} bash -c '{busy.replace('a', 'b')}' & sleep 0.5; "
        f"for _ in {{1..30}}; do {user} true || exit; done; kill %1 %2; echo well"
    )
    done = container.run("bash", "-c", script)
    assert (done.code, done.out) == (0, "well\n"), done


def test_starts_at_once_make_one_user(container: Container) -> None:
    """As tests of an image do, and whoever opens several shells in a container."""
    start = "DOCKER_UID=1234 DOCKER_GID=2345 /entrypoint.sh id --user"
    started = container.bash(f"for _ in {{1..24}}; do {start} & done; wait", DOCKER_USER="many")
    assert started.split() == ["1234"] * 24


def test_overlays_are_sourced_in_order(container: Container, tmp_path: Path) -> None:
    options: list[str] = []
    for number, where in enumerate(("/opt/ws_base_image/install", f"{WORKSPACE}/devel", f"{WORKSPACE}/install")):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / "setup.bash").write_text(f'export ORDER="$ORDER {where}"\n')
        options += mount(folder, where)
    expected = f"/opt/ws_base_image/install {WORKSPACE}/devel {WORKSPACE}/install"
    assert container.bash("echo $ORDER", options=tuple(options)) == expected
    # As a user, and in a shell that came past the entrypoint, as with docker exec.
    assert container.bash("echo $ORDER", options=tuple(options), **USER) == expected
    for user, shell in (("root", "-ic"), ("12345", "-lc"), ("12345", "-ilc")):
        words = ("--entrypoint", "bash", "--user", user, *options)
        assert f"order: {expected}\n" in container.run(shell, "echo order: $ORDER", options=words).out, (user, shell)


@pytest.mark.parametrize(
    "text",
    [
        "trap '' TERM INT; set -aTE; cd /; exec() { :; }; shopt -s expand_aliases; alias exec=false",
        "set -- changed",
        "set -euf; shopt -s nullglob; IFS=x; false || true",
        "command=x; user=x; home=x",
    ],
)
def test_what_an_overlay_does_to_the_shell_is_not_done_to_the_command(
    container: Container, tmp_path: Path, text: str
) -> None:
    (tmp_path / "setup.bash").write_text(text + "\n")
    options = mount(tmp_path, f"{WORKSPACE}/install")
    for environment in ({}, USER):
        done = container.run("printf", "<%s>", "a xb", "*", options=(*options, *env(environment)))
        assert (done.code, done.out, done.err) == (0, "<a xb><*>", "")


@pytest.mark.parametrize("text", ["exit 0", "set -e; false", "exit 3"])
def test_an_overlay_that_ends_the_shell_is_told(container: Container, tmp_path: Path, text: str) -> None:
    """An exit status of 0 would pass for a command that ran."""
    (tmp_path / "setup.bash").write_text(text + "\n")
    done = container.run("echo", "started", options=mount(tmp_path, f"{WORKSPACE}/install"))
    assert (done.code, done.out) == (70, "")
    assert f"entrypoint: {WORKSPACE}/install/setup.bash ended the shell" in done.err


# ---- Interactive shells ----------------------------------------------------------------------------------------------

INTERACTIVE = ("run", "--rm", "--interactive", "--tty", "--network", "none")

BANNER = re.compile(
    r"ROS +Debian \(ROS 1\)\n +OS +Debian GNU/Linux 12 \(bookworm\), \w+\n +Python +3\.11\.\d+\n +CMake +3"
)


def test_a_banner_in_interactive_shells_alone(container: Container) -> None:
    docker, image = container.docker, container.image
    shells = docker.talk((*INTERACTIVE, image), "bash -i\nexit\nexit\n")
    assert len(BANNER.findall(shells)) == 1, f"once, and not in the shell within the shell:\n{shells}"
    assert re.search(r"GPUs +none", shells)
    assert BANNER.search(docker.talk((*INTERACTIVE, *env(USER), image), "exit\n"))
    assert not BANNER.search(docker.talk((*INTERACTIVE, "--env", "ROSML_BANNER=off", image), "exit\n"))
    assert not BANNER.search(docker.talk((*INTERACTIVE, image, "bash", "-c", "true")))
    assert container.run("bash", "-c", "true").out == ""


def test_an_interactive_shell_leaves_no_trace_in_the_environment(container: Container, tmp_path: Path) -> None:
    """Neither a variable nor a function that the image's users could stumble over, but for rosbash's own."""
    (tmp_path / "names").write_text("compgen -v; declare -F | cut -d ' ' -f 3\n")
    shell = ("--env", "BASH_ENV=", *mount(tmp_path, "/names"))
    rosbash = "source /usr/share/bash-completion/completions/rosbash"
    plain, ours = (
        set(container.docker.run(container.image, "bash", *options, command, options=shell).out.split())
        for options, command in (
            (("--norc", "-ic"), f"{rosbash}; source /names/names"),
            (("-ic",), "source /names/names"),
        )
    )
    assert {"PATH", "roscd"} <= plain
    added = ours - plain - {"_rosml_complete", "_rosml_shell", "PIPESTATUS"}
    assert not added, added


def test_commands_of_ros_are_completed(container: Container) -> None:
    """What completes them is loaded on the first TAB; functions such as roscd are there."""
    words = (*INTERACTIVE, "--env", "ROSML_BANNER=off", container.image)
    assert "usage: vcs import" in container.docker.talk(words, "vcs imp\t--help\nexit\n")
    assert container.run("bash", "-ic", "type -t roscd").out == "function\n"


@pytest.mark.parametrize(
    ("environment", "command", "most"),
    [
        ({}, ("sh", "-c"), 30),
        (USER, ("sh", "-c"), 60),
        ({}, ("bash", "-ic"), 60),
    ],
    ids=["root", "user", "interactive shell"],
)
def test_a_start_takes_few_processes(
    container: Container, environment: dict[str, str], command: tuple[str, ...], most: int
) -> None:
    """A container counts its processes from 1: the number of the last one says how many there were before it."""
    done = container.run(*command, "sh -c 'echo number $$'", options=env(environment))
    number = int(done.out.split("number ")[1])
    assert number <= most, number


# ---- Other images: the same contract on frameworks, and on a ROS that has something to source ---------------------------

OTHERS = {
    "ros1-bookworm-core-tensorflow-cpu": "import tensorflow as tf, rospy; assert tf.reduce_sum(tf.ones(3)).numpy() == 3",
    "jazzy-wheels-core": "import rclpy; rclpy.init(); print(rclpy.create_node('node')); rclpy.shutdown()",
}

STARTED_BY = {
    "root": ((), "0:0 /root"),
    "DOCKER_UID": (env(USER), "1000:1001 /home/dockeruser"),
    "an arbitrary user": (("--user", "12345:0"), "12345:0 /tmp"),
    "read-only": (("--read-only", "--tmpfs", "/tmp", *env(USER)), "1000:1001 /tmp"),
}


@pytest.fixture(
    scope="module",
    params=[
        pytest.param("ros1-bookworm-core-tensorflow-cpu", marks=pytest.mark.full(proof="contract")),
        pytest.param("jazzy-wheels-core", marks=pytest.mark.full(proof="wheels")),
    ],
)
def other(request: pytest.FixtureRequest, loaded: Callable[[str], Container]) -> tuple[str, Container]:
    return request.param, loaded(request.param)


@pytest.mark.parametrize("who", STARTED_BY)
def test_other_images_work_whoever_starts_them(other: tuple[str, Container], who: str) -> None:
    target, container = other
    options, expected = STARTED_BY[who]
    script = f'python3 -c "$PROGRAM" >/dev/null; echo "$(id -u):$(id -g) $HOME"; touch {"/tmp" if who == "read-only" else "~"}/mine'
    assert container.bash(script, options=options, PROGRAM=OTHERS[target], TF_CPP_MIN_LOG_LEVEL="3") == expected


# ---- rosml run -------------------------------------------------------------------------------------------------------


@pytest.fixture
def person(container: Container) -> Iterator[Person]:
    with somebody(container.docker) as person:
        yield person


def test_rosml_run_starts_an_image_as_the_person(container: Container, person: Person) -> None:
    starts(person, container.image, "docker")


def test_a_strangers_image_is_not_root(
    container: Container, person: Person, services: Services, published: Publish, tmp_path: Path
) -> None:
    """It says that it makes users, and has a program of root's with the setuid bit."""
    setuid = "install -m 4755 /bin/bash /usr/bin/evil"
    image = container.docker.image(services, published(TARGET).reference, f"{TARGET}-evil", tmp_path, setuid)
    words = ("--volume", ".:/mine", image, "evil", "-pc", "id -u; echo x >/mine/left")
    done = person.rosml("run", "--network", "none", *words)
    assert (done.code, done.out) == (0, f"{person.uid}\n"), done
    assert (person.folder / "left").stat().st_uid == person.uid
    assert ("--trust" in done.err) == (person.uid != 0)
    other = person.rosml("run", "--network", "none", "--security-opt", "no-new-privileges=false", *words)
    assert other.out == "0\n", "without that option, the program is root"


def test_rosml_attach_enters_the_container_of_the_folder(container: Container, person: Person) -> None:
    enters(person, container.image, "docker")


OLD = "no Docker before 23 is here"


def test_a_docker_that_reads_no_zstd_is_said_to_be_old(published: Publish) -> None:
    if not engine.folder_of_daemon(debian=True):
        pytest.skip(OLD)
    with engine.running(debian=True) as docker:
        if docker.reads_zstd:
            pytest.skip(OLD)
        with somebody(docker) as person:
            done = person.run(published(TARGET).reference, "true")
            assert done.code == 125 and "cannot read layers with zstd" in done.err and "update Docker" in done.err, done
            done = person.rosml("doctor")
            assert done.code == 1 and re.search(r"engine .*docker before version 23", done.out), done
