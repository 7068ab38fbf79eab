"""What was measured beside its limit, for an idle machine. Tests hold the work behind it: calls, requests, bytes, layers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from rich.table import Table

from rosml.listing import show


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
    table = Table(box=None, header_style="bold", pad_edge=False)
    table.add_column("median of", no_wrap=True)
    for column in ("seconds", "limit"):
        table.add_column(column, justify="right", no_wrap=True)
    for item in held:
        table.add_row(item.what, f"{item.seconds:.3f}", f"{item.limit:.2f}")
    show(table)
