"""Unpacks the output of a build: only regular files of an archive.

Steps of a build run code of a repository and of its dependencies, so the names, kinds, sizes and contents of their output may be
a stranger's. BuildKit's exporter into a folder would also make their links, pipes and devices on this machine. So the builder
writes an archive (`type=tar`), and this module writes the files in it.
"""

from __future__ import annotations

import errno
import shutil
import tarfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from rosml.base import archives
from rosml.base.errors import RosmlError

MEGABYTE = 1 << 20
DEPTH = 100
"""Parts of a path. Python's mkdir calls itself for each folder above."""


@dataclass(frozen=True)
class Limits:
    """The limits of a build's output: the number of entries of any kind, the bytes of a file, the bytes of all files."""

    entries: int = 20_000
    each: int = 16 * MEGABYTE
    total: int = 64 * MEGABYTE


TESTS = Limits()
OURS = Limits(entries=1000, each=64 * MEGABYTE, total=512 * MEGABYTE)
"""The limits for rosml's own steps, whose largest output is the lists of images' files."""

_KINDS = {
    tarfile.SYMTYPE: "a link",
    tarfile.LNKTYPE: "a link",
    tarfile.FIFOTYPE: "a pipe",
    tarfile.CHRTYPE: "a device",
    tarfile.BLKTYPE: "a device",
}


def output(archive: Path) -> str:
    return f"type=tar,dest={archive}"


def unpack(
    archive: Path, folder: Path, select: Callable[[PurePosixPath], bool] = lambda path: True, limits: Limits = TESTS
) -> dict[str, str]:
    """Writes the files of an archive for which `select` holds into a folder, whose former content it removes.

    Returns:
        By path, why an entry was not written: no regular file, too large, or a name that cannot be shown.
    """
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    refused: dict[str, str] = {}
    count = total = 0
    try:
        with tarfile.open(archive, "r:", tarinfo=archives.Entry, errors="surrogateescape") as entries:
            for entry in entries:
                count += 1
                if count > limits.entries:
                    raise RosmlError(f"the build left more than {limits.entries:,} files", "have its tests write fewer")
                path = PurePosixPath(entry.name)
                if entry.isdir():
                    continue
                if reason := _refusal(entry, path, limits):
                    refused[_shown(path)] = reason
                    continue
                if not select(path):
                    continue
                total += entry.size
                if total > limits.total:
                    text = f"the build left more than {limits.total // MEGABYTE} MB of reports"
                    raise RosmlError(text, "have its tests write less")
                stream = entries.extractfile(entry)
                assert stream is not None, "it is a regular file"
                try:
                    (folder / path).parent.mkdir(parents=True, exist_ok=True)
                    (folder / path).write_bytes(stream.read(entry.size))
                except OSError as error:
                    if error.errno not in _NAMES:
                        raise
                    refused[_shown(path)] = "there cannot be a file of that name"
    except FileNotFoundError:
        raise RosmlError(f"the build left no report in {archive}", "run it again") from None
    except (tarfile.TarError, EOFError, ValueError) as error:
        raise RosmlError(f"what the build left in {archive} is damaged: {error}", "run it again") from None
    return refused


_NAMES = (errno.EEXIST, errno.EISDIR, errno.ELOOP, errno.ENAMETOOLONG, errno.ENOTDIR)


def _refusal(entry: tarfile.TarInfo, path: PurePosixPath, limits: Limits) -> str:
    if path.is_absolute() or not path.parts or ".." in path.parts:
        return "its path leads elsewhere"
    if entry.type not in (tarfile.REGTYPE, tarfile.AREGTYPE):
        return f"it is {_KINDS.get(entry.type, 'no file')}, and not a file"
    if not str(path).isprintable() or any(len(part.encode(errors="replace")) > 255 for part in path.parts):
        return "its name cannot be shown"
    if len(path.parts) > DEPTH:
        return f"it is below more than {DEPTH} folders"
    if entry.size > limits.each:
        return f"it has {entry.size // MEGABYTE} MB, and {limits.each // MEGABYTE} MB are read at most"
    return ""


def _shown(path: PurePosixPath) -> str:
    """A path that is safe to print."""
    return ascii(str(path))[1:-1] if not str(path).isprintable() else str(path)


def read(folder: Path, name: str) -> bytes:
    try:
        return (folder / name).read_bytes()
    except OSError as error:
        raise RosmlError(f"the build left no {name}: {error.strerror}", "run it again") from None
