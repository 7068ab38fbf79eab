"""A dossier's page in a browser: it runs nothing of what strangers wrote, asks nobody, fits each screen and can be printed."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from fakes.dossiers import HOSTILE, Shop, shop, vex
from rosml.images.dossier import write
from rosml.images.scan.vex import MEDIA_TYPE as VEX_TYPE
from tests.page.conftest import MIDDLE, NARROW, WIDE, Windows, expect, tree

HEADINGS = [
    "What is missing",
    "End of support",
    "Vulnerabilities",
    "Statements about vulnerabilities (VEX)",
    "Completeness of the SBOM",
    "Licences",
    "Where it comes from",
    "How to make it again",
    "Components",
    "Files of this dossier",
]


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Shop]:
    with shop(tmp_path_factory.mktemp("shop")) as opened:
        yield opened


@pytest.fixture(scope="module")
def dossier(place: Shop, tmp_path_factory: pytest.TempPathFactory) -> Path:
    reference = place.base()
    statement = {
        "vulnerability": {"name": "CVE-2026-1"},
        "status": "not_affected",
        "impact_statement": HOSTILE,
        "products": [{"subcomponents": [{"@id": "pkg:deb/debian/bash@5.2.15-2"}]}],
    }
    place.attach(*place.only(reference), VEX_TYPE, vex(statement))
    folder = tmp_path_factory.mktemp("page") / "a dossier, übersicht"
    write.write(place.dossier(reference), folder)
    return folder


@pytest.fixture
def windows(browser: Any, dossier: Path) -> Iterator[Windows]:
    opened = Windows(browser, dossier)
    yield opened
    opened.close()


def page_of(windows: Windows, viewport: dict[str, int], scheme: str = "light") -> Any:
    page = windows(viewport, scheme).page
    page.goto((windows.folder / "index.html").as_uri())
    return page


def test_it_reads_well(windows: Windows) -> None:
    page = page_of(windows, WIDE)
    assert page.title() == "Dossier of ros1-bookworm-core"
    assert page.locator("h2").all_inner_texts() == HEADINGS
    first = page.locator("section", has_text="End of support").locator("tbody tr").first
    expect(first).to_contain_text("CUDA 12.8.90")
    expect(first).to_contain_text("2026-02-28 (ended)")
    components = page.locator("section", has=page.locator("h2", has_text="Components"))
    row = components.locator("tr", has_text="bash 5.2.15-2")
    expect(row).not_to_be_visible()
    components.locator("summary").click()
    expect(row).to_contain_text("GPL-3.0-or-later")


def test_what_strangers_wrote_is_text(windows: Windows) -> None:
    page = page_of(windows, WIDE)
    statements = page.locator("section", has=page.locator("h2", has_text="VEX"))
    expect(statements).to_contain_text('<img src=x onerror="document.title=1">')
    assert page.locator("img, script, iframe, a").count() == 0
    assert page.title() == "Dossier of ros1-bookworm-core"


@pytest.mark.parametrize("viewport", [WIDE, MIDDLE, NARROW])
def test_it_fits_each_screen(windows: Windows, viewport: dict[str, int]) -> None:
    page = page_of(windows, viewport)
    assert page.evaluate("document.documentElement.scrollWidth") <= viewport["width"]


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_everybody_can_use_it(windows: Windows, scheme: str) -> None:
    axe = pytest.importorskip("axe_playwright_python.sync_playwright", reason="uv run --group page pytest tests/page")
    page = page_of(windows, WIDE, scheme)
    for summary in page.locator("summary").all():
        summary.click()
    response = axe.Axe().run(page, options={"preload": False}).response
    assert [(item["id"], item["nodes"][0]["html"][:200]) for item in response["violations"]] == []
    headings = [name for role, name in tree(page) if role == "heading"]
    assert headings == ["Dossier of ros1-bookworm-core", *HEADINGS]


def test_it_can_be_printed(windows: Windows, tmp_path: Path) -> None:
    page = page_of(windows, WIDE, "dark")
    page.emulate_media(media="print")
    colour = page.evaluate("getComputedStyle(document.body).color")
    assert colour == "rgb(0, 0, 0)"
    data = page.pdf(path=tmp_path / "dossier.pdf", format="A4")
    assert data.startswith(b"%PDF-") and data.count(b"/Type /Page\n") < 20
