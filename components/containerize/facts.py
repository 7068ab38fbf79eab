#!/usr/bin/env python3
"""Writes packages with their relations, and symbols of libraries, to OUT/facts.gz; they say which apps can move there: facts.py ROOT OUT"""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
import os
import re
import sys
from pathlib import Path
from typing import Any, Iterable, Iterator, Mapping, Sequence

import contents
from elf import Elf, Symbols, elf, symbols

LIBRARY = re.compile(r"(.*/)?[^/]+\.so(\.[^/]+)?")
"""Files that can be libraries, and links to them."""

INTERPRETER = re.compile(r"(usr/(local/)?)?bin/python\d+\.\d+")
"""Python, without a library of its own, exports what its extensions use."""

EXTENSION = b"PyInit_"
"""The beginning of the one symbol that an extension of Python has to export."""

LINKS = 40
"""The most links on the way to a file, as on Linux."""

MERGED = re.compile(r"(bin|lib|lib32|lib64|libx32|sbin)/")
"""Folders that are links to those in /usr. dpkg lists a file as its package has it, with or without /usr."""


def packed(names: Iterable[bytes]) -> str:
    """Symbols as text: four characters for each, in order, which stand for the first three bytes of its SHA-256."""
    digests = {hashlib.sha256(name).digest()[:3] for name in names}
    return base64.urlsafe_b64encode(b"".join(sorted(digests))).decode()


def shown(paths: Iterable[str]) -> list[str]:
    """Paths as JSON can have them: bytes that are not UTF-8 become escapes."""
    return [path.encode("utf-8", "backslashreplace").decode() for path in paths]


def package(text: str) -> dict[str, Any]:
    """A package by its entry in dpkg's database; empty if it lacks its name, architecture or version."""
    values = dict(re.findall(r"^([A-Z][A-Za-z-]*):[ \t]*(.*(?:\n[ \t].*)*)", text, re.MULTILINE))
    fields = {name: " ".join(value.split()) for name, value in values.items()}
    if not fields.keys() >= {"Package", "Architecture", "Version"}:
        return {}

    def joined(*names: str) -> str:
        return ", ".join(fields[name] for name in names if fields.get(name))

    return {
        "name": fields["Package"],
        "architecture": fields["Architecture"],
        "version": fields["Version"],
        "provides": joined("Provides"),
        "depends": joined("Pre-Depends", "Depends"),
        "conflicts": joined("Conflicts", "Breaks"),
    }


