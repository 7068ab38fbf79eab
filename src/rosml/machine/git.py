"""git, asked about a folder. The folder may be a stranger's: nothing in it starts a program.

- We look for `.git` ourselves, and git starts at the folder that has it. A folder that only looks like a bare repository, which any
  clone can bring along, is then never taken for one, by no version of git; `safe.bareRepository` says so from git 2.38 on alone.
  git still finds `.git` itself there, and does not get it by `--git-dir`, because only then it checks whose repository it is.
- git reads the settings of a repository, and a folder that came in an archive has its own. `commit` asks `rev-list`, which checks
  no signature, has no pager, and reads neither files nor hooks. What is left is an object that is missing and has to be fetched:
  no protocol is allowed. That is said by the environment, because `protocol.ext.allow` of a repository beats `protocol.allow`.
- Of the caller's environment, git gets what it needs to find itself and its user. It gets no secret, and no other repository.
"""

from __future__ import annotations

import os
import re
import shlex
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from rosml.base.errors import RosmlError

QUIET = {
    "core.attributesFile": os.devnull,
    "core.fsmonitor": "false",
    "core.hooksPath": os.devnull,
    "core.pager": "cat",
    "diff.external": "",
    "fetch.recurseSubmodules": "false",
    "gc.auto": "0",
    "gpg.program": os.devnull,
    "gpg.openpgp.program": os.devnull,
    "gpg.ssh.program": os.devnull,
    "gpg.x509.program": os.devnull,
    "log.showSignature": "false",
    "maintenance.auto": "false",
    "safe.bareRepository": "explicit",
    "submodule.recurse": "false",
}
"""Settings with which git starts no program beside what is asked for. They go before those of repository and user."""

FETCHING = {"core.askPass": os.devnull, "core.sshCommand": os.devnull, "credential.helper": ""}
"""Settings with which git has no program to fetch by."""

CLEAN = {"GIT_NO_LAZY_FETCH": "1", "GIT_TERMINAL_PROMPT": "0", "GIT_ATTR_NOSYSTEM": "1", "LC_ALL": "C", "LANGUAGE": ""}
"""Variables that git gets for questions, and for fetching too."""

PASSED = ("HOME", "PATH", "SUDO_UID", "USER", "XDG_CONFIG_HOME")
"""Variables of the caller that git gets for questions: where it is, and whose `safe.directory` counts."""

SECONDS = 60.0
"""How long git may take for an answer."""

LATEST = 253402300799
"""The last second of the year 9999; a commit may claim any time."""


@dataclass(frozen=True)
class Commit:
    """A commit. Attributes: hash: whole. time: when it was made, in seconds since 1970, at most LATEST."""

    hash: str
    time: int


def top(folder: Path) -> Path | None:
    """The folder with `.git` that a folder belongs to: itself or one above it; None if there is none."""
    folder = folder.resolve()
    return next((place for place in (folder, *folder.parents) if _has_git(place / ".git")), None)


def _has_git(place: Path) -> bool:
    """Whether `.git` is a repository, or the file that a worktree and a submodule have. git passes over other folders."""
    try:
        return place.is_file() or os.path.lexists(place / "HEAD")
    except OSError:
        return False


def trusting(place: Path) -> str:
    """What has git read a repository that belongs to another user."""
    return f"if you trust it: git config --global --add safe.directory {shlex.quote(str(place))}"


class Distrusted(RosmlError):
    """A repository that belongs to another user, and that git therefore does not read."""


def commit(folder: Path, say: Callable[[str], object] = lambda text: None) -> Commit | None:
    """The commit that is checked out in a folder, which may be a stranger's; None if git does not say.

    Args:
        say: gets a sentence for people if git refuses to say, though there is a commit.
    """
    try:
        said = ask(folder, "rev-list", "--no-walk", "--format=%ct", "HEAD", "--")
    except Distrusted as error:
        say(f"{error.message}: its commit is not known; {error.remedy}")
        return None
    except RosmlError:
        return None
    found = re.fullmatch(rb"commit ([0-9a-f]{40,64})\n(\d+)\n", said)
    return Commit(found[1].decode(), min(int(found[2][:15]), LATEST)) if found else None


def ask(folder: Path, *arguments: str) -> bytes:
    """What git prints; nothing if it fails without a word. In a stranger's folder, ask by `commit` alone: other commands may
    start filters that its settings name.

    Args:
        folder: in a repository. Paths among the arguments are relative to its top.

    Raises:
        RosmlError: git fails, is not installed or does not end; the folder is in no repository.
    """
    place = top(folder)
    if place is None:
        raise RosmlError(f"{folder}: not a git repository", "call it in a git checkout")
    settings = [word for name, value in (QUIET | FETCHING).items() for word in ("-c", f"{name}={value}")]
    environment = {name: os.environ[name] for name in PASSED if name in os.environ} | CLEAN
    environment |= {"GIT_ALLOW_PROTOCOL": "", "GIT_OPTIONAL_LOCKS": "0", "GIT_CEILING_DIRECTORIES": str(place.parent)}
    try:
        done = subprocess.run(
            ["git", "--no-pager", *settings, *arguments],
            cwd=place,
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise RosmlError(f"git does not answer about {folder} in {SECONDS:.0f} s", "run it again") from None
    except OSError as error:
        if not isinstance(error, FileNotFoundError):
            raise RosmlError(f"git cannot be called in {folder}: {error.strerror}", "check who may enter it") from None
        raise RosmlError("git is not installed", "install it: apt-get install git") from None
    if done.returncode and done.stderr:
        said = done.stderr.decode(errors="replace").strip()
        if "detected dubious ownership" in said or "unsafe repository" in said:
            raise Distrusted(f"{place} belongs to another user, and git does not read it", trusting(place))
        raise RosmlError(f"git cannot read {folder}: {said}", "call it in a git checkout")
    return done.stdout
