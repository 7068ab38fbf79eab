"""The lists of files of images and parts: made in the builder, attached in the registry, compared before a join.

Two parts that carry the same file would hide one another's: the later layer wins, without a word. Each list is an
artifact beside the image that it is of, so that whoever joins images in a registry need not pull them to see that.
"""

from __future__ import annotations

import os
import threading
import zlib
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.registry.oci import Registry

ARTIFACT = "application/vnd.rosml.files.v1"
MEDIA_TYPE = "application/vnd.rosml.files.v1+gzip"

LARGEST = 256 << 20
"""Bytes of a list, unpacked; that of the largest image has some 20 MB."""

_MERGED = ("bin", "lib", "lib32", "lib64", "libx32", "sbin")
"""Links to folders below /usr in all systems that images are made of."""


@dataclass(frozen=True)
class Files:
    """The files and links of an image, without a slash at the beginning.

    Attributes:
        entries: as they are listed. places: the same where they really are: /lib is a link to /usr/lib.
        folders: all folders above `entries`.
    """

    entries: frozenset[str]
    places: frozenset[str]
    folders: frozenset[str]

    @classmethod
    def parse(cls, text: bytes) -> Files:
        """The files of a list, which has one on each line."""
        entries = frozenset(line for line in os.fsdecode(text).split("\n") if line)
        folders: set[str] = set()
        for entry in entries:
            folder = entry.rpartition("/")[0]
            while folder and folder not in folders:
                folders.add(folder)
                folder = folder.rpartition("/")[0]
        return cls(entries, frozenset(map(_place, entries)), frozenset(folders))


def _place(entry: str) -> str:
    first, slash, _ = entry.partition("/")
    return f"usr/{entry}" if slash and first in _MERGED else entry


def clash(one: Files, other: Files) -> str:
    """A file that both carry, or that is a folder in one of them; the first by name. Empty if there is none."""
    found = (one.places & other.places) | (one.folders & other.entries) | (one.entries & other.folders)
    return min(found, default="")


def unpacked(data: bytes) -> bytes:
    """A list as it was before it was compressed.

    Raises:
        RosmlError: it is damaged, or larger than any list.
    """
    state = zlib.decompressobj(wbits=31)
    try:
        text = state.decompress(data, LARGEST)
    except zlib.error:
        text = b""
    if not state.eof:
        raise RosmlError("a list of files is damaged", "attach it anew: publish the image again")
    return text


class Lists:
    """Lists of files by the digest of the image; each is downloaded once. Safe to share among threads."""

    def __init__(self) -> None:
        self._known: dict[tuple[str, str, str], Files | None] = {}
        self._clashes: dict[tuple[int, int], str] = {}
        self._lock = threading.Lock()

    def of(self, registry: Registry, repository: str, digest: str) -> Files | None:
        """The files of an image manifest; None if it has no list.

        Raises:
            RosmlError: the registry does not answer; or the list is damaged.
        """
        key = (registry.host, repository, digest)
        if key not in self._known:
            found = self._find(registry, repository, digest)
            with self._lock:
                self._known.setdefault(key, found)
        return self._known[key]

    def clash(self, one: Files, other: Files) -> str:
        """As the function of that name; looked at once for lists that are the same objects."""
        key = (id(one), id(other))  # lists live as long as this
        if key not in self._clashes:
            self._clashes[key] = clash(one, other)
        return self._clashes[key]

    def _find(self, registry: Registry, repository: str, digest: str) -> Files | None:
        entries = registry.referrers(repository, digest, ARTIFACT)
        if not entries:
            return None
        # The same files may have been listed by two publishers: in any order, the same one is taken.
        artifact = registry.manifest(repository, min(entry["digest"] for entry in entries))
        if artifact is None or not artifact.content.get("layers"):
            return None
        return Files.parse(unpacked(registry.blob(repository, artifact.content["layers"][0]["digest"])))
