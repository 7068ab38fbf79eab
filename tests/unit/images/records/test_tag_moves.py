"""The record of a run's moves: what it says after a second call of the run, and after somebody undid it."""

from __future__ import annotations

from dataclasses import replace

from fakes.memory_registry import DAY, NEXT, PREFIX, MemoryRegistry
from rosml.images.records import tag_moves
from rosml.images.records.store import Records
from rosml.images.records.tag_moves import Move
from rosml.registry.place import Place

MOVE = Move("ros", "latest", "", "sha256:1")


def test_where_a_tag_was_before_the_first_call_of_a_run_counts() -> None:
    records = Records(Place(MemoryRegistry(), PREFIX))
    tag_moves.record(records, DAY, [MOVE])
    tag_moves.record(records, DAY, [replace(MOVE, previous="sha256:1", new="sha256:2")])
    assert tag_moves.read_moves(records, tag_moves.record_name(DAY)) == [replace(MOVE, new="sha256:2")]


def test_a_run_that_is_undone_moved_nothing() -> None:
    records = Records(Place(MemoryRegistry(), PREFIX))
    first, second = (tag_moves.record_name(date) for date in (DAY, NEXT))
    tag_moves.record(records, NEXT, [MOVE])
    assert tag_moves.later_moves(records, first) == {("ros", "latest", "sha256:1"): NEXT}
    tag_moves.mark_undone(records, second, NEXT)
    assert tag_moves.later_moves(records, first) == {} and tag_moves.undone_moves(records, 1) == [MOVE]
    assert tag_moves.run_date(second) == NEXT
