"""The feed is valid Atom, and says what runs published and changed."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from datetime import datetime
from html.parser import HTMLParser
from pathlib import Path

import pytest

from fakes.memory_registry import PREFIX
from fakes.shelf import FIRST, SECOND, THIRD, Shelf, shown
from rosml.images.catalogue import feed, site
from rosml.images.catalogue.model import Move, Published
from rosml.images.catalogue.read import Gatherer
from rosml.images.image_set.model import ImageSet
from rosml.registry.place import Place

NOW = "2026-11-22T06:00:00Z"
TORCH = "ros1-bookworm-base-torch-cu128"
NAMES = {"": feed.ATOM}

ONCE = {"id", "title", "updated", "subtitle", "content"}
REQUIRED = {"id", "title", "updated"}
ALLOWED = {"feed": {*REQUIRED, "subtitle", "link", "author", "entry"}, "entry": {*REQUIRED, "link", "content"}}


@pytest.fixture(scope="module")
def catalogue(real: ImageSet) -> Published:
    return gather(shown(real))


def gather(shelf: Shelf) -> Published:
    return Gatherer(shelf.image_set, Place(shelf.registry, PREFIX)).gather(NOW)


def parsed(published: Published) -> ET.Element:
    """The feed, which has to be valid by RFC 4287: what must be there is, once, and in its form."""
    text = feed.render(published)
    root = ET.fromstring(text.encode())
    assert text.startswith('<?xml version="1.0" encoding="utf-8"?>\n') and root.tag == f"{{{feed.ATOM}}}feed"
    assert root.findtext("author/name", namespaces=NAMES)
    for element in (root, *root.findall("entry", NAMES)):
        children = [child.tag.removeprefix(f"{{{feed.ATOM}}}") for child in element]
        kind = element.tag.removeprefix(f"{{{feed.ATOM}}}")
        assert set(children) >= REQUIRED and set(children) <= ALLOWED[kind]
        assert all(children.count(name) <= 1 for name in ONCE)
        assert element.findtext("title", namespaces=NAMES)
        assert re.fullmatch(r"urn:uuid:[0-9a-f-]{36}", element.findtext("id", "", NAMES))
        assert datetime.fromisoformat(element.findtext("updated", "", NAMES)).tzinfo
        links = [(link.get("rel"), link.get("type")) for link in element.findall("link", NAMES)]
        assert all(link.get("href") for link in element.findall("link", NAMES))
        assert len(set(links)) == len(links), "not two alternates of a type"
        for content in element.findall("content", NAMES):
            assert content.get("type") == "html" and len(content) == 0
            Markup().feed(content.text or "")
    ids = [element.text for element in root.iter(f"{{{feed.ATOM}}}id")]
    assert len(set(ids)) == len(ids)
    return root


class Markup(HTMLParser):
    """The HTML of an entry: a list, links and text."""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert tag in {"ul", "li", "a", "p"}
        assert all(name == "href" and str(value).startswith("index.html#/image/") for name, value in attrs)


def entries(root: ET.Element) -> list[tuple[str, str, str]]:
    """Date, title and content of each."""
    read = ("updated", "title", "content")
    return [tuple(entry.findtext(name, "", NAMES) for name in read) for entry in root.findall("entry", NAMES)]  # type: ignore[misc]


def line(content: str, target: str) -> str:
    return next(item.partition("</a>: ")[2] for item in content.split("</li>") if f"/image/{target}" in item)


def test_a_run_is_an_entry_and_says_what_changed(catalogue: Published) -> None:
    root = parsed(catalogue)
    assert root.findtext("updated", namespaces=NAMES) == THIRD
    third, second, first = entries(root)
    assert [third[0], second[0], first[0]] == [THIRD, SECOND, FIRST]
    assert third[1] == "2026-11-22: 81 images published"
    assert first[1] == "2026-11-20: 196 images published, all for the first time"
    assert line(third[2], TORCH) == "torch-cu128-py311 changed; numpy 1.26.4 → 1.26.5"
    assert line(second[2], "ros1-bookworm-core") == "ros1-bookworm-core changed"
    assert line(first[2], "ros1-bookworm-core") == "new"
    assert first[2].count("<li>") == 100 and first[2].endswith("<p>and 96 other images</p>")


def test_no_run_no_entry(tmp_path: Path, real: ImageSet) -> None:
    catalogue = gather(Shelf(real))
    root = parsed(catalogue)
    assert entries(root) == [] and root.findtext("updated", namespaces=NAMES) == NOW
    site.write(tmp_path, catalogue)
    page = (tmp_path / "index.html").read_text()
    assert '<link rel="alternate" type="application/atom+xml"' in page and 'href="feed.xml" />' in page
    assert (tmp_path / "feed.xml").read_text() == feed.render(catalogue)


def test_only_the_newest_runs_are_there(catalogue: Published) -> None:
    image = next(item for item in catalogue.images if item.target == TORCH)
    moves = tuple(Move(run=f"2026-11-{day:02}T03:00:00Z", previous="x", new="y") for day in range(25, 0, -1))
    changed = image.model_copy(update={"moves": moves})
    dates = [date for date, _, _ in entries(parsed(catalogue.model_copy(update={"images": (changed,)})))]
    assert dates == [move.run for move in moves[:20]]


def test_what_was_moved_back_is_told(catalogue: Published) -> None:
    image = next(item for item in catalogue.images if item.target == TORCH)
    main, *others = image.tags
    back = image.model_copy(update={"tags": (main.model_copy(update={"digest": image.moves[0].previous}), *others)})
    removed = image.model_copy(update={"tags": tuple(others)})
    for changed, change in ((back, "moved back since"), (removed, "removed since")):
        third, second, *_ = entries(parsed(catalogue.model_copy(update={"images": (changed,)})))
        assert line(third[2], TORCH).endswith(f"; its tag was {change}") and "since" not in second[2]


def test_what_a_registry_says_is_text(catalogue: Published) -> None:
    image = next(item for item in catalogue.images if item.target == TORCH)
    (platform,) = image.builds[0].platforms
    odd = platform.model_copy(update={"versions": {"<script>": "\x00\x1b]&amp;" + "x" * 300}})
    build = image.builds[0].model_copy(update={"platforms": (odd,)})
    strange = Move(run="<b>2026", previous="", new="x")
    changed = image.model_copy(update={"builds": (build, *image.builds[1:]), "moves": (*image.moves, strange)})
    root = parsed(catalogue.model_copy(update={"images": (changed,)}))
    third, *rest = entries(root)
    assert len(rest) == 2
    change = line(third[2], TORCH)
    assert "&lt;script&gt; none → \ufffd\ufffd]&amp;amp;x" in change and "x" * 75 not in change
    assert "more versions" in change, "those that are gone"
