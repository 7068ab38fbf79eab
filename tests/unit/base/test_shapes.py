"""Documents of others: whatever is in a list, reading it costs what one wrong item costs."""

from __future__ import annotations

import importlib
import pkgutil
import typing
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Any

import pytest
from pydantic import Field, RootModel, ValidationError

import rosml
from rosml.base.shapes import ENTRIES, ITEMS, Shape, adapter


def shapes(kind: type[Shape] = Shape) -> Iterator[type[Shape]]:
    for below in kind.__subclasses__():
        yield below
        yield from shapes(below)


for module in pkgutil.walk_packages(rosml.__path__, "rosml."):
    if not module.name.endswith("__main__"):
        importlib.import_module(module.name)

SHAPES = {f"{shape.__module__}.{shape.__name__}": shape for shape in shapes()}
MOST = 100_000
"""Errors of a document: with what pydantic takes for them, less than 300 MB."""


ITEM: dict[str, Any] = {}
WIDE: dict[str, Any] = {
    "items": [ITEM] * (10 * ITEMS),
    "as many items as may be": [ITEM] * ITEMS,
    "entries": dict.fromkeys(map(str, range(20 * ENTRIES)), ITEM),
    "as many entries as may be": dict.fromkeys(map(str, range(ENTRIES)), ITEM),
}


@pytest.mark.parametrize("name", sorted(name for name in SHAPES if name.startswith("rosml.")))
def test_a_document_of_wrong_items_costs_little(name: str) -> None:
    """pydantic takes 1 to 3 kB for each error, and all of them are made before the first is shown."""
    shape = SHAPES[name]
    fields = {field.alias or key for key, field in shape.model_fields.items()}
    for value in WIDE.values():
        try:
            shape.model_validate(value if issubclass(shape, RootModel) else dict.fromkeys(fields, value))
        except ValidationError as error:
            assert error.error_count() <= MOST


class Item(Shape):
    size: int


@dataclass
class Entry:
    items: list[Item]


@pytest.mark.parametrize("kind", [list[Item], tuple[Item, ...], Entry, typing.Optional[list[Item]]])  # noqa: UP045
def test_other_types_have_the_same_limits(kind: Any) -> None:
    wrong: Any = [{}] * ITEMS
    with pytest.raises(ValidationError) as caught:
        adapter(kind).validate_python({"items": wrong} if kind is Entry else wrong)
    assert caught.value.error_count() <= 3


def test_a_field_may_have_a_limit_of_its_own() -> None:
    class Few(Shape):
        sizes: Annotated[list[int], Field(max_length=2)]

    assert Few.model_validate({"sizes": [1, 2]}).sizes == [1, 2]
    with pytest.raises(ValidationError, match="at most 2 items"):
        Few.model_validate({"sizes": [1, 2, 3]})
