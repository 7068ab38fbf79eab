"""The state folder ``.state``: everything the set-up makes is in it, and nothing else is."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import re
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from machine.console import Failure, say

LONGEST_SOCKET_PATH = 107
"""Bytes of a unix socket's path that fit into Linux' ``sockaddr_un`` (108, one of them the closing zero)."""


@dataclass(frozen=True)
class State:
    """Paths of one checkout's state.

    Attributes:
        root: the checkout.
    """

    root: Path

    @property
    def folder(self) -> Path:
        return self.root / ".state"

    @property
    def bin(self) -> Path:
        return self.folder / "bin"

    @property
    def log(self) -> Path:
        return self.folder / "log"

    @property
    def run(self) -> Path:
        return self.folder / "run"

    @property
    def services(self) -> Path:
        return self.folder / "services.json"

    @property
    def scanner(self) -> Path:
        """Where trivy is, which is installed only when something is scanned."""
        return self.folder / "scanner.json"

    @property
    def signer(self) -> Path:
        """Where cosign is, which is installed only when something is signed."""
        return self.folder / "signer.json"

    @property
    def buildx_config(self) -> Path:
        return self.folder / "buildx"

    @property
    def short_run(self) -> Path:
        """Folder for sockets when the checkout's own path is too long for one, or has odd characters."""
        digest = hashlib.sha256(os.fsencode(self.root)).hexdigest()[:12]
        return Path(f"/tmp/rosml-{os.getuid()}-{digest}")

    def socket(self, name: str) -> Path:
        """Path of a unix socket that is short and plain enough for every program."""
        path = self.run / name
        plain = re.fullmatch(r"[A-Za-z0-9._/+@-]+", str(path))
        return path if plain and len(os.fsencode(path)) <= LONGEST_SOCKET_PATH else self.short_run / name

    def prepare(self) -> None:
        """Makes the folders.

        Raises:
            Failure: the checkout is not writable, or somebody else owns the folder for sockets.
        """
        try:
            for folder in (self.folder, self.bin, self.log, self.run):
                folder.mkdir(parents=True, exist_ok=True)
            probe = self.run / f".write-{os.getpid()}"
            probe.write_bytes(b"")
            probe.unlink()
        except (FileExistsError, NotADirectoryError):
            parts = (self.folder, self.bin, self.log, self.run)
            culprit = next((part for part in parts if part.exists() and not part.is_dir()), self.folder)
            raise Failure(f"{culprit} is in the way: a folder is needed there", "move it away") from None
        except OSError as error:
            raise Failure(
                f"cannot write to {self.folder}: {error.strerror}",
                "give this user write access to the checkout, or clone it elsewhere",
            ) from None

    def prepare_socket(self, path: Path) -> None:
        """Makes a socket's folder; one under /tmp is this user's own and closed to others.

        Raises:
            Failure: another user made a folder of that name.
        """
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        if path.parent == self.short_run:
            facts = path.parent.lstat()
            if not stat.S_ISDIR(facts.st_mode) or facts.st_uid != os.getuid():
                raise Failure(f"{path.parent} belongs to somebody else", f"remove {path.parent}")
            path.parent.chmod(0o700)

    @contextmanager
    def lock(self) -> Iterator[None]:
        """Lets one set-up at a time work on this checkout. The lock goes with the process, however it ends."""
        with (self.run / "lock").open("a") as stream:
            try:
                fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                say("waiting for another set-up of this checkout to finish")
                fcntl.flock(stream, fcntl.LOCK_EX)
            yield


def write_atomically(path: Path, text: str) -> None:
    """Writes a file so that a reader sees the old text or the new one, never a part."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.{os.getpid()}")
    partial.write_text(text)
    os.replace(partial, path)


def read_json(path: Path) -> dict[str, Any] | None:
    """Content of a JSON file, or nothing where it is missing or damaged."""
    try:
        content = json.loads(path.read_text())
    except (OSError, ValueError):
        return None
    return content if isinstance(content, dict) else None
