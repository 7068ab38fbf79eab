"""Options of the engine that set the same thing: a path, a variable, the name."""

from __future__ import annotations

from collections.abc import Iterable

from rosml.run import paths
from rosml.run.words import TypedOption


def without(option: TypedOption, later: Iterable[TypedOption]) -> TypedOption | None:
    """An option without the thing that later ones set, as the engines refuse two mounts at a path. None if nothing is left."""
    thing = _thing(option)
    if not thing[0] or thing not in {_thing(other) for other in later}:
        return option
    *others, _ = option.names  # `-it` of `-itv a:/b`
    return TypedOption((option.words[0][: len(option.names)],), tuple(others)) if others else None


def _thing(option: TypedOption) -> tuple[str, str]:
    """The kind and the name of the thing that the last option of a word sets; empty if a container may have several."""
    name, value = option.names[-1], option.value or ""
    if name == "name":
        return name, ""
    if name == "env":
        return name, value.partition("=")[0]
    if name == "volume":
        return _place(value.split(":")[1] if ":" in value else value)
    if name == "tmpfs":
        return _place(value.partition(":")[0])
    if name == "mount":
        fields = dict(field.partition("=")[::2] for field in paths.fields(value) or ())
        return _place(next((fields[key] for key in ("target", "dst", "destination") if key in fields), ""))
    return "", ""


def _place(path: str) -> tuple[str, str]:
    return ("place", path.rstrip("/") or "/") if path else ("", "")
