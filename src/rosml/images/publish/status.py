"""How the images of a matrix stand: published, outdated, failed, missing, or not to be had; as a table and as data."""

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
"""Every state, with its colour: the tag points at what the matrix says now; at something older; what was made last did not
pass; nothing was published; a lock is missing; it cannot be made on this machine. What is published for some architectures,
and was never made for others, is published."""


@dataclass(frozen=True)
class ImageStatus:
    """How an image stands.

    Attributes:
        target: bake target. state: one of STATES.
        reason: why it is not published as it should be.
        tag: its main tag, with the repository. digest: what that points at; empty where there is none.
        date: of the run that made that; empty where nobody knows. age: seconds since then.
        platforms: what the tag has.
        log: the last lines of what failed, as the records have them.
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
    """How every image, and part, that is asked for stands.

    Args:
        state: what is known of them.
        now: the time from which ages count, as a run's date is written.
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
    """What other images were to prove of an image and did not, by architecture."""
    items = [state.by_key[key] for key in members if key in state.known]
    return [f"{item.architecture}: {why}" for item in items if item.kind != "part" and (why := state.unproven(item))]


def _log(state: State, thing: Image | Part) -> str:
    """What the records have of a failure, if that is more than a line."""
    entries = (entry for key in state.members(thing) if (entry := state.known.get(key)))
    texts = (entry.failed.get("reason", "") for entry in entries if not _over(state, entry))
    return next((text for text in texts if "\n" in text), "")


@dataclass(frozen=True)
class Cause:
    """Why some images are not published as they should be.

    Attributes:
        state: one of STATES. reason: what they have in common. targets: bake targets. log: the last lines of one of them.
    """

    state: str
    reason: str
    targets: tuple[str, ...]
    log: str


_FOR = re.compile(r" \(for [\w.-]+\)")
"""What an image waits for is often what another one, on which it stands, waits for."""

OPEN = ("failed", "outdated", "missing")
"""The states of images that a further run may publish."""


def causes(found: Sequence[ImageStatus], architectures: Iterable[str]) -> list[Cause]:
    """Images that are not published as they should be, by state and reason; failures, and what most have in common, first.

    Args:
        architectures: whose names in reasons do not count, so that one fault on all of them is one cause.
    """
    names = re.compile(rf"(?:(?<=^)|(?<=; ))(?:{'|'.join(map(re.escape, architectures))}): ")
    groups: dict[tuple[str, str], list[ImageStatus]] = {}
    for item in found:
        if item.state != "published":
            reason = "" if item.state == UNLOCKED else _FOR.sub("", names.sub("", item.reason))
            parts = dict.fromkeys(UNLOCKED if part.startswith(UNLOCKED) else part for part in reason.split("; "))
            if len(parts) > 1:
                parts.pop(ELSEWHERE, None)  # who looks has one machine, and a publishing run has all
            groups.setdefault((item.state, "; ".join(parts)), []).append(item)
    made = (
        Cause(state, reason, tuple(x.target for x in items), next((x.log for x in items if x.log), ""))
        for (state, reason), items in groups.items()
    )
    order = [*STATES]
    return sorted(made, key=lambda cause: (cause.state != "failed", order.index(cause.state), -len(cause.targets)))


def ahead(state: State) -> dict[str, int]:
    """How often a further run would do each step, wherever its machines are."""
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
    """What is wrong with the date of what a tag points at; empty where nothing is."""
    if date and not is_date(date):
        return f"its date is none: {date[:40]!r}"
    return f"its date {date} is in the future" if date and is_ahead(date, now) else ""


def _over(state: State, entry: Entry) -> bool:
    """Whether a failure is of the past: what failed is as it should be, since the change that broke it was taken back."""
    item = state.by_key[entry.target, entry.architecture]
    return state.made(item.key) and (item.kind == "part" or state.passed(item, entry))


def _reason(entry: Entry) -> str:
    """Why something failed, on one line."""
    return next(iter(entry.failed.get("reason", "").splitlines()), "nobody knows why")


def _first(state: State, key: tuple[str, str]) -> str:
    """Why an item is not as it should be; the first reason."""
    task = state.task(state.by_key[key])
    if found := _broken(state, state.by_key[key]):
        return found
    if task.hindered and key not in state.known:
        return task.hindered
    if task.hindered == ELSEWHERE:
        return _late(state, state.by_key[key])
    if task.hindered and state.made(key):  # what cannot be made here is there as it should be
        return ""
    return task.why[0] if task.why else task.hindered


def _broken(state: State, item: Item) -> str:
    """What failed below an item when it was last made, in whichever run that was, so that the item waits; empty if nothing did."""
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
    """Why an item is not what the matrix says now, or what it is put together from, whoever can make it; empty where it is."""
    if own := state.reasons(item):
        return own[0]
    below = (target for target in item.needs if _late(state, state.by_key[target, item.architecture]))
    return next((f"{target} is made anew" for target in below), "")


def _time(text: str) -> datetime | None:
    """A run's date; None where it is none: anybody may write an annotation."""
    try:
        return datetime.strptime(text, TIME)
    except ValueError:
        return None


def age(seconds: float | None) -> str:
    """For people: `3 d`, `5 h`, `2 min`."""
    if seconds is None:
        return ""
    for unit, size in (("d", 86400), ("h", 3600), ("min", 60)):
        if seconds >= size:
            return f"{int(seconds // size)} {unit}"
    return f"{max(0, int(seconds))} s"


def as_json(found: list[ImageStatus]) -> str:
    """All of it, and how many there are of each state."""
    counts = Counter(item.state for item in found)
    return json.dumps({"counts": dict(counts), "images": [item.to_json() for item in found]}, indent=2)
