"""The file with X11's cookies: `XAUTHORITY`, as libXau reads and writes it.

An entry is a family and four fields: address, number of the display, kind of secret, secret. Before each field is its length.
All numbers have two bytes, big-endian.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

LOCAL, WILD = 256, 65535


@dataclass(frozen=True)
class Entry:
    """A cookie. `number` is the display's; empty for any. `kind` is that of the secret, such as `MIT-MAGIC-COOKIE-1`."""

    family: int
    address: bytes
    number: bytes
    kind: bytes
    secret: bytes


def read(content: bytes) -> list[Entry]:
    """The entries of a file, up to the first damaged one."""
    entries, at = [], 0
    while at + 2 <= len(content):
        family, at = int.from_bytes(content[at : at + 2]), at + 2
        fields = []
        for _ in range(4):
            size = int.from_bytes(content[at : at + 2])
            fields.append(content[at + 2 : at + 2 + size])
            at += 2 + size
        if at > len(content):
            break
        entries.append(Entry(family, *fields))
    return entries


def written(entries: Iterable[Entry]) -> bytes:
    """The content of a file with these entries."""
    content = bytearray()
    for entry in entries:
        content += entry.family.to_bytes(2)
        for value in (entry.address, entry.number, entry.kind, entry.secret):
            content += len(value).to_bytes(2) + value
    return bytes(content)


def cookie(entries: Sequence[Entry], number: str, machine: str, here: str) -> Entry | None:
    """The entry for a display, changed to fit any machine, because a container has another name. An entry of the display's machine
    comes first. An entry of this machine, `here`, fits no display of another one."""
    fitting = [entry for entry in entries if entry.number in (b"", number.encode())]
    ranked = sorted(fitting, key=lambda entry: not _is_of(entry, machine))
    best = next((entry for entry in ranked if machine == here or not _is_of(entry, here)), None)
    return best and replace(best, family=WILD, address=b"", number=number.encode())


def _is_of(entry: Entry, machine: str) -> bool:
    return (entry.family, entry.address) == (LOCAL, machine.encode())
