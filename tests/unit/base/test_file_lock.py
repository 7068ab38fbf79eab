"""Processes that take turns."""

from __future__ import annotations

import multiprocessing
import sys
from multiprocessing.synchronize import Event
from pathlib import Path

import pytest

from rosml.base.file_lock import holder, turn


def hold(file: Path, begun: Event, end: Event) -> None:
    with turn(file, lambda: None):
        begun.set()
        end.wait(20)


@pytest.mark.parametrize("killed", [False, True])
def test_one_after_the_other(tmp_path: Path, killed: bool) -> None:
    context = multiprocessing.get_context("fork")
    begun, end = context.Event(), context.Event()
    other = context.Process(target=hold, args=(tmp_path / "turns/ros1-bookworm-core", begun, end))
    other.start()
    assert begun.wait(20)
    notices: list[str] = []

    def waiting() -> None:
        notices.append("waits")
        if killed:
            other.kill()
        else:
            end.set()

    with turn(tmp_path / "turns/ros1-bookworm-core", waiting):
        other.join(20)
    assert (notices, other.exitcode) == (["waits"], -9 if killed else 0)


def test_a_lock_keeps_no_option(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["rosml", "dev", "folder", "-e", "TOKEN=secret", "--", "colcon"])
    with turn(tmp_path / "lock", lambda: None):
        assert holder(tmp_path / "lock").endswith(": rosml dev folder")
        assert b"secret" not in (tmp_path / "lock").read_bytes()
    assert holder(tmp_path / "lock") == "another process", "nobody is taken for the one before"
