"""Which images `rosml run` starts as root: those of repositories that the user trusts, by name."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

from fakes.desks import DOCKER, LOCKED, OTHER, OURS, PODMAN, ROOTLESS, Desk
from rosml.run import trust

JO = ["--user", "1234:1234", "-e", "HOME=/tmp", "-e", "USER=jo", "-e", "LOGNAME=jo", *LOCKED]
CONTRACT = ["-e", "DOCKER_UID=1234", "-e", "DOCKER_GID=1234", "-e", "DOCKER_USER=jo"]
REMEDY = "remedy: --trust trusts all images of that repository from now on\n"
EVIL = "ghcr.io/evil/robot"


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    desk = Desk(tmp_path)
    desk.environment["DESK_UID"] = "1234"
    desk.engine(images={"ours": OURS, "ubuntu": OTHER, EVIL: OURS, f"{EVIL}:2": OURS})
    return desk


def runs_as(desk: Desk) -> list[str]:
    """The options of whoever runs in the container that was started last."""
    started = [call for call in desk.calls if call[1] == "run"][-1]
    (options,) = [options for options in (JO, CONTRACT) if options[1] in started]
    at = started.index(options[0], 4)
    assert started[at : at + len(options)] == options
    return options


def remembered(desk: Desk) -> Any:
    """The memory's content; None if there is none."""
    return json.loads(desk.memory.read_text()) if desk.memory.exists() else None


@pytest.mark.parametrize(
    ("name", "repository"),
    [
        *((name, "docker.io/library/ros") for name in ("ros", "ros:jazzy", "docker.io/ros", "index.docker.io/library/ros")),
        (f"ros@sha256:{'a' * 64}", "docker.io/library/ros"),
        ("me/ros:jazzy", "docker.io/me/ros"),
        ("ghcr.io/me/rosml/ros:jazzy-base", "ghcr.io/me/rosml/ros"),
        ("GHCR.IO/me/rosml", "GHCR.IO/me/rosml"),
        ("localhost:5000/ros:5000", "localhost:5000/ros"),
        ("[::1]:5000/rosml/x", "[::1]:5000/rosml/x"),
        ("[1]/x", "sha256:0123abcd"),
        ("ghcr.io.evil.com/me/rosml", "ghcr.io.evil.com/me/rosml"),
        # What an engine would not take, and other ways to name an image, stand for themselves:
        *((name, "sha256:0123abcd") for name in ("evil/x:ghcr.io/me/rosml", "x@ghcr.io/me/rosml", "ghcr.io/me/rosml\n")),
        *((name, "sha256:0123abcd") for name in ("ghcr.io//me", "/ros", "../ros", "ghcr.io/me/../ros", "ghcr.io/me/Ros")),
        *((name, "sha256:0123abcd") for name in ("docker://ghcr.io/me/ros", "oci:a/b", "rös", "ghcr.io/me/ros:", "evil ros")),
        *((name, "sha256:0123abcd") for name in ("sha256:0123abcd", "0123", "sha256:01")),
        ("cafe", "docker.io/library/cafe"),  # the image has another id
    ],
)  # fmt: skip
def test_the_repository_of_a_name(name: str, repository: str) -> None:
    assert trust.repository(name, "0123abcd", podman=False) == repository
    assert trust.repository("evil/x", "0123abcd", podman=False) != repository


def test_podman_looks_up_short_names_by_its_own_settings() -> None:
    assert trust.repository("ros:jazzy", "0", podman=True) == "ros"
    assert trust.repository("docker.io/ros", "0", podman=True) == "docker.io/library/ros"
    assert trust.repository("oci:ros", "0", podman=True) == "sha256:0", "the image in a folder"


def test_the_local_registry_of_a_checkout(tmp_path: Path) -> None:
    (tmp_path / "services.json").write_text(json.dumps({"registry": "127.0.0.1:5000"}))
    registry = trust.local_registry(tmp_path)
    assert trust.is_local("127.0.0.1:5000/rosml/ros", registry)
    for name in (
        "127.0.0.1:5000/rosml-evil/x",
        "127.0.0.1:50000/rosml/ros",
        "evil.com/127.0.0.1:5000/rosml/ros",
        "rosml/ros",
    ):
        assert not trust.is_local(trust.repository(name, "0", podman=False), registry)
    for content in (b"[]", b'{"registry": 5}', b"\xff", b"[" * 9999):
        (tmp_path / "services.json").write_bytes(content)
        assert trust.local_registry(tmp_path) == "" and not trust.is_local("docker.io/rosml/x", "")


