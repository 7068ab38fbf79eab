"""A cache of bare git repositories: one for each URL, with the commits that builds need.

If a repository is damaged, it is removed and fetched again. You may remove all of them at any time.
"""

from __future__ import annotations

import hashlib
import shutil
import tempfile
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from threading import Lock
from typing import TypeVar

from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.containerize.sources import urls
from rosml.containerize.sources.git import LFS, Failed, Git, Setting
from rosml.containerize.sources.versions import Version, resolve

_POINTER = b"version https://git-lfs.github.com/spec/v1\n"
_LARGEST_POINTER = 1024  # bytes

T = TypeVar("T")


class _Unreachable(Failed):
    """The server does not answer, or has no such repository. Starting again does not help."""


@dataclass(frozen=True)
class _Submodule:
    path: str
    url: str
    commit: str


class Store:
    """A folder of bare repositories. Several processes may share it."""

    def __init__(self, git: Git, folder: Path, say: Callable[[str], object]) -> None:
        self._git = git
        self._folder = folder
        self._say = say
        self._turns: dict[str, Lock] = {}  # for this process' threads, by URL

    def commit(self, url: str, version: Version) -> str:
        return version.commit if version.is_exact else self._with(url, lambda kept: self._have(kept, url, version))

    def has_pinned(self, url: str, version: str, commit: str) -> bool:
        """Whether a version names a commit, or has named it: it is the commit of that tag or branch, or in its history.

        By its hash, a forge gives every commit of a network of forks, also those of pull requests that nobody has reviewed.
        Commits that passed once are remembered. Otherwise this asks the server for its names. If the version names another
        commit now, it fetches the history too, without files if the server can leave them out.
        """

        def check(kept: Path) -> bool:
            checked = f"refs/pinned/{hashlib.sha256(version.encode()).hexdigest()[:32]}/{commit}"
            if self._commit_of(kept, checked):
                return True
            try:
                present = resolve(self._git, url, version)
            except Failed as error:
                raise _Unreachable(error.stderr) from None
            if present.commit != commit and not (
                self._leads_to(url, [present.ref], commit)
                if present.ref
                else commit.startswith(present.commit) and self._leads_to(url, ["refs/heads/*", "refs/tags/*"], commit)
            ):
                return False
            self._have(kept, url, replace(present, commit=commit))
            self._git(f"--git-dir={kept}", "update-ref", checked, commit)
            return True

        return self._with(url, check)

    def _leads_to(self, url: str, refs: Iterable[str], commit: str) -> bool:
        """Whether a commit is in the history of a server's refs."""
        # The remote has a name: git leaves out files only if it can get them later from a named one.
        remote = {"url": url, "promisor": "true", "partialclonefilter": "tree:0"}
        settings = [(f"remote.rosml.{name}", value) for name, value in remote.items()]
        with tempfile.TemporaryDirectory(dir=self._folder, prefix="history-") as folder:
            git_dir, refspecs = f"--git-dir={folder}", [f"+{ref}:refs/named/{ref}" for ref in refs]
            self._git("init", "--quiet", "--bare", "--template=", folder)
            self._git(git_dir, "fetch", "--quiet", "--no-tags", "rosml", *refspecs, settings=settings)
            # Without `merge-base`, which would fetch a missing commit.
            return commit in self._git(git_dir, "rev-list", "--all").split()

    def write(self, url: str, version: Version, into: Path) -> None:
        """Empties a folder, then writes the files of a version and of its submodules into it."""
        submodules = self._with(url, lambda kept: self._checkout(kept, url, self._have(kept, url, version), into))
        for submodule in submodules:  # without the repository's lock: two may contain each other
            self._write_submodule(url, submodule, into)

    def _with(self, url: str, work: Callable[[Path], T]) -> T:
        """Works with the repository of a URL. If git fails, tries once more with a new one."""
        kept = self._folder / f"{hashlib.sha256(url.encode()).hexdigest()[:32]}.git"
        waiting = f"waiting for another process, which fetches {url}"
        with self._turns.setdefault(url, Lock()), turn(kept.with_suffix(".lock"), lambda: self._say(waiting)):
            try:
                return work(kept)
            except _Unreachable:
                raise
            except Failed as error:
                if error.could_not_write:
                    raise
            _discard(kept)
            return work(kept)

    def _have(self, kept: Path, url: str, version: Version) -> str:
        """Fetches a version if it is missing. Returns its commit."""
        git_dir = f"--git-dir={kept}"
        ref = f"refs/rosml/{version.commit}"
        if not (kept / "HEAD").is_file():
            self._git("init", "--quiet", "--bare", "--template=", str(kept))
        if commit := self._commit_of(kept, ref):
            return commit
        if not version.ref:
            try:
                self._git("ls-remote", "--quiet", "--", url, "HEAD")
            except Failed as error:
                raise _Unreachable(error.stderr) from None
        if version.is_exact:
            try:
                self._git(git_dir, "fetch", "--quiet", "--depth=1", "--no-tags", "--", url, f"+{version.commit}:{ref}")
            except Failed as error:  # the server refuses single commits
                if error.could_not_write:
                    raise
            if commit := self._commit_of(kept, ref):
                return commit
        self._fetch_all(kept, url, version)
        commit = self._commit_of(kept, version.commit)
        if not commit:
            raise RosmlError(f"it has no commit {version.commit}", "name a tag, a branch or a commit", exit_code=2)
        self._git(git_dir, "update-ref", ref, commit)
        return commit

    def _fetch_all(self, kept: Path, url: str, version: Version) -> None:
        git_dir = f"--git-dir={kept}"
        shallow = self._git(git_dir, "rev-parse", "--is-shallow-repository").strip() == "true"
        refspecs = ["+refs/heads/*:refs/all/heads/*", "+refs/tags/*:refs/all/tags/*"]
        if version.ref:
            refspecs.append(f"+{version.ref}:refs/named")
        options = ["--quiet", "--prune", "--no-tags", *(["--unshallow"] if shallow else [])]
        self._git(git_dir, "fetch", *options, "--", url, *refspecs)

    def _commit_of(self, kept: Path, name: str) -> str:
        """The commit of a name or a hash; empty if it is missing."""
        try:
            return self._git(f"--git-dir={kept}", "rev-parse", "--verify", "--quiet", f"{name}^{{commit}}").strip()
        except Failed:
            return ""

    def _checkout(self, kept: Path, url: str, commit: str, into: Path) -> list[_Submodule]:
        """Writes a commit's own files. Returns its submodules."""
        with tempfile.TemporaryDirectory(prefix="index-", dir=into.parent) as folder:
            environment = {"GIT_DIR": str(kept), "GIT_WORK_TREE": str(into), "GIT_INDEX_FILE": f"{folder}/index"}

            def git(*arguments: str, stdin: bytes = b"", settings: Iterable[Setting] = ()) -> str:
                return self._git(*arguments, stdin=stdin, settings=settings, environment=environment)

            _empty(into)
            git("read-tree", "--reset", "-u", commit)
            if self._has_pointers(git, into):
                if not shutil.which("git-lfs", path=self._git.path):
                    raise RosmlError("it has files in Git LFS, and git-lfs is not installed", "install git-lfs")
                _empty(into)
                Path(environment["GIT_INDEX_FILE"]).unlink()
                try:
                    git("read-tree", "--reset", "-u", commit, settings=[*LFS, ("remote.origin.url", url)])
                except Failed as error:
                    text = f"git-lfs did not get its files: {error.reason}"
                    raise RosmlError(text, "check whether the LFS server has them, and lets you read them") from None
            lines = git("ls-files", "--stage", "-z").split("\0")
            # `160000 HASH 0<tab>PATH` is a submodule.
            links = {
                path: head.split()[1]
                for head, _, path in (line.partition("\t") for line in lines if line.startswith("160000 "))
            }
            return self._submodules(git, commit, links) if links else []

    def _has_pointers(self, git: Callable[..., str], folder: Path) -> bool:
        """Whether files are pointers to Git LFS and have its attribute. Without the attribute they only look like pointers."""
        names = [str(file.relative_to(folder)) for file in folder.rglob("*") if is_pointer(file)]
        if not names:
            return False
        stdin = "".join(f"{name}\0" for name in names).encode(errors="surrogateescape")
        answers = git("check-attr", "--stdin", "-z", "filter", stdin=stdin).split("\0")
        return "lfs" in answers[2::3]

    def _submodules(self, git: Callable[..., str], commit: str, links: Mapping[str, str]) -> list[_Submodule]:
        """The submodules that `.gitmodules` knows. Others have no URL: their folders stay empty."""
        try:
            listed = git("config", f"--blob={commit}:.gitmodules", "-z", "--list")
        except Failed:
            listed = ""
        modules: dict[str, dict[str, str]] = {}
        for setting in listed.split("\0"):
            name, _, value = setting.partition("\n")
            section, _, key = name.rpartition(".")
            modules.setdefault(section, {})[key] = value
        urls_of = {
            module["path"]: module["url"]
            for module in modules.values()
            if "path" in module and "url" in module and module.get("update") != "none"
        }
        for path in links.keys() - urls_of.keys():
            self._say(f"the submodule {path} has no URL in .gitmodules, or is switched off there: its folder is empty")
        return [_Submodule(path, urls_of[path], links[path]) for path in sorted(links.keys() & urls_of.keys())]

    def _write_submodule(self, around: str, submodule: _Submodule, folder: Path) -> None:
        into = folder / submodule.path
        if into.resolve() != folder.resolve() / submodule.path:
            raise RosmlError(f"the submodule {submodule.path} leads out of its repository", "do not use it")
        try:
            url = urls.checked(urls.below(around, submodule.url), local=urls.is_local(around))
            self.write(url, Version(submodule.commit), into)
        except urls.Refused as error:
            raise RosmlError(f"the submodule {submodule.path}: {error}", error.remedy) from None
        except RosmlError as error:
            raise RosmlError(f"the submodule {submodule.path}: {error.message}", error.remedy) from None


def is_pointer(file: Path) -> bool:
    """Whether a file of Git LFS is only a pointer."""
    if file.is_symlink() or not file.is_file() or file.stat().st_size >= _LARGEST_POINTER:
        return False
    with file.open("rb") as stream:
        return stream.read(len(_POINTER)) == _POINTER


def _empty(folder: Path) -> None:
    """Makes a folder, or empties it. Its mode is git's, and does not depend on the umask."""
    if folder.exists():
        shutil.rmtree(folder)
    folder.mkdir()
    folder.chmod(0o755)


def _discard(kept: Path) -> None:
    """Removes a damaged repository, also if a leftover process still writes to it."""
    with tempfile.TemporaryDirectory(dir=kept.parent, prefix="damaged-", ignore_cleanup_errors=True) as folder:
        if kept.exists():
            kept.rename(Path(folder) / kept.name)
