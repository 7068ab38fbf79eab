"""The state of a matrix's images in a registry, such as published, outdated or failed; for people and as data."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from typing import Any, Literal

from rosml.base.clock import TIME, is_ahead, is_date
from rosml.base.problems import counted, listed, some
from rosml.images.image_set import missing_locks
from rosml.images.image_set.missing_locks import UNLOCKED
from rosml.images.image_set.model import Image, Part, tags_of
from rosml.images.publish.items import ELSEWHERE, ENDED, WAITING, Item, Key, Step
from rosml.images.publish.state import State
from rosml.images.records.store import Entry, date_of
from rosml.images.scan.policy import SEVERITIES
from rosml.images.scan.recorded import scan_of

STATES = {
    "published": "green",
    "outdated": "yellow",
    "failed": "red",
    "missing": "default",
    UNLOCKED: "dim",
    WAITING: "dim",
    ENDED: "dim",
}
"""Every state, with its colour.

published: the tag points at an index that is up to date. Architectures that were never built do not count.
outdated: the tag points at something older.
failed: the last build, join, test or index failed, or a lock is there and cannot be used.
missing: the image is not published yet.
lock missing: the image cannot be built without the lock.
waiting for a builder: this machine cannot build the image.
ended: the distribution is past its end of life, and the image's tags stay where they are."""


@dataclass(frozen=True)
class ImageStatus:
    """The state of an image or part."""

    target: str
    state: str  # one of STATES
    reason: str  # why the image is not published in its present form
    tag: str  # the main tag, with the repository
    digest: str  # the index behind the tag; empty if there is none
    date: str  # of the run that made the index; empty if unknown
    age: float | None  # seconds since then
    platforms: tuple[str, ...]
    log: str = ""  # the last lines of what failed, from the records
    kind: Literal["image", "part"] = "image"
    eol: str = ""  # last day of support of its distribution; empty of a part, or if it has none
    vulnerabilities: Mapping[str, int] = field(default_factory=dict)  # of its scan, by severity
    failing: tuple[str, ...] = ()  # advisories that stop it
    database: str = ""  # when the database of its scan was made; empty if it was not scanned

    def to_json(self) -> dict[str, Any]:
        return {**vars(self), "platforms": list(self.platforms), "failing": list(self.failing)}


def read(state: State, now: str) -> Iterator[ImageStatus]:
    """The state of every requested image and part. Ages count from `now`, in the format of a run's date."""
    for thing in state.things():
        repository, main = thing.repository, tags_of(thing)[0]
        index = state.place.client.manifest(state.place.path(repository), main)
        date, digest = date_of(index), index.digest if index else ""
        published, today = _time(date), _time(now)
        name, reason = _state(state, thing, digest)
        yield ImageStatus(
            thing.target,
            name,
            "; ".join(filter(None, (reason, _wrong_date(date, now)))),
            f"{repository}:{main}",
            digest,
            date,
            (today - published).total_seconds() if published and today else None,
            tuple((item.platform and item.platform.architecture) or "" for item in (index.members if index else ())),
            _log(state, thing) if name == "failed" else "",
            "part" if isinstance(thing, Part) else "image",
            _eol(state, thing),
            **_vulnerabilities(state, thing),
        )


def _eol(state: State, thing: Image | Part) -> str:
    day = None if isinstance(thing, Part) else state.image_set.matrix.distributions[thing.distribution].eol
    return str(day) if day else ""


def _vulnerabilities(state: State, thing: Image | Part) -> dict[str, Any]:
    """What the scans of an image's architectures say, for `ImageStatus`: the most of each severity, and the oldest database."""
    entries = [state.entries[key] for key in state.members(thing) if key in state.entries]
    scans = [scan for entry in entries if entry.scanned and (scan := scan_of(entry))]
    severities = {name for scan in scans for name in scan.findings}
    return {
        "vulnerabilities": {
            name: max(scan.findings.get(name, 0) for scan in scans) for name in SEVERITIES if name in severities
        },
        "failing": tuple(sorted({name for scan in scans for name in scan.failing})),
        "database": min((scan.updated for scan in scans), default=""),
    }


def vulnerabilities(it: ImageStatus, now: str) -> str:
    """What people read about an image's vulnerabilities, in the words of the catalogue: `3 high, 1 low known; CVE-2026-1 stops the image`."""
    if not it.database:
        return ""
    counts = ", ".join(f"{number} {name}" for name, number in it.vulnerabilities.items())
    texts = [f"{counts or 'none'} known"]
    if it.failing:
        texts.append(f"{some(it.failing)} {'stops' if len(it.failing) == 1 else 'stop'} the image")
    updated, today = _time(it.database), _time(now)
    if updated and today and today - updated > OLD:
        texts.append(f"by a database of {it.database[:10]}")
    return "; ".join(texts)


