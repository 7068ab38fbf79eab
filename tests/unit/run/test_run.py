"""`rosml run`: what docker and podman get, who runs in the container, and what is said where that cannot be. The engines are
local replacements, which write down how they are called."""

from __future__ import annotations

import json
import os
import shlex
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import click
import pytest
from conftest import ROOT

from fakes.desks import BARE, DOCKER, LOCKED, OTHER, OURS, PODMAN, ROOTLESS, UID, Desk, labelled, plain
from rosml.base.errors import RosmlError
from rosml.cli.run import run
from rosml.run import engine, person
from rosml.run.context import Context, Engine, Image, Person
from rosml.run.paths import bind, resolved
from rosml.run.plan import make_plan
from rosml.run.plugins import basic_options
from rosml.run.plugins.user import NAME
from rosml.run.words import split


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    """A desk with docker, which has the images `ubuntu` and `ours`; the latter is trusted."""
    made = Desk(tmp_path)
    made.engine()
    made.trust(ours=True)
    return made


# ---- What a command is made of: cases that go wrong elsewhere --------------------------------------------------------


@pytest.mark.parametrize(
    "words",
    [
        ["ubuntu", "bash", "-c", 'echo "a  b" $HOME; ls'],
        ["-e", "A=b c", "ubuntu"],
        ["ubuntu", "mycmd", "--name", "x", "--image", "y"],
        ["ubuntu", "ls", "--verbose", "--help"],
        ["ubuntu", "printf", "", "%s", ""],
        ["ubuntu", "ls", "*", "?", "[a-z]"],
        ["ubuntu", "echo", "a\\b", "\\", "\n", "`id`", "$(id)"],
        ["-it", "-v", "/a b:/c d", "ubuntu", "env", "--dry-run", "--rm", "--json"],
    ],
)
def test_words_arrive_as_they_are(desk: Desk, words: list[str]) -> None:
    done = desk.call("--no-tz", *words)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert desk.ran == [*plain(desk), *words]


def test_bytes_that_are_no_text_arrive_as_they_are(desk: Desk) -> None:
    """A file's name may be any bytes."""
    subprocess.run(
        [*desk.argv("--no-tz", "ubuntu", "ls"), b"\xff\xfe"], cwd=desk.folder, env=desk.environment, check=True
    )
    assert os.fsencode(desk.ran[-1]) == b"\xff\xfe"


@pytest.mark.parametrize("written", [["--volume=./a:/a"], ["-v", "./a:/a"], ["-v./a:/a"], ["--volume", "./a:/a"]])
def test_a_relative_folder_is_mounted(desk: Desk, written: list[str]) -> None:
    assert desk.call("--no-tz", *written, "ubuntu", "./a:/a").returncode == 0
    whole = [word.replace("./a", f"{desk.folder}/a") for word in written]
    assert desk.ran == [*plain(desk), *whole, "ubuntu", "./a:/a"]


def test_a_folder_that_is_missing_is_made(desk: Desk) -> None:
    """docker would make it for root, and nobody else could write there. A volume and a file stay what they are."""
    (desk.root / "file").touch()
    words = [
        "-v",
        "./bags/new:/bags",
        "-v",
        "name:/data",
        "-v/file:/file",
        "-v",
        "/anonymous",
        "--mount=type=bind,src=a,dst=/a",
    ]
    desk.call("--dry-run", *words, "ubuntu")
    assert [path.name for path in desk.root.iterdir()] == ["file"]
    assert desk.call(*words, "ubuntu").returncode == 0
    made = desk.root / str(desk.folder).lstrip("/") / "bags/new"
    assert made.is_dir() and made.stat().st_uid == os.geteuid()
    assert {path.name for path in desk.root.iterdir()} == {"file", made.relative_to(desk.root).parts[0]}
    assert (desk.root / "file").is_file()


def test_a_folder_with_spaces_is_mounted_into_the_workspace(desk: Desk) -> None:
    desk.folder = desk.folder / "my, 2nd: folder"
    desk.folder.mkdir()
    assert desk.call("--mws", "ours", "colcon", "build").returncode == 0
    assert f'type=bind,"source={desk.folder}",target=/docker-ros/ws/src/target' in desk.ran


def test_a_running_container_of_the_folders_name_is_left_alone(desk: Desk) -> None:
    """Nothing is started in it: the image that was asked for runs, or a message says why not."""
    desk.engine(containers={"dr": ["running", "/dr"]})
    assert desk.call("--no-tz", "ubuntu", "ls").returncode == 0
    assert desk.ran == [*plain(desk), "ubuntu", "ls"]
    code, told = desk.on_a_terminal("ubuntu", "ls")
    assert code == 125 and b"a container named dr runs, and rosml run did not start it" in told
    assert b"rosml attach dr enters it; --new starts another container" in told
    assert len([call for call in desk.calls if call[1] not in ("info", "image", "container")]) == 1
    assert desk.on_a_terminal("--new", "ubuntu", "ls")[0] == 0 and "--name" not in desk.calls[-1]


def test_without_a_terminal_none_is_asked_for(desk: Desk) -> None:
    assert desk.call("ubuntu").returncode == 0
    assert not {"-t", "--tty", "-i", "-it", "--name"} & set(desk.ran)


def test_there_is_no_engine(desk: Desk) -> None:
    (desk.bin / "docker").unlink()
    done = desk.call("ubuntu", "ls")
    assert (done.returncode, done.stdout) == (125, "")
    assert (
        done.stderr.startswith("error: neither docker nor podman is installed") and "\nremedy: install" in done.stderr
    )


# ---- The terminal ----------------------------------------------------------------------------------------------------


