"""The end of `make image`: what was made and where the time went, on one screen."""

from __future__ import annotations

from rosml.base.units import duration, size
from rosml.build.publisher import Result


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
