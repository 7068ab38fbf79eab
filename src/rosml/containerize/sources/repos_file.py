"""`.repos` files, as vcstool and vcs2l read them: finds them, and reads their repositories.

Newer releases of vcs2l have `extends`: a file, or a list of files, beside this one. If two of them name one path, the later one
counts; the file's own repositories count before all of them.

A file that is a list has the format of rosinstall: `- git: {local-name: PATH, uri: URL, version: VERSION}`.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any, NoReturn

import yaml

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import near
from rosml.containerize import within
from rosml.containerize.sources import urls

KEYS = ("type", "url", "version")
"""The keys of a repository."""

VERSIONS = ("branch", "tag", "commit", "ref", "rev", "revision", "hash", "sha", "checkout")
"""Words that people write instead of `version`."""

ROSINSTALL = {"local-name": "path", "uri": "url", "version": "version"}
"""The keys of a repository in a file of rosinstall, and our names for them."""

EXTENDS = 10
"""The most files that may extend each other in a chain."""

MERGE = "tag:yaml.org,2002:merge"
"""YAML's tag of a key `<<`: the mapping also has the keys of its value, unless it has them itself."""

IGNORE = "COLCON_IGNORE"
"""If a folder has a file of this name, its packages and `.repos` files do not count."""


@dataclass(frozen=True)
class Entry:
    """One repository of a `.repos` file.

    Attributes:
        path: its folder, below that for upstream sources.
        url: its URL, without a user and a password, except the user of ssh.
        version: as written; empty for the default branch.
        file: the name of the `.repos` file.
        line: the line of the path.
    """

    path: str
    url: str
    version: str
    file: str
    line: int

    @property
    def place(self) -> str:
        """Its place: `file:line`."""
        return f"{self.file}:{self.line}"

    def same(self, other: Entry) -> bool:
        """Whether both name the same version of the same repository."""
        return urls.key(self.url) == urls.key(other.url) and self.version == other.version


def found(folder: Path, without: tuple[Path, ...] = ()) -> list[Path]:
    """The `.repos` files below a folder, sorted. Those in `.git` and below COLCON_IGNORE do not count.

    Args:
        without: folders to leave out, resolved.

    Raises:
        RosmlError: a file is a link that leads out of the folder (exit code 2).
        OSError: a folder cannot be read.
    """
    files: list[Path] = []
    for name, folders, names in os.walk(folder, onerror=_raise):
        here = Path(name)
        if IGNORE in names or IGNORE in folders or here.resolve() in without:
            folders.clear()
            continue
        folders[:] = [below for below in folders if below != ".git"]
        files += [here / below for below in names if below.endswith(".repos") and (here / below).is_file()]
    for file in files:
        if not file.resolve().is_relative_to(folder.resolve()):
            raise RosmlError(f"{file}: a link that leads out of {folder}", "replace it by the file", exit_code=2)
    return sorted(files)


def _raise(error: OSError) -> None:
    raise error


def read(files: Iterable[Path], folder: Path, prefix: str, local: bool) -> list[Entry]:
    """The repositories that `.repos` files of a folder name. If one file extends another, the other counts as a part of it.

    Args:
        prefix: the beginning of their paths in messages.
        local: whether they may name repositories of this machine.

    Raises:
        RosmlError: a file cannot be read, or names something that is not allowed (exit code 2).
    """
    reader = _Reader(folder, prefix, local)
    found = {file: reader.entries(file, ()) for file in files}
    return [entry for file in found if file.resolve() not in reader.extended for entry in found[file].values()]


