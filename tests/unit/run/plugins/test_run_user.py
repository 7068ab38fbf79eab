"""The user in the container, and the options of every container: removal, name, time zone, locale, mounts."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

from fakes.desks import BARE, LOCKED, OTHER, OURS
from fakes.exports import ROSML_OPTIONS
from rosml.base.errors import RosmlError
from rosml.run import host
from rosml.run.context import Context, Engine, Image, Person
from rosml.run.paths import bind, resolved
from rosml.run.plan import make_plan
from rosml.run.plugins import basic_options
from rosml.run.plugins.user import NAME
from rosml.run.words import split

PERSON = Person(1234, 5678, "jo", "/home/jo/robot", "Europe/Berlin", {"LANG": "de_DE.UTF-8", "LC_TIME": "C"})
ROOT_USER = Person(0, 0, "root", "/")
DOCKER, PODMAN = Engine(), Engine("podman", podman=True)
ROOTLESS_DOCKER, ROOTLESS_PODMAN = Engine(rootless=True), Engine("podman", podman=True, rootless=True)
IDS = ["--user", "1234:5678", "-e", "HOME=/tmp", "-e", "USER=jo", "-e", "LOGNAME=jo"]
CONTRACT = ["-e", "DOCKER_UID=1234", "-e", "DOCKER_GID=5678", "-e", "DOCKER_USER=jo"]
PODMANS_IDS = [*IDS[:2], "--passwd-entry=jo:*:1234:5678::/tmp:/bin/sh", *IDS[2:]]
PODMANS_ROOT = ["--userns=keep-id", "--user", "0:0", "--passwd=false"]


def added(
    *words: str,
    image: list[str] = OURS,
    engine: Engine = DOCKER,
    caller: Person = PERSON,
    trusted: bool = True,
    **facts: Any,
) -> list[str]:
    """The options of rosml for somebody who is not root, and who trusts the image, without the label."""
    variables = dict(entry.partition("=")[::2] for entry in image)
    line = split([*words, "reg.test/me/ros:jazzy"], ROSML_OPTIONS)
    context = Context(line, engine, caller, Image(environment=variables, **facts), BARE, trusted)
    argv = [*make_plan(context).argv]
    assert argv[:2] == [engine.program, "run"]
    options = argv[2 : len(argv) - 1 - sum(len(option.words) for option in line.engine)]
    at = options.index("--label")
    return options[:at] + options[at + 2 :]


def user_options(*words: str, **facts: Any) -> list[str]:
    return added("--no-rm", "--no-tz", "--no-name", "--no-it", *words, **facts)


@pytest.mark.parametrize(
    ("engine", "image", "expected"),
    [
        (DOCKER, OURS, CONTRACT),
        (DOCKER, OTHER, [*IDS, *LOCKED]),
        (ROOTLESS_DOCKER, OURS, []),
        (ROOTLESS_DOCKER, OTHER, ["--user", "0:0"]),
        (PODMAN, OURS, CONTRACT),
        (PODMAN, OTHER, [*PODMANS_IDS, *LOCKED]),
        (ROOTLESS_PODMAN, OURS, [*PODMANS_ROOT, *CONTRACT]),
        (ROOTLESS_PODMAN, OTHER, ["--userns=keep-id", *PODMANS_IDS]),
    ],
)
def test_files_belong_to_whoever_calls(engine: Engine, image: list[str], expected: list[str]) -> None:
    assert user_options(engine=engine, image=image) == expected


@pytest.mark.parametrize(
    ("engine", "expected"),
    [
        (DOCKER, ["--user", "0:0", *CONTRACT]),
        (ROOTLESS_DOCKER, ["--user", "0:0"]),
        (ROOTLESS_PODMAN, [*PODMANS_ROOT, *CONTRACT]),
    ],
)
def test_an_image_that_starts_as_another_user_is_started_as_root(engine: Engine, expected: list[str]) -> None:
    """Its entrypoint needs root to make the user. Without trust it does not get it."""
    assert user_options(engine=engine, user="vendor") == expected
    assert user_options(engine=engine, user="root:root") == user_options(engine=engine)
    if not engine.rootless:
        assert user_options(engine=engine, user="vendor", trusted=False) == [*IDS, *LOCKED]


def test_an_image_does_not_vouch_for_itself() -> None:
    """Whoever builds an image may write DOCKER_UID into it. Without the user's trust it runs as any other image."""
    for engine in (DOCKER, PODMAN):
        assert user_options(engine=engine, trusted=False) == user_options(engine=engine, image=OTHER)
    for engine in (ROOTLESS_DOCKER, ROOTLESS_PODMAN):  # root there is no other user
        assert user_options(engine=engine, trusted=False) == user_options(engine=engine)


