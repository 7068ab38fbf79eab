"""Tar archives, and files of gzip, zstd and zip, from outside. No other module unpacks what is compressed, and each function has a limit."""

from __future__ import annotations

import io
import re
import struct
import sys
import tarfile
import zipfile
import zlib
from collections.abc import Iterable, Iterator
from typing import IO, Any, Self

if sys.version_info >= (3, 14):
    import compression.zstd as _zstd
else:
    import backports.zstd as _zstd

zstd = _zstd

HEADER_BYTES = 1 << 20
"""The largest header before an entry: a long name or an extended header. tarfile reads it whole."""

MEMBERS = 100
"""The most members that a gzip file may have. Most have one."""

EMPTY = 1000
"""The most members or frames without content in a file that has any number of others."""

PIECE = 1 << 20
"""The most bytes that are unpacked at a time."""

_FED = 16 << 10

_HEADERS = (
    tarfile.GNUTYPE_LONGNAME,
    tarfile.GNUTYPE_LONGLINK,
    tarfile.XHDTYPE,
    tarfile.XGLTYPE,
    tarfile.SOLARIS_XHDTYPE,
)


def gunzipped(data: bytes, limit: int) -> bytes:
    """The content of all members of a gzip file, at most `limit` bytes. Raises ValueError."""
    content = bytearray()
    for _ in range(MEMBERS):
        state = zlib.decompressobj(wbits=31)
        try:
            content += state.decompress(data, limit - len(content) + 1)
        except zlib.error as error:
            raise ValueError(str(error)) from None
        if not state.eof or len(content) > limit:
            break
        data = state.unused_data
        if not data:
            return bytes(content)
    raise ValueError("it is damaged, or too large")


def unpacked(blocks: Iterable[bytes]) -> Iterator[bytes]:
    """The content of a file of gzip or zstd, or of one that is not compressed, in pieces of at most PIECE. The caller limits their sum."""
    # What follows a member is copied at its end, so pieces are small: a file may have many members.
    source = (block[at : at + _FED] for block in blocks for at in range(0, len(block), _FED))
    block = b""
    while len(block) < 4 and (more := next(source, b"")):
        block += more
    if block.startswith((b"\x1f\x8b", zstd_magic := b"\x28\xb5\x2f\xfd")):
        yield from _unpacked(block, source, block.startswith(zstd_magic))
        return
    yield block
    yield from source


def _unpacked(block: bytes, source: Iterator[bytes], is_zstd: bool) -> Iterator[bytes]:
    empty = 0
    try:
        while block:
            state: Any = zstd.ZstdDecompressor() if is_zstd else zlib.decompressobj(wbits=31)
            size = 0
            while not state.eof:
                piece = state.decompress(block, PIECE)
                size += len(piece)
                yield piece
                block = b"" if is_zstd else state.unconsumed_tail
                if not state.eof and (state.needs_input if is_zstd else not block):
                    block = next(source, b"")
                    if not block:
                        raise ValueError("it ends too early")
            empty += not size
            if empty > EMPTY:
                raise ValueError(f"it has more than {EMPTY} parts without content")
            block = state.unused_data or next(source, b"")
            while not is_zstd and block and not (block := block.lstrip(b"\0")):  # gzip lets zeros follow
                block = next(source, b"")
    except (zlib.error, zstd.ZstdError) as error:
        raise ValueError(str(error)) from None


class Frames:
    """A file of zstd, frame by frame. A frame says in its header how large its content is."""

    _HEADER = 18
    """The largest header of a frame."""

    def __init__(self, blocks: Iterable[bytes], window: int) -> None:
        """`window` is the most that a frame refers back to, as a power of two."""
        self._blocks, self._rest = iter(blocks), b""
        self._options: dict[int, int] = {zstd.DecompressionParameter.window_log_max: window}

    def next(self, limit: int, prefix: bytes | bytearray = b"") -> bytes:
        """The content of the next frame, at most `limit` bytes, which may refer to `prefix`. Raises ValueError."""
        dictionary = zstd.ZstdDict(prefix, is_raw=True).as_prefix if prefix else None
        del prefix  # there is a copy
        try:
            while len(self._rest) < self._HEADER and (block := next(self._blocks, b"")):
                self._rest += block
            size = zstd.get_frame_info(self._rest).decompressed_size
            if size is None or size > limit:
                raise ValueError(f"a frame has {size} bytes, and at most {limit:,} are read")
            frame = zstd.ZstdDecompressor(dictionary, self._options)
            content, block = bytearray(), self._rest
            while not frame.eof:
                # A header may lie: what is read beyond its size ends the reading.
                content += frame.decompress(block, size + 1 - len(content))
                block = b""
                if len(content) > size:
                    raise ValueError(f"a frame has more than the {size} bytes that it says")
                if not frame.eof and frame.needs_input and not (block := next(self._blocks, b"")):
                    raise ValueError("it ends too early")
            self._rest = frame.unused_data
        except zstd.ZstdError as error:
            raise ValueError(str(error)) from None
        return bytes(content)

    def end(self) -> bool:
        return not self._rest and not next(self._blocks, b"")


