"""A document -> its model, such as a `Matrix`, or all its problems, each with its place in the file."""

from __future__ import annotations

import re
import types
from collections.abc import Mapping, Sequence
from datetime import date
from typing import Any, TypeVar, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo

from rosml.base.problems import InputError, KeyPath, Problem, listed, near
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.patterns import MEANING
from rosml.images.matrix.references import findings
from rosml.images.matrix.source import Document, quoted

Top = TypeVar("Top", bound=BaseModel)
"""The model of a whole file."""


def checked(document: Document, top: type[Top], meaning: Mapping[str, str]) -> Top:
    """The model of a document. `meaning` has the model's own patterns in words. Raises an InputError with every problem of its
    structure."""
    problems = list(document.problems)
    try:
        model = top.model_validate(document.data)
    except ValidationError as error:
        details = _first_errors(error.errors(include_url=False))
        if other := [
            it for it in details if top is Matrix and it["loc"] == ("version",) and it["type"] == "literal_error"
        ]:
            # The rest may be right in that version.
            text = f"{_problem(document, other[0], top, meaning).text}; {_OTHER_VERSION}"
            raise InputError(document.name, [document.problem(("version",), text)]) from None
        complaints = [_problem(document, detail, top, meaning) for detail in details]
        # `check: yes`: the words that are allowed, rather than what YAML reads.
        words = {it for detail, it in zip(details, complaints, strict=True) if detail["type"] == "literal_error"}
        places = {(it.line, it.column, it.path) for it in words}
        problems = [it for it in problems if (it.line, it.column, it.path) not in places]
        # Values that YAML itself misreads (a key twice, `yes` for true) have their message already.
        explained = {problem.path for problem in problems}
        raise InputError(
            document.name, [*problems, *(problem for problem in complaints if problem.path not in explained)]
        ) from None
    if problems:
        raise InputError(document.name, problems)
    return model


_OTHER_VERSION = "take the rosml of the checkout that the file is from, or a newer one"
"""The remedy for a file whose format this release does not know."""


def validate(document: Document) -> Matrix:
    """The matrix of a document. Raises an InputError with every problem of its structure, or else every name that does not exist."""
    matrix = checked(document, Matrix, MEANING)
    if problems := [document.problem(path, text) for path, text in findings(matrix)]:
        raise InputError(document.name, problems)
    return matrix


def _problem(document: Document, error: Any, top: type[BaseModel], meaning: Mapping[str, str]) -> Problem:
    kind: str = error["type"]
    path, of_key = _path(document, error["loc"], kind)
    if kind == "missing":
        field = _fields(path[:-1], top).get(str(path[-1]))
        purpose = f" ({field.description})" if field and field.description else ""
        return document.problem(path[:-1], f"'{path[-1]}' is missing; add '{path[-1]}: …'{purpose}")
    if kind == "extra_forbidden":
        return document.problem(path, _join(f"unknown key {path[-1]!r}", near(str(path[-1]), _fields(path[:-1], top))))
    value = path[-1] if of_key else error["input"]
    written = document.place(path).text if not of_key else ""
    field = _fields(path[:-1], top).get(str(path[-1])) if path else None
    pattern = next((it.pattern for it in field.metadata if getattr(it, "pattern", "")), "") if field else ""
    scalar = not isinstance(value, (tuple, Mapping))
    if kind == "string_type" and scalar and pattern in meaning and not re.search(pattern, written):  # in quotes neither
        return document.problem(path, f"expected {meaning[pattern]}, found {_described(value, written)}")
    return document.problem(path, _complaint(error, value, written, meaning, _example(path, kind, top)))


def _first_errors(details: Sequence[Any]) -> list[Any]:
    """Pydantic's errors without those that follow from others: if an item is wrong, pydantic calls its list too short."""
    around = {detail["loc"][:end] for detail in details for end in range(len(detail["loc"]))}
    return [detail for detail in details if detail["type"] != "too_short" or detail["loc"] not in around]