@pytest.mark.parametrize(
    ("value", "locked"), [("no-new-privileges", []), ("no-new-privileges=false", []), ("seccomp=x", LOCKED)]
)
def test_the_user_chooses_new_privileges(value: str, locked: list[str]) -> None:
    assert user_options("--security-opt", value, trusted=False) == [*IDS, *locked]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["--user", "7"], []),
        (["--entrypoint", "bash"], [*IDS, *LOCKED]),  # nothing reads DOCKER_UID then
        (["--userns=host"], CONTRACT),
        (["-e", "DOCKER_UID=7"], CONTRACT),  # theirs comes later, and counts
    ],
)
def test_the_user_chooses_who_runs(words: list[str], expected: list[str]) -> None:
    assert user_options(*words) == expected
    assert user_options(*words, "--no-user") == user_options("--userns=host", engine=ROOTLESS_PODMAN) == []


def passwd_options(*words: str, engine: Engine = ROOTLESS_PODMAN, **facts: Any) -> list[str]:
    return [word for word in user_options(*words, engine=engine, **facts) if word.startswith("--passwd")]


@pytest.mark.parametrize("option", ["--mwd", "--mws"])
def test_the_mounted_folder_is_no_home(option: str) -> None:
    """podman writes an entry for a user whom the image lacks, and takes the working directory for the home there."""
    ours, other = [*OURS, "WORKSPACE=/ws"], [*OTHER, "WORKSPACE=/ws"]
    assert passwd_options(option, image=ours) == ["--passwd=false"]
    for engine in (PODMAN, ROOTLESS_PODMAN):
        assert passwd_options(option, image=other, engine=engine) == ["--passwd-entry=jo:*:1234:5678::/tmp:/bin/sh"]
    for engine in (DOCKER, ROOTLESS_DOCKER):
        assert passwd_options(option, image=ours, engine=engine) == []


@pytest.mark.parametrize("option", ["--user=7", "--no-user", "--userns=keep-id"])
def test_a_chosen_user_has_no_home_in_the_mounted_folder(option: str) -> None:
    assert passwd_options("--mwd", option) == ["--passwd=false"]
    assert passwd_options(option) == passwd_options("--mwd", option, "--hostuser=jo") == []


def test_users_without_a_name_and_root() -> None:
    nameless = replace(PERSON, name="")
    assert passwd_options(image=OTHER, caller=nameless) == ["--passwd-entry=1234:*:1234:5678::/tmp:/bin/sh"]
    assert passwd_options(image=OTHER, caller=ROOT_USER) == []
    assert user_options(caller=ROOT_USER, image=OTHER) == ["--user", "0:0"]


@pytest.mark.parametrize("name", ["", "DOMAIN\\jo", "jo smith", "1jo", "x" * 33, "backup", "www-data"])
def test_a_name_that_the_image_would_refuse(name: str) -> None:
    assert user_options(caller=replace(PERSON, name=name)) == CONTRACT[:4]


def test_the_entrypoint_takes_the_same_names() -> None:
    assert f"^{NAME.pattern}$" in (ROOT / "components/base/entrypoint.sh").read_text()


@pytest.mark.parametrize(
    ("words", "selinux", "expected"),
    [
        (["--mws"], True, True),
        (["--mws"], False, False),
        ([], True, False),
        (["-v", "/a:/b:z"], True, False),
        (["--mws", "--security-opt", "label=type:container_runtime_t"], True, False),
        (["--mws", "--privileged"], True, False),
    ],
)
def test_selinux_lets_a_container_read_mounts_of_rosml(words: list[str], selinux: bool, expected: bool) -> None:
    assert ("label=disable" in user_options(*words, engine=replace(ROOTLESS_PODMAN, selinux=selinux))) == expected


def test_the_options_by_default() -> None:
    assert added() == ["--rm", *CONTRACT, "-e", "TZ=Europe/Berlin"]
    terminal = replace(PERSON, terminal=True, reads=True)
    assert added("--no-name", "--no-rm", "--no-it", "--no-tz", "--no-user", caller=terminal) == []
    assert added("--loc")[-4:] == ["-e", "LANG=de_DE.UTF-8", "-e", "LC_TIME=C"]


