#!/usr/bin/env python3
"""Lists the packages of an image in OUT/packages.json, and its files in OUT/files.gz: contents.py ROOT OUT"""

from __future__ import annotations

import contextlib
import functools
import gzip
import json
import os
import re
import stat
import sys
import xml.etree.ElementTree as ElementTree
from email.parser import HeaderParser
from pathlib import Path
from typing import Any, Container, Iterable, Iterator, Mapping, Sequence

PYTHON = re.compile(r"(?!docker-ros/ws/).*\.(dist-info/METADATA|egg-info/PKG-INFO|egg-info)")
"""What a package of Python says of itself. Those in the workspace are ROS packages."""

ROS = re.compile(r"docker-ros/ws/install/(.+/)?share/[^/]+/package\.xml")
"""What a ROS package of an app says of itself."""

APT = re.compile(r"var/lib/dpkg/status\.d/[^/]+")

COPYRIGHT = "usr/share/doc/{}/copyright"
"""What a package of Debian says of its licences: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/"""

LARGEST = 1 << 20
"""More bytes than what packages say of themselves has."""

LINKS = 4
"""How many links lead to a copyright file at most."""

EMPTY_SLOT = re.compile(r".*/rosml/constraints\.d/[^/]+")
"""An empty one is nobody's: a part may fill it."""

STATUS = "var/lib/dpkg/status"
"""dpkg's database."""

KEY = re.compile("[a-z0-9][a-z0-9.+-]*:[a-z0-9][a-z0-9-]*")
"""A package and its architecture: the name is also that of a file."""

INSTALLED = re.compile(r"(install|hold) ok (installed|triggers-awaited|triggers-pending)")
"""What dpkg says of a package that is there; some are held back from upgrades."""


@functools.lru_cache(maxsize=None)
def entries(root: Path) -> Mapping[str, os.stat_result]:
    """All files, links and folders below a root, by path. A root is read once, so it must not change."""
    return {path: item.stat(follow_symlinks=False) for path, item in walk(root)}


def walk(root: Path) -> Iterator[tuple[str, os.DirEntry[str]]]:
    """The same without what each is: to ask that takes most of the time."""
    folders = [""]
    while folders:
        above = folders.pop()
        with contextlib.suppress(OSError), os.scandir(os.path.join(root, above)) as items:
            for item in items:
                yield above + item.name, item
                if item.is_dir(follow_symlinks=False):
                    folders.append(f"{above}{item.name}/")


def files(roots: Sequence[Path]) -> dict[str, str]:
    """All files and links of layers, the lowest first: by path, with the place where an image has them from."""
    return {path: f"{root}/{path}" for root in roots for path, facts in entries(root).items() if _counts(path, facts)}


def _counts(path: str, facts: os.stat_result) -> bool:
    if stat.S_ISLNK(facts.st_mode):
        return True
    return stat.S_ISREG(facts.st_mode) and (facts.st_size > 0 or not EMPTY_SLOT.fullmatch(path))


def owned(root: Path) -> set[str]:
    """The files of packages of the operating system, as dpkg lists them."""
    lists = root.glob("var/lib/dpkg/info/*.list")
    return {line[1:] for file in lists for line in os.fsdecode(file.read_bytes()).split("\n") if line}


def status(root: Path) -> dict[str, str]:
    """dpkg's entries, by package and architecture. One that lacks either counts for none, as for dpkg."""
    by_key = {}
    path = root / STATUS
    for text in path.read_text("utf-8", "replace").split("\n\n") if path.exists() else []:
        fields = dict(re.findall(r"^(Package|Architecture|Status): (.*)$", text, re.MULTILINE))
        key = f"{fields.get('Package', '')}:{fields.get('Architecture', '')}"
        if INSTALLED.fullmatch(fields.get("Status", "")) and KEY.fullmatch(key):
            by_key[key] = text.strip() + "\n"
    return by_key


def packages(paths: dict[str, str], entries: Iterable[str], others: Container[str]) -> dict[str, Any]:
    """The packages of an image with these files. `entries`: of its packages, as dpkg has them. `others`: files of these packages."""
    python = [Path(place) for path, place in paths.items() if PYTHON.fullmatch(path) and path not in others]
    return {
        "system": _system(paths),
        "apt": _sorted(_debian(text, paths) for text in [*entries, *brought(paths)]),
        "python": _sorted(map(_python, python)),
        "ros": _sorted(_ros(Path(place)) for path, place in paths.items() if ROS.fullmatch(path)),
    }


def write(paths: dict[str, str], entries: Iterable[str], others: Container[str], out: Path) -> None:
    """Writes OUT/packages.json and OUT/files.gz: the same for the same image, on any day."""
    (out / "packages.json").write_text(as_json(packages(paths, entries, others), indent=1))
    with open(out / "files.gz", "wb") as raw, gzip.GzipFile("", "wb", 9, raw, 0) as file:
        file.writelines(path + b"\n" for path in sorted(map(os.fsencode, paths)))


def as_json(facts: Any, indent: int) -> str:
    """Facts as JSON for any reader: bytes of names that are no Unicode are replaced."""
    text = json.dumps(facts, indent=indent, ensure_ascii=False) + "\n"
    return json.dumps(json.loads(text.encode("utf-8", "replace")), indent=indent) + "\n"


