"""Models -> JSON Schemas: matrix.schema.json, with which editors complete and check matrix.yaml, and catalogue.schema.json, for
programs that read catalogue.json."""

from __future__ import annotations

import json
import sys
from typing import Any

from pydantic import BaseModel

from rosml.base.errors import RosmlError
from rosml.images.matrix.model import Matrix


def render(
    model: type[BaseModel] = Matrix, module: str = "src/rosml/images/matrix/model.py", read: bool = False
) -> str:
    """The JSON Schema (draft 2020-12) of a model. With `read`, it is for readers of a file that this program writes: keys that a later
    version adds are no errors."""
    if sys.flags.optimize > 1:
        raise RosmlError("Python runs without docstrings, which the schema shows", "unset PYTHONOPTIMIZE", exit_code=2)
    schema = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$comment": f"Generated from {module} by rosml generate",
        **(_open if read else _plain)(_plain(model.model_json_schema())),
    }
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"


def _plain(schema: Any, names: bool = False) -> Any:
    """A schema without the titles that pydantic derives from names. Like the model, it refuses keys that do not match its pattern.
    `names`: keys are names of fields.
    """
    if isinstance(schema, dict):
        strict = {"additionalProperties": False} if "patternProperties" in schema and not names else {}
        plain = {
            key: _plain(value, names=key in ("properties", "$defs") and not names)
            for key, value in schema.items()
            if names or key != "title"
        }
        return plain | strict
    return [_plain(item) for item in schema] if isinstance(schema, list) else schema


def _open(schema: Any) -> Any:
    if isinstance(schema, dict):
        return {key: _open(value) for key, value in schema.items() if (key, value) != ("additionalProperties", False)}
    return [_open(item) for item in schema] if isinstance(schema, list) else schema
