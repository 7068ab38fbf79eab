"""What a registry no longer needs, by reachability: an index that a kept tag points at keeps its images, and those keep
what is attached to them. Everything else that the publisher knows of may go. Nothing is removed unless asked for.

A tag may move while a registry is pruned, by an undo or by a run on another machine, and no registry has a lock for that. So
immediately before an index goes, with the images that only it holds, all tags of its repository and the records of runs are
looked at again: what one of them leads to by then stays.

Looking asks once for each tag, side by side; what hangs on an index stands in it. What is attached to a manifest that
goes is looked for when it goes.
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
"""Tags under which a registry without the referrers API keeps what is attached to a manifest."""

STAYS = " stays: "
"""What a line of `Pruner.remove` has after what it did not remove, before the reason."""

Digests = dict[str, set[str]]
"""By repository."""

T = TypeVar("T")
R = TypeVar("R")


@dataclass
class Pruning:
    """What can go.

    Attributes:
        tags: repository and tag. manifests: repository and digest, no tag of which is kept; what is attached to them goes
            with them.
        records: tags of the records: records of runs that are older than what is kept.
        kept: how many tags stay.
        needed: repository and digest of what something leads to that is kept.
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
    """Looks for what can go, and removes it.

    Attributes:
        place: where.
        image_set: names the repositories.
        today: the day from which ages count. days: dated tags younger than that stay. newest: so many of each image stay in any case.
    """

    place: Place
    image_set: ImageSet
    today: date
    days: int = 30
    newest: int = 3
    _place: str = ""  # the repository of the three that follow
    _recorded: set[str] = field(default_factory=set)  # what the records need there
    _now: set[str] = field(default_factory=set)  # what something leads to, when that was looked at last
    _together: set[str] = field(default_factory=set)  # the images of the index that was looked at last
    _runs: dict[str, str] = field(default_factory=dict)  # digests of the records of runs that were read
    _moved: set[tuple[str, str]] = field(default_factory=set)  # what records of runs name that changed since
    _known: dict[tuple[str, str], Manifest] = field(default_factory=dict)
    _images: set[tuple[str, str]] = field(default_factory=set)

    def find(self) -> Pruning:
        """What can go.

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
        """Each index, then the images that no later one holds; last what is in none."""
        digests = sorted(gone)
        members = {digest: self._held_by(path, digest) for digest in digests}
        last = {image: index for index in digests for image in members[index]}
        alone = [digest for digest in digests if not members[digest] and digest not in last]
        held = [
            [index, *(image for image in digests if last.get(image) == index)] for index in digests if members[index]
        ]
        return [*dict.fromkeys(digest for several in held for digest in several), *alone]

    def _held_by(self, path: str, digest: str) -> set[str]:
        """What an index holds; nothing for what is none."""
        found = self._known.get((path, digest))
        return {item.digest for item in found.members} if found else set()

    def _tags(self, path: str) -> list[str]:
        """Tags of a repository, without those that stand in for the referrers API."""
        return [tag for tag in self.place.client.tags(path) if not FALLBACK.fullmatch(tag)]

    def _manifest(self, path: str, reference: str) -> Manifest | None:
        """What is behind a tag or digest. What has a digest never changes: it is asked for once."""
        found = self._known.get((path, reference)) or self.place.client.manifest(path, reference)
        if found:
            self._known[path, found.digest] = found
            self._images |= {(path, item.digest) for item in found.members if item.mediaType not in INDEXES}
        return found

    @property
    def _oldest(self) -> date:
        return self.today - timedelta(days=self.days)

    def _book(self) -> tuple[Digests, Digests, list[str]]:
        """What the records say: digests by repository that its entries, or kept records of runs, name; those that may go;
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
            for move in moved:  # a record that is kept must be able to bring back what it names
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
        """What something leads to now, in a repository: a tag, the records, a record that is kept.

        Entries of the records are read once for each repository: no tag moves to what an entry names before a record of that
        is there. Records of runs that changed since count with all that they name.

        Args:
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
        """Removes it; gives a line for each thing that is gone, or cannot go. Tags first, then what they pointed at, then
        records.

        A registry that cannot delete a tag is left its manifest as well: no digest goes while a tag points at it. What
        somebody came to need since it was found stays.

        Raises:
            RosmlError: the registry does not answer, or refuses; or it deletes nothing, with how much of what could go
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
        if not digest:  # somebody else removed it
            return ""
        if digest != found.seen.get(item, digest):
            return f"{repository}:{tag}{STAYS}it has moved since"
        try:
            self.place.client.delete(path, tag)
        except RosmlError as error:
            if (repository, digest) in found.needed or digest in self._needed(repository, without=tag):
                found.needed.update((repository, needed) for needed in self._reach(path, [digest]))
                return f"{repository}:{tag}{STAYS}{error.message}"
            self.place.client.delete(path, digest)  # the registry knows only digests, and no other tag has this one
            return f"{repository}:{tag} with {digest}"
        return f"{repository}:{tag}"

    def _remove_manifest(self, found: Pruning, item: tuple[str, str]) -> str:
        """Removes a manifest and what is attached to it."""
        repository, digest = item
        path = self.place.path(repository)
        if item in found.needed or not self.place.client.head(path, digest):
            return ""
        if repository != self._place or digest not in self._together:
            self._now = self._needed(repository)
            self._together = self._held_by(path, digest)
        if digest in self._now:
            return f"{repository}@{digest}{STAYS}something leads to it again"
        attached = [name for name in self._attached(path, digest) if name not in self._now]
        self.place.client.delete(path, digest)
        if not self.place.client.head(path, digest):  # nobody has made it anew meanwhile
            side_by_side(partial(self.place.client.delete, path), attached)
            self.place.client.forget(path, digest)
        return f"{repository}@{digest}"

    def _remove_record(self, _: Pruning, name: str) -> str:
        path = self.place.path(REPOSITORY)
        try:
            self.place.client.delete(path, name)
        except RosmlError:  # the registry knows only digests, and a record has its own
            self.place.client.delete(path, self.place.client.head(path, name))
        return f"{REPOSITORY}:{name}"

    def _repositories(self) -> Iterable[str]:
        return dict.fromkeys([*(facts.repository for facts in self.image_set.matrix.frameworks.values()), PARTS])

    def _entries(self, book: Records, names: Iterable[str]) -> Iterator[Entry]:
        keys = [(target, architecture) for target, _, architecture in (name.rpartition(".") for name in names)]
        found = book.read_all(keys)
        if lost := [key for key in keys if key not in found]:
            # What an entry names that cannot be read might be thrown away.
            raise RosmlError(
                f"the records' entry {'.'.join(lost[0])} cannot be read: nothing can be said to be unused",
                "publish that image again, or use the version of this program that wrote it",
            )
        yield from found.values()

    def _old(self, tags: Iterable[str], oldest: date) -> Iterator[str]:
        """Dated tags that are too old, but for the newest of each image."""
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
        """Those of some digests that are there, and the images of those that are indexes."""
        todo, found = {digest for digest in digests if digest}, set[str]()
        while todo:
            # An image is there if an index names it: a registry takes no index without its images.
            found |= {digest for digest in todo if (path, digest) in self._images}
            manifests = [item for item in side_by_side(partial(self._manifest, path), todo - found) if item]
            found |= {manifest.digest for manifest in manifests}
            todo = {item.digest for manifest in manifests for item in manifest.members} - found
        return found

    def _attached(self, path: str, digest: str) -> list[str]:
        """What is attached to a manifest, and to that; what is attached last comes first."""
        todo, found = [digest], list[str]()
        while todo:
            below = [item["digest"] for item in self.place.client.referrers(path, todo.pop(0))]
            todo += [item for item in below if item not in found]
            found += [item for item in below if item not in found]
        return found[::-1]


def _day(text: str) -> date:
    """`20261122` as a day; one that is never too old where it is none."""
    try:
        return date(int(text[:4]), int(text[4:6]), int(text[6:8]))
    except ValueError:
        return date.max
