"""What a project's file may say without being asked about, and what somebody has allowed: files, and repositories of images.

The file comes with a project that somebody else may have written. Whatever it has the container run, reach or mount is asked
about, the image among it: a container can use the display, and so the keyboard. What follows is all that is not.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import stat
from collections.abc import Mapping, Sequence
from pathlib import Path

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.run.defaults import File, base
from rosml.run.paths import Lead
from rosml.run.words import Given, Line

OWN = frozenset(
    ("--loc", "--mwd", "--mws", "--no-gpu", "--no-it", "--no-name", "--no-rm", "--no-ros", "--no-tz", "--no-x11")
)
"""Options of rosml that take something away, or mount the folder in which somebody calls it."""

ENGINES = frozenset(("cpus", "init", "interactive", "memory", "name", "rm", "shm-size", "tty"))
"""Options of the engine that give a container nothing to reach."""

VARIABLE = re.compile(
    "(ROS_DOMAIN_ID|ROS_LOCALHOST_ONLY|ROS_AUTOMATIC_DISCOVERY_RANGE|RMW_IMPLEMENTATION)=[A-Za-z0-9_]+"
)
"""Variables of a container from which nothing runs. Others make a shell or a program run what they say."""


def wanted(line: Line, trusted: bool, leads: Sequence[Lead] = (), folder: str = "") -> list[str]:
    """What a file wants and is asked about, as a shell reads it.

    Args:
        line: what it says. trusted: it belongs to the person; of another one's file, all is asked about.
        leads, folder: where its paths lead, and the project's folder.
    """
    image = [f"image {shlex.quote(line.image)}"] if line.image else []
    command = [f"command {shlex.join(line.command)}"] if line.command else []
    own = [word for word in line.own if word not in OWN or not trusted]
    engine = [given for given in line.engine if not (trusted and _is_harmless(given))]
    return [*image, *command, *own, *(_shown(given, leads, folder) for given in engine)]


def _shown(given: Given, leads: Sequence[Lead], folder: str) -> str:
    """Options of the engine, with the links on the way to what they name."""
    said = "; ".join(filter(None, (lead.said(folder) for lead in leads if lead.words == given.words)))
    return shlex.join(given.words) + (f" ({said})" if said else "")


def _is_harmless(given: Given) -> bool:
    """Whether options of the engine need no question; several may be in one word, and all of them count."""
    known = ENGINES | ({"env"} if VARIABLE.fullmatch(given.value or "") else frozenset())
    return set(given.names) <= known


# ---- What was allowed ------------------------------------------------------------------------------------------------

IMAGES = "image "
"""What stands before a repository in the memory; files begin with `/`."""


def memory(environment: Mapping[str, str]) -> Path:
    """The file that has what was allowed: for each path of a file its `digest`, and for each repository of images whether it is
    trusted."""
    return Path(base(environment, "XDG_STATE_HOME", ".local/state"), "rosml", "allowed.json")


def is_allowed(file: File, digest: str, place: Path) -> bool:
    """Whether a file was allowed as it is now. `digest`: its own."""
    return _allowed(place).get(file.path) == digest


def is_trusted(repository: str, place: Path) -> bool | None:
    """Whether a repository is trusted; None if nobody has said so."""
    found = _allowed(place).get(IMAGES + repository)
    return found if isinstance(found, bool) else None


def with_file(file: File, digest: str, place: Path) -> bytes:
    """What is in that memory once a file is allowed, until its digest changes."""
    return _with(file.path, digest, place)


def with_repository(repository: str, trusted: bool, place: Path) -> bytes:
    """The same once somebody has said whether they trust a repository."""
    return _with(IMAGES + repository, trusted, place)


def _with(key: str, value: object, place: Path) -> bytes:
    return json.dumps(_allowed(place) | {key: value}, indent=1).encode()


def _allowed(place: Path) -> dict[str, object]:
    """All that was allowed: nothing if the file is missing, damaged, a link, or another user's, so that people are asked once more.
    The same holds if the folder is another user's, or a link that another user made."""
    try:
        with open(os.open(place, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as stream:
            owners = {os.fstat(stream.fileno()).st_uid, os.lstat(place.parent).st_uid}
            found = untrusted.json_value(stream.read(untrusted.SIZE + 1)) if owners == {os.geteuid()} else {}
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


# ---- What a file is ---------------------------------------------------------------------------------------------------


def digest(file: File) -> str:
    """A SHA-256 over a file's content, over where its paths lead, and over the content of files that the engine reads.

    Raises:
        RosmlError: one of these is a pipe or a device, in which something else is whenever it is read.
    """
    import hashlib  # most files want nothing

    led = [[lead.path, lead.target, _read(lead) if lead.reads else ""] for lead in file.leads]
    return hashlib.sha256(json.dumps([hashlib.sha256(file.content).hexdigest(), led]).encode()).hexdigest()


def _read(lead: Lead) -> str:
    """A digest of what the engine would read: of a file, or of the files in a folder; empty if there is none to be read.

    Raises:
        RosmlError: as in `digest`.
    """
    import hashlib

    if lead.target == os.devnull:
        return ""
    try:
        if os.path.isdir(lead.target):
            inside = (Lead(path, path) for name in sorted(os.listdir(lead.target)) if (path := f"{lead.target}/{name}"))
            found = [[each.path, _read(each)] for each in inside if not os.path.isdir(each.path)]
            return hashlib.sha256(json.dumps(found).encode()).hexdigest()
        with open(os.open(lead.target, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as stream:
            if stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
                return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError:
        return ""
    raise RosmlError(f"{lead.path}: it is no file", "write the path of a file; --no-defaults leaves it out", 2)
