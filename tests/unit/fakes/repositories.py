"""Real git repositories, and a target whose `.repos` files name them."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from fakes.stubs import executable
from rosml.base.errors import RosmlError
from rosml.containerize.lock import Pin
from rosml.containerize.sources.fetch import Options, Repository, fetch
from rosml.containerize.sources.git import Access

NOBODY = Access()
SECRET = "s3cret-canary"


def git(folder: Path, *arguments: str) -> str:
    """Calls git as an author does."""
    options = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "protocol.file.allow=always"]
    command = ["git", "-C", str(folder), *options, *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def commit(folder: Path, files: dict[str, str] | None = None) -> str:
    """Commits files to a repository, which it makes. Returns the hash."""
    if not folder.exists():
        folder.mkdir(parents=True)
        git(folder, "init", "--quiet", "--initial-branch=main")
    for name, text in (files or {}).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "--allow-empty", "-m", "a")
    return git(folder, "rev-parse", "HEAD")


def with_submodule(folder: Path, url: str, path: str = "sub") -> str:
    git(folder, "submodule", "add", "--quiet", "--name", "x.y", url, path)
    return commit(folder)


def repos(**entries: tuple[str | Path, str]) -> str:
    """A `.repos` file."""
    content = {path: {"type": "git", "url": str(url), "version": version} for path, (url, version) in entries.items()}
    return json.dumps({"repositories": content})


def pin(url: str | Path, version: str, commit: str) -> dict[str, Pin]:
    return {"a": Pin(url=str(url), version=version, commit=commit)}


def listing(folder: Path) -> dict[str, tuple[str, str]]:
    """The modes and contents of all that is below a folder."""

    def content(item: Path) -> str:
        if item.is_symlink():
            return os.readlink(item)
        return item.read_text("latin-1") if item.is_file() else ""

    items = sorted(folder.rglob("*"))
    return {item.relative_to(folder).as_posix(): (oct(item.lstat().st_mode), content(item)) for item in items}


@dataclass
class Place:
    """A target, and where its sources go."""

    root: Path
    sentences: list[str] = field(default_factory=list)

    @property
    def target(self) -> Path:
        return self.root / "target"

    @property
    def out(self) -> Path:
        return self.root / "out"

    @property
    def cache(self) -> Path:
        return self.root / "cache"

    def put(self, text: str, name: str = ".repos") -> None:
        """Writes a `.repos` file of the target."""
        (self.target / name).parent.mkdir(parents=True, exist_ok=True)
        (self.target / name).write_text(text)

    def a(self, files: dict[str, str] | None = None, version: str = "main") -> tuple[Path, str]:
        """A repository with one commit, which the target names: its folder and the hash."""
        url = self.root / "a"
        hash = commit(url, files or {"f": "1"})
        self.put(repos(a=(url, version)))
        return url, hash

    def fetch(self, access: Access = NOBODY, **options: object) -> list[Repository]:
        self.sentences.clear()
        chosen = Options(**{"local": True} | options)  # type: ignore[arg-type]
        return fetch(self.target, self.out, self.cache, access, chosen, self.sentences.append)

    def refused(self, access: Access = NOBODY, **options: object) -> RosmlError:
        """The error of a call."""
        with pytest.raises(RosmlError) as caught:
            self.fetch(access, **options)
        error = caught.value
        assert error.remedy and SECRET not in f"{error.message} {error.remedy}"
        assert "\n" not in error.message or "two different" in error.message
        return error

    def read(self, name: str) -> str:
        return (self.out / name).read_text()

    def trace(self, more: str = "") -> Path:
        """Has git write down each program that it or a child starts; the user's configuration otherwise has `more`."""
        file = self.root / "trace"
        (self.root / "home/.gitconfig").write_text(f"[trace2]\n\teventTarget = {file}\n{more}")
        return file

    def program(self, name: str, text: str) -> str:
        """A program of this place, as a shell script."""
        (self.root / "programs").mkdir(exist_ok=True)
        (self.root / "programs" / name).unlink(missing_ok=True)
        return executable(self.root / "programs" / name, text)


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Place:
    """A target without files, of a user without configuration, whose programs come first."""
    for name in ("home", "target", "programs"):
        (tmp_path / name).mkdir()
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("GIT_CONFIG_NOSYSTEM", "1")
    monkeypatch.setenv("PATH", f"{tmp_path}/programs:{os.environ['PATH']}")
    for name in ("XDG_CONFIG_HOME", "GIT_SSH", "GIT_SSH_COMMAND", "GIT_ASKPASS", "SSH_ASKPASS"):
        monkeypatch.delenv(name, raising=False)
    return Place(tmp_path)


GIT = shutil.which("git")
"""The real one."""
