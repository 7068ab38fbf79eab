"""Finds and removes what a registry no longer needs.

Reachability decides. A kept tag keeps its index, an index keeps its images, and an image keeps what is attached to it.
Everything else that the publisher knows of can go. Nothing is removed unless that is asked for.

A tag may move during the removal, by an undo or by a run on another machine, and registries have no lock for that. So
immediately before an index goes, and once more before the images that only this index holds, all tags of its repository
and the records of runs are read again. Whatever these lead to stays.

The search asks once for each tag, side by side. An index names its images itself. Artifacts attached to a manifest are
looked up when that manifest is removed.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from datetime import date, timedelta
from functools import partial
from typing import Any

from rosml.base.clock import is_date
from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set.model import ENVIRONMENTS, PARTS, ImageSet
from rosml.images.matrix.tags import DATED
from rosml.images.records.store import REPOSITORY, Records, date_of
from rosml.images.records.tag_moves import UNDO, read_moves
from rosml.registry.client import Undeletable
from rosml.registry.oci import INDEXES, Manifest
from rosml.registry.place import Place

FALLBACK = re.compile(r"sha256-[0-9a-f]{64}")
"""Tags under which a registry without the referrers API keeps the artifacts attached to a manifest."""

STAYS = " stays: "
"""A line of `Pruner.remove` has this text if something was not removed, before the reason."""

Digests = dict[str, set[str]]
"""By repository."""


@dataclass(frozen=True)
class Pruning:
    """What can go."""

    tags: list[tuple[str, str]]  # repository and tag
    # Repository and digest. No kept tag leads to them. Artifacts attached to them go with them.
    manifests: list[tuple[str, str]]
    records: list[str]  # tags of records of runs that are too old
    kept: int  # how many tags stay
    needed: frozenset[tuple[str, str]]  # repository and digest of the manifests that kept tags and records lead to
    tag_digests: dict[tuple[str, str], str]  # where each of `tags` pointed
    run_records: dict[str, str]  # digests of the records of all runs, by their tags
    graph: _Graph = field(repr=False)  # the manifests that were read

    def to_json(self) -> dict[str, Any]:
        return {
            "tags": [":".join(item) for item in self.tags],
            "manifests": ["@".join(item) for item in self.manifests],
            "records": self.records,
            "kept": self.kept,
        }


@dataclass
class Pruner:
    """Finds what can go, and removes it."""

    place: Place
    image_set: ImageSet  # names the repositories
    today: date  # the day from which ages count
    days: int = 30  # dated tags younger than this stay
    newest: int = 3  # this many dated tags of each image always stay

    def find(self) -> Pruning:
        oldest = self.today - timedelta(days=self.days)
        run_records = _run_records(self.place)
        roots, candidates, records = _book(self.place, oldest)
        graph = _Graph(self.place)
        tags, manifests, kept = list[tuple[str, str]](), list[tuple[str, str]](), 0
        needed, tag_digests = set[tuple[str, str]](), dict[tuple[str, str], str]()
        frameworks = (framework.repository for framework in self.image_set.matrix.frameworks.values())
        images = (image.repository for image in self.image_set.images)
        for repository in dict.fromkeys([*frameworks, *images, PARTS, ENVIRONMENTS]):
            path = self.place.path(repository)
            names = graph.tags(path)
            tagged = dict(zip(names, side_by_side(partial(graph.manifest, path), names), strict=True))
            digests = {name: manifest.digest if manifest else "" for name, manifest in tagged.items()}
            expired = {name for name in _expired_tags(names, oldest, self.newest) if is_date(date_of(tagged[name]))}
            tags += sorted((repository, name) for name in expired)
            kept += len(names) - len(expired)
            tag_digests |= {(repository, name): digests[name] for name in expired}
            keep = graph.reach(
                path, {*roots.get(repository, ()), *(digests[name] for name in names if name not in expired)}
            )
            needed |= {(repository, digest) for digest in keep}
            unused = graph.reach(path, {*candidates.get(repository, ()), *(digests[name] for name in expired)} - keep)
            manifests += [(repository, digest) for digest in graph.in_order(path, unused - keep)]
        return Pruning(tags, manifests, records, kept, frozenset(needed), tag_digests, run_records, graph)

    def remove(self, pruning: Pruning) -> Iterator[str]:
        """Removes tags, then manifests, then records. Yields a line for each one that is gone or stays.

        If a registry cannot delete a tag, the manifest stays as well: no digest goes while a tag points at it. A
        manifest that came into use after the search stays, too. If the registry deletes nothing, the error counts what
        stays.
        """
        removal = _Removal(self.place, self.today - timedelta(days=self.days), pruning)
        steps: tuple[tuple[str, list[Any], Callable[[Any], str]], ...] = (
            ("tag", pruning.tags, removal.tag),
            ("manifest", pruning.manifests, removal.manifest),
            ("record", pruning.records, removal.record),
        )
        open_counts = {kind: len(items) for kind, items, _ in steps}
        for kind, items, remove in steps:
            removal.forget_repository()
            for item in items:
                try:
                    line = remove(item)
                except Undeletable as error:
                    stays = listed([counted(number, name) for name, number in open_counts.items() if number])
                    raise RosmlError(f"{error.message}: {stays} could go, and stay", error.remedy) from None
                open_counts[kind] -= STAYS not in line
                if line:
                    yield line


class _Graph:
    """The manifests of a registry. The content of a digest never changes, so each is asked for once."""

    def __init__(self, place: Place) -> None:
        self._client = place.client
        self._manifests: dict[tuple[str, str], Manifest] = {}
        self._images: set[tuple[str, str]] = set()

    def tags(self, path: str) -> list[str]:
        return [tag for tag in self._client.tags(path) if not FALLBACK.fullmatch(tag)]

    def manifest(self, path: str, reference: str) -> Manifest | None:
        """The manifest of a tag or digest."""
        manifest = self._manifests.get((path, reference)) or self._client.manifest(path, reference)
        if manifest:
            self._manifests[path, manifest.digest] = manifest
            self._images |= {(path, item.digest) for item in manifest.members if item.mediaType not in INDEXES}
        return manifest

    def members(self, path: str, digest: str) -> set[str]:
        """The digests of an index's images, if the index was read before."""
        manifest = self._manifests.get((path, digest))
        return {item.digest for item in manifest.members} if manifest else set()

    def reach(self, path: str, digests: Iterable[str]) -> set[str]:
        """The digests that are in the registry, and the images of the indexes among them."""
        todo, reached = {digest for digest in digests if digest}, set[str]()
        while todo:
            # If an index names an image, it is in the registry: a registry takes no index without its images.
            reached |= {digest for digest in todo if (path, digest) in self._images}
            manifests = [item for item in side_by_side(partial(self.manifest, path), todo - reached) if item]
            reached |= {manifest.digest for manifest in manifests}
            todo = {item.digest for manifest in manifests for item in manifest.members} - reached
        return reached

    def in_order(self, path: str, digests: Iterable[str]) -> list[str]:
        """Sorts digests: each index, followed by the images that no later index holds; at the end, images in no index."""
        digests = sorted(digests)
        members = {digest: self.members(path, digest) for digest in digests}
        last = {image: index for index in digests for image in members[index]}
        alone = [digest for digest in digests if not members[digest] and digest not in last]
        groups = [
            [index, *(image for image in digests if last.get(image) == index)] for index in digests if members[index]
        ]
        return [*dict.fromkeys(digest for group in groups for digest in group), *alone]

    def attached(self, path: str, digest: str) -> list[str]:
        """Artifacts attached to a manifest, and artifacts attached to these; the outermost come first."""
        todo, artifacts = [digest], list[str]()
        while todo:
            below = [item["digest"] for item in self._client.referrers(path, todo.pop(0))]
            todo += [item for item in below if item not in artifacts]
            artifacts += [item for item in below if item not in artifacts]
        return artifacts[::-1]


