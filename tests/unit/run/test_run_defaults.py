"""Defaults of `rosml run`: which files count, what wins, and when a project's file needs a question."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest
from conftest import ROOT

from fakes.desks import OTHER, USER, Desk, folder_container
from rosml.base.errors import RosmlError
from rosml.run import consent, defaults, host, paths, words
from rosml.run.defaults import File, Files
from rosml.run.plugins.discovery import BUILT_IN
from rosml.run.words import split
from tests.pages import blocks

IMAGE = 'image = "ubuntu"\n'


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    desk = Desk(tmp_path)
    desk.engine()
    return desk


def project(desk: Desk, text: str) -> Path:
    """Writes the project's file."""
    file = desk.folder / ".rosml.toml"
    file.write_text(text)
    return file


def person(desk: Desk, text: str) -> Path:
    """Writes the person's file."""
    file = Path(desk.environment["HOME"], ".config/rosml/run.toml")
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    return file


def tail(desk: Desk) -> list[str]:
    """The words after those of rosml itself."""
    (at,) = [at for at, word in enumerate(desk.ran) if desk.ran[at : at + len(USER)] == USER]
    rest = desk.ran[at + len(USER) :]
    return rest[2:] if any(word.startswith("TZ=") for word in rest[1:2]) else rest


def allow(desk: Desk) -> None:
    assert desk.on_a_terminal(keys=b"y\n")[0] == 0 and question(desk) == ""


def question(desk: Desk) -> str:
    """The settings that need a question; empty if none does."""
    return desk.call().stderr.partition(" wants what you have not allowed: ")[2].partition("\n")[0]


def test_the_command_line_wins_over_the_project_and_that_over_the_person(desk: Desk) -> None:
    person(desk, 'image = "ours"\ncommand = ["htop"]\noptions = ["-e", "A=1", "--no-rm", "-v", "./x:/x"]\n')
    project(desk, 'options = ["-e", "ROS_DOMAIN_ID=2", "--no-tz"]\n')
    assert desk.call("-e", "A=3", "ubuntu").returncode == 0
    config = Path(desk.environment["HOME"], ".config/rosml")
    assert tail(desk) == ["-v", f"{config}/x:/x", "-e", "ROS_DOMAIN_ID=2", "-e", "A=3", "ubuntu"]
    assert "--rm" not in desk.ran


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        ([], ["ubuntu", "echo", "a  b"]),
        ([".", "ls", "-l"], ["ubuntu", "ls", "-l"]),
        (["--new", ".", "ls"], ["ubuntu", "ls"]),
        (["ours"], ["ours"]),  # the file's command belongs to the file's image
    ],
)
def test_a_file_names_the_image_and_its_command(desk: Desk, typed: list[str], expected: list[str]) -> None:
    person(desk, f'{IMAGE}command = ["echo", "a  b"]\n')
    assert desk.call(*typed).returncode == 0 and desk.ran[-len(expected) :] == expected


def test_a_command_belongs_to_the_image_of_its_own_file(desk: Desk) -> None:
    config = person(desk, 'image = "ours"\ncommand = ["htop"]\noptions = ["-v", "/srv/old:/data", "--no-tz"]\n')
    file = project(desk, f'{IMAGE}options = ["-v", "./bags:/data"]\n')
    done = desk.call("--verbose", "--dry-run")
    assert shlex.split(done.stdout)[-3:] == ["-v", f"{desk.folder}/bags:/data", "ubuntu"]
    sources = [f"from {config}: --no-tz", f"from {file}: -v {desk.folder}/bags:/data ubuntu"]
    assert done.stderr.splitlines()[:2] == sources
    project(desk, 'command = ["echo"]\n')  # of the person's image
    assert shlex.split(desk.call("--dry-run").stdout)[-2:] == ["ours", "echo"]


@pytest.mark.parametrize(
    ("below", "above", "rest"),
    [
        (["-v", "/a:/data"], ["--volume=/b:/data/:ro"], []),
        (["-v", "/a:/data"], ["--mount", "type=bind,src=/b,dst=/data"], []),
        (["--mount", "type=bind,source=/a,target=/data"], ["--tmpfs", "/data:size=1m"], []),
        (["-itv", "/a:/data"], ["-v", "/data"], ["-it"]),
        (["-v", "/a:/data", "-v", "/a:/other"], ["-v", "/b:/data"], ["-v", "/a:/other"]),
        (["--name", "a", "-e", "A=1", "-e", "B=1"], ["--name=b", "-e", "A"], ["-e", "B=1"]),
        (["-p", "1:2"], ["-p", "1:2"], ["-p", "1:2"]),  # the engine says so
    ],
)
def test_of_two_that_set_one_thing_the_upper_one_counts(below: list[str], above: list[str], rest: list[str]) -> None:
    lower, upper = (File("/p", b"", 0, split(words, ())) for words in (below, above))
    calls = ((Files(lower), split([*above, "x"], ())), (Files(lower, upper), split(["x"], ())))
    for files, typed in calls:
        assert [word for option in files.under(typed).engine for word in option.words] == [*rest, *above]


