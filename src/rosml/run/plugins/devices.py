"""The groups that may open the device files of a container."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence

from rosml.run.context import Context
from rosml.run.plugin import Plugin


def devices(context: Context) -> Sequence[str]:
    """The groups of device files that the user hands in by `--device`. A user in the container is in none of this machine's
    groups."""
    places = [place for value in context.line.values("device") if (place := value.partition(":")[0]).startswith("/")]
    if not context.is_here or "keep-groups" in context.line.values("group-add"):
        return []
    return groups(context, (node for place in places for node in _nodes(context, place)))


def groups(context: Context, nodes: Iterable[str]) -> list[str]:
    """The words for the groups that may open device files. Their numbers differ between machines. Without root's rights, the engine
    cannot give groups."""
    if context.engine.rootless:
        return []
    group_ids = {context.host.owner(node)[1] for node in nodes} - {0, -1, context.person.gid}
    return [word for group in sorted(group_ids) for word in ("--group-add", str(group))]


def _nodes(context: Context, place: str) -> list[str]:
    """A device file, or all device files in a folder, as with the engines."""
    within = [f"{folder}/{file}" for folder, _, files in os.walk(context.host.path(place)) for file in files]
    top = str(context.host.root).rstrip("/")
    return [file.removeprefix(top) for file in within] or [place]


PLUGIN = Plugin("devices", devices)
