#!/usr/bin/env python3
"""Moves the commands of wheels from TARGET/bin, where `uv pip install --target` leaves them, to /usr/local/bin, with the interpreter of the
image. Each RECORD follows, so that `pip uninstall` finds them.
"""

from __future__ import annotations

import os
import re
from pathlib import Path

import records  # beside this script

interpreter = "/usr/bin/python3" if os.environ["PYTHON"] == "any" else f"/usr/bin/python{os.environ['PYTHON']}"
commands = records.OUT / "usr/local/bin"


def move(script: Path) -> Path:
    """Moves one command and returns its new place; a Python command gets the image's interpreter."""
    content = script.read_bytes()
    if content.startswith(b"#!") and b"python" in content.splitlines()[0]:
        content = re.sub(rb"\A#![^\n]*", b"#!" + interpreter.encode(), content)
    elif content.startswith(b"#!/bin/sh\n'''exec'"):  # what installers write when the interpreter's path is long
        content = re.sub(rb"\A#!/bin/sh\n'''exec'[^\n]*\n' '''", b"#!" + interpreter.encode(), content)
    target = commands / script.name
    target.write_bytes(content)
    target.chmod(0o755)
    script.unlink()
    return target


def record_line(path: Path) -> list[str]:
    """The RECORD entry of a file: its path from the site directory, its sha256 and its size in bytes."""
    return [os.path.relpath(path, records.SITE), *map(str, records.digest(path))]


def main() -> None:
    folder = records.SITE / "bin"
    if not folder.is_dir():
        return
    commands.mkdir(parents=True, exist_ok=True)
    moved = {f"bin/{script.name}": record_line(move(script)) for script in sorted(folder.iterdir())}
    folder.rmdir()
    records.replace(moved)


main()