def test_on_a_terminal(desk: Desk) -> None:
    code, told = desk.on_a_terminal("--no-tz", "ours")
    assert (code, told) == (0, b"")
    assert desk.ran[:7] == ["docker", "run", "--rm", "-i", "-t", "--name", "dr"]


@pytest.mark.parametrize(
    ("words", "expected"),
    [(["--no-it"], []), (["-it"], []), (["-i"], ["-t"]), (["--tty"], ["-i"]), (["--tty=false"], ["-i"])],
)
def test_what_somebody_says_of_the_terminal(desk: Desk, words: list[str], expected: list[str]) -> None:
    assert desk.on_a_terminal("--no-tz", "--no-user", "--no-name", *words, "ubuntu")[0] == 0
    given = [word for word in words if word != "--no-it"]
    assert desk.ran == ["docker", "run", "--rm", *expected, *labelled(desk), *given, "ubuntu"]


def test_output_into_a_pipe(desk: Desk) -> None:
    """Keyboard, but no terminal: it would write line ends of its own, and the container's errors among the output."""
    reader, writer = os.pipe()
    assert desk.on_a_terminal("ubuntu", output=writer)[0] == 0
    os.close(writer)
    os.close(reader)
    assert "-i" in desk.ran and "-t" not in desk.ran and "--name" not in desk.ran


def test_input_from_a_pipe(desk: Desk) -> None:
    done = subprocess.run(
        desk.argv("ubuntu", "read"),
        cwd=desk.folder,
        env=desk.environment,
        input=b"a\nb",
        capture_output=True,
        check=True,
    )
    assert done.stdout == b"A\nB" and "-i" in desk.ran


def test_input_from_nowhere(desk: Desk, tmp_path: Path) -> None:
    assert person.reads(os.open(os.devnull, os.O_RDONLY)) is False
    assert person.reads(os.open(tmp_path, os.O_RDONLY)) is True
    closed = subprocess.run(
        ["/bin/sh", "-c", 'exec "$@" <&-', "sh", *desk.argv("ubuntu")], env=desk.environment, cwd=desk.folder
    )
    assert closed.returncode == 0 and "-i" not in desk.ran


# ---- How it ends -----------------------------------------------------------------------------------------------------


def test_the_exit_code_is_the_commands(desk: Desk) -> None:
    desk.engine(code=42)
    assert desk.call("ubuntu", "false").returncode == 42


def test_signals_reach_the_engine(desk: Desk) -> None:
    with subprocess.Popen(
        desk.argv("ubuntu", "wait"), cwd=desk.folder, env=desk.environment, stdout=subprocess.PIPE
    ) as process:
        assert process.stdout and process.stdout.readline() == b"waiting\n"
        process.send_signal(signal.SIGTERM)
        assert process.wait(10) == 7


def test_no_signal_is_ignored_that_was_not_before(desk: Desk) -> None:
    """Python ignores SIGPIPE and SIGXFSZ, which a program that it becomes would go on to do."""
    (desk.bin / "docker").write_text(
        "#!/bin/sh\ncase $1 in run) exec /usr/bin/grep SigIgn /proc/self/status;; "
        'image) echo \'{"Id": "x", "Config": {}}\';; esac\n'
    )
    ignored = int(desk.call("ubuntu").stdout.split()[1], 16)
    assert not ignored & (1 << signal.SIGPIPE - 1 | 1 << signal.SIGXFSZ - 1)


def test_what_would_run_is_shown(desk: Desk) -> None:
    shown = desk.call("--no-tz", "--dry-run", "--name", "x", "ubuntu", "echo", "a  b")
    as_json = desk.call("--no-tz", "--json", "--name", "x", "ubuntu", "echo", "a  b")
    assert {call[1] for call in desk.calls} == {"info", "image", "container"}
    wanted = [*plain(desk), "--name", "x", "ubuntu", "echo", "a  b"]
    assert shlex.split(shown.stdout) == json.loads(as_json.stdout) == wanted
    assert shown.stdout == f"{shlex.join(wanted)}\n" and shown.stderr == as_json.stderr == ""
    said = desk.call("--no-tz", "--verbose", "--name", "x", "ubuntu", "echo", "a  b")
    assert (said.stdout, said.stderr, desk.ran) == ("", shown.stdout, wanted)


@pytest.mark.parametrize("option", ["--dry-run", "--verbose"])
def test_bytes_that_are_no_text_are_shown_as_a_shell_reads_them(desk: Desk, option: str) -> None:
    words = [b"\xffab'c\\d e\n", "ü".encode(), "ü".encode() + b"\xfe"]
    done = subprocess.run(
        [*desk.argv("--no-tz", option, "ubuntu", "ls"), *words],
        cwd=desk.folder,
        env=desk.environment,
        capture_output=True,
        check=True,
    )
    told = done.stdout + done.stderr
    assert b"$'\\xff" in told and "ü".encode() in told
    read = subprocess.run(["bash", "-c", b"printf '%s\\0' " + told], capture_output=True, check=True).stdout
    assert read.split(b"\0")[-4:-1] == words


# ---- The engine and the image ----------------------------------------------------------------------------------------


def test_podman_where_there_is_no_docker(desk: Desk) -> None:
    (desk.bin / "docker").rename(desk.bin / "podman")
    desk.engine("podman", info={"host": {"security": {"rootless": False}}})
    (desk.bin / "docker").unlink(missing_ok=True)
    assert desk.call("--no-tz", "ubuntu").returncode == 0
    assert desk.ran == ["podman", *plain(desk)[1:], "ubuntu"]


