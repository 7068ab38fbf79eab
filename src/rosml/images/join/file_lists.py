"""The lists of files of images and parts: made in the builder, attached in the registry, compared before a join.

If two parts carry the same file, the later layer silently hides the other's file. Each list is an artifact attached to
its image, so that a join in a registry need not pull images to find such files.
"""

from __future__ import annotations

import os
import threading
from dataclasses import dataclass

from rosml.base import archives
from rosml.base.errors import RosmlError
from rosml.registry.client import Registry

ARTIFACT = "application/vnd.rosml.files.v1"
MEDIA_TYPE = "application/vnd.rosml.files.v1+gzip"

LARGEST = 64 << 20
"""Most bytes of a list, unpacked, and of the names of all folders in it. The list of the largest image has some 20
MB."""

PACKED = 16 << 20
"""Most bytes of a list as it is stored. The list of the largest image has 2 MB."""

LINES = 2_000_000
"""Most files of a list. The largest image has some 300,000."""

LONGEST = 4096
"""Most characters of a path, as on Linux."""

ATTACHED = 4
"""Most lists of one image. An image has one list from each publisher."""

LAYERS = 32
"""Most layers of one list. An image has a list for each image that it was joined from."""

_REMEDY = "attach it again: publish the image again"

_MERGED = ("bin", "lib", "lib32", "lib64", "libx32", "sbin")
"""These are links to folders below /usr in all operating systems of the matrix."""


@dataclass(frozen=True)
class Files:
    """The paths of an image's files and links, without a slash at the beginning.

    Attributes:
        entries: as they are listed.
        places: the same with links resolved, since /lib is a link to /usr/lib.
        folders: all folders above `entries`.
    """

    entries: frozenset[str]
    places: frozenset[str]
    folders: frozenset[str]

    @classmethod
    def parse(cls, text: bytes) -> Files:
        """The files in the text of a list, which has one path on each line.

        Raises:
            RosmlError: there are too many files or folders, or a path is too long.
        """
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


def _place(entry: str) -> str:
    first, slash, _ = entry.partition("/")
    return f"usr/{entry}" if slash and first in _MERGED else entry


def clash(one: Files, other: Files) -> str:
    """A file that both images carry, or that is a folder in the other one; the first by name. Empty if there is
    none."""
    found = (one.places & other.places) | (one.folders & other.entries) | (one.entries & other.folders)
    return min(found, default="")


def unpacked(data: bytes) -> bytes:
    """The text of a compressed list, from all members of the gzip file.

    Raises:
        RosmlError: the list is damaged, or too large.
    """
    try:
        return archives.gunzipped(data, LARGEST)
    except ValueError:
        raise RosmlError("a list of files is damaged, or too large", _REMEDY) from None


class Lists:
    """Lists of files by image. Each is downloaded once. Safe to share among threads."""

    def __init__(self) -> None:
        self._known: dict[tuple[str, str, str], Files | None] = {}
        self._clashes: dict[tuple[int, int], str] = {}
        self._lock = threading.Lock()

    def of(self, registry: Registry, repository: str, digest: str) -> Files | None:
        """The files of an image manifest; None if it has no list.

        Raises:
            RosmlError: the registry does not answer, or the list is damaged.
        """
        key = (registry.host, repository, digest)
        if key not in self._known:
            found = self._find(registry, repository, digest)
            with self._lock:
                self._known.setdefault(key, found)
        return self._known[key]

    def clash(self, one: Files, other: Files) -> str:
        """As the function `clash`, but computed once for the same two objects."""
        key = (id(one), id(other))  # the lists live as long as this object
        if key not in self._clashes:
            self._clashes[key] = clash(one, other)
        return self._clashes[key]

    def _find(self, registry: Registry, repository: str, digest: str) -> Files | None:
        entries = registry.referrers(repository, digest, ARTIFACT)
        if not entries:
            return None
        # Several publishers may have attached a list. All of them count, so that no list hides a file.
        digests = {entry["digest"] for entry in entries}
        if len(digests) > ATTACHED:
            raise RosmlError(
                f"{registry.host}/{repository}@{digest} has {len(digests)} lists of files",
                "remove those that are not yours",
            )
        texts = []
        for name in sorted(digests):
            artifact = registry.manifest(repository, name)
            layers = (
                artifact.layers if artifact else ()
            )  # an app on another base has its own list and those of the base
            if len(layers) > LAYERS:
                text = f"a list of files at {registry.host}/{repository}@{digest} has {len(layers)} layers"
                raise RosmlError(text, _REMEDY)
            texts += [unpacked(registry.part(repository, layer, PACKED)) for layer in layers]
        return Files.parse(b"\n".join(texts)) if texts else None
