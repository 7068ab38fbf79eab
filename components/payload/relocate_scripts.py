#!/usr/bin/env python3
"""Moves the commands of installed wheels to /usr/local/bin, where a shell finds them.

`uv pip install --target` leaves them in TARGET/bin, with the assembler's interpreter in the first line. Here they go
to /usr/local/bin with the interpreter of the image, and each RECORD follows, so that `pip uninstall` finds them.
"""

import base64
import csv
import hashlib
import io
import os
import re
from pathlib import Path

out = Path(os.environ["OUT"])
site = out / os.environ["SITE"].lstrip("/")
interpreter = "/usr/bin/python3" if os.environ["PYTHON"] == "any" else f"/usr/bin/python{os.environ['PYTHON']}"
commands = out / "usr/local/bin"


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
    content = path.read_bytes()
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return [os.path.relpath(path, site), f"sha256={digest}", str(len(content))]


def main() -> None:
    if not (site / "bin").is_dir():
        return
    commands.mkdir(parents=True, exist_ok=True)
    moved = {f"bin/{script.name}": move(script) for script in sorted((site / "bin").iterdir())}
    (site / "bin").rmdir()
    for record in site.glob("*.dist-info/RECORD"):
        lines = list(csv.reader(io.StringIO(record.read_text())))
        if not any(line and line[0] in moved for line in lines):
            continue
        lines = [record_line(moved[line[0]]) if line[0] in moved else line for line in lines if line]
        with record.open("w", newline="") as stream:
            csv.writer(stream, lineterminator="\n").writerows(lines)


main()
