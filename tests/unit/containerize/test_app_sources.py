"""Upstream sources of apps: real git repositories, by file, https and ssh."""

from __future__ import annotations

import base64
import contextlib
import http.server
import json
import os
import re
import shutil
import ssl
import stat
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

import pytest
import trustme

from fakes.stubs import executable
from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.containerize.lock import Pin
from rosml.containerize.sources import fetch as sources
from rosml.containerize.sources import repos_file
from rosml.containerize.sources.fetch import Access, Options, Repository, fetch
from rosml.containerize.sources.git import Failed, opened

NOBODY = Access()
SECRET = "s3cret-canary"


def git(folder: Path, *arguments: str) -> str:
    """Calls git as an author does."""
    options = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "protocol.file.allow=always"]
    command = ["git", "-C", str(folder), *options, *arguments]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def commit(folder: Path, files: dict[str, str]) -> str:
    """Commits files to a repository, which it makes; gives the hash."""
    if not folder.exists():
        folder.mkdir(parents=True)
        git(folder, "init", "--quiet", "--initial-branch=main")
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "--allow-empty", "-m", "a")
    return git(folder, "rev-parse", "HEAD")


def repos(**entries: tuple[str | Path, str]) -> str:
    """A `.repos` file."""
    listed = {path: {"type": "git", "url": str(url), "version": version} for path, (url, version) in entries.items()}
    return json.dumps({"repositories": listed})


def listing(folder: Path) -> dict[str, tuple[str, str]]:
    """All that is below a folder: kinds, modes and contents."""
    found = {}
    for item in sorted(folder.rglob("*")):
        mode = oct(item.lstat().st_mode)
        content = os.readlink(item) if item.is_symlink() else item.read_text("latin-1") if item.is_file() else ""
        found[item.relative_to(folder).as_posix()] = (mode, content)
    return found


@dataclass
class Place:
    """A target, and where its sources go."""

    root: Path

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

    def fetch(self, access: Access = NOBODY, **options: object) -> list[Repository]:
        self.said: list[str] = []
        chosen = Options(**{"local": True} | options)  # type: ignore[arg-type]
        return fetch(self.target, self.out, self.cache, access, chosen, self.said.append)

    def refused(self, access: Access = NOBODY, **options: object) -> RosmlError:
        """The error of a call."""
        with pytest.raises(RosmlError) as caught:
            self.fetch(access, **options)
        error = caught.value
        assert error.remedy and SECRET not in f"{error.message} {error.remedy}"
        assert "\n" not in error.message or "two different" in error.message
        return error


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Place:
    """A target without files, of a user without configuration."""
    (tmp_path / "home").mkdir()
    (tmp_path / "target").mkdir()
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("GIT_CONFIG_NOSYSTEM", "1")
    for name in ("XDG_CONFIG_HOME", "GIT_SSH", "GIT_SSH_COMMAND", "GIT_ASKPASS", "SSH_ASKPASS"):
        monkeypatch.delenv(name, raising=False)
    return Place(tmp_path)


