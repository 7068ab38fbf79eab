"""What was built: records, and the tables that are made of them."""

from __future__ import annotations

import json
from datetime import date
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from conftest import ROOT
from memory_registry import PREFIX
from shelf import FIRST, Shelf

from rosml import built, command, readme
from rosml.built import Built
from rosml.errors import RosmlError
from rosml.expand import Catalogue
from rosml.gather import Gatherer
from scripts import generate_bake, publish

DAY = date(2026, 11, 22)
ONE = Built(target="bookworm-core", date=DAY, compressed=325_100_000, unpacked=1_270_000_000, passed=21, seconds=23.8)
OTHER = Built(target="trixie-core", date=date(2026, 11, 21), passed=20, outdated=True)
PAGE = """\
# Page

<!-- built 2026-11-22: written by scripts/generate_bake.py -->
old
<!-- /built -->
between
<!-- built 2026-11-21: written by scripts/generate_bake.py -->
<!-- /built -->
end
"""


def test_each_day_has_its_table() -> None:
    page = built.render(PAGE, (ONE, OTHER))
    assert page.index("| `bookworm-core` | 325.1 MB | 1.27 GB | 21 of 21 | 23.8 s |") < page.index("between")
    assert page.index("between") < page.index("| `trixie-core` † | | | 20 of 20 | |") < page.index("end")
    assert "old" not in page
    assert built.render(page, (ONE, OTHER)) == page


def test_a_day_without_a_place_and_a_place_without_a_day() -> None:
    with pytest.raises(RosmlError, match="no place for what was built on 2026-11-21") as caught:
        built.render(PAGE.replace("2026-11-21", "2026-11-20"), (ONE, OTHER))
    assert "<!-- built 2026-11-21: written by" in caught.value.remedy
    with pytest.raises(RosmlError, match=r"nothing in docs/built\.json is for <!-- built 2026-11-21"):
        built.render(PAGE, (ONE,))


def test_newer_records_take_the_place_of_older_ones(tmp_path: Path, real: Catalogue) -> None:
    file = tmp_path / "built.json"
    file.write_text(built.text((OTHER, ONE, ONE.model_copy(update={"target": "gone-core"}))))
    newer = OTHER.model_copy(update={"passed": 25, "outdated": False})
    assert built.record(file, (newer,), real) == 1
    assert built.read(file) == (ONE, newer), "in the order of the matrix; what it has no more is gone"
    assert len(file.read_text().splitlines()) == 4, "a line for each"


GOOD = '{"target": "a", "date": "2026-11-22", "passed": 1}'


def with_facts(facts: str) -> str:
    return f"[{GOOD.removesuffix('}')}, {facts}}}]"


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "Expecting value"),
        ("{}x", "Extra data"),
        ("3", "built"),
        ("{}", "built"),
        ("[3]", "record 1: "),
        ("[" * 200_000, "nested too deeply"),
        ('[{"target": "a"}]', "record 1: date: "),
        ('[{"target": "a", "date": "x", "passed": 1}]', "record 1: date: "),
        (with_facts('"passed": -1'), "record 1: passed: "),
        (with_facts(f'"passed": {10**30}'), "record 1: passed: "),
        (with_facts('"compressed": -1'), "record 1: compressed: "),
        (with_facts(f'"compressed": {10**400}'), "record 1: compressed: "),
        (with_facts(f'"unpacked": {10**16}'), "record 1: unpacked: "),
        (with_facts(f'"unpacked": 1{"0" * 5000}'), "4300 digits"),
        (with_facts('"seconds": NaN'), "record 1: seconds: "),
        (with_facts('"seconds": Infinity'), "record 1: seconds: "),
        (with_facts('"seconds": -1.5'), "record 1: seconds: "),
        (with_facts(f'"seconds": {10**400}'), "record 1: "),
        (f"[{GOOD}, {GOOD.replace('22', '23')}]", "record 2: a is there twice"),
        ("\udcff", "can't decode"),
    ],
    ids=lambda value: value[:40].encode(errors="replace").decode(),
)
def test_a_damaged_file_is_told(text: str, says: str, tmp_path: Path) -> None:
    file = tmp_path / "built.json"
    file.write_text(text, encoding="utf-8", errors="surrogateescape")
    with pytest.raises(RosmlError, match="no list of what was built") as caught:
        built.read(file)
    assert says in caught.value.message
    assert caught.value.remedy == "git checkout docs/built.json"
    assert len(caught.value.message) < 400


def test_targets_that_the_matrix_does_not_have_are_read(tmp_path: Path) -> None:
    (tmp_path / "built.json").write_text(f"[{GOOD}]")
    assert [item.target for item in built.read(tmp_path / "built.json")] == ["a"]


def test_what_cannot_be_recorded_is_told() -> None:
    record = {"target": "bookworm-core", "compressed": -5, "unpacked": 9, "seconds": {}, "passed": 3, "failed": 0}
    with pytest.raises(RosmlError, match="bookworm-core: cannot be recorded: compressed: "):
        built.of_results([record], DAY)


