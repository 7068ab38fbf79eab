"""A publishing run: it does a step item by item, and records each item when it is done.

If a run is interrupted, the next one completes it. If an item fails, only items that are joined from it wait. What a
step does is in `steps/`.
"""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Literal

from rosml.base import progress_bar
from rosml.base.errors import RosmlError
from rosml.images.builds.maker import Maker
from rosml.images.image_set.model import Image, Part
from rosml.images.publish import provenance
from rosml.images.publish.cosign import Signer
from rosml.images.publish.items import ELSEWHERE, ENDED, Item, Key
from rosml.images.publish.state import State
from rosml.images.records.store import INDEX, Entry, Records
from rosml.machine import buildx

Work = Callable[[Item, Entry], Entry]
"""Does a step's work on an item, and returns the item's new entry."""

OutcomeState = Literal["done", "failed", "waits"]

SUPERSEDED = 20
"""If an entry lists more superseded digests than this, it forgets those that are gone from the registry."""


class Postponed(Exception):
    """The item's turn comes again in this run. The message says why."""


@dataclass(frozen=True)
class Outcome:
    """What a step did for an item."""

    step: str
    target: str
    architecture: str  # empty for an index or tags
    state: OutcomeState
    reason: str = ""  # what was done, or why it failed or waits
    seconds: float = 0.0  # wall time
    uploaded: int = 0  # bytes sent to the registry
    waited: float = 0.0  # how much of it other builds had the builder

    def to_json(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if value != ""}


