"""Defaults of `rosml run`: which files count, what wins, and what a project's file gets only from somebody who allows it."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
from pathlib import Path
from types import SimpleNamespace

import pytest
from conftest import ROOT
from test_run_attach import facts

from fakes.desks import OTHER, USER, Desk
from rosml.base.errors import RosmlError
from rosml.run import consent, defaults, host, paths, words
from rosml.run.defaults import File, Files
from rosml.run.plugins.discovery import BUILT_IN
from rosml.run.words import split
from tests.pages import blocks

IMAGE = 'image = "ubuntu"\n'


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    """A desk with docker, which has the images `ubuntu` and `ours`."""
    made = Desk(tmp_path)
    made.engine()
    return made


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
    """What a container got, after what rosml itself adds."""
    (at,) = [at for at, word in enumerate(desk.ran) if desk.ran[at : at + len(USER)] == USER]
    rest = desk.ran[at + len(USER) :]
    return rest[2:] if any(word.startswith("TZ=") for word in rest[1:2]) else rest


# ---- What counts -----------------------------------------------------------------------------------------------------


def test_the_command_line_wins_over_the_project_and_that_over_the_person(desk: Desk) -> None:
    person(desk, 'image = "ours"\ncommand = ["htop"]\noptions = ["-e", "A=1", "--no-rm", "-v", "./x:/x"]\n')
    project(desk, 'options = ["-e", "ROS_DOMAIN_ID=2", "--no-tz"]\n')
    assert desk.call("-e", "A=3", "ubuntu").returncode == 0
    config = Path(desk.environment["HOME"], ".config/rosml")
    assert tail(desk) == ["-v", f"{config}/x:/x", "-e", "ROS_DOMAIN_ID=2", "-e", "A=3", "ubuntu"]
    assert "--rm" not in desk.ran


def test_a_file_names_the_image_and_its_command(desk: Desk) -> None:
    person(desk, f'{IMAGE}command = ["echo", "a  b"]\n')
    assert desk.call().returncode == 0 and tail(desk) == ["ubuntu", "echo", "a  b"]


@pytest.mark.parametrize("words", [[".", "ls", "-l"], ["--new", ".", "ls", "-l"]])
def test_a_point_is_the_image_of_the_file(desk: Desk, words: list[str]) -> None:
    person(desk, f'{IMAGE}command = ["htop"]\n')
    assert desk.call(*words).returncode == 0 and tail(desk) == ["ubuntu", "ls", "-l"]


def test_an_image_is_typed(desk: Desk) -> None:
    """The file's command belongs to the file's image."""
    person(desk, 'image = "ours"\ncommand = ["htop"]\n')
    assert desk.call("ubuntu").returncode == 0 and tail(desk) == ["ubuntu"]


def test_a_command_belongs_to_the_image_of_its_own_file(desk: Desk) -> None:
    person(desk, 'image = "ours"\ncommand = ["htop"]\noptions = ["-v", "/srv/old:/data"]\n')
    project(desk, f'{IMAGE}options = ["-v", "./bags:/data"]\n')
    assert shlex.split(desk.call("--dry-run").stdout)[-3:] == ["-v", f"{desk.folder}/bags:/data", "ubuntu"]
    project(desk, 'command = ["echo"]\n')  # of the person's image
    assert shlex.split(desk.call("--dry-run").stdout)[-2:] == ["ours", "echo"]


@pytest.mark.parametrize(
    ("below", "above", "left"),
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
def test_of_two_that_set_one_thing_the_upper_one_counts(below: list[str], above: list[str], left: list[str]) -> None:
    file = File("/p", b"", 0, split([*below], ()))
    for files, typed in (
        (Files(file), split([*above, "x"], ())),
        (Files(file, File("/q", b"", 0, split(above, ()))), split(["x"], ())),
    ):
        words = [word for given in files.under(typed).engine for word in given.words]
        assert words == [*left, *above]


def test_what_comes_from_which_file_is_said(desk: Desk) -> None:
    person(desk, 'image = "ours"\ncommand = ["htop"]\noptions = ["-v", "/srv/old:/data", "--no-tz"]\n')
    project(desk, f'{IMAGE}options = ["-v", "./bags:/data"]\n')
    config, said = f"{desk.environment['HOME']}/.config/rosml", desk.call("--verbose", "--dry-run").stderr.splitlines()
    assert said[:2] == [
        f"from {config}/run.toml: --no-tz",
        f"from {desk.folder}/.rosml.toml: -v {desk.folder}/bags:/data ubuntu",
    ]


def test_the_container_of_the_folder_is_entered_first(desk: Desk) -> None:
    """With what was typed: the container has the file's options already, and `exec` has no -v."""
    project(desk, f'{IMAGE}options = ["-v", "./a:/a"]\ncommand = ["htop"]\n')
    desk.engine(containers={"dr": facts(desk, "ubuntu")})
    assert desk.call("-e", "A=b").returncode == 0
    assert desk.ran == ["docker", "exec", "-e", "A=b", "dr", "bash"]


