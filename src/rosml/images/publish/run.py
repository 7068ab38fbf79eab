"""A publishing run: carries out a step item by item, and records each item when it is done.

If a run is interrupted, the next one completes it. A failed item is recorded as failed; only items that are joined from it
wait for it. What a step does is in `steps/`.
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
from rosml.images.scan import judge
from rosml.images.scan.sbom import Shelf

Work = Callable[[Item, Entry], Entry]
"""Does a step's work on an item; gives the entry of the item after it."""

SUPERSEDED = 20
"""An entry that has taken the place of more digests than that forgets those that are gone from the registry."""


class Postponed(Exception):
    """An item's turn comes again in this run; the message says why."""


@dataclass(frozen=True)
class Outcome:
    """What a step did about an item.

    Attributes:
        step: its name.
        target, architecture: of the item; no architecture if it is about an index or tags.
        state: done, failed, or waits for something that is not there.
        reason: what was done, or why it failed or waits.
        seconds: wall time.
        uploaded: bytes that the registry got.
    """

    step: str
    target: str
    architecture: str
    state: Literal["done", "failed", "waits"]
    reason: str = ""
    seconds: float = 0.0
    uploaded: int = 0

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {name: value for name, value in vars(self).items() if value != ""}


@dataclass
class Run:
    """A publishing run.

    Attributes:
        state: what is known; the run keeps it up to date.
        maker: builds, joins and tests.
        say: told what is going on, a line at a time.
        signer: signs indexes, which get no tags without a signature; None if nothing is signed.
        started: when the run began, by the monotonic clock.
        outcomes: what was done so far.
        pushed: bytes of layers that the builder added to the registry.
        deadline: by the monotonic clock, when nothing more is begun.
        on_made: called for each image as soon as it is there.
        signing: held while something is signed: one at a time.
        refused: how often the signer failed, one time after the other.
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
    _may_push: bool = False

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
        """Bytes that the registry got since its client was made: layers that it did not have, configs, manifests, what is
        attached, indexes, the records. Without signatures, which cosign sends, of about 1 kB each.
        """
        return self.pushed + self.state.place.client.uploaded

    @cached_property
    def machine(self) -> provenance.Machine:
        """Who makes the images of this run."""
        return provenance.Machine.here(self.state.date)

    @cached_property
    def source(self) -> list[dict[str, Any]]:
        """The checkout that they are made from, as a dependency of a provenance statement."""
        return provenance.source(self.state.request.services.root)

    @property
    def shelf(self) -> Shelf:
        """The SBOMs that the records name."""
        known = self.state.known.values()
        return Shelf(self.state.place.client, {entry.digest: entry.sbom for entry in known if entry.sbom})

    def scanned_part(self, target: str, architecture: str) -> judge.Part:
        """A ROS image or part that was made, as a scan knows it."""
        part, place = self.state.by_key[target, architecture], self.state.place
        digest = self.state.known[part.key].digest
        return judge.Part(target, place.client.host, place.path(part.repository), digest, part.kind == "ros")

    def parts(self, item: Item) -> dict[str, str]:
        """Digests of what an item is put together from, by target."""
        return {target: self.state.known[target, item.architecture].digest for target in item.needs}

    # ---- Work --------------------------------------------------------------------------------------------------------

    def each(self, step: str, items: Sequence[Item], work: Work) -> bool:
        """Does a step's work on those items whose turn it is.

        Returns:
            Whether some were postponed: the step is to be done once more.
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
                if step in task.steps:  # an earlier step is still to be done
                    self.outcomes.append(Outcome(step, *item.key, "waits", f"{task.steps[0]} comes first"))
                continue
            if time.monotonic() >= self.deadline:
                self.outcomes.append(Outcome(step, *item.key, "waits", "the time of this run is over"))
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
        """Does a step's work on an item, and writes down what came of it.

        Args:
            which: of how many it is, for people. why: it is done.

        Raises:
            Postponed: by the work.
        """
        if not self._may_push:  # asked before the first work is done, which may take hours
            self.state.place.client.may_push(self.records.repository)
            self._may_push = True
        self.say(f"{step} {item.target} for {item.architecture} {which}: {'; '.join(why)}")
        entry = self.state.known.get(item.key) or Entry(*item.key)
        started, before = time.monotonic(), self.uploaded
        try:
            entry = work(item, entry)
        except RosmlError as error:
            entry = replace(entry, failed=failure(step, error.message, error.remedy))
            self.say(f"failed: {error.message}" + (f"; {error.remedy}" if error.remedy else ""))
        seconds = time.monotonic() - started
        self.write(item, replace(entry, seconds={**entry.seconds, step: round(seconds, 2)}))
        reason = entry.failed.get("reason", "") if entry.failed else "; ".join(why)
        state: Literal["done", "failed"] = "failed" if entry.failed else "done"
        self.outcomes.append(Outcome(step, *item.key, state, reason, seconds, self.uploaded - before))

    def write(self, item: Item, entry: Entry) -> None:
        """Records what is known of an item now."""
        entry = self._without_what_is_gone(replace(entry, changed=self.state.date))
        self.records.write(entry, self.state.inputs.of(*item.key))
        self.state.known[item.key] = entry
        if entry.digest:
            self.state.present.add(item.key)

    def write_index(self, thing: Image | Part, entry: Entry) -> None:
        """Records what is known of an image's, or part's, index now."""
        entry = self._without_what_is_gone(replace(entry, changed=self.state.date))
        self.records.write(entry, {})
        self.state.known[thing.target, INDEX] = entry
        self.state.present.add((thing.target, INDEX))

    def _without_what_is_gone(self, entry: Entry) -> Entry:
        """An entry without the digests that were in its place and are gone, if it has many: it would grow for ever."""
        if len(entry.superseded) <= SUPERSEDED:
            return entry
        place = self.state.place
        there = (x for x in entry.superseded if place.client.head(place.path(entry.repository), x))
        return replace(entry, superseded=tuple(there))

    def put_in_order(self, before: int) -> None:
        """Gives outcomes the order of images again, which were done side by side.

        Args:
            before: how many outcomes there were before that.
        """
        order = {thing.target: number for number, thing in enumerate(self.state.things())}
        self.outcomes[before:] = sorted(self.outcomes[before:], key=lambda outcome: order[outcome.target])


def failure(step: str, message: str, remedy: str = "") -> dict[str, str]:
    """What an entry says of a step that failed: the beginning of its message, since the records are no place for logs."""
    return {"step": step, "reason": "\n".join(message.splitlines()[:12])[:2000]} | (
        {"remedy": remedy} if remedy else {}
    )
