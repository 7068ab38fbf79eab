"""OCI archives: a tar file of an OCI image layout. They are written in one go, and read as a stranger's word.

https://github.com/opencontainers/image-spec/blob/main/image-layout.md
"""

from __future__ import annotations

import hashlib
import json
import tarfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import IO, Any, BinaryIO, NoReturn

from rosml.base import archives
from rosml.base.errors import RosmlError
from rosml.registry import oci

LAYOUT = "oci-layout"
INDEX = "index.json"
DOCKER = "manifest.json"
"""Docker's own list of what an archive holds. Docker before 25 knows no other."""

LEFT_OUT = "io.rosml.left-out"
"""The annotation of an index about layers that are not in the archive: their digests by the image that has them."""

PATCHES = "io.rosml.patches"
"""The annotation of an index about patches: by the new layer's digest, a descriptor with `old`, the older layer, and `image`, which has it."""

NAME, TAG = "io.containerd.image.name", "org.opencontainers.image.ref.name"
"""Annotations of an image in an archive: its whole name, by which engines call it; and its tag alone."""

ENTRIES = 4096
"""The most entries that an archive may have. An image has at most some hundred layers."""

BLOCK = 1 << 20

Write = Callable[[Iterable[bytes]], None]
Send = Callable[[Write], object]
"""Sends the pieces of a blob to a function; again, from the beginning, if the connection broke."""
Advance = Callable[[int], object]
"""Is called with numbers of bytes that were read or written."""

_AGAIN = "copy it again, or save it again with rosml save"


def path(digest: str) -> str:
    return f"blobs/{digest.replace(':', '/')}"


class Sink:
    """A blob that arrives, perhaps in several attempts from its beginning on."""

    def __init__(self, out: IO[bytes], digest: str, size: int, advance: Advance) -> None:
        self._out, self._digest, self._size, self._advance = out, digest, size, advance
        self._state, self._written = hashlib.new(digest.partition(":")[0]), 0

    def write(self, blocks: Iterable[bytes]) -> None:
        skip = self._written
        for block in blocks:
            rest = block[skip:]
            skip -= len(block) - len(rest)
            if self._written + len(rest) > self._size:
                raise RosmlError(f"{self._digest} has more than {self._size} bytes", _AGAIN)
            self._out.write(rest)
            self._state.update(rest)
            self._written += len(rest)
            self._advance(len(rest))

    def end(self) -> None:
        if self._written != self._size:
            raise RosmlError(f"{self._digest} has {self._written} bytes instead of {self._size}", _AGAIN)
        if self._state.hexdigest() != self._digest.partition(":")[2]:
            raise RosmlError(f"{self._digest} has another digest: it is damaged", _AGAIN)


def receive(digest: str, size: int, send: Send, out: IO[bytes], advance: Advance = lambda _: None) -> None:
    """Writes a blob into a file, and raises a RosmlError if it has another size or digest."""
    sink = Sink(out, digest, size, advance)
    send(sink.write)
    sink.end()


def send_file(file: IO[bytes], write: Write) -> None:
    """A `Send` of a file."""
    file.seek(0)
    write(iter(partial(file.read, BLOCK), b""))


class Writer:
    """Writes an archive. The same calls give the same bytes."""

    def __init__(self, out: BinaryIO) -> None:
        self._out = out
        self.text(LAYOUT, oci.encoded({"imageLayoutVersion": "1.0.0"}))

    def text(self, name: str, data: bytes) -> None:
        self._head(name, len(data))
        self._out.write(data + bytes(-len(data) % tarfile.BLOCKSIZE))

    def blob(self, digest: str, size: int, send: Send, advance: Advance = lambda _: None) -> None:
        self._head(path(digest), size)
        receive(digest, size, send, self._out, advance)
        self._out.write(bytes(-size % tarfile.BLOCKSIZE))

    def end(self) -> None:
        self._out.write(bytes(2 * tarfile.BLOCKSIZE))
        self._out.flush()

    def _head(self, name: str, size: int) -> None:
        entry = tarfile.TarInfo(name)
        entry.size, entry.mode, entry.mtime = size, 0o644, 0
        self._out.write(entry.tobuf(tarfile.GNU_FORMAT))


def index(
    manifest: Mapping[str, Any],
    name: str,
    left_out: Mapping[str, Sequence[str]],
    patches: Mapping[str, Mapping[str, Any]] | None = None,
) -> bytes:
    """The index of an archive with one image.

    Args:
        manifest: its descriptor.
        name: its complete reference with a tag; empty if it has none.
        left_out: as LEFT_OUT has it. patches: as PATCHES has it.
    """
    names = {NAME: name, TAG: name.rpartition(":")[2]} if name else {}
    annotations = {LEFT_OUT: left_out, PATCHES: patches or {}}
    encoded = {key: oci.encoded(value).decode() for key, value in annotations.items() if value}
    entry = {**manifest, **({"annotations": names} if names else {})}
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [entry]}
    return oci.encoded({**content, **({"annotations": encoded} if encoded else {})})