def test_every_repos_file_counts_until_nothing_is_new(place: Place) -> None:
    deep = commit(place.root / "deep", {"d": "d"})
    middle = commit(
        place.root / "middle",
        {
            "src/more.repos": repos(deep=(place.root / "deep", "main")),
            "run.sh": "#!/bin/sh\n",
            "no/COLCON_IGNORE": "",
            "no/x.repos": repos(absent=("/absent", "")),
        },
    )
    (place.root / "middle/run.sh").chmod(0o755)
    (place.root / "middle/link").symlink_to("run.sh")
    middle = commit(place.root / "middle", {})
    place.put("repositories:\n  group/middle:\n    type: git\n    url: " + f"file://{place.root}/middle\n", "a/b.repos")
    place.put("repositories:\n")
    place.put("# nothing\n", "empty.repos")
    place.put(repos(absent=("/absent", "")), ".git/x.repos")
    found = place.fetch()
    assert found == [
        Repository("deep", str(place.root / "deep"), "main", deep, "upstream/group/middle/src/more.repos", True),
        Repository("group/middle", f"file://{place.root}/middle", "", middle, "a/b.repos", True),
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


def test_one_file_alone(place: Place) -> None:
    commit(place.root / "a", {"x.repos": repos(absent=("/absent", ""))})
    place.put(repos(absent=("/absent", "")), "other.repos")
    assert place.fetch(recursive=False) == [] and listing(place.out) == {}
    place.put(repos(a=(place.root / "a", "main")))
    assert [item.path for item in place.fetch(recursive=False)] == ["a"]
    (place.root / "outside.repos").write_text("repositories: {}")
    (place.target / "link.repos").symlink_to("../outside.repos")
    for name in ("nowhere.repos", "../outside.repos", "link.repos"):
        assert f"{name}: no file below" in place.refused(recursive=False, file=name).message


def test_a_file_that_is_left_out(place: Place) -> None:
    commit(place.root / "a", {"x": ""})
    place.put(repos(a=(place.root / "a", "main")))
    place.put(repos(absent=("/absent", "")), "uses.repos")
    assert [item.path for item in place.fetch(without="uses.repos")] == ["a"]


def test_what_versions_mean(place: Place) -> None:
    a = place.root / "a"
    first = commit(a, {"f": "1"})
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
    found = place.fetch()
    assert {item.version: (item.commit, item.moving) for item in found} == meant
    assert (place.out / "p3/f").read_text() == "1" and (place.out / "p7/f").read_text() == "1"
    assert [text for text in place.said if "the tag counts" in text and "both is a tag and a branch" in text]


def test_a_lock_file_names_the_commits(place: Place) -> None:
    url = place.root / "a"
    first = commit(url, {"a": "1"})
    commit(url, {"a": "2"})
    place.put(repos(a=(url, "main")))
    [found] = place.fetch(pins={"a": Pin(url=str(url), version="main", commit=first)})
    assert (found.commit, found.moving, listing(place.out)["a/a"][1]) == (first, False, "1")
    assert "does not have it" in place.refused(pins={}).message
    for other in (Pin(url=str(url), version="v1", commit=first), Pin(url="/elsewhere", version="main", commit=first)):
        error = place.refused(pins={"a": other})
        assert "another url or version" in error.message and "--lock" in error.remedy


@pytest.mark.parametrize("version", ["v1", "main", "", "refs/tags/v1", "HASH", "SHORT"])
def test_a_lock_file_names_no_commit_that_its_version_does_not_lead_to(place: Place, version: str) -> None:
    """A forge gives a commit of a pull request, or of a fork, to everybody who names its hash."""
    url = place.root / "a"
    first = commit(url, {"a": "1"})
    git(url, "tag", "-a", "-m", "t", "v1")
    git(url, "config", "uploadpack.allowAnySHA1InWant", "true")
    git(url, "checkout", "--quiet", "--detach")
    evil = commit(url, {"a": "evil"})
    git(url, "update-ref", "refs/pull/7/head", evil)
    git(url, "checkout", "--quiet", "main")
    version = {"HASH": first, "SHORT": first[:9]}.get(version, version)
    place.put(repos(a=(url, version)))
    for _ in range(2):
        error = place.refused(pins={"a": Pin(url=str(url), version=version, commit=evil)})
        assert f"does not lead to {evil}" in error.message and "--lock" in error.remedy and error.exit_code == 2
        assert not listing(place.out)
        [found] = place.fetch(pins={"a": Pin(url=str(url), version=version, commit=first)})
        assert found.commit == first and listing(place.out)["a/a"][1] == "1"
        shutil.rmtree(place.out)


def test_a_pinned_commit_is_asked_for_once(place: Place) -> None:
    """And its history comes without files, if the server can leave them out."""
    url = place.root / "a"
    first = commit(url, {"a": "1"})
    commit(url, {"a": "2"})
    git(url, "config", "uploadpack.allowFilter", "true")
    place.put(repos(a=(url, "main")))
    pins = {"a": Pin(url=str(url), version="main", commit=first)}
    log = trace(place)
    place.fetch(pins=pins)
    assert '"pack-objects"' in log.read_text() and "--filter=tree:0" in log.read_text()
    url.rename(place.root / "gone")
    shutil.rmtree(place.out)
    place.fetch(pins=pins)
    assert listing(place.out)["a/a"][1] == "1"
    pins = {"a": Pin(url=str(url), version="main", commit="1" * 40)}
    assert "cannot be read" in place.refused(pins=pins).message


def test_a_version_of_a_lock_file_that_is_gone(place: Place) -> None:
    url = place.root / "a"
    first = commit(url, {"a": "1"})
    place.put(repos(a=(url, "v1")))
    error = place.refused(pins={"a": Pin(url=str(url), version="v1", commit=first)})
    assert "it has no version 'v1'" in error.message and "--lock" in error.remedy


def test_a_version_that_is_not_there(place: Place) -> None:
    a = place.root / "a"
    commit(a, {"f": "1"})
    place.put("repositories:\n" + f"  lib/a: {{type: git, url: {a}, version: mian}}\n", "x.repos")
    error = place.refused()
    assert error.message == f"x.repos:2: lib/a ({a}): it has no version 'mian'"
    assert error.remedy == "did you mean 'main'?" and error.exit_code == 2
    for version in ("1" * 40, "abcdef1"):
        place.put(repos(a=(a, version)), "x.repos")
        assert f"it has no commit {version}" in place.refused().message
    place.put(repos(a=(place.root / "nowhere", "")), "x.repos")
    assert "cannot be read" in place.refused().message


def test_two_files_that_contradict_each_other(place: Place) -> None:
    a = place.root / "a"
    commit(a, {"f": "1"})
    place.put(repos(a=(a, "main")), "1.repos")
    place.put(repos(a=(f"{a}/", "main")), "2.repos")
    assert len(place.fetch()) == 1
    place.put(repos(a=(a, "v2")), "2.repos")
    error = place.refused()
    assert f"1.repos:1: main of {a}" in error.message and f"2.repos:1: v2 of {a}" in error.message
    assert "--vcs-import-file 1.repos" in error.remedy and len(place.fetch(recursive=False, file="1.repos")) == 1
    for first, second in (("a", "a/b"), ("a/b", "a")):
        place.put(repos(**{first: (a, "main")}), "1.repos")
        place.put(repos(**{second: (a, "main")}), "2.repos")
        assert "a/b lies within a, which " in place.refused().message


def test_the_format_of_rosinstall_is_read_as_vcstool_does(place: Place) -> None:
    url = place.root / "a"
    hash = commit(url, {"f": "1"})
    place.put(
        f"- git: {{local-name: lib/a, uri: {url}, version: main}}\n- git: {{local-name: b, uri: {url}}}\n", "x.repos"
    )
    found = place.fetch()
    assert [(each.path, each.version, each.commit) for each in found] == [("b", "", hash), ("lib/a", "main", hash)]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("repositories: {../x: {type: git, url: 'https://h/x'}}", "leads out of the folder"),
        ("repositories: {/x: {type: git, url: 'https://h/x'}}", "leads out of the folder"),
        ("repositories: {a/.git/x: {type: git, url: 'https://h/x'}}", "a name that git uses itself"),
        ("repositories: {x: {type: git, url: '--upload-pack=touch x'}}", "the url is not valid"),
        ("repositories: {x: {type: git, url: 'ext::sh -c x'}}", "starts a program"),
        ("repositories: {x: {type: git, url: 'ext::x'}}", "starts a program"),
        ("repositories: {x: {type: git, url: 'fd://3/x'}}", "not allowed"),
        ("repositories: {x: {type: git, url: 'ssh://-oProxyCommand=x/y'}}", "no host"),
        ("repositories: {x: {type: git, url: '-oProxyCommand=x:y'}}", "the url is not valid"),
        ("repositories: {x: {type: git, url: 'git@-oProxyCommand=x:y'}}", "the url is not valid"),
        ("repositories: {x: {type: git, url: 'a/b'}}", "the url is not valid"),
        (f"repositories: {{x: {{type: git, url: 'https://u:{SECRET}@h/x'}}}}", "holds a password"),
        ("repositories: {x: {type: git, url: 'https://h/x', version: --x}}", "is no version"),
        ("repositories: {x: {type: hg, url: 'https://h/x'}}", "the type is hg; only git works"),
        ("repositories: {x: {url: 'https://h/x'}}", "x: no type; add 'type: git'"),
        ("repositories: {.: {type: git, url: 'https://h/x'}}", "'.' is the folder for sources itself"),
        ("repositories: {x: {type: git}}", "no url"),
        ("repositories: {x: 1}", "x is no mapping"),
        ("repositories: {x: {type: git, url: /a}, x: {type: git, url: /b}}", "x is there twice"),
        ("- git: {local-name: x}", "git: no uri; write it as '- git:"),
        ("- git: {uri: /a}", "git: no local-name"),
        ("- git: {local-name: x, uri: /a, url: /b}", "unknown key 'url'; did you mean 'uri'?"),
        ("- git: {local-name: x, uri: /a}\n  hg: {}", "no repository of the format of rosinstall"),
        ("- svn: {local-name: x, uri: /a}", "the type is svn; only git works"),
        ("- git: {local-name: x, uri: 'https://h/x'}\n- git: {local-name: x, uri: 'https://h/y'}", "x is there twice"),
        ("- x", "a repository is no mapping"),
        ("x", "the file is no mapping"),
        ("repos: {}", "no key 'repositories'"),
        ("repositories: [", "not YAML"),
        (
            "repositories: {x: {type: git, url: 'https://h/x', verison: '1'}}",
            "unknown key 'verison'; did you mean 'version'?",
        ),
        ("repositories: {x: {type: git, url: 'https://h/x', tag: '1'}}", "unknown key 'tag'; did you mean 'version'?"),
        (
            "repositories: {x: {type: git, url: 'https://h/x', depth: 1}}",
            "unknown key 'depth'; known: type, url, version",
        ),
        ("repositorys: {}\nrepositories: {}", "unknown key 'repositorys'; did you mean 'repositories'?"),
        ("extend: a.repos\nrepositories: {}", "unknown key 'extend'; did you mean 'extends'?"),
        ("extends: 2.repos", "it extends 2.repos, and there is no such file beside it"),
        ("extends: [y/a.repos, y/a.repos]", "extends has y/a.repos twice"),
        ("extends: x.repos", "it extends x.repos, which extends it"),
        ("extends: ../outside.repos", "leads out of"),
        ("extends: /etc/hostname", "leads out of"),
        ("extends: .env", "gets into no image"),
        ("extends: y", "a folder instead of a file"),
        ("extends: {a: b}", "extends is no file"),
        ("repositories: {<<: [x], x: {type: git, url: /a}}", "merges is no mapping"),
    ],
)
def test_what_is_refused(place: Place, text: str, said: str) -> None:
    place.put(f"\n{text}", "x.repos")
    place.put("repositories: {}", "y/a.repos")
    place.put("A=1", ".env")
    (place.root / "outside.repos").write_text("repositories: {}")
    error = place.refused()
    assert error.message.startswith(("x.repos:2: ", "x.repos:3: ")) and error.exit_code == 2
    assert said in f"{error.message}; {error.remedy}"


