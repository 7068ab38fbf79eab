"""Upstream sources: the repositories that `.repos` files name, at exact commits, as a folder without `.git`.

The caller's machine fetches them. The folder is a context of the build, which needs no credentials.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path, PurePosixPath

from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.base.problems import listed
from rosml.containerize import lock
from rosml.containerize.sources import repos_file, urls
from rosml.containerize.sources.git import Access, Failed, Git, opened
from rosml.containerize.sources.repos_file import Entry
from rosml.containerize.sources.store import Store
from rosml.containerize.sources.tree import Tree, beside
from rosml.containerize.sources.versions import Version, resolve
from rosml.machine.git import trusting

WORKERS = 8  # how many repositories are fetched at the same time. Most of the time is spent waiting for servers

DEFAULT = ".repos"

Say = Callable[[str], object]


@dataclass(frozen=True)
class Repository:
    """A fetched repository. `named_in` is the `.repos` file. A `moving` version is a branch, and may mean another commit tomorrow."""

    path: str
    url: str
    version: str
    commit: str
    named_in: str
    moving: bool


@dataclass(frozen=True)
class Options:
    """Which `.repos` files count, and what they may name."""

    recursive: bool = True  # every file counts, also those in fetched repositories; otherwise only `file`
    file: str = DEFAULT  # below the target
    without: str = ""  # a file of the target that does not count
    pins: Mapping[str, lock.Pin] | None = None  # commits by path: a lock file must have every repository
    local: bool = False  # files of the target, and of local repositories, may name repositories of this machine


def fetch(
    target: Path,
    out: Path,
    cache: Path,
    access: Access,
    options: Options = Options(),  # it is frozen
    say: Say = lambda text: None,
) -> list[Repository]:
    """Writes the repositories that a target needs into the folder `out`, and removes others. After an error, the next call completes
    it. The same commits give the same files and modes. Processes may share `cache`. Any thread calls `say`."""
    cache.mkdir(mode=0o700, parents=True, exist_ok=True)
    out.mkdir(parents=True, exist_ok=True)
    out, cache = out.resolve(), cache.resolve()
    files = _files(target, options, (out, cache))
    with turn(beside(out, "lock"), lambda: say(f"waiting for another process, which writes to {out}")):
        tree = Tree(out)
        entries = _merged({}, repos_file.read(files, target, "", options.local))
        repositories: list[Repository] = []
        if entries:
            with opened(access, cache) as git:
                fetcher = _Fetcher(git, Store(git, cache, say), tree, options.pins, say)
                new = entries
                while new:
                    fetched = fetcher.at_once([new[path] for path in sorted(new)])
                    repositories += fetched
                    nested = (entry for each in fetched for entry in _nested(each, out)) if options.recursive else ()
                    merged = _merged(entries, nested)
                    new = {path: entry for path, entry in merged.items() if path not in entries}
                    entries = merged
        tree.keep(entries)
    return sorted(repositories, key=lambda repository: repository.path)


def _files(target: Path, options: Options, without: tuple[Path, ...]) -> list[Path]:
    if options.recursive:
        files = repos_file.find(target, without)
    elif (target / options.file).is_file() and (target / options.file).resolve().is_relative_to(target.resolve()):
        files = [target / options.file]
    elif options.file == DEFAULT and not (target / DEFAULT).exists():
        files = []
    else:
        raise RosmlError(f"{options.file}: no file below {target}", "name a .repos file of the target", exit_code=2)
    if not options.without:
        return files
    return [path for path in files if path.resolve() != (target / options.without).resolve()]


def _nested(repository: Repository, out: Path) -> list[Entry]:
    folder = out / repository.path
    prefix = f"upstream/{repository.path}/"
    return repos_file.read(repos_file.find(folder), folder, prefix, local=urls.is_local(repository.url))


def _merged(entries: Mapping[str, Entry], more: Iterable[Entry]) -> dict[str, Entry]:
    """Entries by path, with more of them. None may contradict another, or lie within another."""
    merged = dict(entries)
    for entry in more:
        first = merged.setdefault(entry.path, entry)
        if not entry.same(first):
            raise RosmlError(
                f"{entry.path} is two different things:\n"
                f"  {first.place}: {first.version or 'the default branch'} of {first.url}\n"
                f"  {entry.place}: {entry.version or 'the default branch'} of {entry.url}",
                "give it the same url and version in both files, or another path; or let one file count, such as with"
                f" --no-enable-recursive-vcs-import --vcs-import-file {first.file}",
                exit_code=2,
            )
    for path in sorted(merged):
        for above in map(str, PurePosixPath(path).parents):
            if above in merged:
                text = f"{merged[path].place}: {path} lies within {above}, which {merged[above].place} names"
                raise RosmlError(text, "give one of them another path", exit_code=2)
    return merged


@dataclass(frozen=True)
class _Fetcher:
    git: Git
    store: Store
    tree: Tree
    pins: Mapping[str, lock.Pin] | None
    say: Say

    def at_once(self, entries: Sequence[Entry]) -> list[Repository]:
        """Fetches several repositories at the same time. The first error, in their order, ends all."""
        pool = ThreadPoolExecutor(WORKERS)
        try:
            repositories = list(pool.map(self.fetch, entries))
        except BaseException as error:
            self.git.stop()
            pool.shutdown(wait=isinstance(error, Exception), cancel_futures=True)  # after Ctrl-C, do not wait
            raise
        pool.shutdown()
        return repositories

    def fetch(self, entry: Entry) -> Repository:
        head = f"{entry.place}: {entry.path} ({entry.url})"
        try:
            version = self._pinned(entry) if self.pins is not None else resolve(self.git, entry.url, entry.version)
            version = replace(version, commit=self.store.commit(entry.url, version))
            if version.also_branch:
                self.say(f"{head}: {entry.version} is a tag and a branch; the tag counts")
            if not self.tree.has(entry.path, entry.url, version.commit):
                with self.tree.new(entry.path, entry.url, version.commit) as folder:
                    self.store.write(entry.url, version, folder)
                self.say(f"{entry.path}: {entry.version or 'default branch'} is {version.commit}")
        except Failed as error:
            raise explained(head, entry.url, error) from None
        except RosmlError as error:
            raise RosmlError(f"{head}: {error.message}", error.remedy, error.exit_code) from None
        return Repository(entry.path, entry.url, entry.version, version.commit, entry.file, version.moving)

    def _pinned(self, entry: Entry) -> Version:
        """The commit in the lock file, if it is of this url and version, and the version leads to it."""
        pin = (self.pins or {}).get(entry.path)
        if pin is None or (urls.key(pin.url), pin.version) != (urls.key(entry.url), entry.version):
            text = "the lock file has another url or version" if pin else "the lock file does not have it"
            raise RosmlError(text, lock.RENEW, exit_code=2)
        try:
            leads = self.store.has_pinned(entry.url, entry.version, pin.commit)
        except RosmlError as error:
            remedy = lock.RENEW if error.exit_code == 2 else error.remedy
            raise RosmlError(error.message, remedy, error.exit_code) from None
        if not leads:
            text = (
                f"{entry.version or 'the default branch'} does not lead to {pin.commit}, which the lock file has:"
                " it may be of a fork or of a pull request"
            )
            raise RosmlError(text, f"check who wrote the lock file; then {lock.RENEW}", exit_code=2)
        return Version(pin.commit)


def explained(head: str, url: str, error: Failed) -> RosmlError:
    """The error for a failure of git: its meaning and a remedy."""
    if error.could_not_write:
        return RosmlError(f"{head}: cannot be written: {error.reason}", "free some disk space, then run it again")
    host = urls.host(url)
    if any(
        text in error.stderr for text in ("Host key verification failed", "host key is known", "IDENTIFICATION HAS")
    ):
        text = f"{head}: the host key of {host} is unknown, or is another one"
        scan = re.sub(r"^(.*):(\d+)$", r"-p \2 \1", host)
        return RosmlError(text, f"if this prints the host's key, add it to GIT_SSH_KNOWN_HOST_KEYS: ssh-keyscan {scan}")
    if "Load key " in error.stderr:
        text = f"{head}: ssh cannot use the key: it is damaged, or has a passphrase"
        return RosmlError(text, "set GIT_SSH_PRIVATE_KEY to the whole text of a private key without a passphrase")
    if "detected dubious ownership" in error.stderr or "unsafe repository" in error.stderr:
        place = url.removeprefix("file://")
        return RosmlError(f"{head}: {place} belongs to another user, and git does not read it", trusting(Path(place)))
    if url.startswith("git://"):
        remedy = f"write https://{url.removeprefix('git://')}: GitHub and others do not answer git:// any more"
    elif urls.is_local(url):
        remedy = "check the URL"
    else:
        names = ["GIT_HTTPS_SERVER", "GIT_HTTPS_USER", "GIT_HTTPS_PASSWORD"]
        secrets = listed(names) if url.startswith("http") else "GIT_SSH_PRIVATE_KEY (a key without a passphrase)"
        remedy = f"check the URL; if the repository is private, check {secrets} too"
    return RosmlError(f"{head}: cannot be read: {error.reason}", remedy)