_PACKINGS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
"""How files of a zip archive may be packed. zipfile unpacks others without a limit."""

_BAD_ZIP = (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, OSError, RuntimeError, struct.error)
"""What zipfile raises for a damaged archive, besides ValueError."""


def file_of_zip(source: IO[bytes], pattern: str, limit: int) -> bytes:
    """The first file of a zip archive whose whole path matches a pattern, at most `limit` bytes. Raises ValueError."""
    try:
        with zipfile.ZipFile(source) as archive:
            entry = next((entry for entry in archive.infolist() if re.fullmatch(pattern, entry.filename)), None)
            if entry is None:
                raise ValueError("it lacks the file")
            if entry.compress_type not in _PACKINGS:
                raise ValueError("the file is packed in an unusual way")
            with archive.open(entry) as stream:
                content = stream.read(limit + 1)
    except _BAD_ZIP as error:
        raise ValueError(str(error)) from None
    if len(content) > limit:
        raise ValueError(f"the file has more than {limit:,} bytes")
    return content


class Entry(tarfile.TarInfo):
    """The `tarinfo` for `tarfile.open`: a damaged entry, or one with a header that takes hours, is an error, not the archive's end."""

    @classmethod
    def fromtarfile(cls, archive: tarfile.TarFile) -> Self:
        try:
            return super().fromtarfile(archive)
        except tarfile.HeaderError as error:
            if type(error).__name__ in ("InvalidHeaderError", "TruncatedHeaderError"):
                raise tarfile.ReadError(str(error)) from None
            raise

    def _proc_member(self, archive: tarfile.TarFile) -> Self:
        if self.type in _HEADERS and self.size > HEADER_BYTES:
            raise tarfile.ReadError(f"a header has {self.size} bytes")
        entry: Self = super()._proc_member(archive)  # type: ignore[misc]
        return entry

    def _proc_pax(self, archive: tarfile.TarFile) -> Self:
        under: Any = archive.fileobj
        data = under.read(-(-self.size // tarfile.BLOCKSIZE) * tarfile.BLOCKSIZE)
        _require_records(data[: self.size])
        archive.fileobj = _Read(archive, under, data)  # type: ignore[assignment] # tarfile reads it again
        entry: Self = super()._proc_pax(archive)  # type: ignore[misc]
        return entry


_RUN = re.compile(rb"[0-9]{101}")
"""More digits than a header needs. tarfile looks for a number at each of them, up to the last one."""

_LENGTH = re.compile(rb"([0-9]{1,20}) [^=\n]")


def _require_records(data: bytes) -> None:
    """Raises tarfile.ReadError unless an extended header is records of `LENGTH NAME=VALUE` and a line's end, without very long numbers.

    In other headers, tarfile searches from each record to the end.
    """
    at, data = 0, data.rstrip(b"\0")
    while at < len(data):
        match = _LENGTH.match(data, at)
        end = at + int(match[1]) if match else 0
        if not match or not match.end() < end <= len(data) or data[end - 1] != 0x0A or data.find(b"=", at, end) < 0:
            raise tarfile.ReadError("an extended header is damaged")
        at = end
    if _RUN.search(data):
        raise tarfile.ReadError("an extended header has a number of more than 100 digits")


class _Read:
    """Gives a piece that was read already, then makes way for the file."""

    def __init__(self, archive: tarfile.TarFile, under: Any, data: bytes) -> None:
        self._archive, self._under, self._data = archive, under, data

    def read(self, _size: int) -> bytes:
        self._archive.fileobj = self._under
        return self._data


def stream(blocks: Iterator[bytes]) -> io.BufferedReader:
    """What `unpacked` gives, as a file-like object, such as for tarfile."""
    return io.BufferedReader(_Blocks(unpacked(blocks)))


class _Blocks(io.RawIOBase):
    def __init__(self, blocks: Iterator[bytes]) -> None:
        self._blocks, self._rest = blocks, memoryview(b"")

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: Any) -> int:
        while not self._rest and (block := next(self._blocks, None)) is not None:
            self._rest = memoryview(block)
        piece, self._rest = self._rest[: len(buffer)], self._rest[len(buffer) :]
        buffer[: len(piece)] = piece
        return len(piece)
