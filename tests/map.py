"""The test map, docs/tests.md: which file proves what, as its own first sentences say. `uv run python -m tests.map` writes
it."""

from __future__ import annotations

import ast
from pathlib import Path

from tests.proof import Proof, names

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/tests.md"

HEAD = """\
# Test map

Which file proves what, in the words of its own first lines: `uv run python -m tests.map` writes this page, and a test holds
it to them. What holds inside every image is in `tests/structure/`: a file for each part and component, which a child of an
image inherits.
"""

PROOFS = """
## Proofs

`make test` has half an hour on two cores; what takes longer runs in `make test-all`. `make test-all SHARD=1/3` runs what the
first of three machines runs, `make test-all PROOF=cuda` one proof. A proof that passes is recorded in `tests/proofs/`: the day,
the number of tests, the digest of the log, and a digest of the committed files and the images' inputs that it depends on.
`make test` fails where these changed since, or where a proof was never given, and names the command that gives it. In CI, where `CI` is set, nothing is recorded: the committed proof has to agree.

| proof | proves | minutes on two cores, about |
| --- | --- | ---: |"""

KINDS = {
    "lint": ("Linters", "`make lint`: everything that can be said of a file without running it."),
    "unit": ("Unit tests", "`make unit`: no builder, no registry but those that a test starts in its own process."),
    "e2e": (
        "End-to-end tests",
        "`make test`: real builds, a real registry, images that are entered. Tests of a proof run in `make test-all` alone.",
    ),
    "page": ("The catalogue's page", "`make page`, and `make test`: the page in a browser."),
}
"""Folders below tests/, each with its heading and what runs it. No other has tests."""


def render() -> str:
    """The page."""
    parts = [HEAD]
    for folder, (heading, how) in KINDS.items():
        rows = [f"| `{file.name}` | {proves(file)} |" for file in sorted((ROOT / "tests" / folder).glob("test_*.py"))]
        parts += [f"\n## {heading}\n\n{how}\n\n| file | proves |\n| --- | --- |", *rows]
    parts.append(PROOFS)
    proofs = [Proof.load(name) for name in names()]
    parts += [f"| `{proof.name}` | {proof.proves} | {proof.minutes:g} |" for proof in proofs]
    return "\n".join(parts) + "\n"


def proves(file: Path) -> str:
    """The first paragraph of a test file, in a line.

    Raises:
        ValueError: it has none.
    """
    words = ast.get_docstring(ast.parse(file.read_text(encoding="utf-8")))
    if not words:
        raise ValueError(f"{file.name} does not say what it proves: begin it with a docstring")
    return " ".join(words.split("\n\n")[0].split()).replace("|", "\\|").replace("``", "`")


if __name__ == "__main__":
    PAGE.write_text(render(), encoding="utf-8")
