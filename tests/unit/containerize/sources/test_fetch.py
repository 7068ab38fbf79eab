"""Upstream sources: which commits versions mean, and what comes out. From private servers: test_private_repositories.py."""

from __future__ import annotations

import os
import shutil
import stat
import subprocess
import sys
import threading
import time

import pytest

from fakes.repositories import GIT, NOBODY, Place, commit, git, listing, pin, place, repos, with_submodule
from rosml.base.file_lock import turn
from rosml.containerize.sources.fetch import Options, Repository, fetch

__all__ = ["place"]


def test_every_repos_file_counts_until_nothing_is_new(place: Place) -> None:
    deep, middle = place.root / "deep", place.root / "middle"
    deep_commit = commit(deep, {"d": "d"})
    hidden = repos(absent=("/absent", ""))
    files = {"src/more.repos": repos(deep=(deep, "main")), "run.sh": "", "no/COLCON_IGNORE": "", "no/x.repos": hidden}
    commit(middle, files)
    (middle / "run.sh").chmod(0o755)
    (middle / "link").symlink_to("run.sh")
    middle_commit = commit(middle)
    place.put(f"repositories:\n  group/middle:\n    type: git\n    url: file://{middle}\n", "a/b.repos")
    place.put("repositories:\n")
    place.put("# nothing\n", "empty.repos")
    place.put(hidden, ".git/x.repos")
    assert place.fetch() == [
        Repository("deep", str(deep), "main", deep_commit, "upstream/group/middle/src/more.repos", True),
        Repository("group/middle", f"file://{middle}", "", middle_commit, "a/b.repos", True),
    ]
    first = listing(place.out)
    assert first["deep/d"][1] == "d" and first["group/middle/link"][1] == "run.sh"
    assert first["group/middle/run.sh"][0] == oct(stat.S_IFREG | 0o755)
    assert not [name for name in first if ".git" in name]
    umask = os.umask(0o077)
    try:
        fetch(place.target, place.root / "again", place.root / "new cache", NOBODY, Options(local=True))
    finally:
        os.umask(umask)
    assert listing(place.root / "again") == first


def test_what_versions_mean(place: Place) -> None:
    a, first = place.a()
    git(a, "tag", "-a", "-m", "t", "1.10")
    git(a, "tag", "both")
    second = commit(a, {"f": "2"})
    git(a, "branch", "both")
    git(a, "branch", "feature/x")
    meant = {
        "": (second, True),
        "main": (second, True),
        "feature/x": (second, True),
        "1.10": (first, False),
        "refs/tags/1.10": (first, False),
        "both": (first, False),
        first: (first, False),
        first[:9]: (first, False),
    }
    lines = "".join(f"  p{i}: {{type: git, url: {a}, version: {version}}}\n" for i, version in enumerate(meant))
    place.put(f"repositories:\n{lines}")
    assert {item.version: (item.commit, item.moving) for item in place.fetch()} == meant
    assert place.read("p3/f") == place.read("p7/f") == "1"
    assert any("both is a tag and a branch; the tag counts" in text for text in place.sentences)


def test_a_version_that_is_missing(place: Place) -> None:
    a, _ = place.a()
    place.put(f"repositories:\n  lib/a: {{type: git, url: {a}, version: mian}}\n")
    error = place.refused()
    assert error.message == f".repos:2: lib/a ({a}): it has no version 'mian'"
    assert error.remedy == "did you mean 'main'?" and error.exit_code == 2
    for version in ("1" * 40, "abcdef1"):
        place.put(repos(a=(a, version)))
        assert f"it has no commit {version}" in place.refused().message
    place.put(repos(a=(place.root / "nowhere", "")))
    assert "cannot be read" in place.refused().message


def test_a_lock_file_names_the_commits(place: Place) -> None:
    url, first = place.a()
    commit(url, {"f": "2"})
    [repository] = place.fetch(pins=pin(url, "main", first))
    assert (repository.commit, repository.moving, place.read("a/f")) == (first, False, "1")
    assert "does not have it" in place.refused(pins={}).message
    for other in (pin(url, "v1", first), pin("/elsewhere", "main", first)):
        error = place.refused(pins=other)
        assert "another url or version" in error.message and "--lock" in error.remedy
    place.put(repos(a=(url, "v1")))
    error = place.refused(pins=pin(url, "v1", first))
    assert "it has no version 'v1'" in error.message and "--lock" in error.remedy


