"""A container engine for the tests of the runtime contract: the machine's Docker, or dockerd started for them.

`docker run` is what users type; BuildKit's build steps have neither an init process, nor a user's terminal, nor mounts
of theirs.
"""

from __future__ import annotations

import json
import os
import pty
import select
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from rosml.machine.services import Services
from tests.e2e import images
from tests.e2e.calls import Run, run, wait_until

START_SECONDS = 60.0
DAEMONS = ("/usr/sbin/dockerd", "/usr/bin/dockerd", "/usr/local/bin/dockerd")


def daemon() -> str | None:
    """dockerd, where Debian's docker.io or Docker itself put it."""
    return next((path for path in DAEMONS if os.access(path, os.X_OK)), None)


def answers() -> bool:
    """Whether the machine's own Docker does."""
    docker = shutil.which("docker")
    return docker is not None and subprocess.run([docker, "info"], capture_output=True, check=False).returncode == 0


def missing() -> str:
    """Why there is no engine; empty if there is one."""
    if answers():
        return ""
    if shutil.which("docker") is None or daemon() is None:
        return "no Docker answers, and dockerd is not installed (apt-get install docker.io)"
    return "" if os.geteuid() == 0 else "no Docker answers, and starting dockerd needs root"


def terminal_output(terminal: int, seconds: float, ended: Callable[[bytes], bool]) -> str:
    """What is said on a terminal until it is closed, or nothing more comes and it has ended, by what was said so far."""
    output, end = b"", time.monotonic() + seconds
    while time.monotonic() < end:
        if select.select([terminal], [], [], 0.2)[0]:
            with suppress(OSError):  # the other end was closed
                if data := os.read(terminal, 65536):
                    output += data
                    continue
            break
        if ended(output):
            break
    return output.decode(errors="replace").replace("\r", "")


@dataclass(frozen=True)
class Engine:
    """A Docker daemon; no container that is run here has a network."""

    host: str = ""

    def docker(self, *arguments: str, timeout: float = 120.0) -> Run:
        """A command of its client."""
        done = subprocess.run(self.command(*arguments), capture_output=True, text=True, timeout=timeout, check=False)
        return Run(done.returncode, done.stdout, done.stderr)

    def command(self, *arguments: str) -> list[str]:
        """The command line."""
        return ["docker", *(["--host", self.host] if self.host else []), *arguments]

    def run(self, image: str, *command: str, options: tuple[str, ...] = ()) -> Run:
        """`docker run --rm`, without a terminal."""
        return self.docker("run", "--rm", "--network", "none", *options, image, *command)

    def talk(self, arguments: tuple[str, ...], typed: str = "", seconds: float = 60.0) -> str:
        """All that a command of the client says on a terminal, into which something is typed."""
        master, slave = pty.openpty()
        process = subprocess.Popen(self.command(*arguments), stdin=slave, stdout=slave, stderr=slave, close_fds=True)
        os.close(slave)
        os.write(master, typed.encode())
        try:
            return terminal_output(master, seconds, lambda _: process.poll() is not None)
        finally:
            process.kill()
            process.wait()
            os.close(master)

    def load(self, services: Services, reference: str, name: str, folder: Path, *steps: str) -> str:
        """Loads an image of the registry into the engine, with steps of `images.context` on top; returns its name there.
        Debian's docker.io knows no zstd."""
        archive, name, source = folder / "image.tar", f"rosml-contract:{name}", folder / "context"
        source.mkdir()
        images.context(reference, source, steps)
        output = f"type=docker,dest={archive},name={name},compression=uncompressed,force-compression=true"
        options = ["--output", output, *images.ca_secret(services)]
        built = run(*services.buildx, "build", *options, str(source), env=services.environment())
        assert built.code == 0, built.err
        done = self.docker("load", "--input", str(archive), timeout=600.0)
        archive.unlink()
        shutil.rmtree(source)
        assert done.code == 0, done.err
        return name


@contextmanager
def running() -> Iterator[Engine]:
    """The machine's own Docker, or a daemon that lives as long as this."""
    if answers():
        yield Engine()
        return
    program = daemon()
    assert program, missing()
    folder = Path(tempfile.mkdtemp(prefix="dockerd-"))  # short: sockets are in it
    config = folder / "daemon.json"
    config.write_text(json.dumps({"bridge": "none", "iptables": False, "ip6tables": False, "ip-masq": False}))
    host = f"unix://{folder}/socket"
    places = ["--data-root", f"{folder}/data", "--exec-root", f"{folder}/exec", "--pidfile", f"{folder}/pid"]
    log = (folder / "log").open("w")
    process = subprocess.Popen(
        [program, "--host", host, "--config-file", str(config), *places], stdout=log, stderr=log, start_new_session=True
    )
    engine = Engine(host)
    try:
        state = (folder / "log").read_text
        wait_until(lambda: engine.docker("info").code == 0, START_SECONDS, lambda: state()[-3000:], process)
        yield engine
    finally:
        process.terminate()
        with suppress(subprocess.TimeoutExpired):
            process.wait(30)
        process.kill()
        log.close()
        shutil.rmtree(folder, ignore_errors=True)
