"""The page with charts that `make bench` writes."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from bench import report
from bench.idle_run import IdleRun
from bench.many_tags import Grown, Growth
from bench.scan import Scan
from bench.second_image import Comparison, Side
from rosml.base.errors import RosmlError

LIMITS = {"real": 0.5, "largest": 3.0}
GENERATOR: dict[str, Any] = {
    "machine": {"architecture": "x86_64", "processors": 2, "system": "Linux", "load": 0.3},
    "real_seconds": 0.41,
    "sizes": [{"images": 1_000, "seconds": 0.12}, {"images": 10_000, "seconds": 1.2}],
    "growth": 1.0,
}
COMPARED = Comparison(
    target="ros1-bookworm-base-torch-cu128",
    ours=Side(2.0, 3_000, 0, 1.5, 60.0, 0.0, 1_200_000_000, 0.05, 0.012),
    usual=Side(90.0, 1_500_000_000, 1_500_000_100, 1.6, 95.0, 70.0, 1_600_000_000, 4.0, 0.012),
    versions={"torch": "2.10.0"},
    packages=40,
    assembling_seconds=0.0,
)
GROWN = Grown(
    (Growth(10, 2.5, 70_000, 900.0, 15_000_000_000), Growth(20, 5.0, 140_000, 1_800.0, 30_000_000_000)),
    IdleRun(843, 2967, 6.5, 0, 0),
    Scan(1300, 250, 160, 0.5, 0.25, 400_000, 20_000),
)
WHOLE = {**GENERATOR, "comparison": COMPARED.to_json(), "growth_of_tags": GROWN.to_json()}


def test_the_whole_report(tmp_path: Path) -> None:
    """Every picture that the page shows is there, and every number that it shows was measured."""
    page = report.write(WHOLE, tmp_path / "a/b", LIMITS)
    text = page.read_text()
    for name in ("comparison", "growth", "generator"):
        assert f"]({name}.svg)" in text
        assert ElementTree.parse(page.parent / f"{name}.svg").getroot().tag.endswith("svg")
    assert "2 processors (Linux, x86_64), load 0.3 at the start" in text
    assert "| second image: build and push | 2.0 s | 1 min 30 s | 45 x |" in text
    assert "| to pull after a change of ROS | 0 B | 1.50 GB |  |" in text
    assert "Our entrypoint takes 12 ms" in text
    assert "| 20 | 5.0 s | 140.0 kB | 30 min 0 s | 30.00 GB |" in text
    assert "A second run over the whole matrix, nothing changed: 843 images" in text
    assert "A scan of the whole matrix: 1300 images on their architectures, 2 min 45 s, 103.2 MB read" in text
    assert "2967 tags, 6.5 s, 0 B uploaded, 0 steps done" in text
    assert "| 10000 images | 1.20 | 3.00 | 120 |" in text
    assert json.loads((page.parent / "report.json").read_text()) == WHOLE


def test_the_generator_alone(tmp_path: Path) -> None:
    page = report.write(GENERATOR, tmp_path, LIMITS)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["generator.svg", "report.json", "report.md"]
    assert "the usual way" not in page.read_text()


def test_a_folder_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(RosmlError, match="cannot write") as caught:
        report.write(GENERATOR, tmp_path / "file", LIMITS)
    assert "--output" in str(caught.value.remedy)


def test_without_matplotlib(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(RosmlError, match="matplotlib") as caught:
        report.write(GENERATOR, tmp_path, LIMITS)
    assert "make bench" in str(caught.value.remedy)
