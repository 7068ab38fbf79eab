"""`rosml run`: the engine's command, the terminal, the end, pulled images, and wrong calls. The engines are local replacements,
which write down how they are called."""

from __future__ import annotations

import json
import os
import shlex
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from fakes.desks import DOCKER, OTHER, OURS, PODMAN, ROOTLESS, UID, Desk, docker_desk, labelled, plain
from fakes.http_registry import local_registry
from fakes.stubs import services
from rosml.registry import oci
from rosml.registry.client import Registry
from rosml.run import host


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return docker_desk(tmp_path)


def subprocess_of(desk: Desk, *words: str | bytes, **options: object) -> subprocess.CompletedProcess[bytes]:
    argv: list[str | bytes] = [*desk.argv(), *words]
    return subprocess.run(argv, cwd=desk.folder, env=desk.environment, **options)  # type: ignore[call-overload, no-any-return]


@pytest.mark.parametrize(
    "words",
    [
        ["ubuntu", "bash", "-c", 'echo "a  b" $HOME; ls'],
        ["-e", "A=b c", "ubuntu"],
        ["ubuntu", "ls", "--verbose", "--help", "--name", "x"],
        ["ubuntu", "printf", "", "%s", ""],
        ["ubuntu", "echo", "a\\b", "\\", "\n", "`id`", "$(id)", "*"],
        ["-it", "-v", "/a b:/c d", "ubuntu", "env", "--dry-run", "--rm", "--json"],
    ],
)
def test_words_arrive_as_they_are(desk: Desk, words: list[str]) -> None:
    done = desk.call("--no-tz", *words)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert desk.ran == [*plain(desk), *words]


def test_bytes_that_are_no_text_arrive_as_they_are(desk: Desk) -> None:
    subprocess_of(desk, "--no-tz", "ubuntu", "ls", b"\xff\xfe", check=True)
    assert os.fsencode(desk.ran[-1]) == b"\xff\xfe"


def test_a_missing_folder_is_made(desk: Desk) -> None:
    """docker would make it for root, and nobody else could write there. A volume and a file stay what they are."""
    (desk.root / "file").touch()
    words = ["-v", "./bags/new:/bags", "-v", "name:/data", "-v/file:/file", "-v", "/anonymous"]
    desk.call("--dry-run", *words, "ubuntu")
    assert [path.name for path in desk.root.iterdir()] == ["file"]
    assert desk.call(*words, "--mount=type=bind,src=a,dst=/a", "ubuntu").returncode == 0
    folder = desk.root / str(desk.folder).lstrip("/") / "bags/new"
    assert folder.is_dir() and folder.stat().st_uid == os.geteuid() and (desk.root / "file").is_file()
    assert {path.name for path in desk.root.iterdir()} == {"file", folder.relative_to(desk.root).parts[0]}


def test_a_running_container_of_the_folders_name_is_left_alone(desk: Desk) -> None:
    desk.engine(containers={"dr": ["running", "/dr"]})
    assert desk.call("--no-tz", "ubuntu", "ls").returncode == 0
    assert desk.ran == [*plain(desk), "ubuntu", "ls"]
    code, screen = desk.on_a_terminal("ubuntu", "ls")
    assert code == 125 and b"a container named dr runs, and rosml run did not start it" in screen
    assert b"--new starts another container" in screen
    assert len([call for call in desk.calls if call[1] not in ("info", "image", "container")]) == 1
    assert desk.on_a_terminal("--new", "ubuntu", "ls")[0] == 0 and "--name" not in desk.calls[-1]


def test_on_a_terminal(desk: Desk) -> None:
    assert desk.on_a_terminal("--no-tz", "ours") == (0, b"")
    assert desk.ran[:7] == ["docker", "run", "--rm", "-i", "-t", "--name", "dr"]


@pytest.mark.parametrize(
    ("words", "expected"),
    [(["--no-it"], []), (["-it"], []), (["-i"], ["-t"]), (["--tty"], ["-i"]), (["--tty=false"], ["-i"])],
)
def test_the_user_chooses_the_terminal(desk: Desk, words: list[str], expected: list[str]) -> None:
    assert desk.on_a_terminal("--no-tz", "--no-user", "--no-name", *words, "ubuntu")[0] == 0
    typed = [word for word in words if word != "--no-it"]
    assert desk.ran == ["docker", "run", "--rm", *expected, *labelled(desk), *typed, "ubuntu"]


