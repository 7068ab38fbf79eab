"""What a project's file may say without being asked about, and what somebody has allowed.

The file comes with a project that somebody else may have written. Whatever it has the container run, reach or mount is asked
about, the image among it: a container can use the display, and so the keyboard. What follows is all that is not.
"""

from __future__ import annotations

import json
import os
import re
import shlex
from collections.abc import Mapping
from pathlib import Path

from rosml.base import untrusted
from rosml.run.defaults import File, base
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


def wanted(line: Line, trusted: bool) -> list[str]:
    """What a file wants and is asked about, as a shell reads it.

    Args:
        line: what it says. trusted: it belongs to the person; of another one's file, all is asked about.
    """
    image = [f"image {shlex.quote(line.image)}"] if line.image else []
    command = [f"command {shlex.join(line.command)}"] if line.command else []
    own = [word for word in line.own if word not in OWN or not trusted]
    return [*image, *command, *own, *(shlex.join(x.words) for x in line.engine if not (trusted and _is_harmless(x)))]


def _is_harmless(given: Given) -> bool:
    """Whether options of the engine need no question; several may be in one word, and all of them count."""
    known = ENGINES | ({"env"} if VARIABLE.fullmatch(given.value or "") else frozenset())
    return set(given.names) <= known


def is_own(owner: int, environment: Mapping[str, str]) -> bool:
    """Whether a file's owner is the person, or root; for root by sudo, also the one who called it."""
    uid, caller = os.geteuid(), environment.get("SUDO_UID", "")
    return owner in (uid, 0) or (uid == 0 and caller == str(owner))


# ---- What was allowed ------------------------------------------------------------------------------------------------


def memory(environment: Mapping[str, str]) -> Path:
    """The file that has what was allowed: for each path, the SHA-256 of its content."""
    return Path(base(environment, "XDG_STATE_HOME", ".local/state"), "rosml", "allowed.json")


def is_allowed(file: File, place: Path) -> bool:
    """Whether a file was allowed as it is now."""
    return _allowed(place).get(file.path) == _digest(file)


def remembered(file: File, place: Path) -> bytes:
    """What is in that file once another file is allowed, until that one changes."""
    return json.dumps(_allowed(place) | {file.path: _digest(file)}, indent=1).encode()


def _allowed(place: Path) -> dict[str, object]:
    """All that was allowed: nothing where the file is missing, damaged, or another user's, so that people are asked once more."""
    try:
        with place.open("rb") as stream:
            own = os.fstat(stream.fileno()).st_uid == os.geteuid()
            found = untrusted.json_value(stream.read(untrusted.SIZE + 1)) if own else {}
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def _digest(file: File) -> str:
    import hashlib  # most files want nothing

    return hashlib.sha256(file.content).hexdigest()
