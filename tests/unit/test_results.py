"""Records of published images, and their tables."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from rosml import results
from rosml.errors import RosmlError
from rosml.expand import Catalogue


def record(state: Path, target: str, namespace: str = "rosml", **changes: object) -> None:
    facts = {
        "target": target,
        "compressed": 712_000_000,
        "unpacked": 2_568_000_000,
        "passed": 21,
        "failed": 0,
        "seconds": {"build and push": 60.0, "structure tests": 15.2},
    }
    folder = results.folder(state, namespace)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{target}.json").write_text(json.dumps({**facts, **changes}))


def test_records_are_in_the_order_of_the_matrix(tmp_path: Path, small: Catalogue) -> None:
    for target in ("omega-core", "alpha-base", "alpha-core", "long-gone"):
        record(tmp_path, target)
    record(tmp_path, "alpha-desktop", namespace="try")
    found = results.read(tmp_path, "rosml", small)
    assert [item["target"] for item in found] == ["alpha-core", "alpha-base", "omega-core"]
    assert results.read(tmp_path, "nothing", small) == []


def test_markdown(tmp_path: Path, small: Catalogue) -> None:
    record(tmp_path, "alpha-core")
    assert results.markdown(results.read(tmp_path, "rosml", small)) == (
        "| image | compressed | unpacked | tests passed | wall time |\n"
        "| --- | ---: | ---: | ---: | ---: |\n"
        "| `alpha-core` | 712.0 MB | 2.57 GB | 21 of 21 | 1 min 15 s |\n"
    )


def test_table(tmp_path: Path, small: Catalogue, capsys: pytest.CaptureFixture[str]) -> None:
    record(tmp_path, "alpha-core")
    record(tmp_path, "alpha-base", passed=20, failed=1)
    results.print_table(results.read(tmp_path, "rosml", small))
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == ["image", "alpha-core", "alpha-base", "2"]
    assert "20 of 21" in lines[2]
    assert lines[-1] == "2 images, 2 min 30 s in all"


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        '{"target": "alpha-core"}',
        '{"target": "alpha-core", "seconds": [], "passed": 1, "failed": 0, "compressed": 1, "unpacked": 1}',
        '{"target": "alpha-core", "seconds": {}, "passed": 1, "failed": 0, "compressed": null, "unpacked": 1}',
        "[" * 100_000,
    ],
)
def test_a_damaged_record(tmp_path: Path, small: Catalogue, text: str) -> None:
    record(tmp_path, "alpha-core")
    (results.folder(tmp_path, "rosml") / "alpha-core.json").write_text(text)
    with pytest.raises(RosmlError, match=r"alpha-core\.json: no record") as caught:
        results.read(tmp_path, "rosml", small)
    assert "publish that image again" in caught.value.remedy