def test_the_container_of_the_folder_is_entered_with_what_was_typed(desk: Desk) -> None:
    """It has the file's options already, and `exec` has no -v."""
    project(desk, f'{IMAGE}options = ["-v", "./a:/a"]\ncommand = ["htop"]\n')
    desk.engine(containers={"dr": folder_container(desk, "ubuntu")}, images={"ubuntu": OTHER})
    assert desk.call("-e", "A=b").returncode == 0
    assert desk.ran == ["docker", "exec", "-e", "A=b", "dr", "bash"]
    assert desk.on_a_terminal(".", "ls") == (0, b"")
    assert desk.calls[-1] == ["docker", "exec", "-i", "-t", "dr", "ls"]


def test_files_are_left_out(desk: Desk) -> None:
    person(desk, "nonsense")
    project(desk, "nonsense")
    assert desk.call("--no-defaults", "ubuntu").returncode == 0 and tail(desk) == ["ubuntu"]


def test_no_image_is_named_anywhere(desk: Desk) -> None:
    project(desk, 'options = ["--mws"]\n')
    for typed in ([], ["."], ["--new"]):
        assert desk.call(*typed).returncode == 125 and not desk.called("run")


def test_the_search_for_the_projects_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It ends below the home folder, also where a link leads there, and with the file system, as that of git does."""
    home, link = tmp_path / "home", tmp_path / "link"
    deep = home / "robot/src/package"
    deep.mkdir(parents=True)
    link.symlink_to(home)
    (home / ".rosml.toml").touch()
    (tmp_path / ".rosml.toml").touch()
    assert defaults.project_file(str(deep), str(link)) == defaults.project_file(str(home), str(link)) == ""
    (home / "robot/.rosml.toml").touch()
    for end in (str(link), "/nowhere"):
        assert defaults.project_file(str(deep), end) == str(home / "robot/.rosml.toml")
    assert defaults.project_file(str(tmp_path), "/nowhere") == str(tmp_path / ".rosml.toml")
    monkeypatch.setattr("rosml.run.defaults._device", lambda folder: int("package" in folder))
    assert defaults.project_file(str(deep), "/nowhere") == ""


@pytest.mark.parametrize("variable", ["HOME", "XDG_CONFIG_HOME"])
def test_a_relative_folder_of_settings_does_not_count(desk: Desk, tmp_path: Path, variable: str) -> None:
    """It would lead into a project, whose settings need a question."""
    file = person(desk, IMAGE)
    assert desk.call(XDG_CONFIG_HOME=str(file.parent.parent)).returncode == 0 and tail(desk) == ["ubuntu"]
    file.parent.parent.rename(desk.folder / ".config")
    assert desk.call(**{variable: "." if variable == "HOME" else ".config"}).returncode == 125
    project(desk, 'options = ["--privileged"]\n')
    assert "wants what you have not allowed" in desk.call("ubuntu", **{variable: "."}).stderr


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        ('"-v", "./a:/a"', "-v /p/a:/a"),
        ('"--mount=type=bind,src=a,dst=/a"', "--mount=type=bind,src=/p/a,dst=/a"),
        ('"--env-file=~/a.env"', "--env-file=/home/other/a.env"),
        ('"-itv", "..:/a"', "-itv /:/a"),
        ('"--security-opt", "seccomp=a.json"', "--security-opt seccomp=/p/a.json"),
        *((f'"{word}"', word) for word in ("--security-opt=seccomp=unconfined", "--hosts-file=none", "--runtime=runc")),
    ],
)
def test_relative_paths_begin_at_the_files_folder(
    typed: str, expected: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / ".rosml.toml").write_text(f"options = [{typed}]")
    monkeypatch.setenv("HOME", "/home/other")
    options = " ".join(word for option in of_project(tmp_path).line.engine for word in option.words)
    assert options.replace(str(tmp_path.parent), "/").replace(f"/{tmp_path.name}", "p").replace("//", "/") == expected


def test_the_page_shows_the_questions(tmp_path: Path) -> None:
    page = (ROOT / "docs/run/defaults.md").read_text()
    (example,) = [block.text for block in blocks(ROOT / "docs/run/defaults.md") if block.title == ".rosml.toml"]
    (tmp_path / ".rosml.toml").write_text(example)
    file = defaults.files({}, str(tmp_path), ["--mws"], ()).project
    assert file
    (shown,) = [block.text for block in blocks(ROOT / "docs/run/defaults.md") if " wants:" in block.text]
    items = [item.replace(str(tmp_path), "/home/me/robot") for item in consent.questionable(file.line, trusted=True)]
    assert shown.splitlines()[1:-1] == [f"  {item}" for item in items]
    table = page.partition("Only these need no question:")[2].partition("Everything else")[0]
    letters = {f"-{letter}": f"--{long}" for letter, long in words.table().letters.items()}
    listed = {letters.get(word, word) for word in re.findall(r"`(--?[a-z0-9-]+)`", table)}
    assert listed == consent.HARMLESS | {f"--{name}" for name in {*consent.HARMLESS_OF_ENGINE, "env"}}
    assert {*re.findall("`([A-Z_]+)`", table)} == {*re.findall("[A-Z_]{4,}", consent.HARMLESS_VARIABLE.pattern)}


@pytest.mark.parametrize(
    ("text", "says", "remedy"),
    [
        ("\nimage = x", ":2: no TOML: invalid value", "correct"),
        (f"x = {'[' * 5000}", ": no TOML: ", "correct"),
        ('# a\nimgae = "ubuntu"', ":2: unknown key 'imgae'", "did you mean 'image'?"),
        ("\n[options]\na = 1", ":2: options must be a list of texts", 'write options = ["--mws"'),
        ("image = 5", ":1: image must be a text", "write image = "),
        ('command = ["a", 5]', ":1: command must be a list of texts", "write command = ["),
        *((f'image = "{name}"', f":1: '{name}' is no name of an image", "write image = ") for name in ("", "--rm")),
        ('options = ["--mws",\n"ubuntu"]', ":1: options has 'ubuntu', which is no option", "image = "),
        ('options = ["--mws", "--"]', ":1: options has '--', which is no option", "image = "),
        ('options = ["-e"]', ":1: the option -e lacks its value", "write the value"),
        ('options = ["-e A=b"]', ":1: options has two words in one: '-e A=b'", 'write "-e", "A=b"'),
        ('options = ["--no-rm=1"]', ":1: --no-rm takes no value", "write --no-rm"),
        *((f'options = ["{x}"]', ":1: --", "remove it") for x in ("--dry-run", "--check", "--export=compose", "--trust")),
        ('command = ["\\u001b[2J"]', ":1: command has a character that cannot be shown: '\\x1b'", "remove it"),
        ('options = ["-e", "A=\\u202e"]', ":1: options has a character that cannot be shown", "remove it"),
        ("#" * 70000, ": it has more than 64 KiB", "shorten it"),
    ],
)  # fmt: skip
def test_a_file_that_is_wrong(desk: Desk, text: str, says: str, remedy: str) -> None:
    file = project(desk, text)
    done = desk.call("ubuntu")
    assert (done.returncode, done.stdout) == (125, "") and not desk.calls
    message, advice = done.stderr.splitlines()
    assert message.startswith(f"error: {file}{says}") and remedy in advice and "--no-defaults" in advice


def test_what_is_no_file(desk: Desk) -> None:
    file, settings = desk.folder / ".rosml.toml", person(desk, "")
    makers: dict[str, Callable[[], object]] = {
        "": file.mkdir,
        "it is no file": lambda: os.mkfifo(file),
        "it is a link": lambda: file.symlink_to(settings),
        "not UTF-8 (byte 0xff)": lambda: file.write_bytes(b"#\n#\xff"),
    }
    for text, make in makers.items():
        make()
        done = desk.call("ubuntu")
        assert done.returncode == 125 and f"error: {file}:" in done.stderr and text in done.stderr
        file.rmdir() if file.is_dir() else file.unlink()
    settings.unlink()
    settings.mkdir()
    assert f"error: {settings}: " in desk.call("ubuntu").stderr


HARMLESS = ["--mws", "--mwd", "--no-rm", "--no-gpu", "--no-x11", "--no-ros", "-it", "--rm", "-e ROS_DOMAIN_ID=7"]
HARMLESS += ["--name=x", "-itm 1g", "--shm-size=2g", "--env=RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"]
QUESTIONED = ["--privileged", "--privileged=true", "--device /dev/sda", "--network=host", "--net host", "--pid=host"]
QUESTIONED += ["--ipc host", "--cap-add=ALL", "--security-opt seccomp=unconfined", "-v .:/x", "-itv /:/h"]
QUESTIONED += ["-itv/:/h", "--volume=/:/h", "--mount type=bind,src=/,dst=/h", "--userns=host", "--user 0", "-iu0"]
QUESTIONED += [
    "--env-file x",
    "-e SECRET",
    "-eSECRET",
    "-e LD_PRELOAD=/x",
    "-e ROS_DOMAIN_ID",
    "-e 'ROS_DOMAIN_ID=$(id)'",
]
QUESTIONED += ["--env=ROS_*", "--gpus all", "--entrypoint x", "-p 80:80", "--label a=b", "--unheard-of=true", "-w /x"]
QUESTIONED += ["-Pit", "-e 'ROS_DOMAIN_ID=7 a'", "-e RMW_IMPLEMENTATION=a/../b", "--runtime=x", "--pull=always", "-P"]
QUESTIONED += ["--ros-network", "--no-user", "--sound", "--ssh-agent", "--wayland"]
ROSML_OPTIONS = [f"--{name}" for plugin in BUILT_IN for name in plugin.options]


@pytest.mark.parametrize("option", [*HARMLESS, *QUESTIONED])
def test_which_options_need_a_question(option: str) -> None:
    line = split(shlex.split(option), ROSML_OPTIONS)
    shown = [shlex.join(shlex.split(option))]
    assert consent.questionable(line, trusted=False) == shown
    assert consent.questionable(line, trusted=True) == (shown if option in QUESTIONED else [])


def test_whose_file_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    for uid, expected in ((1000, [True, True, False]), (0, [True, False, True])):
        monkeypatch.setattr("os.geteuid", uid.__int__)
        assert [defaults.is_own(owner, {"SUDO_UID": "1001"}) for owner in (0, 1000, 1001)] == expected


def test_another_users_memory_allows_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither a file, nor one behind a link, nor one in a folder that another user made, nor their settings."""
    file, place = File("/x", b"", 0, split([], ())), tmp_path / "rosml/allowed.json"
    digest = consent.digest(file)
    host.write(place, consent.with_answer(file.path, digest, place))
    host.write(place, consent.with_answer(f"{consent.IMAGES}ghcr.io/me/x", True, place))
    assert consent.is_allowed(file, digest, place) and consent.is_trusted("ghcr.io/me/x", place)
    with monkeypatch.context() as patch:
        patch.setattr("os.geteuid", lambda: place.stat().st_uid + 1)
        assert not consent.is_allowed(file, digest, place) and consent.is_trusted("ghcr.io/me/x", place) is None
    with monkeypatch.context() as patch:
        patch.setattr("os.lstat", lambda path: SimpleNamespace(st_uid=os.geteuid() + 1))
        assert not consent.is_allowed(file, digest, place)
        with pytest.raises(PermissionError, match="its folder is another user's"):
            host.write(place, b"{}")
    place.rename(tmp_path / "cloned.json")
    place.symlink_to(tmp_path / "cloned.json")
    assert not consent.is_allowed(file, digest, place)
    host.write(place, consent.with_answer(file.path, digest, place))
    assert consent.is_allowed(file, digest, place) and not place.is_symlink()
    (tmp_path / "rosml/run.toml").write_text(IMAGE)
    monkeypatch.setattr("rosml.run.defaults.is_own", lambda owner, environment: False)
    with pytest.raises(RosmlError, match=r"run\.toml: it belongs to another user"):
        defaults.files({"XDG_CONFIG_HOME": str(tmp_path)}, "/", (), ())


