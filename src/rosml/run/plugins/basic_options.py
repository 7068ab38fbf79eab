"""The options of every container: removal, terminal, name, label, time to stop, time zone, locale, mounts.

The user's own options follow them. Of two that set the same thing, the engines take the last one, which is the user's. If the
engines would take both, or refuse two, nothing is added. An `--env-file` ranks below every `-e`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from rosml.base.errors import RosmlError
from rosml.run import paths
from rosml.run.context import Context, Person
from rosml.run.plugins.user import claims
from rosml.run.words import Line, variables

TARGET = "src/target"
COMPONENT_LABEL = "io.rosml.component"
GRACE = 30
"""Seconds that a container has to stop. The engines' default is 10, but `ros2 launch` kills a hanging node only after 10, and
roslaunch after 17 (docs/stopping.md)."""

FOLDER_LABEL = "io.rosml.run.folder"
"""The label of a container with the folder from which it was started."""


def removal(context: Context) -> Sequence[str]:
    """Removes the container when it ends. The engines refuse that together with --restart."""
    line = context.line
    return [] if line.asks("no-rm") or line.has("rm", "rmi", "restart") else ["--rm"]


def terminal(context: Context) -> Sequence[str]:
    return streams(context.line, context.person)


def streams(line: Line, person: Person) -> Sequence[str]:
    """Standard input if there is something to read, and a terminal if there is one on both sides."""
    if line.asks("no-it"):
        return []
    reads = ["-i"] if person.reads and not line.has("interactive") else []
    return [*reads, *(["-t"] if person.terminal and not line.has("tty") else [])]


def label(context: Context) -> Sequence[str]:
    """The container's folder: `rosml attach` finds the container by it."""
    return ["--label", f"{FOLDER_LABEL}={context.person.folder}"]


def grace(context: Context) -> Sequence[str]:
    """Time to save data, in our images, in which a stop reaches all programs. Other images may ignore a stop."""
    listens = COMPONENT_LABEL in context.image.labels and claims(context)
    return ["--stop-timeout", str(GRACE)] if listens and not context.line.has("stop-timeout") else []


def name_of(line: Line, person: Person) -> str:
    """The container's name: the user's own, or, on a terminal, that of the current folder; of the image if the folder's does not
    fit. Empty if the engine shall make one up: programs that call rosml twice at a time, as in a pipe, need two."""
    if line.has("name"):
        return line.value("name")
    if line.asks("no-name") or line.asks("new") or not person.terminal:
        return ""
    places = (person.folder, line.image.partition("@")[0])
    return next(filter(None, (as_name(place.rpartition("/")[2]) for place in places)), "")


def as_name(text: str) -> str:
    """Text with only the characters of a container's name; empty if fewer than two remain."""
    name = re.sub(r"[^A-Za-z0-9_.-]+", "-", text).strip("-_.")
    return name if len(name) > 1 else ""


def name(context: Context) -> Sequence[str]:
    container_name = "" if context.line.has("name") else name_of(context.line, context.person)
    return ["--name", container_name] if container_name else []


def timezone(context: Context) -> Sequence[str]:
    line, zone = context.line, context.person.timezone
    return [] if line.asks("no-tz") or line.has("tz") or not zone else ["-e", f"TZ={zone}"]


def locale(context: Context) -> Sequence[str]:
    return variables(context.person.locale) if context.line.asks("loc") else []


def mounts(context: Context) -> Sequence[str]:
    """The current folder, at its own path, in which the command then begins, and in the image's workspace."""
    line, folder, added = context.line, context.person.folder, list[str]()
    for target in targets(line, folder, context.image.environment):
        added += ["--mount", paths.bind(folder, target), *(["--workdir", folder] if target == folder else [])]
    return added


def labels(context: Context, added: Sequence[str]) -> Sequence[str]:
    """No SELinux label, as in toolbox and distrobox: with one, a container could not read our mounts. Another label on them
    (`-v …:z`) would stay on the user's files, and sockets of their session cannot have one. `added` are rosml's options."""
    line = context.line
    is_typed = line.has("privileged") or any(value.startswith("label") for value in line.values("security-opt"))
    return ["--security-opt", "label=disable"] if context.engine.selinux and "--mount" in added and not is_typed else []


def targets(line: Line, folder: str, environment: Mapping[str, str]) -> Sequence[str]:
    """The paths at which --mwd and --mws mount the current folder. The environment is that of the image or the container."""
    paths_inside = [folder] if line.asks("mwd") else []
    if line.asks("mws"):
        workspace = environment.get("WORKSPACE", "").rstrip("/")
        if not workspace:
            text = f"{line.image or 'the image'} has no workspace: WORKSPACE is not in its environment"
            raise RosmlError(text, "mount the folder with --mwd, or with -v .:/where", exit_code=2)
        paths_inside.append(f"{workspace}/{TARGET}")
    return paths_inside
