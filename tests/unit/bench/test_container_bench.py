"""`python -m bench container`: sides take turns, and a ratio compares what was measured in one round."""

from __future__ import annotations

from bench import container
from bench.container import OURS, PROCESS, SIDES, USER

WORK = dict.fromkeys(container.MEASURES.values(), 1.0)


def test_a_ratio_is_of_one_round() -> None:
    """The machine was slow in one round for all, and in another for the process alone. A ratio of medians would be 0.75."""
    trip = {PROCESS: (0.001, 0.004, 0.004), OURS: (0.002, 0.008, 0.003), USER: (0.001, 0.004, 0.004)}
    works = {side: [WORK | {"trip 1000": seconds} for seconds in times] for side, times in trip.items()}
    rows = {row.what: row for row in container.rows({side: [{"start": 0.5}] for side in SIDES}, works)}
    assert rows["round trip of 1 kB"].cells == ["4.000 ms", "", "", "3.000 ms", "4.000 ms"]
    assert rows["round trip of 1 kB, beside a process"].cells == ["1.00", "", "", "2.00", "1.00"]
    assert rows["start and end of `true`"].cells == ["500 ms"] * len(SIDES)


def test_sides_take_turns() -> None:
    calls: list[str] = []

    def call(side: str) -> dict[str, float]:
        calls.append(side)
        return {"call": float(len(calls))}

    measured = container.turns(2, "abc", call, lambda line: None)
    assert "".join(calls) == "cababcbca", "another side begins each time, and the first round only fills caches"
    assert measured == {
        "a": [{"call": 4.0}, {"call": 9.0}],
        "b": [{"call": 5.0}, {"call": 7.0}],
        "c": [{"call": 6.0}, {"call": 8.0}],
    }
