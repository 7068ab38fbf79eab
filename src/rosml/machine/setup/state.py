"""The state folder ``.state``, which has all files of setup."""

from __future__ import annotations

import hashlib
import os
import re
import stat
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from rosml import user_cache
from rosml.base.errors import RosmlError

LONGEST_SOCKET_PATH = 107
"""Bytes of a unix socket's path in Linux' ``sockaddr_un``: 108, one of them the closing zero."""


@dataclass(frozen=True)
class State:
    """The paths of a checkout's state, and facts from scripts/bootstrap.py."""

    root: Path
    say: Callable[[str], object] = lambda line: None
    uv: str = ""
    ca_bundle: str = ""  # the user's own; empty if the system's certificates count
    cache: Path = field(default_factory=user_cache)  # what all checkouts of this user may take from one another

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
    def short_run(self) -> Path:
        """The folder for sockets if the checkout's own path is too long for one, or has odd characters."""
        digest = hashlib.sha256(os.fsencode(self.root)).hexdigest()[:12]
        return Path(f"/tmp/rosml-{os.getuid()}-{digest}")

    def socket(self, name: str) -> Path:
        """The path of a unix socket, short and plain enough for every program."""
        path = self.run / name
        plain = re.fullmatch(r"[A-Za-z0-9._/+@-]+", str(path))
        return path if plain and len(os.fsencode(path)) <= LONGEST_SOCKET_PATH else self.short_run / name

    def prepare_socket(self, path: Path) -> None:
        """Makes a socket's folder. Under /tmp, it is this user's own, and closed to others."""
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        if path.parent == self.short_run:
            facts = path.parent.lstat()
            if not stat.S_ISDIR(facts.st_mode) or facts.st_uid != os.getuid():
                raise RosmlError(f"{path.parent} belongs to another user", f"remove {path.parent}")
            path.parent.chmod(0o700)
