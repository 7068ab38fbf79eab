#!/usr/bin/env python3
"""Joins the compile_commands.json of a workspace's packages into one, which language servers find above the sources.

    compile_commands.py WORKSPACE FOLDER

FOLDER is the path of the sources on the container's machine, for whose paths there is `host/compile_commands.json`; empty for none.
"""

from __future__ import annotations

import json
import os
import re
import sys
import tempfile
from pathlib import Path
from typing import Any, Dict

PLACES = ("build", "build_isolated")
NAME = "compile_commands.json"

Entry = Dict[str, Any]


def read(workspace: Path) -> list[Entry]:
    """The entries of all packages. Files that a build is writing, or that are damaged, do not count."""
    all_entries: list[Entry] = []
    for place in PLACES:
        # catkin_make has one for all. colcon may write one as well, beside those of the packages.
        for file in sorted((workspace / place).glob(f"*/{NAME}")) or [workspace / place / NAME]:
            try:
                entries = json.loads(file.read_text(encoding="utf-8"))
            except (OSError, RecursionError, ValueError):
                continue
            all_entries += filter(understood, entries) if isinstance(entries, list) else []
    return all_entries


def understood(entry: Any) -> bool:
    """Whether an entry is complete: https://clang.llvm.org/docs/JSONCompilationDatabase.html."""
    if not isinstance(entry, dict) or not all(isinstance(entry.get(key), str) for key in ("directory", "file")):
        return False
    try:
        words = entry.get("arguments") or split(entry["command"])
    except (KeyError, TypeError, ValueError):
        return False
    return isinstance(words, list) and all(isinstance(word, str) for word in words)


PIECE = re.compile(r"""([^\s"'\\]+)|'([^']*)'|"([^"\\]*(?:\\.[^"\\]*)*)"|\\(.)|(\s+)""", re.DOTALL)
"""A piece of a command: plain text, both kinds of quotes, a character after a backslash, or what is between words."""


def split(command: str) -> list[str]:
    """The words of a command, as a shell splits it. shlex takes a minute for a word of a megabyte."""
    words: list[list[str]] = [[]]
    place = 0
    while place < len(command):
        match = PIECE.match(command, place)
        if not match:
            raise ValueError("a quote does not close")
        plain, single, double, escaped, space = match.groups()
        if space:
            words += [[]] if words[-1] else []
        else:
            words[-1].append(re.sub(r'\\([\\"])', r"\1", double) if double else plain or single or escaped or "")
        place = match.end()
    return ["".join(word) for word in words if word]


def moved(entry: Entry, places: dict[str, str]) -> Entry:
    """An entry with the paths of another machine. `places`: these by the beginnings of ours; the first that fits counts."""

    def path(text: str) -> str:
        for from_path, to_path in places.items():
            before, separator, after = text.partition(from_path)
            if separator and not after[:1].isalnum():
                return before + to_path + after
        return text

    paths = {key: path(str(value)) for key, value in entry.items() if key in ("directory", "file", "output")}
    words = entry.get("arguments") or split(entry.get("command", ""))
    return {**paths, "arguments": [path(word) for word in words]}


def write(file: Path, entries: list[Entry]) -> None:
    text = json.dumps(entries, indent=1) + "\n"
    try:
        if file.read_text(encoding="utf-8") == text:
            return
    except (OSError, ValueError):
        pass
    file.parent.mkdir(exist_ok=True)
    with tempfile.NamedTemporaryFile("w", dir=str(file.parent), delete=False, encoding="utf-8") as stream:
        stream.write(text)
    os.chmod(stream.name, 0o644)
    os.replace(stream.name, file)


def main(workspace: Path, folder: str) -> None:
    entries = read(workspace)
    if not entries:
        return
    write(workspace / NAME, entries)
    if folder:
        places = {f"{workspace}/src/target": folder, str(workspace): f"{folder}/.rosml/dev"}
        write(workspace / "host" / NAME, [moved(entry, places) for entry in entries])


if __name__ == "__main__":
    try:
        main(Path(sys.argv[1]), sys.argv[2])
    except OSError as error:  # the build itself went well
        print(f"warning: {error.filename}: {error.strerror}: editors do not find {NAME}", file=sys.stderr)
