"""What the labels of images and parts say about joins. Anybody may write anything there, so this checks and limits all of it."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from rosml.base.errors import RosmlError
from rosml.images.image_set import labels
from rosml.images.matrix.model import ANY_PYTHON
from rosml.images.matrix.patterns import NAME, PYTHON, WORD

MOST = 64
"""How many parts or add-ons an image has at most, and how much software a part."""

LONGEST = 64

_VERSION = r"[0-9A-Za-z][0-9A-Za-z.+!_-]*"
_WORDS = dict.fromkeys(("part", "distribution", "component", "framework", "stack", "environment"), NAME) | {
    "python": f"{PYTHON}|^{ANY_PYTHON}$"
}


def require(claims: Mapping[str, str], name: str, remedy: str = "publish it again") -> None:
    """Checks the labels about what an image or part is, and what goes together. `name` is the user's name of the image."""
    lists = labels.PARTS, labels.ADDONS, labels.ENVIRONMENTS, _FRAMEWORKS, labels.BRINGS, labels.TAKES
    for label in (*(labels.PREFIX + word for word in _WORDS), *lists):
        wrong = _wrong(claims, label) if claims.get(label) else ""
        if wrong:
            raise RosmlError(f"{name}: its label {label} is damaged: {wrong}", remedy, exit_code=2)


_FRAMEWORKS = f"{labels.PREFIX}frameworks"


def _wrong(claims: Mapping[str, str], label: str) -> str:
    """What is wrong with a label; empty if nothing is."""
    text = claims[label]
    if pattern := _WORDS.get(label.removeprefix(labels.PREFIX)):
        return "" if _is(pattern, text) else f"{text[:LONGEST]!r} is no name"
    if label == labels.BRINGS:
        return _wrong_software(claims)
    if label == labels.TAKES:
        return _wrong_versions(text.split())
    if label in (labels.PARTS, labels.ENVIRONMENTS) or not claims.get(f"{labels.PREFIX}part"):
        return _wrong_names(text.split())
    try:
        combinations = labels.combinations(text)
    except ValueError:
        return f"{text[:LONGEST]!r} names no parts"
    return _wrong_names([*combinations]) or next(filter(None, map(_wrong_names, combinations.values())), "")


def _wrong_names(names: Sequence[str]) -> str:
    if len(names) > MOST:
        return f"it has {len(names):,} names, and at most {MOST} are read"
    if twice := next((name for number, name in enumerate(names) if name in names[:number]), ""):
        return f"{twice[:LONGEST]!r} is there twice"
    wrong = next((name for name in names if not _is(NAME, name)), None)
    return "" if wrong is None else f"{wrong[:LONGEST]!r} is no name"


def _wrong_versions(pairs: Sequence[str]) -> str:
    wrong = next((pair for pair in pairs if not _is(rf"{NAME[1:-1]}={_VERSION}", pair)), None)
    return (
        _wrong_names([pair.partition("=")[0] for pair in pairs])
        if wrong is None
        else f"{wrong[:LONGEST]!r} is no version"
    )


def _wrong_software(claims: Mapping[str, str]) -> str:
    try:
        software = list(labels.brought_by(claims))
    except ValueError:
        return f"{claims[labels.BRINGS][:LONGEST]!r} names no software"
    if any(len(item.environment) > MOST for item in software):
        return f"software needs more than {MOST} variables"
    for item in software:
        fields = [(item.name, NAME), (item.version, _VERSION), (item.short, NAME), (item.title, WORD)]
        fields += [(value, WORD) for value in item.environment.values()]
        if wrong := next((text for text, pattern in fields if text and not _is(pattern, text)), ""):
            return f"{wrong[:LONGEST]!r} is no name, version or value"
    return _wrong_names([item.name for item in software])


def _is(pattern: str, text: str) -> bool:
    return len(text) <= LONGEST and re.fullmatch(pattern, text) is not None
