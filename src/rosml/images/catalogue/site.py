"""Writes the catalogue: catalogue.json for programs, and a page for people that needs no server.

The page's own files are in the folder `page` and are copied as they are. Its data is a script beside them: a browser that opens
a file lets a page load a script, and no JSON.
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
    """The same as a script. A text that is parsed is read several times faster than an object that is written out."""
    return f"window.catalogue = JSON.parse({json.dumps(content.rstrip())});\n"


def write(folder: Path, published: Published) -> list[Path]:
    """Writes catalogue.json and the page into a folder, all or nothing; gives its files.

    Raises:
        RosmlError: it cannot be written.
    """
    content = text(published)
    wanted = {"catalogue.json": content, "data.js": script(content)}
    for source in sorted(SOURCES.iterdir()):
        wanted[source.name] = source.read_text(encoding="utf-8")
    folder.mkdir(parents=True, exist_ok=True)
    files.write_all({folder / name: data for name, data in wanted.items()}, within=folder)
    return [folder / name for name in wanted]