def test_a_point_enters_the_container_on_a_terminal(desk: Desk) -> None:
    project(desk, f'{IMAGE}options = ["--privileged"]\n')
    desk.engine(containers={"dr": facts(desk, "ubuntu")}, images={"ubuntu": OTHER})
    assert desk.on_a_terminal(".", "ls") == (0, b"")
    assert desk.ran == ["docker", "exec", "-i", "-t", "dr", "ls"]


def test_another_container_gets_no_name_of_a_file(desk: Desk) -> None:
    """Which the one that runs has."""
    person(desk, f'{IMAGE}options = ["--name", "dr"]\n')
    desk.engine(containers={"dr": facts(desk, "ubuntu")})
    assert desk.call("--new").returncode == 0 and desk.ran[1] == "run" and "--name" not in desk.ran


def test_files_are_left_out(desk: Desk) -> None:
    person(desk, "nonsense")
    project(desk, "nonsense")
    assert desk.call("--no-defaults", "ubuntu").returncode == 0 and tail(desk) == ["ubuntu"]


@pytest.mark.parametrize("words", [[], ["."], ["--new"]])
def test_no_image_is_named_anywhere(desk: Desk, words: list[str]) -> None:
    project(desk, 'options = ["--mws"]\n')
    done = desk.call(*words)
    assert done.returncode == 125 and "rosml run" in done.stderr and not desk.called("run")


def test_where_the_projects_file_is_looked_for(tmp_path: Path) -> None:
    """In the nearest folder; not in the home folder, also where a link leads there."""
    home, link = tmp_path / "home", tmp_path / "link"
    deep = home / "robot/src/package"
    deep.mkdir(parents=True)
    link.symlink_to(home)
    (home / ".rosml.toml").touch()
    (tmp_path / ".rosml.toml").touch()
    assert defaults.project_file(str(deep), str(link)) == defaults.project_file(str(home), str(link)) == ""
    (home / "robot/.rosml.toml").touch()
    assert defaults.project_file(str(deep), str(link)) == str(home / "robot/.rosml.toml")
    assert defaults.project_file(str(deep), "/nowhere") == str(home / "robot/.rosml.toml")
    assert defaults.project_file(str(tmp_path), "/nowhere") == str(tmp_path / ".rosml.toml")