def test_an_engine_is_named(desk: Desk) -> None:
    desk.engine("podman", info=PODMAN)
    assert desk.call("ubuntu", ROSML_ENGINE=str(desk.bin / "podman")).returncode == 0
    assert desk.ran[0] == "podman"
    done = desk.call("ubuntu", ROSML_ENGINE="nerdctl")
    assert done.returncode == 125 and "no program 'nerdctl', which ROSML_ENGINE names" in done.stderr


def test_podman_by_the_name_of_docker(desk: Desk) -> None:
    """As Debian's package podman-docker has it."""
    desk.engine(info=PODMAN)
    assert desk.call("--no-tz", "ours").returncode == 0
    assert desk.ran[5:9] == PODMANS_ROOT


@pytest.mark.parametrize(
    ("complaint", "says", "remedy"),
    [
        (
            "Cannot connect to the Docker daemon at x",
            "docker does not answer: Cannot connect",
            "systemctl start docker",
        ),
        ("permission denied while trying to connect", "docker does not let you in: permission", "usermod -aG docker"),
    ],
)
def test_an_engine_that_does_not_answer(desk: Desk, complaint: str, says: str, remedy: str) -> None:
    desk.engine(info={"ServerVersion": "", "ServerErrors": [complaint]}, images={}, complaint=complaint)
    desk.engine("podman", info=PODMAN)
    done = desk.call("ubuntu")
    assert done.returncode == 125 and says in done.stderr and remedy in done.stderr
    assert "ROSML_ENGINE=podman" in done.stderr
    assert not [call for call in desk.calls if call[1] in ("pull", "run")]


def test_an_image_that_is_not_there_is_pulled_first(desk: Desk) -> None:
    """What it says of its user counts; progress is not among the command's output."""
    desk.engine(images={}, registry={"ours": OURS})
    done = desk.call("--platform=linux/arm64", "-q", "-qit", "-e", "A=b", "ours", "pwd")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "progress\n")
    assert ["docker", "pull", "--platform=linux/arm64", "-q", "ours"] in desk.calls
    assert f"DOCKER_UID={UID}" in desk.ran


@pytest.mark.parametrize(
    ("image", "words", "pulled"),
    [
        ("127.0.0.1:5000/me/ros:a", [], ["--tls-verify=false"]),
        ("localhost/me", [], ["--tls-verify=false"]),
        ("localhost:5000/me", ["--tls-verify"], ["--tls-verify"]),
        ("127.0.0.1.example.com/me", [], []),
        ("me/ros", [], []),
    ],
)
def test_podman_takes_a_registry_of_this_machine_without_tls(
    desk: Desk, image: str, words: list[str], pulled: list[str]
) -> None:
    desk.engine("podman", info=PODMAN, images={}, registry={image: OTHER})
    assert desk.call(*words, image, ROSML_ENGINE="podman").returncode == 0
    assert ["podman", "pull", *pulled, image] in desk.calls
    desk.engine(images={}, registry={image: OTHER})
    assert desk.call(*words, image).returncode == 0 and ["docker", "pull", *words, image] in desk.calls


def test_podman_is_told_of_a_registry_without_tls(desk: Desk) -> None:
    desk.engine("podman", info=PODMAN)
    said = desk.call("reg.local/me", ROSML_ENGINE="podman").stderr
    assert "if its registry has no TLS: rosml run --tls-verify=false reg.local/me" in said


def test_an_image_that_nobody_has(desk: Desk) -> None:
    done = desk.call("no/such:image")
    assert done.returncode == 125 and not [call for call in desk.calls if call[1] == "run"]
    assert "pull access denied\nerror: no image no/such:image here, and docker cannot pull it\nremedy: " in done.stderr
    assert "docker login" in done.stderr


@pytest.mark.parametrize(
    ("image", "remedy"),
    [
        ("jazzy-base", "if it is a target, `rosml image jazzy-base` builds it"),
        (
            "ros-torch:jazzy",
            "if it is one of rosml's, write its place as well, such as 127.0.0.1:40123/rosml/ros-torch:jazzy",
        ),
        ("ros2", "if it is the command, an image goes before it: rosml run IMAGE ros2"),
        ("ghcr.io/me/rosml/ros:jazzy-base", "ghcr.io/me is an example: write the place that has your images"),
        ("no/such:image", "check its name"),
        ("me/ros:core@sha256:1", "check its digest, or take its tag: me/ros:core"),
        ("IMAGE", "IMAGE stands for an image: write one that you have"),
        ("./my_package", "it is a path: rosml run -v FOLDER:/mnt IMAGE mounts it"),
    ],
)
def test_what_may_be_wrong_with_a_name(desk: Desk, image: str, remedy: str) -> None:
    assert f"remedy: {remedy}" in desk.call(image).stderr


@pytest.mark.parametrize("words", [["--dry-run"], ["--json"], ["--pull=never"], ["--pull", "never"]])
def test_where_nothing_is_pulled(desk: Desk, words: list[str]) -> None:
    desk.engine(images={}, registry={"ours": OURS})
    done = desk.call(*words, "ours")
    assert done.returncode == 125 and "error: no image ours here" in done.stderr
    assert "remedy: docker pull ours" in done.stderr
    assert not [call for call in desk.calls if call[1] in ("pull", "run")]