OLD = timedelta(days=7)
"""If the database of a scan is older, people have to know."""


def _state(state: State, thing: Image | Part, tagged: str) -> tuple[str, str]:
    """The state of an image whose main tag points at a digest, and why."""
    if end := state.end(thing):
        return ENDED, end.removeprefix(f"{ENDED}: ")
    members = state.members(thing)
    index = state.index_of(thing)
    entries = [entry for key in members if (entry := state.entries.get(key))]
    failures = [f"{entry.architecture}: {_reason(entry)}" for entry in entries if _has_failed(state, entry)]
    failures += [f"{it.architecture}: {it.target}: {_reason(it)}" for it in _failed_testers(state, thing)]
    if failures:
        return "failed", "; ".join(failures)
    lacking = sum(len(missing_locks.on(thing, architecture)) for _, architecture in members)
    if damage := state.damage(thing):
        return "failed", damage
    if lacking and not tagged:
        return UNLOCKED, f"{lacking} of its locks are missing"
    why = [f"{key[1]}: {reason}" for key in members if (reason := _first_reason(state, key))]
    only_elsewhere = all(reason.endswith(ELSEWHERE) for reason in why)
    if index and index.failed and only_elsewhere:
        return "failed", _reason(index)
    has_all = index and all(index.parts.get(entry.architecture) == entry.digest for entry in entries)
    if tagged and index and index.digest == tagged and has_all and only_elsewhere:
        absent = [reason.partition(":")[0] for reason in why]
        return "published", f"not published: {', '.join(absent)}" if absent else ""
    if not tagged:
        hindered = [state.task(state.by_key[key]).hindered for key in members]
        if all(hindered) and (waiting := [reason for reason in hindered if reason.startswith(WAITING)]):
            return WAITING, waiting[0].removeprefix(WAITING).lstrip(": ")
    still = f"its tags were moved back on {index.held[:10]}" if index and index.held else "its tags have not moved yet"
    waits_for = why or _unproven(state, members) or [state.unready(thing)]
    return "outdated" if tagged else "missing", "; ".join(waits_for) or still


def _failed_testers(state: State, thing: Image | Part) -> list[Entry]:
    """Of a part, the images without a tag that test it and failed: they have no row of their own."""
    parts = [entry for key in state.members(thing) if isinstance(thing, Part) and (entry := state.entries.get(key))]
    testers = [tester for part in parts if (tester := state.failed_tester(part))]
    return [state.entries[it.key] for it in testers if isinstance(it.thing, Image) and not it.thing.tags]


def _unproven(state: State, members: Sequence[Key]) -> list[str]:
    """Why shared tests in other images prove nothing for an image, by architecture."""
    items = [state.by_key[key] for key in members if key in state.entries and state.by_key[key].kind != "part"]
    return [f"{item.architecture}: {why}" for item in items if (why := state.tests.unproven(item))]


def _log(state: State, thing: Image | Part) -> str:
    """The log of a failure in the records, if it is more than a line."""
    entries = [entry for key in state.members(thing) if (entry := state.entries.get(key)) and _has_failed(state, entry)]
    texts = (it.failed["reason"] for it in (*entries, *_failed_testers(state, thing)) if "reason" in it.failed)
    return next((text for text in texts if "\n" in text), "")


def after_a_number(state: str) -> str:
    """A state behind a number of images or parts: `2 images published`, `2 images without a lock`."""
    return "without a lock" if state == UNLOCKED else state


@dataclass(frozen=True)
class Cause:
    """Why some images and parts are not published in their present form: their state, and what they have in common."""

    state: str
    reason: str
    targets: tuple[str, ...]
    log: str  # the last lines of what failed, of one image
    count: str  # how many: `2 images and 1 part`


def count(statuses: Iterable[ImageStatus]) -> str:
    """How many images and parts there are: `2 images and 1 part`."""
    numbers = Counter(it.kind for it in statuses)
    return listed([counted(number, kind) for kind, number in sorted(numbers.items())]) or counted(0, "image")


_FOR = re.compile(r" \(for [\w.-]+\)")


def without_target(reason: str) -> str:
    """A reason without the image or part below that waits: all that stand on it have the same cause."""
    return _FOR.sub("", reason)


OPEN = ("failed", "outdated", "missing")
"""The states of images that another run may publish."""


