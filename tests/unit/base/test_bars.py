"""Bars on a terminal, which is one of Python's own making; and nothing of them where there is none."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest
from conftest import ROOT

from fakes.stubs import on_a_terminal
from rosml.base import progress_bar

CODE = """
import sys, time, click
from rosml.base import progress_bar
for number in progress_bar.over(iter(range(3)), "locks", 3):
    click.echo(f"line {number}", err=True)
    time.sleep(0.25)
    if sys.argv[1:] == [str(number)]:
        raise SystemExit("it went wrong")
click.echo("the end", err=True)
"""


def shown(*arguments: str) -> str:
    """What a terminal gets to see."""
    env = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "CI")}
    env |= {"PYTHONPATH": str(ROOT), "TERM": "xterm", "COLUMNS": "80"}
    code, told = on_a_terminal(CODE, *arguments, env=env)
    assert code == (1 if arguments else 0), told
    return told.decode()


def test_a_terminal_has_a_bar() -> None:
    told = shown()
    assert re.search(r"locks ━+╸? ?━* [12]/3 ", re.sub(r"\x1b\[[0-9;]*m", "", told)), told
    for line in ("line 0", "line 1", "line 2", "the end"):
        assert re.search(rf"(^|[\nKG]){line}\r?\n", told), f"{line!r} stands in a line of its own: {told!r}"
    assert "━" not in told.partition("the end")[2]
    assert told.rindex("\x1b[2K") < told.index("the end"), "the bar is gone by then"


def test_a_bar_goes_with_an_error() -> None:
    told = shown("1")
    assert "━" not in told[told.index("it went wrong") :]
    assert "\x1b[?25h" in told[: told.index("it went wrong")], "the cursor is there again"


def test_elsewhere_there_are_lines_alone(capsys: pytest.CaptureFixture[str]) -> None:
    assert list(progress_bar.over(iter("abc"), "locks", 3)) == ["a", "b", "c"]
    assert capsys.readouterr() == ("", "")
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, "-c", CODE], env=env, capture_output=True, text=True, check=True)
    assert done.stderr.splitlines() == ["line 0", "line 1", "line 2", "the end"]