@pytest.mark.parametrize("version", ["v1", "main", "", "refs/tags/v1", "HASH", "SHORT"])
def test_a_lock_file_names_no_commit_that_its_version_does_not_lead_to(place: Place, version: str) -> None:
    """A forge gives a commit of a pull request, or of a fork, to everybody who names its hash."""
    url, first = place.a()
    git(url, "tag", "-a", "-m", "t", "v1")
    git(url, "config", "uploadpack.allowAnySHA1InWant", "true")
    git(url, "checkout", "--quiet", "--detach")
    evil = commit(url, {"f": "evil"})
    git(url, "update-ref", "refs/pull/7/head", evil)
    git(url, "checkout", "--quiet", "main")
    version = {"HASH": first, "SHORT": first[:9]}.get(version, version)
    place.put(repos(a=(url, version)))
    for _ in range(2):
        error = place.refused(pins=pin(url, version, evil))
        assert f"does not lead to {evil}" in error.message and "--lock" in error.remedy and error.exit_code == 2
        assert not listing(place.out)
        [repository] = place.fetch(pins=pin(url, version, first))
        assert repository.commit == first and place.read("a/f") == "1"
        shutil.rmtree(place.out)


def test_a_pinned_commit_is_asked_for_once(place: Place) -> None:
    """And its history comes without files, if the server can leave them out."""
    url, first = place.a()
    commit(url, {"f": "2"})
    git(url, "config", "uploadpack.allowFilter", "true")
    log = place.trace()
    place.fetch(pins=pin(url, "main", first))
    assert '"pack-objects"' in log.read_text() and "--filter=tree:0" in log.read_text()
    url.rename(place.root / "gone")
    shutil.rmtree(place.out)
    place.fetch(pins=pin(url, "main", first))
    assert place.read("a/f") == "1"
    assert "cannot be read" in place.refused(pins=pin(url, "main", "1" * 40)).message


# ---- The folder and the cache ----------------------------------------------------------------------------------------


def test_the_second_call_transfers_little_and_writes_nothing(place: Place) -> None:
    a, first = place.a()
    b = place.root / "b"
    commit(b, {"f": "1"})
    place.put(repos(a=(a, first), b=(b, "main"), c=(a, "main")))
    place.fetch()
    before = (place.out / "a").stat()
    second = commit(b, {"f": "2"})
    place.put(repos(a=(a, first), b=(b, "main")))
    a.rename(place.root / "gone")  # a commit in the cache needs no server
    assert [item.commit for item in place.fetch()] == [first, second]
    assert (place.out / "a").stat() == before and place.read("b/f") == "2"
    assert sorted(item.name for item in place.out.iterdir()) == ["a", "b"]
    assert all((kept / "shallow").exists() for kept in place.cache.glob("*.git"))
    shutil.rmtree(place.out)
    place.fetch()
    assert place.read("a/f") == "1"


def test_a_folder_with_something_else_stays_as_it_is(place: Place) -> None:
    place.out.mkdir()
    (place.out / "mine").touch()
    assert place.refused().remedy == "name an empty folder" and (place.out / "mine").exists()


@pytest.mark.parametrize("damage", ["no objects", "half of each object", "a lock", "a file"])
def test_a_damaged_cache_is_made_again(place: Place, damage: str) -> None:
    a, _ = place.a({"f": "1" * 5000})
    place.fetch()
    kept = next(place.cache.glob("*.git"))
    if damage == "no objects":
        shutil.rmtree(kept / "objects")
    elif damage == "half of each object":
        for file in [file for file in (kept / "objects").rglob("*") if file.is_file()]:
            file.chmod(0o644)
            file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
    elif damage == "a lock":
        (kept / "shallow.lock").touch()
        commit(a, {"f": "2"})
    else:
        shutil.rmtree(kept)
        kept.write_text("")
    shutil.rmtree(place.out)
    place.fetch()
    assert place.read("a/f") == (a / "f").read_text()


def test_two_calls_at_once(place: Place) -> None:
    a, _ = place.a({f"f{i}": "1" for i in range(200)})
    place.put(repos(**{f"p{i}": (a, "main") for i in range(10)}))
    outs = [place.root / f"out{i % 2}" for i in range(4)]
    arguments = [(place.target, out, place.cache, NOBODY, Options(local=True)) for out in outs]
    threads = [threading.Thread(target=fetch, args=each) for each in arguments]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(listing(outs[0])) == 2010 and listing(outs[0]) == listing(outs[1])


