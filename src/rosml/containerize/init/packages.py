"""The ROS packages of a folder, and what their manifests and sources name. Reads files and starts nothing."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from rosml.base import files
from rosml.containerize import inputs, within
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.init import cmake_programs
from rosml.containerize.packages import manifest, workspace
from rosml.containerize.packages.manifest import Package

LARGEST = 1 << 20

MOST_FILES = 20_000

LANGUAGES = {
    "C++": (".cpp", ".cc", ".cxx", ".c", ".hpp", ".hh", ".h", ".cu"),
    "Python": (".py",),
}

REPOS = ".repos"

ADDITIONAL = ("additional-debs-file", "additional-pip-file", "blacklisted-packages-file")
"""Inputs that name a list in the repository, as docker-ros has them."""

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
    """What a folder has. `pip` are files of requirements, `repos` lists of upstream repositories, `additional` those of the inputs
    `ADDITIONAL`; all relative to it."""

    packages: tuple[Package, ...]
    mentions: Mapping[str, Mention] = field(default_factory=dict)
    pip: tuple[str, ...] = ()
    repos: tuple[str, ...] = ()
    additional: Mapping[str, str] = field(default_factory=dict)


def find(folder: Path, libraries: Libraries, env: Mapping[str, str] | None = None) -> FolderScan:
    """Finds the packages of a folder, as `rosml containerize` does, and where they mention libraries. `env` has the variables of its
    `.env`."""
    ignored = IgnoredFiles(folder)
    manifests = manifest.read(folder, ignored)
    if not manifests:
        raise workspace.none_in(folder)
    mentions, names = _Mentions(libraries), {package.name for package, _ in manifests}
    for package, text in manifests:
        for key in sorted(package.needs - names):
            mentions.add(key, text, max(text.find(f">{key}<"), 0), package.manifest, by_manifest=True)
    budget = iter(range(MOST_FILES))
    packages = tuple(_scanned(package, folder, ignored, mentions, budget) for package, _ in manifests)
    paths = dict.fromkeys([Path(workspace.PIP), *(package.folder / workspace.PIP for package in packages)])
    pip = [str(path) for path in paths if _is_list(folder, str(path))]
    if workspace.PIP in pip:
        _read(folder / workspace.PIP, workspace.PIP, mentions, _REQUIREMENTS)
    additional = _additional(folder, env or {})
    for name, pattern in (("additional-pip-file", _REQUIREMENTS), ("additional-debs-file", _DEBS)):
        if (path := additional.get(name)) and path not in pip:
            _read(folder / path, path, mentions, pattern)
    lists = (file for file in _files(folder, ignored) if REPOS in (file.suffix, file.name))
    repos = sorted(name for file in lists if (name := str(file.relative_to(folder))).isprintable())
    return FolderScan(packages, mentions, tuple(pip), tuple(repos), additional)


def _is_list(folder: Path, name: str) -> bool:
    try:
        return (folder / name).is_file() and within.is_inside(folder / name, folder) and name.isprintable()
    except OSError:  # such as a name that is too long
        return False


def _additional(folder: Path, env: Mapping[str, str]) -> dict[str, str]:
    """The lists that `.env` names, or docker-ros reads, or that lie at the top with docker-ros' name."""
    lists = dict[str, str]()
    for name in ADDITIONAL:
        usual, of_env = inputs.default(name), env.get(name.upper().replace("-", "_"))
        places = (usual, Path(usual).name) if of_env is None else (of_env,)
        if path := next((place for place in places if place and _is_list(folder, place)), ""):
            lists[name] = path
    return lists


class _Mentions(dict[str, Mention]):
    """Where each library is named first."""

    def __init__(self, libraries: Libraries) -> None:
        super().__init__()
        self._libraries = libraries

    def add(self, name: str, text: str, place: int, path: str, by_manifest: bool = False) -> None:
        """Adds the libraries that a word means, as a whole or by a piece of it: `python3-pytorch-pip`. `path` is shown to people."""
        pieces = {name.lower(), *re.split(r"[^a-z0-9]+", name.lower())}
        for library, words in self._libraries.items():
            if library not in self and not pieces.isdisjoint(words):
                line = text.count("\n", 0, place) + 1
                self[library] = Mention(f"{path}:{line}", name, by_manifest)


def _scanned(
    package: Package, folder: Path, ignored: IgnoredFiles, mentions: _Mentions, budget: Iterator[int]
) -> Package:
    """A package with what its files say. `budget` has an item for each source file that may still be read."""
    languages, launches, programs = set[str](), list[str](), list[str]()
    for file in _files(folder / package.folder, ignored):
        in_launch = file.parent.name == "launch"
        if file.name not in _SETUP and not in_launch:
            languages |= {name for name, ends in LANGUAGES.items() if file.suffix in ends}
        if in_launch and _LAUNCH.search(file.name):
            launches.append(file.name)
        if _patterns(file) and next(budget, None) is not None:
            text = _read(file, str(file.relative_to(folder)), mentions)
            if file.name in _SETUP:
                programs += _SCRIPT.findall(text)
            elif file.name == workspace.PLAIN:
                programs += cmake_programs.installed(text)
    ordered = tuple(name for name in LANGUAGES if name in languages)
    unique = tuple(dict.fromkeys(programs))
    return replace(package, languages=ordered, launches=tuple(sorted(launches)), programs=unique)


def _read(file: Path, path: str, mentions: _Mentions, patterns: tuple[re.Pattern[str], ...] | None = None) -> str:
    text = ""
    with contextlib.suppress(OSError):
        text = files.limited(file, LARGEST).decode("utf-8", "replace")
    for match in (match for pattern in patterns or _patterns(file) for match in pattern.finditer(text)):
        for word in match[1].split(","):
            mentions.add(word.strip().partition(" ")[0], text, match.start(1), path)
    return text


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
_DEBS = (re.compile(r"^[ \t]*([a-z0-9][a-z0-9.+-]*)", re.MULTILINE),)
_INSTALLED = (re.compile(r"""["']([A-Za-z][\w.-]*)(?:[<>=~!;\[][^"'\n]*)?["'][ \t]*[,\]\n]"""),)


def _patterns(file: Path) -> tuple[re.Pattern[str], ...]:
    """How a file names libraries; none if it names none."""
    if file.name in _SETUP:
        return _INSTALLED
    if file.name == workspace.PLAIN or file.suffix == ".cmake":
        return _CMAKE
    if file.suffix in LANGUAGES["Python"]:
        return _PYTHON
    return _INCLUDES if file.suffix in LANGUAGES["C++"] else ()
