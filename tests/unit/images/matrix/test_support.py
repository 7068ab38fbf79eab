"""Until when a distribution is supported, and what to take after that."""

from __future__ import annotations

from datetime import date
from pathlib import Path

import pytest
from click.testing import CliRunner
from conftest import SMALL

from rosml.base import clock
from rosml.cli.images import explain, listing
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import support

END = date(2026, 11, 30)


def test_the_day_of_the_end_of_life_is_the_last_one_with_support(real: ImageSet) -> None:
    assert real.matrix.distributions["kilted"].eol == END
    days = (END.replace(day=29), END, date(2026, 12, 1))
    assert [support.has_ended(real.matrix, "kilted", day) for day in days] == [False, False, True]
    assert not support.has_ended(real.matrix, "rolling", date(2999, 1, 1))


@pytest.mark.parametrize(
    ("name", "others"),
    [
        ("kilted", ("jazzy", "lyrical")),  # on its system; with the longest support
        ("iron", ("humble", "lyrical")),
        ("foxy", ("lyrical", "jazzy")),
        ("noetic", ("ros1-trixie", "ros1-bookworm")),
    ],
)
def test_what_to_take_instead(name: str, others: tuple[str, ...], real: ImageSet) -> None:
    assert support.instead(real.matrix, name, date(2026, 12, 1)) == others


@pytest.mark.parametrize(("now", "ended"), [("2029-05-31T23:59:59Z", False), ("2029-06-01T00:00:00Z", True)])
def test_list_and_explain_say_it(now: str, ended: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clock, "now", lambda: now)
    matrix = tmp_path / "matrix.yaml"
    matrix.write_text(SMALL)
    for command, name in ((listing.main, "alpha"), (explain.main, "alpha-core")):
        done = CliRunner().invoke(command, ["--matrix", str(matrix), name])
        assert ("alpha had its end of life on 2029-05-31; take omega" in done.output) is ended, done.output
