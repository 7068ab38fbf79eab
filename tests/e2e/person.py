"""Somebody who calls `rosml run` in a folder of theirs."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from rosml import ROOT
from tests.e2e import engine
from tests.e2e.conftest import Run

UID = 12345


@dataclass
class Person:
    """They may talk to the engine: nobody's uid where the tests started it, or else this user."""

    engine: engine.Engine
    folder: Path
    uid: int
    environment: dict[str, str] = field(default_factory=dict)

    def start(self, *words: str) -> subprocess.Popen[str]:
        """The command, while it runs."""
        become = ["setpriv", f"--reuid={self.uid}", f"--regid={self.uid}", "--clear-groups"]
        own = {"HOME": str(self.folder), "PYTHONPATH": str(ROOT / "src"), "PYTHONDONTWRITEBYTECODE": "1"}
        host = {"DOCKER_HOST": self.engine.host} if self.engine.host else {}
        return subprocess.Popen(
            [*(become if self.engine.host else []), sys.executable, "-m", "rosml", *words],
            cwd=self.folder,
            env={**os.environ, **own, **host, **self.environment},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def rosml(self, *words: str, typed: str = "") -> Run:
        """What the command says."""
        process = self.start(*words)
        try:
            out, err = process.communicate(typed, timeout=120)
        finally:
            process.kill()
        return Run(process.returncode, out, err)

    def run(self, *words: str, typed: str = "") -> Run:
        """`rosml run`, with a container that has no network."""
        return self.rosml("run", "--network", "none", *words, typed=typed)


@contextmanager
def somebody(docker: engine.Engine) -> Iterator[Person]:
    """A person with a folder, who may talk to the engine."""
    folder = Path(tempfile.mkdtemp(prefix="person-"))  # pytest's own are nobody else's
    found = Person(docker, folder, os.geteuid())
    if docker.host:
        socket = Path(docker.host.removeprefix("unix://"))
        socket.chmod(0o666)
        socket.parent.chmod(0o755)
        found.uid = UID
        os.chown(folder, UID, UID)
    yield found
    shutil.rmtree(folder)
