"""Bytes and seconds as people read them."""

from __future__ import annotations


def size(count: int) -> str:
    """Bytes in decimal units, as registries count: ``3.61 GB``."""
    value = float(count)
    for unit in ("B", "kB", "MB", "GB"):
        if value < 1000 or unit == "GB":
            return f"{value:.0f} B" if unit == "B" else f"{value:.2f} {unit}" if unit == "GB" else f"{value:.1f} {unit}"
        value /= 1000
    raise AssertionError("unreachable")


def duration(seconds: float) -> str:
    """``75.2`` -> ``1 min 15 s``. Less than a minute keeps a decimal."""
    if seconds < 60:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    return f"{whole // 60} min {whole % 60} s"


def time_taken(seconds: float, waited: float) -> str:
    """A duration, and how much of it was spent waiting for another build, if that is a second or more."""
    wait = f" ({duration(waited)} of it waiting for another build)" if waited >= 1 else ""
    return f"{duration(seconds)}{wait}"


def ago(seconds: float) -> str:
    """An age for people, in its largest unit: ``3 hours ago``."""
    if seconds < 0:
        return "in the future"
    for unit, length in (("day", 86400), ("hour", 3600), ("minute", 60)):
        if seconds >= length:
            number = int(seconds // length)
            return f"{number} {unit}{'s'[: number != 1]} ago"
    return f"{int(seconds)} s ago"
