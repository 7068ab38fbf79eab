"""Upstream sources: the repositories that `.repos` files name, at exact commits, as a folder without `.git`.

The caller's machine fetches them. The folder is a context of the build, which needs no credentials.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
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

__all__ = ["Access", "Repository", "fetch"]

WORKERS = 8
"""How many repositories are fetched at the same time. Most of the time is spent waiting for servers."""

DEFAULT = ".repos"

Say = Callable[[str], object]


@dataclass(frozen=True)
class Repository:
    """A fetched repository.

    Attributes:
        path: its folder, below that for upstream sources.
        url: its URL without user and password.
        version: as written: a tag, a branch, a commit; empty for the default branch.
        commit: the whole hash of its commit.
        named_in: the `.repos` file.
        moving: whether the version is a branch, and may mean another commit tomorrow.
    """

    path: str
    url: str
    version: str
    commit: str
    named_in: str
    moving: bool


def fetch(
    target: Path,
    out: Path,
    cache: Path,
    access: Access,
    *,
    recursive: bool = True,
    file: str = DEFAULT,
    without: str = "",
    pins: Mapping[str, lock.Pin] | None = None,
    local: bool = False,
    say: Say = lambda text: None,
) -> list[Repository]:
    """Writes the repositories that a target needs into a folder, and removes others.

    After an error the folder is incomplete. The next call completes it.

    Args:
        target: the folder of the user's packages.
        out: the folder to write, with a folder for each path. The same commits give the same files and modes. Unchanged
            repositories are not written again. Two files beside it record its content.
        cache: the folder of repositories for the next call. Processes may share it; you may remove it at any time.
        recursive: whether every `.repos` file counts, also those in fetched repositories; otherwise only `file`, below the target.
        without: a `.repos` file of the target that does not count.
        pins: commits by path, if there is a lock file; it must have every repository.
        local: whether `.repos` files of the target, and of local repositories that they name, may name repositories of this
            machine. Those of a repository from a server never may.
        say: gets a sentence for people, from any thread.

    Returns:
        The repositories, sorted by path.

    Raises:
        RosmlError: a repository cannot be fetched (the message has the file that names it); or a file is wrong, or `out` has
            something else in it (exit code 2).
        OSError: a folder cannot be written.
    """
    cache.mkdir(mode=0o700, parents=True, exist_ok=True)
    out.mkdir(parents=True, exist_ok=True)
    out, cache = out.resolve(), cache.resolve()
    files = repos_file.found(target, without=(out, cache)) if recursive else _alone(target, file)
    if without:
        files = [path for path in files if path.resolve() != (target / without).resolve()]
    with turn(beside(out, "lock"), lambda: say(f"waiting for another process, which writes to {out}")):
        tree = Tree(out)
        known: dict[str, Entry] = {}
        done: list[Repository] = []
        if wave := repos_file.read(files, target, "", local):
            with opened(access, cache) as git:
                store = Store(git, cache, say)
                while new := _new(wave, known):
                    fetched = _at_once(git, new, lambda entry: _fetch(entry, git, store, tree, pins, say))
                    done += fetched
                    wave = (
                        [entry for repository in fetched for entry in _named_by(repository, out)] if recursive else []
                    )
        tree.keep(known)
    return sorted(done, key=lambda repository: repository.path)


def _alone(target: Path, file: str) -> list[Path]:
    """The only file that counts; none if it is the default and missing."""
    place = target / file
    if place.is_file() and place.resolve().is_relative_to(target.resolve()):
        return [place]
    if file == DEFAULT and not place.exists():
        return []
    raise RosmlError(f"{file}: no file below {target}", "name a .repos file of the target", exit_code=2)


def _named_by(repository: Repository, out: Path) -> list[Entry]:
    """The entries of the `.repos` files of a repository."""
    folder = out / repository.path
    prefix = f"upstream/{repository.path}/"
    return repos_file.read(repos_file.found(folder), folder, prefix, local=urls.is_local(repository.url))


def _new(entries: Iterable[Entry], known: dict[str, Entry]) -> list[Entry]:
    """The entries with new paths; adds them to the known ones.

    Raises:
        RosmlError: an entry contradicts another, or lies within another (exit code 2).
    """
    new: list[str] = []
    for entry in entries:
        first = known.setdefault(entry.path, entry)
        if first is entry:
            new.append(entry.path)
        elif not entry.same(first):
            raise RosmlError(
                f"{entry.path} is two different things:\n"
                f"  {first.place}: {first.version or 'the default branch'} of {first.url}\n"
                f"  {entry.place}: {entry.version or 'the default branch'} of {entry.url}",
                "give it the same url and version in both files, or another path; or let one file count, such as with"
                f" --no-enable-recursive-vcs-import --vcs-import-file {first.file}",
                exit_code=2,
            )
    for path in sorted(known):
        for above in map(str, PurePosixPath(path).parents):
            if above in known:
                raise RosmlError(
                    f"{known[path].place}: {path} lies within {above}, which {known[above].place} names",
                    "give one of them another path",
                    exit_code=2,
                )
    return [known[path] for path in sorted(new)]


def _at_once(git: Git, entries: Iterable[Entry], work: Callable[[Entry], Repository]) -> list[Repository]:
    """Works on several entries at the same time. The first error, in their order, ends all."""
    pool = ThreadPoolExecutor(WORKERS)
    try:
        done = list(pool.map(work, entries))
    except BaseException as error:
        git.stop()
        pool.shutdown(wait=isinstance(error, Exception), cancel_futures=True)  # after Ctrl-C, do not wait
        raise
    pool.shutdown()
    return done


def _fetch(
    entry: Entry, git: Git, store: Store, tree: Tree, pins: Mapping[str, lock.Pin] | None, say: Say
) -> Repository:
    head = f"{entry.place}: {entry.path} ({entry.url})"
    try:
        version = resolve(git, entry.url, entry.version) if pins is None else _pinned(entry, pins, store)
        version = replace(version, commit=store.commit(entry.url, version))
        if version.also_branch:
            say(f"{head}: {entry.version} is a tag and a branch; the tag counts")
        if not tree.has(entry.path, entry.url, version.commit):
            with tree.new(entry.path, entry.url, version.commit) as folder:
                store.write(entry.url, version, folder)
            say(f"{entry.path}: {entry.version or 'default branch'} is {version.commit}")
    except Failed as error:
        raise told(head, entry.url, error) from None
    except RosmlError as error:
        raise RosmlError(f"{head}: {error.message}", error.remedy, error.exit_code) from None
    return Repository(entry.path, entry.url, entry.version, version.commit, entry.file, version.moving)


def _pinned(entry: Entry, pins: Mapping[str, lock.Pin], store: Store) -> Version:
    """The commit in the lock file.

    Raises:
        Failed: git could not fetch it.
        RosmlError: the lock file has none, or another url or version, or a commit to which this version does not lead (exit code 2).
    """
    pin = pins.get(entry.path)
    if pin is None or (urls.key(pin.url), pin.version) != (urls.key(entry.url), entry.version):
        text = "the lock file has another url or version" if pin else "the lock file does not have it"
        raise RosmlError(text, lock.RENEW, exit_code=2)
    try:
        leads = store.has_pinned(entry.url, entry.version, pin.commit)
    except RosmlError as error:
        raise RosmlError(error.message, lock.RENEW if error.exit_code == 2 else error.remedy, error.exit_code) from None
    if not leads:
        name = entry.version or "the default branch"
        text = (
            f"{name} does not lead to {pin.commit}, which the lock file has: it may be of a fork or of a pull request"
        )
        raise RosmlError(text, f"check who wrote the lock file; then {lock.RENEW}", exit_code=2)
    return Version(pin.commit)


def told(head: str, url: str, error: Failed) -> RosmlError:
    """The error for a failure of git: its meaning and a remedy."""
    if error.could_not_write:
        return RosmlError(f"{head}: cannot be written: {error.reason}", "free some disk space, then run it again")
    host = urls.host(url)
    if any(text in error.said for text in ("Host key verification failed", "host key is known", "IDENTIFICATION HAS")):
        text = f"{head}: the host key of {host} is unknown, or is another one"
        scan = re.sub(r"^(.*):(\d+)$", r"-p \2 \1", host)
        return RosmlError(text, f"if this prints the host's key, add it to GIT_SSH_KNOWN_HOST_KEYS: ssh-keyscan {scan}")
    if "Load key " in error.said:
        text = f"{head}: ssh cannot use the key: it is damaged, or has a passphrase"
        return RosmlError(text, "set GIT_SSH_PRIVATE_KEY to the whole text of a private key without a passphrase")
    if "detected dubious ownership" in error.said or "unsafe repository" in error.said:
        place = url.removeprefix("file://")
        text = f"{head}: {place} belongs to another user, and git does not read it"
        return RosmlError(text, trusting(Path(place)))
    if url.startswith("git://"):
        text = f"{head}: cannot be read: {error.reason}"
        return RosmlError(
            text, f"write https://{url.removeprefix('git://')}: GitHub and others do not answer git:// any more"
        )
    if urls.is_local(url):
        return RosmlError(f"{head}: cannot be read: {error.reason}", "check the URL")
    names = ["GIT_HTTPS_SERVER", "GIT_HTTPS_USER", "GIT_HTTPS_PASSWORD"]
    secrets = listed(names) if url.startswith("http") else "GIT_SSH_PRIVATE_KEY (a key without a passphrase)"
    remedy = f"check the URL; if the repository is private, check {secrets} too"
    return RosmlError(f"{head}: cannot be read: {error.reason}", remedy)
