"""This machine: its files, its listeners, and the user who calls."""

from __future__ import annotations

import errno
import os
import pwd
import stat
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.run.context import Address, Host, Person

ROOT = Path("/")
ARCHITECTURES = {"x86_64": "amd64", "aarch64": "arm64"}
TIMEOUT = 0.3
NO_ADDRESS = (OSError, OverflowError, UnicodeError)
"""Errors of addresses that do not answer, of ports beyond 65535, and of names with an empty part."""

GROUP = "239.255.0.1"
ZONES = "zoneinfo/"


def host(environment: Mapping[str, str]) -> Host:
    system = os.uname()
    architecture = ARCHITECTURES.get(system.machine, "")
    return Host(ROOT, environment, system.nodename, connects, owns, echoes, architecture)


def person(environment: Mapping[str, str]) -> Person:
    """The user of this process."""
    uid, name = os.geteuid(), ""
    with suppress(KeyError):
        name = pwd.getpwuid(uid).pw_name
    try:
        folder = os.getcwd()
    except OSError as error:
        raise RosmlError(f"the current folder: {error.strerror}", "go to another folder", exit_code=2) from None
    locale = {k: v for k, v in environment.items() if k in ("LANG", "LANGUAGE") or k.startswith("LC_")}
    terminal = os.isatty(0) and os.isatty(1)
    return Person(uid, os.getegid(), name, folder, timezone(environment), locale, terminal, reads(0))


def timezone(environment: Mapping[str, str], etc: Path = Path("/etc")) -> str:
    """The name of the time zone: that of TZ, or else the system's; empty if neither has a name."""
    places = [environment.get("TZ", "").removeprefix(":")]
    with suppress(OSError):
        places.append(os.readlink(etc / "localtime"))
    with suppress(OSError, UnicodeDecodeError):
        places.append((etc / "timezone").read_text(encoding="utf-8").strip())
    return next(filter(None, map(_zone, places)), "")


def _zone(place: str) -> str:
    """The zone of a path, or of a name; empty for a path to anywhere else."""
    if ZONES in place:
        return place.rpartition(ZONES)[2]
    return "" if place.startswith(("/", ".")) else place


def reads(descriptor: int) -> bool:
    """Whether a descriptor may have something to read: a terminal, a pipe or a file; not /dev/null or a closed one."""
    try:
        status = os.fstat(descriptor)
        return not (stat.S_ISCHR(status.st_mode) and status.st_rdev == os.stat(os.devnull).st_rdev)
    except OSError:
        return False


def connects(address: Address) -> bool:
    """Whether something listens at an address."""
    import socket  # most calls ask nothing

    family = socket.AF_UNIX if isinstance(address, str) else socket.AF_INET
    with socket.socket(family, socket.SOCK_STREAM) as connection:
        connection.settimeout(TIMEOUT)
        try:
            connection.connect(address)
        except NO_ADDRESS:
            return False
    return True


def owns(address: str) -> bool:
    """Whether an address, or the address of a name, is this machine's own."""
    import socket

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as connection:
        try:
            connection.bind((address, 0))
        except NO_ADDRESS:
            return False
    return True


def echoes(port: int) -> bool:
    """Whether a packet to DDS's multicast group comes back. It does not leave this machine, and nodes that listen ignore it. If a
    node lets nobody else listen at the port, we try another port."""
    import socket
    import time

    packet = os.urandom(16)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as connection:
        for option in (socket.SO_REUSEADDR, socket.SO_REUSEPORT):
            connection.setsockopt(socket.SOL_SOCKET, option, 1)
        connection.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
        try:
            with suppress(OSError):
                connection.bind(("", port))
            if not connection.getsockname()[1]:
                connection.bind(("", 0))
            connection.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, socket.inet_aton(GROUP) + bytes(4))
            connection.sendto(packet, (GROUP, connection.getsockname()[1]))
            deadline = time.monotonic() + TIMEOUT
            while (seconds := deadline - time.monotonic()) > 0:
                connection.settimeout(seconds)
                if connection.recv(len(packet)) == packet:
                    return True
        except OSError:
            return False
    return False


def write(path: Path, content: bytes) -> None:
    """Writes a private file at once. If it has the content already, it stays, because containers have it mounted. The folder must be
    this user's: a link there may be another user's."""
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    if os.lstat(path.parent).st_uid not in (os.geteuid(), 0):
        raise PermissionError(errno.EPERM, "its folder is another user's", str(path))
    with suppress(OSError):
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