def test_a_file_may_extend_others(place: Place) -> None:
    """As in vcs2l: the later one counts, and the file itself counts before them. Those that it extends do not count alone."""
    for name in ("a", "b", "c", "d"):
        commit(place.root / name, {"f": name})
        git(place.root / name, "tag", "v1")
    every = {name: (place.root / name, "main") for name in ("a", "b", "c")}
    place.put(repos(**every), "deps/base.repos")
    place.put(repos(b=(place.root / "b", "v1"), d=(place.root / "d", "main")), "deps/more.yaml")
    place.put(f"extends: [deps/base.repos, deps/more.yaml]\n{_yaml(repos(a=(place.root / 'a', 'v1')))}", "my.repos")
    found = {repository.path: (repository.version, repository.named_in) for repository in place.fetch()}
    assert found == {
        "a": ("v1", "my.repos"),
        "b": ("v1", "deps/more.yaml"),
        "c": ("main", "deps/base.repos"),
        "d": ("main", "deps/more.yaml"),
    }
    place.put("extends: my.repos\n", "other.repos")
    assert len(place.fetch(recursive=False, file="other.repos")) == 4
    place.put("extends: ../other.repos\n", "deps/more.yaml")
    assert "which extends it" in place.refused(recursive=False, file="other.repos").message
    for number in range(repos_file.EXTENDS + 2):
        place.put(f"extends: {number + 1}.yaml\n", f"{number}.yaml")
    assert "more than 10 files extend each other" in place.refused(recursive=False, file="0.yaml").message