class _Removal:
    """Removes what can go, unless it came into use since the search."""

    def __init__(self, place: Place, oldest: date, pruning: Pruning) -> None:
        self._place, self._client, self._oldest, self._graph = place, place.client, oldest, pruning.graph
        self._tag_digests = pruning.tag_digests
        self._needed = set(pruning.needed)
        self._run_records = dict(pruning.run_records)
        self._moved: set[tuple[str, str]] = set()  # what records of runs name that changed meanwhile
        self.forget_repository()

    def forget_repository(self) -> None:
        self._repository = ""  # that of the next fields
        self._recorded: set[str] = set()  # digests that the records need
        self._in_use: set[str] = set()  # at the last look
        self._members: set[str] = set()  # images of the index that was removed last
        self._fresh = False  # whether the last look was after that index was removed

    def tag(self, item: tuple[str, str]) -> str:
        repository, tag = item
        path = self._place.path(repository)
        digest = self._client.head(path, tag)
        if not digest:  # somebody else removed the tag
            return ""
        if digest != self._tag_digests.get(item, digest):
            return f"{repository}:{tag}{STAYS}it moved meanwhile"
        try:
            self._client.delete(path, tag)
        except RosmlError as error:
            if (repository, digest) in self._needed or digest in self._look(repository, without=tag):
                self._needed.update((repository, needed) for needed in self._graph.reach(path, [digest]))
                return f"{repository}:{tag}{STAYS}{error.message}"
            self._client.delete(path, digest)  # the registry deletes only digests, and no other tag has this one
            return f"{repository}:{tag} with {digest}"
        return f"{repository}:{tag}"

    def manifest(self, item: tuple[str, str]) -> str:
        """Removes a manifest and the artifacts attached to it."""
        repository, digest = item
        path = self._place.path(repository)
        if item in self._needed or not self._client.head(path, digest):
            return ""
        is_member = repository == self._repository and digest in self._members
        if not (is_member and self._fresh):
            self._in_use, self._fresh = self._look(repository), is_member
        if not is_member:
            self._members = self._graph.members(path, digest)
        if digest in self._in_use:
            return f"{repository}@{digest}{STAYS}it is in use again"
        attached = [name for name in self._graph.attached(path, digest) if name not in self._in_use]
        self._client.delete(path, digest)
        if not self._client.head(path, digest):  # nobody has pushed it again meanwhile
            side_by_side(partial(self._client.delete, path), attached)
            self._client.forget(path, digest)
        return f"{repository}@{digest}"

    def record(self, name: str) -> str:
        path = self._place.path(REPOSITORY)
        try:
            self._client.delete(path, name)
        except RosmlError:  # the registry deletes only digests, and each record has its own
            self._client.delete(path, self._client.head(path, name))
        return f"{REPOSITORY}:{name}"

    def _look(self, repository: str, without: str = "") -> set[str]:
        """The digests of a repository that are in use now: by tags, except for one, by entries or by records of runs.

        Entries are read once for each repository: before a tag moves to the digest of an entry, there is a record of
        the run. If a record of a run changed meanwhile, all digests in it count.
        """
        if repository != self._repository:
            self.forget_repository()
            self._repository, self._recorded = repository, _book(self._place, self._oldest)[0].get(repository, set())
        for name, digest in _run_records(self._place).items():
            if self._run_records.get(name) != digest:
                self._run_records[name] = digest
                moves = read_moves(Records(self._place), name)
                self._moved |= {(move.repository, end) for move in moves for end in (move.previous, move.new) if end}
        path = self._place.path(repository)
        tags = [tag for tag in self._graph.tags(path) if tag != without]
        digests = side_by_side(partial(self._client.head, path), tags)
        moved = {digest for place, digest in self._moved if place == repository}
        return self._graph.reach(path, {*self._recorded, *moved, *digests})


