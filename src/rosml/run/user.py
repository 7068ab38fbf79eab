"""Who runs in the container, so that what is written into a mount belongs to the person who calls."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rosml.run.context import Context

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]{0,31}")
"""The names that an image's entrypoint takes for DOCKER_USER."""

KEPT = "--userns=keep-id"
"""podman without root: the person has the same uid in the container."""


def user(context: Context) -> Sequence[str]:
    """An image whose environment has DOCKER_UID makes that user itself (docs/contract.md). In another one, the person's bare
    ids run. In docker without root, root is the person. Where somebody says who runs, nothing is added."""
    line, engine = context.line, context.engine
    if line.asks("no-user") or line.has("user") or (engine.podman and line.has("userns")):
        return []
    makes_users = "DOCKER_UID" in context.image.environment and not line.has("entrypoint")
    if engine.rootless and not engine.podman:
        return [] if makes_users else ["--user", "0:0"]
    kept = [KEPT] if engine.rootless else []
    if not makes_users:
        return [*kept, *_bare(context)]
    return [*kept, *(["--user", "0:0"] if kept else []), *_contract(context)]


def _bare(context: Context) -> Sequence[str]:
    """The ids without a user: there is no home for them but /tmp. root has one."""
    person = context.person
    home = ["-e", "HOME=/tmp"] if person.uid else []
    return ["--user", f"{person.uid}:{person.gid}", *home]


def _contract(context: Context) -> Sequence[str]:
    """What an entrypoint makes the user from. A name that it would refuse is left out: the image has one."""
    person = context.person
    facts = {"DOCKER_UID": person.uid, "DOCKER_GID": person.gid}
    named = {"DOCKER_USER": person.name} if NAME.fullmatch(person.name) else {}
    return [word for key, value in {**facts, **named}.items() for word in ("-e", f"{key}={value}")]
