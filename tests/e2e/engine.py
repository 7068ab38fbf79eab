"""A container engine for the tests of the runtime contract: the machine's Docker, or one that is started for them.

`docker run` is what users type; BuildKit's build steps have neither an init process, nor a user's terminal, nor mounts
of theirs. A current one is that of `rosml setup engine`; Debian's docker.io is as old as that of many robots.
"""

from __future__ import annotations

import json
import os
import pty
import re
import select
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from rosml import ROOT
from rosml.images.builds.push import COMPRESSION
from rosml.machine.services import Services
from rosml.machine.setup.installer import Version
from tests.e2e import images
from tests.e2e.calls import Run, run, wait_until

START_SECONDS = 60.0
CURRENT = ROOT / ".state/engine"
"""The folder of the programs that `rosml setup engine` built."""
DEBIAN = ("/usr/sbin", "/usr/bin", "/usr/local/bin")
"""Folders in which Debian's docker.io, or Docker itself, put dockerd."""
ZSTD = (23,)
"""The first Docker that reads zstd."""
SUBNET = "172.31.255"


def version(environment: Mapping[str, str]) -> Version:
    """The version of the Docker that answers; empty if none does."""
    env = {**os.environ, **environment}
    if shutil.which("docker", path=env["PATH"]) is None:
        return ()
    argv = ["docker", "version", "--format", "{{.Server.Version}}"]
    done = subprocess.run(argv, env=env, capture_output=True, text=True, check=False)
    return tuple(map(int, re.findall(r"\d+", done.stdout)[:2])) if done.returncode == 0 else ()


def folder_of_daemon(debian: bool = False) -> str:
    """The folder of the newest dockerd that can be started, or of Debian's; empty if there is none."""
    folders = DEBIAN if debian else (str(CURRENT), *DEBIAN)
    return next((folder for folder in folders if os.access(f"{folder}/dockerd", os.X_OK)), "")


def missing() -> str:
    """Why there is no engine; empty if there is one."""
    if version({}):
        return ""
    if not folder_of_daemon():
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
    """A Docker daemon; no container that is run here has a network. `environment`: what its client needs beside this process' own."""

    environment: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def reads_zstd(self) -> bool:
        """Whether it pulls our images as they are."""
        return version(self.environment) >= ZSTD

    @property
    def socket(self) -> Path | None:
        """That of a daemon that was started for tests."""
        host = self.environment.get("DOCKER_HOST", "")
        return Path(host.removeprefix("unix://")) if host else None

    def docker(self, *arguments: str, timeout: float = 120.0) -> Run:
        """A command of its client."""
        argv, env = ["docker", *arguments], self.variables()
        done = subprocess.run(argv, env=env, capture_output=True, text=True, timeout=timeout, check=False)
        return Run(done.returncode, done.stdout, done.stderr)

    def variables(self) -> dict[str, str]:
        """The environment of its client."""
        return {**os.environ, **self.environment}

    def run(self, image: str, *command: str, options: tuple[str, ...] = ()) -> Run:
        """`docker run --rm`, without a terminal."""
        return self.docker("run", "--rm", "--network", "none", *options, image, *command)

    def talk(self, arguments: tuple[str, ...], typed: str = "", seconds: float = 60.0) -> str:
        """All that a command of the client says on a terminal, into which something is typed."""
        master, slave = pty.openpty()
        process = subprocess.Popen(
            ["docker", *arguments], env=self.variables(), stdin=slave, stdout=slave, stderr=slave, close_fds=True
        )
        os.close(slave)
        os.write(master, typed.encode())
        try:
            return terminal_output(master, seconds, lambda _: process.poll() is not None)
        finally:
            process.kill()
            process.wait()
            os.close(master)

    def pull(self, reference: str) -> str:
        """Takes an image of the local registry as a user does; returns its name."""
        done = self.docker("pull", "--quiet", reference, timeout=900.0)
        assert done.code == 0, done.err
        return reference

    def image(self, services: Services, reference: str, name: str, folder: Path, *steps: str) -> str:
        """Takes an image of the registry into the engine, with steps of `images.context` on top; returns its name there.

        An engine that reads no zstd gets it unpacked.
        """
        if self.reads_zstd and not steps:
            return self.pull(reference)
        source, archive = folder / "context", folder / "image.tar"
        source.mkdir()
        images.context(reference, source, steps)
        place = f"{services.registry}/rosml-test/contract:{name}"
        output = f"type=docker,dest={archive},name={place},compression=uncompressed,force-compression=true"
        if self.reads_zstd:
            output = f"type=image,push=true,name={place},{COMPRESSION}"
        options = ["--output", output, *images.ca_secret(services)]
        built = run(*services.buildx, "build", *options, str(source), env=services.environment())
        assert built.code == 0, built.err
        shutil.rmtree(source)
        if self.reads_zstd:
            return self.pull(place)
        done = self.docker("load", "--input", str(archive), timeout=600.0)
        archive.unlink()
        assert done.code == 0, done.err
        return place


@contextmanager
def running(debian: bool = False, bridge: str = "none") -> Iterator[Engine]:
    """The machine's own Docker, or a daemon that lives as long as this: without a bridge, it would remove that of another.

    Args:
        debian: Debian's docker.io, however old it is, if one is started.
        bridge: the name of one that is made for it, as its build steps need one, with a way out of this machine.
    """
    if version({}):
        yield Engine()
        return
    programs = folder_of_daemon(debian)
    assert programs, missing()
    folder = Path(tempfile.mkdtemp(prefix="dockerd-"))  # short: sockets are in it
    config = folder / "daemon.json"
    settings = {"bridge": bridge, "iptables": False, "ip6tables": False, "ip-masq": False, "userland-proxy": False}
    if bridge != "none":
        subprocess.run(["ip", "link", "add", bridge, "type", "bridge"], check=True)
        subprocess.run(["ip", "address", "add", f"{SUBNET}.1/24", "dev", bridge], check=True)
        subprocess.run(["ip", "link", "set", bridge, "up"], check=True)
        subprocess.run(_masquerade("--append", bridge), check=True)
    config.write_text(json.dumps(settings))
    host = f"unix://{folder}/socket"
    places = ["--data-root", f"{folder}/data", "--exec-root", f"{folder}/exec", "--pidfile", f"{folder}/pid"]
    log = (folder / "log").open("w")
    engine = Engine({"PATH": f"{programs}:{os.environ['PATH']}", "DOCKER_HOST": host})
    argv = ["dockerd", "--host", host, "--config-file", str(config), *places]
    process = subprocess.Popen(argv, env=engine.variables(), stdout=log, stderr=log, start_new_session=True)
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
        if bridge != "none":
            subprocess.run(_masquerade("--delete", bridge), check=False)
            subprocess.run(["ip", "link", "delete", bridge], check=False)
        shutil.rmtree(folder, ignore_errors=True)


def _masquerade(action: str, bridge: str) -> list[str]:
    """The call of iptables that gives containers on a bridge a way out of this machine, or takes it from them."""
    packets = ["--source", f"{SUBNET}.0/24", "!", "--out-interface", bridge]
    return ["iptables", "--table", "nat", action, "POSTROUTING", *packets, "--jump", "MASQUERADE"]
