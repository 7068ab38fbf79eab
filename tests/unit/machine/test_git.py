"""git, asked about a folder: honest repositories answer, and those of a stranger start no program. All with the real git."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable
from rosml.base.errors import RosmlError
from rosml.machine import git

TIME = 1700000000
PGP = "-----BEGIN PGP SIGNATURE-----\n \n x\n -----END PGP SIGNATURE-----"
SSH = "-----BEGIN SSH SIGNATURE-----\n x\n -----END SSH SIGNATURE-----"


@pytest.fixture(autouse=True)
def author(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An author without settings, who commits at one time."""
    (tmp_path / "home").mkdir()
    (tmp_path / "home/.gitconfig").write_text(
        '[user]\n\tname = a\n\temail = a@example.org\n[protocol "file"]\n\tallow = always\n[init]\n\tdefaultBranch = main\n'
    )
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("GIT_CONFIG_NOSYSTEM", "1")
    monkeypatch.delenv("XDG_CONFIG_HOME", raising=False)
    for name in ("GIT_AUTHOR_DATE", "GIT_COMMITTER_DATE"):
        monkeypatch.setenv(name, f"@{TIME} +0000")


def author_git(folder: Path, *arguments: str, content: str = "") -> str:
    command = ["git", "-C", str(folder), *arguments]
    return subprocess.run(command, input=content, check=True, capture_output=True, text=True).stdout.strip()


def repository(folder: Path, *options: str) -> Path:
    (folder / "sub").mkdir(parents=True)
    (folder / "sub/f").write_text("1\n")
    author_git(folder, "init", "--quiet", *options)
    author_git(folder, "add", "--all")
    author_git(folder, "commit", "--quiet", "-m", "a")
    return folder


def commit_with(folder: Path, header: str = "", moment: str = str(TIME)) -> None:
    tree = author_git(folder, "write-tree")
    who = f"a <a@example.org> {moment} +0000"
    text = f"tree {tree}\nauthor {who}\ncommitter {who}\n{header}\nm\n"
    new = author_git(folder, "hash-object", "-t", "commit", "-w", "--literally", "--stdin", content=text)
    author_git(folder, "update-ref", "refs/heads/main", new)


@pytest.fixture
def program(tmp_path: Path) -> Path:
    file = tmp_path / "program"
    file.write_text(f'#!/bin/sh\necho "$0 $*" >>{tmp_path}/ran\nexit 1\n')
    file.chmod(0o755)
    return file


def ran(program: Path) -> str:
    """What the stranger's program says of its calls."""
    file = program.with_name("ran")
    return file.read_text() if file.exists() else ""


# ---- Honest repositories ---------------------------------------------------------------------------------------------


def head(folder: Path) -> git.Commit:
    return git.Commit(author_git(folder, "rev-parse", "HEAD"), TIME)


def clone(origin: Path, folder: Path) -> Path:
    author_git(origin.parent, "clone", "--quiet", str(origin), str(folder))
    return folder


def shallow(origin: Path, folder: Path) -> Path:
    author_git(origin, "commit", "--quiet", "--allow-empty", "-m", "b")
    author_git(origin.parent, "clone", "--quiet", "--depth=1", f"file://{origin}", str(folder))
    assert (folder / ".git/shallow").exists()
    return folder


def worktree(origin: Path, folder: Path) -> Path:
    author_git(origin, "worktree", "add", "--quiet", "--detach", str(folder))
    assert (folder / ".git").is_file()
    return folder


def submodule(origin: Path, folder: Path) -> Path:
    around = repository(folder.with_name("around"))
    author_git(around, "submodule", "add", "--quiet", str(origin), "module")
    assert (around / "module/.git").is_file()
    return around / "module"


def with_names_of_git(origin: Path, folder: Path) -> Path:
    clone(origin, folder)
    (folder / "HEAD").write_text("x")
    (folder / "sub/.git").mkdir()
    author_git(folder, "tag", "HEAD")
    return folder