def for_docker(config: str, layers: Iterable[str], name: str) -> bytes:
    """Docker's own list of the image: the digests of its config and its layers, lowest first, and its name, which may be empty."""
    tags = [name] if name else None
    return json.dumps([{"Config": path(config), "RepoTags": tags, "Layers": [path(item) for item in layers]}]).encode()


class Archive:
    """An archive that somebody gave us. Only files of known names are read, each once, and nothing is unpacked. Its name is for messages."""

    def __init__(self, file: IO[bytes], name: str) -> None:
        self.name, self._file = name, file
        self._length = file.seek(0, 2)
        if not self._length:
            text = f"{name} is empty: the program that wrote or copied it had no space, or was interrupted"
            raise RosmlError(text, _AGAIN, exit_code=2)
        self._places: dict[str, tuple[int, int]] = {}
        file.seek(0)
        for entry in entries(file, "r:", name):
            self._add(entry)
        if LAYOUT not in self._places or INDEX not in self._places:
            raise RosmlError(f"{name} is no OCI archive: it has no {LAYOUT} or no {INDEX}", _AGAIN, exit_code=2)

    def _add(self, entry: tarfile.TarInfo) -> None:
        name = entry.name.removeprefix("./").rstrip("/")
        if entry.isdir() or not (name in (LAYOUT, INDEX) or name.startswith("blobs/")):
            return
        if not is_plain(entry):
            raise self.damaged(f"{name[:100]!r} is no plain file")
        if name in self._places:
            raise self.damaged(f"it has {name[:100]!r} twice")
        if entry.offset_data + entry.size > self._length:
            raise self.damaged(f"it ends within {name[:100]}")
        self._places[name] = entry.offset_data, entry.size

    def size(self, digest: str) -> int | None:
        """The size of a blob in bytes; None if the archive lacks it."""
        place = self._places.get(path(digest))
        return place and place[1]

    def text(self, name: str, limit: int) -> bytes:
        """A file of at most `limit` bytes."""
        if name not in self._places:
            raise self.damaged(f"it lacks {name}")
        offset, size = self._places[name]
        if size > limit:
            raise self.damaged(f"{name} has {size:,} bytes, and at most {limit:,} are read")
        return self._read(offset, size)

    def small_blob(self, digest: str, limit: int) -> bytes:
        data = self.text(path(digest), limit)
        if hashlib.new(digest.partition(":")[0], data).hexdigest() != digest.partition(":")[2]:
            raise self.damaged(f"{digest} has another digest")
        return data

    def blocks(self, digest: str) -> Iterator[bytes]:
        """The pieces of a blob that the archive has. The reader checks the digest."""
        offset, size = self._places[path(digest)]
        end = offset + size
        while offset < end:
            block = self._read(offset, min(BLOCK, end - offset))
            if not block:
                raise self.damaged(f"it ends within {digest}")
            offset += len(block)
            yield block

    def _read(self, offset: int, size: int) -> bytes:
        try:
            self._file.seek(offset)
            return self._file.read(size)
        except OSError as error:
            raise RosmlError(f"{self.name} cannot be read: {error.strerror}", "copy it to another disk first") from None

    def damaged(self, why: str) -> RosmlError:
        return RosmlError(f"{self.name} is damaged: {why}", _AGAIN)


def entries(file: Any, mode: Any, name: str) -> Iterator[tarfile.TarInfo]:
    """The entries of a tar file. `mode` is tarfile's: `r:` for a file, `r|` for a pipe."""
    try:
        with tarfile.open(fileobj=file, mode=mode, tarinfo=_Entry, bufsize=BLOCK) as archive:
            for number, entry in enumerate(archive):
                if number >= ENTRIES:
                    raise RosmlError(f"{name} has more than {ENTRIES:,} entries", _AGAIN, exit_code=2)
                if entry.size < 0:
                    raise tarfile.ReadError("a size is below 0")
                archive.members = []  # type: ignore[attr-defined] # tarfile would keep them all
                entry.content = archive  # type: ignore[attr-defined] # to read it from a pipe
                yield entry
    except (tarfile.TarError, EOFError, ValueError, OverflowError) as error:
        raise RosmlError(f"{name} is no tar file, or is damaged: {error}", _AGAIN, exit_code=2) from None


def is_plain(entry: tarfile.TarInfo) -> bool:
    """Whether an entry is a file with its content behind it: no link, and no device."""
    return entry.type in (tarfile.REGTYPE, tarfile.AREGTYPE)


class _Entry(archives.Entry):
    """An entry, but of no file with holes: tarfile would read a list of them, as long as the archive is."""

    def _refuse(self, *_: object) -> NoReturn:
        raise tarfile.ReadError("it has a file with holes")

    _proc_sparse = _proc_gnusparse_00 = _proc_gnusparse_01 = _proc_gnusparse_10 = _refuse
