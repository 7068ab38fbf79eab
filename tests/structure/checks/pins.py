#!/usr/bin/env python3
"""pip and uv keep to what Python finds of the image's parts: all of it, in these versions, and nothing else."""

from __future__ import annotations

import os
import re
import sys
from email.parser import HeaderParser
from pathlib import Path

ROOT = Path(os.environ.get("CHECK_ROOT", "/"))
FILE = "/usr/local/share/rosml/constraints.d/all.txt"


def normal(name: str) -> str:
    """A package's name as pip compares it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def constraints(file: Path) -> set[str]:
    """The constraints of a file, and of those that it names."""
    found: set[str] = set()
    for line in file.read_text().splitlines():
        if line.startswith("-c "):
            found |= constraints(file.parent / line[3:])
        elif line and not line.startswith("#"):
            found.add(line)
    return found


def carried() -> set[str]:
    """What Python finds in /usr/local, as constraints."""
    found: set[str] = set()
    for metadata in ROOT.glob("usr/local/lib/python3*/dist-packages/*.dist-info/METADATA"):
        with metadata.open(encoding="utf-8") as stream:
            said = HeaderParser().parse(stream)
        found.add(f"{normal(said['Name'])}=={said['Version']}")
    return found


named = {
    "/etc/pip.conf": re.findall(r"^constraint = (.*)", (ROOT / "etc/pip.conf").read_text(), re.MULTILINE),
    "UV_CONSTRAINT": [os.environ.get("UV_CONSTRAINT", "")],
}
wrong = [f"{who} names {what}, and not {FILE}" for who, what in named.items() if what != [FILE]]
kept, parts = constraints(ROOT / FILE[1:]), carried()
pinned = {line for line in kept if "==" in line}
wrong += [f"{item} is there, and not pinned" for item in sorted(parts - pinned)]
wrong += [f"{item} is pinned, and not there" for item in sorted(pinned - parts)]
for name in ("numpy", "empy"):
    if not any(re.match(f"{name}[<>]", line) for line in kept):
        wrong.append(f"nothing keeps {name} to what ROS was built with")
print(f"{len(parts)} packages")
sys.exit("\n".join(wrong) or 0)
