"""What a registry no longer needs, by reachability: an index that a kept tag points at keeps its images, and those keep
what is attached to them. Everything else that the publisher knows of may go. Nothing is removed unless asked for, and
before anything is removed, what leads to it is looked for again: a run may have come to need it in the meantime.
"""

from __future__ import annotations

import re
import time
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from datetime import date, timedelta
from typing import Any

from rosml import ledger, provenance
from rosml.client import Client
from rosml.errors import RosmlError
from rosml.expand import Catalogue
from rosml.ledger import REPOSITORY, Entry, Ledger, order
from rosml.names import repository_path
from rosml.oci import Manifest
from rosml.pipeline import date_of, is_date
from rosml.promote import UNDO, moves

DATED = re.compile(r"-(\d{8})(?:\.\d+)?$")
"""The end of a tag that never moves."""

LOOK_SECONDS = 5.0
"""How long it counts what was seen of a repository; before a removal after that, it is looked at again."""

FALLBACK = re.compile(r"sha256-[0-9a-f]{64}")
"""Tags under which a registry without the referrers API keeps what is attached to a manifest."""

MARKS = {ledger.ARTIFACT: ledger.FACTS, provenance.MEDIA_TYPE: provenance.DEFINITION}
"""Types of artifacts of which an image needs the newest alone, and the annotation that says that a run attached them."""


@dataclass
class Pruning:
    """What can go.

    Attributes:
        tags: repository and tag. manifests: repository and digest, no tag of which is kept.
        records: tags of the ledger: records of runs that are older than what is kept.
        superseded: repository, digest of an image or index that stays, and of an artifact that is attached to it in whose
            place there is a newer one.
        kept: how many tags stay.
        needed: repository and digest of what something leads to that is kept.
        seen: where each of `tags` pointed.
    """

    tags: list[tuple[str, str]] = field(default_factory=list)
    manifests: list[tuple[str, str]] = field(default_factory=list)
    records: list[str] = field(default_factory=list)
    superseded: list[tuple[str, str, str]] = field(default_factory=list)
    kept: int = 0
    needed: set[tuple[str, str]] = field(default_factory=set)
    seen: dict[tuple[str, str], str] = field(default_factory=dict)

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {
            "tags": [":".join(item) for item in self.tags],
            "manifests": ["@".join(item) for item in self.manifests],
            "records": self.records,
            "superseded": [f"{repository}@{digest}" for repository, _, digest in self.superseded],
            "kept": self.kept,
        }


