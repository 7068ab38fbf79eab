"""What was measured, and the pages that show it."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree

import pytest

from bench import results
from bench.results import Result, Row
from rosml.base.errors import RosmlError

SVG = "{http://www.w3.org/2000/svg}"

RESULT = Result(
    "waits",
    "python -m bench waits",
    ("before", "now"),
    [Row("help", (0.2, 0.1), goal="0.12 s", met=True), Row("bytes & requests", (None, 2_000_000), "B")],
    measured="2026-01-01",
    machine="2 cores",
)
PAGE = "# Page\n\n<!-- measured: waits -->\nwhat an earlier run gave\n<!-- end -->\n\nWhy.\n"


def test_a_result_stands_in_its_place() -> None:
    page, other = results.pages([PAGE, "# Other\n"], {"waits": RESULT})
    assert "| help | 0.20 s | 0.10 s | 0.12 s: met |" in page
    assert "| bytes & requests |  | 2.0 MB |  |" in page
    assert "what an earlier run gave" not in page and page.endswith("<!-- end -->\n\nWhy.\n")
    assert results.pages([page, other], {"waits": RESULT}) == [page, "# Other\n"]


@pytest.mark.parametrize("texts", [["# Page\n"], [PAGE, "<!-- measured: other -->\n<!-- end -->\n"], [PAGE, PAGE]])
def test_no_result_is_left_out(texts: list[str]) -> None:
    with pytest.raises(RosmlError, match="differ: "):
        results.pages(texts, {"waits": RESULT})


def test_bars_of_a_row_compare_its_sides() -> None:
    drawing = ElementTree.fromstring(results.plot(RESULT))
    wide = [float(bar.attrib["width"]) for bar in drawing.iter(f"{SVG}rect")]
    assert wide == [results.BARS, results.BARS / 2, results.BARS], "what a side lacks has no bar"


def test_the_pages_and_their_plots_are_current() -> None:
    """`python -m bench page` writes both."""
    measured = results.load()
    texts = [page.read_text() for page in results.PAGES]
    assert results.pages(texts, measured) == texts
    for name, result in measured.items():
        assert (results.PLOTS / f"{name}.svg").read_text() == results.plot(result)
