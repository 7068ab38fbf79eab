"""What rosml adds to `docker run`: one small function for each concern, from what is known to arguments of the engine.

A person's own options follow them on the engine's command line. Of two that set the same thing the engines take the last one,
which is the person's. Where they take both, or refuse two, a concern keeps out. An `--env-file` ranks below every `-e`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from rosml.base.errors import RosmlError
from rosml.run import paths
from rosml.run.context import Context, Person
from rosml.run.user import claims
from rosml.run.words import Line

TARGET = "src/target"
"""Where --mws mounts a folder, in the workspace."""

OURS = "io.rosml.component"
"""A label that all our images have."""

GRACE = 30
"""Seconds that a container has to stop. `ros2 launch` kills a node that hangs after 10, which is what the engines give a whole container,
roslaunch after 17 (docs/stopping.md)."""

FOLDER = "io.rosml.run.folder"
"""The label of a container that says from which folder it was started."""


def removal(context: Context) -> Sequence[str]:
    """The container is removed when it ends; the engines refuse that together with --restart."""
    line = context.line
    return [] if line.asks("no-rm") or line.has("rm", "rmi", "restart") else ["--rm"]


def terminal(context: Context) -> Sequence[str]:
    """Standard input and a terminal."""
    return streams(context.line, context.person)


def streams(line: Line, person: Person) -> Sequence[str]:
    """Standard input, where there is something to read, and a terminal, where there is one on both sides."""
    if line.asks("no-it"):
        return []
    reads = ["-i"] if person.reads and not line.has("interactive") else []
    return [*reads, *(["-t"] if person.terminal and not line.has("tty") else [])]


def label(context: Context) -> Sequence[str]:
    """The folder to which the container belongs: `rosml attach` finds it by that."""
    return ["--label", f"{FOLDER}={context.person.folder}"]


def grace(context: Context) -> Sequence[str]:
    """Time to save, in an image of ours, where a stop reaches what has to save. Others may not listen to a stop at all."""
    listens = OURS in context.image.labels and claims(context)
    return ["--stop-timeout", str(GRACE)] if listens and not context.line.has("stop-timeout") else []


def name_of(line: Line, person: Person) -> str:
    """The container's name: the person's own, or, on a terminal, that of the current folder; of the image where the folder's
    will not do. Empty where the engine makes one up: programs that call rosml twice at a time, as in a pipe, need two."""
    if line.has("name"):
        return line.value("name")
    if line.asks("no-name") or line.asks("new") or not person.terminal:
        return ""
    places = (person.folder, line.image.partition("@")[0])
    return next(filter(None, (_as_name(place.rpartition("/")[2]) for place in places)), "")


def _as_name(text: str) -> str:
    """Text with what the engines take in a container's name; empty where less than two characters are left."""
    name = re.sub(r"[^A-Za-z0-9_.-]+", "-", text).strip("-_.")
    return name if len(name) > 1 else ""


def name(context: Context) -> Sequence[str]:
    """A name by which people find the container, unless they wrote one."""
    found = "" if context.line.has("name") else name_of(context.line, context.person)
    return ["--name", found] if found else []


def timezone(context: Context) -> Sequence[str]:
    """The person's time zone; podman has an option for it."""
    line, zone = context.line, context.person.timezone
    return [] if line.asks("no-tz") or line.has("tz") or not zone else ["-e", f"TZ={zone}"]


def locale(context: Context) -> Sequence[str]:
    """The person's locale."""
    if not context.line.asks("loc"):
        return []
    return [word for key, value in context.person.locale.items() for word in ("-e", f"{key}={value}")]


def mounts(context: Context) -> Sequence[str]:
    """The current folder at its own path, where the command then begins; and in the image's workspace.

    Raises:
        RosmlError: the image has no workspace.
    """
    line, folder, added = context.line, context.person.folder, list[str]()
    for target in targets(line, folder, context.image.environment):
        added += ["--mount", paths.bind(folder, target), *(["--workdir", folder] if target == folder else [])]
    return added


def labels(context: Context, added: Sequence[str]) -> Sequence[str]:
    """SELinux lets no container read what rosml mounts: another label on it (`-v …:z`) would stay on a person's files, and no socket
    of their session can have one. So this container has no label, as in toolbox and distrobox.

    Args:
        added: what rosml adds.
    """
    line = context.line
    said = line.has("privileged") or any(value.startswith("label") for value in line.values("security-opt"))
    return ["--security-opt", "label=disable"] if context.engine.selinux and "--mount" in added and not said else []


def targets(line: Line, folder: str, environment: Mapping[str, str]) -> Sequence[str]:
    """Where the current folder is mounted, for --mwd and --mws.

    Args:
        environment: the image's, or the container's.

    Raises:
        RosmlError: the image has no workspace.
    """
    found = [folder] if line.asks("mwd") else []
    if line.asks("mws"):
        workspace = environment.get("WORKSPACE", "").rstrip("/")
        if not workspace:
            text = f"{line.image or 'the image'} has no workspace: WORKSPACE is not in its environment"
            raise RosmlError(text, "mount the folder with --mwd, or with -v .:/where", exit_code=2)
        found.append(f"{workspace}/{TARGET}")
    return found
