"""The end of `make image`: what was made and where the time went, on one screen."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rosml.publish import Result


def size(count: int) -> str:
    """Bytes for people, in decimal units as registries count: ``3.61 GB``."""
    value = float(count)
    for unit in ("B", "kB", "MB", "GB"):
        if value < 1000 or unit == "GB":
            return f"{value:.0f} B" if unit == "B" else f"{value:.2f} {unit}" if unit == "GB" else f"{value:.1f} {unit}"
        value /= 1000
    raise AssertionError("unreachable")


def duration(seconds: float) -> str:
    """``75.2`` -> ``1 min 15 s``; short ones keep a decimal."""
    if seconds < 60:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    return f"{whole // 60} min {whole % 60} s"


def text(result: Result) -> str:
    """The summary as aligned lines."""
    moved = ", ".join(result.moved) if result.moved else "none: all pointed here already"
    shared = f" ({size(result.payloads)} of it payloads, which other images share)" if result.payloads else ""
    tagged = [
        ("digest", result.digest),
        ("tags", ", ".join(tag.rsplit("/", 1)[1] for tag in result.tags)),
        ("tags moved", moved),
    ]
    rows = [
        ("FROM", result.reference),
        *(tagged if result.tags else [("tags", "none: a tag is for all platforms of an image")]),
        ("base image", result.base),
        ("build on it", result.builder),
        ("size", f"{size(result.compressed)} compressed{shared}, {size(result.unpacked)} unpacked"),
        ("new in registry", size(max(0, result.uploaded))),
        ("structure tests", f"{result.passed} passed, {result.failed} failed"),
        ("time", f"{duration(sum(result.seconds.values()))}: {_parts(result.seconds)}"),
    ]
    if result.work:
        rows.append(("builder's work", _parts(result.work)))
    if result.reused:
        rows.append(("reused", ", ".join(result.reused)))
    width = max(len(name) for name, _ in rows)
    title = f"{result.target} is built, tested and {'published' if result.tags else 'pushed by its digest'}"
    return "\n".join(["", title, "-" * len(title), *(f"{name.ljust(width)}  {value}" for name, value in rows)])


def _parts(seconds: dict[str, float]) -> str:
    return ", ".join(f"{name} {duration(value)}" for name, value in seconds.items())