def test_time_to_save_when_it_is_stopped() -> None:
    """In an image of ours with its own entrypoint, a stop reaches all programs."""
    label = {"io.rosml.component": "base"}
    assert added("--no-rm", "--no-tz", "--no-user", labels=label) == ["--stop-timeout", "30"]
    for words in (["--stop-timeout", "5"], ["--entrypoint", "bash"]):
        assert "30" not in added(*words, labels=label)
    assert "30" not in added() and "30" not in added(labels=label, image=OTHER)


@pytest.mark.parametrize("words", [["--rm"], ["--restart=always"], ["--rmi"], ["--rm=false"]])
def test_what_goes_with_no_removal(words: list[str]) -> None:
    assert "--rm" not in added(*words) and added("--restart-not=x")[0] == "--rm"


@pytest.mark.parametrize(
    ("folder", "image", "name"),
    [
        ("/home/jo/robot", "ros", "robot"),
        ("/home/jo/my robot (2)", "ros", "my-robot-2"),
        ("/", "reg.test:5000/me/ros:jazzy", "ros-jazzy"),
        ("/x", "ros@sha256:" + "0" * 64, "ros"),
        ("/机器人", "ubuntu", "ubuntu"),
        ("/", "x", ""),
    ],
)
def test_the_containers_name(folder: str, image: str, name: str) -> None:
    def name_of(*words: str, terminal: bool = True) -> str:
        return basic_options.name_of(
            split([*words, image], ROSML_OPTIONS), Person(0, 0, "root", folder, terminal=terminal)
        )

    assert (name_of(), name_of("--name", "mine")) == (name, "mine")
    assert name_of("--no-name") == name_of("--new") == name_of(terminal=False) == ""


def test_the_time_zone(tmp_path: Path) -> None:
    def zone(text: str = "") -> str:
        return host.timezone({"TZ": text} if text else {}, tmp_path)

    assert zone() == ""
    (tmp_path / "timezone").write_text("Asia/Tokyo\n")
    assert zone() == "Asia/Tokyo"
    (tmp_path / "localtime").symlink_to("/usr/share/zoneinfo/Europe/Berlin")
    assert zone() == zone(":/etc/localtime") == zone("/somewhere") == "Europe/Berlin"
    assert zone("America/New_York") == zone(":/usr/share/zoneinfo/America/New_York") == "America/New_York"
    (tmp_path / "localtime").unlink()
    (tmp_path / "timezone").write_bytes(b"\xff")
    assert zone() == "" and "TZ=Europe/Berlin" not in added("--tz=local")


def test_the_current_folder_is_mounted() -> None:
    here = "/home/jo/robot"
    mounts = ["--mount", f"type=bind,source={here},target={here}", "--workdir", here]
    mounts += ["--mount", f"type=bind,source={here},target=/docker-ros/ws/src/target"]
    assert added("--mwd", "--mws")[-6:] == mounts
    with pytest.raises(RosmlError, match="has no workspace"):
        added("--mws", image=OTHER)


@pytest.mark.parametrize(
    ("typed", "expected"),
    [
        ("-v .:/ws", "-v /home/jo:/ws"),
        ("-v ..:/ws:ro", "-v /home:/ws:ro"),
        ("-v a/b:/ws", "-v /home/jo/a/b:/ws"),
        *((typed, typed) for typed in ("-v /a/../b:/ws", "-v name:/ws", "-v /ws", "-v ./ws")),
        ("-itv./a:/b", "-itv/home/jo/a:/b"),
        ("--volume=~/a:/b", "--volume=/home/other/a:/b"),
        ("--mount type=bind,source=a,target=/b", "--mount type=bind,source=/home/jo/a,target=/b"),
        *((f"--mount {value}", f"--mount {value}") for value in ("type=bind,src=/a", "type=volume,src=a", "src=a")),
        *((typed, typed) for typed in ('--mount "type=bind', "--env-file ./a", "-e A=./a:/b", "--workdir ./a:/b")),
    ],
)
def test_relative_folders(typed: str, expected: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", "/home/other")
    (option,) = split([*typed.split(), "image"], ()).engine
    assert " ".join(resolved(option, "/home/jo").words) == expected


def test_odd_paths_in_a_mount() -> None:
    assert bind("/a:b", "/c") == "type=bind,source=/a:b,target=/c"
    assert bind('/a,"b"', "/c d") == 'type=bind,"source=/a,""b""",target=/c d'
    (option,) = split(["--mount", 'type=bind,"source=a,b",target=/c', "image"], ()).engine
    assert resolved(option, "/x").value == 'type=bind,"source=/x/a,b",target=/c'
