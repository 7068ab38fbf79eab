"""Who runs in the container, so that what is written into a mount belongs to the person who calls."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from rosml.run.context import Context

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]{0,31}")
"""The names that an image's entrypoint takes for DOCKER_USER."""

SYSTEM = frozenset(
    [
        "_apt",
        "backup",
        "bin",
        "daemon",
        "games",
        "gnats",
        "irc",
        "list",
        "lp",
        "mail",
        "man",
        "messagebus",
        "news",
        "nobody",
        "proxy",
        "root",
        "sshd",
        "sync",
        "sys",
        "uucp",
        "www-data",
    ]
)
"""Names that users of the image's system have, with uids of their own: an entrypoint makes no second one."""

KEPT = "--userns=keep-id"
"""podman without root: the person has the same uid in the container."""

VARIABLE = "DOCKER_UID"
"""An image whose environment has it makes the user itself, and starts as root for that (docs/contract.md). Any image can say so."""

LOCKED = "no-new-privileges"
"""The value of --security-opt with which no setuid program of the image gets another user's rights."""


def user(context: Context) -> Sequence[str]:
    """An image that makes the user itself gets the person's ids as variables, if it may start as root. In another one, the bare ids
    run, and an engine with root locks them in: otherwise a setuid program of the image would be root. In docker without root, root
    is the person. An image that makes the user and starts as another one is started as root. If somebody says who runs, nothing is added."""
    line, engine = context.line, context.engine
    if line.asks("no-user") or line.has("user") or (engine.podman and line.has("userns")):
        return []
    makes_users = claims(context) and (context.trusted or not _gains(context))
    root = ["--user", "0:0"]
    as_root = context.image.user.partition(":")[0] in ("", "0", "root")
    if engine.rootless and not engine.podman:
        return [] if makes_users and as_root else root
    kept = [KEPT] if engine.rootless else []
    if not makes_users:
        return [*kept, *_bare(context), *(_locked(context) if _gains(context) else [])]
    return [*kept, *([] if as_root and not kept else root), *_contract(context)]


def needs_trust(context: Context) -> bool:
    """Whether it depends on the person's trust who runs: the image wants to start as root, root in it has more rights than the
    person, and nobody says who runs."""
    line = context.line
    said = line.asks("no-user") or line.has("user") or (context.engine.podman and line.has("userns"))
    return claims(context) and _gains(context) and not said


def claims(context: Context) -> bool:
    """Whether the image says that its entrypoint makes the user, and that entrypoint runs."""
    return VARIABLE in context.image.environment and not context.line.has("entrypoint")


def _gains(context: Context) -> bool:
    """Whether root in the container has rights that the person lacks."""
    return not context.engine.rootless and context.person.uid != 0


def _bare(context: Context) -> Sequence[str]:
    """The ids without a user: there is no home for them but /tmp, and no name but in variables, where Python's getpass looks. root
    has both."""
    person = context.person
    facts = {"HOME": "/tmp", **({"USER": person.name, "LOGNAME": person.name} if person.name else {})}
    return ["--user", f"{person.uid}:{person.gid}", *(_variables(facts) if person.uid else [])]


def _locked(context: Context) -> Sequence[str]:
    """No other rights than those with which the container starts, unless somebody says something else."""
    said = any(value.startswith(LOCKED) for value in context.line.values("security-opt"))
    return [] if said else ["--security-opt", LOCKED]


def _contract(context: Context) -> Sequence[str]:
    """What an entrypoint makes the user from. A name that it would refuse is left out: the image has one."""
    person = context.person
    facts = {VARIABLE: person.uid, "DOCKER_GID": person.gid}
    fits = NAME.fullmatch(person.name) and person.name not in SYSTEM
    named = {"DOCKER_USER": person.name} if fits else {}
    return _variables({**facts, **named})


def _variables(facts: Mapping[str, object]) -> list[str]:
    """The words for environment variables."""
    return [word for key, value in facts.items() for word in ("-e", f"{key}={value}")]