def test_a_checkout_trusts_what_it_builds(desk: Desk, tmp_path: Path) -> None:
    """The installed command trusts nothing by itself, also in the folder of a checkout."""
    local, evil = "127.0.0.1:5000/rosml/ros:jazzy-base", "127.0.0.1:5000/rosml-evil/x"
    desk.engine(images={local: OURS, evil: OURS})
    checkout, installed = tmp_path / "checkout", tmp_path / "installed"
    for place in (checkout / "src", installed):
        shutil.copytree(ROOT / "src/rosml", place / "rosml", ignore=shutil.ignore_patterns("__pycache__"))
    (checkout / "scripts").mkdir()
    (checkout / "scripts/bootstrap.py").touch()
    for state in (checkout / ".state", desk.folder / ".state"):
        state.mkdir()
        (state / "services.json").write_text(json.dumps({"registry": "127.0.0.1:5000"}))
    assert desk.call(local, PYTHONPATH=str(checkout / "src")).stderr == "" and runs_as(desk) == CONTRACT
    assert REMEDY in desk.call(evil, PYTHONPATH=str(checkout / "src")).stderr and runs_as(desk) == JO
    assert REMEDY in desk.call(local, PYTHONPATH=str(installed)).stderr and runs_as(desk) == JO


def test_a_strangers_image_runs_as_the_person(desk: Desk) -> None:
    """Although it claims to make users."""
    done = desk.call("-v", ".:/x", EVIL)
    warning = f"warning: {EVIL} wants to start as root, and you have not trusted it: it runs as you, without sudo\n"
    assert (done.returncode, done.stderr) == (0, warning + REMEDY)
    assert runs_as(desk) == JO and remembered(desk) is None
    assert desk.call("ubuntu").stderr == "" and runs_as(desk) == JO, "another image asks for nothing"


@pytest.mark.parametrize(("keys", "expected"), [(b"y\n", CONTRACT), (b"n\n", JO), (b"\n", JO)])
def test_somebody_is_asked_once_for_a_repository(desk: Desk, keys: bytes, expected: list[str]) -> None:
    code, screen = desk.on_a_terminal("--no-name", EVIL, keys=keys)
    lines = screen.decode().replace("\r", "").splitlines()
    assert code == 0 and runs_as(desk) == expected
    assert f"{EVIL} wants to start as root, and to make a user with your ids then." in lines
    assert any(line.startswith(f"Trust all images of {EVIL}? [y/N] ") for line in lines)
    assert remembered(desk) == {f"image {EVIL}": expected == CONTRACT} and desk.memory.stat().st_mode & 0o777 == 0o600
    assert desk.on_a_terminal("--no-name", f"{EVIL}:2") == (0, b"") and runs_as(desk) == expected, "both are remembered"
    assert desk.call(EVIL).stderr == "" and runs_as(desk) == expected
    desk.on_a_terminal("--no-name", "ours", keys=b"n\n")
    assert runs_as(desk) == JO and [*remembered(desk)] == [f"image {EVIL}", "image docker.io/library/ours"]


def test_an_option_trusts_without_a_question(desk: Desk) -> None:
    desk.trust(ours=False)
    assert desk.call("ours").stderr == "" and runs_as(desk) == JO
    assert desk.call("--trust", "ours").stderr == "" and runs_as(desk) == CONTRACT and "--trust" not in desk.calls[-1]
    assert remembered(desk) == {"image docker.io/library/ours": True}
    assert desk.on_a_terminal("--no-name", "ours") == (0, b"") and runs_as(desk) == CONTRACT