def test_somebody_is_asked_once_for_each_content_and_folder(desk: Desk) -> None:
    file = project(desk, f'{IMAGE}options = ["--no-name", "--network", "host"]\n')
    code, screen = desk.on_a_terminal(keys=b"\n")
    assert code == 125 and f"{file} is not allowed".encode() in screen and not desk.called("run")
    code, screen = desk.on_a_terminal(keys=b"y\n")
    lines = screen.decode().replace("\r", "").splitlines()
    assert code == 0 and lines[lines.index(f"{file} wants:") :][1:3] == ["  image ubuntu", "  --network host"]
    assert tail(desk) == ["--network", "host", "ubuntu"]
    assert desk.on_a_terminal() == (0, b"") and desk.call().returncode == 0, "allowed"
    state = desk.memory
    assert (state.stat().st_mode & 0o777, state.parent.stat().st_mode & 0o777) == (0o600, 0o700)
    assert [*json.loads(state.read_text())] == [str(file)] and os.listdir(state.parent) == [state.name]
    project(desk, f'{IMAGE}options = ["--no-name", "--privileged"]\n')
    assert desk.call().returncode == 125, "changed"
    allow(desk)
    state.write_text("nonsense")
    assert desk.call().returncode == 125, "a damaged file allows nothing"
    allow(desk)
    desk.folder = desk.folder.with_name("other")
    desk.folder.mkdir()
    project(desk, f'{IMAGE}options = ["--no-name", "--privileged"]\n')
    assert desk.call().returncode == 125, "another folder"


