"""The facts about a call of `rosml run`, as plain data."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from rosml.run.words import Line

PODMAN_CDI = ("/etc/cdi", "/var/run/cdi")
"""The folders in which podman looks for CDI files."""


OLD_DOCKER = "docker before version 23 cannot read layers with zstd, which rosml's images have"
"""Docker 23.0 reads them first: https://docs.docker.com/engine/release-notes/23.0/"""
NEW_DOCKER = "update Docker (https://docs.docker.com/engine/install), or take podman: ROSML_ENGINE=podman"


@dataclass(frozen=True)
class Engine:
    """The engine, docker or podman."""

    program: str = "docker"
    podman: bool = False  # also of podman by the name of docker
    rootless: bool = False  # root in a container is another user outside
    nvidia: bool = False  # NVIDIA's container runtime is one of its runtimes
    cdi: tuple[str, ...] = ()  # the folders in which it looks for CDI files
    machine: str = ""  # the name of its machine; empty if unknown
    selinux: bool = False
    snap: bool = False  # it has its own /tmp and /run, and sees no socket of a session
    passwd: bool = True  # podman's `run` has --passwd and --passwd-entry
    chains: bool = False  # docker's classic store finds a layer of an image by all that is below it
    zstd: bool = True  # it reads layers that are compressed with zstd. docker does since 23
    version: str = ""  # such as `29.9.3`; empty if it says none that we understand

    def is_on(self, host: Host) -> bool:
        """Whether it runs containers on a machine. Docker Desktop has its own machine; on Windows it shares WSL's files."""
        return self.machine in ("", host.name) or (self.machine == "docker-desktop" and host.has("/dev/dxg"))


@dataclass(frozen=True)
class Person:
    """The user who calls."""

    uid: int
    gid: int
    name: str  # empty if the system has none
    folder: str  # the current one, absolute
    timezone: str = ""  # such as `Europe/Berlin`; empty if unknown
    locale: Mapping[str, str] = field(default_factory=dict)  # `LANG`, `LANGUAGE` and `LC_…`
    terminal: bool = False  # standard input and standard output are terminals
    reads: bool = False  # standard input may have something to read


@dataclass(frozen=True)
class Health:
    """The HEALTHCHECK of an image. Durations are in seconds; 0 stands for the engine's default."""

    command: tuple[str, ...] = ()
    interval: float = 0
    timeout: float = 0
    start_period: float = 0
    retries: int = 0


@dataclass(frozen=True)
class Image:
    """An image of the engine."""

    id: str = ""  # without `sha256:`
    environment: Mapping[str, str] = field(default_factory=dict)
    labels: Mapping[str, str] = field(default_factory=dict)
    entrypoint: tuple[str, ...] = ()
    command: tuple[str, ...] = ()
    user: str = ""
    digest: str = ""  # of the manifest for this architecture, if the engine names one
    digests: tuple[str, ...] = ()  # its names in registries, such as `ghcr.io/me/ros@sha256:…`
    health: Health = field(default_factory=Health)


@dataclass(frozen=True)
class Container:
    """A container of the engine. `user`, `network` and `ipc` are the values of these options."""

    name: str
    state: str  # such as `running` or `exited`
    image: str = ""  # as typed
    image_id: str = ""  # without `sha256:`
    user: str = ""
    environment: Mapping[str, str] = field(default_factory=dict)
    labels: Mapping[str, str] = field(default_factory=dict)
    entrypoint: tuple[str, ...] = ()
    mounts: frozenset[str] = frozenset()
    network: str = ""
    ipc: str = ""
    sources: Mapping[str, str] = field(default_factory=dict)  # the mounts' paths on the engine's machine; empty if none

    def loss(self, program: str) -> str:
        """What is lost if it is removed, for remedies."""
        return f"with all that was written in it; {program} commit {self.name} IMAGE keeps that"


LIMIT = 1024 * 1024
Address = str | tuple[str, int]


@dataclass(frozen=True)
class Host:
    """This machine, whose files are below `root`. `host.py` says what `connects`, `owns` and `echoes` are; a path has the root already."""

    root: Path
    environment: Mapping[str, str] = field(default_factory=dict)  # the caller's
    name: str = ""
    connects: Callable[[Address], bool] = lambda address: False
    owns: Callable[[str], bool] = lambda name: False
    echoes: Callable[[int], bool] = lambda port: False
    architecture: str = ""  # as images name it, such as `amd64`; empty if unknown

    def path(self, place: str) -> Path:
        return self.root / place.lstrip("/")

    def has(self, *places: str) -> bool:
        return all(self.path(place).exists() for place in places)

    def content(self, place: str) -> bytes:
        """The content of a file; nothing if it is missing, not readable, or no file: a pipe or a device may have no end."""
        try:
            with open(os.open(self.path(place), os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as stream:
                return stream.read(LIMIT) if stat.S_ISREG(os.fstat(stream.fileno()).st_mode) else b""
        except OSError:
            return b""

    def text(self, place: str) -> str:
        return self.content(place).decode(errors="replace")

    def files(self, folder: str) -> list[str]:
        try:
            return [f"{folder}/{name}" for name in sorted(os.listdir(self.path(folder)))]
        except OSError:
            return []

    def owner(self, place: str) -> tuple[int, int]:
        """The ids of a file's user and group; -1 if it is missing."""
        try:
            status = self.path(place).stat()
        except OSError:
            return -1, -1
        return status.st_uid, status.st_gid

    def answers(self, socket: str) -> bool:
        """Whether something listens at a socket's path."""
        return self.connects(str(self.path(socket)))

    def program(self, name: str) -> bool:
        """Whether a program is installed. A service's program may be in a folder that is not on the caller's PATH."""
        folders = [*self.environment.get("PATH", "").split(":"), "/usr/bin", "/usr/local/bin"]
        return any(folder.startswith("/") and self.has(f"{folder}/{name}") for folder in folders)


@dataclass(frozen=True)
class Context:
    """All facts. `trusted`: the user trusts the image's repository, so that the image may start as root."""

    line: Line
    engine: Engine
    person: Person
    image: Image
    host: Host
    trusted: bool = False

    @property
    def is_here(self) -> bool:
        """Whether containers run on this machine and can have its devices and sockets."""
        return self.engine.is_on(self.host)
