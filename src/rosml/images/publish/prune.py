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
from typing import Any, TypeVar

from rosml.base.clock import is_date
from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set.model import PARTS, ImageSet
from rosml.images.matrix.names import DATED
from rosml.images.records.store import REPOSITORY, Entry, Records, date_of
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

T = TypeVar("T")
R = TypeVar("R")


@dataclass
class Pruning:
    """What can go.

    Attributes:
        tags: repository and tag.
        manifests: repository and digest. No kept tag leads to them. Artifacts attached to them go with them.
        records: tags of records of runs that are too old.
        kept: how many tags stay.
        needed: repository and digest of the manifests that kept tags and records lead to.
        seen: where each of `tags` pointed.
    """

    tags: list[tuple[str, str]] = field(default_factory=list)
    manifests: list[tuple[str, str]] = field(default_factory=list)
    records: list[str] = field(default_factory=list)
    kept: int = 0
    needed: set[tuple[str, str]] = field(default_factory=set)
    seen: dict[tuple[str, str], str] = field(default_factory=dict)

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {
            "tags": [":".join(item) for item in self.tags],
            "manifests": ["@".join(item) for item in self.manifests],
            "records": self.records,
            "kept": self.kept,
        }


@dataclass
class Pruner:
    """Finds what can go, and removes it.

    Attributes:
        place: the registry.
        image_set: names the repositories.
        today: the day from which ages count.
        days: dated tags younger than this stay.
        newest: this many dated tags of each image always stay.
    """

    place: Place
    image_set: ImageSet
    today: date
    days: int = 30
    newest: int = 3
    _place: str = ""  # the repository of the next three fields
    _recorded: set[str] = field(default_factory=set)  # digests that the records need
    _now: set[str] = field(default_factory=set)  # digests in use, at the last look
    _together: set[str] = field(default_factory=set)  # images of the index that was removed last
    _fresh: bool = False  # whether the last look was after that index was removed
    _runs: dict[str, str] = field(default_factory=dict)  # digests of the records of runs, as they were read
    _moved: set[tuple[str, str]] = field(default_factory=set)  # what records of runs name that changed meanwhile
    _known: dict[tuple[str, str], Manifest] = field(default_factory=dict)
    _images: set[tuple[str, str]] = field(default_factory=set)

    def find(self) -> Pruning:
        """Finds what can go.

        Raises:
            RosmlError: the registry does not answer.
        """
        found = Pruning()
        self._known.clear()
        self._images.clear()
        oldest = self._oldest
        self._moved.clear()
        self._runs = self._records_of_runs()
        roots, candidates, found.records = self._book()
        for repository in self._repositories():
            path = self.place.path(repository)
            tags = self._tags(path)
            manifests = dict(zip(tags, side_by_side(partial(self._manifest, path), tags), strict=True))
            going = {tag for tag in self._old(tags, oldest) if is_date(date_of(manifests[tag]))}
            found.tags += sorted((repository, tag) for tag in going)
            found.kept += len(tags) - len(going)
            digests = {tag: manifest.digest if manifest else "" for tag, manifest in manifests.items()}
            found.seen |= {(repository, tag): digests[tag] for tag in going}
            keep = self._reach(path, {*roots.get(repository, ()), *(digests[tag] for tag in tags if tag not in going)})
            found.needed.update((repository, digest) for digest in keep)
            gone = self._reach(path, {*candidates.get(repository, ()), *(digests[tag] for tag in going)} - keep)
            found.manifests += [(repository, digest) for digest in self._in_order(path, gone - keep)]
        return found

    def _in_order(self, path: str, gone: Iterable[str]) -> list[str]:
        """Sorts digests: each index, followed by the images that no later index holds; at the end, images in no
        index."""
        digests = sorted(gone)
        members = {digest: self._held_by(path, digest) for digest in digests}
        last = {image: index for index in digests for image in members[index]}
        alone = [digest for digest in digests if not members[digest] and digest not in last]
        held = [
            [index, *(image for image in digests if last.get(image) == index)] for index in digests if members[index]
        ]
        return [*dict.fromkeys(digest for several in held for digest in several), *alone]

    def _held_by(self, path: str, digest: str) -> set[str]:
        """The digests of an index's images; none if the manifest is no index."""
        found = self._known.get((path, digest))
        return {item.digest for item in found.members} if found else set()

    def _tags(self, path: str) -> list[str]:
        """Tags of a repository, without those that replace the referrers API."""
        return [tag for tag in self.place.client.tags(path) if not FALLBACK.fullmatch(tag)]

    def _manifest(self, path: str, reference: str) -> Manifest | None:
        """The manifest of a tag or digest. A digest's content never changes, so it is asked for once."""
        found = self._known.get((path, reference)) or self.place.client.manifest(path, reference)
        if found:
            self._known[path, found.digest] = found
            self._images |= {(path, item.digest) for item in found.members if item.mediaType not in INDEXES}
        return found

    @property
    def _oldest(self) -> date:
        return self.today - timedelta(days=self.days)

    def _book(self) -> tuple[Digests, Digests, list[str]]:
        """What the records say: digests, by repository, that entries or kept records of runs name; digests that may go;
        and records of runs that are too old."""
        book = Records(self.place)
        names = self.place.client.tags(book.repository)
        records = sorted(name for name in names if name.startswith(UNDO))
        old = [name for name in records if _day(name.removeprefix(UNDO)[:8]) < self._oldest]
        roots: Digests = {}
        candidates: Digests = {}
        for entry in self._entries(book, [name for name in names if "." in name and not name.startswith(UNDO)]):
            candidates.setdefault(entry.repository, set()).update(entry.superseded)
            if entry.digest:
                roots.setdefault(entry.repository, set()).add(entry.digest)
        for name, moved in zip(records, side_by_side(partial(read_moves, book), records), strict=True):
            for move in moved:  # an undo must be able to bring back what a kept record names
                if move.old:
                    target = candidates if name in old else roots
                    target.setdefault(move.repository, set()).add(move.old)
        return roots, candidates, old

    def _records_of_runs(self) -> dict[str, str]:
        """Digests of the records of runs, by their tags."""
        path = self.place.path(REPOSITORY)
        names = [name for name in self.place.client.tags(path) if name.startswith(UNDO)]
        return dict(zip(names, side_by_side(partial(self.place.client.head, path), names), strict=True))

    def _needed(self, repository: str, without: str = "") -> set[str]:
        """The digests of a repository that are in use now, by tags, entries or records of runs.

        Entries are read once for each repository: before a tag moves to the digest of an entry, there is a record of
        the run. If a record of a run changed meanwhile, all digests in it count.

        Args:
            repository: without the registry's prefix.
            without: a tag that does not count.
        """
        if repository != self._place:
            self._place, self._recorded, self._together = repository, self._book()[0].get(repository, set()), set()
        for name, digest in self._records_of_runs().items():
            if self._runs.get(name) != digest:
                self._runs[name] = digest
                moves = read_moves(Records(self.place), name)
                self._moved |= {(move.repository, end) for move in moves for end in (move.old, move.new) if end}
        path = self.place.path(repository)
        tags = side_by_side(partial(self.place.client.head, path), [tag for tag in self._tags(path) if tag != without])
        moved = {digest for place, digest in self._moved if place == repository}
        return self._reach(path, {*self._recorded, *moved, *tags})

    def remove(self, found: Pruning) -> Iterator[str]:
        """Removes tags, then manifests, then records. Gives a line for each one that is gone or stays.

        If a registry cannot delete a tag, the manifest stays as well: no digest goes while a tag points at it. A
        manifest that came into use after the search stays, too.

        Raises:
            RosmlError: the registry does not answer, or refuses, or deletes nothing; then the message counts what
                stays.
        """
        steps: tuple[tuple[str, list[Any], Callable[[Pruning, Any], str]], ...] = (
            ("tag", found.tags, self._remove_tag),
            ("manifest", found.manifests, self._remove_manifest),
            ("record", found.records, self._remove_record),
        )
        left = {kind: len(items) for kind, items, _ in steps}
        for kind, items, work in steps:
            self._place = ""
            for item in items:
                try:
                    line = work(found, item)
                except Undeletable as error:
                    stays = listed([counted(number, name) for name, number in left.items() if number])
                    raise RosmlError(f"{error.message}: {stays} could go, and stay", error.remedy) from None
                left[kind] -= STAYS not in line
                if line:
                    yield line

    def _remove_tag(self, found: Pruning, item: tuple[str, str]) -> str:
        repository, tag = item
        path = self.place.path(repository)
        digest = self.place.client.head(path, tag)
        if not digest:  # somebody else removed the tag
            return ""
        if digest != found.seen.get(item, digest):
            return f"{repository}:{tag}{STAYS}it moved meanwhile"
        try:
            self.place.client.delete(path, tag)
        except RosmlError as error:
            if (repository, digest) in found.needed or digest in self._needed(repository, without=tag):
                found.needed.update((repository, needed) for needed in self._reach(path, [digest]))
                return f"{repository}:{tag}{STAYS}{error.message}"
            self.place.client.delete(path, digest)  # the registry deletes only digests, and no other tag has this one
            return f"{repository}:{tag} with {digest}"
        return f"{repository}:{tag}"

    def _remove_manifest(self, found: Pruning, item: tuple[str, str]) -> str:
        """Removes a manifest and the artifacts attached to it."""
        repository, digest = item
        path = self.place.path(repository)
        if item in found.needed or not self.place.client.head(path, digest):
            return ""
        together = repository == self._place and digest in self._together
        if not (together and self._fresh):
            self._now, self._fresh = self._needed(repository), together
        if not together:
            self._together = self._held_by(path, digest)
        if digest in self._now:
            return f"{repository}@{digest}{STAYS}it is in use again"
        attached = [name for name in self._attached(path, digest) if name not in self._now]
        self.place.client.delete(path, digest)
        if not self.place.client.head(path, digest):  # nobody has pushed it again meanwhile
            side_by_side(partial(self.place.client.delete, path), attached)
            self.place.client.forget(path, digest)
        return f"{repository}@{digest}"

    def _remove_record(self, _: Pruning, name: str) -> str:
        path = self.place.path(REPOSITORY)
        try:
            self.place.client.delete(path, name)
        except RosmlError:  # the registry deletes only digests, and each record has its own
            self.place.client.delete(path, self.place.client.head(path, name))
        return f"{REPOSITORY}:{name}"

    def _repositories(self) -> Iterable[str]:
        return dict.fromkeys([*(facts.repository for facts in self.image_set.matrix.frameworks.values()), PARTS])

    def _entries(self, book: Records, names: Iterable[str]) -> Iterator[Entry]:
        keys = [(target, architecture) for target, _, architecture in (name.rpartition(".") for name in names)]
        found = book.read_all(keys)
        if lost := [key for key in keys if key not in found]:
            # An entry that cannot be read may name a digest that would be removed.
            raise RosmlError(
                f"the records' entry {'.'.join(lost[0])} cannot be read, so no digest is known to be unused",
                "publish that image again, or use the version of this program that wrote it",
            )
        yield from found.values()

    def _old(self, tags: Iterable[str], oldest: date) -> Iterator[str]:
        """Dated tags that are too old, without the newest ones of each image."""
        families: dict[str, list[str]] = {}
        for tag in tags:
            if match := DATED.search(tag):
                families.setdefault(tag[: match.start()], []).append(tag)
        for members in families.values():
            for tag in sorted(members, reverse=True)[self.newest :]:
                match = DATED.search(tag)
                if match and _day(match[1]) < oldest:
                    yield tag

    def _reach(self, path: str, digests: Iterable[str]) -> set[str]:
        """The digests that are in the registry, and the images of the indexes among them."""
        todo, found = {digest for digest in digests if digest}, set[str]()
        while todo:
            # If an index names an image, it is in the registry: a registry takes no index without its images.
            found |= {digest for digest in todo if (path, digest) in self._images}
            manifests = [item for item in side_by_side(partial(self._manifest, path), todo - found) if item]
            found |= {manifest.digest for manifest in manifests}
            todo = {item.digest for manifest in manifests for item in manifest.members} - found
        return found

    def _attached(self, path: str, digest: str) -> list[str]:
        """Artifacts attached to a manifest, and artifacts attached to these; the outermost come first."""
        todo, found = [digest], list[str]()
        while todo:
            below = [item["digest"] for item in self.place.client.referrers(path, todo.pop(0))]
            todo += [item for item in below if item not in found]
            found += [item for item in below if item not in found]
        return found[::-1]


def _day(text: str) -> date:
    """`20261122` as a day; the last possible day if the text is no date, so that it is never too old."""
    try:
        return date(int(text[:4]), int(text[4:6]), int(text[6:8]))
    except ValueError:
        return date.max