@pytest.mark.parametrize("text", [IMAGE, 'options = ["-v", "/:/host"]\n', 'command = ["sh"]\n'])
def test_without_a_terminal_nothing_is_allowed(desk: Desk, text: str) -> None:
    person(desk, IMAGE)
    file = project(desk, text)
    done = desk.call()
    assert (done.returncode, done.stdout) == (125, "") and not desk.called("run") and not desk.called("pull")
    assert f"error: {file} wants what you have not allowed: " in done.stderr
    assert "remedy: call it once in a terminal" in done.stderr and "--no-defaults" in done.stderr
    assert not Path(desk.environment["HOME"], ".local").exists()


def test_an_unused_image_needs_no_question(desk: Desk) -> None:
    project(desk, 'image = "evil"\ncommand = ["evil"]\noptions = ["--no-tz"]\n')
    assert desk.call("ubuntu").returncode == 0 and tail(desk) == ["ubuntu"]


@pytest.mark.parametrize("option", ["--dry-run", "--json", "--export=compose", "--export=devcontainer"])
def test_what_would_run_is_shown_without_a_question(desk: Desk, option: str) -> None:
    """With the file's options, and also if a container of the folder runs."""
    project(desk, f'{IMAGE}command = ["htop"]\noptions = ["--privileged"]\n')
    if option.startswith("--export"):
        desk.engine(containers={"dr": folder_container(desk, "ubuntu")})
    done = desk.call(option)
    assert done.returncode == 0 and "privileged" in done.stdout and "ubuntu" in done.stdout
    assert "wants what you have not allowed: image ubuntu, command htop, --privileged" in done.stderr
    assert ("htop" in done.stdout) == (option != "--export=devcontainer"), "an editor takes no command of a file"


