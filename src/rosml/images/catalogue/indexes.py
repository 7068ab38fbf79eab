"""Reads the indexes of images from the registry: the present ones, and those that earlier runs published.

It pulls only manifests and configs, each once. If an image cannot be read, it is left out with a remark, and people still find the
others.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.catalogue.model import SIGNER, Move, Sbom
from rosml.images.image_set.labels import COVERED
from rosml.images.image_set.model import Image, Part, tags_of
from rosml.images.matrix.tags import DATED
from rosml.images.records import tag_moves
from rosml.images.records.store import INDEX, Entry, Records, date_of
from rosml.registry import documents
from rosml.registry.place import Place

Thing = Image | Part
Key = TypeVar("Key")
Value = TypeVar("Value")

_SBOM = re.compile(r"[a-z0-9]+(?:[._/-]+[a-z0-9]+)*@sha256:[0-9a-f]{64}")
_MOST_SBOMS = 32


@dataclass(frozen=True)
class Member:
    """An image manifest, its platform and labels, and its entry in the records: the present one, or that of its index."""

    digest: str
    platform: str
    layers: tuple[tuple[str, int], ...]
    labels: Mapping[str, str]
    entry: Entry | None = None
    sboms: tuple[Sbom, ...] = ()


@dataclass(frozen=True)
class Index:
    """An index and its images."""

    digest: str
    created: str
    members: tuple[Member, ...]
    signed: tuple[str, ...] = ()


@dataclass(frozen=True)
class History:
    """An image or part in the registry: its tags with their digests, and all its present and former indexes."""

    tags: Mapping[str, str]
    moves: Sequence[Move]
    indexes: Sequence[Index]


class Reader:
    """Reads a registry: of builds without a tag only the newest, as `history` says. `remarks` takes what was left out."""

    def __init__(self, place: Place, history: int, remarks: list[str]) -> None:
        self._place = place
        self._client = place.client
        self._records = Records(place)
        self._history = history
        self._remarks = remarks
        self._entries: Mapping[str, Entry] = {}  # by digest

    def read(self, things: Sequence[Thing]) -> dict[str, History]:
        """The images and parts in the registry, by target."""
        keys = [(thing.target, name) for thing in things for name in (*thing.architectures, INDEX)]
        entries = self._records.read_all(keys)
        self._entries = {entry.digest: entry for entry in entries.values() if entry.digest}
        tags = self._tags(things)
        moves = self._moves()
        moves_of = {thing.target: moves.get((thing.repository, tags_of(thing)[0]), []) for thing in things}
        digests: dict[str, list[str]] = {}
        for thing in things:
            entry = entries.get((thing.target, INDEX))
            moved = [digest for move in moves_of[thing.target] for digest in (move.new, move.previous)]
            former = [*tags[thing.target].values(), *moved, *(entry.superseded if entry else ())]
            digests[thing.target] = list(dict.fromkeys(filter(None, former)))
        keys = list(dict.fromkeys((t.repository, digest) for t in things for digest in digests[t.target]))
        indexes = _each(keys, lambda key: self._index(*key), "images")
        histories = {}
        for thing in things:
            read = [indexes[thing.repository, digest] for digest in digests[thing.target]]
            kept = self._kept(tags_of(thing)[0], tags[thing.target], [index for index in read if index])
            histories[thing.target] = History(tags[thing.target], moves_of[thing.target], kept)
        return histories

    def _tags(self, things: Sequence[Thing]) -> dict[str, dict[str, str]]:
        """The tags of images with their digests, by target: those of the matrix, and dated ones of the main tag."""
        repositories = dict.fromkeys(thing.repository for thing in things)
        names = _each(repositories, lambda name: _by_undated(self._client.tags(self._place.path(name))), "tags")
        tags = {thing.target: _present_tags(thing, names[thing.repository]) for thing in things}
        keys = [(thing.repository, tag) for thing in things for tag in tags[thing.target]]
        digests = _each(keys, lambda key: self._client.head(self._place.path(key[0]), key[1]), "digests")
        return {
            thing.target: {tag: digest for tag in tags[thing.target] if (digest := digests[thing.repository, tag])}
            for thing in things
        }

    def _kept(self, main: str, tags: Mapping[str, str], indexes: Iterable[Index]) -> list[Index]:
        """The present index, then others, newest first: all with a tag, and some without one."""
        newest = sorted(indexes, key=lambda index: (index.digest == tags.get(main), index.created), reverse=True)
        tagged = set(tags.values())
        untagged = [index.digest for index in newest if index.digest not in tagged]
        kept = tagged.union(untagged[: self._history])
        return [index for index in newest if index.digest in kept]

    def _moves(self) -> dict[tuple[str, str], list[Move]]:
        """The moves of tags in the records of runs, by repository and tag, newest first."""
        tags = self._client.tags(self._records.repository)
        names = sorted((name for name in tags if name.startswith(tag_moves.UNDO)), reverse=True)
        by_tag: dict[tuple[str, str], list[Move]] = {}
        for name, moves in _each(names, self._recorded_moves, "records").items():
            for move in moves:
                if move.previous != move.new:
                    run = tag_moves.run_date(name)
                    by_tag.setdefault((move.repository, move.tag), []).append(
                        Move(run=run, previous=move.previous, new=move.new)
                    )
        return by_tag

    def _recorded_moves(self, name: str) -> list[tag_moves.Move]:
        try:
            return tag_moves.read_moves(self._records, name)
        except RosmlError as error:
            self._remarks.append(error.message)
            return []

    def _index(self, repository: str, digest: str) -> Index | None:
        """An index and its images; None if it is gone or damaged."""
        path = self._place.path(repository)
        try:
            manifest = self._client.manifest(path, digest)
            if manifest is None:  # the build was removed
                return None
            if not manifest.is_index:
                raise ValueError("it is no index")
            members = [
                self._member(repository, item)
                for item in manifest.members
                if not _platform(item.platform).startswith("unknown")
            ]
            entry = self._entries.get(digest)
            signed = sorted(name for name in (entry.signed if entry else ()) if re.fullmatch(SIGNER, name))
            return Index(digest, date_of(manifest), tuple(members), tuple(signed))
        except (ArithmeticError, LookupError, TypeError, ValueError, RosmlError) as error:
            self._client.head(path, digest)  # raises if the registry does not answer any more
            self._remarks.append(f"{repository}@{digest} is left out: it cannot be read ({error})")
            return None

    def _member(self, repository: str, item: documents.Descriptor) -> Member:
        path = self._place.path(repository)
        manifest = self._client.manifest(path, item.digest)
        if manifest is None:
            raise ValueError(f"{item.digest} is not there")
        config = self._client.config(path, manifest)
        layers = tuple((layer.digest, layer.size) for layer in manifest.layers)
        entry = self._entries.get(item.digest)
        if entry is None:  # another image has replaced it in the records
            entry = self._records.attached(repository, item.digest)
        return Member(item.digest, _platform(item.platform), layers, config.labels, entry, _sboms(item.annotations))


def _sboms(annotations: Mapping[str, str]) -> tuple[Sbom, ...]:
    """The SBOMs that an index names for an image; names that are not well-formed are left out."""
    names = {name.removeprefix(COVERED): text for name, text in annotations.items() if name.startswith(COVERED)}
    parts = ((name, text.partition("@")) for name, text in sorted(names.items())[:_MOST_SBOMS] if _SBOM.fullmatch(text))
    return tuple(Sbom(part=name, repository=repository, digest=digest) for name, (repository, _, digest) in parts)


def _by_undated(tags: Iterable[str]) -> dict[str, list[str]]:
    """The tags of a repository, by their names without a day."""
    by_name: dict[str, list[str]] = {}
    for tag in tags:
        by_name.setdefault(DATED.sub("", tag), []).append(tag)
    return by_name


def _present_tags(thing: Thing, tags: Mapping[str, list[str]]) -> list[str]:
    main, *others = tags_of(thing)
    return [*tags.get(main, ()), *(tag for tag in others if tag in tags.get(tag, ()))]


def _platform(platform: documents.Platform | None) -> str:
    """BuildKit's name of a platform: `linux/arm64`."""
    name = "/".join(filter(None, (platform.os, platform.architecture, platform.variant))) if platform else ""
    return name.removesuffix("/v8") if name.startswith("linux/arm64") else name


def _each(keys: Iterable[Key], work: Callable[[Key], Value], title: str) -> dict[Key, Value]:
    """Asks for several things at a time, with a progress bar on a terminal."""
    keys = list(keys)
    return dict(zip(keys, side_by_side(work, keys, title=title), strict=True))