def test_output_into_a_pipe_has_no_terminal(desk: Desk) -> None:
    """It would write line ends of its own, and the container's errors among the output."""
    reader, writer = os.pipe()
    assert desk.on_a_terminal("ubuntu", output=writer)[0] == 0
    os.close(writer)
    os.close(reader)
    assert "-i" in desk.ran and "-t" not in desk.ran and "--name" not in desk.ran


def test_input(desk: Desk, tmp_path: Path) -> None:
    assert subprocess_of(desk, "ubuntu", "read", input=b"a\nb", capture_output=True).stdout == b"A\nB"
    assert "-i" in desk.ran and not host.reads(os.open(os.devnull, os.O_RDONLY))
    assert host.reads(os.open(tmp_path, os.O_RDONLY))
    closed = ["/bin/sh", "-c", 'exec "$@" <&-', "sh", *desk.argv("ubuntu")]
    assert subprocess.run(closed, env=desk.environment, cwd=desk.folder).returncode == 0 and "-i" not in desk.calls[-1]


def test_the_exit_code_is_the_commands(desk: Desk) -> None:
    desk.engine(code=42)
    assert desk.call("ubuntu", "false").returncode == 42


def test_signals_reach_the_engine(desk: Desk) -> None:
    argv, options = desk.argv("ubuntu", "wait"), {"cwd": desk.folder, "env": desk.environment}
    with subprocess.Popen(argv, stdout=subprocess.PIPE, **options) as process:  # type: ignore[call-overload]
        assert process.stdout and process.stdout.readline() == b"waiting\n"
        process.send_signal(signal.SIGTERM)
        assert process.wait(10) == 7


def test_python_ignores_no_signal_for_the_engine(desk: Desk) -> None:
    (desk.bin / "docker").write_text(
        "#!/bin/sh\ncase $1 in run) exec /usr/bin/grep SigIgn /proc/self/status;; "
        'image) echo \'{"Id": "x", "Config": {}}\';; esac\n'
    )
    ignored = int(desk.call("ubuntu").stdout.split()[1], 16)
    assert not ignored & (1 << signal.SIGPIPE - 1 | 1 << signal.SIGXFSZ - 1)


def test_what_would_run_is_shown(desk: Desk) -> None:
    words = ["--name", "x", "ubuntu", "echo", "a  b"]
    dry_run, as_json = desk.call("--no-tz", "--dry-run", *words), desk.call("--no-tz", "--json", *words)
    assert {call[1] for call in desk.calls} == {"info", "image", "container"}
    argv = [*plain(desk), *words]
    assert (dry_run.stdout, dry_run.stderr) == (f"{shlex.join(argv)}\n", "")
    assert (json.loads(as_json.stdout), as_json.stderr) == (argv, "")
    verbose = desk.call("--no-tz", "--verbose", *words)
    assert (verbose.stdout, verbose.stderr, desk.ran) == ("", dry_run.stdout, argv)


def test_bytes_that_are_no_text_are_shown_as_a_shell_reads_them(desk: Desk) -> None:
    words = [b"\xffab'c\\d e\n", "ü".encode(), "ü".encode() + b"\xfe"]
    shown = subprocess_of(desk, "--no-tz", "--dry-run", "ubuntu", "ls", *words, capture_output=True, check=True).stdout
    assert b"$'\\xff" in shown and "ü".encode() in shown
    read = subprocess.run(["bash", "-c", b"printf '%s\\0' " + shown], capture_output=True, check=True).stdout
    assert read.split(b"\0")[-4:-1] == words


