"""Whether the image of `rosml run` may start as root: asks the user whether to trust its repository."""

from __future__ import annotations

import os
from dataclasses import replace

from rosml import IN_CHECKOUT, STATE
from rosml.cli import command
from rosml.cli.run import container, question
from rosml.run.context import Context
from rosml.run.plugins.user import needs_trust

OPTION = "trust"


def settled(context: Context) -> Context:
    """The context with whether the image's repository is trusted. If the user has not said so, asks on a terminal and keeps
    the answer. If nothing runs, or there is no terminal, only warns."""
    says_so = context.line.asks(OPTION)
    if not says_so and not needs_trust(context):
        return context
    from rosml.run import consent, trust

    name = trust.repository(context.line.image, context.image.id, context.engine.podman)
    place, runs = consent.memory(os.environ), not container.only_shown(context.line)
    if says_so:
        if runs and consent.is_trusted(name, place) is not True:
            question.keep(place, consent.with_repository(name, True, place))
        return replace(context, trusted=True)
    if (answer := consent.is_trusted(name, place)) is not None:
        return replace(context, trusted=answer)
    if IN_CHECKOUT and trust.is_local(name, trust.local_registry(STATE)):
        return replace(context, trusted=True)
    if not runs or not question.possible() or context.line.has("userns"):
        text = f"{name} wants to start as root, and you have not trusted it: it runs as you, without sudo"
        command.warn(text, f"--{OPTION} trusts all images of that repository from now on")
        return context
    answer = question.agreed(
        f"{name} wants to start as root, and to make a user with your ids then.",
        "As root it can read and change all that you mount, and leave files of root's there. If not, it runs as you, without sudo.",
        f"Trust all images of {name}?",
    )
    question.keep(place, consent.with_repository(name, answer, place))
    return replace(context, trusted=answer)
