"""Pages of the documentation, their fenced blocks, and the commands in them: for tests that do what a page says."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SHELLS = ("sh", "bash", "shell", "console")


@dataclass(frozen=True)
class Block:
    """A fenced block of a page."""

    page: str
    section: str
    language: str
    title: str
    text: str


def pages() -> list[Path]:
    """Every page of the documentation."""
    return [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").rglob("*.md"))]


_FENCE = re.compile(r'^(?P<indent> *)```(?P<language>[\w+-]*)(?: title="(?P<title>[^"]*)")? *$')


def blocks(page: Path) -> Iterator[Block]:
    """The fenced blocks of a page, each with the heading that it stands under.

    Raises:
        ValueError: a block does not end.
    """
    lines, section, opening, text = page.read_text(encoding="utf-8").split("\n"), "", None, list[str]()
    name = str(page.relative_to(ROOT))
    for line in lines:
        fence = _FENCE.match(line)
        if opening is None:
            if line.startswith("#"):
                section = line.lstrip("# ")
            if line.lstrip().startswith("```") and not fence:
                raise ValueError(f"{name}: a fence that is not understood: {line!r}")
            opening, text = fence, []
        elif fence and not fence["language"]:
            yield Block(name, section, opening["language"], opening["title"] or "", "\n".join(text) + "\n")
            opening = None
        else:
            text.append(line.removeprefix(opening["indent"]))
    if opening:
        raise ValueError(f"{name}: a fenced block under {section!r} does not end")


def commands(block: Block) -> Iterator[str]:
    """The commands of a block of shell, one a line, without comments; a line that ends with a backslash goes on."""
    for line in block.text.replace("\\\n", " ").splitlines():
        words = re.sub(r"(^|\s)#\s.*$", "", line.removeprefix("$ ")).strip()
        if words:
            yield " ".join(words.split())
