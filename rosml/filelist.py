"""The lists of files of images and payloads: made in the builder, attached in the registry, compared before a join.

Two parts that carry the same file would hide one another's: the later layer wins, without a word. Each list is an
artifact beside the image that it is of, so that whoever joins images in a registry need not pull them to see that.
"""

from __future__ import annotations

import os
import tempfile
import threading
import zlib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosml import oci
from rosml.errors import RosmlError
from rosml.join import platform
from rosml.oci import Manifest, Registry

if TYPE_CHECKING:
    from rosml.expand import Catalogue
    from rosml.services import Services

ARTIFACT = "application/vnd.rosml.files.v1"
MEDIA_TYPE = "application/vnd.rosml.files.v1+gzip"
TARGET = "file-list"
"""The bake target that makes a list."""

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
    """Lists of files by the digest of the image; each is downloaded once. Safe to share among threads.

    Attributes:
        cache: folder for what was downloaded.
    """

    def __init__(self, cache: Path) -> None:
        self.cache = cache
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
        return Files.parse(unpacked(self._blob(registry, repository, artifact.content["layers"][0]["digest"])))

    def _blob(self, registry: Registry, repository: str, digest: str) -> bytes:
        file = self.cache / digest.replace(":", "-")
        try:
            data = file.read_bytes()
            if oci.digest_of(data) == digest:
                return data
        except OSError:
            pass
        data = registry.blob(repository, digest)
        try:
            self.cache.mkdir(parents=True, exist_ok=True)
            descriptor, name = tempfile.mkstemp(dir=self.cache)
            with os.fdopen(descriptor, "wb") as stream:
                stream.write(data)
            os.replace(name, file)
        except OSError:  # a cache that cannot be written saves nothing, and breaks nothing
            pass
        return data


def attach_files(
    services: Services,
    catalogue: Catalogue,
    registry: Registry,
    repository: str,
    digest: str,
    say: Callable[[str], None],
) -> list[str]:
    """Lists the files of an image that was pushed, for each of its platforms, and attaches the lists to it.

    The builder mounts the image, which it has where it built it, and runs nothing of it: no emulation is needed.
    A manifest that has its list keeps it.

    Args:
        services: the builder. catalogue: for the system whose tools make the list.
        registry: where the image is. repository: its path there. digest: of a manifest, or of an index.
        say: told what is going on, a line at a time.

    Returns:
        Digests of the lists' artifacts that were attached now.

    Raises:
        RosmlError: the image is not there; the build failed; the registry refuses.
    """
    attached = []
    for manifest in _manifests(registry, repository, digest):
        if registry.referrers(repository, manifest.digest, ARTIFACT):
            continue
        say(f"list the files of {repository}@{manifest.digest}")
        data = _made(services, catalogue, registry, repository, manifest)
        attached.append(registry.attach(repository, manifest.descriptor, ARTIFACT, data, MEDIA_TYPE))
    return attached


def attach(registry: Registry, repository: str, manifest: Manifest, data: bytes) -> str:
    """Attaches a list that was made elsewhere to an image manifest; gives the artifact's digest.

    Args:
        data: sorted lines, gzip'd.
    """
    unpacked(data)
    return registry.attach(repository, manifest.descriptor, ARTIFACT, data, MEDIA_TYPE)


def _manifests(registry: Registry, repository: str, digest: str) -> list[Manifest]:
    """A manifest itself, or those of an index that are for a platform."""
    found = registry.manifest(repository, digest)
    if found is None:
        raise RosmlError(f"{registry.host}/{repository}@{digest} is not there", "push it first")
    if not found.is_index:
        return [found]
    entries = [entry for entry in found.content["manifests"] if "unknown" not in platform(entry.get("platform", {}))]
    return [manifest for entry in entries for manifest in _manifests(registry, repository, entry["digest"])]


def _made(services: Services, catalogue: Catalogue, registry: Registry, repository: str, manifest: Manifest) -> bytes:
    from rosml import base_images, builder, names
    from rosml.publish import write_excerpt

    config: dict[str, Any] = registry.json_blob(repository, manifest.content["config"]["digest"])
    os_name = catalogue.matrix.default.assembler
    base = base_images.ensure(services, catalogue.matrix.operating_systems[os_name], say=lambda _: None)
    file = write_excerpt(services, catalogue, TARGET)
    (services.state / "tmp").mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=services.state / "tmp") as folder:
        sets = (
            f"{TARGET}.output=type=local,dest={folder}",
            f"{TARGET}.platform={platform(config)}",
            f"{TARGET}.contexts.listed=docker-image://{registry.host}/{repository}@{manifest.digest}",
        )
        variables = {names.os_variable(os_name): f"docker-image://{base}"}
        short = manifest.digest.partition(":")[2][:12]
        builder.run(services, builder.Bake(TARGET, f"{TARGET}-{short}", file, sets, variables))
        data = (Path(folder) / "files.gz").read_bytes()
    if not unpacked(data):
        raise RosmlError(f"the list of the files of {repository}@{manifest.digest} is empty", "run it again")
    return data
