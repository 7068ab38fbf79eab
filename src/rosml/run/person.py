"""The user who calls, by this process and this machine."""

from __future__ import annotations

import os
import pwd
import stat
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.run.context import Person

ZONES = "zoneinfo/"


def person(environment: Mapping[str, str]) -> Person:
    """The user of this process."""
    uid, name = os.geteuid(), ""
    with suppress(KeyError):
        name = pwd.getpwuid(uid).pw_name
    try:
        folder = os.getcwd()
    except OSError as error:
        raise RosmlError(f"the current folder: {error.strerror}", "go to another folder", exit_code=2) from None
    locale = {k: v for k, v in environment.items() if k in ("LANG", "LANGUAGE") or k.startswith("LC_")}
    terminal = os.isatty(0) and os.isatty(1)
    return Person(uid, os.getegid(), name, folder, timezone(environment), locale, terminal, reads(0))


def timezone(environment: Mapping[str, str], etc: Path = Path("/etc")) -> str:
    """The name of the time zone: that of TZ, or else the system's; empty if neither has a name."""
    places = [environment.get("TZ", "").removeprefix(":")]
    with suppress(OSError):
        places.append(os.readlink(etc / "localtime"))
    with suppress(OSError, UnicodeDecodeError):
        places.append((etc / "timezone").read_text(encoding="utf-8").strip())
    return next(filter(None, map(_zone, places)), "")


def _zone(place: str) -> str:
    """The zone of a path, or of a name; empty for a path to anywhere else."""
    if ZONES in place:
        return place.rpartition(ZONES)[2]
    return "" if place.startswith(("/", ".")) else place


def reads(descriptor: int) -> bool:
    """Whether a descriptor may have something to read: a terminal, a pipe or a file; not /dev/null or a closed one."""
    try:
        status = os.fstat(descriptor)
        return not (stat.S_ISCHR(status.st_mode) and status.st_rdev == os.stat(os.devnull).st_rdev)
    except OSError:
        return False
