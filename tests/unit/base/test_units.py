"""Bytes and seconds as people read them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from rosml.base import units


@pytest.mark.parametrize(
    ("function", "numbers", "texts"),
    [
        (units.size, (0, 999, 1000, 1_234_567, 3_612_345_678, 2_500_000_000_000),
         ("0 B", "999 B", "1.0 kB", "1.2 MB", "3.61 GB", "2500.00 GB")),
        (units.duration, (0, 59.9, 60, 75.2, 119.6), ("0.0 s", "59.9 s", "1 min 0 s", "1 min 15 s", "2 min 0 s")),
        (units.ago, (-1, 9.9, 60, 7199, 200_000), ("in the future", "9 s ago", "1 minute ago", "1 hour ago", "2 days ago")),
        (lambda wait: units.time_taken(158, wait), (0.4, 85),
         ("2 min 38 s", "2 min 38 s (1 min 25 s of it waiting for another build)")),
    ],
    ids=["size", "duration", "ago", "time taken"],
)  # fmt: skip
def test_units(function: Callable[[float], str], numbers: tuple[float, ...], texts: tuple[str, ...]) -> None:
    assert tuple(map(function, numbers)) == texts
