"""Moves tags back to where they were before a run."""

from __future__ import annotations

from dataclasses import replace

from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set.labels import TITLE
from rosml.images.image_set.model import PARTS
from rosml.images.matrix.names import part_target
from rosml.images.publish.run import Outcome
from rosml.images.records.store import INDEX, Records
from rosml.images.records.tag_moves import UNDO, Move, read_moves, record_name


def undo(book: Records, date: str, run: str = "") -> list[Outcome]:
    """Moves tags back to where they were before a run. The index they pointed at is held: no later run moves them to it
    again.

    This reads only the run's record and the indexes in it: no matrix, and nothing of this machine.

    Args:
        book: the records of the registry.
        date: the time of this call. Entries say that they are held since then.
        run: the run's date; the last run with a record if empty.

    Returns:
        An outcome for each tag that was not back yet.

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
    recorded = list(reversed(read_moves(book, name)))
    there = side_by_side(lambda move: book.registry.head(book.place.path(move.repository), move.tag), recorded)
    now = list(zip(recorded, there, strict=True))
    # Before the first tag moves: if this process is killed in between, the next run moves no tag to these indexes again.
    held = {(move.repository, move.new) for move, where in now if where in (move.old, move.new)}
    side_by_side(lambda item: _hold(book, item[0], item[1], date), sorted(held))
    images: dict[tuple[str, str], list[tuple[Move, str]]] = {}
    for move, where in now:
        images.setdefault((move.repository, move.new), []).append((move, where))
    # The tags of one image move in their order, images side by side.
    found = side_by_side(lambda item: [_back(book, name, move, where) for move, where in item], images.values())
    outcomes = [outcome for several in found for outcome in several if outcome]
    return outcomes or [Outcome("undo", name, "", "done", "nothing was left to move back")]


def _back(book: Records, record: str, move: Move, there: str) -> Outcome | None:
    """Moves one tag back; None if it is back already.

    Raises:
        RosmlError: the registry does not answer.
    """
    repository, text = book.place.path(move.repository), f"{move.repository}:{move.tag}"
    if there == move.old:
        return None
    if there != move.new:
        return Outcome("undo", text, "", "waits", "a later run moved it")
    try:
        if move.old:
            book.registry.tag(repository, move.old, move.tag)
        else:
            book.registry.delete(repository, move.tag)
    except RosmlError as error:  # the registry deletes no tag, or the old index is gone: the other tags still move
        book.registry.head(book.repository, record)  # raises if the registry is down, before all other tags time out
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
