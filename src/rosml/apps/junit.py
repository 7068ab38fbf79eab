"""What JUnit files say of tests."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

SHOWN = 160
"""Characters of what a failed test said."""


@dataclass(frozen=True)
class Tests:
    """Tests that ran. `failures` names those that failed, with what they said in a line."""

    count: int = 0
    skipped: int = 0
    failures: tuple[str, ...] = ()


def add(one: Tests, other: Tests) -> Tests:
    """Both together."""
    return Tests(one.count + other.count, one.skipped + other.skipped, one.failures + other.failures)


def read(folder: Path) -> Tests:
    """All JUnit files below a folder, which has one for each package, and its file `failed`: what is no test's own failure,
    such as tests that do not build or a program that ended without a report."""
    found = Tests()
    for path in sorted(folder.rglob("*.xml")):
        found = add(found, _file(path, path.relative_to(folder).parts[0]))
    failed = folder / "failed"
    if failed.exists() and not found.failures:
        lines = failed.read_text(errors="replace").split("\n")
        found = add(found, Tests(failures=tuple(line for line in lines if line.strip())))
    return found


def _file(path: Path, package: str) -> Tests:
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError:
        return Tests(1, 0, (f"{package}: {path.name} is no XML: its program was ended",))
    count = skipped = 0
    failures = []
    for case in _cases(root):
        count += 1
        skipped += case.find("skipped") is not None
        wrong = next((found for kind in ("failure", "error") if (found := case.find(kind)) is not None), None)
        if wrong is not None:
            said = " ".join((wrong.get("message") or wrong.text or "").split())[:SHOWN]
            name = ".".join(filter(None, (case.get("classname"), case.get("name"))))
            failures.append(f"{package}: {name}: {said}".rstrip(": "))
    return Tests(count, skipped, tuple(failures))


def _cases(root: ElementTree.Element) -> Iterator[ElementTree.Element]:
    yield from root.iter("testcase")
