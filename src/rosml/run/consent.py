"""Consent: the settings of a project's file that need no question, and the memory of allowed files and trusted repositories.

A project, and so its file, may be a stranger's. rosml asks the user about everything that the file lets the container run,
reach or mount. That includes the image: a container can use the display, and so the keyboard. The exceptions follow here.
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
from rosml.run.words import Line, TypedOption

HARMLESS = frozenset(
    ("--loc", "--mwd", "--mws", "--no-gpu", "--no-it", "--no-name", "--no-rm", "--no-ros", "--no-tz", "--no-x11")
)
"""Options of rosml that take something away, or mount the current folder."""

HARMLESS_OF_ENGINE = frozenset(("cpus", "init", "interactive", "memory", "name", "rm", "shm-size", "tty"))
"""Options of the engine that let a container reach nothing."""

HARMLESS_VARIABLE = re.compile(
    "(ROS_DOMAIN_ID|ROS_LOCALHOST_ONLY|ROS_AUTOMATIC_DISCOVERY_RANGE|RMW_IMPLEMENTATION)=[A-Za-z0-9_]+"
)
"""Variables of a container that run nothing. Others can make a shell or a program run their value."""


def questionable(line: Line, trusted: bool, leads: Sequence[Lead] = (), folder: str = "") -> list[str]:
    """The settings of a file that need a question, as a shell reads them. If the file is not `trusted`, as another user's, all need it.
    `folder` is the project's."""
    image = [f"image {shlex.quote(line.image)}"] if line.image else []
    command = [f"command {shlex.join(line.command)}"] if line.command else []
    items = [*image, *command, *(word for word in line.rosml if word not in HARMLESS or not trusted)]
    for option in line.engine:
        if not (trusted and _is_harmless(option)):
            links = "; ".join(filter(None, (lead.shown(folder) for lead in leads if lead.words == option.words)))
            items.append(shlex.join(option.words) + (f" ({links})" if links else ""))
    return items


def _is_harmless(option: TypedOption) -> bool:
    """Whether options of the engine need no question. A word may have several, and all of them count."""
    harmless = HARMLESS_OF_ENGINE | ({"env"} if HARMLESS_VARIABLE.fullmatch(option.value or "") else frozenset())
    return set(option.names) <= harmless


IMAGES = "image "


def memory(environment: Mapping[str, str]) -> Path:
    """The file of answers: by a file's path the allowed digest, and by a repository of images whether the user trusts it."""
    return Path(base(environment, "XDG_STATE_HOME", ".local/state"), "rosml", "allowed.json")


def is_allowed(file: File, digest: str, place: Path) -> bool:
    """Whether the user has allowed a file with this digest."""
    return _allowed(place).get(file.path) == digest


def is_trusted(repository: str, place: Path) -> bool | None:
    """Whether the user trusts a repository; None if they have not said."""
    answer = _allowed(place).get(IMAGES + repository)
    return answer if isinstance(answer, bool) else None


def with_answer(key: str, answer: str | bool, place: Path) -> bytes:
    """The memory with the digest of a file, by its path, or whether the user trusts a repository, by its name after `IMAGES`."""
    return json.dumps(_allowed(place) | {key: answer}, indent=1).encode()


def _allowed(place: Path) -> dict[str, object]:
    """The memory. It is empty, so that rosml asks once more, if the file is missing, damaged, a link, or another user's, or if
    its folder is another user's or a link that another user made."""
    try:
        with open(os.open(place, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as stream:
            owners = {os.fstat(stream.fileno()).st_uid, os.lstat(place.parent).st_uid}
            answers = untrusted.json_value(stream.read(untrusted.SIZE + 1)) if owners == {os.geteuid()} else {}
    except (OSError, ValueError):
        return {}
    return answers if isinstance(answers, dict) else {}


def digest(file: File) -> str:
    """A SHA-256 over a file's content, the targets of its paths, and the content of files that the engine reads. A pipe or a device
    among them is an error, as its content changes with every read."""
    import hashlib  # most files want nothing

    targets = [[lead.path, lead.target, _read(lead) if lead.reads else ""] for lead in file.leads]
    return hashlib.sha256(json.dumps([hashlib.sha256(file.content).hexdigest(), targets]).encode()).hexdigest()


def _read(lead: Lead) -> str:
    """A digest of the file, or of the files in the folder, that the engine would read; empty if there is none."""
    import hashlib

    if lead.target == os.devnull:
        return ""
    try:
        if os.path.isdir(lead.target):
            files = (Lead(path, path) for name in sorted(os.listdir(lead.target)) if (path := f"{lead.target}/{name}"))
            digests = [[file.path, _read(file)] for file in files if not os.path.isdir(file.path)]
            return hashlib.sha256(json.dumps(digests).encode()).hexdigest()
        with open(os.open(lead.target, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as stream:
            if stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
                return hashlib.file_digest(stream, "sha256").hexdigest()
    except OSError:
        return ""
    raise RosmlError(f"{lead.path}: it is no file", "write the path of a file; --no-defaults leaves it out", 2)
