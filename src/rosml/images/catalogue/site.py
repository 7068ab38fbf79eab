"""Writes the catalogue: catalogue.json for programs, and a page for people that needs no server.

The page's own files are copied from the folder `page`. Its data is a script beside them: from a file, a browser lets a page load a
script, but no JSON.
"""

from __future__ import annotations

import json
from pathlib import Path

from rosml.base import files
from rosml.images.catalogue.model import Published

SOURCES = Path(__file__).parent / "page"


def text(published: Published) -> str:
    """catalogue.json: the same text for the same facts. Parts and layers keep their order."""
    return json.dumps(published.model_dump(), separators=(",", ":"), ensure_ascii=False) + "\n"


def script(content: str) -> str:
    """catalogue.json as a script. Browsers read a parsed text several times faster than an object literal."""
    return f"window.catalogue = JSON.parse({json.dumps(content.rstrip())});\n"


def write(folder: Path, published: Published) -> list[Path]:
    """Writes catalogue.json and the page into a folder, all or nothing. Returns the files.

    Raises:
        RosmlError: a file cannot be written.
    """
    content = text(published)
    wanted = {"catalogue.json": content, "data.js": script(content)}
    for source in sorted(SOURCES.iterdir()):
        wanted[source.name] = source.read_text(encoding="utf-8")
    folder.mkdir(parents=True, exist_ok=True)
    files.write_all({folder / name: data for name, data in wanted.items()}, within=folder)
    return [folder / name for name in wanted]