@pytest.mark.parametrize(
    ("state", "found", "refused", "remedy"),
    [
        ("running", "/x1", True, "rosml attach x1 enters it; another --name starts another container"),
        (
            "exited",
            "/x1",
            True,
            "rosml attach x1 starts it again, docker rm x1 removes it with all that was written in it",
        ),
        ("dead", "/x1", True, "remedy: docker rm x1"),
        ("running", "x1", True, "rosml attach x1"),  # podman writes no slash
        ("running", "/brave_bell", False, ""),  # its id begins with x1
    ],
)
def test_a_name_that_is_taken(desk: Desk, state: str, found: str, refused: bool, remedy: str) -> None:
    desk.engine(containers={"x1": [state, found]})
    done = desk.call("--name=x1", "ubuntu")
    assert done.returncode == (125 if refused else 0)
    assert ("a container named x1 " in done.stderr) == refused and remedy in done.stderr
    assert "/entrypoint.sh" not in done.stderr
    assert desk.call("--name=x1", "--replace", "ubuntu").returncode == 0, "podman replaces it"


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ([], "no container was started in this folder\nremedy: rosml run IMAGE starts one"),
        (["--new"], "--new needs an image, and none is named"),
        (["--brand-new", "ubuntu"], "remedy: --brand-new=VALUE"),
        (["--nvidia", "--x11", "ubuntu"], "remedy: leave it out: rosml run hands in your GPUs"),
        (["--no-rm=1", "ubuntu"], "'--no-rm' does not take a value"),
        (["--mws", "ubuntu"], "ubuntu has no workspace"),
        (["<registry>/ros:jazzy-base"], "remedy: write an image that you have"),
        (["--user", "--home", "ubuntu"], "remedy: leave --user out"),
        (["--user", "me/ros:jazzy-base", "bash"], "remedy: leave --user out"),
        (["--image", "ubuntu"], "remedy: write the image alone, after the options: rosml run IMAGE"),
        (["--cmd", "ls", "ubuntu"], "remedy: write the command after the image"),
        (["--name", "robot"], "to enter a container that is there: rosml attach robot"),
    ],
)
def test_a_call_that_is_wrong(desk: Desk, words: list[str], says: str) -> None:
    done = desk.call(*words)
    assert (done.returncode, says in done.stderr) == (125, True), done.stderr
    assert not [call for call in desk.calls if call[1] == "run"]


def test_help_is_what_h_alone_asks_for(desk: Desk) -> None:
    assert desk.call("-h").stdout.startswith("Usage: ")
    desk.call("-h", "robot", "ubuntu")
    assert [word for word in desk.calls[-1] if word in ("-h", "robot")] == ["-h", "robot"]


@pytest.mark.parametrize(
    ("word", "told"), [("--gpus", True), ("--mws", True), ("-it", True), ("--version", False), ("-la", False)]
)
def test_an_option_after_the_image(desk: Desk, word: str, told: bool) -> None:
    """It reaches the container as it is; whoever meant the engine's own is told."""
    done = desk.call("ubuntu", word)
    assert desk.calls[-1][-1] == word
    assert (f"options come first: rosml run {word} … ubuntu" in done.stderr) == told


@pytest.mark.parametrize(
    "words", [["--network", "host"], ["-v", "host"], ["-itv", "host"], ["-e", "host"], ["-u", "host"]]
)
def test_an_option_that_took_the_image(desk: Desk, words: list[str]) -> None:
    done = desk.call(*words)
    assert done.returncode == 125, done.stderr
    assert f"'host' is the value of {words[0]}" in done.stderr and "rosml run … IMAGE" in done.stderr


def test_a_folder_with_a_colon_goes_with_no_volume(desk: Desk) -> None:
    desk.folder = desk.folder / "a:b, c"
    desk.folder.mkdir()
    done = desk.call("-v", ".:/x:ro", "ubuntu")
    assert done.returncode == 125 and f"error: -v cannot mount {desk.folder}: the path has a colon\n" in done.stderr
    (remedy,) = [line for line in done.stderr.splitlines() if line.startswith("remedy: ")]
    assert shlex.split(remedy)[1:] == ["--mount", f'type=bind,"source={desk.folder}",target=/x,readonly']
    assert not desk.called("run")


@pytest.mark.parametrize("option", ["--dry-run", "--json", "--help"])
def test_output_that_goes_nowhere(desk: Desk, option: str) -> None:
    """Nobody reads it, or the disk is full: nothing was to be done, so nothing has failed, and no service is in the way."""
    reader, writer = os.pipe()
    os.close(reader)
    argv = desk.argv(option, "ubuntu")
    done = subprocess.run(
        argv, cwd=desk.folder, env=desk.environment, stdout=writer, stderr=subprocess.PIPE, check=False
    )
    os.close(writer)
    assert (done.returncode, done.stderr) == (0, b"")
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            argv, cwd=desk.folder, env=desk.environment, stdout=full, stderr=subprocess.PIPE, check=False
        )
    assert done.returncode == 125 and done.stderr.startswith(
        b"error: standard output: No space left on device\nremedy: "
    )
    assert b"setup" not in done.stderr and done.stderr.count(b"\n") == 2


