"""`.repos` files, as vcstool and vcs2l read them: finds them, and reads their repositories.

Newer releases of vcs2l have `extends`: a file, or a list of files, beside this one. If two of them name one path, the later one
counts; the file's own repositories count before all of them.

A file that is a list has the format of rosinstall: `- git: {local-name: PATH, uri: URL, version: VERSION}`.
"""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any, NoReturn

import yaml

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import near
from rosml.containerize import within
from rosml.containerize.sources import urls

KEYS = ("type", "url", "version")
VERSIONS = ("branch", "tag", "commit", "ref", "rev", "revision", "hash", "sha", "checkout")
"""Words that people write instead of `version`."""

ROSINSTALL = {"local-name": "path", "uri": "url", "version": "version"}
"""The keys of a repository in a file of rosinstall, and our names for them."""

EXTENDS = 10  # the most files that may extend each other in a chain

NULL = "tag:yaml.org,2002:null"
MERGE = "tag:yaml.org,2002:merge"
"""YAML's tag of a key `<<`: the mapping also has the keys of its value, unless it has them itself."""

IGNORE = "COLCON_IGNORE"
"""If a folder has a file of this name, its packages and `.repos` files do not count."""

_FORMAT = "write it as 'repositories: {PATH: {type: git, url: URL, version: VERSION}}'"
_ROSINSTALL = "write it as '- git: {local-name: PATH, uri: URL, version: VERSION}'"

_Pair = tuple[Any, Any]
"""The nodes of a key and of its value."""


@dataclass(frozen=True)
class Entry:
    """One repository of a `.repos` file."""

    path: str  # its folder, below that for upstream sources
    url: str  # without a user and a password, except the user of ssh
    version: str  # as written; empty for the default branch
    file: str
    line: int

    @property
    def place(self) -> str:
        return f"{self.file}:{self.line}"

    def same(self, other: Entry) -> bool:
        return urls.key(self.url) == urls.key(other.url) and self.version == other.version


def find(folder: Path, without: tuple[Path, ...] = ()) -> list[Path]:
    """The `.repos` files below a folder, sorted, without those in `.git`, below COLCON_IGNORE, and in some resolved folders."""
    paths: list[Path] = []
    for name, folders, names in os.walk(folder, onerror=_raise):
        here = Path(name)
        if IGNORE in names or IGNORE in folders or here.resolve() in without:
            folders.clear()
            continue
        folders[:] = [below for below in folders if below != ".git"]
        paths += [here / below for below in names if below.endswith(".repos") and (here / below).is_file()]
    for path in paths:
        if not path.resolve().is_relative_to(folder.resolve()):
            raise RosmlError(f"{path}: a link that leads out of {folder}", "replace it by the file", exit_code=2)
    return sorted(paths)


def _raise(error: OSError) -> None:
    raise error


def read(paths: Iterable[Path], folder: Path, prefix: str, local: bool) -> list[Entry]:
    """The repositories that `.repos` files of a folder name. If one file extends another, the other counts as a part of it. Their paths
    in messages begin with `prefix`; if `local`, they may name repositories of this machine."""
    reader = _Reader(folder, prefix, local)
    entries = {path: reader.entries(path, ()) for path in paths}
    return [entry for path in entries if path.resolve() not in reader.extended for entry in entries[path].values()]


