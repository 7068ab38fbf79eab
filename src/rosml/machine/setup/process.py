"""Calls of programs in setup: a sign of life if they take long, the end of the log if they fail, an orderly end on Ctrl-C."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.base.units import duration

TAIL_LINES = 20
HEARTBEAT_SECONDS = 20.0


@dataclass(frozen=True)
class Call:
    """A call of a program whose output goes to a log."""

    title: str
    argv: Sequence[str]
    log: Path
    env: Mapping[str, str] | None = None
    cwd: Path | None = None
    pass_fds: tuple[int, ...] = ()
    finish_on_interrupt: bool = False  # after Ctrl-C, let the command finish first (do not interrupt dpkg)


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
    """The last lines of a log from byte `start` on, and its path."""
    lines = log.read_bytes()[start:].decode(errors="replace").splitlines()[-TAIL_LINES:]
    return "The end of its log:\n" + "".join(f"    {line}\n" for line in lines) + f"  whole log: {log}"


def run(say: Callable[[str], object], call: Call) -> None:
    """Makes a long call, with signs of life for the user. After Ctrl-C the command ends before this does."""
    start = call.log.stat().st_size if call.log.exists() else 0
    process, started = detached(call), time.monotonic()
    try:
        while process.returncode is None:
            try:
                process.wait(HEARTBEAT_SECONDS)
            except subprocess.TimeoutExpired:
                say(f"  {call.title}: still at work ({duration(time.monotonic() - started)})")
    except BaseException:
        if call.finish_on_interrupt:
            say(f"  {call.title}: interrupted; letting it finish first, so that nothing is left half-installed")
            process.wait()
        else:
            end_group(process)
        raise
    if process.returncode != 0:
        raise RosmlError(f"{call.title}: failed (exit code {process.returncode}). {tail(call.log, start)}")


def detached(call: Call) -> subprocess.Popen[bytes]:
    """Starts a command in its own session, so that a terminal's Ctrl-C does not reach it."""
    with call.log.open("ab") as out:
        out.write(f"$ {' '.join(call.argv)}\n".encode(errors="surrogateescape"))
        out.flush()
        try:
            return subprocess.Popen(
                call.argv,
                stdin=subprocess.DEVNULL,
                stdout=out,
                stderr=out,
                env=call.env,
                cwd=call.cwd,
                pass_fds=call.pass_fds,
                start_new_session=True,
            )
        except OSError as error:
            raise RosmlError(f"{call.title}: cannot run {call.argv[0]}: {error.strerror}") from None


def end_group(process: subprocess.Popen[bytes]) -> None:
    for kind, patience in ((signal.SIGTERM, 10.0), (signal.SIGKILL, None)):
        with suppress(ProcessLookupError):
            os.killpg(process.pid, kind)
        with suppress(subprocess.TimeoutExpired):
            process.wait(patience)
            return
