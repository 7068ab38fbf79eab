"""Files, written at once and read with limits."""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import IO, BinaryIO

from rosml.base.errors import RosmlError

WRITABLE = "choose a writable folder"


def write(file: Path, content: str, within: Path | None = None) -> bool:
    """Writes a file at once, so that nobody ever reads half of it. Returns whether it changed.

    Links are followed; pipes and devices, such as /dev/stdout, are written to. For a name that the user did not choose, such as one
    in a repository, `within` is the folder below which no link is followed.
    """
    return bool(write_all({file: content}, within))


def write_all(contents: Mapping[Path, str], within: Path | None = None) -> list[Path]:
    """Writes files as `write` does: all of them, or none if the disk is full. Returns those that changed."""
    staged: dict[Path, tuple[Path, Path]] = {}
    written: list[Path] = []
    try:
        for file, content in contents.items():
            with _write_errors(file):
                if within:
                    _require_within(file, within)
                if file.exists() and not file.is_file() and not file.is_dir():
                    file.write_text(content, encoding="utf-8")
                    written.append(file)
                elif _read(file) != content:
                    staged[file] = (file.resolve(), _staged(file.resolve(), content))
        for file, (real, temporary) in staged.items():
            with _write_errors(file):
                os.replace(temporary, real)
                written.append(file)
    except BaseException:  # also Ctrl-C: leave nothing behind
        for _, temporary in staged.values():
            temporary.unlink(missing_ok=True)
        raise
    return written


def require_writable(folder: Path) -> None:
    """Raises RosmlError if a folder, or the one that it would be made in, takes no files. Call it before long work whose result goes there."""
    place = next(it for it in (folder.absolute(), *folder.absolute().parents) if it.exists())
    if not place.is_dir():
        raise RosmlError(f"{shown(folder)}: cannot be written: {shown(place)} is no folder", WRITABLE)
    if not os.access(place, os.W_OK | os.X_OK):
        raise RosmlError(f"{shown(folder)}: cannot be written: {shown(place)} is read-only", WRITABLE)


@contextlib.contextmanager
def whole(file: Path) -> Iterator[BinaryIO]:
    """A large file to write. It appears under its name only if all went well, and is on the disk then. Links and devices are as in `write`."""
    import tempfile  # only needed here

    if file.exists() and not file.is_file() and not file.is_dir():
        with _write_errors(file), file.open("wb") as stream:
            yield stream
        return
    with _write_errors(file):
        real = file.resolve()
        if real.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        mode = real.stat().st_mode & 0o777 if real.exists() else 0o644
        descriptor, name = _unnamed(real.parent), str(real.parent / f".{real.name[:100]}.{os.getpid()}")
        unnamed = descriptor is not None
        if descriptor is None:
            descriptor, name = tempfile.mkstemp(dir=real.parent, prefix=f".{real.name[:100]}.")
    try:
        with _write_errors(file):
            with os.fdopen(descriptor, "wb") as stream:
                yield stream
                stream.flush()
                os.fchmod(descriptor, mode)
                os.fsync(descriptor)
                if unnamed:
                    Path(name).unlink(missing_ok=True)
                    # With src_dir_fd, linkat follows the link.
                    os.link(f"/proc/self/fd/{descriptor}", name, src_dir_fd=descriptor)
            os.replace(name, real)
            folder = os.open(real.parent, os.O_RDONLY)
            try:
                os.fsync(folder)
            finally:
                os.close(folder)
    except BaseException:  # also Ctrl-C: leave nothing behind
        Path(name).unlink(missing_ok=True)
        raise


def _unnamed(folder: Path) -> int | None:
    """A file without a name, of which nothing is left if this process is killed; None if the file system has none."""
    if not Path("/proc/self/fd").is_dir():  # without it, only root may give the file a name
        return None
    try:
        return os.open(folder, os.O_TMPFILE | os.O_WRONLY | os.O_CLOEXEC, 0o600)
    except OSError as error:
        if error.errno in (errno.EOPNOTSUPP, errno.EISDIR, errno.EINVAL, errno.ENOENT) and folder.is_dir():
            return None
        raise


def large_folder() -> str | None:
    """The folder for large temporary files: TMPDIR, or else /var/tmp, as /tmp may be in memory. None for Python's own choice."""
    return None if "TMPDIR" in os.environ or not os.path.isdir("/var/tmp") else "/var/tmp"


