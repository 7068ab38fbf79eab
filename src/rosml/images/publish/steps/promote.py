"""Moves tags to indexes whose images passed everything.

The order matters. First the index is signed, if the run signs, and the entries are attached to its images. Then the run
records where tags were. Then tags move: first the dated tag, which no later run moves, then tags that spell versions
out, and last the floating ones. A tag never moves to something older, or to fewer architectures.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain, count

from rosml.base import clock
from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set import labels
from rosml.images.image_set.labels import TITLE
from rosml.images.image_set.model import Image, Part, tags_of
from rosml.images.matrix.tags import dated
from rosml.images.publish.run import Run
from rosml.images.publish.steps.sign import sign
from rosml.images.records import store, tag_moves
from rosml.images.records.store import INDEX, Entry
from rosml.images.records.tag_moves import Move, record_name
from rosml.registry.oci import Manifest

BATCH = 64
"""How many images are prepared, and their moves recorded, before their tags move."""

Thing = Image | Part
Tags = Mapping[tuple[str, str], str]
"""Where tags point, by repository and tag."""


def promote(run: Run) -> list[Move]:
    """Moves the tags of all images whose index is up to date, in batches: if the run is ended, the first images have their tags."""
    return _Promotion(run).moves()


class _Promotion:
    def __init__(self, run: Run) -> None:
        self.run = run
        self.state = run.state
        self.registry = run.state.place.client
        self.date = run.state.date
        self._silent: RosmlError | None = None

    def moves(self) -> list[Move]:
        before, moves = len(self.run.outcomes), list[Move]()
        tags = self._tags()
        ready = [thing for thing in self.state.things() if self._is_ready(thing)]
        while ready:
            batch, ready = ready[:BATCH], ready[BATCH:]
            prepared = side_by_side(lambda thing: (thing, self._prepare(thing, tags)), batch)
            planned = [(thing, thing_moves) for thing, thing_moves in prepared if thing_moves]
            if planned:
                batch_moves = [move for _, thing_moves in planned for move in thing_moves]
                tag_moves.record(self.run.records, self.date, batch_moves)
                moves += batch_moves
            side_by_side(lambda pair: self._move(*pair), planned)  # the tags of one image move in their order
        self.run.put_in_order(before)
        return moves

    def _tags(self) -> Tags:
        """Where the tags of all indexes point. Asks side by side: one after the other takes minutes on a distant registry."""
        names = [
            (self.state.place.path(entry.repository), tag)
            for thing in self.state.things()
            if (entry := self.state.index_of(thing)) and entry.digest
            for tag in (dated(tags_of(thing)[0], entry.date), *tags_of(thing))
        ]
        return dict(zip(names, side_by_side(lambda name: self.registry.head(*name), names), strict=True))

    def _is_ready(self, thing: Thing) -> bool:
        """Whether an image's index is up to date and may have tags; if not, an outcome says so."""
        entry = self.state.index_of(thing)
        reason = self.state.unready(thing)
        if not reason and (entry is None or not self.state.is_of_these(thing, entry)):
            reason = "its index is not made yet"
        if not reason and entry and entry.held:
            reason = f"its tags were moved back on {entry.held[:10]}; a change, or --force, rebuilds it"
        if reason:
            self.run.add("promote", thing, "failed" if self.state.damage(thing) else "waits", reason)
        return not reason

    def _prepare(self, thing: Thing, tags: Tags) -> list[Move]:
        """Signs an image's index and attaches the entries to its images, then returns its moves; none if that fails."""
        entry = self.state.entries[thing.target, INDEX]
        moves = list(self._moves(thing, entry, tags))
        if (moves or self.run.signer) and (reason := self._foreign_index(thing, entry)):
            self.run.add("promote", thing, "failed", reason)
        elif sign(self.run, thing, moving=bool(moves)) and moves and self._attach_entries(thing):
            return moves
        return []

    def _foreign_index(self, thing: Thing, entry: Entry) -> str:
        """Why the index that the records name is not the index of this image; empty if it is."""
        index = self.registry.manifest(self.state.place.path(entry.repository), entry.digest)
        if index is None:
            return f"its index {entry.digest} is not in the registry any more"
        name = index.annotations.get(TITLE, "")
        if _members(index) != dict(entry.parts) or name != labels.title(thing):
            what = f"that of {name}" if name != labels.title(thing) else "of other images than the records have"
            return f"the records name {entry.digest} as its index, which is {what}; --force rebuilds it"
        return ""

    def _attach_entries(self, thing: Thing) -> bool:
        """Attaches their entries to the images of an index, for the catalogue's history. Returns whether it worked."""
        started = time.monotonic()
        try:
            for key in self.state.members(thing):
                self.run.records.attach(self.state.entries[key], self.state.inputs.of(*key))
        except RosmlError as error:
            self._require_answer()
            self.run.add("promote", thing, "failed", error.message, started)
            return False
        return True

    def _moves(self, thing: Thing, entry: Entry, tags: Tags) -> Iterator[Move]:
        """The moves of an image, in their order. A move that would go back or lose an architecture is left out and reported."""
        repository = self.state.place.path(entry.repository)
        main, *others = tags_of(thing)
        day = dated(main, entry.date)
        for name in chain([day], (f"{day}.{number}" for number in count(2))):  # the second tag of a day ends in .2
            digest = tags[repository, day] if name == day else self.registry.head(repository, name)
            if not digest:
                yield Move(entry.repository, name, "", entry.digest)
            if digest in ("", entry.digest):
                break
        spelled = [tag for tag in others if tag.startswith(f"{main}-")]
        for tag in (*spelled, main, *(tag for tag in others if tag not in spelled)):
            digest = tags[repository, tag]
            if digest == entry.digest:
                continue
            if reason := self._reason_to_stay(repository, digest, entry):
                self.run.add("promote", thing, "waits", f"{tag} stays: {reason}")
                continue
            yield Move(entry.repository, tag, digest, entry.digest)

    def _reason_to_stay(self, repository: str, digest: str, entry: Entry) -> str:
        """Why a tag stays at a digest; empty if it moves."""
        index = self.registry.manifest(repository, digest) if digest else None
        if index is None:
            return ""
        date = store.date_of(index)
        if date and not clock.is_date(date):
            self.run.say(f"{repository}@{digest} has no valid date ({date[:40]!r}), and is taken for older")
        elif date > entry.date and not clock.is_ahead(date, clock.now()):
            return f"it points at something newer, of {date}"
        elif date > entry.date and not self.state.request.force:
            return f"it points at something of {date}, which is in the future: undo that run, or move it with --force"
        lost = _members(index).keys() - entry.parts.keys() - {"unknown", ""}
        return f"it would lose {', '.join(sorted(lost))}" if lost else ""

    def _move(self, thing: Thing, moves: Iterable[Move]) -> None:
        """Moves the tags of an image. If one is protected, only this image fails; if the registry is silent, no further tag is tried."""
        started = time.monotonic()
        reason = ""
        try:
            for move in moves:
                if self._silent:
                    raise self._silent
                self.registry.tag(self.state.place.path(move.repository), move.new, move.tag)
        except RosmlError as error:
            try:
                self._require_answer()
            except RosmlError as silent:
                self._silent = silent
                raise
            reason = error.message
        tags = ", ".join(move.tag for move in moves)
        self.run.add("promote", thing, "failed" if reason else "done", reason or tags, started)

    def _require_answer(self) -> None:
        """Checks, after a failure, that the registry answers. If it does not, trying every other tag would take hours."""
        self.registry.head(self.run.records.repository, record_name(self.date))


def _members(index: Manifest) -> dict[str, str]:
    """Digests of an index's images by architecture."""
    return {(item.platform and item.platform.architecture) or "": item.digest for item in index.members}
