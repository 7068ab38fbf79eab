"""The model -> the text of matrix.schema.json, with which editors complete and check matrix.yaml."""

from __future__ import annotations

import json
import sys
from typing import Any

from rosml.errors import RosmlError
from rosml.model import Matrix


def render() -> str:
    """The JSON Schema (draft 2020-12).

    Raises:
        RosmlError: Python dropped the docstrings, some of which are descriptions there.
    """
    if sys.flags.optimize > 1:
        raise RosmlError("Python runs without docstrings, which the schema shows", "unset PYTHONOPTIMIZE", exit_code=2)
    schema = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$comment": "Generated from rosml/model.py by scripts/generate_bake.py",
        **_plain(Matrix.model_json_schema()),
    }
    return json.dumps(schema, indent=2, ensure_ascii=False) + "\n"


def _plain(schema: Any, names: bool = False) -> Any:
    """Without the titles that pydantic derives from names, which only repeat them, and with the model's strictness
    about keys: one that does not match its pattern is an error. `names`: keys are names of fields.
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
