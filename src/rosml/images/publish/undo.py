"""Moves tags back to where they were before a run.

This reads only the run's record and the indexes in it: no matrix, and nothing of this machine.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime, timedelta

from rosml.base.clock import TIME, is_date
from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set.labels import TITLE
from rosml.images.image_set.model import ENVIRONMENTS, PARTS
from rosml.images.matrix.names import part_target
from rosml.images.publish.run import Outcome
from rosml.images.records.store import INDEX, Records
from rosml.images.records.tag_moves import UNDO, Move, later_moves, mark_undone, read_moves, record_name, run_date

RECENT = timedelta(days=1)
"""A last run that is older than this is undone only by its name: whoever means last night's may not know that it moved no tag."""


@dataclass(frozen=True)
class RecordedRun:
    """A run that moved tags."""

    name: str  # the tag of its record
    moves: tuple[Move, ...]  # in their order
    # Where later runs moved tags, by repository, tag and digest, with the date of the last of these runs.
    later: Mapping[tuple[str, str, str], str] = field(default_factory=dict)

    @property
    def date(self) -> str:
        return run_date(self.name)

    def reason_to_stay(self, move: Move, digest: str) -> str:
        """Why an undo leaves a tag at the digest where it is now; empty if it moves it."""
        if digest != move.new:
            return "a later run moved it"
        later = self.later.get((move.repository, move.tag, move.new), "")
        return f"the run of {later} moved it here again; undo that one first" if later else ""

    def foreseen(self, move: Move, digest: str) -> str:
        """What an undo would do with a tag that is at a digest now."""
        if digest == move.previous:
            return "is back already"
        if reason := self.reason_to_stay(move, digest):
            return f"stays: {reason}"
        return f"would move back to {move.previous}" if move.previous else "would be removed: it was not there before"

    def age(self, date: str) -> timedelta | None:
        """The time from the run to a date; None if one of the two is no date."""
        if not (is_date(self.date) and is_date(date)):
            return None
        return datetime.strptime(date, TIME) - datetime.strptime(self.date, TIME)


def find(book: Records, date: str = "") -> RecordedRun:
    """The run of a date; the last run with a record if there is no date."""
    records = sorted(name for name in book.registry.tags(book.repository) if name.startswith(UNDO))
    name = record_name(date) if date else (records[-1] if records else "")
    if name not in records:
        dates = ", ".join(record.removeprefix(UNDO) for record in records[-5:])
        remedy = f"there are records of {dates}" if records else "no run has moved a tag in this registry yet"
        raise RosmlError(f"there is no record of {'a run of ' + date if date else 'any run'}", remedy)
    return RecordedRun(name, tuple(read_moves(book, name)), later_moves(book, name))


def undo(book: Records, date: str, run: RecordedRun) -> list[Outcome]:
    """Moves tags back to where they were before a run. No later run moves them to the same index again. An outcome for each tag moved."""
    moves = whereabouts(book, run)
    # Before the first tag moves: if this process is killed in between, the next run moves no tag to these indexes again.
    held = {
        (move.repository, move.new)
        for move, digest in moves
        if digest == move.previous or not run.reason_to_stay(move, digest)
    }
    side_by_side(lambda index: _hold(book, *index, date), sorted(held))
    mark_undone(book, run.name, date)
    images: dict[tuple[str, str], list[tuple[Move, str]]] = {}
    for move, digest in moves:
        images.setdefault((move.repository, move.new), []).append((move, digest))
    # The tags of one image move in their order, images side by side.
    done = side_by_side(lambda pairs: [_move_back(book, run, *pair) for pair in pairs], images.values())
    outcomes = [outcome for of_image in done for outcome in of_image if outcome]
    return outcomes or [Outcome("undo", run.name, "", "done", "nothing was left to move back")]


def whereabouts(book: Records, run: RecordedRun) -> list[tuple[Move, str]]:
    """The moves of a run, the last one first, each with the digest where its tag is now; empty if it is gone."""
    moves = list(reversed(run.moves))
    digests = side_by_side(lambda move: book.registry.head(book.place.path(move.repository), move.tag), moves)
    return list(zip(moves, digests, strict=True))


def _move_back(book: Records, run: RecordedRun, move: Move, digest: str) -> Outcome | None:
    """Moves one tag back from the digest where it is now; None if it is back already."""
    repository, text = book.place.path(move.repository), f"{move.repository}:{move.tag}"
    if digest == move.previous:
        return None
    if reason := run.reason_to_stay(move, digest):
        return Outcome("undo", text, "", "waits", reason)
    try:
        if move.previous:
            book.registry.tag(repository, move.previous, move.tag)
        else:
            book.registry.delete(repository, move.tag)
    except RosmlError as error:  # the registry deletes no tag, or the old index is gone: the other tags still move
        book.registry.head(book.repository, run.name)  # raises if the registry is down, before all other tags time out
        reason = f"{error.message}: {error.remedy}" if error.remedy else error.message
        return Outcome("undo", text, "", "failed", reason)
    return Outcome(
        "undo", text, "", "done", f"back to {move.previous}" if move.previous else "removed: it was not there before"
    )


def _hold(book: Records, repository: str, digest: str, date: str) -> None:
    """Records that an index gets no more tags, in the entry of the image or part that its title names."""
    index = book.registry.manifest(book.place.path(repository), digest)
    title = index.annotations.get(TITLE, "") if index else ""
    entry = book.read(part_target(title) if repository in (PARTS, ENVIRONMENTS) else title, INDEX) if title else None
    if entry and not entry.held and (entry.repository, entry.digest) == (repository, digest):
        book.write(replace(entry, held=date, changed=date), {})
