"""Derived files: written when they differ, compared when they are checked."""

from __future__ import annotations

import os
from pathlib import Path

from rosml.base.errors import RosmlError

WRITABLE = "name, or make, a folder that is there, has room, and in which you may write"


def write(file: Path, content: str) -> bool:
    """Writes a file at once, so that nobody ever reads half of it. Returns whether it changed.

    Links are followed; pipes and devices, such as /dev/stdout, are written to, never replaced.

    Raises:
        RosmlError: it cannot be written.
    """
    try:
        if file.exists() and not file.is_file() and not file.is_dir():
            file.write_text(content, encoding="utf-8")
            return True
        if _read(file) == content:
            return False
        _replace(file.resolve(), content)
    except (OSError, ValueError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise RosmlError(f"{shown(file)}: cannot be written: {reason}", WRITABLE) from None
    return True


def _replace(file: Path, content: str) -> None:
    import tempfile  # only needed here

    mode = file.stat().st_mode & 0o777 if file.exists() else 0o644
    descriptor, temporary = tempfile.mkstemp(dir=file.parent, prefix=f".{file.name}.")
    try:
        with os.fdopen(descriptor, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(content)
        os.chmod(temporary, mode)
        os.replace(temporary, file)
    except BaseException:  # also Ctrl-C: leave nothing behind
        Path(temporary).unlink(missing_ok=True)
        raise


def text(file: Path) -> str:
    """What a file of the checkout holds.

    Raises:
        RosmlError: it cannot be read, or is not UTF-8.
    """
    try:
        return file.read_bytes().decode("utf-8")
    except OSError as error:
        remedy = (
            f"bring it back: git checkout {shown(file)}" if isinstance(error, FileNotFoundError) else "make it readable"
        )
        raise RosmlError(f"{shown(file)}: cannot be read: {error.strerror}", remedy) from None
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        found = f"byte 0x{error.object[error.start]:02x}"
        raise RosmlError(f"{shown(file)}:{line}: not UTF-8 ({found})", "save the file as UTF-8", exit_code=2) from None


def difference(file: Path, content: str) -> str:
    """A unified diff from the file to what it should hold; empty if it holds just that."""
    found = _read(file)
    if found == content:
        return ""
    from difflib import unified_diff  # only needed when something is stale

    name = shown(file)
    old = [] if found is None else found.splitlines(keepends=True)
    return "".join(unified_diff(old, content.splitlines(keepends=True), f"{name} (found)", f"{name} (expected)"))


def _read(file: Path) -> str | None:
    try:
        return file.read_bytes().decode("utf-8", errors="replace")
    except FileNotFoundError:
        return None
    except OSError as error:
        raise RosmlError(f"{shown(file)}: cannot be read: {error.strerror}") from None


def shown(file: Path) -> str:
    """A file's name for messages: short where it lies below the current folder."""
    try:
        return str(file.resolve().relative_to(Path.cwd()))
    except (ValueError, OSError, RuntimeError):  # elsewhere, or a link that leads to itself
        return str(file)
