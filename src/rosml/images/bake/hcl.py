"""Writes HCL, as far as a bake file needs it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from json.encoder import encode_basestring as quoted


@dataclass(frozen=True)
class Code:
    """Raw HCL, such as a variable, as opposed to text."""

    code: str


@cache
def text(value: str) -> str:
    """A quoted text without templates."""
    return quoted(value).replace("${", "$${").replace("%{", "%%{")


def literal(value: object) -> str:
    """Plain data on one line: None, booleans, text, code, and lists and mappings of these."""
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return text(value)
    if isinstance(value, Code):
        return value.code
    if isinstance(value, Mapping):
        return f"{{ {', '.join(pairs(value))} }}" if value else "{}"
    assert isinstance(value, Sequence), f"{value!r} is no plain data"
    return f"[{', '.join(literal(item) for item in value)}]"


def pairs(values: Mapping[str, object]) -> Iterable[str]:
    """`name = value` for each value of a mapping."""
    return (f"{key(name)} = {literal(value)}" for name, value in values.items())


def aligned(values: Mapping[str, object]) -> Iterable[str]:
    """`name = value` for each value of a mapping, with aligned values."""
    width = max((len(key(name)) for name in values), default=0)
    return (f"{key(name).ljust(width)} = {literal(value)}" for name, value in values.items())


@cache
def key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z][A-Za-z0-9_-]*", name) else text(name)


def block(kind: str, name: str, attributes: Mapping[str, object]) -> str:
    """A block such as `target "core" { … }`, an attribute a line."""
    return "\n".join([f"{kind} {text(name)} {{", *(f"  {pair}" for pair in aligned(attributes)), "}"]) + "\n"