def test_the_search_ends_with_the_file_system(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As that of git does: what is mounted may be anybody's, and so may the folder above it."""
    mounted = tmp_path / "mounted/src"
    mounted.mkdir(parents=True)
    (tmp_path / ".rosml.toml").touch()
    assert defaults.project_file(str(mounted), "/nowhere") == str(tmp_path / ".rosml.toml")
    monkeypatch.setattr("rosml.run.defaults._device", lambda folder: int("mounted" in folder))
    assert defaults.project_file(str(mounted), "/nowhere") == ""


def test_a_folder_of_settings_elsewhere(desk: Desk, tmp_path: Path) -> None:
    person(desk, IMAGE).parent.rename(tmp_path / "rosml")
    assert desk.call(XDG_CONFIG_HOME=str(tmp_path)).returncode == 0 and tail(desk) == ["ubuntu"]
    assert desk.call(XDG_CONFIG_HOME="relative").returncode == 125


@pytest.mark.parametrize("variable", ["HOME", "XDG_CONFIG_HOME"])
def test_a_folder_of_settings_in_a_project_is_not_the_persons(desk: Desk, variable: str) -> None:
    """A relative path would lead there, and nobody would be asked."""
    person(desk, IMAGE).parent.parent.rename(desk.folder / ".config")
    assert desk.call(**{variable: "." if variable == "HOME" else ".config"}).returncode == 125
    project(desk, 'options = ["--privileged"]\n')
    assert "wants what you have not allowed" in desk.call("ubuntu", **{variable: "."}).stderr


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ('"-v", "./a:/a"', "-v /p/a:/a"),
        ('"--mount=type=bind,src=a,dst=/a"', "--mount=type=bind,src=/p/a,dst=/a"),
        ('"--env-file", "a.env"', "--env-file /p/a.env"),
        ('"--env-file=~/a.env"', "--env-file=/home/other/a.env"),
        ('"-itv", "..:/a"', "-itv /:/a"),
        ('"-v", ".a:/a"', "-v /p/.a:/a"),
        ('"--security-opt", "seccomp=a.json"', "--security-opt seccomp=/p/a.json"),
        ('"--security-opt=seccomp=unconfined"', "--security-opt=seccomp=unconfined"),
        ('"--hosts-file=none"', "--hosts-file=none"),
        ('"--runtime=runc"', "--runtime=runc"),
    ],
)
def test_relative_paths_are_meant_from_the_files_folder(
    written: str, meant: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / ".rosml.toml").write_text(f"options = [{written}]")
    monkeypatch.setenv("HOME", "/home/other")
    found = defaults.files({}, str(tmp_path), (), ()).project
    assert found
    said = " ".join(word for given in found.line.engine for word in given.words)
    assert said.replace(str(tmp_path.parent), "/").replace(f"/{tmp_path.name}", "p").replace("//", "/") == meant


def test_the_page_shows_what_is_there(tmp_path: Path) -> None:
    """Its example can be read, what it says of it is what would be asked about, and its list is the list."""
    page = (ROOT / "docs/run/defaults.md").read_text()
    (example,) = [block.text for block in blocks(ROOT / "docs/run/defaults.md") if block.title == ".rosml.toml"]
    (tmp_path / ".rosml.toml").write_text(example)
    file = defaults.files({}, str(tmp_path), ["--mws"], ()).project
    assert file
    (question,) = [block.text for block in blocks(ROOT / "docs/run/defaults.md") if " wants:" in block.text]
    items = [item.replace(str(tmp_path), "/home/me/robot") for item in consent.questionable(file.line, trusted=True)]
    assert question.splitlines()[1:-1] == [f"  {item}" for item in items]
    table = page.partition("Only these need no question:")[2].partition("Everything else")[0]
    letters = {f"-{letter}": f"--{long}" for letter, long in words.table().letters.items()}
    listed = {letters.get(word, word) for word in re.findall(r"`(--?[a-z0-9-]+)`", table)}
    assert listed == consent.HARMLESS | {f"--{name}" for name in {*consent.HARMLESS_OF_ENGINE, "env"}}
    variables = {*re.findall("`([A-Z_]+)`", table)}
    assert variables and all(consent.HARMLESS_VARIABLE.fullmatch(f"{name}=x") for name in variables)
    assert variables == {*re.findall("[A-Z_]{4,}", consent.HARMLESS_VARIABLE.pattern)}


