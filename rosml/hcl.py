"""Rendering of HCL, as far as a bake file needs it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from json.encoder import encode_basestring as quoted

WIDTH = 120
"""Lists are kept on one line up to this many characters."""


@dataclass(frozen=True)
class Expression:
    """HCL code, as opposed to text: a variable, a function call, a condition."""

    code: str


def text(value: str) -> str:
    """A quoted text in which nothing is filled in."""
    return quoted(value).replace("${", "$${").replace("%{", "%%{")


def template(value: str) -> Expression:
    """A quoted text in which `${…}` is filled in."""
    return Expression(quoted(value))


def call(function: str, *arguments: str | Expression) -> Expression:
    """A function call."""
    return Expression(f"{function}({', '.join(_scalar(argument) for argument in arguments)})")


def block(kind: str, name: str, attributes: Mapping[str, object]) -> str:
    """A block such as `target "core" { … }`. Empty attributes are left out."""
    present = {key: value for key, value in attributes.items() if value not in ("", (), [], {}, None)}
    rendered = [(key, _value(value, "  ", len(key))) for key, value in present.items()]
    lines = [f"{kind} {text(name)} {{"]
    for tall, run in groupby(rendered, key=lambda item: "\n" in item[1]):
        attributes_of_run = list(run)
        width = 0 if tall else max(len(key) for key, _ in attributes_of_run)
        lines += [f"  {key.ljust(width)} = {value}" for key, value in attributes_of_run]
    return "\n".join([*lines, "}"]) + "\n"


def _value(value: object, indent: str, used: int) -> str:
    if isinstance(value, (str, Expression)):
        return _scalar(value)
    room = WIDTH - len(indent) - used - len(" = ")
    if isinstance(value, Mapping):
        return _object(value, indent, room)
    assert isinstance(value, Sequence)
    items = [_scalar(item) for item in value]
    line = f"[{', '.join(items)}]"
    if len(line) <= room:
        return line
    return "[\n" + "".join(f"{indent}  {item},\n" for item in items) + f"{indent}]"


def _object(value: Mapping[str, str | Expression], indent: str, room: int) -> str:
    keys = {key: key if key.replace("_", "a").replace("-", "a").isalnum() else text(key) for key in value}
    if len(value) == 1:
        (key, item), *_ = value.items()
        line = f"{{ {keys[key]} = {_scalar(item)} }}"
        if len(line) <= room:
            return line
    width = max(len(key) for key in keys.values())
    lines = [f"{indent}  {keys[key].ljust(width)} = {_scalar(item)}\n" for key, item in value.items()]
    return "{\n" + "".join(lines) + f"{indent}}}"


def _scalar(value: str | Expression) -> str:
    return value.code if isinstance(value, Expression) else text(value)