@pytest.mark.parametrize("option", ["--dry-run", "--help"])
def test_output_that_nobody_reads_is_no_failure_and_a_full_disk_is(desk: Desk, option: str) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess_of(desk, option, "ubuntu", stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    assert (done.returncode, done.stderr) == (0, b"")
    with open("/dev/full", "w") as full:
        done = subprocess_of(desk, option, "ubuntu", stdout=full, stderr=subprocess.PIPE)
    assert done.returncode == 125 and b"No space left on device\nremedy: " in done.stderr


def test_which_engine_runs(desk: Desk) -> None:
    desk.engine("podman", info={"host": {"security": {"rootless": False}}})
    assert desk.call("--no-tz", "ubuntu", ROSML_ENGINE=str(desk.bin / "podman")).returncode == 0
    assert desk.calls[-1] == ["podman", *plain(desk)[1:], "ubuntu"]
    done = desk.call("ubuntu", ROSML_ENGINE="nerdctl")
    assert done.returncode == 125 and "no program 'nerdctl', which ROSML_ENGINE names" in done.stderr
    (desk.bin / "docker").unlink()
    assert desk.call("ubuntu").returncode == 0 and desk.calls[-1][0] == "podman"
    (desk.bin / "podman").unlink()
    done = desk.call("ubuntu")
    assert (done.returncode, done.stdout) == (125, "")
    assert "neither docker nor podman is installed" in done.stderr and "\nremedy: install" in done.stderr


def test_an_engine_that_cannot_be_run(desk: Desk) -> None:
    done = desk.call("ubuntu", ROSML_ENGINE=str(desk.folder))
    assert done.returncode == 125 and "cannot be run: it is a folder" in done.stderr
    (desk.bin / "docker").write_text("no program")
    done = desk.call("ubuntu")
    assert done.returncode == 125 and "error: docker cannot be run: Exec format error\nremedy: " in done.stderr


@pytest.mark.parametrize(
    ("complaint", "remedy"), [("Cannot connect", "start docker"), ("permission denied", "usermod")]
)
def test_an_engine_that_does_not_answer(desk: Desk, complaint: str, remedy: str) -> None:
    desk.engine(info={"ServerVersion": "", "ServerErrors": [complaint]}, images={}, complaint=complaint)
    desk.engine("podman", info={}, images={})
    for desk.command, words in (("run", ["ubuntu"]), ("attach", []), ("attach", ["x"])):
        done = desk.call(*words)
        assert done.returncode == 125 and complaint in done.stderr and remedy in done.stderr
        assert "ROSML_ENGINE=podman" in done.stderr and not desk.called("pull") and not desk.called("run")


def test_podman_takes_the_place_of_a_docker_without_a_daemon(desk: Desk) -> None:
    """It says so. Whoever names Docker gets Docker's error, and whoever may not call Docker, too."""
    silent = {"ServerVersion": "", "ServerErrors": ["Cannot connect"]}
    desk.engine(info=silent, images={}, complaint="Cannot connect")
    desk.engine("podman", info=PODMAN)
    done = desk.call("--no-tz", "ubuntu")
    assert (done.returncode, desk.ran[0]) == (0, "podman")
    assert done.stderr == "rosml: docker does not answer, so podman is taken; ROSML_ENGINE names one of them\n"
    for name, text in (("ROSML_ENGINE", "docker"), ("DOCKER_HOST", "unix:///x"), ("DOCKER_CONTEXT", "robot")):
        done = desk.call("ubuntu", **{name: text})
        assert done.returncode == 125 and "docker does not answer: Cannot connect\n" in done.stderr
    desk.engine(info=silent, images={}, complaint="permission denied")
    done = desk.call("ubuntu")
    assert done.returncode == 125 and "usermod" in done.stderr and "ROSML_ENGINE=podman" in done.stderr
    desk.engine("podman", info={}, images={}, complaint="no such user")
    done = desk.call("ubuntu", ROSML_ENGINE="podman")
    assert "podman does not answer: no such user\nremedy: podman info says more" in done.stderr


def test_a_missing_image_is_pulled_first(desk: Desk) -> None:
    """Its user counts; progress is not among the command's output."""
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
    error = desk.call("reg.local/me", ROSML_ENGINE="podman").stderr
    assert "if its registry has no TLS: rosml run --tls-verify=false reg.local/me" in error


@pytest.mark.parametrize(
    ("image", "remedy"),
    [
        ("jazzy-base", "if it is a target, `rosml image jazzy-base` builds it"),
        (
            "ros-torch:jazzy",
            "such as ghcr.io/me/rosml/ros-torch:jazzy; if it is of your packages, rosml containerize builds",
        ),
        ("ros2", "an image goes before it: rosml run IMAGE ros2"),
        ("me/ros:core@sha256:1", "take its tag: me/ros:core"),
        ("./my_package", "it is a path: rosml run -v FOLDER:/mnt IMAGE mounts it"),
    ],
)
def test_an_image_that_nobody_has(desk: Desk, image: str, remedy: str) -> None:
    done = desk.call(image)
    assert done.returncode == 125 and remedy in done.stderr.partition("remedy: ")[2] and not desk.called("run")
    assert f"pull access denied\nerror: no image {image} here, and docker cannot pull it\n" in done.stderr


@pytest.mark.parametrize("repository", ["robot", "rosml/robot"])
def test_a_short_name_is_one_of_the_local_registry(desk: Desk, tmp_path: Path, repository: str) -> None:
    """`rosml containerize` and `rosml image` put images there, if no Docker has them."""
    with local_registry() as server, Registry(server.address) as registry:
        registry.put_manifest(repository, "latest-dev", {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []})
        name = f"{server.address}/{repository}:latest-dev"
        desk.engine(images={}, registry={name: OURS})
        checkout = {"DESK_CHECKOUT": str(services(tmp_path, server.address).root)}
        assert f"docker pull {name}" in desk.call("--dry-run", "robot:latest-dev", **checkout).stderr
        assert desk.call("robot:latest-dev", "pwd", **checkout).returncode == 0
        assert desk.ran[-2:] == [name, "pwd"]
        assert "error: no image other:latest here" in desk.call("other:latest", **checkout).stderr


@pytest.mark.parametrize(
    ("info", "remedy"),
    [
        (DOCKER, "check its name; if its registry is down, call rosml setup in the checkout;"),
        (
            ROOTLESS,
            "if docker has a network of its own, as without root before version 29.5, give it a file: rosml save ",
        ),
        (
            {**DOCKER, "Name": "robot"},
            "docker runs on another machine, robot, whose loopback is another one; give it a",
        ),
    ],
)
def test_a_registry_on_loopback_that_the_engine_does_not_reach(desk: Desk, info: dict[str, Any], remedy: str) -> None:
    desk.engine(info=info, images={})
    done = desk.call("127.0.0.1:5000/rosml/ros:jazzy")
    assert done.returncode == 125 and remedy in f"{done.stderr.partition('remedy: ')[2].strip()};"
    assert "docker login" not in done.stderr


def test_docker_that_reads_no_zstd_is_the_first_reason_why_it_cannot_pull(desk: Desk) -> None:
    desk.engine(info={**DOCKER, "ServerVersion": "20.10.24"}, images={})
    remedy = desk.call("ghcr.io/us/ros:jazzy").stderr.partition("remedy: ")[2]
    assert remedy.startswith("update Docker") and "before version 23" in remedy and "check its name" in remedy


@pytest.mark.parametrize("words", [["--dry-run"], ["--json"], ["--pull=never"], ["--pull", "never"]])
def test_where_nothing_is_pulled(desk: Desk, words: list[str]) -> None:
    desk.engine(images={}, registry={"ours": OURS})
    done = desk.call(*words, "ours")
    assert done.returncode == 125 and "error: no image ours here" in done.stderr and "docker pull ours" in done.stderr
    assert not desk.called("pull") and not desk.called("run")


def test_an_image_that_is_missing_after_it_was_pulled(desk: Desk) -> None:
    (desk.bin / "docker").write_text(
        f"#!/bin/sh\ncase $1 in info) echo '{json.dumps(DOCKER)}';; image) exit 1;; run) exit 7;; esac\n"
    )
    done = desk.call("ours")
    assert done.returncode == 125 and "docker has pulled ours, and yet does not have it" in done.stderr


@pytest.mark.parametrize(
    ("state", "name", "refused", "remedy"),
    [
        ("running", "/x1", True, "rosml attach x1 enters it; another --name starts another container"),
        ("exited", "/x1", True, "rosml attach x1 starts it again, docker rm x1 removes it with all"),
        ("dead", "/x1", True, "remedy: docker rm x1"),
        ("running", "x1", True, "rosml attach x1"),  # podman writes no slash
        ("running", "/brave_bell", False, ""),  # its id begins with x1
    ],
)
def test_a_name_that_is_taken(desk: Desk, state: str, name: str, refused: bool, remedy: str) -> None:
    desk.engine(containers={"x1": [state, name]})
    done = desk.call("--name=x1", "ubuntu")
    assert done.returncode == (125 if refused else 0)
    assert ("a container named x1 " in done.stderr) == refused and remedy in done.stderr
    assert desk.call("--name=x1", "--replace", "ubuntu").returncode == 0, "podman replaces it"


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ([], "no container was started in this folder\nremedy: rosml run IMAGE starts one"),
        (["--new"], "--new needs an image"),
        (["<registry>/ros:jazzy-base"], "remedy: write an image that you have"),
        (["--user", "me/ros:jazzy-base", "bash"], "remedy: leave --user out"),
        (["--name", "robot"], "to enter a container that is there: rosml attach robot"),
        (["--network", "host"], "'host' is the value of --network"),
    ],
)
def test_a_call_that_is_wrong(desk: Desk, words: list[str], says: str) -> None:
    done = desk.call(*words)
    assert (done.returncode, says in done.stderr) == (125, True), done.stderr
    assert not desk.called("run")


