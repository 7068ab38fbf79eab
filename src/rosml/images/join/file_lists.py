"""The lists of files of images and parts: made in the builder, attached in the registry, compared before a join.

If two parts carry the same file, the later layer silently hides the other's. With attached lists, a join pulls no image.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from rosml.base import archives
from rosml.base.errors import RosmlError
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest

ARTIFACT = "application/vnd.rosml.files.v1"
MEDIA_TYPE = "application/vnd.rosml.files.v1+gzip"

LARGEST = 64 << 20
"""Most bytes of a list, unpacked, and of the names of all folders in it. That of the largest image has some 20 MB."""

PACKED = 16 << 20
"""Most bytes of a list as it is stored. The list of the largest image has 2 MB."""

LINES = 2_000_000
"""Most files of a list. The largest image has some 300,000."""

LONGEST = 4096
"""Most characters of a path, as on Linux."""

ATTACHED = 4
"""The most artifacts of one type of one image, which has one from each publisher."""

LAYERS = 32
"""Most layers of one list. An image has a list for each image that it was joined from."""

_REMEDY = "attach it again: publish the image again"

COPY = "if somebody copied the image, copy what is attached to it as well: regctl image copy --referrers"
"""The remedy for an image in a mirror that lacks what is attached to the original."""

_MERGED = ("bin", "lib", "lib32", "lib64", "libx32", "sbin")
"""These are links to folders below /usr in all operating systems of the matrix."""


@dataclass(frozen=True)
class Files:
    """The paths of an image's files and links, without a slash at the beginning."""

    entries: frozenset[str]
    places: frozenset[str]  # the same with links resolved, since /lib is a link to /usr/lib
    folders: frozenset[str]  # all folders above `entries`

    @classmethod
    def parse(cls, text: bytes) -> Files:
        """The files in the text of a list, which has one path on each line."""
        if text.count(b"\n") > LINES:
            raise RosmlError(f"a list of files has more than {LINES:,} lines", _REMEDY)
        entries = frozenset(line for line in os.fsdecode(text).split("\n") if line)
        folders: set[str] = set()
        room = LARGEST
        for entry in entries:
            if len(entry) > LONGEST:
                raise RosmlError(f"a list of files has a path of {len(entry):,} characters", _REMEDY)
            folder = entry.rpartition("/")[0]
            while folder and folder not in folders:
                folders.add(folder)
                room -= len(folder)
                folder = folder.rpartition("/")[0]
            if room < 0:
                raise RosmlError("a list of files has more folders than any image", _REMEDY)
        return cls(entries, frozenset(map(_place, entries)), frozenset(folders))


def together(lists: Sequence[Files]) -> Files:
    none = frozenset[str]()
    return Files(
        none.union(*(item.entries for item in lists)),
        none.union(*(item.places for item in lists)),
        none.union(*(item.folders for item in lists)),
    )


def _place(entry: str) -> str:
    first, slash, _ = entry.partition("/")
    return f"usr/{entry}" if slash and first in _MERGED else entry


def clash(one: Files, other: Files) -> str:
    """The first file by name that both images carry, or that is a folder in the other one; empty if there is none."""
    shared = (one.places & other.places) | (one.folders & other.entries) | (one.entries & other.folders)
    return min(shared, default="")


def unpacked(data: bytes) -> bytes:
    """The text of a compressed list, from all members of the gzip file."""
    try:
        return archives.gunzipped(data, LARGEST)
    except ValueError:
        raise RosmlError("a list of files is damaged, or too large", _REMEDY) from None


def mounted(
    source: Registry, repository: str, digest: str, registry: Registry, target: str
) -> Iterator[dict[str, Any]]:
    """The lists of an image as layers of an artifact in the repository `target`, to which their blobs are mounted or copied."""
    for artifact in _artifacts(source, repository, digest):
        for layer in artifact.layers:
            here = source.host == registry.host
            if not (here and (repository == target or registry.mount(target, layer.digest, repository))):
                registry.put_blob(target, source.part(repository, layer, PACKED))
            yield {"mediaType": layer.mediaType, "digest": layer.digest, "size": layer.size}


def attached(registry: Registry, repository: str, digest: str, artifact_type: str, what: str) -> list[Manifest]:
    """The artifacts of a type that all publishers attached to an image; `what` names several in the error about too many."""
    digests = {entry["digest"] for entry in registry.referrers(repository, digest, artifact_type)}
    if len(digests) > ATTACHED:
        text = f"{registry.host}/{repository}@{digest} has {len(digests)} {what}"
        raise RosmlError(text, "remove those that are not yours")
    return [artifact for name in sorted(digests) if (artifact := registry.manifest(repository, name))]


def _artifacts(registry: Registry, repository: str, digest: str) -> list[Manifest]:
    """The artifacts with lists of an image. Those of all publishers count, so that no list hides a file."""
    artifacts = attached(registry, repository, digest, ARTIFACT, "lists of files")
    for artifact in artifacts:  # an app on another base has its own list and those of the base
        if len(artifact.layers) > LAYERS:
            text = f"a list of files at {registry.host}/{repository}@{digest} has {len(artifact.layers)} layers"
            raise RosmlError(text, _REMEDY)
    return artifacts


class Lists:
    """Lists of files by image. Each is downloaded once. Safe to share among threads."""

    def __init__(self) -> None:
        self._lists: dict[tuple[str, str, str], Files | None] = {}
        self._clashes: dict[tuple[int, int], str] = {}
        self._lock = threading.Lock()

    def of(self, registry: Registry, repository: str, digest: str) -> Files | None:
        """The files of an image manifest; None if it has no list."""
        key = (registry.host, repository, digest)
        if key not in self._lists:
            files = self._find(registry, repository, digest)
            with self._lock:
                self._lists.setdefault(key, files)
        return self._lists[key]

    def clash(self, one: Files, other: Files) -> str:
        """Computed once for the same two objects."""
        key = (id(one), id(other))  # the lists live as long as this object
        if key not in self._clashes:
            self._clashes[key] = clash(one, other)
        return self._clashes[key]

    def _find(self, registry: Registry, repository: str, digest: str) -> Files | None:
        texts = [
            unpacked(registry.part(repository, layer, PACKED))
            for artifact in _artifacts(registry, repository, digest)
            for layer in artifact.layers
        ]
        return Files.parse(b"\n".join(texts)) if texts else None