# ---- Files that are wrong --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "says", "remedy"),
    [
        ("\nimage = x", ":2: no TOML: invalid value", "correct"),
        ("\n\nimage = ", ":3: no TOML: ", "correct"),
        (f"x = {'[' * 5000}", ": no TOML: ", "correct"),
        ('# a\nimgae = "ubuntu"', ":2: unknown key 'imgae'", "did you mean 'image'?"),
        ("\n[options]\na = 1", ":2: options must be a list of texts", 'write options = ["--mws"'),
        ('options = "--mws"', ":1: options must be a list of texts", "write options = ["),
        ("image = 5", ":1: image must be a text", "write image = "),
        ('command = ["a", 5]', ":1: command must be a list of texts", "write command = ["),
        ('image = "--privileged"', ":1: '--privileged' is no name of an image", "write image = "),
        ('image = ""', ":1: '' is no name of an image", "write image = "),
        ('options = ["--mws",\n"ubuntu"]', ":1: options has 'ubuntu', which is no option", "image = "),
        ('options = ["--", "ubuntu"]', ":1: options has '--', which is no option", "image = "),
        ('options = ["--mws", "--"]', ":1: options has '--', which is no option", "image = "),
        ('options = ["-e"]', ":1: the option -e lacks its value", "write the value"),
        ('options = ["--volum", "x"]', ":1: unknown option --volum", "did you mean --volume?"),
        ('options = ["-e A=b"]', ":1: options has two words in one: '-e A=b'", 'write "-e", "A=b"'),
        ('options = ["--no-rm=1"]', ":1: --no-rm takes no value", "write --no-rm"),
        ('options = ["--dry-run"]', ":1: --dry-run is for the command line alone", "remove it"),
        ('options = ["--check"]', ":1: --check is for the command line alone", "remove it"),
        ('options = ["--export", "compose"]', ":1: --export is for the command line alone", "remove it"),
        ('options = ["--export=compose"]', ":1: --export is for the command line alone", "remove it"),
        ('command = ["\\u001b[2J"]', ":1: command has a character that cannot be shown: '\\x1b'", "remove it"),
        ('options = ["-e", "A=\\u202e"]', ":1: options has a character that cannot be shown: '\\u202e'", "remove it"),
        ("#" * 70000, ": it has more than 64 KiB", "shorten it"),
    ],
)
def test_a_file_that_is_wrong(desk: Desk, text: str, says: str, remedy: str) -> None:
    file = project(desk, text)
    done = desk.call("ubuntu")
    assert (done.returncode, done.stdout) == (125, "") and not desk.calls
    message, advice = done.stderr.splitlines()
    assert message.startswith(f"error: {file}{says}") and advice.startswith("remedy: ") and remedy in advice
    assert "--no-defaults" in advice


def test_what_is_no_file(desk: Desk) -> None:
    def told() -> str:
        done = desk.call("ubuntu")
        assert done.returncode == 125 and done.stderr.count("\n") == 2
        return done.stderr

    file = desk.folder / ".rosml.toml"
    file.mkdir()
    assert f"error: {file}: " in told()
    file.rmdir()
    os.mkfifo(file)
    assert f"error: {file}: it is no file" in told()
    file.unlink()
    file.symlink_to(person(desk, ""))
    assert f"error: {file}: it is a link" in told()
    file.unlink()
    file.write_bytes(b"#\n#\xff")
    assert f"error: {file}:2: not UTF-8 (byte 0xff)" in told()
    file.unlink()
    own = person(desk, "")
    own.unlink()
    own.mkdir()
    assert f"error: {own}: " in told()


# ---- What a project's file gets --------------------------------------------------------------------------------------

HARMLESS = ["--mws", "--mwd", "--no-rm", "--no-gpu", "--no-x11", "--no-ros", "-it", "--rm", "-e ROS_DOMAIN_ID=7"]
HARMLESS += ["--name=x", "-itm 1g", "--shm-size=2g", "--env=RMW_IMPLEMENTATION=rmw_cyclonedds_cpp"]
ASKED = ["--privileged", "--privileged=true", "--device /dev/sda", "--network=host", "--net host", "--pid=host"]
ASKED += ["--ipc host", "--cap-add=ALL", "--security-opt seccomp=unconfined", "-v .:/x", "-v /:/h", "-itv /:/h"]
ASKED += ["-itv/:/h", "--volume=/:/h", "--mount type=bind,src=/,dst=/h", "--userns=host", "--user 0", "-iu0"]
ASKED += ["--env-file x", "-e SECRET", "-eSECRET", "-e LD_PRELOAD=/x", "-e ROS_DOMAIN_ID", "-e 'ROS_DOMAIN_ID=$(id)'"]
ASKED += ["--env=ROS_*", "--gpus all", "--entrypoint x", "-p 80:80", "--label a=b", "--unheard-of=true", "-w /x"]
ASKED += ["-Pit", "-e 'ROS_DOMAIN_ID=7 a'", "-e RMW_IMPLEMENTATION=a/../b"]
ASKED += ["--ros-network", "--no-user", "--sound", "--ssh-agent", "--wayland", "--runtime=x", "--pull=always", "-P"]
OWN = [f"--{name}" for plugin in BUILT_IN for name in plugin.options]


