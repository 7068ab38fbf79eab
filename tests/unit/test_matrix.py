"""The model: properties that hold for any input, and its agreement with the schema that editors use."""

from __future__ import annotations

import datetime
import json
import re
from typing import Any

import pytest
import yaml
from conftest import ROOT, SMALL, changed, parse
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rosml import bake, expand, model, schema, source
from rosml.errors import RosmlError
from rosml.problems import InputError

REAL = (ROOT / "matrix.yaml").read_text(encoding="utf-8")
QUICK = settings(max_examples=100, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))


def outcome(content: bytes) -> expand.Catalogue | None:
    """The catalogue, or None if the matrix is refused; any other exception is a bug."""
    try:
        catalogue = expand.catalogue(source.parse(content))
    except RosmlError as error:
        assert error.exit_code == 2
        assert error.message
        assert "Traceback" not in error.message
        if isinstance(error, InputError):
            lines = content.count(b"\n") + content.count(b"\r") + 2
            assert all(1 <= problem.line <= lines and problem.column >= 1 for problem in error.problems)
        return None
    bake.render(catalogue)
    return catalogue


@QUICK
@given(st.integers(0, len(REAL) - 1), st.integers(0, 40), st.text(max_size=12))
def test_any_edit_of_the_text(start: int, length: int, new: str) -> None:
    text = REAL[:start] + new + REAL[start + length :]
    outcome(text.encode("utf-8", errors="surrogatepass"))


@QUICK
@given(st.binary(max_size=200))
def test_any_bytes(content: bytes) -> None:
    outcome(content)


WORDS = st.sampled_from(
    ["core", "cu128", "torch", "amd64", "3.11", "", "x" * 300, "${REGISTRY}", "%{x}", '"', "\n", "ü"]
)
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | WORDS | st.dates(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(WORDS, inner, max_size=3),
    max_leaves=6,
)