def signed(origin: Path, folder: Path) -> Path:
    commit_with(origin, f"gpgsig {PGP}\n")
    return origin


def of_sha256(origin: Path, folder: Path) -> Path:
    return repository(folder, "--object-format=sha256")


@pytest.mark.parametrize(
    "make",
    [clone, shallow, worktree, submodule, with_names_of_git, signed, of_sha256],
    ids=lambda make: make.__name__,
)
def test_what_an_honest_repository_has(tmp_path: Path, make: Callable[[Path, Path], Path]) -> None:
    folder = make(repository(tmp_path / "origin"), tmp_path / "made")
    assert git.commit(folder) == git.commit(folder / "sub") == head(folder)
    (tmp_path / "link").symlink_to(folder / "sub")
    assert git.commit(tmp_path / "link") == head(folder)


def test_where_there_is_no_commit(tmp_path: Path) -> None:
    assert git.commit(tmp_path) is None
    author_git(tmp_path, "init", "--quiet")
    assert git.commit(tmp_path) is None
    assert git.commit(tmp_path / "absent") is None


def test_a_commit_may_claim_any_time(tmp_path: Path) -> None:
    folder = repository(tmp_path / "a")
    commit_with(folder, moment="9" * 15)
    commit = git.commit(folder)
    assert commit and commit.time == git.LATEST
    commit_with(folder, moment="9" * 5000)
    assert (commit := git.commit(folder)) and 0 <= commit.time <= git.LATEST


def test_git_is_not_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = repository(tmp_path / "a")
    monkeypatch.setenv("PATH", str(tmp_path))
    assert git.commit(folder) is None
    with pytest.raises(RosmlError, match="git is not installed"):
        git.ask(folder, "status")


# ---- A stranger's folder ---------------------------------------------------------------------------------------------


def signature(kind: str) -> Callable[[Path, Path], None]:
    def prepare(folder: Path, program: Path) -> None:
        commit_with(folder, f"gpgsig {kind}\n")
        (folder / "signers").write_text("")
        author_git(folder, "config", "log.showSignature", "true")
        author_git(folder, "config", "gpg.program", str(program))
        author_git(folder, "config", "gpg.ssh.program", str(program))
        author_git(folder, "config", "gpg.ssh.allowedSignersFile", str(folder / "signers"))

    return prepare


def included(folder: Path, program: Path) -> None:
    signature(PGP)(folder, program)
    config = git_dir(folder) / "config"
    (folder / "innocent").write_text(config.read_text())
    author_git(folder, "config", "--unset", "log.showSignature")
    author_git(folder, "config", "include.path", str(folder / "innocent"))


def missing(**settings: str) -> Callable[[Path, Path], None]:
    def prepare(folder: Path, program: Path) -> None:
        name = author_git(folder, "rev-parse", "HEAD")
        (git_dir(folder) / "objects" / name[:2] / name[2:]).unlink()
        facts = {"core.repositoryFormatVersion": "1", "extensions.partialClone": "x", "remote.x.promisor": "true"}
        facts |= {"protocol.allow": "always", "protocol.ext.allow": "always", "protocol.file.allow": "always"}
        for key, value in (facts | settings).items():
            author_git(folder, "config", key.replace("_", "."), value.format(program=program, folder=git_dir(folder)))

    return prepare


def git_dir(folder: Path) -> Path:
    return folder / ".git" if (folder / ".git").exists() else folder


STRANGERS = {
    "a signature": signature(PGP),
    "a signature of ssh": signature(SSH),
    "settings elsewhere": included,
    "missing, ext": missing(remote_x_url="ext::{program}"),
    "missing, a local repository": missing(remote_x_url="{folder}", remote_x_uploadpack="{program}"),
    "missing, ssh": missing(remote_x_url="ssh://127.0.0.1/x", core_sshCommand="{program}"),
}


