"""`.repos` files, as vcstool reads them: where they are, and which repositories they name."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any, NoReturn

import yaml

from rosml.apps import urls
from rosml.base import files, untrusted
from rosml.base.errors import RosmlError

IGNORE = "COLCON_IGNORE"
"""A folder with a file of this name has no packages, and no `.repos` files that count."""


@dataclass(frozen=True)
class Entry:
    """One repository of a `.repos` file.

    Attributes:
        path: below the folder for upstream sources. url: without a user and a password, except the user of ssh.
        version: as written; empty for the default branch. file: the name of the `.repos` file. line: of the path.
    """

    path: str
    url: str
    version: str
    file: str
    line: int

    @property
    def place(self) -> str:
        """Where it is named: `file:line`."""
        return f"{self.file}:{self.line}"

    def same(self, other: Entry) -> bool:
        """Whether both name the same version of the same repository."""
        return urls.key(self.url) == urls.key(other.url) and self.version == other.version


def found(folder: Path, without: tuple[Path, ...] = ()) -> list[Path]:
    """The `.repos` files below a folder, sorted. Those in `.git` and below COLCON_IGNORE do not count.

    Args:
        without: folders that are left out, resolved.

    Raises:
        RosmlError: one of them is a link that leads out of the folder (exit code 2). OSError: a folder cannot be read.
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


def read(file: Path, name: str, local: bool) -> list[Entry]:
    """The repositories that a `.repos` file names.

    Args:
        name: what the file is called in messages. local: whether it may name repositories of this machine.

    Raises:
        RosmlError: it cannot be read, or names something that is not allowed (exit code 2).
    """
    try:
        node = untrusted.yaml_node(files.limited(file, untrusted.SIZE).decode("utf-8-sig"))
    except OSError as error:
        raise RosmlError(f"{name}: cannot be read: {error.strerror}", "make it readable", exit_code=2) from None
    except UnicodeDecodeError:
        raise RosmlError(f"{name}: not UTF-8", "save the file as UTF-8", exit_code=2) from None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        what = getattr(error, "problem", None) or "a character that YAML does not allow"
        raise RosmlError(f"{name}:{mark.line + 1 if mark else 1}: not YAML: {what}", _FORMAT, exit_code=2) from None
    if _is_empty(node):
        return []
    listed = _mapping(node, name, "the file").get("repositories")
    if listed is None:
        _refuse(name, node, "no key 'repositories'")
    if _is_empty(listed[1]):
        return []
    entries = _mapping(listed[1], name, "repositories")
    return [_entry(name, key, value, local) for key, value in entries.values()]


_FORMAT = "write it as 'repositories: {PATH: {type: git, url: URL, version: VERSION}}'"

_Pair = tuple[Any, Any]


def _is_empty(node: Any) -> bool:
    return node is None or (isinstance(node, yaml.ScalarNode) and node.tag == "tag:yaml.org,2002:null")


def _refuse(name: str, node: Any, text: str, remedy: str = _FORMAT) -> NoReturn:
    raise RosmlError(f"{name}:{node.start_mark.line + 1}: {text}", remedy, exit_code=2)


def _mapping(node: Any, name: str, what: str) -> dict[str, _Pair]:
    """The nodes of a mapping's keys and values."""
    if not isinstance(node, yaml.MappingNode):
        _refuse(name, node, f"{what} is no mapping")
    pairs: dict[str, _Pair] = {}
    for key, value in node.value:
        if not isinstance(key, yaml.ScalarNode):
            _refuse(name, key, "a key is no text")
        if key.value in pairs:
            _refuse(name, key, f"{key.value} is there twice", "keep one of them")
        pairs[key.value] = (key, value)
    return pairs


def _entry(name: str, key: Any, node: Any, local: bool) -> Entry:
    fields = dict(_texts(name, key.value, node))
    if (kind := fields.get("type") or "missing") != "git":
        _refuse(name, key, f"{key.value}: the type is {kind}; only git works", "take the sources from git")
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


def _texts(name: str, path: str, node: Any) -> Iterator[tuple[str, str]]:
    """The plain values of a repository, as they are written: YAML would read the version 1.10 as the number 1.1."""
    for key, (_, value) in _mapping(node, name, path).items():
        if key in ("type", "url", "version"):
            if not isinstance(value, yaml.ScalarNode):
                _refuse(name, value, f"{path}: {key} is no text")
            yield key, "" if _is_empty(value) else value.value


def _path(name: str, key: Any) -> str:
    path = PurePosixPath(key.value)
    parts = path.parts
    if not parts or path.is_absolute() or ".." in parts or not key.value.isprintable() or "\\" in key.value:
        _refuse(name, key, f"{key.value!r} leads out of the folder for sources", "name a folder below it")
    if ".git" in (part.lower() for part in parts):
        _refuse(name, key, f"{key.value!r} is a name that git uses itself", "choose another one")
    return str(path)
