"""Models of documents that others wrote: they stop at the first wrong item, and lists and objects have a limit.

pydantic collects an error for each wrong item of a list. A list of a million empty objects would take gigabytes for them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sized
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, GetCoreSchemaHandler, TypeAdapter
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

ITEMS = 200_000
"""The most items of a list, unless its field says otherwise. The longest lists name the files of an image."""

ENTRIES = 5_000
"""The most entries of an object, likewise."""

T = TypeVar("T")

Adapter = TypeAdapter

_LISTS = ("list", "tuple", "set", "frozenset")
_OBJECTS = ("dict", "model-fields")
"""pydantic's names of what has limits. Each entry of an object that a model does not know may be an error as well."""


def _bounded(schema: Any) -> Any:
    """A schema in which each list ends at its first error, and no list or object is longer than the limits."""
    if isinstance(schema, list):
        return [_bounded(item) for item in schema]
    if not isinstance(schema, dict) or schema.get("function") in _WITHIN:  # within another shape
        return schema
    bounded = {name: item if name in ("metadata", "serialization") else _bounded(item) for name, item in schema.items()}
    if schema.get("type") in _LISTS:
        check = _few_in_tuple if schema["type"] == "tuple" else _few
        return core_schema.no_info_before_validator_function(check, {"fail_fast": True} | bounded)
    if schema.get("type") in _OBJECTS:
        return core_schema.no_info_before_validator_function(_few, bounded)
    return bounded


def _few(value: Any) -> Any:
    """Raises PydanticCustomError if a value has too many items to look at them."""
    most = ENTRIES if isinstance(value, Mapping) else ITEMS
    if isinstance(value, Sized) and not isinstance(value, str | bytes) and len(value) > most:
        raise PydanticCustomError("too_long", f"it has more than {most:,} items")
    return value


def _few_in_tuple(value: Any) -> Any:
    """The same for a field that is a tuple: in a document, it is a list."""
    return tuple(_few(value)) if isinstance(value, list) else _few(value)


_WITHIN = [
    core_schema.no_info_before_validator_function(check, core_schema.any_schema())["function"]
    for check in (_few, _few_in_tuple)
]


class Shape(BaseModel):
    """A document, or an object in one. Reading it takes time and memory for what is right in it alone."""

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        schema: CoreSchema = _bounded(handler(source))
        return schema


class Bounded:
    """Annotates a type that is no `Shape`, such as a dataclass or a list of shapes: `adapter` does."""

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        schema: CoreSchema = _bounded(handler.resolve_ref_schema(handler(source)))
        return schema


def adapter(kind: type[T]) -> Adapter[T]:
    """Reads a value of a type that is no `Shape`, within the same limits."""
    bounded: Any = Annotated[kind, Bounded]
    return Adapter(bounded)
