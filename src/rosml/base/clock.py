"""Dates of publishing runs, in UTC, and checks of dates from outside."""

from __future__ import annotations

from datetime import UTC, date, datetime, timedelta

from rosml.base.errors import RosmlError

TIME = "%Y-%m-%dT%H:%M:%SZ"

AHEAD = timedelta(days=1)
"""How far a date may be ahead of the clock: clocks and time zones differ."""


def checked_date(text: str) -> str:
    """Returns a run's date, or raises RosmlError (exit code 2)."""
    if not is_date(text):
        raise RosmlError(f"{text!r} is no time", "write it as 2026-11-22T03:00:00Z", exit_code=2)
    return text


def is_date(text: str) -> bool:
    """Whether a text is a run's date: exactly as in `2026-11-22T03:00:00Z`."""
    try:
        return datetime.strptime(text, TIME).strftime(TIME) == text  # strptime also takes shorter numbers
    except ValueError:
        return False


def is_ahead(date: str, clock: str) -> bool:
    return datetime.strptime(date, TIME) > datetime.strptime(clock, TIME) + AHEAD


def require_not_ahead(date: str, clock: str) -> None:
    if is_ahead(date, clock):
        text = f"the run's date {date} is in the future (it is {clock}): no run before that date could move its tags"
        raise RosmlError(text, "correct the date, or this machine's clock; --force takes it anyway", exit_code=2)


def now() -> str:
    """The time now, as a run's date: `2026-11-22T03:00:00Z`."""
    return datetime.now(UTC).strftime(TIME)


def today() -> date:
    """The day now, in UTC, as publishing runs count it."""
    return day_of(now())


def day_of(date_of_run: str) -> date:
    """The day of a run's date."""
    return datetime.strptime(date_of_run, TIME).date()