def test_a_folder_that_is_gone(desk: Desk) -> None:
    script = 'mkdir x; cd x; rmdir ../x; exec "$@"'
    argv = ["sh", "-c", script, "sh", *desk.argv("ubuntu")]
    env = {**desk.environment, "PATH": f"{desk.bin}:/usr/bin:/bin"}
    done = subprocess.run(argv, cwd=desk.folder, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 125 and "remedy: go to another folder" in done.stderr


def test_what_it_does_not_need_is_not_imported(desk: Desk) -> None:
    """Nothing of publishing, no library but click, and nothing that is slow."""
    code = (
        "import sys; before = {*sys.modules}; sys.argv[1:] = ['run', '--dry-run', 'ubuntu']\n"
        "from rosml.cli.main import run\n"
        "assert run() == 0\n"
        "print(*{*sys.modules} - before)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], env=desk.environment, capture_output=True, text=True, check=True
    )
    imported = {*done.stdout.splitlines()[-1].split()}
    empty = {"backports"}  # in which zstd is looked for
    assert {name.partition(".")[0] for name in imported} - sys.stdlib_module_names - empty == {"rosml", "click"}
    packages = {name.split(".")[1] for name in imported if name.startswith("rosml.")}
    assert packages == {"base", "cli", "run"}
    assert not imported & {
        "csv",
        "difflib",
        "importlib.metadata",
        "socket",
        "rosml.cli.images.publish",
        "rosml.run.exports.compose",
    }


# ---- Who runs --------------------------------------------------------------------------------------------------------

PERSON = Person(1234, 5678, "jo", "/home/jo/robot", "Europe/Berlin", {"LANG": "de_DE.UTF-8", "LC_TIME": "C"})
ENGINE_OF_ROOT = Engine()
LABEL = ["--label", "io.rosml.run.folder=/home/jo/robot"]
OWN = [name for option in run.main.get_params(click.Context(run.main)) for name in option.opts if name.startswith("--")]
THEIR_IDS = ["--user", "1234:5678", "-e", "HOME=/tmp", "-e", "USER=jo", "-e", "LOGNAME=jo"]
CONTRACT = ["-e", "DOCKER_UID=1234", "-e", "DOCKER_GID=5678", "-e", "DOCKER_USER=jo"]
PODMANS_IDS = [*THEIR_IDS[:2], "--passwd-entry=jo:*:1234:5678::/tmp:/bin/sh", *THEIR_IDS[2:]]
PODMANS_ROOT = ["--userns=keep-id", "--user", "0:0", "--passwd=false"]


def added(
    *words: str,
    image: list[str] = OURS,
    engine: Engine = ENGINE_OF_ROOT,
    caller: Person = PERSON,
    trusted: bool = True,
    labels: dict[str, str] | None = None,
    user: str = "",
) -> list[str]:
    """What rosml adds to a command of somebody who is not root, and who trusts the image; the label is left out."""
    variables = dict(entry.partition("=")[::2] for entry in image)
    line = split([*words, "reg.test/me/ros:jazzy"], OWN)
    argv = [
        *make_plan(
            Context(line, engine, caller, Image(environment=variables, labels=labels or {}, user=user), BARE, trusted)
        ).argv
    ]
    assert argv[:2] == [engine.program, "run"]
    found = argv[2 : len(argv) - 1 - sum(len(given.words) for given in line.engine)]
    at = found.index("--label")
    return found[:at] + found[at + 2 :]


def without_others(**facts: Any) -> list[str]:
    return added("--no-rm", "--no-tz", "--no-name", "--no-it", *facts.pop("words", ()), **facts)


@pytest.mark.parametrize(
    ("engine", "image", "expected"),
    [
        (Engine(), OURS, CONTRACT),
        (Engine(), OTHER, [*THEIR_IDS, *LOCKED]),
        (Engine(rootless=True), OURS, []),
        (Engine(rootless=True), OTHER, ["--user", "0:0"]),
        (Engine("podman", podman=True), OURS, CONTRACT),
        (Engine("podman", podman=True), OTHER, [*PODMANS_IDS, *LOCKED]),
        (Engine("podman", podman=True, rootless=True), OURS, [*PODMANS_ROOT, *CONTRACT]),
        (Engine("podman", podman=True, rootless=True), OTHER, ["--userns=keep-id", *PODMANS_IDS]),
    ],
)
def test_files_belong_to_whoever_calls(engine: Engine, image: list[str], expected: list[str]) -> None:
    assert without_others(engine=engine, image=image) == expected


@pytest.mark.parametrize(
    ("engine", "expected"),
    [
        (Engine(), ["--user", "0:0", *CONTRACT]),
        (Engine(rootless=True), ["--user", "0:0"]),
        (Engine("podman", podman=True, rootless=True), [*PODMANS_ROOT, *CONTRACT]),
    ],
)
def test_an_image_that_starts_as_another_user_makes_the_person_as_well(engine: Engine, expected: list[str]) -> None:
    """As one of somebody else's that got ROS: its entrypoint needs root for that. Without trust it does not get it."""
    assert without_others(engine=engine, user="vendor") == expected
    assert without_others(engine=engine, user="root:root") == without_others(engine=engine)
    if not engine.rootless:
        assert without_others(engine=engine, user="vendor", trusted=False) == [*THEIR_IDS, *LOCKED]


@pytest.mark.parametrize("engine", [Engine(), Engine("podman", podman=True)])
def test_an_image_does_not_vouch_for_itself(engine: Engine) -> None:
    """Whoever builds an image may write DOCKER_UID into it. Without the person's trust it runs as any other image."""
    untrusted = without_others(engine=engine, trusted=False)
    ids = PODMANS_IDS if engine.podman else THEIR_IDS
    assert untrusted == without_others(engine=engine, image=OTHER) == [*ids, *LOCKED]


@pytest.mark.parametrize(
    "facts",
    [
        {"engine": Engine(rootless=True)},
        {"engine": Engine("podman", podman=True, rootless=True)},
        {"caller": Person(0, 0, "root", "/")},
        *({"words": words} for words in (["--user", "7"], ["--no-user"], ["--entrypoint", "bash"])),
    ],
)
def test_where_trust_changes_nothing(facts: dict[str, Any]) -> None:
    """Root in the container has no more rights than the person, or the person says who runs."""
    assert without_others(trusted=False, **facts) == without_others(trusted=True, **facts)


@pytest.mark.parametrize("value", ["no-new-privileges", "no-new-privileges=false", "no-new-privileges:true"])
def test_what_somebody_says_of_new_privileges(value: str) -> None:
    assert without_others(words=["--security-opt", value], trusted=False) == THEIR_IDS
    assert without_others(words=["--security-opt", "seccomp=x"], trusted=False) == [*THEIR_IDS, *LOCKED]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--user", "7"], []),
        (["-u7"], []),
        (["--entrypoint", "bash"], [*THEIR_IDS, *LOCKED]),  # nothing reads DOCKER_UID then
        (["--userns=host"], CONTRACT),
        (["-e", "DOCKER_UID=7"], CONTRACT),  # theirs comes later, and counts
    ],
)
def test_whoever_says_who_runs_is_heard(words: list[str], expected: list[str]) -> None:
    assert without_others(words=words) == expected
    assert without_others(words=[*words, "--no-user"]) == []