def brought(paths: Mapping[str, str]) -> Iterator[str]:
    """What packages of apt say of themselves that apps brought."""
    for path, place in sorted(paths.items()):
        if APT.fullmatch(path) and Path(place).is_file():
            yield from Path(place).read_text("utf-8", "replace").split("\n\n")


def _system(paths: dict[str, str]) -> dict[str, str]:
    place = Path(paths.get("usr/lib/os-release", "/dev/null"))
    text = place.read_text("utf-8", "replace") if place.is_file() else ""
    fields = {name: value.strip("\"'") for name, value in re.findall(r"^(\w+)=(.*)$", text, re.MULTILINE)}
    return {"name": fields.get("ID", ""), "version": fields.get("VERSION_ID", "")}


_OF_DEBIAN = re.compile(
    r"^(Package|Architecture|Version|Source|Maintainer|Depends|Pre-Depends|Provides): (.*)$", re.MULTILINE
)


def _debian(text: str, paths: Mapping[str, str]) -> dict[str, Any]:
    fields = dict(_OF_DEBIAN.findall(text))
    if not fields.keys() >= {"Package", "Architecture", "Version"}:
        return {}
    source, _, version = fields.get("Source", "").partition(" ")
    return {
        "name": fields["Package"],
        "version": fields["Version"],
        "architecture": fields["Architecture"],
        "source": source or fields["Package"],
        "source_version": version.strip("()") or fields["Version"],
        "maintainer": fields.get("Maintainer", ""),
        "depends": ", ".join(filter(None, (fields.get("Pre-Depends"), fields.get("Depends")))),
        "provides": fields.get("Provides", ""),
        "licenses": licenses(copyright_text(fields["Package"], paths)),
    }


def copyright_text(package: str, paths: Mapping[str, str]) -> str:
    """The copyright file of a package; empty if the image has none. Links count by the image's paths, and lead to no file outside."""
    path = COPYRIGHT.format(package)
    for _ in range(LINKS):
        folder = os.path.dirname(path)
        at = next((place for place in (path, folder) if os.path.islink(paths.get(place, ""))), "")
        if not at:
            return _text(paths.get(path, ""))
        target = os.path.join("/", os.path.dirname(at), os.readlink(paths[at]), os.path.relpath(path, at))
        path = os.path.normpath(target).lstrip("/")
    return ""


def _text(place: str) -> str:
    """The text of a file; empty if there is none, or it has more than we read."""
    if not os.path.isfile(place) or os.path.islink(place) or os.path.getsize(place) > LARGEST:
        return ""
    return Path(place).read_text("utf-8", "replace")


def licenses(text: str) -> list[str]:
    """The names of licences in a copyright file that machines can read, each once, by name."""
    head = text[:500]
    if not re.search(r"^Format:.*copyright-format", head, re.MULTILINE):
        return []
    return sorted({name.strip() for name in re.findall(r"^License:[ \t]*(\S.*)$", text, re.MULTILINE)})


def _python(place: Path) -> dict[str, Any]:
    if not place.is_file():  # a link that leads nowhere, or a folder
        return {}
    fields = HeaderParser().parsestr(place.read_text("utf-8-sig", "replace"))
    first = {name: str(fields.get(name, "")).strip() for name in ("Name", "Version", *AUTHORS, *LICENSES)}
    if not first["Name"] or not first["Version"]:
        return {}
    classifiers = [str(text) for text in fields.get_all("Classifier", []) if str(text).startswith("License ::")]
    return {
        "name": first["Name"],
        "version": first["Version"],
        "author": next((first[name] for name in AUTHORS if first[name]), ""),
        "licenses": [text for text in (*(first[name] for name in LICENSES), *classifiers) if text],
        "requires": [str(text) for text in fields.get_all("Requires-Dist", [])],
    }


AUTHORS = ("Author", "Author-email", "Maintainer", "Maintainer-email")
LICENSES = ("License-Expression", "License")
"""Fields of a wheel, the most telling first: https://packaging.python.org/specifications/core-metadata/"""


def _ros(place: Path) -> dict[str, Any]:
    try:
        root = ElementTree.parse(str(place)).getroot()
    except (ElementTree.ParseError, LookupError, ValueError, OSError):
        return {}
    fields = [(item.tag.rpartition("}")[2], (item.text or "").strip()) for item in root if isinstance(item.tag, str)]
    first = dict(fields[::-1])
    name = first.get("name", "")
    if not name:
        return {}
    return {
        "name": name,
        "version": first.get("version", ""),
        "maintainer": first.get("maintainer", ""),
        "licenses": [text for tag, text in fields if tag == "license" and text],
        "depends": sorted({text for tag, text in fields if text and tag in NEEDS}),
    }


NEEDS = ("depend", "run_depend", "exec_depend", "build_export_depend")
"""What names a package that another one needs when it runs: https://ros.org/reps/rep-0149.html"""


def _sorted(items: Iterable[dict[str, Any]]) -> list[dict[str, Any]]:
    """Each once, without those that say nothing."""
    by_name = {(item["name"], item["version"], item.get("architecture", "")): item for item in items if item}
    return [by_name[name] for name in sorted(by_name)]


def main(root: Path, out: Path) -> None:
    write(files([root]), status(root).values(), owned(root), out)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
