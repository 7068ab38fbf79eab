"""Requests and pins, and how pins are dealt to the parts of the small matrix."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from conftest import SMALL, parse

from rosml.images.locks import lock
from rosml.images.locks.requests import Request
from rosml.images.locks.resolve import Pin
from rosml.images.matrix.model import PartEntry

PARTS = parse(SMALL).matrix.parts
ROOTS = {"torch": "torch==2.10.0", "tensorflow": "tensorflow[and-cuda]==2.20.0"}


def pin(name: str, *wanted_by: str, version: str = "1") -> Pin:
    return Pin(name, version, (f"sha256:{name}",), frozenset(wanted_by))


def request(**changes: object) -> Request:
    facts: dict[str, object] = {
        "stack": "cu1",
        "architecture": "amd64",
        "python": "3.12",
        "wheels": "x86_64-manylinux_2_28",
        "roots": ROOTS,
        "parts": PARTS,
        "numpy": "<2",
    }
    return Request(**{**facts, **changes})  # type: ignore[arg-type]


def dealt(
    pins: list[Pin],
    roots: Mapping[str, str] = ROOTS,
    parts: Sequence[PartEntry] = PARTS,
    beside: Mapping[str, Sequence[str]] | None = None,
) -> dict[str, list[str]]:
    return {part: [pin.name for pin in content] for part, content in lock.split(pins, roots, parts, beside).items()}
