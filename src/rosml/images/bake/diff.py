"""Differences between two versions of the project: added, removed and changed images, and the reasons."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, field
from functools import cache

from rosml.base import github
from rosml.base.problems import counted, some
from rosml.images.bake.inputs import TARGET, Inputs
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import names

PARENT = "parent"
"""The input for another parent: the image stands on another target than before."""

NO_LOCK = "cannot be built yet: no lock"


@dataclass(frozen=True)
class Change:
    """A changed input; None on the side that lacks it."""

    input: str
    before: str | None
    after: str | None


@dataclass(frozen=True)
class Difference:
    """Two versions of the project: targets of images, and the reasons of each changed one."""

    added: tuple[str, ...]
    removed: tuple[str, ...]
    changed: dict[str, tuple[Change, ...]]
    same: int  # the number of unchanged images
    # The old and the new target of tags that moved, or that an image on both sides gained (None before) or lost (None now).
    tags: dict[str, tuple[str | None, str | None]] = field(default_factory=dict)
    unbuildable: tuple[str, ...] = ()  # added and changed images without a lock
    registry: tuple[str, str] | None = None  # the old and the new one, if it changed: then all names change


def between(earlier: Inputs, later: Inputs) -> Difference:
    @cache
    def changes(target: str, architecture: str) -> frozenset[Change]:
        before, after = earlier.of(target, architecture), later.of(target, architecture)
        changed_inputs: set[Change] = set()
        for name in before.keys() | after.keys():
            if before.get(name) != after.get(name):
                if name.startswith(TARGET) and name in before and name in after:
                    changed_inputs |= changes(name.removeprefix(TARGET), architecture)
                else:
                    changed_inputs.add(Change(name, before.get(name), after.get(name)))
        return frozenset(
            _parents(earlier.image_set.by_target.get(target), later.image_set.by_target.get(target), changed_inputs)
        )

    def reasons(target: str) -> Iterator[Change]:
        before, after = (side.digests(side.image_set.by_target[target]) for side in (earlier, later))
        for architecture in before.keys() | after.keys():
            if architecture in before and architecture in after:
                yield from changes(target, architecture)
            else:
                sides = ["built" if architecture in side else None for side in (before, after)]
                yield Change(f"architecture {architecture}", *sides)

    was, now = earlier.image_set.by_target, later.image_set.by_target
    why_changed = {target: _ordered(reasons(target)) for target in now if target in was}
    changed = {target: why for target, why in why_changed.items() if why}
    added, removed = tuple(name for name in now if name not in was), tuple(name for name in was if name not in now)
    registries = earlier.image_set.matrix.registry, later.image_set.matrix.registry
    return Difference(
        added,
        removed,
        changed,
        same=len(why_changed) - len(changed),
        tags=_tags(earlier.image_set, later.image_set),
        unbuildable=tuple(
            name for name, image in now.items() if not image.locked and (name in added or name in changed)
        ),
        registry=registries if registries[0] != registries[1] else None,
    )


def _parents(earlier: Image | None, later: Image | None, changes: set[Change]) -> set[Change]:
    """The changes, with one change for another parent instead of two with the digests of an architecture."""
    if earlier is None or later is None or earlier.parent == later.parent:
        return changes
    ends = {(TARGET + earlier.parent, None), (TARGET + later.parent, None)}
    return {change for change in changes if (change.input, change.before and change.after) not in ends} | {
        Change(PARENT, earlier.parent, later.parent)
    }


def _tags(earlier: ImageSet, later: ImageSet) -> dict[str, tuple[str | None, str | None]]:
    before, after = ({tag: image.target for image in side.images for tag in image.tags} for side in (earlier, later))
    ways = {tag: (before.get(tag), after.get(tag)) for tag in before | after}
    return {tag: way for tag, way in ways.items() if way[0] != way[1] and _stays(way, earlier, later)}


def _stays(way: tuple[str | None, str | None], earlier: ImageSet, later: ImageSet) -> bool:
    """Whether a tag's move is worth mentioning. Tags that only come or go with their image are not."""
    return None not in way or any(target in earlier.by_target and target in later.by_target for target in way)