def test_an_image_is_not_looked_into_without_a_question(desk: Desk) -> None:
    """To check it, its own program would list a folder."""
    project(desk, 'image = "ros"\noptions = ["--network", "none"]\n')
    desk.engine(images={"ros": ["ROS_DISTRO=jazzy"]}, answers={"run": "rmw_fastrtps_cpp"})
    done = desk.call("--check")
    assert done.stdout.startswith("problem  network") and not desk.called("run")
    assert "wants what you have not allowed: image ros, --network none" in done.stderr
    assert desk.call("--check", "ros").returncode == 1 and desk.called("run"), "somebody has typed it"


def test_a_folders_name_does_not_reach_the_terminal_as_it_is(desk: Desk) -> None:
    desk.folder = desk.folder / "a\x1b[2K\u202eb"
    desk.folder.mkdir()
    project(desk, IMAGE)
    screen = desk.on_a_terminal("--no-name", keys=b"n\n")[1]
    assert b"a\\x1b[2K\\u202eb/.rosml.toml wants:" in screen and b"\x1b[2K" not in screen


LINKED = [
    *("-v ./x:/x", "-v ./deep/x/in:/x", "-v .x:/x", "-v ./there:/x:O,upperdir={here}/x,workdir=/w"),
    *("--mount type=bind,src=x,dst=/x", "--mount TYPE=Bind,Source=x,dst=/x"),
    "--mount type=volume,dst=/x,volume-opt=type=none,volume-opt=o=bind,volume-opt=device={here}/x",
    *("--env-file x", "--label-file=x", "--cidfile x", "--pidfile x", "--init-path x", "--cert-dir x"),
    *("--decryption-key=x:secret", "--security-opt seccomp=x", "--log-opt path=x", "--network ns:x", "--pid=ns:x"),
    *("--runtime ./x", "--device {here}/x", "--device={here}/x:/dev/x:r"),
]