class _Reader:
    """Reads files of a folder, each once. `extended`: files that others extend, resolved."""

    def __init__(self, folder: Path, prefix: str, local: bool) -> None:
        self._folder, self._prefix, self._local = folder, prefix, local
        self._entries: dict[Path, dict[str, Entry]] = {}
        self.extended: set[Path] = set()

    def entries(self, path: Path, above: tuple[Path, ...]) -> dict[str, Entry]:
        """The repositories of a file, by path. `above`: the files that led here by `extends`."""
        place = path.resolve()
        if place not in self._entries:
            self._entries[place] = self._read(path, (*above, place))
        return self._entries[place]

    def _read(self, path: Path, above: tuple[Path, ...]) -> dict[str, Entry]:
        file = _File(f"{self._prefix}{os.path.relpath(path, self._folder)}", self._local)
        node = file.parsed(within.read(path, self._folder, untrusted.SIZE) or b"")
        if _is_empty(node):
            return {}
        if isinstance(node, yaml.SequenceNode):
            return file.rosinstall(node)
        top = file.mapping(node, "the file")
        listed, extends = top.pop("repositories", None), top.pop("extends", None)
        if listed is None and extends is None:
            file.refuse(node, "no key 'repositories'")
        file.require_known(top, ("repositories", "extends"), listed)
        entries: dict[str, Entry] = {}
        for item, parent in self._parents(file, path, extends[1]) if extends else ():
            if parent.resolve() in above:
                file.refuse(item, f"it extends {item.value}, which extends it", "take one of the two out")
            if len(above) > EXTENDS:
                file.refuse(item, f"more than {EXTENDS} files extend each other", "write them as fewer")
            self.extended.add(parent.resolve())
            entries |= self.entries(parent, above)
        return entries | (file.repositories(listed[1]) if listed else {})

    def _parents(self, file: _File, path: Path, node: Any) -> Iterator[tuple[Any, Path]]:
        """The files that a file extends, each with its node."""
        names: set[str] = set()
        for item in node.value if isinstance(node, yaml.SequenceNode) else [node]:
            if not isinstance(item, yaml.ScalarNode) or not item.value or not item.value.isprintable():
                file.refuse(item, "extends is no file", "name a .repos file, or a list of them")
            if item.value in names:
                file.refuse(item, f"extends has {item.value} twice", "keep one of them")
            names.add(item.value)
            parent = path.parent / item.value
            try:
                exists = within.exists(parent, self._folder)
            except RosmlError as error:
                file.refuse(item, f"it extends {item.value}: {error.message}", error.remedy)
            if not exists:
                file.refuse(item, f"it extends {item.value}, and there is no such file beside it", "check its name")
            yield item, parent


