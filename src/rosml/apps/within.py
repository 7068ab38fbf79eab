"""What a repository has at a path: nothing that a link takes from elsewhere on the machine."""

from __future__ import annotations

import os
from pathlib import Path

from rosml.base.errors import RosmlError


def there(path: Path, root: Path, folder: bool = False) -> bool:
    """Whether a repository has a file, or a folder, at a path.

    Raises:
        RosmlError: the path leads out of the repository or to nothing, or has a folder in the place of a file, or the other
            way round (exit code 2).
    """
    if not os.path.lexists(path):
        return False
    if not Path(os.path.realpath(path)).is_relative_to(os.path.realpath(root)):
        raise RosmlError(f"{path} leads out of {root}", "put what it names into the repository", exit_code=2)
    if not path.exists():
        raise RosmlError(f"{path}: a link to nothing", "correct the link, or remove it", exit_code=2)
    if path.is_dir() != folder:
        kinds = ("a file", "a folder") if folder else ("a folder", "a file")
        raise RosmlError(
            f"{path}: {kinds[0]} in the place of {kinds[1]}", "rename it, or name another one", exit_code=2
        )
    return True
