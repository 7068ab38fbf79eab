"""A background service: started detached, found by its command line, and reliably stopped."""

from __future__ import annotations

import hashlib
import os
import signal
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.machine.setup.process import Call, detached
from rosml.machine.setup.state import State

START_SECONDS = 60.0

LOG_LIMIT = 10_000_000
"""From this size in bytes, a log is put aside when its service starts."""


@dataclass(frozen=True)
class Daemon:
    """One service."""

    state: State
    name: str
    argv: tuple[str, ...]  # has a file of this checkout, so no other checkout has the same
    config: Path  # read when it starts; if the file changes, it restarts
    env: Mapping[str, str]
    launcher: tuple[str, ...] = ()  # a command that prepares the process and then becomes the service

    @property
    def log(self) -> Path:
        return self.state.log / f"{self.name}.log"

    @property
    def _read_digest(self) -> Path:
        """The file with the digest of the configuration that the service has read."""
        return self.state.run / f"{self.name}.read"

    def pid(self) -> int | None:
        return next((pid for pid in processes() if command_line(pid) == self.argv), None)

    def current(self) -> bool:
        """Whether the running service has read the present configuration."""
        return self._read_digest.exists() and self._read_digest.read_text() == fingerprint(self.config)

    def start(self) -> None:
        """You may interrupt it: the digest is written before the service reads its configuration, and `pid` needs no record."""
        if self.log.exists() and self.log.stat().st_size > LOG_LIMIT:
            self.log.replace(self.log.with_suffix(".log.old"))
        files.write(self._read_digest, fingerprint(self.config))
        argv = (*self.launcher, *self.argv)
        process = detached(Call(self.name, argv, self.log, self.env, self.state.folder))
        # The start is reported a little before the new command line can be read.
        wait_until(lambda: command_line(process.pid) == self.argv or process.poll() is not None, 5.0, 0.01)

    def stop(self, patience: float = 20.0) -> bool:
        """Sends SIGTERM, and SIGKILL after `patience` seconds. Returns whether it ran."""
        pid = self.pid()
        for kind, seconds in ((signal.SIGTERM, patience), (signal.SIGKILL, 10.0)):
            if pid is None or command_line(pid) != self.argv:
                break
            try:
                os.kill(pid, kind)
            except PermissionError:
                raise RosmlError(f"{self.name} (process {pid}) belongs to another user", f"sudo kill {pid}") from None
            wait_until(lambda: self.pid() != pid, seconds)
        self._read_digest.unlink(missing_ok=True)
        return pid is not None


def fingerprint(path: Path) -> str:
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()
    except OSError:
        return ""


def processes() -> list[int]:
    return [int(entry) for entry in os.listdir("/proc") if entry.isdigit()]


def command_line(pid: int) -> tuple[str, ...]:
    """The arguments of a process; empty if it has ended (a zombie has none either), or if this user may not see it."""
    try:
        content = Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return ()
    return tuple(os.fsdecode(part) for part in content.split(b"\0")[:-1])


def wait_until(condition: Callable[[], bool], seconds: float, pause: float = 0.1) -> bool:
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(pause)
    return True
