"""Entries of tar archives that somebody else made."""

from __future__ import annotations

import tarfile
from typing import Self

HEADER_BYTES = 1 << 20
"""Bytes of what stands before an entry: long names, and extended headers. tarfile reads it whole."""

_HEADERS = (
    tarfile.GNUTYPE_LONGNAME,
    tarfile.GNUTYPE_LONGLINK,
    tarfile.XHDTYPE,
    tarfile.XGLTYPE,
    tarfile.SOLARIS_XHDTYPE,
)


class Entry(tarfile.TarInfo):
    """An entry that is an error where it is damaged, which tarfile takes for the end, or where more than HEADER_BYTES stand before
    it. Give it to `tarfile.open` as `tarinfo`."""

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
