"""What the user sees: one line when something starts, one when it is done, the log's end when it fails."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType

TAIL_LINES = 20
HEARTBEAT_SECONDS = 20.0


class Failure(Exception):
    """The set-up cannot go on. ``remedy`` says what the user can do about it."""

    def __init__(self, message: str, remedy: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.remedy = remedy


def say(text: str) -> None:
    """Prints a line at once, also into a pipe."""
    print(text, flush=True)


def elapsed(since: float) -> str:
    """Time since ``since`` (of ``time.monotonic()``), e.g. ``38 s`` or ``2 min 5 s``."""
    seconds = round(time.monotonic() - since)
    return f"{seconds} s" if seconds < 100 else f"{seconds // 60} min {seconds % 60} s"


def tail(log: Path, start: int = 0) -> str:
    """The last lines of a log, indented; empty when there is none. ``start``: byte to read from."""
    try:
        with log.open(errors="replace") as stream:
            stream.seek(start)
            return "".join(f"    {line.rstrip()}\n" for line in deque(stream, TAIL_LINES))
    except OSError:
        return ""


def run(
    what: str,
    argv: Sequence[str],
    log: Path,
    env: Mapping[str, str] | None = None,
    cwd: Path | None = None,
    finish_on_interrupt: bool = False,
) -> None:
    """Runs a command that takes long: its output goes to ``log``, a sign of life to the user.

    Args:
        what: name of the work, for messages.
        finish_on_interrupt: on Ctrl-C let the command come to its end first (dpkg must not be torn apart).

    Raises:
        Failure: the command is missing or exits with another code than 0; shows the end of the log.
        KeyboardInterrupt: the user pressed Ctrl-C; the command has ended.
    """
    log.parent.mkdir(parents=True, exist_ok=True)
    started = time.monotonic()
    with log.open("ab") as stream:
        start = stream.tell()
        stream.write(f"$ {' '.join(argv)}\n".encode(errors="surrogateescape"))
        stream.flush()
        try:
            process = subprocess.Popen(
                argv,
                stdin=subprocess.DEVNULL,
                stdout=stream,
                stderr=subprocess.STDOUT,
                env=env,
                cwd=cwd,
                start_new_session=True,
            )
        except OSError as error:
            raise Failure(f"{what}: cannot run {argv[0]}: {error.strerror}") from None
        try:
            while True:
                try:
                    code = process.wait(HEARTBEAT_SECONDS)
                    break
                except subprocess.TimeoutExpired:
                    say(f"  {what}: still at work ({elapsed(started)})")
        except BaseException:
            if finish_on_interrupt:
                say(f"  {what}: interrupted; letting it finish first, so that nothing is left half-installed")
                process.wait()
            else:
                end_group(process)
            raise
    if code != 0:
        raise Failure(f"{what}: failed (exit code {code}). The end of its log:\n{tail(log, start)}  whole log: {log}")


def end_group(process: subprocess.Popen[bytes]) -> None:
    """Ends a command started in a session of its own, with all it started."""
    for kind, patience in ((signal.SIGTERM, 10.0), (signal.SIGKILL, None)):
        with suppress(ProcessLookupError):
            os.killpg(process.pid, kind)
        try:
            process.wait(patience)
            return
        except subprocess.TimeoutExpired:
            continue


@contextmanager
def uninterrupted() -> Iterator[None]:
    """Holds Ctrl-C and SIGTERM back until the block is done.

    A handler, not a mask: a signal mask or SIG_IGN would be inherited by what the block starts.
    """
    held: list[int] = []

    def hold(number: int, _frame: FrameType | None) -> None:
        held.append(number)

    before = {number: signal.signal(number, hold) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        if held:
            os.kill(os.getpid(), held[0])


def colour(text: str, code: int) -> str:
    """Coloured on a terminal, plain elsewhere and with NO_COLOR."""
    return f"\033[{code}m{text}\033[0m" if sys.stderr.isatty() and "NO_COLOR" not in os.environ else text
