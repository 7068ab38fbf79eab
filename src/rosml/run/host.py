"""This machine: where its files are, and what listens."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Mapping
from pathlib import Path

from rosml.run.context import Address, Host

ROOT = Path("/")
"""Where the machine's files are."""

PATIENCE = 0.3
"""Seconds in which a display answers, or does not."""


def host(environment: Mapping[str, str]) -> Host:
    """This machine."""
    return Host(ROOT, environment, os.uname().nodename, connects)


def connects(address: Address) -> bool:
    """Whether something listens at an address."""
    import socket  # most calls ask nothing

    family = socket.AF_UNIX if isinstance(address, str) else socket.AF_INET
    with socket.socket(family, socket.SOCK_STREAM) as asked:
        asked.settimeout(PATIENCE)
        try:
            asked.connect(address)
        except OSError:
            return False
    return True


def write(path: Path, content: bytes) -> None:
    """Writes a private file, which nobody sees half written. One that has the content already stays: containers have it mounted.

    Raises:
        OSError: it cannot be written.
    """
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    with contextlib.suppress(OSError):
        if path.read_bytes() == content and path.stat().st_mode & 0o777 == 0o600:
            return
    new = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with open(os.open(new, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "wb") as out:
            out.write(content)
        new.replace(path)
    except OSError:
        new.unlink(missing_ok=True)
        raise