def as_json(difference: Difference) -> str:
    """The whole difference, with whole digests."""
    changed = {
        target: [{"input": change.input, "old": change.before, "new": change.after} for change in changes]
        for target, changes in difference.changed.items()
    }
    return json.dumps({**asdict(difference), "changed": changed}, indent=2) + "\n"


def rows(difference: Difference) -> Iterator[tuple[str, str, str]]:
    """Rows of event, reason and images. Reasons that reach the same images share a row."""
    yield from _changed(difference)
    unbuildable = set(difference.unbuildable)
    for kind in ("changed", "added"):
        if targets := [target for target in getattr(difference, kind) if target in unbuildable]:
            yield kind, NO_LOCK, some(targets)
    for kind in ("added", "removed"):
        if targets := [target for target in getattr(difference, kind) if target not in unbuildable]:
            yield kind, "", some(targets)
    yield from _tag_rows(difference.tags)


def _changed(difference: Difference) -> Iterator[tuple[str, str, str]]:
    reached: dict[Change, list[str]] = {}
    for target, why in difference.changed.items():
        # Labels spell out what the other inputs say, for each image in its own words.
        for item in [item for item in why if not item.input.startswith("label ")] or why:
            reached.setdefault(item, []).append(target)
    alike: dict[tuple[str, ...], list[str]] = {}
    for item, targets in reached.items():
        alike.setdefault(tuple(targets), []).append(_sentence(item))
    for images, reasons in alike.items():
        yield "changed", "\n".join(reasons), some(images)


def _tag_rows(tags: Mapping[str, tuple[str | None, str | None]]) -> Iterator[tuple[str, str, str]]:
    """Rows about tags: one for all that move between the same images, one for all that are gone, and one for all gained."""
    moved: dict[str, list[str]] = {}
    for tag, (was, now) in tags.items():
        if was and now:
            moved.setdefault(f"{was} → {now}", []).append(tag)
    for way, alike in moved.items():
        yield f"tag{'s'[: len(alike) != 1]} moved", way, some(alike)
    for index, word in ((1, "gone"), (0, "gained")):
        if changed_tags := [tag for tag, way in tags.items() if way[index] is None]:
            yield f"{counted(len(changed_tags), 'tag')} {word}", "", some(changed_tags)


def markdown(difference: Difference) -> str:
    """The difference for the summary of a job."""
    counts = [how_many(difference, name) for name in ("added", "removed", "changed")]
    lines = list(rows(difference))
    table = "\n" + github.table(("what", "why", "which"), lines) if lines else ""
    return f"\n## What differs\n\n{', '.join([*counts, f'{difference.same} same'])}\n{table}"


def how_many(difference: Difference, kind: str) -> str:
    """`3 added`, `3 added (2 without a lock)`."""
    targets = getattr(difference, kind)
    unlocked = len(set(difference.unbuildable).intersection(targets))
    return f"{len(targets)} {kind}" + (f" ({unlocked} without a lock)" if unlocked else "")


def _ordered(changes: Iterable[Change]) -> tuple[Change, ...]:
    return tuple(sorted(set(changes), key=lambda change: (change.input, change.before or "", change.after or "")))


def _sentence(change: Change) -> str:
    """An input with the words that differ, and shortened digests."""
    if change.input == PARENT:
        before, after = ((value or "").removeprefix("_os-") for value in (change.before, change.after))
        return f"stands on {after} instead of {before}"
    if change.input.startswith(TARGET) and None in (change.before, change.after):
        name = change.input.removeprefix(TARGET).removeprefix(names.files_target(""))
        return f"{'with' if change.before is None else 'without'} {name}"
    old_words, new_words = ((value or "").split() for value in (change.before, change.after))
    sides = [
        [word for word in old_words if word not in new_words],
        [word for word in new_words if word not in old_words],
    ]
    words = [" ".join(side) or "nothing" for side in (sides if any(sides) else [old_words, new_words])]
    return re.sub(r"\b([0-9a-f]{12})[0-9a-f]{52}\b", r"\1", f"{change.input}: {' → '.join(words)}")
