#!/usr/bin/env python3
"""What pip and uv know of a part's packages.

  packages.py SLOT [LOCK...]
      shows Python the packages of other parts, by their locks (<part>.txt), and writes constraints for pip and uv to the slot

Packages that match a line of the part's pins.txt keep their version, or all if there is no such file. Others may move as far as the part's
own packages ask for them, so that `pip check` finds nothing.

Other parts are those for any Python, below /usr/local/lib/rosml, which are not here. uv follows neither a link to a package's folder nor a
.pth file, so each package has a folder with links.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from email.parser import HeaderParser
from pathlib import Path

import records  # beside this script

SHOWN = ("INSTALLER", "METADATA", "RECORD", "WHEEL")
"""Of each package that uv installed. By RECORD, a package is removed with its files."""

REQUIREMENT = re.compile(
    r"(?P<name>[A-Za-z0-9][\w.-]*) *(?:\[[^]]*\])? *\(?(?P<range>[^;()]*)\)? *(?:; *(?P<marker>.*))?"
)
"""As `Requires-Dist` has it: jinja2[i18n] (>=3,<4) ; python_version < "3.9"."""


def normal(name: str) -> str:
    """A package's name as pip compares it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def show(lock: Path) -> None:
    """Makes folders for the packages of a lock, with links to those of its part."""
    for name, version in re.findall(r"^([A-Za-z0-9._-]+)==([^ \\\n]+)", lock.read_text(), re.MULTILINE):
        folder = records.SITE / "{}-{}.dist-info".format(re.sub(r"[-.]+", "_", name), version)
        folder.mkdir()
        for file in SHOWN:
            (folder / file).symlink_to(f"/usr/local/lib/rosml/{lock.stem}/{folder.name}/{file}")


def required(metadata: Path) -> Iterator[tuple[str, str, str]]:
    """What a package asks for, whatever its extras: name, range of versions, and the marker of when."""
    for line in HeaderParser().parsestr(metadata.read_text(encoding="utf-8")).get_all("Requires-Dist", ()):
        match = REQUIREMENT.fullmatch(line.strip())
        if match is None:
            sys.exit(f"packages: {metadata.parent.name} has a requirement that nobody can read: {line}")
        marker = match["marker"] or ""
        if match["range"].strip() and not re.search(r"\bextra\b", marker):
            yield normal(match["name"]), re.sub(r"\s", "", match["range"]), marker


def constraints() -> list[str]:
    """The slot's lines: packages that keep their version (torch==2.10.0+cpu), then what others are held to."""
    kept, requirements = records.patterns("pins.txt") or ["*"], set()
    pinned: dict[str, str] = {}
    for folder in records.SITE.glob("*.dist-info"):
        name, version = folder.stem.rsplit("-", 1)
        if records.matching(normal(name), kept):
            pinned[normal(name)] = version
        if (folder / "METADATA").exists():  # a link leads to a part that is not here
            requirements |= set(required(folder / "METADATA"))
    held = sorted(item for item in requirements if item[0] not in pinned)
    return [
        *(f"{name}=={version}" for name, version in sorted(pinned.items())),
        *(f"{name}{bounds}{marker and f'; {marker}'}" for name, bounds, marker in held),
    ]


def main(slot: str, *locks: str) -> None:
    for lock in locks:
        if Path(lock).exists():  # the shell leaves a pattern as it is that nothing matches
            show(Path(lock))
    file = records.OUT / "usr/local/share/rosml/constraints.d" / f"{slot}.txt"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("\n".join([f"# What the part {os.environ['PART']} holds and asks for", *constraints(), ""]))


if __name__ == "__main__":
    main(*sys.argv[1:])
