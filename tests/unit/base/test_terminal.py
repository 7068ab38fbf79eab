"""What is printed, whoever wrote it: no terminal and no CI takes it for a command."""

from __future__ import annotations

import time

import click
import pytest

from rosml.base import terminal
from rosml.base.errors import RosmlError
from rosml.cli import command


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain, with ü and 图\n\tand lines", "plain, with ü and 图\n\tand lines"),
        (click.style("red", fg="red", bold=True), click.style("red", fg="red", bold=True)),
        ("\x1b]52;c;aGFybQ==\x07clipboard", "clipboard"),
        ("\x1b]8;;https://evil.example\x1b\\link\x1b]8;;\x1b\\", "link"),
        ("\x1b]0;no end", "0;no end"),
        ("\x1bPtmux;\x1b\\device", "device"),
        ("\x1b[8mhidden\x1b[30;40mhidden", "hiddenhidden"),
        ("error: \rall is well\x08", "error: all is well"),
        ("\x1b", ""),
        ("abc\u202edcba\u2066 \u200b\ufeff", "abcdcba "),
        ("::error::on a machine of one's own", "::error::on a machine of one's own"),
    ],
)
def test_commands_to_a_terminal_are_left_out(text: str, shown: str) -> None:
    assert terminal.shown(text) == shown


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("::add-mask::secret", ": :add-mask::secret"),
        ("a\n   ::error file=x::y", "a\n   : :error file=x::y"),
        ("0:20 made ##[add-mask]x ##[error]y", "0:20 made # #[add-mask]x # #[error]y"),
        ("std::string and a::b", "std::string and a::b"),
    ],
)
def test_commands_to_github_are_words(text: str, shown: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    assert terminal.shown(text) == shown


@pytest.mark.parametrize("piece", ["\x1b[", "\x1b]", "\x1b[2", "2;", "\x1b[22;", "::", "##[", " ::", "\r", "\x1b P"])
def test_it_takes_no_time(piece: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GITHUB_ACTIONS", "true")
    started = time.monotonic()
    terminal.shown(f"\x1b[{piece * 100_000}")
    assert time.monotonic() - started < 1


def test_errors_notices_and_tables_are_safe(capfd: pytest.CaptureFixture[str]) -> None:
    @click.command()
    def harm() -> None:
        command.say("\x1b]0;begins\x07")
        terminal.show_rows(("name",), [("\x1b]0;cell\x07named",)])
        terminal.console().print("\x1b]0;line\x07note")
        raise RosmlError("\x1b]0;error\x07wrong", "\x1b]0;remedy\x07correct it")

    assert command.run(harm, arguments=[]) == 1
    out, err = capfd.readouterr()
    assert "\x1b]" not in out + err and "\x07" not in out + err
    assert "named" in out and "note" in out and "wrong" in err and "correct it" in err