@pytest.mark.parametrize("option", HARMLESS)
def test_what_needs_no_question(option: str) -> None:
    line = split(shlex.split(option), OWN)
    assert consent.questionable(line, trusted=True) == [] and consent.questionable(line, trusted=False) == [option]


@pytest.mark.parametrize("option", ASKED)
def test_what_is_asked_about(option: str) -> None:
    given = shlex.split(option)
    assert consent.questionable(split(given, OWN), trusted=True) == [shlex.join(given)]


def test_whose_file_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("os.geteuid", lambda: 1000)
    assert [defaults.is_own(uid, {"SUDO_UID": "1001"}) for uid in (0, 1000, 1001)] == [True, True, False]
    monkeypatch.setattr("os.geteuid", lambda: 0)
    assert [defaults.is_own(uid, {"SUDO_UID": "1001"}) for uid in (0, 1000, 1001)] == [True, False, True]


def test_what_another_user_writes_down_allows_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where the folder of state is one in which others can write."""
    file, place = defaults.File("/x", b"", 0, split([], ())), tmp_path / "allowed.json"
    place.write_bytes(consent.with_file(file, consent.digest(file), place))
    place.write_bytes(consent.with_repository("ghcr.io/me/x", True, place))
    assert consent.is_allowed(file, consent.digest(file), place) and consent.is_trusted("ghcr.io/me/x", place)
    monkeypatch.setattr("os.geteuid", lambda: place.stat().st_uid + 1)
    assert not consent.is_allowed(file, consent.digest(file), place)
    assert consent.is_trusted("ghcr.io/me/x", place) is None


def test_a_memory_that_a_link_leads_to_allows_nothing(tmp_path: Path) -> None:
    """Where others can write, one of them may put a link there: to a file of the person's that a repository brought."""
    file, cloned, place = (
        defaults.File("/x", b"", 0, split([], ())),
        tmp_path / "cloned.json",
        tmp_path / "allowed.json",
    )
    cloned.write_bytes(consent.with_file(file, consent.digest(file), place))
    place.symlink_to(cloned)
    assert not consent.is_allowed(file, consent.digest(file), place)
    host.write(place, consent.with_file(file, consent.digest(file), place))
    assert consent.is_allowed(file, consent.digest(file), place) and not place.is_symlink()