def of_project(folder: Path) -> File:
    file = defaults.files({}, str(folder), (), ()).project
    assert file
    return file


@pytest.mark.parametrize("option", LINKED)
def test_the_target_of_a_link_is_what_somebody_allows(option: str, tmp_path: Path) -> None:
    """Somebody allows a folder of the project. Then a commit makes it a link; the file stays byte for byte."""
    here, secret = tmp_path / "dr", tmp_path / "secret"
    (secret / "in").mkdir(parents=True)
    (here / "there/in").mkdir(parents=True)
    (here / "deep").mkdir()
    (here / ".rosml.toml").write_text(f"options = {json.dumps(shlex.split(option.format(here=here)))}")
    digests = []
    for target in (here / "there", secret):
        for place in ("x", ".x", "deep/x"):
            (here / place).unlink(missing_ok=True)
            (here / place).symlink_to(target)
        file = of_project(here)
        (item,) = [item for item in consent.questionable(file.line, True, file.leads, str(here)) if "a link to" in item]
        assert f"a link to {target}" in item and ("outside the project" in item) == (target == secret)
        assert str(target) in file.line.engine[-1].words[-1], "the engine gets what is asked about"
        digests.append(consent.digest(file))
    assert digests[0] != digests[1] == consent.digest(of_project(here))


@pytest.mark.parametrize(
    "option", ["--env-file", "--label-file", "--authfile", "--cert-dir", "--security-opt=seccomp=", "--runtime=./"]
)
def test_the_content_of_a_file_is_what_somebody_allows(tmp_path: Path, option: str) -> None:
    read = tmp_path / "read"
    if option == "--cert-dir":
        read.mkdir()
    words = [f"{option}read"] if option[-1] in "=/" else [option, "read"]
    (tmp_path / ".rosml.toml").write_text(f"options = {json.dumps(words)}")
    content, digests = read / "ca.crt" if read.is_dir() else read, [consent.digest(of_project(tmp_path))]
    for text in ("A=b", "LD_PRELOAD=/x"):
        content.write_text(text)
        digests.append(consent.digest(of_project(tmp_path)))
    assert len({*digests}) == 3 and consent.digest(of_project(tmp_path)) == digests[-1]


def test_a_file_that_changes_during_the_question_needs_another(desk: Desk) -> None:
    (desk.folder / "x").write_text("A=b")
    project(desk, f'{IMAGE}options = ["--no-name", "--env-file", "x"]')
    change = "open('x', 'w').write('LD_PRELOAD=/x')"
    code = f"from rosml.cli.run import questions; questions.agreed = lambda *_: bool([exec({change!r})])"
    argv = desk.argv()
    argv[2] = f"{code}\nquestions.possible = lambda: True\n{argv[2]}"
    subprocess.run(argv, cwd=desk.folder, env=desk.environment, check=True)
    assert json.loads(desk.memory.read_text()) and (desk.folder / "x").read_text() == "LD_PRELOAD=/x"
    assert question(desk)


def test_a_pipe_is_nothing_that_somebody_can_allow(desk: Desk) -> None:
    """Whoever writes into it decides each time what is in it. /dev/zero has no end."""
    os.mkfifo(desk.folder / "x")
    for name, path in (("x", desk.folder / "x"), ("/dev/zero", "/dev/zero")):
        project(desk, f'{IMAGE}options = ["--env-file", "{name}"]')
        done = desk.call()
        assert done.returncode == 125 and f"error: {path}: it is no file\nremedy: " in done.stderr
    project(desk, f'{IMAGE}options = ["--mount", "type=glob,src=/x/*,dst=/x"]')
    assert "--mount type=glob: what it finds may change\nremedy: " in desk.call().stderr


def test_links_of_udev_do_not_count(monkeypatch: pytest.MonkeyPatch) -> None:
    """They change whenever somebody plugs something in. A link in /dev/shm is anybody's."""
    places = {"/dev/serial/by-id/camera": "/dev/ttyUSB0", "/dev/shm/x": "/dev/sda", "/dev/fd": "/proc/self/fd"}
    monkeypatch.setattr("os.path.realpath", lambda path: places.get(path, path))
    monkeypatch.setattr("os.lstat", lambda path: SimpleNamespace(st_uid=0, st_dev=int("shm" in path)))
    options = split([word for place in places for word in ("--device", place)], ()).engine
    targets = [paths.followed(option)[0].value for option in options]
    assert targets == ["/dev/serial/by-id/camera", "/dev/sda:/dev/shm/x", "/proc/self/fd:/dev/fd"]
