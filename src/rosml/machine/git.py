"""Asks git about a folder. The folder may be a stranger's: nothing in it may start a program.

- We look for `.git` ourselves, and start git in the folder that has it. So no version of git takes a folder for a bare repository
  that only looks like one; `safe.bareRepository` does the same only from git 2.38 on. We do not pass `--git-dir`, because git would
  then not check who owns the repository.
- `commit` asks `rev-list`, which checks no signature, has no pager, and reads neither files nor hooks. It could still fetch a missing
  object, so we allow no protocol: in the environment, because `protocol.ext.allow` of a repository beats `protocol.allow`.
- git gets only those of the caller's variables that it needs to find itself and its user: no secret, and no other repository.
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
"""Settings that keep git from starting other programs. They count before those of repository and user."""

FETCHING = {"core.askPass": os.devnull, "core.sshCommand": os.devnull, "credential.helper": ""}

CLEAN = {"GIT_NO_LAZY_FETCH": "1", "GIT_TERMINAL_PROMPT": "0", "GIT_ATTR_NOSYSTEM": "1", "LC_ALL": "C", "LANGUAGE": ""}

PASSED = ("HOME", "PATH", "SUDO_UID", "USER", "XDG_CONFIG_HOME")
"""The caller's variables that say where git is, and whose `safe.directory` counts."""

SECONDS = 60.0
LATEST = 253402300799
"""The last second of the year 9999; a commit may claim any time."""


@dataclass(frozen=True)
class Commit:
    """A commit's whole hash, and its time in seconds since 1970, at most LATEST."""

    hash: str
    time: int


def top(folder: Path) -> Path | None:
    """The nearest folder with `.git`: the folder itself or one above it."""
    folder = folder.resolve()
    return next((place for place in (folder, *folder.parents) if _has_git(place / ".git")), None)


def _has_git(place: Path) -> bool:
    """Whether `.git` is a repository, or the file of a worktree or a submodule. git skips other folders."""
    try:
        return place.is_file() or os.path.lexists(place / "HEAD")
    except OSError:
        return False


def trusting(place: Path) -> str:
    return f"if you trust it: git config --global --add safe.directory {shlex.quote(str(place))}"


class Distrusted(RosmlError):
    """The repository belongs to another user, so git does not read it."""


def commit(folder: Path, say: Callable[[str], object] = lambda text: None) -> Commit | None:
    """The checked-out commit of a folder, which may be a stranger's. `say` gets a sentence if git refuses to read an existing one."""
    try:
        output = ask(folder, "rev-list", "--no-walk", "--format=%ct", "HEAD", "--")
    except Distrusted as error:
        say(f"{error.message}: its commit is not known; {error.remedy}")
        return None
    except RosmlError:
        return None
    match = re.fullmatch(rb"commit ([0-9a-f]{40,64})\n(\d+)\n", output)
    return Commit(match[1].decode(), min(int(match[2][:15]), LATEST)) if match else None


def ask(folder: Path, *arguments: str) -> bytes:
    """Returns git's output; nothing if git fails without a message.

    In a stranger's folder, call only `commit`: other commands may start filters from the repository's settings. Paths among the arguments
    are relative to the repository's top.
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
    except FileNotFoundError:
        raise RosmlError("git is not installed", "install it: apt-get install git") from None
    except OSError as error:
        text = f"git cannot be called in {folder}: {error.strerror}"
        raise RosmlError(text, "check the folder's permissions") from None
    if done.returncode and done.stderr:
        message = done.stderr.decode(errors="replace").strip()
        if "detected dubious ownership" in message or "unsafe repository" in message:
            raise Distrusted(f"{place} belongs to another user, and git does not read it", trusting(place))
        raise RosmlError(f"git cannot read {folder}: {message}", "call it in a git checkout")
    return done.stdout
