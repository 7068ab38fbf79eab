"""The recording of a first session says what the commands say; test_containerize.py replays what needs a build."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from conftest import ROOT

from tests import recording
from tests.recording import CAST, COMMANDS, Command, Event


def test_what_is_typed_is_what_would_be_recorded() -> None:
    cast = recording.read()
    assert [cast["list"].typed, cast["containerize"].typed] == [COMMANDS["list"], COMMANDS["containerize"]]
    assert (
        cast["containerize"].output.splitlines()[-1]
        == f"try    {cast['run'].typed.removesuffix(' ' + COMMANDS['run'])}"
    )


def test_list_says_what_was_recorded(tmp_path: Path) -> None:
    now = recording.recorded(COMMANDS["list"].replace("./rosml", f"{sys.executable} {ROOT / 'src'}"), tmp_path, {})
    assert recording.stable(now.output) == recording.stable(recording.read()["list"].output)


def test_the_picture_is_drawn_from_the_cast() -> None:
    assert recording.picture(recording.read()) == recording.PICTURE.read_text(), "call python -m tests.recording draw"


def test_a_cast_names_nothing_of_the_machine_and_is_small() -> None:
    text = CAST.read_text()
    assert str(ROOT) not in text and "/tmp" not in text
    assert len(text) < 6000


def test_a_cast_is_read_as_it_was_written(tmp_path: Path) -> None:
    events = (Event(0.5, "o", "\x1b[1mone\x1b[0m\r\n"), Event(2.25, "o", "two\r\n"))
    commands = {"a": Command("a --b", events), "c": Command("c", ())}
    (tmp_path / "cast").write_text(recording.written(commands))
    assert recording.read(tmp_path / "cast") == commands
    assert commands["a"].output == "one\ntwo\n"


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("run    127.0.0.1:40123/x:latest", "run    127.0.0.1:59431/x:latest"),
        ("time   54.9 s", "time   8.0 s"),
        ("time   1 min 5 s", "time   8.0 s"),
        ("ros:jazzy  1.3  amd64", "ros:jazzy  10.6  amd64"),
        ("made sha256:0a1b", "made sha256:ffff"),
        ("kept 3.1 kB", "kept 12 MB"),
        ("==> 1 package for linux/amd64", "==> 1 package for linux/arm64"),
        ("==> a\n    0:01     1.3 s  [x y 1/2] z", "==> a"),
    ],
)
def test_times_digests_and_sizes_do_not_count(one: str, other: str) -> None:
    assert recording.stable(one) == recording.stable(other)


@pytest.mark.parametrize(
    ("one", "other"),
    [("2 passed, 0 skipped", "1 passed, 0 skipped"), ("torch 2.14", "torch 2.15"), ("==> base image a", "==> base b")],
)
def test_all_else_counts(one: str, other: str) -> None:
    assert recording.stable(one) != recording.stable(other)


def test_steps_are_those_of_the_log() -> None:
    printed = (
        "    0:01     1.3 s  [report built 1/1] /run/build.sh tar…\n    0:02     …      [run apt 1/2] install.sh: a\n"
    )
    log = "CACHED [results built 1/1] RUN --mount=type=bind,from=x,target=/y     /run/build.sh target\n"
    assert recording.steps(printed) == {"built 1/1] /run/build.sh tar"}
    assert recording.steps(log) == {"built 1/1] /run/build.sh target"}