@dataclass
class Run:
    """A publishing run."""

    state: State
    maker: Maker
    say: Callable[[str], None]  # prints a line of progress
    signer: Signer | None = None  # signs indexes. Without a signature they get no tags. None if nothing is signed.
    started: float = field(default_factory=time.monotonic)  # when the run began, by the monotonic clock
    outcomes: list[Outcome] = field(default_factory=list)
    pushed: int = 0  # bytes of layers that the builder added to the registry
    deadline: float = math.inf  # when the run starts no further item, by the monotonic clock
    on_made: Callable[[Item], None] = lambda _: None  # called for each image as soon as it is built or joined
    signing: Any = field(default_factory=threading.Lock)  # a lock, so that one index is signed at a time
    refused: int = 0  # how often in a row the signer failed
    whole: bool = False  # it is for one image: nothing more is started after a failure
    _may_push: bool = False
    beforehand: dict[Key, float] = field(default_factory=dict)  # seconds of work on items that were built at once

    @property
    def records(self) -> Records:
        return self.state.records

    @property
    def failed(self) -> bool:
        return any(outcome.state == "failed" for outcome in self.outcomes)

    @property
    def uploaded(self) -> int:
        """Bytes sent to the registry since its client was made. Signatures, of about 1 kB each, do not count: cosign sends them."""
        return self.pushed + self.state.place.client.uploaded

    @cached_property
    def machine(self) -> provenance.Machine:
        return provenance.Machine.here(self.state.date)

    @cached_property
    def source(self) -> list[dict[str, Any]]:
        """The checkout that images are made from, as a dependency of a provenance statement."""
        return provenance.source(self.state.request.services.root)

    def parts(self, item: Item) -> dict[str, str]:
        """Digests of what an item is put together from, by target."""
        return {target: self.state.entries[target, item.architecture].digest for target in item.needs}

    # ---- Work --------------------------------------------------------------------------------------------------------

    def each(self, step: str, items: Sequence[Item], work: Work) -> bool:
        """Does a step's work on the items that are ready for it. Returns whether items were postponed: then the step has to be repeated."""
        expected = sum(step in self.state.task(item).steps for item in items)
        number, postponed = 0, False
        for item in progress_bar.over(items, step, len(items)):
            task = self.state.task(item, ahead=False)
            if reason := self._reason_to_wait(step, task.steps, task.hindered):
                self.outcomes.append(Outcome(step, *item.key, "waits", reason))
                continue
            if step not in task.steps:
                continue
            if step == "build":
                self.state.look_again(item)
                if step not in self.state.task(item, ahead=False).steps:
                    self.say(f"{item.target} for {item.architecture} was built by another machine meanwhile")
                    continue
            number += 1
            try:
                self.do(step, item, f"({number} of {expected})", task.why, work)
            except Postponed as news:
                self.say(str(news))
                postponed = True
                continue
            if item.kind != "part" and step != "test":
                self.on_made(item)
        return postponed

    def _reason_to_wait(self, step: str, steps: Sequence[str], hindered: str) -> str:
        """Why an item waits, and people are told so; empty if it is ready, or nothing is to be done here."""
        if hindered:  # that a distribution has ended is said once for each image, when its tags would move
            return "" if hindered == ELSEWHERE or hindered.startswith(ENDED) else hindered
        if step not in steps:
            return ""
        if step != steps[0]:
            return f"{steps[0]} comes first"
        if self.whole and self.failed:
            return "something failed before it"
        return "the time of this run is over" if time.monotonic() >= self.deadline else ""

    def do(self, step: str, item: Item, count: str, why: Sequence[str], work: Work) -> None:
        """Does a step's work on an item, and records the result. The work may raise `Postponed`."""
        if not self._may_push:  # ask before the first work, which may take hours
            self.state.place.client.may_push(self.records.repository)
            self._may_push = True
        self.say(f"{step} {item.target} for {item.architecture} {count}: {'; '.join(why)}")
        entry = self.state.entries.get(item.key) or Entry(*item.key)
        started, before, waits = time.monotonic(), self.uploaded, buildx.waited()
        try:
            entry = work(item, entry)
        except RosmlError as error:
            entry = replace(entry, failed=failure(step, error.message, error.remedy))
            self.say(f"failed: {error.message}" + (f"; {error.remedy}" if error.remedy else ""))
        waited = buildx.waited() - waits
        seconds = time.monotonic() - started + self.beforehand.pop(item.key, 0.0)
        self.write(replace(entry, seconds={**entry.seconds, step: round(seconds - waited, 2)}))
        reason = entry.failed.get("reason", "") if entry.failed else "; ".join(why)
        state: OutcomeState = "failed" if entry.failed else "done"
        self.outcomes.append(Outcome(step, *item.key, state, reason, seconds, self.uploaded - before, waited))

    def write(self, entry: Entry) -> None:
        """Records the new entry of an item or index."""
        key, entry = (entry.target, entry.architecture), replace(entry, changed=self.state.date)
        if len(entry.superseded) > SUPERSEDED:  # so that the entry does not grow for ever
            place = self.state.place
            path = place.path(entry.repository)
            entry = replace(entry, superseded=tuple(x for x in entry.superseded if place.client.head(path, x)))
        self.records.write(entry, {} if entry.architecture == INDEX else self.state.inputs.of(*key))
        self.state.entries[key] = entry
        if entry.digest:
            self.state.present.add(key)

    def add(
        self, step: str, thing: Image | Part, state: OutcomeState, reason: str, started: float | None = None
    ) -> None:
        """Notes the outcome of a step for an index or tags. `started`: by the monotonic clock, if it took time."""
        seconds = 0.0 if started is None else time.monotonic() - started
        self.outcomes.append(Outcome(step, thing.target, "", state, reason, seconds))

    def put_in_order(self, first: int) -> None:
        """Sorts the outcomes from the first one on, of images that were done side by side."""
        order = {item.target: number for number, item in enumerate(self.state.items)}
        self.outcomes[first:] = sorted(self.outcomes[first:], key=lambda outcome: order[outcome.target])


def failure(step: str, message: str, remedy: str = "") -> dict[str, str]:
    """What an entry says of a failed step: the beginning of its message, since records are no place for logs."""
    reason = "\n".join(message.splitlines()[:12])[:2000]
    return {"step": step, "reason": reason} | ({"remedy": remedy} if remedy else {})
