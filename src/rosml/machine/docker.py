"""The user's Docker: what its client says of it, and what to do if it does not answer."""

from __future__ import annotations

import os
import re
import subprocess
from dataclasses import dataclass
from typing import Any

from rosml.base import silent_docker, untrusted

SECONDS = 10.0
SILENT = re.compile("docker|error during connect", re.IGNORECASE)
"""Words of Docker's client if its daemon does not answer, also if buildx repeats them."""
DESKTOP = "docker-desktop"
"""The machine of Docker Desktop. On Windows it shares WSL's loopback, so that only a trial tells what it reaches."""
CONTAINERD_STORE = (
    'write {"features": {"containerd-snapshotter": true}} into /etc/docker/daemon.json, and restart Docker'
)
"""How Docker gets containerd's image store after an update: https://docs.docker.com/engine/storage/containerd"""


@dataclass(frozen=True)
class Docker:
    """The answer of the Docker that `docker` asks. `silence`: why there is none, with the remedy; empty if it answers."""

    silence: str = ""
    remedy: str = ""
    machine: str = ""  # the name of the machine that it runs on
    containerd_store: bool = False
    rootless: bool = False

    @property
    def answers(self) -> bool:
        return not self.silence

    @property
    def is_elsewhere(self) -> bool:
        """Whether it runs on another machine, whose files and loopback are not those of this one."""
        return self.machine not in ("", DESKTOP, os.uname().nodename)


def ask(program: str) -> Docker:
    """What `docker info` says. `program`: the client; empty if it is not installed."""
    if not program:
        return Docker("Docker is not installed", "install it")
    text, complaint = _output(program, "info", "--format", "{{json .}}")
    info = untrusted.json_object(text) or {}
    if "host" in info:
        return Docker("docker is podman here, which is no builder", "install Docker")
    if not info.get("ServerVersion"):
        complaint = complaint or _line(info.get("ServerErrors")) or "it says nothing"
        verb = "let you in" if silent_docker.denies(complaint) else "answer"
        return Docker(f"Docker does not {verb}: {complaint}", silent_docker.remedy(complaint))
    return Docker(
        machine=str(info.get("Name") or ""),
        containerd_store="io.containerd.snapshotter" in str(info.get("DriverStatus")),
        rootless="name=rootless" in str(info.get("SecurityOptions")),
    )


def address(program: str = "docker") -> str:
    """The address of the Docker that `docker` asks, by DOCKER_HOST or its context; empty if it does not say."""
    return _output(program, "context", "inspect", "--format", "{{.Endpoints.docker.Host}}")[0].strip()


def _output(program: str, *words: str) -> tuple[str, str]:
    """The output of Docker's client, and the last line that it complains with."""
    quiet = subprocess.DEVNULL
    try:
        done = subprocess.run([program, *words], stdin=quiet, capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return "", f"no answer within {SECONDS:.0f} s"
    except OSError as error:
        return "", f"cannot run {program}: {error.strerror}"
    return done.stdout.decode(errors="replace"), _line([done.stderr.decode(errors="replace").strip()])


def _line(texts: Any) -> str:
    """The last line of the first text."""
    first = texts[0] if isinstance(texts, list) and texts else ""
    return str(first).strip().rpartition("\n")[2]
