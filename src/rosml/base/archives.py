"""Tar archives and gzip files from outside."""

from __future__ import annotations

import tarfile
import zlib
from typing import Self

HEADER_BYTES = 1 << 20
"""The largest header before an entry, in bytes: a long name or an extended header. tarfile reads it whole."""

MEMBERS = 100
"""The most members that a gzip file may have. Most have one."""

_HEADERS = (
    tarfile.GNUTYPE_LONGNAME,
    tarfile.GNUTYPE_LONGLINK,
    tarfile.XHDTYPE,
    tarfile.XGLTYPE,
    tarfile.SOLARIS_XHDTYPE,
)


def gunzipped(data: bytes, limit: int) -> bytes:
    """The content of all members of a gzip file.

    Args:
        limit: the largest content, in bytes.

    Raises:
        ValueError: the file is damaged, or its content is larger.
    """
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


class Entry(tarfile.TarInfo):
    """A tar entry that raises an error if it is damaged, or if its header has more than HEADER_BYTES. tarfile itself takes a
    damaged entry for the end. Give this class to `tarfile.open` as `tarinfo`."""

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
        found: Self = super()._proc_member(archive)  # type: ignore[misc]
        return found
