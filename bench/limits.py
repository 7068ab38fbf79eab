"""What was measured beside its limit, for an idle machine. Tests hold the work behind it: calls, requests, bytes, layers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from rosml.base.terminal import show, table


@dataclass(frozen=True)
class Held:
    """A median of seconds beside its limit."""

    what: str
    seconds: float
    limit: float


def missed(held: Iterable[Held]) -> list[str]:
    """Those that take too long, each with its numbers."""
    return [
        f"{item.what} takes {item.seconds:.2f} s; the limit of {item.limit} s holds"
        for item in held
        if item.seconds >= item.limit
    ]


def print_table(held: Iterable[Held]) -> None:
    """Prints medians beside their limits."""
    numbers = ("seconds", "limit")
    made = table("median of", *numbers, right=numbers)
    for item in held:
        made.add_row(item.what, f"{item.seconds:.3f}", f"{item.limit:.2f}")
    show(made)
