"""Moves tags to indexes whose images passed everything.

The order matters. First the index is signed, if the run signs, and the entries are attached to its images. Then the run
records where tags were. Then tags move: first the dated tag, which no later run moves, then tags that spell versions
out, and last the floating ones. A tag never moves to something older, or to fewer architectures.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from itertools import chain, count
from typing import Any

from rosml.base import clock
from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set import labels
from rosml.images.image_set.labels import TITLE
from rosml.images.image_set.model import Image, Part, tags_of
from rosml.images.matrix.names import dated
from rosml.images.publish.run import Outcome, Run
from rosml.images.publish.steps.sign import sign
from rosml.images.records import store, tag_moves
from rosml.images.records.store import INDEX, Entry
from rosml.images.records.tag_moves import Move, record_name
from rosml.registry.oci import Manifest

BATCH = 64
"""How many images are prepared, and their moves recorded, before their tags move."""


def promote(run: Run) -> list[Move]:
    """Moves the tags of all images whose index is up to date. If the registry refuses one image, the others still move.

    Works on images in batches, so that if the run is ended, for example by a time limit, the first images have their
    tags.

    Raises:
        RosmlError: the registry does not answer, or refuses the record of where a batch's tags were; then none of these
            tags moves.
    """
    return _Promotion(run).moves()


class _Promotion:
    def __init__(self, run: Run) -> None:
        self.run = run
        self.state = run.state
        self.registry = run.state.place.client
        self.date = run.state.date
        self._there: dict[tuple[str, str], str] = {}
        self._silent: RosmlError | None = None

    def moves(self) -> list[Move]:
        before, every = len(self.run.outcomes), list[Move]()
        self._there = self._pointing()
        ready = [thing for thing in self.state.things() if self._ready(thing)]
        while ready:
            batch, ready = ready[:BATCH], ready[BATCH:]
            planned = [item for item in side_by_side(self._prepared, batch) if item[1]]
            moves = [move for _, several in planned for move in several]
            if moves:
                tag_moves.record(self.run.records, self.date, moves)
            every += moves
            side_by_side(self._move, planned)  # the tags of one image move in their order
        self.run.put_in_order(before)
        return every

    def _ready(self, thing: Image | Part) -> bool:
        """Whether an image's index is up to date and may have tags; if not, an outcome says so."""
        entry = self.state.index_of(thing)
        if reason := self.state.unready(thing):
            self._say(thing, "waits", reason)
        elif entry is None or not self.state.is_of_these(thing, entry):
            self._say(thing, "waits", "its index is not made yet")
        elif entry.held:
            self._say(
                thing, "waits", f"its tags were moved back on {entry.held[:10]}; a change, or --force, rebuilds it"
            )
        else:
            return True
        return False

    def _prepared(self, thing: Image | Part) -> tuple[Image | Part, list[Move]]:
        """Signs an image's index and attaches the entries to its images, then gives its moves; no moves if that
        fails."""
        entry = self.state.known[thing.target, INDEX]
        moves = list(self._moves(thing, entry))
        if (moves or self.run.signer) and (wrong := self._wrong(thing, entry)):
            self._say(thing, "failed", wrong)
        elif sign(self.run, thing, moving=bool(moves)) and moves and self._attached(thing):
            return thing, moves
        return thing, []

    def _say(self, thing: Image | Part, state: Any, reason: str, seconds: float = 0.0) -> None:
        self.run.outcomes.append(Outcome("promote", thing.target, "", state, reason, seconds))

    def _wrong(self, thing: Image | Part, entry: Entry) -> str:
        """Why the index that the records name is not the index of this image; empty if it is."""
        found = self.registry.manifest(self.state.place.path(entry.repository), entry.digest)
        if found is None:
            return f"its index {entry.digest} is not in the registry any more"
        name = found.annotations.get(TITLE, "")
        if _members(found) != dict(entry.parts) or name != labels.title(thing):
            what = f"that of {name}" if name != labels.title(thing) else "of other images than the records have"
            return f"the records name {entry.digest} as its index, which is {what}; --force rebuilds it"
        return ""

    def _attached(self, thing: Image | Part) -> bool:
        """Attaches their entries to the images of an index, for the catalogue's history. Gives whether it worked."""
        started = time.monotonic()
        try:
            for key in self.state.members(thing):
                self.run.records.attach(self.state.known[key], self.state.inputs.of(*key))
        except RosmlError as error:
            _require_answer(self.run)
            self._say(thing, "failed", error.message, time.monotonic() - started)
            return False
        return True

    def _pointing(self) -> dict[tuple[str, str], str]:
        """Where the tags of all indexes point, by repository and tag. Asks side by side: one after the other, this
        would take minutes on a distant registry, although most tags need no move.
        """
        known = self.state.known
        wanted = [
            (self.state.place.path(entry.repository), tag)
            for thing in self.state.things()
            if (entry := known.get((thing.target, INDEX))) and entry.digest
            for tag in (dated(tags_of(thing)[0], entry.date), *tags_of(thing))
        ]
        return dict(zip(wanted, side_by_side(lambda item: self.registry.head(*item), wanted), strict=True))

    def _moves(self, thing: Image | Part, entry: Entry) -> Iterable[Move]:
        """The moves of an image, in their order. If a move would go back or lose an architecture, it is left out and
        reported."""
        repository = self.state.place.path(entry.repository)
        tags = tags_of(thing)
        main = tags[0]
        day = dated(main, entry.date)
        for name in chain([day], (f"{day}.{number}" for number in count(2))):  # the second tag of a day ends in .2
            there = self._there[repository, day] if name == day else self.registry.head(repository, name)
            if not there:
                yield Move(entry.repository, name, "", entry.digest)
            if there in ("", entry.digest):
                break
        spelled = [tag for tag in tags if tag.startswith(f"{main}-")]
        for tag in (*spelled, *(tag for tag in tags if tag not in spelled)):
            old = self._there[repository, tag]
            if old == entry.digest:
                continue
            if reason := self._keeps(repository, old, entry):
                self._say(thing, "waits", f"{tag} stays: {reason}")
                continue
            yield Move(entry.repository, tag, old, entry.digest)

    def _keeps(self, repository: str, old: str, entry: Entry) -> str:
        """Why a tag stays where it is; empty if it moves."""
        found = self.registry.manifest(repository, old) if old else None
        if found is None:
            return ""
        date = store.date_of(found)
        if date and not clock.is_date(date):
            self.run.say(f"{repository}@{old} has no valid date ({date[:40]!r}), and is taken for older")
        elif date > entry.date and not clock.is_ahead(date, clock.now()):
            return f"it points at something newer, of {date}"
        elif date > entry.date and not self.state.request.force:
            return f"it points at something of {date}, which is in the future: undo that run, or move it with --force"
        platforms = [item.platform for item in found.members if item.platform]
        lost = {item.architecture or "" for item in platforms} - set(entry.parts) - {"unknown", ""}
        return f"it would lose {', '.join(sorted(lost))}" if lost else ""

    def _move(self, planned: tuple[Image | Part, list[Move]]) -> None:
        """Moves the tags of an image. If a tag is protected, or the index is gone, only this image fails.

        Raises:
            RosmlError: the registry does not answer.
        """
        started = time.monotonic()
        thing, moves = planned
        reason = ""
        try:
            for move in moves:
                if self._silent:
                    raise self._silent
                self.registry.tag(self.state.place.path(move.repository), move.new, move.tag)
        except RosmlError as error:
            try:
                _require_answer(self.run)
            except RosmlError as silent:
                self._silent = silent
                raise
            reason = error.message
        tags = ", ".join(move.tag for move in moves)
        self._say(thing, "failed" if reason else "done", reason or tags, time.monotonic() - started)


def _members(index: Manifest) -> dict[str, str]:
    """Digests of an index's images by architecture."""
    return {(item.platform and item.platform.architecture) or "": item.digest for item in index.members}


def _require_answer(run: Run) -> None:
    """Checks, after a failure, that the registry answers. If it does not, trying every other tag would take hours.

    Raises:
        RosmlError: it does not.
    """
    run.state.place.client.head(run.records.repository, record_name(run.state.date))
