"""Progress bars on a terminal, and none elsewhere."""

from __future__ import annotations

import os
import re
import subprocess
import sys

from conftest import ROOT

from fakes.stubs import on_a_terminal

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


def terminal_output(*arguments: str) -> str:
    env = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "CI")}
    env |= {"PYTHONPATH": str(ROOT), "TERM": "xterm", "COLUMNS": "80"}
    code, output = on_a_terminal(CODE, *arguments, env=env)
    assert code == (1 if arguments else 0), output
    return output.decode()


def test_a_terminal_has_a_bar() -> None:
    output = terminal_output()
    assert re.search(r"locks ━+╸? ?━* [12]/3 ", re.sub(r"\x1b\[[0-9;]*m", "", output)), output
    for line in ("line 0", "line 1", "line 2", "the end"):
        assert re.search(rf"(^|[\nKG]){line}\r?\n", output), f"{line!r} stands in a line of its own: {output!r}"
    assert "━" not in output.partition("the end")[2]
    assert output.rindex("\x1b[2K") < output.index("the end"), "the bar is gone by then"


def test_a_bar_goes_with_an_error() -> None:
    before, _, after = terminal_output("1").partition("it went wrong")
    assert "━" not in after and "\x1b[?25h" in before, "the cursor is shown again"


def test_elsewhere_are_lines_alone() -> None:
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, "-c", CODE], env=env, capture_output=True, text=True, check=True)
    assert done.stderr.splitlines() == ["line 0", "line 1", "line 2", "the end"]
