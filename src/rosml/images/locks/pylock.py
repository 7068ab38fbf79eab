"""Reads the files `pylock.toml` that uv writes: https://packaging.python.org/en/latest/specifications/pylock-toml/. What is in them is the
index's word."""

from __future__ import annotations

from datetime import datetime

from pydantic import ConfigDict, Field, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import Shape


class _Shape(Shape):
    model_config = ConfigDict(strict=True, frozen=True)


class Wheel(_Shape):
    """A wheel on an index. Size, in bytes, and time are None if the index does not say them."""

    url: str = ""
    size: int | None = Field(default=None, ge=0)
    uploaded: datetime | None = Field(default=None, alias="upload-time")


class Package(_Shape):
    name: str
    version: str
    wheels: list[Wheel] = []


class _Lock(_Shape):
    packages: list[Package]


def read(text: str) -> list[Package]:
    """The packages of a file."""
    try:
        return _Lock.model_validate(untrusted.toml_value(text)).packages
    except ValidationError as error:
        why = first_of(error)
    except ValueError as error:
        why = str(error)
    raise RosmlError(f"what uv says of the wheels cannot be read: {why}", "install rosml's own uv: rosml setup")
