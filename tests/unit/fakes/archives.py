"""Archives as a builder hands them out, with whatever somebody put into them."""

from __future__ import annotations

import io
import tarfile
from collections.abc import Mapping
from pathlib import Path

LINK, HARD_LINK, PIPE, DEVICE = tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.FIFOTYPE, tarfile.CHRTYPE
FOLDER = (tarfile.DIRTYPE, "")

Content = str | bytes | tuple[bytes, str]
"""Of a file; or the kind of something else, and where it leads."""


def write(archive: Path, entries: Mapping[str, Content]) -> None:
    archive.write_bytes(packed(entries))


def packed(entries: Mapping[str, Content]) -> bytes:
    """An archive of entries in their order."""
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w") as tar:
        for name, content in entries.items():
            entry = tarfile.TarInfo(name)
            if isinstance(content, tuple):
                entry.type, entry.linkname = content
                tar.addfile(entry)
                continue
            data = content.encode() if isinstance(content, str) else content
            entry.size = len(data)
            tar.addfile(entry, io.BytesIO(data))
    return stream.getvalue()
