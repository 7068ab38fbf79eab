#!/usr/bin/env python3
"""Lists the packages of an image in OUT/packages.json, and its files in OUT/files.gz: contents.py ROOT OUT"""

from __future__ import annotations

import contextlib
import functools
import gzip
import hashlib
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

DEBS = "usr/local/share/rosml/debs.txt"
"""The hashes of packages' archives, as components/build/deb_hashes.sh notes them: name, architecture, version, hash."""

FOLDER = re.compile(r"(docker-ros/ws/install/([^/]+))/share/\2/package\.xml")
"""What says that a folder has one ROS package alone."""

HASHED = 256 << 20
"""The most bytes of a ROS package that are read for its hash: some bring models."""

DIGEST = re.compile(r"[0-9a-f]{64}|[0-9a-f]{128}")
"""SHA-256 or SHA-512."""

NAME = re.compile(r"[^/\s\x00-\x1f]")
"""What a package's name has, or no SBOM can name it."""

LONGEST, MOST = 10_000, 1_000
"""The most characters of what a package says, and the most licences and requirements."""

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
    python = [path for path in paths if PYTHON.fullmatch(path) and path not in others]
    digests, folders = deb_digests(paths.get(DEBS, "")), _folders(paths)
    return {
        "system": _system(paths),
        "apt": _sorted(_debian(text, paths, digests) for text in [*entries, *brought(paths)]),
        "python": _sorted(_python(path, paths) for path in python),
        "ros": _sorted(_ros(path, paths, folders) for path in paths if ROS.fullmatch(path)),
    }


def deb_digests(place: str) -> dict[tuple[str, ...], str]:
    """The hashes of archives by name, architecture and version; none if there is no such file."""
    lines = (line.split(" ") for line in _text(place).split("\n"))
    return {tuple(words[:3]): words[3] for words in lines if len(words) == 4 and DIGEST.fullmatch(words[3])}


def _folders(paths: Mapping[str, str]) -> dict[str, list[str]]:
    """The files of each folder of the install space that has one ROS package alone, without links, by path."""
    matches = (FOLDER.fullmatch(path) for path in paths)
    folders: dict[str, list[str]] = {match.group(1): [] for match in matches if match}
    for path in sorted(paths) if folders else ():
        folder = "/".join(path.split("/", 4)[:4])
        if folder in folders and _is_regular(paths[path]):
            folders[folder].append(path)
    return folders


def write(paths: dict[str, str], entries: Iterable[str], others: Container[str], out: Path) -> None:
    """Writes OUT/packages.json and OUT/files.gz: the same for the same image, on any day."""
    out.mkdir(exist_ok=True)
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
    return {
        "name": fields.get("ID", ""),
        "version": fields.get("VERSION_ID", ""),
        "vendor": fields.get("NAME", ""),
        "home": fields.get("HOME_URL", ""),
    }


_OF_DEBIAN = re.compile(
    r"^(Package|Architecture|Version|Source|Maintainer|Depends|Pre-Depends|Provides|SHA256|SHA512): (.*)$", re.MULTILINE
)


def _debian(text: str, paths: Mapping[str, str], digests: Mapping[tuple[str, ...], str]) -> dict[str, Any]:
    fields = dict(_OF_DEBIAN.findall(text))
    if not fields.keys() >= {"Package", "Architecture", "Version"}:
        return {}
    key = (fields["Package"], fields["Architecture"], fields["Version"])
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
        "digest": fields.get("SHA512") or fields.get("SHA256") or digests.get(key, ""),
    }


def copyright_text(package: str, paths: Mapping[str, str]) -> str:
    """The copyright file of a package; empty if the image has none. Links count by the image's paths, and lead to no file outside."""
    path = COPYRIGHT.format(package)
    for _ in range(LINKS):
        folder = os.path.dirname(path)
        at = next((place for place in (path, folder) if os.path.islink(paths.get(place, ""))), "")
        if not at:
            text = _text(paths.get(path, ""))
            return text if len(text) < LARGEST else ""
        target = os.path.join("/", os.path.dirname(at), os.readlink(paths[at]), os.path.relpath(path, at))
        path = os.path.normpath(target).lstrip("/")
    return ""


def _text(place: str, encoding: str = "utf-8") -> str:
    return _bytes(place).decode(encoding, "replace").replace("\r\n", "\n")


def _bytes(place: str) -> bytes:
    """The beginning of a file, as far as we read; empty if there is none, or it is a link, which may lead outside."""
    if not _is_regular(place):
        return b""
    with open(place, "rb") as file:
        return file.read(LARGEST)


def _is_regular(place: str) -> bool:
    return os.path.isfile(place) and not os.path.islink(place)


def licenses(text: str) -> list[str]:
    """The names of licences in a copyright file that machines can read, each once, by name."""
    head = text[:500]
    if not re.search(r"^Format:.*copyright-format", head, re.MULTILINE):
        return []
    return sorted({name.strip() for name in re.findall(r"^License:[ \t]*(\S.*)$", text, re.MULTILINE)})


