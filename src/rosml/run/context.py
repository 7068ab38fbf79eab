"""What is known when an image is started: data, which somebody else has found out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from rosml.run.words import Line


@dataclass(frozen=True)
class Engine:
    """What runs containers. Attributes: program: its command. podman: it is podman, or podman by the name of docker.
    rootless: it runs without root's rights, so that root in a container is somebody else outside."""

    program: str = "docker"
    podman: bool = False
    rootless: bool = False


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
        environment, labels, entrypoint, command: as it was built; the last is its `CMD`.
    """

    id: str = ""
    environment: Mapping[str, str] = field(default_factory=dict)
    labels: Mapping[str, str] = field(default_factory=dict)
    entrypoint: tuple[str, ...] = ()
    command: tuple[str, ...] = ()


@dataclass(frozen=True)
class Container:
    """A container, as the engine has it.

    Attributes:
        state: such as `running` or `exited`.
        image: what it was started from, as it is called there. image_id: its digest, without `sha256:`.
        user: who runs in it, as `--user` has it; empty where nobody said so.
        mounts: the places in it where something is mounted.
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


@dataclass(frozen=True)
class Context:
    """All of it. Attributes: line: what was written."""

    line: Line
    engine: Engine
    person: Person
    image: Image
