#!/usr/bin/env python3
"""Keeps a part and the wheels' own records of their files (RECORD) in agreement.

  records.py prune    removes files that match a line of the part's prune.txt, and, if it has a keep.txt, those that match none of that
  records.py verify   fails unless all recorded files are those of the wheel. Files that match a line of adapted.txt are recorded anew
  records.py link TARGET PATH...
                      makes files or whole folders links to another part's at TARGET/PATH, and writes down what they were, for a test
  records.py alias NAME WHEEL
                      makes a package NAME that stands for a wheel of another name; WHEEL is its folder, onnxruntime-1.23.2.dist-info

Patterns are those of the shell, below the folder of the packages; `*` matches slashes as well. Lines that begin with # say why. uv has
compared the wheels with the lock's hashes before.
"""

from __future__ import annotations

import base64
import csv
import email.parser
import fnmatch
import hashlib
import os
import shutil
import sys
from collections.abc import Callable, Iterable
from pathlib import Path

OUT = Path(os.environ["OUT"])
SITE = OUT / os.environ["SITE"].lstrip("/")
PART = Path(os.environ.get("PART_FOLDER", Path(__file__).resolve().parent.parent / os.environ.get("PART", "")))


def patterns(name: str) -> list[str]:
    """The patterns of a file of the part; none where it has no such file."""
    file = PART / name
    lines = file.read_text().splitlines() if file.exists() else []
    return [line.strip() for line in lines if line.strip() and not line.startswith("#")]


def matching(path: str, globs: list[str]) -> str | None:
    return next((pattern for pattern in globs if fnmatch.fnmatchcase(path, pattern)), None)


def read(record: Path) -> list[list[str]]:
    """The entries of a RECORD: path, hash and size."""
    with record.open(newline="", encoding="utf-8") as stream:
        return [row for row in csv.reader(stream) if row]


def write(record: Path, rows: list[list[str]]) -> None:
    with record.open("w", newline="", encoding="utf-8") as stream:
        csv.writer(stream, lineterminator="\n").writerows(rows)


def replace(entries: dict[str, list[str]]) -> None:
    """Replaces entries of all RECORDs, by path."""
    for record in SITE.glob("*.dist-info/RECORD"):
        rows = read(record)
        if any(row[0] in entries for row in rows):
            write(record, [entries.get(row[0], row) for row in rows])


def digest(file: Path) -> tuple[str, int]:
    """A file's sha256 as RECORD spells it, and its size in bytes."""
    state = hashlib.sha256()
    with file.open("rb") as stream:
        for block in iter(lambda: stream.read(1 << 20), b""):
            state.update(block)
    return "sha256=" + base64.urlsafe_b64encode(state.digest()).rstrip(b"=").decode(), file.stat().st_size


NOT_KEPT = "what keep.txt does not name"


def prune() -> None:
    pruned, kept_alone = patterns("prune.txt"), patterns("keep.txt")
    saved = {pattern: [0, 0] for pattern in pruned}
    if kept_alone:
        saved[NOT_KEPT] = [0, 0]
    for record in sorted(SITE.glob("*.dist-info/RECORD")):
        rows, kept = read(record), []
        for row in rows:
            file = SITE / row[0]
            pattern = matching(row[0], pruned)
            if pattern is None and kept_alone and matching(row[0], kept_alone) is None:
                pattern = NOT_KEPT
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


def link(target: str, *paths: str) -> None:
    here: dict[str, list[list[str]]] = {path: [] for path in paths}
    for record in sorted(SITE.glob("*.dist-info/RECORD")):
        rows = read(record)
        for path, recorded_rows in here.items():
            inside = [row for row in rows if row[0] == path or row[0].startswith(f"{path}/")]
            if inside:
                recorded_rows += inside
                rows = [row for row in rows if row not in inside] + [[path, "", ""]]
                write(record, rows)
    for path, recorded_rows in here.items():
        place = SITE / path
        files = [file for file in place.rglob("*") if not file.is_dir()] if place.is_dir() else [place]
        recorded = {row[0]: (row[1], int(row[2])) for row in recorded_rows}
        wrong = [str(name) for file in files if recorded.get(name := str(file.relative_to(SITE))) != digest(file)]
        if wrong or len(recorded) != len(files):
            sys.exit(
                f"records: {path} is not what the wheel has: {wrong[:5] or f'{len(files)} of {len(recorded)} files'}"
            )
        shutil.rmtree(place) if place.is_dir() else place.unlink()
        place.symlink_to(f"{target}/{path}")
    summary_file = OUT / EXPECTED.lstrip("/") / Path(target).name
    summary_file.parent.mkdir(parents=True, exist_ok=True)
    summary_file.write_text(f"{summary(row for recorded_rows in here.values() for row in recorded_rows)}\n")