def test_records_that_are_left_out_are_told(
    small: Catalogue, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    one, other, *gone = (
        ONE.model_copy(update={"target": name}) for name in ("alpha-core", "omega-core", "gone-core", "gone-base")
    )
    assert built.left_out((one, other), small) == ""
    single = (
        "1 record of an image that the matrix no longer has is left out (git checkout docs/built.json brings it back)"
    )
    assert built.left_out((one, gone[0]), small) == f"docs/built.json: {single}"
    several = (
        "2 records of images that the matrix no longer has are left out (git checkout docs/built.json brings them back)"
    )
    file = tmp_path / "docs/built.json"
    file.parent.mkdir()
    file.write_text(built.text((one, *gone)))
    built.record(file, (), small)
    assert capsys.readouterr().err == f"docs/built.json: {several}\n"

    file.write_text(text := built.text((one, *gone)))
    monkeypatch.setattr(generate_bake, "ROOT", tmp_path)
    monkeypatch.setattr(generate_bake, "generated", lambda *_: {file: built.text((one,))})
    matrix = ["--matrix", str(ROOT / "matrix.yaml")]
    monkeypatch.setattr("rosml.expand.load", lambda *_: small)
    assert command.run(generate_bake.main, arguments=[*matrix, "--check"]) == 1
    assert (file.read_text(), "left out" in capsys.readouterr().err) == (text, False)
    assert command.run(generate_bake.main, arguments=matrix) == 0
    told = capsys.readouterr().err
    assert f"built.json: written\ndocs/built.json: {several}\n" in told
    assert command.run(generate_bake.main, arguments=matrix) == 0
    assert "left out" not in capsys.readouterr().err


def test_results_that_failed_were_not_built() -> None:
    record: dict[str, Any] = {
        "target": "bookworm-core",
        "compressed": 5,
        "unpacked": 9,
        "seconds": {"a": 1.0, "b": 2.04},
    }
    found = built.of_results([record | {"passed": 3, "failed": 0}, record | {"passed": 3, "failed": 1}], DAY)
    assert [(item.target, item.passed, item.seconds) for item in found] == [("bookworm-core", 3, 3.0)]


def test_results_of_a_checkout_are_recorded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs/built.json").write_text(built.text((OTHER,)))
    folder = tmp_path / ".state/results/rosml"
    folder.mkdir(parents=True)
    facts = {"passed": 4, "failed": 0, "compressed": 5, "unpacked": 9, "seconds": {"build": 1.5}}
    (folder / "bookworm-core.json").write_text(json.dumps({"target": "bookworm-core", **facts}))
    monkeypatch.setattr(publish, "ROOT", tmp_path)
    done = CliRunner().invoke(publish.cli, ["results", "--record", "2026-11-22"])
    assert done.exit_code == 0, done.output
    assert "docs/built.json: 1 of 1 recorded" in done.stderr
    assert built.read(tmp_path / "docs/built.json") == (
        Built(target="bookworm-core", date=DAY, compressed=5, unpacked=9, passed=4, seconds=1.5),
        OTHER,
    )


def test_a_published_catalogue_gives_the_same(real: Catalogue) -> None:
    shelf = Shelf(real)
    shelf.night(FIRST, ["bookworm"])
    published = Gatherer(real, shelf.registry, "ghcr.io/me", PREFIX).gather(FIRST)
    found = {item.target: item for item in built.of_catalogue(published)}
    assert found.keys() == {i.target for i in real.images if i.distribution == "bookworm" and i.locked}
    platform = next(i for i in published.images if i.target == "bookworm-core").builds[0].platforms[0]
    assert found["bookworm-core"].compressed == platform.size.compressed
    assert (str(found["bookworm-core"].date), found["bookworm-core"].seconds) == ("2026-11-20", None)


def test_the_readme_tells_what_was_built(real: Catalogue) -> None:
    begin = f"{readme.BEGIN}\n{readme.END}"
    nothing, some = readme.render(begin, real), readme.render(begin, real, (ONE,))
    rows = [line for line in some.splitlines() if line not in nothing.splitlines()]
    assert len(rows) == 2, rows
    assert rows[0].startswith("| `bookworm` ") and rows[0].endswith("| 1 built, 65 not built yet |")
    assert rows[1].startswith("| `ros:<distribution>") and rows[1].endswith("| 325.1 MB (core) |")
    other = OTHER.model_copy(update={"compressed": 1_090_000_000})
    assert "| 325.1 MB (core) |" in readme.render(begin, real, (ONE, other)), "what is outdated gives no size"
    other = other.model_copy(update={"outdated": False, "target": "trixie-base"})
    assert "| 325.1 MB to 1.09 GB (core, base) |" in readme.render(begin, real, (ONE, other))
    every = [ONE.model_copy(update={"target": f"bookworm-{name}"}) for name in real.matrix.components]
    assert "| 325.1 MB to 325.1 MB |" in readme.render(begin, real, every)


def test_what_is_committed_is_of_this_matrix(real: Catalogue) -> None:
    text = (ROOT / "docs/built.json").read_text()
    assert text == built.text(built.merged(built.read(ROOT / "docs/built.json"), (), real))
    assert len(json.loads(text)) > 100
    sizes_are_outdated_where_payloads_were_larger(real)


def sizes_are_outdated_where_payloads_were_larger(real: Catalogue) -> None:
    """An image less the ROS image below it is its payloads, whose sizes hardly differ between images of one stack. The
    records of larger ones are those that say so."""
    known = {item.target: item for item in built.read(ROOT / "docs/built.json")}
    sizes: dict[tuple[str, str | None], dict[bool, list[int]]] = {}
    for item in known.values():
        image = real.by_target[item.target]
        ros = known.get(image.parent)
        if image.stack and ros and ros.compressed and item.compressed:
            by_state = sizes.setdefault((image.framework, image.stack), {False: [], True: []})
            by_state[item.outdated].append(item.compressed - ros.compressed)
    assert len(sizes) == 8
    for key, by_state in sizes.items():
        today, before = by_state[False], by_state[True]
        assert max(today) < 1.02 * min(today), key
        assert min(before) > 1.08 * max(today), key
    assert not any(item.outdated for item in known.values() if not real.by_target[item.target].stack)
