"""What is known when an image is started: data, which somebody else has found out."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from rosml.run.words import Line


@dataclass(frozen=True)
class Engine:
    """What runs containers. Attributes: program: its command. podman: it is podman, or podman by the name of docker.
    rootless: it runs without root's rights, so that root in a container is somebody else outside.
    nvidia: NVIDIA's container runtime is one of its runtimes. cdi: the folders in which it looks for CDI's files. machine: the
    name of the machine on which it runs; empty where it does not say. selinux: it gives its containers labels of SELinux.
    snap: it is a snap, which has its own /tmp and /run, and sees no socket of a session."""

    program: str = "docker"
    podman: bool = False
    rootless: bool = False
    nvidia: bool = False
    cdi: tuple[str, ...] = ()
    machine: str = ""
    selinux: bool = False
    snap: bool = False


@dataclass(frozen=True)
class Person:
    """Who calls, and from where.

    Attributes:
        uid, gid, name: as the system has them; the name is empty where it has none.
        folder: the current one, absolute.
        timezone: such as `Europe/Berlin`; empty where it is unknown.
        locale: `LANG`, `LANGUAGE` and `LC_…` of the environment.
        terminal: standard input and standard output are terminals. reads: standard input has, or may have, something to read.
    """

    uid: int
    gid: int
    name: str
    folder: str
    timezone: str = ""
    locale: Mapping[str, str] = field(default_factory=dict)
    terminal: bool = False
    reads: bool = False


@dataclass(frozen=True)
class Image:
    """An image, as the engine has it.

    Attributes:
        id: its digest, without `sha256:`.
        environment, labels, entrypoint, command: as it was built; the last is its `CMD`. user: as whom it starts.
    """

    id: str = ""
    environment: Mapping[str, str] = field(default_factory=dict)
    labels: Mapping[str, str] = field(default_factory=dict)
    entrypoint: tuple[str, ...] = ()
    command: tuple[str, ...] = ()
    user: str = ""


@dataclass(frozen=True)
class Container:
    """A container, as the engine has it.

    Attributes:
        state: such as `running` or `exited`.
        image: what it was started from, as it is called there. image_id: its digest, without `sha256:`.
        user: who runs in it, as `--user` has it; empty where nobody said so.
        mounts: the places in it where something is mounted.
        network, ipc: as `--network` and `--ipc` have them.
        sources: what of the engine's machine is mounted at these places; empty for what has no path there.
    """

    name: str
    state: str
    image: str = ""
    image_id: str = ""
    user: str = ""
    environment: Mapping[str, str] = field(default_factory=dict)
    labels: Mapping[str, str] = field(default_factory=dict)
    entrypoint: tuple[str, ...] = ()
    mounts: frozenset[str] = frozenset()
    network: str = ""
    ipc: str = ""
    sources: Mapping[str, str] = field(default_factory=dict)

    def loss(self, program: str) -> str:
        """What removing it takes away, for remedies: somebody has kept it."""
        return f"with all that was written in it; {program} commit {self.name} IMAGE keeps that"


LIMIT = 1024 * 1024
"""Bytes of a file that are read. Those of this machine's settings have fewer."""

Address = str | tuple[str, int]
"""Where something listens: the path of a socket, or a host and a port."""


def _nothing(address: Address) -> bool:
    return False


def _nowhere(place: str | int) -> bool:
    return False


@dataclass(frozen=True)
class Host:
    """This machine. Attributes: root: the folder under which its files are. environment: the caller's. name: its own.
    connects: whether something listens at an address; a path is below the root already. owns: whether an address, or what a
    name stands for, is one of this machine's own. echoes: whether a packet of multicast to a port comes back."""

    root: Path
    environment: Mapping[str, str] = field(default_factory=dict)
    name: str = ""
    connects: Callable[[Address], bool] = _nothing
    owns: Callable[[str], bool] = _nowhere
    echoes: Callable[[int], bool] = _nowhere

    def path(self, place: str) -> Path:
        """The file at an absolute path."""
        return self.root / place.lstrip("/")

    def has(self, *places: str) -> bool:
        """Whether there is a file at each of these paths."""
        return all(self.path(place).exists() for place in places)

    def content(self, place: str) -> bytes:
        """What is in a file; nothing if it is missing, may not be read, or is none: a pipe or a device may have no end."""
        try:
            with open(os.open(self.path(place), os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as stream:
                return stream.read(LIMIT) if stat.S_ISREG(os.fstat(stream.fileno()).st_mode) else b""
        except OSError:
            return b""

    def text(self, place: str) -> str:
        """The same as text."""
        return self.content(place).decode(errors="replace")

    def files(self, folder: str) -> list[str]:
        """The paths of what is in a folder."""
        try:
            return [f"{folder}/{name}" for name in sorted(os.listdir(self.path(folder)))]
        except OSError:
            return []

    def owner(self, place: str) -> tuple[int, int]:
        """The ids of the user and the group to whom a file belongs; -1 where it is missing."""
        try:
            found = self.path(place).stat()
        except OSError:
            return -1, -1
        return found.st_uid, found.st_gid

    def answers(self, socket: str) -> bool:
        """Whether something listens at a socket's path."""
        return self.connects(str(self.path(socket)))

    def program(self, name: str) -> bool:
        """Whether a program is installed. Those of services may be in a folder that is not on the caller's PATH."""
        folders = [*self.environment.get("PATH", "").split(":"), "/usr/bin", "/usr/local/bin"]
        return any(folder.startswith("/") and self.has(f"{folder}/{name}") for folder in folders)


@dataclass(frozen=True)
class Context:
    """All of it. Attributes: line: what was written. trusted: the person trusts the image's repository, so that the image may start
    as root. What the image says of itself does not count for that."""

    line: Line
    engine: Engine
    person: Person
    image: Image
    host: Host
    trusted: bool = False

    @property
    def is_here(self) -> bool:
        """Whether containers run on this machine, so that its devices and sockets are theirs."""
        return is_here(self.engine, self.host)


def is_here(engine: Engine, host: Host) -> bool:
    """Whether an engine runs containers on this machine. Docker Desktop has its own; that for Windows hands in what WSL has."""
    return engine.machine in ("", host.name) or (engine.machine == "docker-desktop" and host.has("/dev/dxg"))