def _complaint(error: Any, value: Any, written: str, meaning: Mapping[str, str], example: str) -> str:
    kind, context, otherwise = error["type"], error.get("ctx", {}), error["msg"]
    if kind == "string_type":
        is_plain = isinstance(value, (int, float, date)) and written
        remedy = f'write it in quotes: "{written}"' if is_plain else ""
        if isinstance(value, tuple):
            remedy = "write it without brackets"
        return _join(f"expected text, found {_described(value, written)}", remedy)
    if kind == "string_pattern_mismatch":
        return f"expected {meaning.get(context['pattern'], 'text')}, found {_described(value)}"
    if kind == "literal_error":
        words = str(context["expected"]).replace("'", "").replace(" or ", ", ").split(", ")
        return f"expected {listed(words, last='or')}, found {_described(value, written)}"
    if kind in _EXPECTED:
        expected = f"{_EXPECTED[kind]}, such as {example}" if example else _EXPECTED[kind]
        return f"expected {expected}, found {_described(value, written)}"
    if kind in ("greater_than_equal", "less_than_equal"):
        bound = "at least" if kind.startswith("greater") else "at most"
        return f"expected {bound} {context.get('ge', context.get('le'))}, found {_described(value, written)}"
    if kind == "too_short":
        return f"nothing is there; add at least one entry, such as {example}"
    if kind == "string_too_long":
        return f"too long: {len(value)} characters, at most {context['max_length']} are allowed"
    return f"{otherwise[:1].lower()}{otherwise[1:]}, found {_described(value, written)}"


_EXPECTED = {
    "model_type": "keys and values",
    "dict_type": "keys and values",
    "tuple_type": "a list",
    "int_type": "a whole number",
    "bool_type": "true or false",
    "date_type": "a day, such as 2028-06-30, without quotes",
}


def _described(value: Any, written: str = "") -> str:
    if value is None:
        return "nothing"
    if isinstance(value, Mapping):
        return "keys and values"
    if isinstance(value, Sequence) and not isinstance(value, str):
        return "a list"
    if isinstance(value, str):
        return quoted(value)
    kind = "a date" if isinstance(value, date) else "the number" if not isinstance(value, bool) else ""
    return f"{kind} {written or value}".strip()


def _join(*sentences: str) -> str:
    return "; ".join(sentence for sentence in sentences if sentence)


def _path(document: Document, location: Sequence[Any], kind: str) -> tuple[KeyPath, bool]:
    """Pydantic's location as a path in the file, and whether the key itself is meant.

    Pydantic adds steps that the file does not have: `[key]` after a bad key, the tag of a union's member.
    """
    of_key = bool(location) and location[-1] == "[key]"
    steps = list(location[:-1] if of_key else location)
    path: KeyPath = ()
    for index, step in enumerate(steps):
        last = index == len(steps) - 1
        if (*path, step) in document.places or (last and kind == "missing"):
            path = (*path, step)
    return path, of_key


def _example(path: KeyPath, kind: str, top: type[BaseModel]) -> str:
    """What a value looks like whose kind is wrong: `'app: …'` for keys and values, `'- app: …'` or `[a, b]` for a list."""
    if kind not in ("model_type", "tuple_type", "too_short"):
        return ""
    fields = _fields(path if kind == "model_type" else (*path, 0), top)
    key = next((name for name, field in fields.items() if field.is_required()), "")
    if kind == "model_type":
        return f"'{key}: …'" if key else ""
    return f"'- {key}: …'" if key else "[a, b]"


def _fields(path: KeyPath, top: type[BaseModel]) -> Mapping[str, FieldInfo]:
    """The fields of the model at a path; none if another type is there."""
    model = _model(path, top)
    return model.model_fields if model else {}


def _model(path: KeyPath, top: type[BaseModel]) -> type[BaseModel] | None:
    kind: Any = top
    for step in path:
        if isinstance(kind, type) and issubclass(kind, BaseModel):
            field = kind.model_fields.get(str(step))
            kind = _bare(field.annotation) if field else None
        else:
            arguments = get_args(kind)
            kind = _bare(arguments[1 if get_origin(kind) is dict else 0]) if arguments else None
    return kind if isinstance(kind, type) and issubclass(kind, BaseModel) else None


def _bare(kind: Any) -> Any:
    """A type without `| None`. A union becomes its first member."""
    while get_origin(kind) in (Union, types.UnionType):
        kind = next(argument for argument in get_args(kind) if argument is not type(None))
    return kind