@dataclass(frozen=True)
class _File:
    """Reads the nodes of one file. `local`: whether it may name repositories of this machine."""

    name: str
    local: bool

    def refuse(self, node: Any, text: str, remedy: str = _FORMAT) -> NoReturn:
        raise RosmlError(f"{self.name}:{node.start_mark.line + 1}: {text}", remedy, exit_code=2)

    def parsed(self, content: bytes) -> Any:
        try:
            return untrusted.yaml_node(content.decode("utf-8-sig"))
        except UnicodeDecodeError:
            raise RosmlError(f"{self.name}: not UTF-8", "save the file as UTF-8", exit_code=2) from None
        except yaml.YAMLError as error:
            mark = getattr(error, "problem_mark", None)
            problem = getattr(error, "problem", None) or "a character that YAML does not allow"
            text = f"{self.name}:{mark.line + 1 if mark else 1}: not YAML: {problem}"
            raise RosmlError(text, _FORMAT, exit_code=2) from None

    def repositories(self, node: Any) -> dict[str, Entry]:
        pairs = {} if _is_empty(node) else self.mapping(node, "repositories")
        entries = [self._entry(key, self._texts(key.value, value, KEYS)) for key, value in pairs.values()]
        return {entry.path: entry for entry in entries}

    def rosinstall(self, node: Any) -> dict[str, Entry]:
        entries: dict[str, Entry] = {}
        for item in node.value:
            pairs = [*self.mapping(item, "a repository").values()]
            if len(pairs) != 1:
                self.refuse(item, "no repository of the format of rosinstall", _ROSINSTALL)
            ((kind, value),) = pairs
            texts = self._texts(kind.value, value, ROSINSTALL)
            for needed in ("local-name", "uri"):
                if not texts.get(needed):
                    self.refuse(kind, f"{kind.value}: no {needed}", _ROSINSTALL)
            fields = {"type": kind.value} | {ROSINSTALL[key]: text for key, text in texts.items()}
            entry = self._entry(self.mapping(value, kind.value)["local-name"][1], fields)
            if entry.path in entries:
                self.refuse(kind, f"{entry.path} is there twice", "keep one of them")
            entries[entry.path] = entry
        return entries

    def mapping(self, node: Any, what: str) -> dict[str, _Pair]:
        """The nodes of a mapping's keys and values, with merged ones."""
        if not isinstance(node, yaml.MappingNode):
            self.refuse(node, f"{what} is no mapping")
        pairs: dict[str, _Pair] = {}
        merged: dict[str, _Pair] = {}
        for key, value in node.value:
            if not isinstance(key, yaml.ScalarNode):
                self.refuse(key, "a key is no text")
            if key.tag == MERGE:
                for item in value.value if isinstance(value, yaml.SequenceNode) else [value]:
                    merged = self.mapping(item, f"what {what} merges") | merged  # the first one counts
                continue
            if key.value in pairs:
                self.refuse(key, f"{key.value} is there twice", "keep one of them")
            pairs[key.value] = (key, value)
        return merged | pairs

    def require_known(self, others: Mapping[str, _Pair], keys: Collection[str], used: _Pair | None = None) -> None:
        """Checks that a mapping has no unknown key, unless that only holds anchors for the value of `used`."""
        reached = _nodes(used[1]) if used and others else set()
        for key, value in others.values():
            if reached.isdisjoint(_nodes(value)):
                is_version = key.value in VERSIONS and "version" in keys
                remedy = "did you mean 'version'?" if is_version else near(key.value, keys)
                self.refuse(key, f"unknown key {key.value!r}", remedy)

    def _texts(self, path: str, node: Any, keys: Collection[str]) -> dict[str, str]:
        """The plain values of a repository, as written: YAML would read the version 1.10 as the number 1.1."""
        fields = self.mapping(node, path)
        self.require_known({key: pair for key, pair in fields.items() if key not in keys}, keys)
        for key, (_, value) in fields.items():
            if not isinstance(value, yaml.ScalarNode):
                self.refuse(value, f"{path}: {key} is no text")
        return {key: "" if _is_empty(value) else value.value for key, (_, value) in fields.items()}

    def _entry(self, key: Any, fields: Mapping[str, str]) -> Entry:
        if not fields.get("type"):
            self.refuse(key, f"{key.value}: no type", "add 'type: git'")
        if fields["type"] != "git":
            self.refuse(key, f"{key.value}: the type is {fields['type']}; only git works", "take the sources from git")
        if not fields.get("url"):
            self.refuse(key, f"{key.value}: no url")
        try:
            url = urls.checked(fields["url"], self.local)
        except urls.Refused as error:
            self.refuse(key, f"{key.value}: {error}", error.remedy)
        version = fields.get("version", "")
        if version.startswith("-") or not version.isprintable() or " " in version:
            self.refuse(key, f"{key.value}: {version!r} is no version", "name a tag, a branch or a commit")
        return Entry(self._path(key), url, version, self.name, key.start_mark.line + 1)

    def _path(self, key: Any) -> str:
        path = PurePosixPath(key.value)
        if not path.parts:
            text = f"{key.value!r} is the folder for sources itself, which other repositories go into as well"
            self.refuse(key, text, "name a folder below it, such as the repository's name")
        if path.is_absolute() or ".." in path.parts or not key.value.isprintable() or "\\" in key.value:
            self.refuse(key, f"{key.value!r} leads out of the folder for sources", "name a folder below it")
        if ".git" in (part.lower() for part in path.parts):
            self.refuse(key, f"{key.value!r} is a name that git uses itself", "choose another one")
        return str(path)


def _is_empty(node: Any) -> bool:
    return node is None or (isinstance(node, yaml.ScalarNode) and node.tag == NULL)


def _nodes(node: Any) -> set[int]:
    """A node and all nodes below it; an alias is the node that it names."""
    ids: set[int] = set()
    todo = [node]
    while todo:
        item = todo.pop()
        if id(item) not in ids:
            ids.add(id(item))
            if isinstance(item, yaml.MappingNode):
                todo += [part for pair in item.value for part in pair]
            elif isinstance(item, yaml.SequenceNode):
                todo += item.value
    return ids