def test_podman_takes_one_user_namespace() -> None:
    assert without_others(words=["--userns=host"], engine=Engine("podman", podman=True, rootless=True)) == []


def home_options(*words: str, **facts: Any) -> list[str]:
    """The options about podman's entry in /etc/passwd. rootless podman, unless `facts` name another engine."""
    facts = {"engine": Engine("podman", podman=True, rootless=True), **facts}
    return [word for word in without_others(words=words, **facts) if word.startswith("--passwd")]


@pytest.mark.parametrize("option", ["--mwd", "--mws", "--no-gpu"])
def test_the_mounted_folder_is_no_home(option: str) -> None:
    """podman writes an entry for a user whom the image lacks, and takes the working directory for the home there. The entrypoint
    takes the home of an entry."""
    ours, other = [*OURS, "WORKSPACE=/ws"], [*OTHER, "WORKSPACE=/ws"]
    assert home_options(option, image=ours) == ["--passwd=false"]
    for rootless in (True, False):
        engine = Engine("podman", podman=True, rootless=rootless)
        assert home_options(option, image=other, engine=engine) == ["--passwd-entry=jo:*:1234:5678::/tmp:/bin/sh"]
        for image in (ours, other):
            assert home_options(option, image=image, engine=Engine(rootless=rootless)) == []


@pytest.mark.parametrize("words", [["--user", "7"], ["--no-user"], ["--userns=keep-id"]])
def test_a_chosen_user_has_no_home_in_the_mounted_folder(words: list[str]) -> None:
    assert home_options("--mwd", *words) == ["--passwd=false"]
    assert home_options(*words) == home_options("--mwd", *words, engine=Engine()) == []


@pytest.mark.parametrize("option", ["--passwd", "--passwd-entry=x", "--group-entry=x", "--hostuser=jo"])
def test_somebody_says_what_podman_writes(option: str) -> None:
    assert home_options("--mwd", option) == home_options("--mwd", option, image=OTHER) == []


def test_a_user_without_a_name_has_an_entry() -> None:
    found = home_options(image=OTHER, caller=Person(1234, 5678, "", "/"))
    assert found == ["--passwd-entry=1234:*:1234:5678::/tmp:/bin/sh"]
    assert home_options(image=OTHER, caller=Person(0, 0, "root", "/")) == []


@pytest.mark.parametrize(
    ("version", "expected"),
    [
        *((version, False) for version in ("3.4.4", "4.0.3")),
        *((version, True) for version in ("4.1.0-rc1", "4.3.1", "4.10", "5.0.0-dev", "10.0", "", None, 5)),
    ],
)
def test_podman_has_these_options_since_4_1(desk: Desk, version: object, expected: bool) -> None:
    """What is not known counts as new."""
    desk.engine(info={**PODMAN, "version": {"Version": version}})
    assert ("--passwd=false" in json.loads(desk.call("--json", "--mwd", "ours").stdout)) == expected


@pytest.mark.parametrize("name", ["", "DOMAIN\\jo", "jo smith", "1jo", "x" * 33, "backup", "www-data"])
def test_a_name_that_the_image_would_refuse(name: str) -> None:
    assert without_others(caller=Person(1234, 5678, name, "/")) == CONTRACT[:4]


def test_names_are_those_that_the_entrypoint_takes() -> None:
    script = (ROOT / "components/base/entrypoint.sh").read_text()
    assert f"^{NAME.pattern}$" in script


def test_root_has_a_home() -> None:
    root = Person(0, 0, "root", "/")
    assert without_others(caller=root, image=OTHER) == ["--user", "0:0"]


@pytest.mark.parametrize(
    ("words", "selinux", "expected"),
    [
        (["--mws"], True, True),
        (["--mwd"], True, True),
        (["--mws"], False, False),
        ([], True, False),
        (["-v", "/a:/b:z"], True, False),
        (["--mws", "--security-opt", "label=type:container_runtime_t"], True, False),
        (["--mws", "--privileged"], True, False),
    ],
)
def test_selinux_keeps_no_container_from_what_rosml_mounts(words: list[str], selinux: bool, expected: bool) -> None:
    engine = Engine("podman", podman=True, rootless=True, selinux=selinux)
    assert ("label=disable" in without_others(words=words, engine=engine)) == expected


def test_a_docker_that_is_a_snap_says_where_its_files_are(desk: Desk) -> None:
    desk.engine(info={**DOCKER, "DockerRootDir": "/var/snap/docker/common/var-lib-docker"})
    done = desk.call("--dry-run", "ubuntu", DISPLAY=":0")
    assert done.returncode == 0 and "docker is a snap" in done.stderr
    assert desk.call("--dry-run", "ubuntu").stderr == "", "without a display, nobody misses it"