def causes(statuses: Sequence[ImageStatus], architectures: Iterable[str]) -> list[Cause]:
    """Groups unpublished images by state and reason, failures and large groups first. One fault on all architectures is one cause."""
    names = re.compile(rf"(?:(?<=^)|(?<=; ))(?:{'|'.join(map(re.escape, architectures))}): ")
    groups: dict[tuple[str, str], list[ImageStatus]] = {}
    for image in statuses:
        if image.state != "published":
            reason = "" if image.state == UNLOCKED else without_target(names.sub("", image.reason))
            parts = dict.fromkeys(UNLOCKED if part.startswith(UNLOCKED) else part for part in reason.split("; "))
            if len(parts) > 1:
                parts.pop(ELSEWHERE, None)  # a publishing run has machines of all architectures
            groups.setdefault((image.state, "; ".join(parts)), []).append(image)
    grouped = (
        Cause(state, reason, tuple(x.target for x in images), next((x.log for x in images if x.log), ""), count(images))
        for (state, reason), images in groups.items()
    )
    order = [*STATES]
    return sorted(grouped, key=lambda cause: (cause.state != "failed", order.index(cause.state), -len(cause.targets)))


@dataclass(frozen=True)
class Ahead:
    """How often another run would do a step. `architecture` is empty for those that were asked for."""

    step: Step
    number: int
    architecture: str = ""


def ahead(state: State) -> list[Ahead]:
    """What another run would do, with machines of all architectures."""
    serve = state.request.serve
    counts: Counter[tuple[str, Step]] = Counter()
    for item in state.items:
        if (
            state.end(item.thing)
            or missing_locks.on(item.thing, item.architecture)
            or (serve and item.architecture not in serve)
        ):
            continue
        outdated = bool(state.reasons(item))
        other = "" if item.architecture in state.architectures else item.architecture
        counts[other, item.making] += outdated
        if item.kind != "part" and (outdated or not state.tests.passed(item, state.entries[item.key])):
            counts[other, "test"] += 1
    steps = sorted(counts, key=lambda it: (it[0], _STEPS.index(it[1])))
    return [Ahead(step, counts[other, step], other) for other, step in steps if counts[other, step]]


_STEPS: tuple[Step, ...] = ("build", "join", "test")


def _wrong_date(date: str, now: str) -> str:
    if date and not is_date(date):
        return f"its date is not valid: {date[:40]!r}"
    return f"its date {date} is in the future" if date and is_ahead(date, now) else ""


def _has_failed(state: State, entry: Entry) -> bool:
    """Whether the last step failed, and the change that broke it was not reverted since."""
    item = state.by_key[entry.target, entry.architecture]
    reverted = state.is_current(item.key) and (item.kind == "part" or state.tests.passed(item, entry))
    return bool(entry.failed) and not reverted


def _reason(entry: Entry) -> str:
    """Why something failed, on one line."""
    return next(iter(entry.failed.get("reason", "").splitlines()), "unknown reason")


def _first_reason(state: State, key: Key) -> str:
    """The first reason why an item is not up to date; empty if it is."""
    item = state.by_key[key]
    task = state.task(item)
    if failure := _failure_below(state, item):
        return failure
    if task.hindered and key not in state.entries:
        return task.hindered
    if task.hindered == ELSEWHERE:
        return _outdated(state, item)
    if task.hindered and state.is_current(key):  # this machine could not build it, but it is up to date
        return ""
    return task.why[0] if task.why else task.hindered


def _failure_below(state: State, item: Item) -> str:
    """What failed below an item in the last run that built it, so that the item waits; empty if nothing did."""
    for target in item.needs:
        need = state.by_key[target, item.architecture]
        if state.is_current(need.key):
            continue
        failed = state.entries[need.key].failed if need.key in state.entries else {}
        if failed.get("step") == need.making:
            return f"{need.making} of {target} failed"
        if failure := _failure_below(state, need):
            return failure
    return ""


def _outdated(state: State, item: Item) -> str:
    """Why an item, or something below it, is out of date, whatever machine can build it; empty if all are up to date."""
    if reasons := state.reasons(item):
        return reasons[0]
    below = (target for target in item.needs if _outdated(state, state.by_key[target, item.architecture]))
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


def as_json(statuses: list[ImageStatus], ending: Sequence[str] = ()) -> str:
    """The states of images as JSON, with the count of each state, and the policy's entries that end soon."""
    counts = Counter(image.state for image in statuses)
    images = [image.to_json() for image in statuses]
    return json.dumps({"counts": dict(counts), "ending": list(ending), "images": images}, indent=2)
