"""What rosml adds to `docker run`: one small function for each concern, from what is known to arguments of the engine.

A person's own options follow them on the engine's command line. Where the engine takes the last of several, the person's
counts; where it takes all of them or refuses two, a concern keeps out.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from rosml.base.errors import RosmlError
from rosml.run import paths
from rosml.run.context import Context
from rosml.run.user import user

Concern = Callable[[Context], Sequence[str]]

TARGET = "src/target"
"""Where --mws mounts a folder, in the workspace."""


def removal(context: Context) -> Sequence[str]:
    """The container is removed when it ends; the engines refuse that together with --restart."""
    return [] if context.flags.no_rm or context.line.has("rm", "rmi", "restart") else ["--rm"]


def terminal(context: Context) -> Sequence[str]:
    """Standard input, where there is something to read, and a terminal, where there is one on both sides."""
    line, person = context.line, context.person
    if context.flags.no_it:
        return []
    reads = ["-i"] if person.reads and not line.has("interactive") else []
    return [*reads, *(["-t"] if person.terminal and not line.has("tty") else [])]


def name_of(context: Context) -> str:
    """The container's name: the person's own, or, on a terminal, that of the current folder; of the image where the folder's
    will not do. Empty where the engine makes one up: programs that call rosml twice at a time, as in a pipe, need two."""
    if context.line.has("name"):
        return context.line.value("name")
    if context.flags.no_name or not context.person.terminal:
        return ""
    places = (context.person.folder, context.line.image.partition("@")[0])
    return next(filter(None, (_as_name(place.rpartition("/")[2]) for place in places)), "")


def _as_name(text: str) -> str:
    """Text with what the engines take in a container's name; empty where less than two characters are left."""
    name = re.sub(r"[^A-Za-z0-9_.-]+", "-", text).strip("-_.")
    return name if len(name) > 1 else ""


def name(context: Context) -> Sequence[str]:
    """A name by which people find the container, unless they wrote one."""
    found = "" if context.line.has("name") else name_of(context)
    return ["--name", found] if found else []


def timezone(context: Context) -> Sequence[str]:
    """The person's time zone; podman has an option for it."""
    zone = context.person.timezone
    return [] if context.flags.no_tz or context.line.has("tz") or not zone else ["-e", f"TZ={zone}"]


def locale(context: Context) -> Sequence[str]:
    """The person's locale."""
    if not context.flags.loc:
        return []
    return [word for key, value in context.person.locale.items() for word in ("-e", f"{key}={value}")]


def mounts(context: Context) -> Sequence[str]:
    """The current folder at its own path, where the command then begins; and in the image's workspace.

    Raises:
        RosmlError: the image has no workspace.
    """
    folder, added = context.person.folder, list[str]()
    if context.flags.mwd:
        added += ["--mount", paths.bind(folder, folder), "--workdir", folder]
    if context.flags.mws:
        workspace = context.image.get("WORKSPACE", "").rstrip("/")
        if not workspace:
            text = f"{context.line.image} has no workspace: WORKSPACE is not in its environment"
            raise RosmlError(text, "mount the folder with --mwd, or with -v .:/where", exit_code=2)
        added += ["--mount", paths.bind(folder, f"{workspace}/{TARGET}")]
    return added


CONCERNS: tuple[Concern, ...] = (removal, terminal, name, user, timezone, locale, mounts)
"""All of them, in the order of their arguments."""


def argv(context: Context) -> list[str]:
    """The engine's command: what the concerns add, the person's own options, the image, and the command as it is.

    Raises:
        RosmlError: a concern cannot do what it is asked for.
    """
    line = context.line
    added = [word for concern in CONCERNS for word in concern(context)]
    written = [word for given in line.engine for word in paths.resolved(given, context.person.folder).words]
    return [context.engine.program, "run", *added, *written, line.image, *line.command]