def _python(path: str, paths: Mapping[str, str]) -> dict[str, Any]:
    fields = HeaderParser().parsestr(_text(paths[path], "utf-8-sig"))
    first = {name: str(fields.get(name, "")).strip() for name in ("Name", "Version", *AUTHORS, *LICENSES)}
    if not first["Name"] or not first["Version"]:
        return {}
    classifiers = [str(text) for text in fields.get_all("Classifier", []) if str(text).startswith("License ::")]
    folder = os.path.dirname(path) if path.endswith(("/METADATA", "/PKG-INFO")) else path
    record = f"{folder}/RECORD"
    return {
        "name": first["Name"],
        "version": first["Version"],
        "author": person(first["Author"], first["Author-email"])
        or person(first["Maintainer"], first["Maintainer-email"]),
        "licenses": [text for text in (*(first[name] for name in LICENSES), *classifiers) if text],
        "requires": [str(text) for text in fields.get_all("Requires-Dist", [])],
        "file": wheel(os.path.basename(folder), _text(paths.get(f"{folder}/WHEEL", ""))),
        "record": record if record in paths else "",
        "digest": sha512(paths.get(record, "")),
    }


def person(name: str, address: str) -> str:
    """Somebody by name and address, as mail has them. Both fields may have several people; the address may have the name already."""
    if name and re.fullmatch(r"[^\s<>,]+@[^\s<>,]+", address):
        return f"{name} <{address}>"
    return address if "<" in address or not name else name


def wheel(folder: str, text: str) -> str:
    """The file name of a wheel by what its folder's WHEEL says; that of the folder if several names would say the same.

    A name has all values of a tag, by name; maturin has them as in WHEEL: https://packaging.python.org/specifications/platform-compatibility-tags/
    """
    tags = [tag.split("-") for tag in re.findall(r"^Tag: (\S+)$", text, re.MULTILINE)]
    if not tags or any(len(tag) != 3 for tag in tags) or not folder.endswith(".dist-info"):
        return folder
    values = [list(dict.fromkeys(tag[place] for tag in tags)) for place in range(3)]
    if any(value != sorted(value) for value in values) and not re.search("^Generator: maturin", text, re.MULTILINE):
        return folder
    build = re.findall(r"^Build: (\S+)$", text, re.MULTILINE)[:1]
    return "-".join([folder[: -len(".dist-info")], *build, *map(".".join, values)]) + ".whl"


def sha512(place: str) -> str:
    """The hash of a file; empty if there is none, or it is a link."""
    if not _is_regular(place):
        return ""
    state = hashlib.sha512()
    with open(place, "rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            state.update(block)
    return state.hexdigest()


def sha512_of_all(files: Sequence[str], paths: Mapping[str, str]) -> str:
    """The hash of what sha512sum says of files; empty if there are none, or too much to read."""
    if not files or sum(os.path.getsize(paths[path]) for path in files) > HASHED:
        return ""
    lines = (f"{sha512(paths[path])}  {path}\n" for path in files)
    return hashlib.sha512(os.fsencode("".join(lines))).hexdigest()


AUTHORS = ("Author", "Author-email", "Maintainer", "Maintainer-email")
LICENSES = ("License-Expression", "License")
"""Fields of a wheel, the most telling first: https://packaging.python.org/specifications/core-metadata/"""


def _ros(path: str, paths: Mapping[str, str], folders: Mapping[str, list[str]]) -> dict[str, Any]:
    text = _bytes(paths[path])
    try:
        root = ElementTree.fromstring(b"" if b"<!ENTITY" in text else text)  # some need all memory
    except (ElementTree.ParseError, LookupError, ValueError):
        return {}
    fields = [(item.tag.rpartition("}")[2], (item.text or "").strip()) for item in root if isinstance(item.tag, str)]
    first = dict(fields[::-1])
    addresses = [item.get("email", "") for item in root if str(item.tag).rpartition("}")[2] == "maintainer"]
    folder = FOLDER.fullmatch(path)
    files = folders.get(folder.group(1), []) if folder else []
    return {
        "name": first.get("name", ""),
        "version": first.get("version", ""),
        "maintainer": person(first.get("maintainer", ""), addresses[0] if addresses else ""),
        "licenses": [text for tag, text in fields if tag == "license" and text],
        "depends": sorted({text for tag, text in fields if text and tag in NEEDS}),
        "folder": folder.group(1) if folder else "",
        "executable": any(os.access(paths[path], os.X_OK) for path in files),
        "digest": sha512_of_all(files, paths),
    }


NEEDS = ("depend", "run_depend", "exec_depend", "build_export_depend")
"""What names a package that another one needs when it runs: https://ros.org/reps/rep-0149.html"""


def _sorted(items: Iterable[dict[str, Any]]) -> list[dict[str, Any]]:
    """Each once, without those that say nothing."""
    limited = [_limited(item) for item in items if NAME.search(item.get("name", ""))]
    by_name = {(item["name"], item["version"], item.get("architecture", "")): item for item in limited}
    return [by_name[name] for name in sorted(by_name)]


def _limited(item: dict[str, Any]) -> dict[str, Any]:
    """A package without what nobody reads: strangers wrote it."""
    lists = {key: [text[:LONGEST] for text in value[:MOST]] for key, value in item.items() if isinstance(value, list)}
    texts = {key: value[:LONGEST] for key, value in item.items() if isinstance(value, str)}
    return {**item, **lists, **texts}


def main(root: Path, out: Path) -> None:
    write(files([root]), status(root).values(), owned(root), out)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
