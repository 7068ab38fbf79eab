"""The folder with upstream sources. Its repositories are complete, and unchanged ones stay as they are."""

from __future__ import annotations

import contextlib
import json
import shutil
import tempfile
import threading
from collections.abc import Collection, Iterator
from pathlib import Path, PurePosixPath

from pydantic import ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.files import write
from rosml.base.shapes import adapter


def beside(folder: Path, kind: str) -> Path:
    """A file or folder beside a folder, which belongs to it."""
    return folder.with_name(f".{folder.name}.{kind}")


class Tree:
    """A folder with a folder for each repository. One process at a time may change it; its threads may do so together.

    A repository is written elsewhere, and moved here when it is complete. A file beside the folder has the commits in it. Without
    that file, a folder with files is refused, since they would be removed.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._file = beside(folder, "json")
        self._staging = beside(folder, "new")
        self._guard = threading.Lock()
        self._here = _read(self._file)
        if not self._file.exists():
            if any(folder.iterdir()):
                raise RosmlError(f"{folder} has something else in it", "name an empty folder", exit_code=2)
            self._save()
        if self._staging.exists():  # left by a killed process
            shutil.rmtree(self._staging)
        self._staging.mkdir()

    def has(self, path: str, url: str, commit: str) -> bool:
        return self._here.get(path) == [url, commit] and (self._folder / path).is_dir()

    @contextlib.contextmanager
    def new(self, path: str, url: str, commit: str) -> Iterator[Path]:
        """A place to write a commit to. If nothing fails, it becomes the commit's folder."""
        with tempfile.TemporaryDirectory(dir=self._staging) as staging:
            yield Path(staging) / "new"
            with self._guard:
                self._forget(path)
                for above in reversed(PurePosixPath(path).parents[:-1]):
                    if not (self._folder / above).exists():
                        (self._folder / above).mkdir()
                        (self._folder / above).chmod(0o755)  # whatever the umask is
                (Path(staging) / "new").rename(self._folder / path)
                self._here[path] = [url, commit]
                self._save()

    def keep(self, paths: Collection[str]) -> None:
        """Removes all other repositories."""
        kept = {self._folder / path for path in paths}
        around = {folder for path in kept for folder in path.parents}
        for path in self._here.keys() - set(paths):
            del self._here[path]
        self._save()
        pending = [self._folder]
        while pending:
            for item in pending.pop().iterdir():
                if item in around and item.is_dir() and not item.is_symlink():
                    pending.append(item)
                elif item not in kept:
                    _remove(item)
        shutil.rmtree(self._staging)

    def _forget(self, path: str) -> None:
        """Removes the repositories at a path, around it and below it."""
        for other in list(self._here):
            if f"{path}/".startswith(f"{other}/") or other.startswith(f"{path}/"):
                del self._here[other]
        self._save()
        for above in [*map(str, reversed(PurePosixPath(path).parents[:-1])), path]:
            place = self._folder / above
            if above == path or place.is_symlink() or not place.is_dir():
                _remove(place)

    def _save(self) -> None:
        write(self._file, json.dumps(self._here, indent=1, sort_keys=True))


def _read(file: Path) -> dict[str, list[str]]:
    """The commits in a folder, from its file; none if that is damaged."""
    try:
        return _WRITTEN.validate_python(untrusted.json_of(file.read_bytes(), str(file)))
    except (FileNotFoundError, ValidationError, RosmlError):
        return {}


_WRITTEN = adapter(dict[str, list[str]])


def _remove(place: Path) -> None:
    if place.is_dir() and not place.is_symlink():
        shutil.rmtree(place)
    else:
        place.unlink(missing_ok=True)
