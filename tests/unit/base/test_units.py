"""Bytes and seconds as people read them."""

from __future__ import annotations

import pytest

from rosml.base import units


def test_size() -> None:
    sizes = (0, 999, 1000, 1_234_567, 999_000_000, 3_612_345_678, 2_500_000_000_000)
    assert [units.size(count) for count in sizes] == [
        *("0 B", "999 B", "1.0 kB", "1.2 MB", "999.0 MB", "3.61 GB", "2500.00 GB")
    ]


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(0, "0.0 s"), (3.14, "3.1 s"), (59.9, "59.9 s"), (60, "1 min 0 s"), (75.2, "1 min 15 s"), (119.6, "2 min 0 s")],
)
def test_duration(seconds: float, text: str) -> None:
    assert units.duration(seconds) == text


@pytest.mark.parametrize(
    ("waited", "text"), [(0.4, "2 min 38 s"), (85, "2 min 38 s (1 min 25 s of it waiting for another build)")]
)
def test_time_taken(waited: float, text: str) -> None:
    assert units.time_taken(158, waited) == text


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(-1, "in the future"), (9.9, "9 s ago"), (60, "1 minute ago"), (7199, "1 hour ago"), (200_000, "2 days ago")],
)
def test_ago(seconds: float, text: str) -> None:
    assert units.ago(seconds) == text