def test_a_server_that_gives_no_single_commits(place: Place) -> None:
    a, first = place.a()
    second = commit(a, {"f": "2"})
    place.trace("[protocol]\n\tversion = 0\n")  # the old one, in which a server gives the tips of branches alone
    place.put(repos(p1=(a, first), p2=(a, "main"), p3=(a, first[:10])))
    assert [item.commit for item in place.fetch()] == [first, second, first]
    assert [place.read(f"p{i}/f") for i in (1, 2, 3)] == ["1", "2", "1"]


def test_the_users_configuration_opens_repositories_and_changes_no_file(
    place: Place, monkeypatch: pytest.MonkeyPatch
) -> None:
    place.a({"f": "1\n", "x.dat": "1", ".gitattributes": "*.dat filter=touch\n"})
    place.put(repos(a=("https://git.test/a", "main")))
    for name in ("post-checkout", "reference-transaction", "post-index-change"):
        place.program(name, f"touch {place.root}/hooked")
    hooks = place.root / "programs"
    place.trace(
        f'[url "file://{place.root}/"]\n\tinsteadOf = https://git.test/\n'
        f"[core]\n\tautocrlf = true\n\thooksPath = {hooks}\n\tfsmonitor = {hooks}/post-checkout\n"
    )
    git(place.root, "init", "--quiet")  # this one has nothing to do with it
    git(place.root, "config", "url./nowhere/.insteadOf", "https://git.test/a")
    place.fetch()
    shutil.rmtree(place.cache)
    monkeypatch.setenv("GIT_DIR", str(place.root / ".git"))
    place.fetch()
    assert (place.out / "a/f").read_bytes() == b"1\n"
    assert not (place.root / "hooked").exists()