def _yaml(text: str) -> str:
    return "repositories: " + json.dumps(json.loads(text)["repositories"])


def test_a_mapping_has_what_it_merges(place: Place) -> None:
    a = place.root / "a"
    commit(a, {"f": "1"})
    git(a, "tag", "v1")
    place.put(
        f"""defaults: &defaults {{type: git, url: '{a}', version: main}}
repositories:
  one: {{<<: *defaults}}
  two: {{version: v1, <<: [{{version: v2}}, *defaults]}}
"""
    )
    assert {repository.path: repository.version for repository in place.fetch()} == {"one": "main", "two": "v1"}


def test_links_in_a_repository_lead_nowhere(place: Place) -> None:
    a = place.root / "a"
    commit(a, {"f": "1"})
    (place.root / "outside.repos").write_text("repositories: {}")
    (a / "x.repos").symlink_to(place.root / "outside.repos")
    commit(a, {})
    place.put(repos(a=(a, "main")))
    assert "a link that leads out" in place.refused().message


def test_the_second_call_transfers_little_and_writes_nothing(place: Place) -> None:
    a, b = place.root / "a", place.root / "b"
    first = commit(a, {"f": "1"})
    commit(b, {"f": "1"})
    place.put(repos(a=(a, first), b=(b, "main"), old=(a, "main")))
    place.fetch()
    before = (place.out / "a").stat()
    second = commit(b, {"f": "2"})
    place.put(repos(a=(a, first), b=(b, "main")))
    a.rename(place.root / "gone")  # a commit that is kept asks nobody
    assert [item.commit for item in place.fetch()] == [first, second]
    assert (place.out / "a").stat() == before and (place.out / "b/f").read_text() == "2"
    assert sorted(item.name for item in place.out.iterdir()) == ["a", "b"]
    assert all((kept / "shallow").exists() for kept in place.cache.glob("*.git"))
    shutil.rmtree(place.out)
    place.put(repos(a=(a, first)))
    place.fetch()
    assert (place.out / "a/f").read_text() == "1"


def test_a_folder_with_something_else_stays_as_it_is(place: Place) -> None:
    place.out.mkdir()
    (place.out / "mine").touch()
    assert place.refused().remedy == "name an empty folder" and (place.out / "mine").exists()


@pytest.mark.parametrize("damage", ["no objects", "half of each object", "a lock", "a file"])
def test_a_damaged_cache_is_made_again(place: Place, damage: str) -> None:
    a = place.root / "a"
    commit(a, {"f": "1" * 5000})
    place.put(repos(a=(a, "main")))
    place.fetch()
    kept = next(place.cache.glob("*.git"))
    packed = [file for file in (kept / "objects").rglob("*") if file.is_file()]
    if damage == "no objects":
        shutil.rmtree(kept / "objects")
    elif damage == "half of each object":
        for file in packed:
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
    assert (place.out / "a/f").read_text() == (a / "f").read_text()