@pytest.mark.parametrize("option", ["--dry-run", "--json", "--export=compose", "--export=devcontainer", "--check"])
def test_where_nothing_runs_nobody_is_asked(desk: Desk, option: str) -> None:
    desk.engine(images={"ours": [*OURS, "ROS_DISTRO=jazzy"]})
    code, screen = desk.on_a_terminal(option, "ours", keys=b"y\n")
    assert b"--trust trusts" in screen and b"[y/N]" not in screen and b"DOCKER_UID=1234" not in screen
    done = desk.call(option, "--trust", "ours")
    assert done.stderr == "" and remembered(desk) is None
    if option != "--check":
        assert code == 0 and b"no-new-privileges" in screen and b"1234:1234" in screen
        assert ("no-new-privileges" in done.stdout) == (option == "--export=devcontainer"), (
            "an editor has no entrypoint"
        )


@pytest.mark.parametrize("words", [["--user", "7"], ["--no-user"], ["--entrypoint", "sh"], ["--userns=host"]])
def test_whoever_chooses_who_runs_is_not_asked(desk: Desk, words: list[str]) -> None:
    """Another user namespace of docker gets nothing without trust."""
    screen = desk.on_a_terminal("--no-name", *words, EVIL, keys=b"y\n")[1]
    assert b"[y/N]" not in screen and (b"--trust trusts" in screen) == (words == ["--userns=host"])
    assert "DOCKER_UID=1234" not in desk.ran and remembered(desk) is None


@pytest.mark.parametrize(("info", "uid"), [(ROOTLESS, 1234), (PODMAN, 1234), (DOCKER, 0)])
def test_without_more_rights_no_trust_is_needed(desk: Desk, info: dict[str, Any], uid: int) -> None:
    """Engines without root, and root itself."""
    desk.engine(images={EVIL: OURS}, info=info)
    desk.environment["DESK_UID"] = str(uid)
    assert desk.on_a_terminal("--no-name", EVIL) == (0, b"") and "no-new-privileges" not in desk.ran
    assert ("DOCKER_UID=0" in desk.ran) == (uid == 0)


def test_what_was_typed_before_a_question_is_no_answer(desk: Desk) -> None:
    """Somebody may hit Enter, or type the next command, while an image is pulled."""
    code, screen = desk.on_a_terminal("--no-name", EVIL, keys=b"n\n", before=b"y\n")
    assert code == 0 and screen.count(b"[y/N]") == 1 and runs_as(desk) == JO


def test_a_files_image_is_allowed_and_not_trusted(desk: Desk) -> None:
    (desk.folder / ".rosml.toml").write_text(f'image = "{EVIL}"\noptions = ["--no-name"]')
    code, screen = desk.on_a_terminal("--new", keys=b"y\nn\n")
    assert code == 0 and screen.count(b"[y/N]") == 2 and runs_as(desk) == JO
    assert {*map(type, remembered(desk).values())} == {str, bool}, "each in its own place"


@pytest.mark.parametrize(
    "content", ["nonsense", "[]", '{"image ghcr.io/evil/robot": "true"}', '{"image ghcr.io/evil/robot": 1}', f'{{"{EVIL}": true}}']
)  # fmt: skip
def test_a_damaged_memory_trusts_nothing(desk: Desk, content: str) -> None:
    desk.memory.parent.mkdir(parents=True)
    desk.memory.write_text(content)
    assert REMEDY in desk.call(EVIL).stderr and runs_as(desk) == JO
    assert desk.on_a_terminal("--no-name", EVIL, keys=b"y\n")[0] == 0 and desk.call(EVIL).stderr == ""


def test_an_image_by_its_id_stands_for_itself(desk: Desk) -> None:
    """Also if an id begins like the name of a trusted repository."""
    desk.trust(cafe=True)
    desk.engine(images={"cafe": OURS}, answers={"image": json.dumps({"Id": "sha256:cafe12", "Config": {"Env": OURS}})})
    assert "sha256:cafe12 wants to start as root" in desk.call("cafe").stderr and runs_as(desk) == JO


def test_an_answer_that_cannot_be_kept(desk: Desk) -> None:
    Path(desk.environment["HOME"], ".local").touch()
    code, screen = desk.on_a_terminal("--no-name", EVIL, keys=b"y\n")
    assert code == 0 and b"allowed.json: Not a directory" in screen and runs_as(desk) == CONTRACT