@pytest.mark.parametrize("prepare", STRANGERS.values(), ids=[*STRANGERS])
def test_settings_of_a_repository_start_nothing(
    tmp_path: Path, program: Path, prepare: Callable[[Path, Path], None]
) -> None:
    folder = repository(tmp_path / "a")
    first_commit = head(folder)
    prepare(folder, program)
    commit = git.commit(folder)
    assert not ran(program)
    assert commit is None or (commit.time == TIME and commit != first_commit), "it has another commit, or none"


def bare(folder: Path, program: Path) -> Path:
    """A folder that looks like a bare repository, with a commit whose signature the stranger's program checks."""
    author_git(folder.parent, "init", "--quiet", "--bare", "--template=", str(folder))
    author_git(folder, "config", "core.bare", "false")
    author_git(folder, "config", "core.worktree", str(folder.parent))
    commit_with(folder, f"gpgsig {PGP}\n")
    author_git(folder, "config", "log.showSignature", "true")
    author_git(folder, "config", "gpg.program", str(program))
    return folder


def test_a_folder_of_a_clone_that_looks_like_a_bare_repository(tmp_path: Path, program: Path) -> None:
    origin = repository(tmp_path / "origin")
    bare(origin / "robot", program)
    author_git(origin, "add", "--all")
    author_git(origin, "commit", "--quiet", "-m", "b")
    folder = clone(origin, tmp_path / "made")
    assert (folder / "robot/config").is_file()
    commits = git.commit(folder / "robot"), git.commit(folder / "robot/refs")
    assert not ran(program)
    assert commits == (head(folder), head(folder))


def test_such_a_folder_without_a_repository_around(tmp_path: Path, program: Path) -> None:
    bare(tmp_path / "robot", program)
    assert git.commit(tmp_path / "robot") is None
    (tmp_path / "robot/.git").mkdir()
    (tmp_path / "robot/.git/HEAD").touch()
    git.commit(tmp_path / "robot")
    (tmp_path / "linked").mkdir()
    bare(tmp_path / "linked/x", program)
    (tmp_path / "linked/.git").write_text("gitdir: x\n")
    git.commit(tmp_path / "linked")
    assert not ran(program)


def test_all_that_a_repository_can_name_as_a_program(tmp_path: Path, program: Path) -> None:
    """They are real: git runs the stranger's program, if somebody else calls it there."""
    folder = repository(tmp_path / "a")
    hooks = tmp_path / "hooks"
    hooks.mkdir()
    for name in ("post-index-change", "reference-transaction", "post-checkout"):
        (hooks / name).symlink_to(program)
    (folder / ".gitattributes").write_text("* filter=x diff=x\n")
    for key in (
        *("core.fsmonitor", "core.pager", "core.editor", "core.askPass", "core.sshCommand", "core.gitProxy"),
        *("core.alternateRefsCommand", "credential.helper", "diff.external", "diff.x.textconv", "diff.x.command"),
        *("filter.x.clean", "filter.x.smudge", "filter.x.process", "pager.rev-list", "uploadpack.packObjectsHook"),
    ):
        author_git(folder, "config", key, str(program))
    author_git(folder, "config", "alias.rev-list", f"!{program}")
    author_git(folder, "config", "core.hooksPath", str(hooks))
    os.utime(folder / "sub/f")
    head_hash = (folder / ".git/refs/heads/main").read_text().strip()
    assert git.commit(folder) == git.Commit(head_hash, TIME) and not ran(program)
    subprocess.run(["git", "-C", str(folder), "status"], capture_output=True)
    assert ran(program)


def test_questions_about_our_own_checkout_start_no_hook(tmp_path: Path, program: Path) -> None:
    folder = repository(tmp_path / "a")
    author_git(folder, "config", "core.fsmonitor", str(program))
    assert git.ask(folder / "sub", "status", "--porcelain", "--", "sub") == b""
    assert not ran(program)


