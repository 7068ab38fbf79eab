#!/usr/bin/env python3
"""Names the Debian packages that programs need to run, of those that they are built with.

    runtime_packages.py PACKAGE…

A package with headers, such as libroscpp-dev, becomes those that it depends on: libroscpp4d, messages. A package that needs a compiler is
left out. All others stay, also those with a version or an architecture, and those that apt does not know. Prints a name a line, sorted.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterable

HEADERS = re.compile(r".*-dev")
"""Packages with headers, and metapackages of such. Those of the section libdevel have some too, except Python's."""

COMPILERS = re.compile(
    r"(gcc|g\+\+|cpp|libgcc|libstdc\+\+)(-\d+)?(-dev)?|build-essential|binutils|dpkg-dev|make|ninja-build|libc6-dev"
    r"|linux-libc-dev"
)


class Archive:
    """What apt knows of packages, by name: their sections and dependencies."""

    def __init__(self) -> None:
        output = subprocess.run(["apt-cache", "dumpavail"], capture_output=True, check=True).stdout.decode(
            errors="replace"
        )
        self._packages: dict[str, tuple[str, list[str]]] = {}
        self._providers: dict[str, str] = {}
        for text in output.split("\n\n"):
            fields = dict(re.findall(r"^(Package|Section|Pre-Depends|Depends|Provides): (.*)$", text, re.MULTILINE))
            groups = f"{fields.get('Pre-Depends', '')},{fields.get('Depends', '')}".split(",")
            # Of alternatives the first, as apt chooses.
            depends = [name[0] for group in groups if (name := re.match(r"[^\s:(|]+", group.strip()))]
            self._packages[fields.get("Package", "")] = fields.get("Section", "").rpartition("/")[2], depends
            for virtual in re.findall(r"[^\s,(]+", re.sub(r"\([^()]*\)", "", fields.get("Provides", ""))):
                self._providers.setdefault(virtual, fields.get("Package", ""))

    def real(self, name: str) -> str:
        """The package itself, or the first that provides it; empty if there is none."""
        return name if name in self._packages else self._providers.get(name, "")

    def section(self, name: str) -> str:
        return self._packages.get(name, ("", []))[0]

    def needs(self, name: str) -> list[str]:
        return self._packages.get(name, ("", []))[1]

    def compiles(self, name: str) -> bool:
        seen, todo = {name}, [name]
        while todo:
            if any(COMPILERS.fullmatch(item) for item in todo):
                return True
            todo = sorted({need for item in todo for need in self.needs(item)} - seen)
            seen.update(todo)
        return False


def needed(packages: Iterable[str], archive: Archive) -> list[str]:
    kept: set[str] = set()
    seen: set[str] = set()
    todo = list(packages)
    while todo:
        seen.update(todo)
        dependencies = []
        for item in todo:
            name = archive.real(item)
            section = archive.section(name)
            if COMPILERS.fullmatch(item):
                continue
            if not name:
                kept.add(item)
            elif HEADERS.fullmatch(name) or (section == "libdevel" and not name.startswith("python3-")):
                dependencies += archive.needs(name)
            elif section != "devel" or not archive.compiles(name):
                kept.add(item)
        todo = sorted(set(dependencies) - seen)
    return sorted(kept)


if __name__ == "__main__":
    print("\n".join(needed(sys.argv[1:], Archive())))
