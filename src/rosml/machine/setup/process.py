"""Calls of programs in setup: a sign of life if they take long, the end of the log if they fail, an orderly end on Ctrl-C."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.base.units import duration

TAIL_LINES = 20
HEARTBEAT_SECONDS = 20.0


def output_of(argv: Sequence[str], seconds: float = 20.0, env: Mapping[str, str] | None = None) -> str:
    """The output of a short command; empty if it is missing, fails or hangs."""
    try:
        done = subprocess.run(
            argv, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=seconds, env=env, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return done.stdout if done.returncode == 0 else ""


def tail(log: Path, start: int = 0) -> str:
    """The last lines of a log, indented, and its path. ``start``: the first byte to read."""
    lines = log.read_bytes()[start:].decode(errors="replace").splitlines()[-TAIL_LINES:]
    return "The end of its log:\n" + "".join(f"    {line}\n" for line in lines) + f"  whole log: {log}"


def run(
    say: Callable[[str], object],
    what: str,
    argv: Sequence[str],
    log: Path,
    env: Mapping[str, str] | None = None,
    cwd: Path | None = None,
    finish_on_interrupt: bool = False,
) -> None:
    """Runs a long command. Its output goes to ``log``; the user sees signs of life.

    Args:
        what: the name of the work, for messages.
        finish_on_interrupt: after Ctrl-C, let the command finish first (do not interrupt dpkg).

    Raises:
        RosmlError: the command is missing, or its exit code is not 0; the message has the end of the log.
        KeyboardInterrupt: the user pressed Ctrl-C; the command has ended.
    """
    start = log.stat().st_size if log.exists() else 0
    process, started = detached(what, argv, log, env, cwd), time.monotonic()
    try:
        while process.returncode is None:
            try:
                process.wait(HEARTBEAT_SECONDS)
            except subprocess.TimeoutExpired:
                say(f"  {what}: still at work ({duration(time.monotonic() - started)})")
    except BaseException:
        if finish_on_interrupt:
            say(f"  {what}: interrupted; letting it finish first, so that nothing is left half-installed")
            process.wait()
        else:
            end_group(process)
        raise
    if process.returncode != 0:
        raise RosmlError(f"{what}: failed (exit code {process.returncode}). {tail(log, start)}")


def detached(
    what: str, argv: Sequence[str], log: Path, env: Mapping[str, str] | None = None, cwd: Path | None = None
) -> subprocess.Popen[bytes]:
    """Starts a command in its own session, so that a terminal's Ctrl-C does not reach it. Its output goes to ``log``.

    Raises:
        RosmlError: it cannot be run.
    """
    with log.open("ab") as out:
        out.write(f"$ {' '.join(argv)}\n".encode(errors="surrogateescape"))
        out.flush()
        try:
            return subprocess.Popen(
                argv, stdin=subprocess.DEVNULL, stdout=out, stderr=out, env=env, cwd=cwd, start_new_session=True
            )
        except OSError as error:
            raise RosmlError(f"{what}: cannot run {argv[0]}: {error.strerror}") from None


def end_group(process: subprocess.Popen[bytes]) -> None:
    """Ends a command in its own session, with all its children."""
    for kind, patience in ((signal.SIGTERM, 10.0), (signal.SIGKILL, None)):
        with suppress(ProcessLookupError):
            os.killpg(process.pid, kind)
        with suppress(subprocess.TimeoutExpired):
            process.wait(patience)
            return
