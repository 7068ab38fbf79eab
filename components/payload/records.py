#!/usr/bin/env python3
"""Keeps a payload and the wheels' own records of their files (RECORD) in agreement.

  records.py prune    removes what no use of an image needs: files whose path matches a line of the part's prune.txt
  records.py verify   every recorded file is there, byte for byte as in the wheel, but for those that match a line of
                      the part's adapted.txt, whose records follow what we ship; anything else fails

Patterns are those of the shell, below the folder of the packages; `*` matches slashes as well. Lines that begin with #
say why. uv has checked the wheels themselves against the lock's hashes before; this is about what became of them.
"""

from __future__ import annotations

import base64
import csv
import fnmatch
import hashlib
import os
import sys
from pathlib import Path

OUT = Path(os.environ["OUT"])
SITE = OUT / os.environ["SITE"].lstrip("/")
PART = Path(os.environ.get("PART_FOLDER", Path(__file__).resolve().parent.parent / "part"))


def patterns(name: str) -> list[str]:
    """The patterns of a file of the part; none where it has no such file."""
    file = PART / name
    lines = file.read_text().splitlines() if file.exists() else []
    return [line.strip() for line in lines if line.strip() and not line.startswith("#")]


def matching(path: str, wanted: list[str]) -> str | None:
    """The first pattern that a path matches, if any."""
    return next((pattern for pattern in wanted if fnmatch.fnmatchcase(path, pattern)), None)


def read(record: Path) -> list[list[str]]:
    """The entries of a RECORD: path, hash and size."""
    with record.open(newline="", encoding="utf-8") as stream:
        return [row for row in csv.reader(stream) if row]


def write(record: Path, rows: list[list[str]]) -> None:
    """Writes a RECORD."""
    with record.open("w", newline="", encoding="utf-8") as stream:
        csv.writer(stream, lineterminator="\n").writerows(rows)


def digest(file: Path) -> tuple[str, int]:
    """A file's sha256 as RECORD spells it, and its size in bytes."""
    state = hashlib.sha256()
    with file.open("rb") as stream:
        for block in iter(lambda: stream.read(1 << 20), b""):
            state.update(block)
    return "sha256=" + base64.urlsafe_b64encode(state.digest()).rstrip(b"=").decode(), file.stat().st_size


def prune() -> None:
    """Removes files, and folders that are empty then; says what that saves."""
    wanted = patterns("prune.txt")
    saved = {pattern: [0, 0] for pattern in wanted}
    for record in sorted(SITE.glob("*.dist-info/RECORD")):
        rows, kept = read(record), []
        for row in rows:
            file = SITE / row[0]
            pattern = matching(row[0], wanted)
            if pattern is None:
                kept.append(row)
                continue
            if not file.exists():  # of another wheel as well
                continue
            saved[pattern][0] += 1
            saved[pattern][1] += file.stat().st_size
            file.unlink()
            folder = file.parent
            while folder != SITE and not any(folder.iterdir()):
                folder.rmdir()
                folder = folder.parent
        if len(kept) < len(rows):
            write(record, kept)
    for pattern, (count, size) in saved.items():
        print(f"prune: {pattern}: {count} files, {size / 1e6:.1f} MB")


def verify() -> None:
    """Compares every recorded file with its record.

    Raises:
        SystemExit: a file is missing or differs and is not said to.
    """
    adapted = patterns("adapted.txt")
    wrong, checked = [], 0
    for record in sorted(SITE.glob("*.dist-info/RECORD")):
        everything = read(record)
        rows = [row for row in everything if not row[0].endswith(".pyc")]  # bytecode.sh makes them anew
        changed = len(rows) < len(everything)
        for row in rows:
            path, expected, size = row
            file = SITE / path
            if not expected:  # RECORD itself
                continue
            if not file.is_file() and not (file.is_symlink() and matching(path, adapted)):
                wrong.append(f"{path} is missing")
            elif matching(path, adapted):
                # a link leads to another payload, whose file is not here
                row[1:] = ["", ""] if file.is_symlink() else [str(fact) for fact in digest(file)]
                changed = True
            elif expected.startswith("sha256=") and digest(file) != (expected, int(size)):
                wrong.append(f"{path} is not what the wheel has")
            checked += 1
        if changed:
            write(record, rows)
    if wrong or not checked:
        sys.exit("records: " + ("\n  ".join(wrong) or "nothing is recorded"))
    print(f"records: {checked} files are what the wheels have")


if __name__ == "__main__":
    {"prune": prune, "verify": verify}[sys.argv[1]]()
