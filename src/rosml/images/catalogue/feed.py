"""Writes feed.xml: an Atom feed (RFC 4287) with an entry for each run that moved tags, and what changed in each image.

Addresses are relative to the feed, since a catalogue does not know where it is served.
"""

from __future__ import annotations

import html
import re
import uuid
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence

from rosml.base.clock import is_date
from rosml.base.problems import counted, listed
from rosml.images.catalogue.model import Build, Image, Layer, Move, Platform, Published

ATOM = "http://www.w3.org/2005/Atom"

RUNS = 20
"""The most entries: the newest runs."""

IMAGES = 100
"""The most images that an entry describes; it counts the others."""

VERSIONS = 8
"""The most versions that an image has in the feed."""

LONGEST = 80
"""The most characters of a version."""

NO_TEXT = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML cannot have."""

Moved = tuple[Image, Move]


def render(published: Published) -> str:
    """The feed."""
    runs: dict[str, list[Moved]] = {}
    for image in published.images:
        for move in image.moves:
            if is_date(move.run):  # the record of another run has a name that somebody chose
                runs.setdefault(move.run, []).append((image, move))
    newest = sorted(runs, reverse=True)[:RUNS]
    feed = ET.Element("feed", xmlns=ATOM)
    _add(feed, "title", f"ROS images in {published.registry}")
    _add(feed, "subtitle", "What was published, and what changed")
    _add(feed, "id", _id(published.registry))
    _add(feed, "updated", newest[0] if newest else published.created)
    _add(feed, "link", rel="self", type="application/atom+xml", href="feed.xml")
    _add(feed, "link", rel="alternate", type="text/html", href="index.html")
    _add(_add(feed, "author"), "name", "rosml")
    for run in newest:
        entry = _add(feed, "entry")
        _add(entry, "title", _title(run, runs[run]))
        _add(entry, "id", _id(f"{published.registry} {run}"))
        _add(entry, "updated", run)
        _add(entry, "link", rel="alternate", type="text/html", href="index.html")
        _add(entry, "content", _content(runs[run], published.layers), type="html")
    ET.indent(feed)
    return f'<?xml version="1.0" encoding="utf-8"?>\n{ET.tostring(feed, encoding="unicode")}\n'


def _add(parent: ET.Element, name: str, text: str = "", **attributes: str) -> ET.Element:
    element = ET.SubElement(parent, name, attributes)
    element.text = NO_TEXT.sub("\ufffd", text) or None
    return element


def _id(name: str) -> str:
    """An address that stays the same: readers of feeds know by it what they have shown."""
    return uuid.uuid5(uuid.NAMESPACE_URL, name).urn


def _title(run: str, moved: Sequence[Moved]) -> str:
    new = sum(not move.previous for _, move in moved)
    first = "" if not new else ", all for the first time" if new == len(moved) else f", {new} for the first time"
    return f"{run[:10]}: {counted(len(moved), 'image')} published{first}"


def _content(moved: Sequence[Moved], layers: Sequence[Layer]) -> str:
    lines = [
        f'<li><a href="index.html#/image/{html.escape(image.target)}">{html.escape(image.target)}</a>: '
        f"{html.escape(_change(image, move, layers))}</li>"
        for image, move in moved[:IMAGES]
    ]
    rest = len(moved) - IMAGES
    return f"<ul>{''.join(lines)}</ul>" + (f"<p>and {counted(rest, 'other image')}</p>" if rest > 0 else "")


def _change(image: Image, move: Move, layers: Sequence[Layer]) -> str:
    """What a run changed in an image, in words."""
    builds = {build.digest: build for build in image.builds}
    before, after = builds.get(move.previous), builds.get(move.new)
    if not move.previous:
        changes = ["new"]
    elif before is None or after is None:
        changes = ["changed"]
    else:
        changes = list(_differences(before, after, layers)) or ["only the configuration changed"]
    present = next((tag.digest for tag in image.tags if tag.kind == "main"), "")
    if move is image.moves[0] and present != move.new:  # `rosml publish undo` or a person moved the tag
        changes.append("its tag was moved back since" if present else "its tag was removed since")
    return "; ".join(changes)


def _differences(before: Build, after: Build, layers: Sequence[Layer]) -> Iterator[str]:
    """What differs between two builds, over all platforms."""
    earlier = {platform.platform: platform for platform in before.platforms}
    later = {platform.platform: platform for platform in after.platforms}
    if added := later.keys() - earlier.keys():
        yield f"now for {listed(sorted(added))} as well"
    if lost := earlier.keys() - later.keys():
        yield f"no longer for {listed(sorted(lost))}"
    both = [(earlier[name], later[name]) for name in later if name in earlier]
    if parts := dict.fromkeys(part for pair in both for part in _changed_parts(*pair, layers)):
        yield f"{listed([part or 'other layers' for part in parts])} changed"
    versions = list(dict.fromkeys(text for pair in both for text in _changed_versions(*pair)))
    yield from versions[:VERSIONS]
    if len(versions) > VERSIONS:
        yield f"{len(versions) - VERSIONS} more versions"


def _changed_parts(before: Platform, after: Platform, layers: Sequence[Layer]) -> Iterator[str]:
    for position in (*after.layers, *before.layers):
        if (position in before.layers) != (position in after.layers):
            yield layers[position].part


def _changed_versions(before: Platform, after: Platform) -> Iterator[str]:
    if before.found_inside != after.found_inside:  # labels name less than was found inside
        return
    for name in sorted(before.versions.keys() | after.versions.keys()):
        earlier, later = (platform.versions.get(name, "none") for platform in (before, after))
        if earlier != later:
            yield f"{name[:LONGEST]} {earlier[:LONGEST]} → {later[:LONGEST]}"
