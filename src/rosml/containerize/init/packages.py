"""The ROS packages of a folder, and what their manifests and sources name. Reads files and starts nothing."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from rosml.base import files
from rosml.containerize import within
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.packages import manifest, workspace
from rosml.containerize.packages.manifest import Package

LARGEST = 1 << 20

MOST_FILES = 20_000

LANGUAGES = {
    "C++": (".cpp", ".cc", ".cxx", ".c", ".hpp", ".hh", ".h", ".cu"),
    "Python": (".py",),
}

PIP = "requirements.txt"
"""The file in which Python packages name what pip is to install."""

REPOS = ".repos"

Libraries = Mapping[str, Collection[str]]
"""Names of libraries, and the words by which manifests and sources name each, in small letters."""


@dataclass(frozen=True)
class Mention:
    """Where a library is named first, such as `src/node.py:3`. rosdep installs one that a manifest names."""

    place: str
    word: str
    by_manifest: bool


@dataclass(frozen=True)
class FolderScan:
    """What a folder has. `pip` are files of requirements, `repos` lists of upstream repositories, relative to it."""

    packages: tuple[Package, ...]
    mentions: Mapping[str, Mention] = field(default_factory=dict)
    pip: tuple[str, ...] = ()
    repos: tuple[str, ...] = ()


def find(folder: Path, libraries: Libraries) -> FolderScan:
    """Finds the packages of a folder, as `rosml containerize` does, and where they mention libraries."""
    ignored = IgnoredFiles(folder)
    manifests = manifest.read(folder, ignored)
    if not manifests:
        raise workspace.none_in(folder)
    budget = iter(range(MOST_FILES))
    scans = [_scan(package, folder, ignored, libraries, budget) for package, _ in manifests]
    paths = dict.fromkeys([Path(PIP), *(package.folder / PIP for package, _ in manifests)])
    pip = [str(path) for path in paths if (folder / path).is_file() and within.is_inside(folder / path, folder)]
    pip = [name for name in pip if name.isprintable()]
    mentions = [_in_manifests(manifests, libraries), *(of_package for _, of_package in scans)]
    if PIP in pip:
        mentions.append(_in_text(folder / PIP, PIP, _text(folder / PIP), libraries))
    lists = (file for file in _files(folder, ignored) if REPOS in (file.suffix, file.name))
    repos = sorted(name for file in lists if (name := str(file.relative_to(folder))).isprintable())
    return FolderScan(tuple(package for package, _ in scans), _first(mentions), tuple(pip), tuple(repos))


Mentions = Mapping[str, Mention]


def _first(mentions: Iterable[Mentions]) -> Mentions:
    first: dict[str, Mention] = {}
    for item in mentions:
        first = {**item, **first}
    return first


def _in_manifests(manifests: Sequence[tuple[Package, str]], libraries: Libraries) -> Mentions:
    names = {package.name for package, _ in manifests}
    mentions: dict[str, Mention] = {}
    for package, text in manifests:
        for key in sorted(package.needs - names):
            line = text.count("\n", 0, max(text.find(f">{key}<"), 0)) + 1
            for library in _meant(libraries, key):
                mentions.setdefault(library, Mention(f"{package.manifest}:{line}", key, by_manifest=True))
    return mentions


def _scan(
    package: Package, folder: Path, ignored: IgnoredFiles, libraries: Libraries, budget: Iterator[int]
) -> tuple[Package, Mentions]:
    """A package with what its files say, and what they mention. `budget` has an item for each source file that may still be read."""
    languages, launches, scripts = set[str](), list[str](), list[str]()
    mentions: Mentions = {}
    for file in _files(folder / package.folder, ignored):
        in_launch = file.parent.name == "launch"
        if file.name not in _SETUP and not in_launch:
            languages |= {name for name, ends in LANGUAGES.items() if file.suffix in ends}
        if in_launch and _LAUNCH.search(file.name):
            launches.append(file.name)
        if _patterns(file) and next(budget, None) is not None:
            text = _text(file)
            mentions = _first([mentions, _in_text(file, str(file.relative_to(folder)), text, libraries)])
            scripts += _SCRIPT.findall(text) if file.name in _SETUP else ()
    ordered = tuple(name for name in LANGUAGES if name in languages)
    scripts = list(dict.fromkeys(scripts))
    return replace(package, languages=ordered, launches=tuple(sorted(launches)), scripts=tuple(scripts)), mentions


def _text(file: Path) -> str:
    with contextlib.suppress(OSError):
        return files.limited(file, LARGEST).decode("utf-8", "replace")
    return ""


def _in_text(file: Path, path: str, text: str, libraries: Libraries) -> Mentions:
    """What a file's text mentions first; `path` is shown to people."""
    mentions: dict[str, Mention] = {}
    for match in (match for pattern in _patterns(file) for match in pattern.finditer(text)):
        for word in match[1].split(","):
            name = word.strip().partition(" ")[0]
            for library in _meant(libraries, name):
                if library not in mentions:
                    line = text.count("\n", 0, match.start(1)) + 1
                    mentions[library] = Mention(f"{path}:{line}", name, by_manifest=False)
    return mentions


def _files(place: Path, ignored: IgnoredFiles) -> Iterator[Path]:
    for path, folders, names in os.walk(place):
        folders[:] = sorted(
            name for name in folders if not name.startswith(".") and not ignored.whole(Path(path, name))
        )
        for name in sorted(names):
            file = Path(path, name)
            if not file.is_symlink() and file.is_file() and not ignored(file):
                yield file


_SETUP = ("setup.py", "setup.cfg")
"""Files of a Python package that say what it installs."""

_LAUNCH = re.compile(r"(\.launch|\.launch\.(py|xml|ya?ml)|_launch\.(py|xml|ya?ml))$")
_SCRIPT = re.compile(r"""(?:^|["'])[ \t]*([\w.-]+)[ \t]*=[ \t]*[\w.]+:\w""", re.MULTILINE)
_PYTHON = (
    re.compile(r"^[ \t]*from[ \t]+([A-Za-z_]\w*)[\w.]*[ \t]+import\b", re.MULTILINE),
    re.compile(r"^[ \t]*import[ \t]+([\w., \t]+)", re.MULTILINE),
)
_INCLUDES = (re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^/>"\n]+)', re.MULTILINE),)
_CMAKE = (re.compile(r"^[ \t]*find_package[ \t]*\([ \t]*(\w+)", re.MULTILINE | re.IGNORECASE),)
_REQUIREMENTS = (re.compile(r"^([A-Za-z][\w.-]*)(?=[ \t]*(?:$|[<>=~!;\[#]))", re.MULTILINE),)
_INSTALLED = (re.compile(r"""["']([A-Za-z][\w.-]*)(?:[<>=~!;\[][^"'\n]*)?["'][ \t]*[,\]\n]"""),)


def _patterns(file: Path) -> tuple[re.Pattern[str], ...]:
    """How a file names libraries; none if it names none."""
    if file.name == PIP:
        return _REQUIREMENTS
    if file.name in _SETUP:
        return _INSTALLED
    if file.name == workspace.PLAIN or file.suffix == ".cmake":
        return _CMAKE
    if file.suffix in LANGUAGES["Python"]:
        return _PYTHON
    return _INCLUDES if file.suffix in LANGUAGES["C++"] else ()


def _meant(libraries: Libraries, word: str) -> Iterator[str]:
    """The libraries that a word names, as a whole or by a piece of it: `python3-pytorch-pip`."""
    pieces = {word.lower(), *re.split(r"[^a-z0-9]+", word.lower())}
    return (library for library, words in libraries.items() if pieces.intersection(words))