def paths(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Every path in nested data."""
    found = [path]
    for key, value in data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ():
        found += paths(value, (*path, key))
    return found


PATHS = paths(yaml.safe_load(REAL))[1:]


@QUICK
@given(
    st.lists(st.tuples(st.sampled_from(PATHS), st.sampled_from(["replace", "remove", "rename"]), VALUES), max_size=3)
)
def test_any_edit_of_the_data(edits: list[tuple[tuple[Any, ...], str, Any]]) -> None:
    data = yaml.safe_load(REAL)
    for path, kind, value in edits:
        owner = data
        try:
            for step in path[:-1]:
                owner = owner[step]
            old = owner[path[-1]]
        except (KeyError, IndexError, TypeError):
            continue  # an earlier edit took it away
        if kind == "replace":
            owner[path[-1]] = value
        elif isinstance(owner, dict):
            del owner[path[-1]]
            if kind == "rename":
                owner[str(value)] = old
    outcome(yaml.safe_dump(data, allow_unicode=True).encode("utf-8", errors="surrogatepass"))


def test_the_real_matrix_is_accepted() -> None:
    assert outcome(REAL.encode()) is not None


# ---- Schema and model ------------------------------------------------------------------------------------------------


class Invalid(Exception):
    """An instance that the schema refuses."""


KINDS = {"object": dict, "array": list, "string": str, "integer": int, "boolean": bool, "null": type(None)}

# Keywords say nothing about values of other types.
APPLIES_TO: dict[str, type | tuple[type, ...]] = {
    **dict.fromkeys(
        ("required", "properties", "additionalProperties", "patternProperties", "propertyNames", "minProperties"), dict
    ),
    **dict.fromkeys(("items", "minItems", "maxItems"), list),
    **dict.fromkeys(("pattern", "minLength", "maxLength"), str),
    **dict.fromkeys(("minimum", "maximum"), (int, float)),
}


def check(node: dict[str, Any], value: Any, root: dict[str, Any]) -> None:
    """Validates as JSON Schema does, for the keywords that the schema uses; any other keyword fails the test."""
    for keyword, wanted in node.items():
        if isinstance(value, APPLIES_TO.get(keyword, object)) and not _holds(node, keyword, wanted, value, root):
            raise Invalid(f"{value!r}: {keyword} {wanted}")


def _holds(node: dict[str, Any], keyword: str, wanted: Any, value: Any, root: dict[str, Any]) -> bool:
    known, patterns = node.get("properties", {}), node.get("patternProperties", {})
    match keyword:
        case "$schema" | "$comment" | "$defs" | "description" | "default" | "format":
            return True
        case "$ref":
            return accepts(root["$defs"][wanted.rsplit("/", 1)[1]], value, root)
        case "anyOf" | "oneOf":
            return any(accepts(option, value, root) for option in wanted)
        case "type":
            return isinstance(value, KINDS[wanted]) and (wanted == "boolean") == isinstance(value, bool)
        case "required":
            return all(key in value for key in wanted)
        case "properties":
            return all(accepts(wanted[key], value[key], root) for key in wanted.keys() & value.keys())
        case "patternProperties":
            matching = [(key, inner) for pattern, inner in wanted.items() for key in value if re.search(pattern, key)]
            return all(accepts(inner, value[key], root) for key, inner in matching)
        case "additionalProperties":
            others = [key for key in value if key not in known and not any(re.search(p, key) for p in patterns)]
            return (
                not others
                if wanted is False
                else wanted is True or all(accepts(wanted, value[k], root) for k in others)
            )
        case "propertyNames":
            return all(accepts(wanted, key, root) for key in value)
        case "items":
            return all(accepts(wanted, item, root) for item in value)
        case "const" | "enum":
            return value in (wanted if keyword == "enum" else [wanted]) and not isinstance(value, bool)
        case "pattern":
            return re.search(wanted, value) is not None
        case "minItems" | "minLength" | "minProperties":
            return bool(len(value) >= wanted)
        case "maxItems" | "maxLength":
            return bool(len(value) <= wanted)
        case "minimum" | "maximum":
            return bool(value >= wanted if keyword == "minimum" else value <= wanted)
    pytest.fail(f"this test does not know the keyword {keyword}")


def accepts(node: dict[str, Any], value: Any, root: dict[str, Any]) -> bool:
    try:
        check(node, value, root)
    except Invalid:
        return False
    return True


SCHEMA = json.loads(schema.render())


def as_editors_see_it(data: Any) -> Any:
    """Dates are text in JSON; tuples are lists; `1.5` is told apart from text by its type."""
    if isinstance(data, dict):
        return {key: as_editors_see_it(value) for key, value in data.items()}
    if isinstance(data, (list, tuple)):
        return [as_editors_see_it(value) for value in data]
    return data.isoformat() if isinstance(data, datetime.date) else data


def model_accepts(data: Any) -> bool:
    try:
        model.Matrix.model_validate(data)
    except ValueError:
        return False
    return True


@pytest.mark.parametrize("text", [REAL, SMALL])
def test_schema_accepts_what_the_model_accepts(text: str) -> None:
    check(SCHEMA, as_editors_see_it(source.parse(text.encode()).data), SCHEMA)


def tupled(data: Any) -> Any:
    """Lists as the reader gives them to the model."""
    if isinstance(data, dict):
        return {key: tupled(value) for key, value in data.items()}
    return tuple(tupled(value) for value in data) if isinstance(data, list) else data


SIMPLE = st.none() | st.booleans() | st.integers(-2, 2) | st.sampled_from(["core", "3.11", "a b", "x" * 200, ""])


@settings(QUICK, max_examples=150)
@given(st.sampled_from(PATHS), st.sampled_from(["replace", "remove", "rename", "add"]), SIMPLE)
def test_schema_and_model_judge_alike(path: tuple[Any, ...], kind: str, value: Any) -> None:
    data = yaml.safe_load(REAL)
    owner = data
    for step in path[:-1]:
        owner = owner[step]
    old = owner[path[-1]]
    if isinstance(old, datetime.date):
        return  # text in the schema, a day in the model
    if kind == "replace":
        owner[path[-1]] = value
    elif kind == "add" and isinstance(old, dict):
        old["surplus"] = value
    elif isinstance(owner, dict):
        del owner[path[-1]]
        if kind == "rename":
            owner[str(value)] = old
    assert model_accepts(tupled(data)) == accepts(SCHEMA, as_editors_see_it(data), SCHEMA)


def test_every_key_is_described() -> None:
    described = [SCHEMA, *SCHEMA["$defs"].values()]
    sections = set(SCHEMA["properties"])
    bare = [
        key
        for node in described
        for key, value in node.get("properties", {}).items()
        if "description" not in value and key not in sections
    ]
    assert bare == []


def test_the_check_above_can_fail() -> None:
    data = as_editors_see_it(source.parse(REAL.encode()).data)
    data["surplus"] = 1
    assert not accepts(SCHEMA, data, SCHEMA)


# ---- Facts -----------------------------------------------------------------------------------------------------------


def test_requirement(small: expand.Catalogue) -> None:
    stack = small.matrix.stacks["cpu"]
    assert stack.requirement("tensorflow", "amd64") == "tensorflow-cpu==2.20.0"
    assert stack.requirement("tensorflow", "arm64") == "tensorflow==2.20.0"
    assert stack.requirement("torch", "amd64") == "torch==2.10.0"


def test_a_stack_without_a_release_asks_for_nothing(real: expand.Catalogue) -> None:
    assert real.matrix.stacks["cu130"].requirement("tensorflow", "amd64") is None


def test_a_new_distribution_fits_in_ten_lines() -> None:
    row = """\
  made-up:
    os: ubuntu-24.04
    ros: 2
    ros_distro: madeup
    packages: ros-{ros_distro}-{metapackage}
    components: [core, base, desktop]
    default_stack: cu1
    eol: 2031-05-31
    lts: true
    apt: {channel: live}
"""
    assert row.count("\n") <= 10
    catalogue = parse(changed("distributions:\n", f"distributions:\n{row}"))
    assert catalogue.image("made-up-base").packages == "ros-madeup-ros-base"
    assert "ros-torch:latest" in catalogue.image("made-up-base-torch-cu1").tags


def test_a_new_release_is_one_line() -> None:
    line = '    2.11.0: {python: ["3.12"], wheels: {cu1: [amd64]}}\n'
    catalogue = parse(changed("  torch:\n    2.10.0", f"  torch:\n{line}    2.10.0"))
    assert "2.11.0" in catalogue.matrix.releases.torch
