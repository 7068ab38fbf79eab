"""The state of a matrix's images in a registry, such as published, outdated or failed; for people and as data."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from rosml.base.clock import TIME, is_ahead, is_date
from rosml.images.image_set import missing
from rosml.images.image_set.missing import UNLOCKED
from rosml.images.image_set.model import Image, Part, repository_of, tags_of
from rosml.images.publish.state import ELSEWHERE, WAITING, Item, State
from rosml.images.records.store import Entry, date_of

STATES = {
    "published": "green",
    "outdated": "yellow",
    "failed": "red",
    "missing": "default",
    UNLOCKED: "dim",
    WAITING: "dim",
}
"""Every state, with its colour.

published: the tag points at an index that is up to date. Architectures that were never built do not count.
outdated: the tag points at something older.
failed: the last build, join, test or index failed.
missing: the image is not published yet.
lock missing: the image cannot be built without the lock.
waiting for a builder: this machine cannot build the image."""


@dataclass(frozen=True)
class ImageStatus:
    """The state of an image.

    Attributes:
        target: bake target.
        state: one of STATES.
        reason: why the image is not published in its present form.
        tag: the main tag, with the repository.
        digest: the index behind the tag; empty if there is none.
        date: of the run that made the index; empty if unknown.
        age: seconds since then.
        platforms: of the index.
        log: the last lines of what failed, from the records.
    """

    target: str
    state: str
    reason: str
    tag: str
    digest: str
    date: str
    age: float | None
    platforms: tuple[str, ...]
    log: str = ""

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {**vars(self), "platforms": list(self.platforms)}


def read(state: State, now: str) -> Iterator[ImageStatus]:
    """The state of every requested image and part.

    Args:
        state: what is known of them.
        now: the time from which ages count, in the format of a run's date.
    """
    for thing in state.things():
        repository, main = repository_of(thing), tags_of(thing)[0]
        found = state.place.client.manifest(state.place.path(repository), main)
        date = date_of(found)
        members = found.members if found else []
        platforms = tuple((item.platform and item.platform.architecture) or "" for item in members)
        made, today = _time(date), _time(now)
        stands, reason = _stands(state, thing, found.digest if found else "")
        if odd := _odd(date, now):
            reason = f"{reason}; {odd}" if reason else odd
        yield ImageStatus(
            thing.target,
            stands,
            reason,
            f"{repository}:{main}",
            found.digest if found else "",
            date,
            (today - made).total_seconds() if made and today else None,
            platforms,
            _log(state, thing) if stands == "failed" else "",
        )


def _stands(state: State, thing: Image | Part, tagged: str) -> tuple[str, str]:
    members = state.members(thing)
    index = state.index_of(thing)
    still = f"its tags were moved back on {index.held[:10]}" if index and index.held else "its tags have not moved yet"
    entries = [entry for key in members if (entry := state.known.get(key))]
    failures = [f"{e.architecture}: {_reason(e)}" for e in entries if e.failed and not _over(state, e)]
    if failures:
        return "failed", "; ".join(failures)
    lacking = sum(len(missing.on(thing, architecture)) for _, architecture in members)
    if lacking and not tagged:
        if isinstance(thing, Image) and thing.damaged:
            return UNLOCKED, missing.reason(thing)
        return UNLOCKED, f"{lacking} of its locks are missing"
    why = [f"{key[1]}: {_first(state, key)}" for key in members if _first(state, key)]
    if index and index.failed and all(item.endswith(ELSEWHERE) for item in why):
        return "failed", _reason(index)
    if tagged:
        current = index and index.digest == tagged and all(index.parts.get(e.architecture) == e.digest for e in entries)
        if current and all(item.endswith(ELSEWHERE) for item in why):
            absent = [item.partition(":")[0] for item in why]
            return "published", f"not published: {', '.join(absent)}" if absent else ""
        return "outdated", "; ".join(why or _unproven(state, members)) or still
    hindered = [state.task(state.by_key[key]).hindered for key in members]
    if all(hindered) and (waiting := [reason for reason in hindered if reason.startswith(WAITING)]):
        return WAITING, waiting[0].removeprefix(WAITING).lstrip(": ")
    return "missing", "; ".join(why or _unproven(state, members)) or still


def _unproven(state: State, members: Sequence[tuple[str, str]]) -> list[str]:
    """Why shared tests in other images prove nothing for an image, by architecture."""
    items = [state.by_key[key] for key in members if key in state.known]
    return [f"{item.architecture}: {why}" for item in items if item.kind != "part" and (why := state.unproven(item))]


def _log(state: State, thing: Image | Part) -> str:
    """The log of a failure in the records, if it is more than a line."""
    entries = (entry for key in state.members(thing) if (entry := state.known.get(key)))
    texts = (entry.failed.get("reason", "") for entry in entries if not _over(state, entry))
    return next((text for text in texts if "\n" in text), "")


@dataclass(frozen=True)
class Cause:
    """Why some images are not published in their present form.

    Attributes:
        state: one of STATES.
        reason: what the images have in common.
        targets: bake targets.
        log: the last lines of what failed, of one image.
    """

    state: str
    reason: str
    targets: tuple[str, ...]
    log: str


_FOR = re.compile(r" \(for [\w.-]+\)")
"""What an image waits for is often what another one, on which it stands, waits for."""

OPEN = ("failed", "outdated", "missing")
"""The states of images that another run may publish."""


def causes(found: Sequence[ImageStatus], architectures: Iterable[str]) -> list[Cause]:
    """Groups the images that are not published in their present form by state and reason. Failures and large groups
    come first.

    Args:
        found: the state of each image.
        architectures: names that do not count in reasons, so that one fault on all architectures is one cause.
    """
    names = re.compile(rf"(?:(?<=^)|(?<=; ))(?:{'|'.join(map(re.escape, architectures))}): ")
    groups: dict[tuple[str, str], list[ImageStatus]] = {}
    for item in found:
        if item.state != "published":
            reason = "" if item.state == UNLOCKED else _FOR.sub("", names.sub("", item.reason))
            parts = dict.fromkeys(UNLOCKED if part.startswith(UNLOCKED) else part for part in reason.split("; "))
            if len(parts) > 1:
                parts.pop(ELSEWHERE, None)  # a publishing run has machines of all architectures
            groups.setdefault((item.state, "; ".join(parts)), []).append(item)
    made = (
        Cause(state, reason, tuple(x.target for x in items), next((x.log for x in items if x.log), ""))
        for (state, reason), items in groups.items()
    )
    order = [*STATES]
    return sorted(made, key=lambda cause: (cause.state != "failed", order.index(cause.state), -len(cause.targets)))


def ahead(state: State) -> dict[str, int]:
    """How often another run would do each step, with machines of all architectures."""
    serve = state.request.serve
    counts: Counter[str] = Counter()
    for item in state.items:
        if missing.on(item.thing, item.architecture) or (serve and item.architecture not in serve):
            continue
        if state.reasons(item):
            counts[item.making] += 1
        if item.kind != "part" and (state.reasons(item) or not state.passed(item, state.known[item.key])):
            counts["test"] += 1
    return {name: counts[name] for name in ("build", "join", "test") if counts[name]}


def _odd(date: str, now: str) -> str:
    """What is wrong with the date of an index; empty if nothing is."""
    if date and not is_date(date):
        return f"its date is not valid: {date[:40]!r}"
    return f"its date {date} is in the future" if date and is_ahead(date, now) else ""


def _over(state: State, entry: Entry) -> bool:
    """Whether a failure is over: the item is up to date, because the change that broke it was reverted."""
    item = state.by_key[entry.target, entry.architecture]
    return state.made(item.key) and (item.kind == "part" or state.passed(item, entry))


def _reason(entry: Entry) -> str:
    """Why something failed, on one line."""
    return next(iter(entry.failed.get("reason", "").splitlines()), "unknown reason")


def _first(state: State, key: tuple[str, str]) -> str:
    """The first reason why an item is not up to date; empty if it is."""
    task = state.task(state.by_key[key])
    if found := _broken(state, state.by_key[key]):
        return found
    if task.hindered and key not in state.known:
        return task.hindered
    if task.hindered == ELSEWHERE:
        return _late(state, state.by_key[key])
    if task.hindered and state.made(key):  # this machine could not build it, but it is up to date
        return ""
    return task.why[0] if task.why else task.hindered


def _broken(state: State, item: Item) -> str:
    """What failed below an item in the last run that built it, so that the item waits; empty if nothing did."""
    for target in item.needs:
        need = state.by_key[target, item.architecture]
        if state.made(need.key):
            continue
        failed = state.known[need.key].failed if need.key in state.known else {}
        if failed.get("step") == need.making:
            return f"{need.making} of {target} failed"
        if found := _broken(state, need):
            return found
    return ""


def _late(state: State, item: Item) -> str:
    """Why an item, or something below it, is out of date, whatever machine can build it; empty if all are up to
    date."""
    if own := state.reasons(item):
        return own[0]
    below = (target for target in item.needs if _late(state, state.by_key[target, item.architecture]))
    return next((f"{target} is rebuilt" for target in below), "")


def _time(text: str) -> datetime | None:
    """The date of a run as a time; None if it is not valid, since anybody may write an annotation."""
    try:
        return datetime.strptime(text, TIME)
    except ValueError:
        return None


def age(seconds: float | None) -> str:
    """An age for people, such as `3 d`, `5 h` or `2 min`."""
    if seconds is None:
        return ""
    for unit, size in (("d", 86400), ("h", 3600), ("min", 60)):
        if seconds >= size:
            return f"{int(seconds // size)} {unit}"
    return f"{max(0, int(seconds))} s"


def as_json(found: list[ImageStatus]) -> str:
    """The states of images as JSON, with the count of each state."""
    counts = Counter(item.state for item in found)
    return json.dumps({"counts": dict(counts), "images": [item.to_json() for item in found]}, indent=2)