@pytest.mark.parametrize(
    ("info", "selinux"),
    [
        (DOCKER, False),
        ({**DOCKER, "SecurityOptions": ["name=selinux"]}, True),
        (PODMAN, False),
        ({"host": {"security": {"rootless": True, "selinuxEnabled": True}}}, True),
    ],
)
def test_an_engine_says_whether_it_has_selinux(desk: Desk, info: dict[str, Any], selinux: bool) -> None:
    desk.engine(info=info)
    assert ("label=disable" in desk.call("--dry-run", "--mwd", "ubuntu").stdout) == selinux


@pytest.mark.parametrize(
    ("info", "expected"),
    [(DOCKER, (False, False)), (ROOTLESS, (False, True)), (PODMAN, (True, True)), ({"host": {}}, (True, False))],
)
def test_an_engine_says_what_it_is(desk: Desk, info: Any, expected: tuple[bool, bool]) -> None:
    desk.engine(info=info)
    found = engine.ask(str(desk.bin / "docker"), "ours", "").engine
    assert (found.podman, found.rootless) == expected


@pytest.mark.parametrize(("name", "expected"), [("docker", (False, False)), ("podman", (True, UID != 0))])
def test_an_engine_that_says_nothing_of_itself(desk: Desk, name: str, expected: tuple[bool, bool]) -> None:
    (desk.bin / name).write_text('#!/bin/sh\n[ $1 != image ] || echo \'{"Id": "x", "Config": {}}\'\n')
    (desk.bin / name).chmod(0o755)
    found = engine.ask(str(desk.bin / name), "ours", "")
    assert (found.engine.podman, found.engine.rootless, found.image) == (*expected, Image("x"))


ODD = "error: docker answers with something that rosml does not understand: "


@pytest.mark.parametrize(
    "info",
    [
        *({"host": {"security": None}}, {"host": 5}, {"host": {"security": [1]}}, 5, [1, 2], None),
        {"host": {}, "version": 5},
        *({**DOCKER, "SecurityOptions": found} for found in ([5], 5, "rootless", {"a": 1})),
        *({**DOCKER, "CDISpecDirs": found} for found in ([5], 5)),
        {**DOCKER, "Runtimes": 5},
    ],
)
def test_an_engine_that_describes_itself_oddly(desk: Desk, info: Any) -> None:
    desk.engine(info=info)
    done = desk.call("ours")
    assert (done.returncode, done.stdout) == (125, "") and done.stderr.startswith(ODD), done.stderr
    assert done.stderr.endswith("\nremedy: try `docker info --format '{{json .}}'`\n")
    assert not desk.called("run")


@pytest.mark.parametrize(
    "answer",
    [
        *(
            "nonsense",
            "",
            "null",
            "[]",
            "[1]",
            "[{}, {}]",
            "5",
            '{"Id": "x"}',
            '{"Config": {}}',
            '{"Id": 5, "Config": {}}',
        ),
        *(f'{{"Id": "x", "Config": {config}}}' for config in ("5", "null", '{"Env": 5}', '{"Env": [5]}')),
        *(f'{{"Id": "x", "Config": {config}}}' for config in ('{"Labels": [1]}', '{"Cmd": 5}', '{"Entrypoint": [5]}')),
        '{"Id": "x", "Config": {}} {}',
    ],
)
def test_an_image_that_is_described_oddly(desk: Desk, answer: str) -> None:
    """It may be one of ours, and would run as the wrong user."""
    desk.engine(answers={"image": answer})
    done = desk.call("ours")
    assert (done.returncode, done.stdout) == (125, "") and done.stderr.startswith(ODD), done.stderr
    assert done.stderr.endswith("\nremedy: try `docker image inspect ours`\n")
    assert not desk.called("run") and not desk.called("pull")


def test_a_warning_before_the_answer(desk: Desk) -> None:
    image = f"WARNING: x\n{json.dumps({'Id': 'sha256:x', 'Config': {'Env': OURS}})}"
    desk.engine(answers={"image": image, "info": f"WARNING: y\n{json.dumps(DOCKER, indent=1)}"})
    assert desk.call("ours").returncode == 0 and f"DOCKER_UID={UID}" in desk.ran


def test_an_image_that_is_missing_after_it_was_pulled(desk: Desk) -> None:
    (desk.bin / "docker").write_text(
        f"#!/bin/sh\ncase $1 in info) echo '{json.dumps(DOCKER)}';; image) exit 1;; run) exit 7;; esac\n"
    )
    done = desk.call("ours")
    assert done.returncode == 125 and "error: docker has pulled ours, and yet does not have it\n" in done.stderr
    assert "docker images" in done.stderr and "docker pull" not in done.stderr


def test_an_engine_that_cannot_be_run(desk: Desk) -> None:
    file = desk.folder / "file"
    file.write_text("x")
    for named in (file, desk.folder):
        done = desk.call("ubuntu", ROSML_ENGINE=str(named))
        assert done.returncode == 125 and f"error: '{named}', which ROSML_ENGINE names, cannot be run" in done.stderr
    (desk.bin / "docker").write_text("no program")
    done = desk.call("ubuntu")
    assert done.returncode == 125 and "error: docker cannot be run: Exec format error\nremedy: " in done.stderr


# ---- The other concerns ----------------------------------------------------------------------------------------------


def test_what_is_added_by_default() -> None:
    assert added() == ["--rm", *CONTRACT, "-e", "TZ=Europe/Berlin"]
    everything = ["--no-name", "--no-rm", "--no-it", "--no-tz", "--no-user"]
    there = Person(1234, 5678, "jo", "/home/jo/robot", "UTC", {}, terminal=True, reads=True)
    assert added(*everything, caller=there) == []


