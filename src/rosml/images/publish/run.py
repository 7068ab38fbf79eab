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
from rosml.images.publish.state import ELSEWHERE, Item, State
from rosml.images.records.store import INDEX, Entry, Records
from rosml.machine import buildx

Work = Callable[[Item, Entry], Entry]
"""Does a step's work on an item; gives the item's new entry."""

SUPERSEDED = 20
"""If an entry lists more superseded digests than this, it forgets those that are gone from the registry."""


class Postponed(Exception):
    """The item's turn comes again in this run. The message says why."""


@dataclass(frozen=True)
class Outcome:
    """What a step did for an item.

    Attributes:
        step: name of the step.
        target: the item's bake target.
        architecture: the item's architecture; empty for an index or tags.
        state: done; failed; or waits, if something is missing.
        reason: what was done, or why it failed or waits.
        seconds: wall time.
        waited: how much of it other builds had the builder.
        uploaded: bytes sent to the registry.
    """

    step: str
    target: str
    architecture: str
    state: Literal["done", "failed", "waits"]
    reason: str = ""
    seconds: float = 0.0
    uploaded: int = 0
    waited: float = 0.0

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {name: value for name, value in vars(self).items() if value != ""}


@dataclass
class Run:
    """A publishing run.

    Attributes:
        state: what is known; the run keeps it up to date.
        maker: builds, joins and tests.
        say: prints a line of progress.
        signer: signs indexes. Without a signature they get no tags. None if nothing is signed.
        started: when the run began, by the monotonic clock.
        outcomes: what was done so far.
        pushed: bytes of layers that the builder added to the registry.
        deadline: when the run starts no further item, by the monotonic clock.
        on_made: called for each image as soon as it is built or joined.
        signing: a lock, so that one index is signed at a time.
        refused: how often in a row the signer failed.
        whole: it is for one image: nothing more is started after a failure.
        beforehand: seconds of work on items before their turn, if several were built at once.
    """

    state: State
    maker: Maker
    say: Callable[[str], None]
    signer: Signer | None = None
    started: float = field(default_factory=time.monotonic)
    outcomes: list[Outcome] = field(default_factory=list)
    pushed: int = 0
    deadline: float = math.inf
    on_made: Callable[[Item], None] = lambda _: None
    signing: Any = field(default_factory=threading.Lock)
    refused: int = 0
    whole: bool = False
    _may_push: bool = False
    beforehand: dict[tuple[str, str], float] = field(default_factory=dict)

    @property
    def records(self) -> Records:
        """The records of the registry."""
        return self.state.records

    @property
    def failed(self) -> bool:
        """Whether something failed."""
        return any(outcome.state == "failed" for outcome in self.outcomes)

    @property
    def uploaded(self) -> int:
        """Bytes sent to the registry since its client was made: new layers, configs, manifests, attached artifacts,
        indexes and records. Signatures, of about 1 kB each, do not count: cosign sends them.
        """
        return self.pushed + self.state.place.client.uploaded

    @cached_property
    def machine(self) -> provenance.Machine:
        """Who makes the images of this run."""
        return provenance.Machine.here(self.state.date)

    @cached_property
    def source(self) -> list[dict[str, Any]]:
        """The checkout that images are made from, as a dependency of a provenance statement."""
        return provenance.source(self.state.request.services.root)

    def parts(self, item: Item) -> dict[str, str]:
        """Digests of what an item is put together from, by target."""
        return {target: self.state.known[target, item.architecture].digest for target in item.needs}

    # ---- Work --------------------------------------------------------------------------------------------------------

    def each(self, step: str, items: Sequence[Item], work: Work) -> bool:
        """Does a step's work on the items that are ready for it.

        Returns:
            Whether items were postponed, so that the step has to be repeated.
        """
        expected = sum(step in self.state.task(item).steps for item in items)
        number, again = 0, False
        for item in progress_bar.over(items, step, len(items)):
            task = self.state.task(item, ahead=False)
            if task.hindered:
                if task.hindered != ELSEWHERE:
                    self.outcomes.append(Outcome(step, *item.key, "waits", task.hindered))
                continue
            if step not in task.steps[:1]:
                if step in task.steps:  # an earlier step comes first
                    self.outcomes.append(Outcome(step, *item.key, "waits", f"{task.steps[0]} comes first"))
                continue
            if self.whole and self.failed:
                self.outcomes.append(Outcome(step, *item.key, "waits", "something failed before it"))
                continue
            if time.monotonic() >= self.deadline:
                self.outcomes.append(Outcome(step, *item.key, "waits", "the time of this run is over"))
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
                again = True
                continue
            if item.kind != "part" and step != "test":
                self.on_made(item)
        return again

    def do(self, step: str, item: Item, which: str, why: Sequence[str], work: Work) -> None:
        """Does a step's work on an item, and records the result.

        Args:
            step: name of the step.
            item: an image or part.
            which: a count for people, such as `(2 of 7)`.
            why: reasons.
            work: does it.

        Raises:
            Postponed: by the work.
        """
        if not self._may_push:  # ask before the first work, which may take hours
            self.state.place.client.may_push(self.records.repository)
            self._may_push = True
        self.say(f"{step} {item.target} for {item.architecture} {which}: {'; '.join(why)}")
        entry = self.state.known.get(item.key) or Entry(*item.key)
        started, before, waits = time.monotonic(), self.uploaded, buildx.waited()
        try:
            entry = work(item, entry)
        except RosmlError as error:
            entry = replace(entry, failed=failure(step, error.message, error.remedy))
            self.say(f"failed: {error.message}" + (f"; {error.remedy}" if error.remedy else ""))
        waited = buildx.waited() - waits
        seconds = time.monotonic() - started + self.beforehand.pop(item.key, 0.0)
        self.write(item, replace(entry, seconds={**entry.seconds, step: round(seconds - waited, 2)}))
        reason = entry.failed.get("reason", "") if entry.failed else "; ".join(why)
        state: Literal["done", "failed"] = "failed" if entry.failed else "done"
        self.outcomes.append(Outcome(step, *item.key, state, reason, seconds, self.uploaded - before, waited))

    def write(self, item: Item, entry: Entry) -> None:
        """Records the new entry of an item."""
        entry = self._without_what_is_gone(replace(entry, changed=self.state.date))
        self.records.write(entry, self.state.inputs.of(*item.key))
        self.state.known[item.key] = entry
        if entry.digest:
            self.state.present.add(item.key)

    def write_index(self, thing: Image | Part, entry: Entry) -> None:
        """Records the new entry of the index of an image or part."""
        entry = self._without_what_is_gone(replace(entry, changed=self.state.date))
        self.records.write(entry, {})
        self.state.known[thing.target, INDEX] = entry
        self.state.present.add((thing.target, INDEX))

    def _without_what_is_gone(self, entry: Entry) -> Entry:
        """The entry; if it has many superseded digests, without those that are gone, so that it does not grow for
        ever."""
        if len(entry.superseded) <= SUPERSEDED:
            return entry
        place = self.state.place
        there = (x for x in entry.superseded if place.client.head(place.path(entry.repository), x))
        return replace(entry, superseded=tuple(there))

    def put_in_order(self, before: int) -> None:
        """Sorts the outcomes of images that were done side by side.

        Args:
            before: how many outcomes there were before; these stay as they are.
        """
        order = {item.target: number for number, item in enumerate(self.state.items)}
        self.outcomes[before:] = sorted(self.outcomes[before:], key=lambda outcome: order[outcome.target])


def failure(step: str, message: str, remedy: str = "") -> dict[str, str]:
    """What an entry says of a failed step: the beginning of its message, since records are no place for logs."""
    return {"step": step, "reason": "\n".join(message.splitlines()[:12])[:2000]} | (
        {"remedy": remedy} if remedy else {}
    )
