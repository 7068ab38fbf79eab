"""The user in the container: files in a mount shall belong to the user who calls."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rosml.run.context import Context
from rosml.run.words import variables

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]{0,31}")
"""The names that an image's entrypoint takes for DOCKER_USER."""

SYSTEM = (
    *("_apt", "backup", "bin", "daemon", "games", "gnats", "irc", "list", "lp", "mail", "man", "messagebus", "news"),
    *("nobody", "proxy", "root", "sshd", "sync", "sys", "uucp", "www-data"),
)
"""Names of system users in images. They have their own uids, so an entrypoint makes no second one."""

KEEP_ID = "--userns=keep-id"
VARIABLE = "DOCKER_UID"
"""A variable in the environment of images that make the user themselves, and start as root for that (docs/contract.md). Any
image can claim so."""

NO_ENTRY = "--passwd=false"
ENTRY_OPTIONS = ("passwd", "passwd-entry", "group-entry", "hostuser")
LOCKED = "no-new-privileges"
"""The value of --security-opt that gives no setuid program of the image another user's rights."""


def user(context: Context) -> Sequence[str]:
    """The words that decide who runs.

    - If the image makes the user itself and may start as root, it gets the user's ids as variables. It is started as root even
      if it names another user.
    - In other images the bare ids run. An engine with root locks them in; otherwise a setuid program of the image would be root.
    - In docker without root, root is the user.
    - If the user chooses who runs, nothing is added, except `_entry` with --mwd, which sets the working directory.
    """
    engine = context.engine
    if _is_chosen(context):
        return _entry(context, NO_ENTRY) if context.line.asks("mwd") else []
    makes_users = claims(context) and (context.trusted or not _gains(context))
    root = ["--user", "0:0"]
    as_root = context.image.user.partition(":")[0] in ("", "0", "root")
    if engine.rootless and not engine.podman:
        return [] if makes_users and as_root else root
    namespace = [KEEP_ID] if engine.rootless else []
    if not makes_users:
        return [*namespace, *_bare(context), *(_locked(context) if _gains(context) else [])]
    if namespace:
        return [*namespace, *root, *_entry(context, NO_ENTRY), *_contract(context)]
    return [*([] if as_root else root), *_contract(context)]


def needs_trust(context: Context) -> bool:
    """Whether the user's trust decides who runs: the image wants to start as root, root in it has more rights than the user, and
    the user does not choose who runs."""
    return claims(context) and _gains(context) and not _is_chosen(context)


def _is_chosen(context: Context) -> bool:
    line = context.line
    return line.asks("no-user") or line.has("user") or (context.engine.podman and line.has("userns"))


def claims(context: Context) -> bool:
    """Whether the image claims that its entrypoint makes the user, and that entrypoint runs."""
    return VARIABLE in context.image.environment and not context.line.has("entrypoint")


def _gains(context: Context) -> bool:
    """Whether root in the container has rights that the user lacks."""
    return not context.engine.rootless and context.person.uid != 0


def _bare(context: Context) -> Sequence[str]:
    """The bare ids. Their home is /tmp, and their name is in variables, which Python's getpass reads. root has its own."""
    person = context.person
    ids = f"{person.uid}:{person.gid}"
    if not person.uid:
        return ["--user", ids]
    names = {"USER": person.name, "LOGNAME": person.name} if person.name else {}
    entry = f"--passwd-entry={person.name or person.uid}:*:{ids}::/tmp:/bin/sh"
    return ["--user", ids, *_entry(context, entry), *variables({"HOME": "/tmp", **names})]


def _entry(context: Context, option: str) -> Sequence[str]:
    """The option about podman's entry in the container's /etc/passwd, for a user whom the image lacks. In podman's own entry the
    home is the working directory, and so a mounted project: programs would leave their files in it. Nothing if the user types such
    an option, or podman is too old for it."""
    engine = context.engine
    return [option] if engine.podman and engine.passwd and not context.line.has(*ENTRY_OPTIONS) else []


def _locked(context: Context) -> Sequence[str]:
    """The option against more rights than at the start, unless the user types another value."""
    is_typed = any(value.startswith(LOCKED) for value in context.line.values("security-opt"))
    return [] if is_typed else ["--security-opt", LOCKED]


def _contract(context: Context) -> Sequence[str]:
    """The variables from which an entrypoint makes the user. A name that it would refuse is left out: the image has one."""
    person = context.person
    fits = NAME.fullmatch(person.name) and person.name not in SYSTEM
    name = {"DOCKER_USER": person.name} if fits else {}
    return variables({VARIABLE: person.uid, "DOCKER_GID": person.gid, **name})
