"""Somebody who calls `rosml run` in a folder of theirs."""

from __future__ import annotations

import fcntl
import os
import pty
import shutil
import struct
import subprocess
import sys
import tempfile
import termios
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from rosml import ROOT
from tests.e2e import engine
from tests.e2e.calls import Run

UID = 12345
SIZE = (33, 101)


@dataclass
class Person:
    """Who may talk to an engine.

    Attributes:
        become: the words before each command, which make the tests' user this person.
    """

    folder: Path
    uid: int
    become: list[str] = field(default_factory=list)
    environment: dict[str, str] = field(default_factory=dict)

    def start(self, *words: str) -> subprocess.Popen[str]:
        """The command rosml, while it runs."""
        return subprocess.Popen(
            [*self.become, *_rosml(words)],
            cwd=self.folder,
            env=self._variables(),
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
        """`rosml run` of an image that they trust, with a container that has no network."""
        return self.rosml("run", "--trust", "--network", "none", *words, typed=typed)

    def other(self, *command: str, place: Path | None = None, timeout: float = 600) -> Run:
        """What another program says, in their folder or another one."""
        done = subprocess.run(
            [*self.become, *command],
            cwd=place or self.folder,
            env=self._variables(),
            capture_output=True,
            text=True,
            timeout=timeout,
            check=False,
        )
        return Run(done.returncode, done.stdout, done.stderr)

    def resized(self, *words: str, seconds: float = 60.0) -> str:
        """All that the command says on a terminal whose size becomes SIZE while it runs, and after that a key is pressed."""
        child, terminal = pty.fork()
        if not child:
            os.chdir(self.folder)
            command = [*self.become, *_rosml(words)]
            os.execvpe(command[0], command, self._variables())

        def resize(output: bytes) -> bool:
            if b"ready" in output:
                fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", *SIZE, 0, 0))
                time.sleep(2)
                os.write(terminal, b"\n")
            return False

        try:
            return engine.terminal_output(terminal, seconds, resize)
        finally:
            os.close(terminal)  # which hangs up
            os.waitpid(child, 0)

    def _variables(self) -> dict[str, str]:
        state = {"XDG_STATE_HOME": str(self.folder / ".state"), "XDG_CONFIG_HOME": str(self.folder / ".config")}
        ours = {"HOME": str(self.folder), **state, "PYTHONPATH": str(ROOT / "src"), "PYTHONDONTWRITEBYTECODE": "1"}
        return {**os.environ, **ours, **self.environment}


def _rosml(words: tuple[str, ...]) -> list[str]:
    return [sys.executable, "-m", "rosml", *words]


def starts(person: Person, image: str, name: str) -> None:
    """Asserts that an image of ours starts as they work with it.

    Args:
        name: the engine's.
    """
    done = person.run("--mwd", image, "bash", "-c", "id -u; pwd; echo $ROS_DISTRO; touch made; exit 37")
    assert (done.code, done.out.split()) == (37, [str(person.uid), str(person.folder), "Debian"]), done
    assert (person.folder / "made").stat().st_uid == person.uid
    home = person.run("--mwd", image, "bash", "-c", "touch ~/.of_rosml && cd && pwd").out.strip()
    assert home not in ("", str(person.folder)) and not (person.folder / ".of_rosml").exists(), home
    assert person.run(image, "printf", "<%s>", "a  b", "", "$HOME", "*").out == "<a  b><><$HOME><*>"
    assert person.run(image, "cat", typed="piped").out == "piped"
    assert person.run(image, "bash", "-c", "kill -TERM $$").code == 143
    assert [person.run(image, command).code for command in ("/etc/passwd", "/nothing")] == [126, 127]
    seen = person.resized("run", "--network", "none", image, "bash", "-c", "echo ready; read; stty size")
    assert " ".join(map(str, SIZE)) in seen, seen
    containers = person.other(name, "ps", "--all", "--quiet", "--filter", f"label=io.rosml.run.folder={person.folder}")
    assert (containers.code, containers.out) == (0, ""), "nothing is containers"


def enters(person: Person, image: str, name: str) -> None:
    """Asserts that they enter a container that they have started, by its name and by their folder."""
    started = person.run("--name", "robot", "--detach", image, "sleep", "1000")
    assert started.code == 0, started.err
    try:
        for where in ("robot", "."):
            done = person.rosml("attach", where, "bash", "-c", "id -u; echo $ROS_DISTRO; exit 3")
            assert (done.code, done.out) == (3, f"{person.uid}\nDebian\n"), done.err
        taken = person.rosml("run", "--name", "robot", "--volume", ".:/x", image)
        assert taken.code == 125 and "rosml attach robot" in taken.err
    finally:
        person.other(name, "rm", "--force", "robot")


@contextmanager
def somebody(docker: engine.Engine) -> Iterator[Person]:
    """A person with a folder, who may talk to the engine: nobody's uid where the tests started it, or else this user."""
    folder = Path(tempfile.mkdtemp(prefix="person-"))  # pytest's own are nobody else's
    person = Person(folder, os.geteuid())
    if socket := docker.socket:
        socket.chmod(0o666)
        socket.parent.chmod(0o755)
        person.uid = UID
        person.become = ["setpriv", f"--reuid={UID}", f"--regid={UID}", "--clear-groups"]
        person.environment |= docker.environment
        os.chown(folder, UID, UID)
    try:
        yield person
    finally:
        shutil.rmtree(folder)
