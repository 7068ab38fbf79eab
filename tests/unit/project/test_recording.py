"""The recording of a first session says what the commands say; test_containerize.py replays what needs a build."""

from __future__ import annotations

import sys
from pathlib import Path

from conftest import ROOT

from tests import recording
from tests.recording import CAST, COMMANDS


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
