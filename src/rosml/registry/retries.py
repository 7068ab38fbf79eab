"""When a request that failed is sent again: how often, and after how many seconds. `transport.py` does it."""

from __future__ import annotations

import random

from rosml.registry.failures import Limited, Refused, Transient

ATTEMPTS = 7
"""How often a request is sent, in about half a minute."""

ATTEMPTS_UNREACHED = 3
"""The same, if the registry never answered, so that a wrong name fails soon."""

ATTEMPTS_REFUSED = 5
"""The same, if the registry refuses a request that it may accept later, in about eight seconds."""

ATTEMPTS_LIMITED = 2
"""The same, if the registry's first answer is that there were too many requests."""

WAIT, LONGEST_WAIT = 0.5, 30.0
"""Seconds before the second attempt, which double with each further one; and the most that a registry may ask for."""

TOO_LONG = 120.0
"""If a registry asks for a longer wait because of too many requests, nobody waits."""


def pause(error: Transient, attempt: int, reached: bool = True) -> float | None:
    """Seconds to wait before a request is sent again; None if it was sent often enough. `reached`: the registry ever answered."""
    most = ATTEMPTS_REFUSED if isinstance(error, Refused) else ATTEMPTS if reached else ATTEMPTS_UNREACHED
    if isinstance(error, Limited) and error.from_the_first:
        most = ATTEMPTS_LIMITED
    if attempt >= most or (isinstance(error, Limited) and error.after > TOO_LONG):
        return None
    backoff: float = WAIT * 2 ** (attempt - 1) + random.uniform(0, WAIT)
    return min(max(backoff, error.after), LONGEST_WAIT)