def test_a_call_that_is_killed_is_finished_by_the_next(place: Place) -> None:
    """It is killed before every second of its calls of git."""
    commit(place.root / "sub", {"s": "1"})
    a, _ = place.a({"f": "1", "g/x.repos": repos(b=(place.root / "sub", "main"))})
    with_submodule(a, "../sub")
    place.fetch()
    whole = listing(place.out)
    counting = f'echo >>{place.root}/calls\ntest "$(wc -l <{place.root}/calls)" != "${{LAST:-0}}"'
    place.program("git", f'{counting} || {{ kill -9 $PPID; exit 1; }}\nexec {GIT} "$@"')
    code = (
        "import sys; from pathlib import Path; from rosml.containerize.sources.fetch import Options, fetch; from rosml.containerize.sources.git import Access;"
        "fetch(*map(Path, sys.argv[1:]), Access(), Options(local=True))"
    )
    command = [sys.executable, "-c", code, str(place.target), str(place.out), str(place.cache)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    codes: list[int] = []
    while not codes or codes[-1]:
        shutil.rmtree(place.out)
        shutil.rmtree(place.cache)
        (place.root / "calls").unlink(missing_ok=True)
        last = {"LAST": str(2 * len(codes) + 2)}
        codes.append(subprocess.run(command, env=environment | last, check=False).returncode)
        place.fetch()
        assert listing(place.out) == whole, codes
    assert len(codes) > 5 and set(codes[:-1]) == {-9}


def test_another_process_is_waited_for(place: Place) -> None:
    a, _ = place.a()
    place.fetch()
    (kept,) = place.cache.glob("*.git")
    commit(a, {"f": "2"})
    thread = threading.Thread(target=place.fetch)
    with turn(kept.with_suffix(".lock"), lambda: None):
        thread.start()
        while f"waiting for another process, which fetches {a}" not in place.sentences:
            assert thread.is_alive()
            time.sleep(0.01)
        before = listing(place.cache)
        time.sleep(0.1)
        assert listing(place.cache) == before and place.read("a/f") == "1"
    thread.join()
    assert place.read("a/f") == "2"


@pytest.mark.parametrize(
    ("call", "reason"), [("fetch", "write error: No space left on device"), ("read-tree", "unable to write file f")]
)
def test_a_full_disk(place: Place, call: str, reason: str) -> None:
    """The commits of earlier calls stay, for they are the most that a full disk has room for."""
    a, first = place.a()
    place.fetch()
    [kept] = place.cache.glob("*.git")
    commit(a, {"f": "2"})
    place.program("git", f'case " $* " in *" {call} "*) echo "fatal: {reason}" >&2; exit 1;; esac\nexec {GIT} "$@"')
    error = place.refused()
    assert error.message.endswith(f"cannot be written: {reason}") and "free some disk space" in error.remedy
    assert first in git(kept, "rev-parse", f"refs/rosml/{first}")


def test_without_git(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(place.root))
    assert place.fetch() == []
    place.put(repos(a=("/a", "main")))
    assert "git is not installed" in place.refused().message


# ---- Submodules and LFS ----------------------------------------------------------------------------------------------


def test_submodules_at_their_commits(place: Place) -> None:
    inner, middle = place.root / "inner", place.root / "middle"
    commit(inner, {"i": "1"})
    commit(middle, {"m": "1"})
    with_submodule(middle, "../inner", "lib/inner")
    a, _ = place.a()
    version = with_submodule(a, f"file://{middle}", "middle")
    commit(inner, {"i": "2"})
    place.put(repos(a=(a, version)))
    place.fetch()
    contents = {name: content for name, (_, content) in listing(place.out).items() if content and "git" not in name}
    assert contents == {"a/f": "1", "a/middle/m": "1", "a/middle/lib/inner/i": "1"}


def test_a_submodule_without_a_url(place: Place) -> None:
    a, _ = place.a()
    for name in ("lost", "off"):
        git(a, "update-index", "--add", "--cacheinfo", f"160000,{'1' * 40},{name}")
    (a / ".gitmodules").write_text('[submodule "off"]\n\tpath = off\n\turl = ../off\n\tupdate = none\n')
    git(a, "add", ".gitmodules")
    git(a, "commit", "--quiet", "-m", "a")
    place.fetch()
    for name in ("lost", "off"):
        assert list((place.out / "a" / name).iterdir()) == []
        assert [text for text in place.sentences if f"the submodule {name} has no URL" in text]


def test_a_submodule_below_a_link(place: Place) -> None:
    """Its files would land wherever the link leads. Today's git makes no such index, whatever the tree is that a server sends."""
    sub = commit(place.root / "sub", {"s": "1"})
    elsewhere = place.root / "elsewhere"
    (elsewhere / "sub").mkdir(parents=True)
    (elsewhere / "sub/mine").write_text("1")
    a, _ = place.a({".gitmodules": '[submodule "x"]\n\tpath = link/sub\n\turl = ../sub\n'})
    (a / "link").symlink_to(elsewhere)
    commit(a)
    listed = f"""case " $* " in *" ls-files "*) printf '160000 {sub} 0\\tlink/sub\\0' ;; esac"""
    place.program("git", f'{GIT} "$@" || exit\n{listed}')
    assert "the submodule link/sub leads out of its repository" in place.refused().message
    assert [file.name for file in (elsewhere / "sub").iterdir()] == ["mine"]


POINTER = f"version https://git-lfs.github.com/spec/v1\noid sha256:{'1' * 64}\nsize 3\n"

GIT_LFS = """
# Speaks git's protocol for filters as far as a checkout needs it.
import sys
def read():
    lines = []
    while (size := int(sys.stdin.buffer.read(4) or exit(), 16)):
        lines.append(sys.stdin.buffer.read(size - 4))
    return lines
def write(*lines):
    for line in lines:
        sys.stdout.buffer.write(b"%04x" % (len(line) + 4) + line)
    sys.stdout.buffer.write(b"0000")
    sys.stdout.flush()
assert sys.argv[1:] == ["filter-process"]
read(), write(b"git-filter-server\\n", b"version=2\\n")
read(), write(b"capability=smudge\\n")
while read():
    assert b"".join(read()).startswith(b"version https://git-lfs")
    write(b"status=success\\n"), write(b"big"), write()
"""


def test_files_in_lfs(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    place.a({".gitattributes": "*.bin filter=lfs\n", "b/x.bin": POINTER, "doc.txt": POINTER})
    place.trace('[filter "lfs"]\n\tprocess = git-lfs filter-process\n\trequired = true\n')
    for name in ("git", "sh"):
        (place.root / "programs" / name).symlink_to(str(shutil.which(name)))
    monkeypatch.setenv("PATH", str(place.root / "programs"))
    error = place.refused()
    assert "files in Git LFS" in error.message and error.remedy == "install git-lfs"
    assert list(place.out.iterdir()) == []
    (place.root / "lfs.py").write_text(GIT_LFS)
    place.program("git-lfs", f'exec {sys.executable} {place.root}/lfs.py "$@"')
    place.fetch()
    assert place.read("a/b/x.bin") == "big" and place.read("a/doc.txt") == POINTER