class _Reader:
    """Reads files of a folder, each once.

    Attributes:
        extended: files that others extend, resolved.
    """

    def __init__(self, folder: Path, prefix: str, local: bool) -> None:
        self._folder, self._prefix, self._local = folder, prefix, local
        self._known: dict[Path, dict[str, Entry]] = {}
        self.extended: set[Path] = set()

    def entries(self, file: Path, above: tuple[Path, ...]) -> dict[str, Entry]:
        """The repositories of a file, by path. `above`: the files that led here by `extends`."""
        place = file.resolve()
        if place not in self._known:
            self._known[place] = self._read(file, (*above, place))
        return self._known[place]

    def _read(self, file: Path, above: tuple[Path, ...]) -> dict[str, Entry]:
        name = f"{self._prefix}{os.path.relpath(file, self._folder)}"
        node = _parsed(file, name)
        if _is_empty(node):
            return {}
        if isinstance(node, yaml.SequenceNode):
            return {entry.path: entry for entry in _of_rosinstall(name, node, self._local)}
        top = _mapping(node, name, "the file")
        listed, extends = top.pop("repositories", None), top.pop("extends", None)
        if listed is None and extends is None:
            _refuse(name, node, "no key 'repositories'")
        _require_known(name, top, ("repositories", "extends"), listed)
        found: dict[str, Entry] = {}
        for item, parent in self._parents(file, name, extends[1]) if extends else ():
            if parent.resolve() in above:
                _refuse(name, item, f"it extends {item.value}, which extends it", "take one of the two out")
            if len(above) > EXTENDS:
                _refuse(name, item, f"more than {EXTENDS} files extend each other", "write them as fewer")
            self.extended.add(parent.resolve())
            found |= self.entries(parent, above)
        if listed is not None and not _is_empty(listed[1]):
            for key, value in _mapping(listed[1], name, "repositories").values():
                entry = _entry(name, key, dict(_texts(name, key.value, value, KEYS)), self._local)
                found[entry.path] = entry
        return found

    def _parents(self, file: Path, name: str, node: Any) -> Iterator[tuple[Any, Path]]:
        """The files that a file extends, each with its node."""
        said: set[str] = set()
        for item in node.value if isinstance(node, yaml.SequenceNode) else [node]:
            if not isinstance(item, yaml.ScalarNode) or not item.value or not item.value.isprintable():
                _refuse(name, item, "extends is no file", "name a .repos file, or a list of them")
            if item.value in said:
                _refuse(name, item, f"extends has {item.value} twice", "keep one of them")
            said.add(item.value)
            path = file.parent / item.value
            try:
                there = within.there(path, self._folder)
            except RosmlError as error:
                _refuse(name, item, f"it extends {item.value}: {error.message}", error.remedy)
            if not there:
                _refuse(name, item, f"it extends {item.value}, and there is no such file beside it", "check its name")
            yield item, path


def _parsed(file: Path, name: str) -> Any:
    try:
        return untrusted.yaml_node(files.limited(file, untrusted.SIZE).decode("utf-8-sig"))
    except OSError as error:
        raise RosmlError(f"{name}: cannot be read: {error.strerror}", "make it readable", exit_code=2) from None
    except UnicodeDecodeError:
        raise RosmlError(f"{name}: not UTF-8", "save the file as UTF-8", exit_code=2) from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        what = getattr(error, "problem", None) or "a character that YAML does not allow"
        raise RosmlError(f"{name}:{mark.line + 1 if mark else 1}: not YAML: {what}", _FORMAT, exit_code=2) from None


_FORMAT = "write it as 'repositories: {PATH: {type: git, url: URL, version: VERSION}}'"

_ROSINSTALL = "write it as '- git: {local-name: PATH, uri: URL, version: VERSION}'"

_Pair = tuple[Any, Any]


def _is_empty(node: Any) -> bool:
    return node is None or (isinstance(node, yaml.ScalarNode) and node.tag == "tag:yaml.org,2002:null")


def _refuse(name: str, node: Any, text: str, remedy: str = _FORMAT) -> NoReturn:
    raise RosmlError(f"{name}:{node.start_mark.line + 1}: {text}", remedy, exit_code=2)


def _mapping(node: Any, name: str, what: str) -> dict[str, _Pair]:
    """The nodes of a mapping's keys and values, with merged ones."""
    if not isinstance(node, yaml.MappingNode):
        _refuse(name, node, f"{what} is no mapping")
    pairs: dict[str, _Pair] = {}
    merged: dict[str, _Pair] = {}
    for key, value in node.value:
        if not isinstance(key, yaml.ScalarNode):
            _refuse(name, key, "a key is no text")
        if key.tag == MERGE:
            for item in value.value if isinstance(value, yaml.SequenceNode) else [value]:
                merged = _mapping(item, name, f"what {what} merges") | merged  # the first one counts
            continue
        if key.value in pairs:
            _refuse(name, key, f"{key.value} is there twice", "keep one of them")
        pairs[key.value] = (key, value)
    return merged | pairs