def write(out: Path, **facts: Sequence[Any]) -> None:
    text = json.dumps(facts, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    with open(out / "facts.gz", "wb") as raw, gzip.GzipFile("", "wb", 9, raw, 0) as file:
        file.write(text.encode("utf-8", "replace"))


def write_base(root: Path, out: Path) -> None:
    """The facts of a base image or a part: its packages, and the libraries that export something."""
    paths = contents.files([root])
    links = _links(paths)
    libraries = []
    for path, place in sorted(paths.items()):
        if LIBRARY.fullmatch(path) or INTERPRETER.fullmatch(path):
            binary = _read(Path(place))
            if binary and _counts(*binary):
                libraries.append(_library(path, *binary, links.get(path, ())))
    entries = [*contents.status(root).values(), *contents.brought(paths)]
    write(out, packages=_sorted(map(package, entries)), libraries=libraries)


def write_app(
    layer: Path, runtime: Path, out: Path, imports: Mapping[str, str], asks: Iterable[str], asks_pip: Iterable[str]
) -> None:
    """Writes the facts of an app with these files.

    Args:
        runtime: the image without the app's ROS packages, with dpkg's lists of files.
        imports: modules of the base image that the app's Python imports, each with a file that does.
        asks: packages of apt that the app asks for by name. asks_pip: those of pip.
    """
    paths = contents.files([layer])
    links = _links(paths)
    read = {path: content for path, place in sorted(paths.items()) if (content := _read(Path(place)))}
    exported = {(binary.machine, name) for binary, names in read.values() for name in names.exports}
    libraries = []
    for path, (binary, names) in read.items():
        uses = {name for name in names.uses if (binary.machine, name) not in exported}
        libraries.append({**_library(path, binary, names, links.get(path, ())), "uses": sorted(_texts(uses))})
    packages = _sorted(map(package, contents.brought(paths)))
    for item in packages:
        item["files"] = sorted({*shown(_owned(item, paths, runtime))})
    others = {*shown(paths)}.difference(*(item["files"] for item in packages))
    write(
        out,
        packages=packages,
        libraries=libraries,
        files=sorted(others),
        imports=[{"module": name, "file": file} for name, file in sorted(zip(shown(imports), shown(imports.values())))],
        asks=sorted(asks),
        asks_pip=sorted(asks_pip),
    )


def _read(place: Path) -> tuple[Elf, Symbols] | None:
    """What a program or a library says of itself; None if it is damaged."""
    binary = elf(place)
    names = symbols(place) if binary else None
    if not binary or not names:
        return None
    if not binary.build:  # then its content says whether it is the same
        binary = binary._replace(build=_digest(place))
    return binary, names


def _digest(place: Path) -> str:
    whole = hashlib.sha256()
    with open(place, "rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            whole.update(block)
    return whole.hexdigest()[:40]


def _counts(binary: Elf, names: Symbols) -> bool:
    """Whether a library of a base can matter to others: an extension that only Python loads does not."""
    if all(name.startswith(EXTENSION) for name in names.exports):
        return not names.exports and binary.soname != ""
    return True


def _library(path: str, binary: Elf, names: Symbols, links: Iterable[str]) -> dict[str, Any]:
    return {
        "path": shown([path])[0],
        "soname": binary.soname,
        "id": binary.build[:64],
        "names": sorted(shown({*links} - {binary.soname, os.path.basename(path)})),
        "machine": binary.machine,
        "needed": binary.needed,
        "symbols": packed(names.exports),
    }


def _texts(names: Iterable[bytes]) -> Iterator[str]:
    """Symbols in UTF-8; no compiler makes others."""
    for name in names:
        try:
            yield name.decode()
        except UnicodeDecodeError:
            continue


def _links(paths: dict[str, str]) -> dict[str, set[str]]:
    """The names of links to each file that can be a library."""
    targets = {path: os.readlink(place) for path, place in paths.items() if os.path.islink(place)}
    names: dict[str, set[str]] = {}
    for path in targets:
        if LIBRARY.fullmatch(path):
            names.setdefault(_resolved(path, targets), set()).add(os.path.basename(path))
    return names


def _resolved(path: str, targets: dict[str, str]) -> str:
    """The file that a path leads to in an image with these links; empty if it leads nowhere."""
    pending, here, links = path.split("/")[::-1], "", 0
    while pending:
        part = pending.pop()
        if part == "..":
            here = os.path.dirname(here)
        elif part not in ("", "."):
            below = os.path.join(here, part)
            if below not in targets:
                here = below
                continue
            links += 1
            if links > LINKS:
                return ""
            here = "" if targets[below].startswith("/") else here
            pending += targets[below].split("/")[::-1]
    return here


def _owned(item: dict[str, Any], paths: dict[str, str], runtime: Path) -> Iterator[str]:
    """The files of an app's layer that a package owns, with what the layer says of the package."""
    key = f"{item['name']}:{item['architecture']}"
    if not contents.KEY.fullmatch(key):
        return
    entry = f"var/lib/dpkg/status.d/{item['name']}"
    if entry in paths:
        yield entry
    for name in (item["name"], key):
        file = runtime / f"var/lib/dpkg/info/{name}.list"
        for line in os.fsdecode(file.read_bytes()).split("\n") if file.is_file() else []:
            path = line[1:]
            yield from {path, f"usr/{path}" if MERGED.match(path) else path} & paths.keys()


def _sorted(items: Iterable[dict[str, Any]]) -> list[dict[str, Any]]:
    """Each package once: the last entry counts, as the upper layer's."""
    by_name = {(item["name"], item["architecture"]): item for item in items if item}
    return [by_name[name] for name in sorted(by_name)]


if __name__ == "__main__":
    write_base(*map(Path, sys.argv[1:]))