def test_h_alone_asks_for_help(desk: Desk) -> None:
    assert desk.call("-h").stdout.startswith("Usage: ")
    desk.call("-h", "robot", "ubuntu")
    assert [word for word in desk.calls[-1] if word in ("-h", "robot")] == ["-h", "robot"]


@pytest.mark.parametrize(
    ("word", "warns"), [("--gpus", True), ("--mws", True), ("-it", True), ("--version", False), ("-la", False)]
)
def test_an_option_after_the_image(desk: Desk, word: str, warns: bool) -> None:
    done = desk.call("ubuntu", word)
    assert desk.calls[-1][-1] == word
    assert (f"options come first: rosml run {word} … ubuntu" in done.stderr) == warns


def test_a_folder_with_a_colon_goes_with_no_volume(desk: Desk) -> None:
    desk.folder = desk.folder / "a:b, c"
    desk.folder.mkdir()
    done = desk.call("-v", ".:/x:ro", "ubuntu")
    assert done.returncode == 125 and f"error: -v cannot mount {desk.folder}: the path has a colon\n" in done.stderr
    (remedy,) = [line for line in done.stderr.splitlines() if line.startswith("remedy: ")]
    assert shlex.split(remedy)[1:] == ["--mount", f'type=bind,"source={desk.folder}",target=/x,readonly']