@dataclass
class Pruner:
    """Looks for what can go, and removes it.

    Attributes:
        registry: where. prefix: path of its repositories.
        catalogue: names the repositories.
        today: the day from which ages count. days: dated tags younger than that stay. newest: so many of each image stay in any case.
    """

    registry: Client
    prefix: str
    catalogue: Catalogue
    today: date
    days: int = 30
    newest: int = 3
    _read: tuple[float, dict[str, set[str]]] | None = None

    def find(self) -> Pruning:
        """What can go.

        Raises:
            RosmlError: the registry does not answer.
        """
        found = Pruning()
        oldest = self._oldest
        roots, candidates, found.records = self._book()
        for repository in self._repositories():
            path = self._path(repository)
            tags = [tag for tag in self.registry.tags(path) if not FALLBACK.fullmatch(tag)]
            going = {tag for tag in self._old(tags, oldest) if self._ours(path, tag)}
            found.tags += sorted((repository, tag) for tag in going)
            found.kept += len(tags) - len(going)
            digests = {tag: self.registry.head(path, tag) for tag in tags}
            found.seen |= {(repository, tag): digests[tag] for tag in going}
            old: dict[str, str] = {}
            kept = [*roots.get(repository, ()), *(digests[tag] for tag in tags if tag not in going)]
            keep = self._reach(path, kept, old)
            found.superseded += [(repository, subject, digest) for digest, subject in old.items()]
            found.needed.update((repository, digest) for digest in keep)
            gone = self._reach(path, [*candidates.get(repository, ()), *(digests[tag] for tag in going)])
            found.manifests += [
                (repository, digest) for digest in sorted(gone) if digest not in keep and digest not in old
            ]
        return found

    @property
    def _oldest(self) -> date:
        return self.today - timedelta(days=self.days)

    def _book(self) -> tuple[dict[str, set[str]], dict[str, set[str]], list[str]]:
        """What the ledger says: digests by repository that are needed, those that may go, and records that are too old."""
        book = Ledger(self.registry, self.prefix)
        entries = list(self._entries())
        records = [name for name in self.registry.tags(book.repository) if name.startswith(UNDO)]
        old = sorted(name for name in records if _day(name.removeprefix(UNDO)[:8]) < self._oldest)
        roots: dict[str, set[str]] = {}
        candidates: dict[str, set[str]] = {}
        for entry in entries:
            candidates.setdefault(entry.repository, set()).update(entry.superseded)
            if entry.digest:
                roots.setdefault(entry.repository, set()).add(entry.digest)
        for name in sorted(records):
            for move in moves(book, name):  # a record that is kept must be able to bring back what it names
                if move.old:
                    target = candidates if name in old else roots
                    target.setdefault(move.repository, set()).add(move.old)
        return roots, candidates, old

    def _roots(self, repository: str) -> set[str]:
        """What the ledger needs of a repository, as of some seconds ago."""
        if self._read is None or time.monotonic() > self._read[0] + LOOK_SECONDS:
            self._read = time.monotonic(), self._book()[0]
        return self._read[1].get(repository, set())

    def _needed(self, repository: str) -> set[str]:
        """What something leads to now, in a repository: a tag, the ledger, a record that is kept."""
        path = self._path(repository)
        tags = [self.registry.head(path, tag) for tag in self.registry.tags(path) if not FALLBACK.fullmatch(tag)]
        return set(self._reach(path, [*self._roots(repository), *tags]))

    def remove(self, found: Pruning) -> Iterator[str]:
        """Removes it; gives a line for each thing that is gone, or cannot go. Tags first, then what they pointed at.

        A registry that cannot delete a tag is left its manifest as well: no digest goes while a tag points at it. What
        somebody came to need since it was found stays.
        """
        stuck: set[tuple[str, str]] = set()
        for repository, tag in found.tags:
            path = self._path(repository)
            digest = self.registry.head(path, tag)
            if not digest:  # somebody else removed it
                continue
            if digest != found.seen.get((repository, tag), digest):
                yield f"{repository}:{tag} stays: it has moved since"
                continue
            try:
                self.registry.delete(path, tag)
                yield f"{repository}:{tag}"
            except RosmlError as error:
                shared = [
                    name
                    for name in self.registry.tags(path)
                    if name != tag and self.registry.head(path, name) == digest
                ]
                if shared or (repository, digest) in found.needed or digest in self._roots(repository):
                    stuck.update((repository, item) for item in self._reach(path, [digest]))
                    yield f"{repository}:{tag} stays: {error.message}"
                else:  # the registry knows only digests, and no other tag has this one
                    self.registry.delete(path, digest)
                    yield f"{repository}:{tag} with {digest}"
        where, needed, looked = "", set[str](), 0.0
        for repository, digest in found.manifests:
            path = self._path(repository)
            if (repository, digest) in stuck or not self.registry.head(path, digest):
                continue
            if repository != where or time.monotonic() > looked + LOOK_SECONDS:
                self._read = None
                where, needed, looked = repository, self._needed(repository), time.monotonic()
            if digest in needed:
                yield f"{repository}@{digest} stays: something leads to it again"
                continue
            self.registry.delete(path, digest)
            if not self.registry.head(path, digest):  # nobody has made it anew meanwhile
                self.registry.forget(path, digest)
            yield f"{repository}@{digest}"
        for repository, subject, digest in found.superseded:
            if self.registry.head(self._path(repository), digest):
                self.registry.detach(self._path(repository), subject, digest)
                yield f"{repository}@{digest}, of {subject}"
        for name in found.records:
            path = self._path(REPOSITORY)
            try:
                self.registry.delete(path, name)
            except RosmlError:  # the registry knows only digests, and a record has its own
                self.registry.delete(path, self.registry.head(path, name))
            yield f"{REPOSITORY}:{name}"

    def _repositories(self) -> Iterable[str]:
        return dict.fromkeys([*(facts.repository for facts in self.catalogue.matrix.frameworks.values()), "payload"])

    def _path(self, repository: str) -> str:
        return repository_path(self.prefix, repository)

    def _entries(self) -> Iterator[Entry]:
        book = Ledger(self.registry, self.prefix)
        names = [name for name in self.registry.tags(book.repository) if "." in name and not name.startswith(UNDO)]
        keys = [(target, architecture) for target, _, architecture in (name.rpartition(".") for name in names)]
        found = book.read_all(keys)
        if lost := [key for key in keys if key not in found]:
            # What an entry names that cannot be read might be thrown away.
            raise RosmlError(
                f"the ledger's entry {'.'.join(lost[0])} cannot be read: nothing can be said to be unused",
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

    def _ours(self, path: str, tag: str) -> bool:
        """Whether a run made what a tag points at; that of somebody else may end in a day as well."""
        found = self.registry.manifest(path, tag)
        return is_date(date_of(found))

    def _reach(self, path: str, digests: Iterable[str], old: dict[str, str] | None = None) -> dict[str, None]:
        """What hangs on some digests: themselves first, then an index's images, then what is attached.

        Args:
            path: of the repository. digests: of manifests and indexes.
            old: gets what is attached and superseded, with what it is attached to; that is left out then.
        """
        todo, found = [digest for digest in digests if digest], dict[str, None]()
        while todo:
            digest = todo.pop(0)
            manifest = None if digest in found else self.registry.manifest(path, digest)
            if manifest is None:
                continue
            found[digest] = None
            todo += [item["digest"] for item in manifest.content.get("manifests") or []]
            attached = self.registry.referrers(path, digest)
            if old is not None:
                old |= dict.fromkeys(self._superseded(path, attached), digest)
            todo += [item["digest"] for item in attached if not old or item["digest"] not in old]
        return found

    def _superseded(self, path: str, attached: Iterable[Mapping[str, Any]]) -> Iterator[str]:
        """Of what is attached to one manifest, entries of the ledger and provenance but for the newest of each. What
        others attached is theirs."""
        kinds: dict[str, list[Manifest]] = {}
        for item in attached:
            if mark := MARKS.get(str(item.get("artifactType"))):
                manifest = self.registry.manifest(path, item["digest"])
                if manifest and mark in (manifest.content.get("annotations") or {}):
                    kinds.setdefault(mark, []).append(manifest)
        for members in kinds.values():
            yield from (manifest.digest for manifest in sorted(members, key=order)[:-1])


def _day(text: str) -> date:
    """`20261122` as a day; one that is never too old where it is none."""
    try:
        return date(int(text[:4]), int(text[4:6]), int(text[6:8]))
    except ValueError:
        return date.max