def test_folders_and_files_of_another_user_do_not_count(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither a folder for the memory, or a link to one, that another user made, nor their settings."""
    place, file = tmp_path / "rosml/allowed.json", defaults.File("/x", b"", 0, split([], ()))
    host.write(place, consent.with_file(file, consent.digest(file), place))
    assert consent.is_allowed(file, consent.digest(file), place)
    with monkeypatch.context() as patch:
        patch.setattr("os.lstat", lambda path: SimpleNamespace(st_uid=os.geteuid() + 1))
        assert not consent.is_allowed(file, consent.digest(file), place)
        with pytest.raises(PermissionError, match="its folder is another user's"):
            host.write(place, b"{}")
    (tmp_path / "rosml/run.toml").write_text(IMAGE)
    monkeypatch.setattr("rosml.run.defaults.is_own", lambda owner, environment: False)
    with pytest.raises(RosmlError, match=r"run\.toml: it belongs to another user"):
        defaults.files({"XDG_CONFIG_HOME": str(tmp_path)}, "/", (), ())


def test_somebody_is_asked_once_for_each_content(desk: Desk) -> None:
    file = project(desk, f'{IMAGE}options = ["--no-name", "--network", "host"]\n')
    code, told = desk.on_a_terminal(keys=b"\n")
    assert code == 125 and f"{file} is not allowed".encode() in told and not desk.called("run")
    code, told = desk.on_a_terminal(keys=b"y\n")
    lines = told.decode().replace("\r", "").splitlines()
    assert code == 0 and lines[lines.index(f"{file} wants:") :][1:3] == ["  image ubuntu", "  --network host"]
    assert tail(desk) == ["--network", "host", "ubuntu"]
    assert desk.on_a_terminal() == (0, b"") and desk.call().returncode == 0, "allowed"
    state = Path(desk.environment["HOME"], ".local/state/rosml/allowed.json")
    assert (state.stat().st_mode & 0o777, state.parent.stat().st_mode & 0o777) == (0o600, 0o700)
    assert [*json.loads(state.read_text())] == [str(file)] and os.listdir(state.parent) == [state.name]
    project(desk, f'{IMAGE}options = ["--no-name", "--privileged"]\n')
    assert desk.call().returncode == 125, "changed"
    assert desk.on_a_terminal(keys=b"y\n")[0] == 0 and desk.call().returncode == 0
    state.write_text("nonsense")
    assert desk.call().returncode == 125, "a damaged file allows nothing"
    assert desk.on_a_terminal(keys=b"yes\n")[0] == 0 and desk.call().returncode == 0


# ---- What its paths lead to ------------------------------------------------------------------------------------------


def asked(desk: Desk) -> str:
    """What somebody is asked about without a terminal; empty if nothing."""
    done = desk.call()
    return done.stderr.partition(" wants what you have not allowed: ")[2].partition("\n")[0]


LINKED = [
    "-v ./x:/x",
    "-v ./deep/x/in:/x",
    "-v .x:/x",
    "--mount type=bind,src=x,dst=/x",
    "--mount TYPE=Bind,Source=x,dst=/x",
    "--mount type=volume,dst=/x,volume-opt=type=none,volume-opt=o=bind,volume-opt=device={here}/x",
    "-v ./there:/x:O,upperdir={here}/x,workdir=/w",
    "--env-file x",
    "--label-file=x",
    "--cidfile x",
    "--pidfile x",
    "--init-path x",
    "--cert-dir x",
    "--decryption-key=x:secret",
    "--security-opt seccomp=x",
    "--log-opt path=x",
    "--network ns:x",
    "--pid=ns:x",
    "--runtime ./x",
    "--device {here}/x",
    "--device={here}/x:/dev/x:r",
]


def of_project(folder: Path) -> defaults.File:
    """A project's file, as it is read for a folder."""
    found = defaults.files({}, str(folder), (), ()).project
    assert found
    return found


@pytest.mark.parametrize("option", LINKED)
def test_what_a_link_leads_to_is_what_somebody_allows(option: str, tmp_path: Path) -> None:
    """The person allows a folder of the project. Then a commit makes it a link; the file stays byte for byte."""
    here, secret = tmp_path / "dr", tmp_path / "secret"
    (secret / "in").mkdir(parents=True)
    (here / "there/in").mkdir(parents=True)
    (here / "deep").mkdir()
    (here / ".rosml.toml").write_text(f"options = {json.dumps(shlex.split(option.format(here=here)))}")
    seen = []
    for target in (here / "there", secret):
        for place in ("x", ".x", "deep/x"):
            (here / place).unlink(missing_ok=True)
            (here / place).symlink_to(target)
        file = of_project(here)
        said = [item for item in consent.questionable(file.line, True, file.leads, str(here)) if "a link to" in item]
        assert len(said) == 1 and f"a link to {target}" in said[0]
        assert ("outside the project" in said[0]) == (target == secret)
        assert str(target) in file.line.engine[-1].words[-1], "the engine gets what is asked about"
        seen.append(consent.digest(file))
    assert seen[0] != seen[1] == consent.digest(of_project(here))


def test_a_link_that_leads_elsewhere_later_is_asked_about(desk: Desk, tmp_path: Path) -> None:
    bags = desk.folder / "bags"
    bags.mkdir()
    project(desk, f'{IMAGE}options = ["--no-name", "-v", "./bags:/bags"]')
    assert desk.on_a_terminal(keys=b"y\n")[0] == 0 and asked(desk) == ""
    bags.rmdir()
    bags.symlink_to(tmp_path)
    assert f"{bags}, a link to {tmp_path}, outside the project" in asked(desk)
    started = len([call for call in desk.calls if call[1] == "run"])
    assert desk.on_a_terminal(keys=b"n\n")[0] == 125
    assert len([call for call in desk.calls if call[1] == "run"]) == started


def test_the_engine_gets_what_was_checked(desk: Desk, tmp_path: Path) -> None:
    """A link that changes between the question and the engine leads nowhere else; people see where it leads."""
    (tmp_path / "root").mkdir(exist_ok=True)
    (desk.folder / "bags").symlink_to(tmp_path / "root")
    (desk.folder / "maps").mkdir()
    (desk.folder / "more").symlink_to("maps")
    file = project(
        desk, f'{IMAGE}options = ["--no-name", "-v", "./bags:/bags", "-v", "./maps:/maps", "-v", "./more:/m:ro"]'
    )
    told = desk.on_a_terminal(keys=b"y\n")[1].decode().replace("\r", "").splitlines()
    assert told[told.index(f"{file} wants:") + 2 :][:3] == [
        f"  -v {tmp_path}/root:/bags ({desk.folder}/bags, a link to {tmp_path}/root, outside the project)",
        f"  -v {desk.folder}/maps:/maps",
        f"  -v {desk.folder}/maps:/m:ro ({desk.folder}/more, a link to {desk.folder}/maps)",
    ]
    assert [word.partition(":")[0] for word in desk.ran if word.startswith(str(tmp_path)) and ":/" in word] == [
        f"{tmp_path}/root",
        f"{desk.folder}/maps",
        f"{desk.folder}/maps",
    ]


@pytest.mark.parametrize(
    "option",
    ["--env-file", "--label-file", "--authfile", "--cert-dir", "--security-opt=seccomp=", "--runtime=./"],
)
def test_what_is_in_a_file_is_what_somebody_allows(tmp_path: Path, option: str) -> None:
    read = tmp_path / "read"
    if option == "--cert-dir":
        read.mkdir()
    words = [f"{option}read"] if option[-1] in "=/" else [option, "read"]
    (tmp_path / ".rosml.toml").write_text(f"options = {json.dumps(words)}")
    content, seen = read / "ca.crt" if read.is_dir() else read, [consent.digest(of_project(tmp_path))]
    for text in ("A=b", "LD_PRELOAD=/x"):
        content.write_text(text)
        seen.append(consent.digest(of_project(tmp_path)))
    assert len({*seen}) == 3 and consent.digest(of_project(tmp_path)) == seen[-1]


def test_a_file_of_variables_that_changes_later_is_asked_about(desk: Desk) -> None:
    """A variable such as LD_PRELOAD comes with a later commit."""
    (desk.folder / "robot.env").write_text("A=b")
    project(desk, f'{IMAGE}options = ["--no-name", "--env-file", "robot.env"]')
    assert desk.on_a_terminal(keys=b"y\n")[0] == 0 and asked(desk) == ""
    (desk.folder / "robot.env").write_text("LD_PRELOAD=/x")
    assert asked(desk)


def test_what_somebody_sees_is_what_they_allow(desk: Desk) -> None:
    """A file that changes while they read the question is asked about again."""
    (desk.folder / "x").write_text("A=b")
    project(desk, f'{IMAGE}options = ["--no-name", "--env-file", "x"]')
    change = "open('x', 'w').write('LD_PRELOAD=/x')"
    code = f"from rosml.cli.run import question; question.agreed = lambda *_: bool([exec({change!r})])"
    argv = desk.argv()
    argv[2] = f"{code}\nquestion.possible = lambda: True\n{argv[2]}"
    subprocess.run(argv, cwd=desk.folder, env=desk.environment, check=True)
    assert json.loads(desk.memory.read_text()) and (desk.folder / "x").read_text() == "LD_PRELOAD=/x"
    assert asked(desk)


def test_a_pipe_is_nothing_that_somebody_can_allow(desk: Desk) -> None:
    """Whoever writes into it decides each time what is in it; nobody waits for them. /dev/zero has no end."""
    os.mkfifo(desk.folder / "x")
    for name, path in (("x", desk.folder / "x"), ("/dev/zero", "/dev/zero")):
        project(desk, f'{IMAGE}options = ["--env-file", "{name}"]')
        done = desk.call()
        assert done.returncode == 125 and f"error: {path}: it is no file\nremedy: " in done.stderr
        assert desk.call("--no-defaults", "--dry-run", "--env-file", str(path), "ubuntu").returncode == 0
    project(desk, f'{IMAGE}options = ["--mount", "type=glob,src=/x/*,dst=/x"]')
    done = desk.call()
    assert done.returncode == 125 and "--mount type=glob: what it finds may change\nremedy: " in done.stderr


def test_links_of_udev_do_not_count(monkeypatch: pytest.MonkeyPatch) -> None:
    """They change whenever somebody plugs something in. A link in /dev/shm is anybody's."""
    places = {"/dev/serial/by-id/camera": "/dev/ttyUSB0", "/dev/shm/x": "/dev/sda", "/dev/fd": "/proc/self/fd"}
    monkeypatch.setattr("os.path.realpath", lambda path: places.get(path, path))
    monkeypatch.setattr("os.lstat", lambda path: SimpleNamespace(st_uid=0, st_dev=int("shm" in path)))

    def led(place: str) -> str:
        (option,) = split(["--device", place, "x"], ()).engine
        return str(paths.followed(option)[0].value)

    assert led("/dev/serial/by-id/camera") == "/dev/serial/by-id/camera" and led("nvidia.com/gpu=all")
    assert (led("/dev/shm/x"), led("/dev/fd")) == ("/dev/sda:/dev/shm/x", "/proc/self/fd:/dev/fd")


def test_another_folder_is_asked_about_as_well(desk: Desk) -> None:
    project(desk, IMAGE)
    assert desk.on_a_terminal("--no-name", keys=b"y\n")[0] == 0
    desk.folder = desk.folder.with_name("other")
    desk.folder.mkdir()
    project(desk, IMAGE)
    assert desk.call().returncode == 125


@pytest.mark.parametrize("text", [IMAGE, 'options = ["-v", "/:/host"]\n', 'command = ["sh"]\n'])
def test_without_a_terminal_nothing_is_allowed(desk: Desk, text: str) -> None:
    person(desk, IMAGE)
    file = project(desk, text)
    done = desk.call()
    assert (done.returncode, done.stdout) == (125, "") and not desk.called("run") and not desk.called("pull")
    assert f"error: {file} wants what you have not allowed: " in done.stderr
    assert "remedy: call it once in a terminal" in done.stderr and "--no-defaults" in done.stderr
    assert not Path(desk.environment["HOME"], ".local").exists()


def test_an_image_that_is_not_used_is_not_asked_about(desk: Desk) -> None:
    project(desk, 'image = "evil"\ncommand = ["evil"]\noptions = ["--no-tz"]\n')
    assert desk.call("ubuntu").returncode == 0 and tail(desk) == ["ubuntu"]


@pytest.mark.parametrize("option", ["--dry-run", "--json", "--export=compose", "--export=devcontainer"])
def test_what_would_run_is_shown_without_a_question(desk: Desk, option: str) -> None:
    """With the file's options, and also where a container of the folder runs."""
    project(desk, f'{IMAGE}options = ["--privileged"]\n')
    if option.startswith("--export"):
        desk.engine(containers={"dr": facts(desk, "ubuntu")})
    done = desk.call(option)
    assert done.returncode == 0 and "privileged" in done.stdout and "ubuntu" in done.stdout
    assert "wants what you have not allowed: image ubuntu, --privileged\nremedy: rosml run will ask" in done.stderr


def test_an_editor_takes_no_command_of_a_file(desk: Desk) -> None:
    project(desk, f'{IMAGE}command = ["htop"]\noptions = ["-v", "./bags:/bags"]\n')
    done = desk.call("--export=devcontainer")
    assert done.returncode == 0 and "${localWorkspaceFolder}/bags:/bags" in done.stdout and "htop" not in done.stdout
    assert desk.call("--export=devcontainer", ".", "htop").returncode == 125


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
    told = desk.on_a_terminal("--no-name", keys=b"n\n")[1]
    assert b"a\\x1b[2K\\u202eb/.rosml.toml wants:" in told and b"\x1b[2K" not in told


def test_an_answer_that_cannot_be_kept(desk: Desk) -> None:
    Path(desk.environment["HOME"], ".local").touch()
    project(desk, IMAGE)
    code, told = desk.on_a_terminal("--no-name", keys=b"y\n")
    assert code == 0 and b"allowed.json: Not a directory" in told and b"asks each time" in told