def test_a_folder_that_is_gone(desk: Desk) -> None:
    argv = ["sh", "-c", 'mkdir x; cd x; rmdir ../x; exec "$@"', "sh", *desk.argv("ubuntu")]
    env = {**desk.environment, "PATH": f"{desk.bin}:/usr/bin:/bin"}
    done = subprocess.run(argv, cwd=desk.folder, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 125 and "remedy: go to another folder" in done.stderr


MODULES = {"run": 42, "attach": 27}
"""The most modules of rosml that a shell waits for."""


@pytest.mark.parametrize("command", MODULES)
def test_unused_modules_are_not_imported(desk: Desk, command: str) -> None:
    desk.engine(containers={"ubuntu": ["running", "/ubuntu"]})
    code = (
        f"import sys; before = {{*sys.modules}}; sys.argv[1:] = ['{command}', '--dry-run', 'ubuntu']\n"
        "from rosml.cli.main import run\n"
        "assert run() == 0\n"
        "print(*{*sys.modules} - before)\n"
    )
    argv = [sys.executable, "-c", code]
    done = subprocess.run(argv, env=desk.environment, capture_output=True, text=True, check=True)
    imported = {*done.stdout.splitlines()[-1].split()}
    empty = {"backports"}  # in which zstd is looked for
    assert {name.partition(".")[0] for name in imported} - sys.stdlib_module_names - empty == {"rosml", "click"}
    ours = [name for name in imported if name.startswith("rosml")]
    assert {name.split(".")[1] for name in ours if "." in name} == {"base", "cli", "run"}
    assert len(ours) <= MODULES[command]
    assert not imported & {"csv", "difflib", "importlib.metadata", "socket", "rosml.run.exports.compose"}
