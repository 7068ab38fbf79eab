"""The catalogue's page in a browser: Chromium as the machine has it, driven by Playwright.

Whatever a test does, the page must stay within its folder and have nothing to complain about: that is checked after each.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from fakes.shelf import FIRST, Shelf, shown
from rosml import ROOT
from rosml.images.catalogue import packages, site
from rosml.images.catalogue.model import Published
from rosml.images.catalogue.read import Gatherer
from rosml.images.image_set import load
from rosml.images.matrix import source
from rosml.machine.setup.tools import BROWSERS
from rosml.registry.place import Place
from tests import synthetic

NOW = "2026-11-22T06:00:00Z"
REGISTRY = "ghcr.io/me/rosml"
WIDE = {"width": 1280, "height": 900}
MIDDLE = {"width": 768, "height": 900}
NARROW = {"width": 360, "height": 740}


def program() -> str:
    """The browser."""
    path = next((path for name in BROWSERS if (path := shutil.which(name))), None)
    return path or pytest.skip(f"no browser is there ({', '.join(BROWSERS)}): python3 scripts/bootstrap.py browser")


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    path = program()
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="Playwright is not there: uv run --group page pytest tests/page"
    )
    with playwright.sync_playwright() as drivers:
        options = ["--no-sandbox"] if os.geteuid() == 0 else []
        running = drivers.chromium.launch(executable_path=path, args=options)
        yield running
        running.close()


def expect(what: Any) -> Any:
    """Playwright's assertions, which wait. A condition in JavaScript may not be waited for: the page forbids `eval`, and
    Playwright calls it in the page as soon as the condition does not hold at once."""
    return pytest.importorskip("playwright.sync_api").expect(what)


def tree(page: Any) -> list[tuple[str, str]]:
    """Roles and names in the tree that Chromium hands to a screen reader, in its order."""
    nodes = page.context.new_cdp_session(page).send("Accessibility.getFullAXTree")["nodes"]
    return [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in nodes if not node["ignored"]]


def gather(shelf: Shelf) -> Published:
    return Gatherer(shelf.image_set, Place(shelf.registry, "rosml")).gather(NOW)


@pytest.fixture(scope="session")
def nights() -> Shelf:
    """Three nights of bookworm and trixie."""
    return shown(load.load(ROOT / "matrix.yaml", ROOT))


@pytest.fixture(scope="session")
def published(nights: Shelf) -> Published:
    """These nights, and all that our matrix describes beside them."""
    return gather(nights)


@pytest.fixture(scope="session")
def folder(nights: Shelf, published: Published, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page in a folder whose name is one that addresses have to spell in another way."""
    path = tmp_path_factory.mktemp("page") / "a catalogue, übersicht"
    site.write(path, published, packages.read(Place(nights.registry, "rosml"), published)[0])
    return path


@pytest.fixture(scope="session")
def thousand(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same of a matrix with more than 1,000 images, each with two platforms."""
    image_set = load.image_set(source.parse(synthetic.matrix(1000).encode()))
    shelf = Shelf(image_set)
    shelf.night(FIRST, image_set.matrix.distributions)
    path = tmp_path_factory.mktemp("page") / "thousand"
    site.write(path, gather(shelf))
    return path


@dataclass
class Window:
    """A window of the browser, its complaints in the console, and the addresses that it asked for."""

    page: Any
    folder: Path
    complaints: list[str] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)

    def open(self, route: str = "#/", base: str = "") -> Any:
        """Opens a view; gives the page."""
        self.page.goto((base or (self.folder / "index.html").as_uri()) + route)
        self.page.wait_for_function("document.documentElement.dataset.ready")
        return self.page

    def outside(self, base: str = "") -> list[str]:
        """Requests of something that is not in the page's folder."""
        allowed = (base or self.folder.as_uri(), "data:")
        return [address for address in self.requests if not address.startswith(allowed)]


@dataclass
class Windows:
    """Opens windows, and looks after what happens in them."""

    browser: Any
    folder: Path
    opened: list[tuple[Any, Window]] = field(default_factory=list)

    def __call__(self, viewport: dict[str, int] | None = None, scheme: str = "light", **options: Any) -> Window:
        """A window of a size and with a colour scheme."""
        context = self.browser.new_context(viewport=viewport or WIDE, color_scheme=scheme, **options)
        context.grant_permissions(["clipboard-read", "clipboard-write"])
        window = Window(context.new_page(), self.folder)
        window.page.set_default_timeout(10_000)
        window.page.on("console", lambda message: window.complaints.append(f"{message.type}: {message.text}"))
        window.page.on("pageerror", lambda error: window.complaints.append(str(error)))
        window.page.on("request", lambda request: window.requests.append(request.url))
        self.opened.append((context, window))
        return window

    def close(self) -> None:
        for context, opened in self.opened:
            context.close()
            assert opened.complaints == []
            if not any(address.startswith("http://127.0.0.1") for address in opened.requests):
                assert opened.outside() == []
                assert opened.requests


@pytest.fixture
def window(browser: Any, folder: Path) -> Iterator[Windows]:
    windows = Windows(browser, folder)
    yield windows
    windows.close()


PageOf = Callable[..., Windows]


@pytest.fixture
def page_of(browser: Any, tmp_path: Path) -> Iterator[PageOf]:
    """Writes the page of a catalogue, and opens windows of it."""
    opened: list[Windows] = []

    def write(published: Published, *sboms: Any) -> Windows:
        site.write(tmp_path / "page", published, *sboms)
        opened.append(Windows(browser, tmp_path / "page"))
        return opened[-1]

    yield write
    for windows in opened:
        windows.close()
