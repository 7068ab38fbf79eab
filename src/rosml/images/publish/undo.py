"""Moves tags back to where they were before a run."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime, timedelta

from rosml.base.clock import TIME, is_date
from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set.labels import TITLE
from rosml.images.image_set.model import PARTS
from rosml.images.matrix.names import part_target
from rosml.images.publish.run import Outcome
from rosml.images.records.store import INDEX, Records
from rosml.images.records.tag_moves import UNDO, Move, later_moves, mark_undone, read_moves, record_name

RECENT = timedelta(days=1)
"""A last run that is older than this is undone only by its name: whoever means last night's may not know that it moved no tag."""


@dataclass(frozen=True)
class Recorded:
    """A run that moved tags.

    Attributes:
        name: the tag of its record.
        moves: its moves, in their order.
        later: where later runs moved tags, by repository, tag and digest, with the date of the last of these runs.
    """

    name: str
    moves: tuple[Move, ...]
    later: Mapping[tuple[str, str, str], str] = field(default_factory=dict)

    @property
    def date(self) -> str:
        """The run's date; what stands in the record's tag, if that is no date."""
        text = self.name.removeprefix(UNDO)
        found = _STAMP.fullmatch(text)
        return "{}-{}-{}T{}:{}:{}Z".format(*found.groups()) if found else text

    def why_stays(self, move: Move, there: str) -> str:
        """Why an undo leaves a tag where it is; empty if it moves it.

        Args:
            there: the digest where the tag is now.
        """
        if there != move.new:
            return "a later run moved it"
        later = self.later.get((move.repository, move.tag, move.new), "")
        return f"the run of {later} moved it here again; undo that one first" if later else ""

    def age(self, date: str) -> timedelta | None:
        """How long before a date it was; None if its own is none."""
        if not (is_date(self.date) and is_date(date)):
            return None
        return datetime.strptime(date, TIME) - datetime.strptime(self.date, TIME)


_STAMP = re.compile(r"(\d{4})(\d\d)(\d\d)T(\d\d)(\d\d)(\d\d)Z", re.ASCII)


def find(book: Records, run: str = "") -> Recorded:
    """The run to undo.

    Args:
        book: the records of the registry.
        run: the run's date; the last run with a record if empty.

    Raises:
        RosmlError: there is no such record, or the registry does not answer.
    """
    known = sorted(name for name in book.registry.tags(book.repository) if name.startswith(UNDO))
    name = record_name(run) if run else (known[-1] if known else "")
    if name not in known:
        dates = ", ".join(item.removeprefix(UNDO) for item in known[-5:])
        text = f"there is no record of {'a run of ' + run if run else 'any run'}"
        raise RosmlError(
            text, f"there are records of {dates}" if known else "no run has moved a tag in this registry yet"
        )
    return Recorded(name, tuple(read_moves(book, name)), later_moves(book, name))


def undo(book: Records, date: str, run: str | Recorded = "") -> list[Outcome]:
    """Moves tags back to where they were before a run. The index they pointed at is held: no later run moves them to it
    again.

    This reads only the run's record and the indexes in it: no matrix, and nothing of this machine.

    Args:
        book: the records of the registry.
        date: the time of this call. Entries say that they are held since then.
        run: the run, or its date; the last run with a record if empty.

    Returns:
        An outcome for each tag that was not back yet.

    Raises:
        RosmlError: there is no such record, or the registry does not answer.
    """
    found = run if isinstance(run, Recorded) else find(book, run)
    now = whereabouts(book, found)
    # Before the first tag moves: if this process is killed in between, the next run moves no tag to these indexes again.
    held = {(move.repository, move.new) for move, where in now if where == move.old or not found.why_stays(move, where)}
    side_by_side(lambda item: _hold(book, item[0], item[1], date), sorted(held))
    mark_undone(book, found.name, date)
    images: dict[tuple[str, str], list[tuple[Move, str]]] = {}
    for move, where in now:
        images.setdefault((move.repository, move.new), []).append((move, where))
    # The tags of one image move in their order, images side by side.
    done = side_by_side(lambda item: [_back(book, found, move, where) for move, where in item], images.values())
    outcomes = [outcome for several in done for outcome in several if outcome]
    return outcomes or [Outcome("undo", found.name, "", "done", "nothing was left to move back")]


def whereabouts(book: Records, found: Recorded) -> list[tuple[Move, str]]:
    """The moves of a run, the last one first, each with the digest where its tag is now; empty if it is gone.

    Raises:
        RosmlError: the registry does not answer.
    """
    recorded = list(reversed(found.moves))
    there = side_by_side(lambda move: book.registry.head(book.place.path(move.repository), move.tag), recorded)
    return list(zip(recorded, there, strict=True))


def foreseen(found: Recorded, move: Move, there: str) -> str:
    """What an undo of a run would do with a tag that is at a digest now."""
    if there == move.old:
        return "is back already"
    if why := found.why_stays(move, there):
        return f"stays: {why}"
    return f"would move back to {move.old}" if move.old else "would be removed: it was not there before"


def _back(book: Records, found: Recorded, move: Move, there: str) -> Outcome | None:
    """Moves one tag back; None if it is back already.

    Raises:
        RosmlError: the registry does not answer.
    """
    repository, text = book.place.path(move.repository), f"{move.repository}:{move.tag}"
    if there == move.old:
        return None
    if why := found.why_stays(move, there):
        return Outcome("undo", text, "", "waits", why)
    try:
        if move.old:
            book.registry.tag(repository, move.old, move.tag)
        else:
            book.registry.delete(repository, move.tag)
    except RosmlError as error:  # the registry deletes no tag, or the old index is gone: the other tags still move
        book.registry.head(
            book.repository, found.name
        )  # raises if the registry is down, before all other tags time out
        reason = f"{error.message}: {error.remedy}" if error.remedy else error.message
        return Outcome("undo", text, "", "failed", reason)
    return Outcome("undo", text, "", "done", f"back to {move.old}" if move.old else "removed: it was not there before")


def _hold(book: Records, repository: str, digest: str, date: str) -> None:
    """Records that an index gets no more tags, in the entry of the image or part that its title names."""
    index = book.registry.manifest(book.place.path(repository), digest)
    title = index.annotations.get(TITLE, "") if index else ""
    entry = book.read(part_target(title) if repository == PARTS else title, INDEX) if title else None
    if entry and not entry.held and (entry.repository, entry.digest) == (repository, digest):
        book.write(replace(entry, held=date, changed=date), {})