def alias(name: str, wheel: str) -> None:
    """Makes a package that stands for a wheel's, unless the wheel or another one has that name. Without it, pip would install another wheel
    over this one for what depends on the name. Its record has the wheel's files, so who replaces it replaces them. Call it after `link`.
    """
    called, _, version = wheel[: -len(".dist-info")].rpartition("-")
    folder = SITE / f"{name}-{version}.dist-info"
    if folder.name == wheel:
        return
    if not folder.is_dir():
        folder.mkdir()
        files = {
            "INSTALLER": ["rosml"],
            "METADATA": [
                "Metadata-Version: 2.4",
                f"Name: {name}",
                f"Version: {version}",
                f"Summary: Stands for {called}, which is the same package under another name",
                f"Requires-Dist: {called}=={version}",
                *makers(SITE / wheel / "METADATA"),
            ],
            "RECORD": [f"{folder.name}/{file},," for file in ("INSTALLER", "METADATA", "RECORD", "WHEEL")],
            "WHEEL": ["Wheel-Version: 1.0", "Generator: rosml", "Root-Is-Purelib: true", "Tag: py3-none-any"],
        }
        for file, lines in files.items():
            (folder / file).write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
    with (folder / "RECORD").open("ab") as record:
        record.write((SITE / wheel / "RECORD").read_bytes())


MAKERS = (
    "Author",
    "Author-email",
    "Maintainer",
    "Maintainer-email",
    "Home-page",
    "License-Expression",
    "License",
    "Classifier",
)
"""Who made a package, and under which licence: https://packaging.python.org/specifications/core-metadata/"""


def makers(metadata: Path) -> list[str]:
    """The lines of a wheel's metadata that also hold for what stands for it. Some wheels have a whole text as their licence: no line of it."""
    message = email.parser.HeaderParser().parsestr(metadata.read_text(encoding="utf-8"))
    every = ((field, value.strip()) for field in MAKERS for value in message.get_all(field, []))
    return [
        f"{field}: {value}"
        for field, value in every
        if "\n" not in value and (field != "Classifier" or value.startswith("License ::"))
    ]


EXPECTED = "/usr/local/share/rosml/expected.d"
"""What a part takes another part's files to be: one file for each, by the name of the other part."""


def summary(rows: Iterable[list[str]]) -> str:
    return hashlib.sha256("\n".join(sorted(",".join(row) for row in rows)).encode()).hexdigest()


def verify() -> None:
    adapted = patterns("adapted.txt")
    wrong = [f"{folder.name} has no RECORD" for folder in SITE.glob("*.dist-info") if not (folder / "RECORD").is_file()]
    checked = 0
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
                # a link leads to another part, whose file is not here
                row[1:] = ["", ""] if file.is_symlink() else [str(fact) for fact in digest(file)]
                changed = True
            elif digest(file) != (expected, int(size or file.stat().st_size)):
                wrong.append(f"{path} is not what the wheel has")
            checked += 1
        if changed:
            write(record, rows)
    if wrong or not checked:
        sys.exit("records: " + ("\n  ".join(wrong) or "nothing is recorded"))
    print(f"records: {checked} files are what the wheels have")


if __name__ == "__main__":
    commands: dict[str, Callable[..., None]] = {"prune": prune, "verify": verify, "link": link, "alias": alias}
    commands[sys.argv[1]](*sys.argv[2:])