def test_two_calls_at_once(place: Place) -> None:
    a = place.root / "a"
    commit(a, {f"f{i}": "1" for i in range(200)})
    place.put(repos(**{f"p{i}": (a, "main") for i in range(10)}))
    threads = [
        threading.Thread(
            target=fetch, args=(place.target, place.root / f"out{i % 2}", place.cache, NOBODY, Options(local=True))
        )
        for i in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(listing(place.root / "out0")) == 2010 and listing(place.root / "out0") == listing(place.root / "out1")


def test_a_server_that_gives_no_single_commits(place: Place) -> None:
    a = place.root / "a"
    first = commit(a, {"f": "1"})
    second = commit(a, {"f": "2"})
    trace(place, "[protocol]\n\tversion = 0\n")  # the old one, in which a server gives the tips of branches alone
    place.put(repos(p1=(a, first), p2=(a, "main"), p3=(a, first[:10])))
    assert [item.commit for item in place.fetch()] == [first, second, first]
    assert [(place.out / f"p{i}/f").read_text() for i in (1, 2, 3)] == ["1", "2", "1"]


def test_the_users_configuration_opens_repositories_and_changes_no_file(
    place: Place, monkeypatch: pytest.MonkeyPatch
) -> None:
    a = place.root / "a"
    commit(a, {"f": "1\n", "x.dat": "1", ".gitattributes": "*.dat filter=touch\n"})
    place.put(repos(a=("https://git.test/a", "main")))
    hooks = place.root / "hooks"
    hooks.mkdir()
    for name in ("post-checkout", "reference-transaction", "post-index-change"):
        (hooks / name).write_text(f"#!/bin/sh\ntouch {place.root}/hooked\n")
        (hooks / name).chmod(0o755)
    trace(
        place,
        f'[url "file://{place.root}/"]\n\tinsteadOf = https://git.test/\n'
        f"[core]\n\tautocrlf = true\n\thooksPath = {hooks}\n\tfsmonitor = {hooks}/post-checkout\n",
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
    a = place.root / "a"
    commit(place.root / "sub", {"s": "1"})
    commit(a, {"f": "1", "g/x.repos": repos(b=(place.root / "sub", "main"))})
    git(a, "submodule", "add", "--quiet", "../sub", "sub")
    commit(a, {})
    place.put(repos(a=(a, "main")))
    place.fetch()
    whole = listing(place.out)
    programs = place.root / "programs"
    programs.mkdir()
    (programs / "git").write_text(
        f"#!/bin/sh\necho >>{place.root}/calls\n"
        f'test "$(wc -l <{place.root}/calls)" != "$LAST" || {{ kill -9 $PPID; exit 1; }}\n'
        f'exec {shutil.which("git")} "$@"\n'
    )
    (programs / "git").chmod(0o755)
    code = (
        "import sys; from pathlib import Path; from rosml.containerize.sources.fetch import Access, Options, fetch;"
        "fetch(*map(Path, sys.argv[1:]), Access(), Options(local=True))"
    )
    command = [sys.executable, "-c", code, str(place.target), str(place.out), str(place.cache)]
    path = os.pathsep.join(str(folder) for folder in sys.path)
    ended: list[int] = []
    while not ended or ended[-1]:
        shutil.rmtree(place.out)
        shutil.rmtree(place.cache)
        (place.root / "calls").unlink(missing_ok=True)
        environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "PYTHONPATH": path}
        done = subprocess.run(command, env={**environment, "LAST": str(2 * len(ended) + 2)}, check=False)
        ended.append(done.returncode)
        place.fetch()
        assert listing(place.out) == whole, ended
    assert len(ended) > 5 and set(ended[:-1]) == {-9}


def test_another_process_is_waited_for(place: Place) -> None:
    a = place.root / "a"
    commit(a, {"f": "1"})
    place.put(repos(a=(a, "main")))
    place.fetch()
    (kept,) = place.cache.glob("*.git")
    commit(a, {"f": "2"})
    thread = threading.Thread(target=place.fetch)
    with turn(kept.with_suffix(".lock"), lambda: None):
        thread.start()
        while not any(text == f"waiting for another process, which fetches {a}" for text in place.said):
            assert thread.is_alive()
            time.sleep(0.01)
        before = listing(place.cache)
        time.sleep(0.1)
        assert listing(place.cache) == before and (place.out / "a/f").read_text() == "1"
    thread.join()
    assert (place.out / "a/f").read_text() == "2"


# ---- Submodules and LFS ------------------------------------------------------------------------------------------------


def test_submodules_at_their_commits(place: Place) -> None:
    inner, middle, outer = place.root / "inner", place.root / "middle", place.root / "outer"
    commit(inner, {"i": "1"})
    commit(middle, {"m": "1"})
    git(middle, "submodule", "add", "--quiet", "../inner", "lib/inner")
    commit(middle, {})
    commit(outer, {"o": "1"})
    git(outer, "submodule", "add", "--quiet", "--name", "x.y", f"file://{middle}", "middle")
    version = commit(outer, {})
    commit(inner, {"i": "2"})
    place.put(repos(outer=(outer, version)))
    place.fetch()
    found = {name: content for name, (_, content) in listing(place.out).items() if "gitmodules" not in name}
    assert found == {
        "outer": "",
        "outer/o": "1",
        "outer/middle": "",
        "outer/middle/m": "1",
        "outer/middle/lib": "",
        "outer/middle/lib/inner": "",
        "outer/middle/lib/inner/i": "1",
    }


def test_a_submodule_without_a_url(place: Place) -> None:
    a = place.root / "a"
    commit(a, {"f": "1"})
    git(a, "update-index", "--add", "--cacheinfo", f"160000,{'1' * 40},lost")
    git(a, "update-index", "--add", "--cacheinfo", f"160000,{'1' * 40},off")
    (a / ".gitmodules").write_text('[submodule "off"]\n\tpath = off\n\turl = ../off\n\tupdate = none\n')
    git(a, "add", ".gitmodules")
    git(a, "commit", "--quiet", "-m", "a")
    place.put(repos(a=(a, "main")))
    place.fetch()
    for name in ("lost", "off"):
        assert list((place.out / "a" / name).iterdir()) == []
        assert [text for text in place.said if f"the submodule {name} has no URL" in text]


def test_a_submodule_below_a_link(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its files would land wherever the link leads. Today's git makes no such index, whatever the tree is that a server sends."""
    lost = commit(place.root / "sub", {"s": "1"})
    a, elsewhere = place.root / "a", place.root / "elsewhere"
    (elsewhere / "sub").mkdir(parents=True)
    (elsewhere / "sub/mine").write_text("1")
    commit(a, {".gitmodules": '[submodule "x"]\n\tpath = link/sub\n\turl = ../sub\n'})
    (a / "link").symlink_to(elsewhere)
    commit(a, {})
    (place.root / "programs").mkdir()
    (place.root / "programs/git").write_text(
        f'#!/bin/sh\n{shutil.which("git")} "$@" || exit\n'
        f'case " $* " in *" ls-files "*) printf \'160000 {lost} 0\\tlink/sub\\0\' ;; esac\n'
    )
    (place.root / "programs/git").chmod(0o755)
    monkeypatch.setenv("PATH", f"{place.root}/programs:{os.environ['PATH']}")
    place.put(repos(a=(a, "main")))
    assert "the submodule link/sub leads out of its repository" in place.refused().message
    assert [file.name for file in (elsewhere / "sub").iterdir()] == ["mine"]


POINTER = f"version https://git-lfs.github.com/spec/v1\noid sha256:{'1' * 64}\nsize 3\n"

GIT_LFS = f"""#!{sys.executable}
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
    a = place.root / "a"
    commit(a, {".gitattributes": "*.bin filter=lfs\n", "b/x.bin": POINTER, "doc.txt": POINTER})
    trace(place, '[filter "lfs"]\n\tprocess = git-lfs filter-process\n\trequired = true\n')
    place.put(repos(a=(a, "main")))
    programs = only_git(place, monkeypatch)
    error = place.refused()
    assert "files in Git LFS" in error.message and error.remedy == "install git-lfs"
    assert list(place.out.iterdir()) == []
    (programs / "git-lfs").write_text(GIT_LFS)
    (programs / "git-lfs").chmod(0o755)
    place.fetch()
    assert (place.out / "a/b/x.bin").read_text() == "big" and (place.out / "a/doc.txt").read_text() == POINTER


def only_git(place: Place, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with git and a shell, which is all that PATH has."""
    programs = place.root / "programs"
    programs.mkdir()
    for name in ("git", "sh"):
        (programs / name).symlink_to(str(shutil.which(name)))
    monkeypatch.setenv("PATH", str(programs))
    return programs


@pytest.mark.parametrize(
    ("call", "said"), [("fetch", "write error: No space left on device"), ("read-tree", "unable to write file f")]
)
def test_a_full_disk(place: Place, monkeypatch: pytest.MonkeyPatch, call: str, said: str) -> None:
    """What was fetched before stays, for it is the most that a full disk has room for."""
    first = commit(place.root / "a", {"f": "1"})
    place.put(repos(a=(place.root / "a", "main")))
    place.fetch()
    [kept] = place.cache.glob("*.git")
    commit(place.root / "a", {"f": "2"})
    real = shutil.which("git")
    program = only_git(place, monkeypatch) / "git"
    program.unlink()
    program.write_text(
        f'#!/bin/sh\ncase " $* " in *" {call} "*) echo "fatal: {said}" >&2; exit 1;; esac\nexec {real} "$@"\n'
    )
    program.chmod(0o755)
    error = place.refused()
    assert error.message.endswith(f"cannot be written: {said}") and "free some disk space" in error.remedy
    assert first in git(kept, "rev-parse", f"refs/rosml/{first}")


def test_git_gets_no_secret_that_it_does_not_need(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    place.put(repos(a=(place.root / "a", commit(place.root / "a", {"f": "1"}))))
    real = shutil.which("git")
    program = only_git(place, monkeypatch) / "git"
    program.unlink()
    program.write_text(f'#!/bin/sh\nexport -p >>{place.root}/environment\nexec {real} "$@"\n')
    program.chmod(0o755)
    for name in ("GIT_HTTPS_PASSWORD", "GIT_SSH_PRIVATE_KEY", "REGISTRY_PASSWORD"):
        monkeypatch.setenv(name, SECRET)
    place.fetch()
    environment = (place.root / "environment").read_text()
    assert "GIT_NO_LAZY_FETCH" in environment
    assert re.search(r"GIT_TERMINAL_PROMPT=['\"]?0\b", environment), "nobody is there to answer"
    no_secret(place)


def test_a_password_that_a_server_echoes_is_not_shown(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    place.put(repos(a=("https://git.example.org/a", "main")))
    program = only_git(place, monkeypatch) / "git"
    program.unlink()
    program.write_text('#!/bin/sh\necho "fatal: remote: who is $ROSML_GIT_PASSWORD?" >&2; exit 1\n')
    program.chmod(0o755)
    error = place.refused(Access(https_server="git.example.org", https_user="me", https_password=SECRET))
    assert "who is ***?" in error.message


def test_without_git(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(place.root))
    assert place.fetch() == []
    place.put(repos(a=("/a", "main")))
    assert "git is not installed" in place.refused().message


# ---- Private repositories ----------------------------------------------------------------------------------------------


class _Backend(http.server.BaseHTTPRequestHandler):
    """`git http-backend` behind a password."""

    root = Path()
    asked: list[str]  # users, as they came

    def do_GET(self) -> None:
        sent = self.headers.get("Authorization", "")
        user = base64.b64decode(sent.removeprefix("Basic ")).decode() if sent else ""
        self.asked.append(user)
        if user != f"robot:{SECRET}":
            self.send_response(401)
            self.send_header("WWW-Authenticate", 'Basic realm="private"')
            self.send_header("Content-Length", "0")
            self.end_headers()
            return
        path, _, query = self.path.partition("?")
        environment = {
            **os.environ,
            "GIT_PROJECT_ROOT": str(self.root),
            "GIT_HTTP_EXPORT_ALL": "1",
            "PATH_INFO": path,
            "QUERY_STRING": query,
            "REQUEST_METHOD": self.command,
            "CONTENT_TYPE": self.headers.get("Content-Type", ""),
            "HTTP_CONTENT_ENCODING": self.headers.get("Content-Encoding", ""),
            "GIT_PROTOCOL": self.headers.get("Git-Protocol", ""),
        }
        body = self._body()
        done = subprocess.run(["git", "http-backend"], input=body, env=environment, capture_output=True, check=True)
        head, _, content = done.stdout.partition(b"\r\n\r\n")
        fields = dict(line.split(": ", 1) for line in head.decode().split("\r\n"))
        self.send_response(int(fields.pop("Status", "200").split()[0]))
        for name, value in fields.items():
            self.send_header(name, value)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    do_POST = do_GET

    def _body(self) -> bytes:
        if self.headers.get("Transfer-Encoding") != "chunked":
            return self.rfile.read(int(self.headers.get("Content-Length", 0)))
        body = b""
        while size := int(self.rfile.readline(), 16):
            body += self.rfile.read(size)
            self.rfile.readline()
        return body

    def log_message(self, format: str, *args: object) -> None:
        """Says nothing."""


@contextmanager
def serving(root: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[str, list[str]]]:
    """An https server of the repositories in a folder, which git trusts: its address, and who asked."""
    authority = trustme.CA()
    authority.cert_pem.write_to_path(root / "ca.pem")
    monkeypatch.setenv("GIT_SSL_CAINFO", str(root / "ca.pem"))
    tls = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    authority.issue_cert("127.0.0.1").configure_cert(tls)
    asked: list[str] = []
    handler = type("Handler", (_Backend,), {"root": root, "asked": asked})
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        server.socket = tls.wrap_socket(server.socket, server_side=True)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            yield f"127.0.0.1:{server.server_address[1]}", asked
        finally:
            server.shutdown()


def trace(place: Place, more: str = "") -> Path:
    """Has git write down each program that it or a child starts; the user's configuration otherwise says `more`."""
    file = place.root / "trace"
    (place.root / "home/.gitconfig").write_text(f"[trace2]\n\teventTarget = {file}\n{more}")
    return file


def no_secret(place: Place, secret: str = SECRET) -> None:
    """Checks all that is on the disk, the arguments of programs among it, and what was said."""
    files = [file for file in place.root.rglob("*") if file.is_file() and not file.is_symlink()]
    assert [file for file in files if secret.encode() in file.read_bytes()] == []
    assert secret not in "".join(place.said)


def test_a_private_repository_by_https(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    a, sub = place.root / "a", place.root / "sub"
    commit(sub, {"s": "1"})
    commit(a, {"f": "1"})
    git(a, "submodule", "add", "--quiet", "../sub", "sub")
    version = commit(a, {})
    traced = trace(place, "[credential]\n\thelper = store\n")
    with serving(place.root, monkeypatch) as (server, asked):
        access = Access(https_server=server, https_user="robot", https_password=f"{SECRET}\n")
        (place.root / "bare").mkdir()
        git(place.root, "clone", "--quiet", "--bare", str(a), "bare/a.git")
        git(place.root, "clone", "--quiet", "--bare", str(sub), "bare/sub")
        place.put(repos(a=(f"https://somebody@{server}/bare/a.git", "main")))
        (found,) = place.fetch(access)
        assert found.url == f"https://{server}/bare/a.git" and found.commit == version
        assert (place.out / "a/sub/s").read_text() == "1"
        assert "git-remote-https" in traced.read_text() and SECRET not in repr(access)
        no_secret(place)

        shutil.rmtree(place.cache)
        for wrong in (NOBODY, replace(access, https_server="127.0.0.1"), replace(access, https_server=f"x{server}")):
            asked.clear()
            error = place.refused(wrong)
            assert "cannot be read: could not read Username" in error.message and set(asked) == {""}
            assert (
                error.remedy
                == "check the URL; if the repository is private, check GIT_HTTPS_SERVER, GIT_HTTPS_USER and GIT_HTTPS_PASSWORD too"
            )
        error = place.refused(replace(access, https_user="nobody"))
        assert "Authentication failed" in error.message
        no_secret(place)


def test_a_password_needs_its_server(place: Place) -> None:
    place.put(repos(a=("https://example.org/a", "main")))
    assert "GIT_HTTPS_SERVER" in place.refused(Access(https_password=SECRET)).remedy
    assert "is no server" in place.refused(Access(https_server="a/b", https_password=SECRET)).message
    assert "several lines" in place.refused(Access(https_server="a", https_password=f"{SECRET}\nx")).message


@pytest.mark.parametrize("before", ["", "file://"])
def test_a_folder_names_no_repository_of_this_machine_unless_a_person_lets_it(before: str, place: Place) -> None:
    """It may be a stranger's, and what it names gets into images and into steps of the build."""
    commit(place.root / "private", {"p": "1"})
    text = f"repositories: {{a: {{type: git, url: '{before}{place.root}/private', version: main}}}}\n"
    (place.target / ".repos").write_text(text)
    refused = place.refused(local=False)
    assert "the url names a repository of this machine" in refused.message and "--allow-file-urls" in refused.remedy
    assert listing(place.out) == {} and [item.path for item in place.fetch()] == ["a"]


def test_a_server_names_no_repository_of_this_machine(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    private = place.root / "private"
    commit(private, {"p": "1"})
    a, b = place.root / "a", place.root / "b"
    commit(a, {"x.repos": repos(private=(private, "main"))})
    commit(b, {"f": "1"})
    git(b, "submodule", "add", "--quiet", str(private), "sub")
    commit(b, {})
    with serving(place.root, monkeypatch) as (server, _):
        access = Access(https_server=server, https_user="robot", https_password=SECRET)
        place.put(repos(a=(f"https://{server}/a/.git", "main")))
        assert "the url names a repository of this machine" in place.refused(access).message
        place.put(repos(b=(f"https://{server}/b/.git", "main")))
        assert "the submodule sub: the url names a repository of this machine" in place.refused(access).message


KEY = "-----BEGIN OPENSSH PRIVATE KEY-----\ncanary-of-the-key\n-----END OPENSSH PRIVATE KEY-----\n"

SSH = f"""#!{sys.executable}
# Answers as ssh does, as far as options say who is let in.
import os, shlex, stat, sys
words = sys.argv[1:]
options = dict(word.split("=", 1) for word in words if "=" in word)
assert options["BatchMode"] == "yes"
key = words[words.index("-i") + 1] if "-i" in words else ""
if "UserKnownHostsFile" in options:
    assert options["StrictHostKeyChecking"] == "yes"
    if "git.test ssh-ed25519" not in open(options["UserKnownHostsFile"].strip('"')).read():
        sys.exit("No ED25519 host key is known for git.test and you have requested strict checking.\\n"
                 "Host key verification failed.")
with open(os.environ["HOME"] + "/ssh", "a") as log:
    log.write(f"{{key}}\\n")
if key and (open(key, 'rb').read() != {KEY.encode()!r} or stat.S_IMODE(os.stat(key).st_mode) != 0o600):
    sys.exit("git@git.test: Permission denied (publickey).")
assert words[-2] == "git@git.test"
os.execvp("sh", ["sh", "-c", words[-1]])
"""


@pytest.fixture
def ssh(place: Place, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Puts a program in the place of ssh; gives the list of the keys that it was called with."""
    programs = place.root / "programs"
    programs.mkdir()
    (programs / "ssh").write_text(SSH)
    (programs / "ssh").chmod(0o755)
    monkeypatch.setenv("PATH", f"{programs}:{os.environ['PATH']}")
    return place.root / "home/ssh"


HOSTS = "git.test ssh-ed25519 AAAA"


@pytest.mark.parametrize("key", [KEY, KEY.strip(), KEY.replace("\n", "\\n"), KEY.replace("\n", "\r\n")])
def test_a_private_repository_by_ssh(place: Place, ssh: Path, key: str) -> None:
    a = place.root / "a"
    commit(a, {"f": "1"})
    trace(place)
    place.put(repos(a=(f"git@git.test:{a}", "main"), b=(f"ssh://git@git.test{a}", "main")))
    access = Access(ssh_key=key, ssh_known_hosts=HOSTS)
    assert [item.url for item in place.fetch(access)] == [f"git@git.test:{a}", f"ssh://git@git.test{a}"]
    keys = set(ssh.read_text().split())
    assert len(keys) == 1 and not any(Path(name).exists() for name in keys)
    (place.root / "programs/ssh").unlink()  # which knows the key
    assert "canary" not in repr(access)
    no_secret(place, "canary-of-the-key")


def test_without_a_key_ssh_is_the_users_own(place: Place, ssh: Path) -> None:
    a = place.root / "a"
    commit(a, {"f": "1"})
    place.put(repos(a=(f"git@git.test:{a}", "main")))
    place.fetch()
    assert ssh.read_text() == "\n" * len(ssh.read_text())
    trace(place, "[core]\n\tsshCommand = echo mine >&2; false\n")
    shutil.rmtree(place.cache)
    assert "cannot be read: mine" in place.refused().message


def test_ctrl_c_leaves_no_key(place: Place, ssh: Path) -> None:
    program = place.root / "programs/ssh"
    program.write_text(program.read_text().replace("assert words[-2]", f"os.kill({os.getpid()}, 2); assert words[-2]"))
    commit(place.root / "a", {"f": "1"})
    place.put(repos(a=(f"git@git.test:{place.root}/a", "main")))
    with pytest.raises(KeyboardInterrupt):
        place.fetch(Access(ssh_key=KEY, ssh_known_hosts=HOSTS))
    (name,) = ssh.read_text().split()
    assert not Path(name).parent.exists()


@pytest.mark.parametrize(("code", "calls"), [(429, 2), (503, 2), (404, 1)])
def test_a_server_that_is_too_busy_is_asked_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, code: int, calls: int
) -> None:
    monkeypatch.setattr(web, "WAIT", 0.001)
    text = f"echo x >>{tmp_path}/calls; test -e {tmp_path}/again && echo done && exit; touch {tmp_path}/again"
    said = f"fatal: unable to access 'https://h/a/': The requested URL returned error: {code}"
    executable(tmp_path / "git", f'case "$*" in *ls-remote*) ;; *) exit 1 ;; esac\n{text}; echo "{said}" >&2; exit 128')
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    with opened(Access(), tmp_path) as call, contextlib.suppress(Failed):
        assert call("ls-remote", "https://h/a") == "done\n"
    assert (tmp_path / "calls").read_text() == "x\n" * calls


@pytest.mark.parametrize(
    ("url", "said", "cause", "remedy"),
    [
        (
            "file:///srv/my robot",
            "fatal: detected dubious ownership in repository at '/srv/my robot'\nTo add an exception, call:",
            "/srv/my robot belongs to another user",
            "git config --global --add safe.directory '/srv/my robot'",
        ),
        (
            "/srv/a",
            "fatal: unsafe repository ('/srv/a' is owned by someone else)",
            "another user",
            "safe.directory /srv/a",
        ),
        (
            "git://github.com/me/a.git",
            "fatal: unable to connect to github.com:",
            "unable",
            "write https://github.com/me/a.git",
        ),
    ],
)
def test_a_failure_of_git_is_told_with_its_cause(url: str, said: str, cause: str, remedy: str) -> None:
    error = sources.explained("a.repos:2: a", url, Failed(said))
    assert cause in error.message and remedy in error.remedy


def test_ssh_says_what_is_wrong(place: Place, ssh: Path) -> None:
    a = place.root / "a"
    commit(a, {"f": "1"})
    place.put(repos(a=(f"ssh://git@git.test:2222{a}", "main")))
    error = place.refused(Access(ssh_key=KEY, ssh_known_hosts="other.test ssh-ed25519 AAAA"))
    assert "the host key of git.test:2222 is unknown" in error.message
    assert error.remedy.endswith("add it to GIT_SSH_KNOWN_HOST_KEYS: ssh-keyscan -p 2222 git.test")
    error = place.refused(Access(ssh_key="another key", ssh_known_hosts=HOSTS))
    assert error.message.endswith("git@git.test: Permission denied (publickey).")
    assert "GIT_SSH_PRIVATE_KEY" in error.remedy
    assert not any(Path(name).exists() for name in ssh.read_text().split())
    error = place.refused(Access(ssh_key=KEY))
    assert "ssh-keyscan HOST" in error.remedy and error.exit_code == 2