def temporary() -> IO[bytes]:
    """A large file in `large_folder` without a name. It goes away when it is closed, or when its process ends."""
    import tempfile  # only needed here

    return tempfile.TemporaryFile(dir=large_folder())


@contextlib.contextmanager
def _write_errors(file: Path) -> Iterator[None]:
    try:
        yield
    except (OSError, ValueError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        full = getattr(error, "errno", None) in (errno.ENOSPC, errno.EDQUOT)
        remedy = "free some disk space, then run it again" if full else WRITABLE
        raise RosmlError(f"{shown(file)}: cannot be written: {reason}", remedy) from None


def _require_within(file: Path, folder: Path) -> None:
    """Raises RosmlError if a file is not in a folder, or is a link there, or is below one."""
    top, path = folder.resolve(), folder.resolve() / os.path.relpath(file, folder)
    for place in (path, *path.parents):
        if place == top:
            return
        if place.is_symlink():
            text = f"{file}: cannot be written: {place} is a link, to {os.readlink(place)}"
            raise RosmlError(text, "remove the link, then run it again")
    raise RosmlError(f"{file}: cannot be written: it is not in {folder}", "choose a file in that folder")


def _staged(file: Path, content: str) -> Path:
    import tempfile  # only needed here

    mode = file.stat().st_mode & 0o777 if file.exists() else 0o644
    descriptor, name = tempfile.mkstemp(dir=file.parent, prefix=f".{file.name}.")
    try:
        with os.fdopen(descriptor, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(content)
        os.chmod(name, mode)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
    return Path(name)


def limited(file: Path, most: int) -> bytes:
    """The content of a file, up to one byte more than it may have: the caller refuses that."""
    with file.open("rb") as stream:
        return stream.read(most + 1)


def regular(file: Path, most: int) -> bytes | None:
    """The content of a file from outside, None if there is none. It must be no link, pipe or device, and have at most `most` bytes."""
    try:
        descriptor = os.open(file, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except FileNotFoundError:
        return None
    except OSError as error:
        reason = "it is a link" if error.errno == errno.ELOOP else error.strerror
        raise RosmlError(f"{shown(file)}: cannot be read: {reason}", "put a file in its place", 2) from None
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        os.close(descriptor)
        raise RosmlError(f"{shown(file)}: cannot be read: it is no file", "put a file in its place", 2)
    with os.fdopen(descriptor, "rb") as stream:
        content = stream.read(most + 1)
    if len(content) > most:
        raise RosmlError(f"{shown(file)}: has more than {most:,} bytes", "put a smaller file in its place", 2)
    return content


def text(file: Path) -> str:
    try:
        return file.read_bytes().decode("utf-8")
    except OSError as error:
        remedy = (
            f"bring it back: git checkout {shown(file)}" if isinstance(error, FileNotFoundError) else "make it readable"
        )
        raise RosmlError(f"{shown(file)}: cannot be read: {error.strerror}", remedy) from None
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        byte = f"byte 0x{error.object[error.start]:02x}"
        raise RosmlError(f"{shown(file)}:{line}: not UTF-8 ({byte})", "save the file as UTF-8", exit_code=2) from None


def difference(file: Path, content: str) -> str:
    """A unified diff from the file to its expected content; empty if they are the same."""
    present = _read(file)
    if present == content:
        return ""
    from difflib import unified_diff  # only needed when something is stale

    name = shown(file)
    present_lines = [] if present is None else present.splitlines(keepends=True)
    return "".join(
        unified_diff(present_lines, content.splitlines(keepends=True), f"{name} (found)", f"{name} (expected)")
    )


def _read(file: Path) -> str | None:
    try:
        return file.read_bytes().decode("utf-8", errors="replace")
    except FileNotFoundError:
        return None
    except OSError as error:
        raise RosmlError(f"{shown(file)}: cannot be read: {error.strerror}") from None


def shown(file: Path) -> str:
    """A file's name for messages: relative to the current folder if it lies below it."""
    try:
        return str(file.resolve().relative_to(Path.cwd()))
    except (ValueError, OSError, RuntimeError):  # elsewhere, or a link that leads to itself
        return str(file)
