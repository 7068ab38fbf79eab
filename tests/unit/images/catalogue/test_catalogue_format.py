"""catalogue.json keeps what its format promised to other people's programs."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from conftest import ROOT

from rosml.images.catalogue.model import Published
from rosml.images.matrix import schema


def fields(content: Any, schema: dict[str, Any], path: str = "") -> Iterator[str]:
    """Every field of a schema, with its type: `images[].tags[].name string`."""
    content = content if "$ref" not in content else schema["$defs"][content["$ref"].rsplit("/", 1)[1]]
    if "anyOf" in content:
        for item in content["anyOf"]:
            yield from fields(item, schema, path)
        return
    kind = content.get("type") or type(content.get("const", (content.get("enum") or [""])[0])).__name__
    yield f"{path} {kind}".strip()
    for name, item in content.get("properties", {}).items():
        yield from fields(item, schema, f"{path}.{name}".lstrip("."))
    if isinstance(content.get("additionalProperties"), dict):
        yield from fields(content["additionalProperties"], schema, f"{path}.*")
    if "items" in content:
        yield from fields(content["items"], schema, f"{path}[]")


def test_what_format_1_promised_is_still_there() -> None:
    """A reader of format 1 finds every field, of the type that it had. A new field may be added here; to take one away, or to
    change its type, raise FORMAT and begin another file."""
    committed = json.loads((ROOT / "catalogue.schema.json").read_text())
    promised = (ROOT / "tests/unit/images/catalogue/catalogue-format-1.txt").read_text().splitlines()
    assert len(promised) > 80
    assert sorted(set(promised) - set(fields(committed, committed))) == []
    optional = [name for name, item in committed["$defs"].items() if set(item["required"]) != set(item["properties"])]
    assert optional == [], "every field is always there"


def test_the_schema_is_that_of_the_model_and_open_to_later_fields() -> None:
    text = (ROOT / "catalogue.schema.json").read_text()
    assert text == schema.render(Published, "src/rosml/images/catalogue/model.py", read=True)
    assert '"additionalProperties": false' not in text
    assert '"additionalProperties": false' in schema.render(), "the matrix is held to its keys"
