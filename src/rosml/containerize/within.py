"""Checks of paths in a repository: no link may lead elsewhere on the machine, or to files that stay there."""

from __future__ import annotations

import os
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError

SECRET = (".git", ".env")
"""Files and folders that stay on the user's machine, at any depth of a repository."""


def require_inside(path: Path, root: Path) -> None:
    """Checks that a path, with its links followed, stays in the repository. It need not exist."""
    real, top = Path(os.path.realpath(path)), os.path.realpath(root)
    if not real.is_relative_to(top):
        raise RosmlError(f"{path} leads out of {root}", "put what it names into the repository", exit_code=2)
    if any(part in SECRET for part in real.relative_to(top).parts):
        text = f"{path} leads to {real.relative_to(top)}, which gets into no image and no step of a build"
        raise RosmlError(text, "name another file", exit_code=2)


def is_inside(path: Path, root: Path) -> bool:
    """Whether a path leads to a file or folder of the repository that is not secret."""
    try:
        require_inside(path, root)
    except RosmlError:
        return False
    return True


def exists(path: Path, root: Path, folder: bool = False) -> bool:
    """Whether a repository has a file, or a folder, at a path. If it leads elsewhere, or is of another kind, that is an error."""
    if not os.path.lexists(path):
        return False
    require_inside(path, root)
    if not path.exists():
        raise RosmlError(f"{path}: a link to nothing", "correct the link, or remove it", exit_code=2)
    if not path.is_dir() and not path.is_file():
        raise RosmlError(f"{path}: it is neither a file nor a folder", "put a file in its place", exit_code=2)
    if path.is_dir() != folder:
        kinds = ("a file", "a folder") if folder else ("a folder", "a file")
        raise RosmlError(f"{path}: {kinds[0]} instead of {kinds[1]}", "rename it, or name another one", exit_code=2)
    return True


def read(path: Path, root: Path, most: int) -> bytes | None:
    """The content of a file of the repository; None if there is none. `most`: the most bytes."""
    if not exists(path, root):
        return None
    try:
        content = files.limited(path, most)
    except OSError as error:
        raise RosmlError(f"{path}: cannot be read: {error.strerror}", "make it readable", exit_code=2) from None
    if len(content) > most:
        raise RosmlError(f"{path}: has more than {most >> 20} MiB", "put a smaller file in its place", exit_code=2)
    return content
