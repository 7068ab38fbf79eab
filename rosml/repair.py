"""Stand-ins for values that the model refuses, so that the rest of the file can be checked in the same run.

Without it, a misspelt key would hide every unknown name until the next run. A repaired matrix is only ever looked at
for further problems; it is never expanded.
"""

from __future__ import annotations

import copy
import datetime
import types
from collections.abc import Iterable, Sequence
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo

from rosml import model
from rosml.problems import Path

Detail = tuple[str, Path, bool]
"""What the model refused: the kind of the error, its path, and whether the key itself is meant."""

STAND_IN = {
    model.NAME: "stand-in",
    model.FILE_NAME: "stand-in",
    model.VERSION: "0.0.0",
    model.PYTHON: "3.0",
    model.DIGEST: "sha256:" + "0" * 64,
    model.REFERENCE: "stand-in",
    model.IMAGE: "stand.in/stand-in:stand-in",
    model.URL: "https://stand.in",
    model.HOST: "http://stand.in",
    model.FOLDER: "stand-in",
    model.APT: "http://stand.in",
    model.DEB: "https://stand.in",
    model.PLATFORM: "linux/standin",
    model.RMW: "rmw_stand_in",
    model.WORD: "stand-in",
    model.SPECIFIER: "<2",
    model.REQUIREMENT: "stand-in",
    model.PINNED: "stand-in==0",
    model.SENTENCE: "stand-in",
    model.PACKAGES: "stand-in",
}


def repaired(data: Any, details: Sequence[Detail]) -> tuple[model.Matrix | None, set[Path]]:
    """A matrix like `data` with stand-ins for what was refused, and the paths at which they stand.

    Returns:
        None where names themselves are in doubt (a whole section, a key): then every use of them would look wrong.
    """
    data = copy.deepcopy(data)
    stand_ins: set[Path] = set()
    for kind, path, of_key in details:
        expected = annotation(path)
        if of_key or not path or (kind != "extra_forbidden" and _free_keys(expected)):
            return None, stand_ins
        stand_ins.add(path)
        if kind == "extra_forbidden":
            _put(data, path, None, remove=True)
        else:
            _put(data, path, _stand_in(expected))
    try:
        return model.Matrix.model_validate(data), stand_ins
    except ValidationError:
        return None, stand_ins


def trusted(findings: Iterable[tuple[Path, str]], stand_ins: set[Path]) -> list[tuple[Path, str]]:
    """Findings that no stand-in can have caused."""
    return [(path, text) for path, text in findings if not any(_related(path, other) for other in stand_ins)]


def _related(path: Path, stand_in: Path) -> bool:
    shared = min(len(path), len(stand_in))
    if path[:shared] == stand_in[:shared]:
        return True
    # What a system and the generation of ROS are decides where packages may come from, and Python who must agree.
    if path[:1] == ("distributions",) and path[2:] == ("apt",):
        return stand_in[0] == "operating_systems" or stand_in == (*path[:2], "ros")
    if path[:1] == ("operating_systems",):
        return stand_in == (*path[:2], "python")
    # Within a stack, and among frameworks, one fact decides what the others must be.
    return path[:1] == stand_in[:1] and (
        path[:1] == ("frameworks",) or (path[:1] == ("stacks",) and path[1] == stand_in[1])
    )


def _put(data: Any, path: Path, value: Any, remove: bool = False) -> None:
    """Sets or removes what stands at `path`; lists are tuples, so they are made anew on the way back."""
    owner, way = data, []
    for step in path[:-1]:
        way.append((owner, step))
        owner = owner[step]
    step = path[-1]
    if isinstance(owner, dict):
        if remove:
            owner.pop(str(step), None)
        else:
            owner[str(step)] = value
        return
    changed: Any = (*owner[: int(step)], value, *owner[int(step) + 1 :])
    while way:
        owner, step = way.pop()
        if isinstance(owner, dict):
            owner[str(step)] = changed
            return
        changed = (*owner[: int(step)], changed, *owner[int(step) + 1 :])


def annotation(path: Path, top: type[BaseModel] = model.Matrix) -> Any:
    """The type, with its annotations, of what stands at `path` below `top`; None where the model has no such place."""
    kind: Any = top
    for step in path:
        kind = bare(kind)
        if isinstance(kind, type) and issubclass(kind, BaseModel):
            field = kind.model_fields.get(str(step))
            kind = _whole(field) if field else None
        else:
            arguments = get_args(kind)
            kind = arguments[1 if get_origin(kind) is dict else 0] if arguments else None
    return kind


def bare(kind: Any) -> Any:
    """A type without annotations and without `| None`; of a union, its first member."""
    while True:
        if get_origin(kind) is Annotated:
            kind = get_args(kind)[0]
        elif get_origin(kind) in (Union, types.UnionType):
            kind = next(argument for argument in get_args(kind) if argument is not type(None))
        else:
            return kind


def _whole(field: FieldInfo) -> Any:
    """A field's type with the annotations that pydantic keeps apart."""
    annotated: Any = Annotated
    arguments = (field.annotation, *field.metadata)
    return annotated[arguments] if field.metadata else field.annotation


def _free_keys(kind: Any) -> bool:
    kind = bare(kind)
    return get_origin(kind) is dict or kind is model.Releases


def _stand_in(kind: Any) -> Any:
    """A valid value of a type."""
    pattern = _pattern(kind)
    kind = bare(kind)
    if pattern:
        return STAND_IN[pattern]
    if get_origin(kind) is Literal:
        return get_args(kind)[0]
    if get_origin(kind) is tuple:
        return (_stand_in(get_args(kind)[0]),)
    if get_origin(kind) is dict:
        return {}
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        return {name: _stand_in(_whole(field)) for name, field in kind.model_fields.items() if field.is_required()}
    return {str: "stand-in", int: 0, bool: False, datetime.date: datetime.date(2000, 1, 1)}.get(kind)


def _pattern(kind: Any) -> str | None:
    """The pattern that a text must match, however deep it is wrapped."""
    if get_origin(kind) is Annotated:
        inner, *metadata = get_args(kind)
        for item in metadata:
            for part in (item, *getattr(item, "metadata", ())):
                if pattern := getattr(part, "pattern", None):
                    return str(pattern)
        return _pattern(inner)
    if get_origin(kind) in (Union, types.UnionType):
        return next((found for argument in get_args(kind) if (found := _pattern(argument))), None)
    return None
