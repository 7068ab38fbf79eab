"""Moments as a run writes them, in UTC, and what may be said of a date that somebody else wrote."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta

from rosml.base.errors import RosmlError

TIME = "%Y-%m-%dT%H:%M:%SZ"

AHEAD = timedelta(days=1)
"""How far a date may be ahead of the clock: clocks differ, and so do the places where people write dates down."""


def checked_date(text: str) -> str:
    """A run's date.

    Raises:
        RosmlError: it is none (exit code 2).
    """
    if not is_date(text):
        raise RosmlError(f"{text!r} is no time", "write it as 2026-11-22T03:00:00Z", exit_code=2)
    return text


def is_date(text: str) -> bool:
    """Whether a text is a run's date, all of which are written alike: `2026-11-22T03:00:00Z`."""
    try:
        return datetime.strptime(text, TIME).strftime(TIME) == text  # which takes shorter numbers as well
    except ValueError:
        return False


def is_ahead(date: str, clock: str) -> bool:
    """Whether a run's date is in the future. Both are dates of runs."""
    return datetime.strptime(date, TIME) > datetime.strptime(clock, TIME) + AHEAD


def require_not_ahead(date: str, clock: str) -> None:
    """Checks the date of a run that begins now: until it comes, no other run could move the tags that it moves.

    Raises:
        RosmlError: it is in the future (exit code 2).
    """
    if is_ahead(date, clock):
        raise RosmlError(
            f"the run's date {date} is in the future (it is {clock}): no run before that date could move its tags",
            "correct the date, or this machine's clock; --force takes it all the same",
            exit_code=2,
        )


def now() -> str:
    """The date and time of a run, which is chosen once: 2026-11-22T03:00:00Z."""
    return datetime.now(UTC).strftime(TIME)
