"""The ROS packages of a folder, and what their manifests and sources name. Reads files and starts nothing."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from rosml.base import files
from rosml.containerize import within
from rosml.containerize.packages import manifest, workspace
from rosml.containerize.packages.ignored import LeftOut
from rosml.containerize.packages.manifest import Package

LARGEST = 1 << 20
"""The most bytes that are read of a source file."""

MOST_FILES = 20_000
"""The most source files that are read."""

LANGUAGES = {
    "C++": (".cpp", ".cc", ".cxx", ".c", ".hpp", ".hh", ".h", ".cu"),
    "Python": (".py",),
}
"""Languages, and the ends of the names of their files."""

PIP = "requirements.txt"
"""The file in which Python packages name what pip is to install."""

REPOS = ".repos"
"""The end of the names of files that list upstream repositories."""

Libraries = Mapping[str, Collection[str]]
"""Names of libraries, and the words by which manifests and sources name each, in small letters."""


@dataclass(frozen=True)
class Named:
    """Where a library is named first.

    Attributes:
        place: the file, relative to the folder, and its line: `src/node.py:3`.
        word: the name as it stands there.
        manifest: a package.xml names it, so that rosdep installs it.
    """

    place: str
    word: str
    manifest: bool


@dataclass(frozen=True)
class Found:
    """What a folder has.

    Attributes:
        packages: its packages, in the order of their paths.
        named: the libraries that are named, and where first.
        pip: files of requirements for pip, relative to the folder.
        repos: lists of upstream repositories, likewise.
    """

    packages: tuple[Package, ...]
    named: Mapping[str, Named] = field(default_factory=dict)
    pip: tuple[str, ...] = ()
    repos: tuple[str, ...] = ()


def find(folder: Path, libraries: Libraries) -> Found:
    """Finds the packages of a folder, as `rosml containerize` does.

    Args:
        libraries: what to look for in manifests and sources.

    Raises:
        RosmlError: there is no package, or a manifest cannot be read (exit code 2).
    """
    left = LeftOut(folder)
    read = manifest.read(folder, left)
    if not read:
        raise workspace.none_in(folder)
    own = {package.name for package, _ in read}
    named = dict[str, Named]()
    for package, text in read:
        for key in sorted(package.needs - own):
            for library in _meant(libraries, key):
                if library not in named:
                    line = text.count("\n", 0, max(text.find(f">{key}<"), 0)) + 1
                    named[library] = Named(f"{package.manifest}:{line}", key, manifest=True)
    rest = iter(range(MOST_FILES))
    packages = tuple(_with_files(package, folder, left, named, libraries, rest) for package, _ in read)
    pip = [str(path) for path in dict.fromkeys([Path(PIP), *(package.folder / PIP for package in packages)])]
    pip = [
        name
        for name in pip
        if name.isprintable() and (folder / name).is_file() and within.is_own(folder / name, folder)
    ]
    if PIP in pip:
        _sources(folder / PIP, PIP, named, libraries)
    lists = (file for file in _files(folder, folder, left) if REPOS in (file.suffix, file.name))
    repos = sorted(name for file in lists if (name := str(file.relative_to(folder))).isprintable())
    return Found(packages, named, tuple(pip), tuple(repos))


def _with_files(
    package: Package, folder: Path, left: LeftOut, named: dict[str, Named], libraries: Libraries, rest: Iterator[int]
) -> Package:
    """A package with what its files say.

    Args:
        rest: has an item for each source file that may still be read.
    """
    languages, launches, scripts = set[str](), list[str](), list[str]()
    for file in _files(folder / package.folder, folder, left):
        if file.name not in _SETUP:
            languages |= {
                name for name, ends in LANGUAGES.items() if file.suffix in ends and file.parent.name != "launch"
            }
        if file.parent.name == "launch" and _LAUNCH.search(file.name):
            launches.append(file.name)
        if _patterns(file) and next(rest, None) is not None:
            text = _sources(file, str(file.relative_to(folder)), named, libraries)
            if file.name in _SETUP:
                scripts += _SCRIPT.findall(text)
    spoken = tuple(name for name in LANGUAGES if name in languages)
    return replace(package, languages=spoken, launches=tuple(sorted(launches)), scripts=tuple(dict.fromkeys(scripts)))


def _sources(file: Path, shown: str, named: dict[str, Named], libraries: Libraries) -> str:
    """Notes the libraries that a file names. Returns its text."""
    text = ""
    with contextlib.suppress(OSError):
        text = files.limited(file, LARGEST).decode("utf-8", "replace")
    for match in (match for pattern in _patterns(file) for match in pattern.finditer(text)):
        for word in match[1].split(","):
            name = word.strip().partition(" ")[0]
            for library in _meant(libraries, name):
                if library not in named:
                    line = text.count("\n", 0, match.start(1)) + 1
                    named[library] = Named(f"{shown}:{line}", name, manifest=False)
    return text


def _files(place: Path, root: Path, left: LeftOut) -> Iterator[Path]:
    """The files below a place that the builder gets, without hidden folders and without links."""
    for path, folders, names in os.walk(place):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and not left.whole(Path(path, name)))
        for name in sorted(names):
            file = Path(path, name)
            if not file.is_symlink() and file.is_file() and not left(file):
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
