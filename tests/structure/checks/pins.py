#!/usr/bin/env python3
"""pip and uv keep to what Python finds of the image's parts: frameworks, CUDA and numpy in these versions, and everything that
the parts' packages ask for within what they ask."""

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
    lines: set[str] = set()
    for line in file.read_text().splitlines():
        if line.startswith("-c "):
            lines |= constraints(file.parent / line[3:])
        elif line and not line.startswith("#"):
            lines.add(line)
    return lines


KEPT = re.compile(r"numpy|torch|torchvision|torchaudio|triton|tensorflow(-.*)?|nvidia-.*")
"""What has one version in an image, whatever else a part pins."""


def carried() -> tuple[set[str], set[tuple[str, str]]]:
    """What Python finds in /usr/local, as constraints; and what that asks for, as names and clauses: ("pillow", ">=5.3.0")."""
    packages: set[str] = set()
    requirements: set[tuple[str, str]] = set()
    for metadata in ROOT.glob("usr/local/lib/python3*/dist-packages/*.dist-info/METADATA"):
        with metadata.open(encoding="utf-8") as stream:
            description = HeaderParser().parse(stream)
        packages.add(f"{normal(description['Name'])}=={description['Version']}")
        for line in description.get_all("Requires-Dist", ()):
            requirement, _, marker = re.sub(r"\[[^]]*\]", "", line).partition(";")
            name = re.split(r"[^\w.-]", requirement)[0]
            clauses = re.sub(r"[\s()]", "", requirement[len(name) :])
            if "extra" not in marker:
                requirements |= {(normal(name), clause) for clause in clauses.split(",") if clause}
    return packages, requirements


settings = {
    "/etc/pip.conf": re.findall(r"^constraint = (.*)", (ROOT / "etc/pip.conf").read_text(), re.MULTILINE),
    "UV_CONSTRAINT": [os.environ.get("UV_CONSTRAINT", "")],
}
wrong = [f"{who} names {what}, and not {FILE}" for who, what in settings.items() if what != [FILE]]
kept, (parts, requirements) = constraints(ROOT / FILE[1:]), carried()
pinned = {line for line in kept if re.fullmatch(r"[a-z0-9-]+==[^;]*", line)}
names = {line.partition("==")[0] for line in pinned}
held = {
    (re.split(r"[^\w-]", line)[0], clause)
    for line in kept
    for clause in re.findall(r"[<>=!~]+[^,;]+", line.split(";")[0])
}
wrong += [f"{item} is there, and not pinned" for item in sorted(parts - pinned) if KEPT.fullmatch(item.split("==")[0])]
wrong += [f"{item} is pinned, and not there" for item in sorted(pinned - parts)]
wrong += [
    f"a part asks for {''.join(item)}, and nothing holds it to that"
    for item in sorted(requirements - held)
    if item[0] not in names
]
for name in ("numpy", "empy"):
    if not any(re.match(f"{name}[<>]", line) for line in kept):
        wrong.append(f"nothing keeps {name} to what ROS was built with")
print(f"{len(parts)} packages, {len(pinned)} pinned")
sys.exit("\n".join(wrong) or 0)