def test_what_git_gets_of_the_environment(tmp_path: Path, program: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = repository(tmp_path / "a")
    commit = head(folder)
    other = repository(tmp_path / "other")
    commit_with(other, f"gpgsig {PGP}\n")
    secrets = ("GIT_HTTPS_PASSWORD", "GIT_SSH_PRIVATE_KEY", "REGISTRY_PASSWORD", "GITHUB_TOKEN", "CI_JOB_TOKEN")
    for name in secrets:
        monkeypatch.setenv(name, "s3cret-canary")
    monkeypatch.setenv("GIT_DIR", str(other / ".git"))
    monkeypatch.setenv("GIT_CONFIG_PARAMETERS", f"'log.showSignature'='true' 'gpg.program'='{program}'")
    monkeypatch.setenv("GIT_TRACE", str(tmp_path / "trace"))
    for name in ("GIT_EXTERNAL_DIFF", "GIT_SSH_COMMAND", "GIT_PAGER", "GIT_ASKPASS", "GIT_PROXY_COMMAND"):
        monkeypatch.setenv(name, str(program))
    assert git.commit(folder) == commit
    assert not ran(program) and not (tmp_path / "trace").exists()

    programs = tmp_path / "programs"
    programs.mkdir()
    printed = "import json, os; print(json.dumps([dict(os.environ), os.read(0, 1).decode()]))"
    (programs / "git").write_text(f"#!/bin/sh\nexec {sys.executable} -c '{printed}'\n")
    (programs / "git").chmod(0o755)
    monkeypatch.setenv("PATH", f"{programs}:{os.environ['PATH']}")
    environment, read_input = json.loads(git.ask(folder, "x"))
    assert read_input == "" and "s3cret-canary" not in str(environment)
    assert environment["HOME"] == os.environ["HOME"]
    assert environment["GIT_ALLOW_PROTOCOL"] == "", "older versions of git do not read GIT_NO_LAZY_FETCH"
    names = {*git.PASSED, *git.CLEAN, "GIT_ALLOW_PROTOCOL", "GIT_OPTIONAL_LOCKS", "GIT_CEILING_DIRECTORIES"}
    assert environment.keys() <= names | {"PWD", "OLDPWD", "SHLVL", "_", "LC_CTYPE"}, "what a shell adds"


def test_a_pipe_in_the_place_of_its_settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(git, "SECONDS", 0.5)
    folder = repository(tmp_path / "a")
    (folder / ".git/config").unlink()
    os.mkfifo(folder / ".git/config")
    begun = time.monotonic()
    assert git.commit(folder) is None
    assert time.monotonic() - begun < 10


def test_another_users_repository_counts_if_its_user_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = repository(tmp_path / "a")
    commit = head(folder)
    monkeypatch.delenv("SUDO_UID", raising=False)
    if os.geteuid() == 0:
        os.chown(folder, 12345, -1)
        os.chown(folder / ".git", 12345, -1)
        assert git.commit(folder) is None
    author_git(tmp_path, "config", "--global", "safe.directory", str(folder))
    assert git.commit(folder) == commit


@pytest.mark.parametrize(
    "message", ["detected dubious ownership in repository at 'x'", "unsafe repository ('x' is owned by someone else)"]
)
def test_another_users_repository_is_named_with_its_remedy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, message: str
) -> None:
    """In the words of git since 2.35."""
    place = repository(tmp_path / "my robot")
    executable(tmp_path / "git", f'echo "fatal: {message}" >&2; exit 128')
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    warnings: list[str] = []
    assert git.commit(place / "sub", warnings.append) is None
    assert warnings == [
        f"{place} belongs to another user, and git does not read it: its commit is not known;"
        f" if you trust it: git config --global --add safe.directory '{place}'"
    ]
    executable(tmp_path / "git", 'echo "fatal: bad object HEAD" >&2; exit 128')
    assert git.commit(place, warnings.append) is None and len(warnings) == 1


def test_nothing_else_calls_git() -> None:
    calls = [file for file in (ROOT / "src").rglob("*.py") if re.search(r'\[\s*"git"', file.read_text())]
    assert sorted(str(file.relative_to(ROOT / "src/rosml")) for file in calls) == [
        "containerize/sources/git.py",
        "machine/git.py",
    ]
