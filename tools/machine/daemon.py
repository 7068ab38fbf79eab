"""A service that runs on its own: started detached, known by its command line, stopped for certain."""

from __future__ import annotations

import hashlib
import json
import os
import signal
import subprocess
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from machine.console import Failure, uninterrupted
from machine.state import State, read_json, write_atomically

LOG_LIMIT = 10_000_000
"""Bytes at which a log is put aside when its service starts."""


@dataclass(frozen=True)
class Daemon:
    """One service.

    Attributes:
        name: also the name of its log and its pid file.
        argv: its command line; it names a file of this checkout, so no other checkout has the same.
        config: the file it reads when it starts. A change means a restart.
        env: its environment.
        launcher: a command that prepares the process and then becomes the service, with its arguments.
    """

    state: State
    name: str
    argv: tuple[str, ...]
    config: Path
    env: Mapping[str, str]
    launcher: tuple[str, ...] = ()

    @property
    def pid_file(self) -> Path:
        return self.state.run / f"{self.name}.json"

    @property
    def log(self) -> Path:
        return self.state.log / f"{self.name}.log"

    def pid(self) -> int | None:
        """The running service, or nothing. A process that only has the recorded number does not count.

        Looks through all processes if the record is missing: a set-up killed at the wrong moment leaves none.
        """
        recorded = (read_json(self.pid_file) or {}).get("pid")
        if isinstance(recorded, int) and command_line(recorded) == self.argv:
            return recorded
        return next((pid for pid in processes() if command_line(pid) == self.argv), None)

    def current(self) -> bool:
        """Whether the running service read the configuration as it is now."""
        return (read_json(self.pid_file) or {}).get("config") == fingerprint(self.config)

    def start(self) -> None:
        """Starts it in a session of its own, so that Ctrl-C in a terminal does not reach it."""
        if self.log.exists() and self.log.stat().st_size > LOG_LIMIT:
            self.log.replace(self.log.with_suffix(".log.old"))
        with self.log.open("ab") as stream, uninterrupted():
            try:
                process = subprocess.Popen(
                    (*self.launcher, *self.argv),
                    stdin=subprocess.DEVNULL,
                    stdout=stream,
                    stderr=subprocess.STDOUT,
                    env=dict(self.env),
                    cwd=self.state.folder,
                    start_new_session=True,
                )
            except OSError as error:
                raise Failure(f"{self.name}: cannot run {(*self.launcher, *self.argv)[0]}: {error.strerror}") from None
            record = {"pid": process.pid, "config": fingerprint(self.config)}
            write_atomically(self.pid_file, json.dumps(record) + "\n")
            # The kernel reports the start as done a little before the new command line can be read.
            wait_until(lambda: command_line(process.pid) == self.argv or process.poll() is not None, 5.0, 0.01)

    def stop(self, patience: float = 20.0) -> bool:
        """Stops it: SIGTERM, after ``patience`` seconds SIGKILL. Says whether it was running."""
        pid = self.pid()
        if pid is not None:
            for kind, seconds in ((signal.SIGTERM, patience), (signal.SIGKILL, 10.0)):
                if command_line(pid) == self.argv:
                    try:
                        os.kill(pid, kind)
                    except PermissionError:
                        raise Failure(
                            f"{self.name} (process {pid}) belongs to another user", f"sudo kill {pid}"
                        ) from None
                if wait_until(lambda: command_line(pid) != self.argv, seconds):
                    break
        self.pid_file.unlink(missing_ok=True)
        return pid is not None


def fingerprint(path: Path) -> str:
    """Hash of a file's content; empty where it is missing."""
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError:
        return ""


def processes() -> list[int]:
    """Numbers of all processes."""
    return [int(entry) for entry in os.listdir("/proc") if entry.isdigit()]


def command_line(pid: int) -> tuple[str, ...]:
    """Arguments of a process; empty where it has ended (a zombie has none either) or is not this user's to see."""
    try:
        content = Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return ()
    return tuple(os.fsdecode(part) for part in content.split(b"\0")[:-1])


def wait_until(condition: Callable[[], bool], seconds: float, pause: float = 0.1) -> bool:
    """Waits for a condition; says whether it came true in time."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(pause)
    return True