def test_time_to_save_when_it_is_stopped() -> None:
    """Where a stop reaches what has to save: in an image of ours, with its own entrypoint."""
    label = {"io.rosml.component": "base"}
    assert added("--no-rm", "--no-tz", "--no-user", labels=label) == ["--stop-timeout", "30"]
    assert added("--no-rm", "--no-tz", "--no-user") == []
    for words in (["--stop-timeout", "5"], ["--entrypoint", "bash"]):
        assert "30" not in added(*words, labels=label)
    assert "30" not in added(labels=label, image=OTHER)


@pytest.mark.parametrize("words", [["--rm"], ["--restart=always"], ["--rmi"], ["--rm=false"]])
def test_what_goes_with_no_removal(words: list[str]) -> None:
    assert "--rm" not in added(*words) and added("--restart-not=x")[0] == "--rm"


@pytest.mark.parametrize(
    ("folder", "image", "name"),
    [
        ("/home/jo/robot", "ros", "robot"),
        ("/home/jo/my robot (2)", "ros", "my-robot-2"),
        ("/home/jo/.config", "ros", "config"),
        ("/", "reg.test:5000/me/ros:jazzy", "ros-jazzy"),
        ("/x", "ros@sha256:" + "0" * 64, "ros"),
        ("/机器人", "ubuntu", "ubuntu"),
        ("/", "x", ""),
    ],
)
def test_the_containers_name(folder: str, image: str, name: str) -> None:
    def named(*words: str, terminal: bool = True) -> str:
        return basic_options.name_of(split([*words, image], OWN), Person(0, 0, "root", folder, terminal=terminal))

    assert named() == name
    assert named("--name", "mine") == "mine"
    assert named("--no-name") == named("--new") == named(terminal=False) == ""


def test_the_time_zone(tmp_path: Path) -> None:
    def zone(text: str = "") -> str:
        return person.timezone({"TZ": text} if text else {}, tmp_path)

    assert zone() == ""
    (tmp_path / "timezone").write_text("Asia/Tokyo\n")
    assert zone() == "Asia/Tokyo"
    (tmp_path / "localtime").symlink_to("/usr/share/zoneinfo/Europe/Berlin")
    assert zone() == zone(":/etc/localtime") == zone("/somewhere") == "Europe/Berlin"
    assert zone("America/New_York") == zone(":/usr/share/zoneinfo/America/New_York") == "America/New_York"
    (tmp_path / "localtime").unlink()
    (tmp_path / "localtime").write_bytes(b"TZif2")
    (tmp_path / "timezone").write_bytes(b"\xff")
    assert zone() == ""
    assert "TZ=Europe/Berlin" in added() and "TZ=Europe/Berlin" not in added("--tz=local")


def test_the_locale() -> None:
    assert added("--loc")[-4:] == ["-e", "LANG=de_DE.UTF-8", "-e", "LC_TIME=C"]


def test_the_current_folder_is_mounted() -> None:
    both = added("--mwd", "--mws")
    here = "/home/jo/robot"
    assert both[-6:-2] == ["--mount", f"type=bind,source={here},target={here}", "--workdir", here]
    assert both[-2:] == ["--mount", f"type=bind,source={here},target=/docker-ros/ws/src/target"]
    with pytest.raises(RosmlError, match="has no workspace"):
        added("--mws", image=OTHER)


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("-v .:/ws", "-v /home/jo:/ws"),
        ("-v ..:/ws:ro", "-v /home:/ws:ro"),
        ("-v a/b:/ws", "-v /home/jo/a/b:/ws"),
        ("-v ./a/../b:/ws", "-v /home/jo/b:/ws"),
        ("-v /a/../b:/ws", "-v /a/../b:/ws"),
        ("-v name:/ws", "-v name:/ws"),
        ("-v /ws", "-v /ws"),
        ("-v ./ws", "-v ./ws"),
        ("-itv./a:/b", "-itv/home/jo/a:/b"),
        ("--volume=~/a:/b", "--volume=/home/other/a:/b"),
        ("--mount type=bind,source=a,target=/b", "--mount type=bind,source=/home/jo/a,target=/b"),
        ("--mount=type=bind,src=./a,dst=./b", "--mount=type=bind,src=/home/jo/a,dst=./b"),
        ("--mount type=bind,src=/a,dst=/b", "--mount type=bind,src=/a,dst=/b"),
        ("--mount type=volume,src=a,dst=/b", "--mount type=volume,src=a,dst=/b"),
        ("--mount src=a,dst=/b", "--mount src=a,dst=/b"),
        ('--mount "type=bind', '--mount "type=bind'),
        ("--env-file ./a", "--env-file ./a"),
        ("-e A=./a:/b", "-e A=./a:/b"),
        ("--workdir ./a:/b", "--workdir ./a:/b"),
    ],
)
def test_relative_folders(written: str, meant: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", "/home/other")
    (option,) = split([*written.split(), "image"], ()).engine
    assert " ".join(resolved(option, "/home/jo").words) == meant


def test_odd_paths_in_a_mount() -> None:
    assert bind("/a:b", "/c") == "type=bind,source=/a:b,target=/c"
    assert bind('/a,"b"', "/c d") == 'type=bind,"source=/a,""b""",target=/c d'
    (option,) = split(["--mount", 'type=bind,"source=a,b",target=/c', "image"], ()).engine
    assert resolved(option, "/x").value == 'type=bind,"source=/x/a,b",target=/c'
