"""What is known when an image is started: data, which somebody else has found out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from rosml.run.words import Line


@dataclass(frozen=True)
class Flags:
    """What a person asks of rosml; all of it is off by default. `rosml run --help` says what each does."""

    no_name: bool = False
    no_rm: bool = False
    no_it: bool = False
    no_tz: bool = False
    no_user: bool = False
    loc: bool = False
    mwd: bool = False
    mws: bool = False


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
class Context:
    """All of it. Attributes: line: what was written. image: the image's environment variables."""

    line: Line
    flags: Flags
    engine: Engine
    person: Person
    image: Mapping[str, str]
