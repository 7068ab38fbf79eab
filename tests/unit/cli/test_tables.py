"""What a table says of things that come from outside: a builder's message, a name, a reason."""

from __future__ import annotations

import time

import pytest

from rosml.cli.images import report, tables
from rosml.images.publish.run import Outcome
from rosml.images.publish.status import ImageStatus


@pytest.mark.parametrize(
    "text", ["failed in step [ros1-bookworm-core ros 1/2]", "no file [/x]", "[red]late[/red]", ":bug:"]
)
def test_it_is_printed_as_it_is(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Never taken for rich's markup, which would lose brackets, colour what follows, or end the command with an error."""
    outcomes = [Outcome("build", "alpha-core", "amd64", "failed", text), Outcome("test", "b", "amd64", "waits", text)]
    report.print_outcomes(outcomes, "2026-11-22T03:00:00Z", 0, time.monotonic(), as_json=False)
    row, waits, *_ = capsys.readouterr().out.splitlines()[1:]
    assert row.split() == ["build", "alpha-core", "amd64", "failed", "0.0", "s", *text.split()]
    assert waits == f"waits: 1 times: {text}"
    tables.print_status([ImageStatus("alpha-core", "failed", text, "ros:alpha-core", "", "", None, ())], [], [])
    assert capsys.readouterr().out.splitlines()[1].split() == ["alpha-core", "failed", *text.split()]
