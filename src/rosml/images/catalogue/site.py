"""Writes the catalogue: catalogue.json for programs, feed.xml for readers of feeds, and a page for people that needs no server.

The page's own files are copied from the folder `page`. Its data is a script beside them: from a file, a browser lets a page load a
script, but no JSON.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from rosml.base import files
from rosml.images.catalogue import feed
from rosml.images.catalogue.model import Published
from rosml.images.catalogue.packages import Package

SOURCES = Path(__file__).parent / "page"


def text(published: Published) -> str:
    """catalogue.json: the same text for the same facts. Parts and layers keep their order."""
    return json.dumps(published.model_dump(), separators=(",", ":"), ensure_ascii=False) + "\n"


def script(content: str) -> str:
    """catalogue.json as a script. Browsers read a parsed text several times faster than an object literal."""
    return f"window.catalogue = JSON.parse({json.dumps(content.rstrip())});\n"


PACKAGES = "packages"
"""The folder of scripts with the packages of an SBOM each, which the page loads when somebody asks for them."""


def write(folder: Path, published: Published, packages: Mapping[str, Sequence[Package]] | None = None) -> list[Path]:
    """Writes catalogue.json, the feed and the page into a folder, all or nothing. Returns the files. `packages` are
    those in SBOMs, by the digests of these."""
    content = text(published)
    by_name = {digest.removeprefix("sha256:"): items for digest, items in (packages or {}).items()}
    contents = {
        "catalogue.json": content,
        "feed.xml": feed.render(published),
        "data.js": f"{script(content)}window.packaged = {json.dumps(sorted(by_name))};\n",
    }
    for source in sorted(SOURCES.iterdir()):
        contents[source.name] = source.read_text(encoding="utf-8")
    for name, items in by_name.items():
        data = json.dumps(json.dumps(items, separators=(",", ":")))
        contents[f"{PACKAGES}/{name}.js"] = f'window.rosml.packagesRead("{name}", JSON.parse({data}));\n'
    folder.mkdir(parents=True, exist_ok=True)
    if by_name:
        (folder / PACKAGES).mkdir(exist_ok=True)
    files.write_all({folder / name: data for name, data in contents.items()}, within=folder)
    scripts = () if (folder / PACKAGES).is_symlink() else (folder / PACKAGES).glob("*.js")
    for file in scripts:  # of builds that are gone
        if re.fullmatch(r"[0-9a-f]{64}", file.stem) and file.stem not in by_name:
            file.unlink()
    return [folder / name for name in contents]