def _book(place: Place, oldest: date) -> tuple[Digests, Digests, list[str]]:
    """What the records say: digests that entries or kept records of runs name; digests that may go; records that are too old."""
    book = Records(place)
    names = place.client.tags(book.repository)
    records = sorted(name for name in names if name.startswith(UNDO))
    expired = [name for name in records if _day(name.removeprefix(UNDO)[:8]) < oldest]
    roots: Digests = {}
    candidates: Digests = {}
    tags = [name for name in names if "." in name and not name.startswith(UNDO)]
    keys = [(target, architecture) for target, _, architecture in (name.rpartition(".") for name in tags)]
    entries = book.read_all(keys)
    if unreadable := [key for key in keys if key not in entries]:
        # An entry that cannot be read may name a digest that would be removed.
        raise RosmlError(
            f"the records' entry {'.'.join(unreadable[0])} cannot be read, so no digest is known to be unused",
            "publish that image again, or use the version of this program that wrote it",
        )
    for entry in entries.values():
        candidates.setdefault(entry.repository, set()).update(entry.superseded)
        if entry.digest:
            roots.setdefault(entry.repository, set()).add(entry.digest)
    for name, moves in zip(records, side_by_side(partial(read_moves, book), records), strict=True):
        for move in moves:  # an undo must be able to bring back what a kept record names
            if move.previous:
                digests = candidates if name in expired else roots
                digests.setdefault(move.repository, set()).add(move.previous)
    return roots, candidates, expired


def _run_records(place: Place) -> dict[str, str]:
    """Digests of the records of runs, by their tags."""
    path = place.path(REPOSITORY)
    names = [name for name in place.client.tags(path) if name.startswith(UNDO)]
    return dict(zip(names, side_by_side(partial(place.client.head, path), names), strict=True))


def _expired_tags(tags: Iterable[str], oldest: date, newest: int) -> Iterator[str]:
    """Dated tags that are too old, without the newest ones of each image."""
    families: dict[str, list[tuple[str, date]]] = {}
    for tag in tags:
        if match := DATED.search(tag):
            families.setdefault(tag[: match.start()], []).append((tag, _day(match[1])))
    for members in families.values():
        yield from (tag for tag, day in sorted(members, reverse=True)[newest:] if day < oldest)


def _day(text: str) -> date:
    """`20261122` as a day; the last possible day if the text is no date, so that it is never too old."""
    try:
        return date(int(text[:4]), int(text[4:6]), int(text[6:8]))
    except ValueError:
        return date.max