def _require_known(name: str, others: dict[str, _Pair], known: tuple[str, ...], used: _Pair | None = None) -> None:
    """Checks that a mapping has no unknown key, unless that only holds anchors for the value of `used`."""
    reached = _nodes(used[1]) if used and others else set()
    for key, value in others.values():
        if reached.isdisjoint(_nodes(value)):
            meant = (
                "did you mean 'version'?" if key.value in VERSIONS and "version" in known else near(key.value, known)
            )
            _refuse(name, key, f"unknown key {key.value!r}", meant)


def _nodes(node: Any) -> set[int]:
    """A node and all nodes below it; an alias is the node that it names."""
    found: set[int] = set()
    todo = [node]
    while todo:
        item = todo.pop()
        if id(item) not in found:
            found.add(id(item))
            if isinstance(item, yaml.MappingNode):
                todo += [part for pair in item.value for part in pair]
            elif isinstance(item, yaml.SequenceNode):
                todo += item.value
    return found


def _of_rosinstall(name: str, node: Any, local: bool) -> Iterator[Entry]:
    """The repositories of a file that is a list."""
    said: set[str] = set()
    for item in node.value:
        pairs = [*_mapping(item, name, "a repository").values()]
        if len(pairs) != 1:
            _refuse(name, item, "no repository of the format of rosinstall", _ROSINSTALL)
        ((kind, value),) = pairs
        fields = _mapping(value, name, kind.value)
        texts = dict(_texts(name, kind.value, value, tuple(ROSINSTALL)))
        for needed in ("local-name", "uri"):
            if not texts.get(needed):
                _refuse(name, kind, f"{kind.value}: no {needed}", _ROSINSTALL)
        entry = _entry(
            name,
            fields["local-name"][1],
            {"type": kind.value} | {ROSINSTALL[key]: text for key, text in texts.items()},
            local,
        )
        if entry.path in said:
            _refuse(name, kind, f"{entry.path} is there twice", "keep one of them")
        said.add(entry.path)
        yield entry


def _entry(name: str, key: Any, fields: dict[str, str], local: bool) -> Entry:
    """A repository. `key`: the node of its path."""
    if not fields.get("type"):
        _refuse(name, key, f"{key.value}: no type", "add 'type: git'")
    if fields["type"] != "git":
        _refuse(name, key, f"{key.value}: the type is {fields['type']}; only git works", "take the sources from git")
    if not fields.get("url"):
        _refuse(name, key, f"{key.value}: no url")
    try:
        url = urls.checked(fields["url"], local)
    except urls.Refused as error:
        _refuse(name, key, f"{key.value}: {error}", error.remedy)
    version = fields.get("version", "")
    if version.startswith("-") or not version.isprintable() or " " in version:
        _refuse(name, key, f"{key.value}: {version!r} is no version", "name a tag, a branch or a commit")
    return Entry(_path(name, key), url, version, name, key.start_mark.line + 1)


def _texts(name: str, path: str, node: Any, known: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    """The plain values of a repository, as written: YAML would read the version 1.10 as the number 1.1."""
    fields = _mapping(node, name, path)
    _require_known(name, {key: pair for key, pair in fields.items() if key not in known}, known)
    for key, (_, value) in fields.items():
        if not isinstance(value, yaml.ScalarNode):
            _refuse(name, value, f"{path}: {key} is no text")
        yield key, "" if _is_empty(value) else value.value


def _path(name: str, key: Any) -> str:
    path = PurePosixPath(key.value)
    parts = path.parts
    if not parts:
        text = f"{key.value!r} is the folder for sources itself, which other repositories go into as well"
        _refuse(name, key, text, "name a folder below it, such as the repository's name")
    if path.is_absolute() or ".." in parts or not key.value.isprintable() or "\\" in key.value:
        _refuse(name, key, f"{key.value!r} leads out of the folder for sources", "name a folder below it")
    if ".git" in (part.lower() for part in parts):
        _refuse(name, key, f"{key.value!r} is a name that git uses itself", "choose another one")
    return str(path)
