"""Reads what programs and libraries in ELF need, export, and expect of others. Only segments count, as `strip` may remove sections.

A file that is damaged, or larger than any real one, counts as no ELF file.
"""

from __future__ import annotations

import os
import stat
import struct
from pathlib import Path
from typing import BinaryIO, NamedTuple

SEGMENTS, TABLE = 1024, 1 << 20
"""The most segments, and the most bytes of a dynamic section."""

LINE, NAME = 4096, 1 << 16
"""The most bytes of a library's name, and of a symbol's. Names of templates are long."""

SYMBOLS, VERSIONS, VERSION = 2 << 20, 1 << 16, 1024
"""The most symbols of a file, entries about their versions, and bytes of a version."""

TEXTS = 512 << 20
"""The most bytes of all names in a file."""

_LOAD, _DYNAMIC, _NOTE = 1, 2, 4
_BUILD_ID = 3, b"GNU\0"
"""The kind and the owner of the note with the build ID."""

_NEEDED, _HASH, _STRTAB, _SYMTAB, _STRSZ, _SONAME = 1, 4, 5, 6, 10, 14
_GNU_HASH, _VERSYM, _VERDEF, _VERDEFNUM, _VERNEED, _VERNEEDNUM = (
    0x6FFFFEF5,
    0x6FFFFFF0,
    0x6FFFFFFC,
    0x6FFFFFFD,
    0x6FFFFFFE,
    0x6FFFFFFF,
)
_ABSOLUTE = 0xFFF1
_TABLES = (_HASH, _STRTAB, _GNU_HASH, _VERSYM, _VERDEF, _VERNEED, 7, 17, 23)
"""Entries of a dynamic section that are addresses of tables, also of relocations."""

_WRONG = (OSError, struct.error, KeyError, IndexError, OverflowError, ValueError)
"""Errors that a damaged file leads to."""


class Elf(NamedTuple):
    machine: tuple[int, int, int]  # class, byte order, machine
    needed: list[str]  # libraries
    soname: str
    build: str  # the linker's build ID, in hexadecimal digits


class Symbols(NamedTuple):
    """Dynamic symbols, each as `name`, and as `name@VERSION` if it has a version."""

    exports: set[bytes]
    uses: set[bytes]  # `name@VERSION` alone if it has a version; no weak ones, since a program runs without them


def elf(path: Path) -> Elf | None:
    """None for any other file, and for one that is damaged."""
    try:
        with _opened(path) as file:
            return _File(file).elf()
    except _WRONG:
        return None


def symbols(path: Path) -> Symbols | None:
    """None if `elf` is None, and if its tables are damaged."""
    try:
        with _opened(path) as file:
            return _File(file).symbols()
    except _WRONG:
        return None


def _opened(path: Path) -> BinaryIO:
    if not stat.S_ISREG(os.lstat(path).st_mode):
        raise ValueError("no file")
    return open(path, "rb")  # the caller closes it


class _File:
    """An open file. All methods raise an error of `_WRONG` if it is damaged."""

    def __init__(self, file: BinaryIO) -> None:
        self._file, self._size = file, os.fstat(file.fileno()).st_size
        head = self._at(0, 64)
        if head[:4] != b"\x7fELF" or head[4] not in (1, 2) or head[5] not in (1, 2):
            raise ValueError("no ELF file")
        self._wide, self._order = head[4] == 2, "<" if head[5] == 1 else ">"
        kind, machine = struct.unpack_from(self._order + "HH", head, 16)
        if kind not in (2, 3):
            raise ValueError("an object file, or a core")
        self._machine = head[4], head[5], machine
        place = struct.unpack_from(self._order + ("Q" if self._wide else "I"), head, 32 if self._wide else 28)[0]
        size, count = struct.unpack_from(self._order + "HH", head, 54 if self._wide else 42)
        if count > SEGMENTS:
            raise ValueError("too many segments")
        self._loaded: list[tuple[int, int, int]] = []  # address, bytes, place in the file
        dynamic = []
        self._notes: list[tuple[int, int]] = []
        for number in range(count):
            entry = self._at(place + number * size, size)
            if self._wide:
                segment, _, offset, address, _, length = struct.unpack_from(self._order + "IIQQQQ", entry)
            else:
                segment, offset, address, _, length = struct.unpack_from(self._order + "IIIII", entry)
            if segment == _LOAD:
                self._loaded.append((address, length, offset))
            elif segment == _DYNAMIC:
                dynamic.append((offset, length))
            elif segment == _NOTE:
                self._notes.append((offset, length))
        self._versions_left = VERSIONS  # entries about versions that may still be read
        self._tags: dict[int, list[int]] = {}
        form = struct.Struct(self._order + ("qQ" if self._wide else "iI"))
        for offset, length in dynamic[:1]:
            table = self._at(offset, min(length, TABLE))
            for tag, value in form.iter_unpack(table[: len(table) // form.size * form.size]):
                if not tag:
                    break
                self._tags.setdefault(tag, []).append(value)

    def _at(self, offset: int, length: int) -> bytes:
        if offset >= self._size:
            return b""
        self._file.seek(offset)
        return self._file.read(min(length, self._size - offset))

    def _loaded_at(self, address: int, most: int) -> bytes:
        """What is loaded at an address, up to the end of its segment."""
        for start, length, offset in self._loaded:
            if start <= address < start + length:
                return self._at(offset + address - start, min(most, start + length - address))
        raise ValueError("an address that nothing is loaded at")

    def _tag(self, tag: int) -> int:
        return self._tags[tag][0]

    def _name(self, place: int) -> str:
        text = self._loaded_at(self._tag(_STRTAB) + place, LINE).partition(b"\0")[0]
        return text.decode("utf-8", "backslashreplace")

    def elf(self) -> Elf:
        needed = [self._name(place) for place in self._tags.get(_NEEDED, [])]
        soname = self._name(self._tag(_SONAME)) if _SONAME in self._tags else ""
        return Elf(self._machine, needed, soname, self._build())

    def _build(self) -> str:
        for offset, length in self._notes:
            rest = self._at(offset, min(length, LINE))
            while len(rest) >= 12:
                name, size, kind = struct.unpack_from(self._order + "III", rest)
                start = 12 + (name + 3) // 4 * 4
                if (kind, rest[12 : 12 + name]) == _BUILD_ID:
                    return rest[start : start + size].hex()
                rest = rest[start + (size + 3) // 4 * 4 :]
        return ""

    def symbols(self) -> Symbols:
        symbols = Symbols(set(), set())
        if _SYMTAB not in self._tags:
            return symbols
        texts = self._loaded_at(self._tag(_STRTAB), min(self._tag(_STRSZ), TEXTS))
        form = struct.Struct(self._order + ("IBBHQQ" if self._wide else "IIIBBH"))
        count = self._count(form.size)
        table = memoryview(self._loaded_at(self._tag(_SYMTAB), count * form.size))
        table = table[: len(table) // form.size * form.size]
        versions = self._versions(texts)
        chosen = self._chosen(len(table) // form.size) if versions else []
        room = min(TEXTS, 4 * len(texts) + 64 * count)  # the names of few symbols share their end
        for number, entry in enumerate(form.iter_unpack(table)):
            if self._wide:
                place, info, other, section, _, _ = entry
            else:
                place, _, _, info, other, section = entry
            binding = info >> 4
            # Global, weak and unique ones; neither sections nor files; neither internal nor hidden ones.
            if not place or binding not in (1, 2, 10) or info & 15 in (3, 4) or other & 3 in (1, 2):
                continue
            name = texts[place : texts.index(b"\0", place)]
            version = versions.get(chosen[number] & 0x7FFF) if chosen else None
            full = name + b"@" + version if version else name
            room -= len(full)
            if len(name) > NAME or room < 0:
                raise ValueError("names that are too long")
            if section == _ABSOLUTE and name == version:  # it stands for the version itself
                continue
            if section:
                symbols.exports.add(name)
                symbols.exports.add(full)
            elif binding != 2:
                symbols.uses.add(full)
        return symbols

    def _count(self, size: int) -> int:
        """The number of symbols, of which each takes `size` bytes."""
        if _HASH in self._tags:
            count: int = struct.unpack(self._order + "II", self._loaded_at(self._tag(_HASH), 8))[1]
        else:
            count = (self._hashed() if _GNU_HASH in self._tags else 0) or self._room() // size
        if count > SYMBOLS:
            raise ValueError("too many symbols")
        return count

    def _hashed(self) -> int:
        """The number of symbols by GNU's hash table, where those that are exported come last; 0 if there are none of these."""
        place, word = self._tag(_GNU_HASH), struct.Struct(self._order + "I")
        buckets, first, bloom, _ = struct.unpack(self._order + "IIII", self._loaded_at(place, 16))
        if max(buckets, bloom) > SYMBOLS:
            raise ValueError("too large a hash table")
        place += 16 + bloom * (8 if self._wide else 4)
        last: int = max((number for (number,) in word.iter_unpack(self._loaded_at(place, buckets * 4))), default=0)
        if last < first:
            return 0
        place += (buckets + last - first) * 4
        chain = self._loaded_at(place, SYMBOLS * 4)
        for (value,) in word.iter_unpack(chain[: len(chain) // 4 * 4]):
            last += 1
            if value & 1:
                return last
        raise ValueError("a hash table without an end")

    def _room(self) -> int:
        """The bytes between the symbols and the next table."""
        start = self._tag(_SYMTAB)
        return (
            min((place for tag in _TABLES for place in self._tags.get(tag, []) if place > start), default=start) - start
        )

    def _chosen(self, count: int) -> list[int]:
        table = self._loaded_at(self._tag(_VERSYM), count * 2)
        return [number for (number,) in struct.iter_unpack(self._order + "H", table[: count * 2])]

    def _versions(self, texts: bytes) -> dict[int, bytes]:
        """The versions that the file defines or expects, by number."""
        versions: dict[int, bytes] = {}
        if _VERSYM not in self._tags:
            return versions
        for table, count, form in ((_VERDEF, _VERDEFNUM, "HHHHIII"), (_VERNEED, _VERNEEDNUM, "HHIII")):
            if table not in self._tags:
                continue
            place = self._tag(table)
            for _ in range(self._tag(count)):
                entry = self._unpacked(form, place)
                if table == _VERDEF:
                    _put(versions, entry[2], self._unpacked("II", place + entry[5])[0], texts)
                else:
                    self._expected(place + entry[3], entry[1], texts, versions)
                if not entry[-1]:
                    break
                place += entry[-1]
        return versions

    def _unpacked(self, form: str, address: int) -> tuple[int, ...]:
        self._versions_left -= 1
        if self._versions_left < 0:
            raise ValueError("too many versions")
        return struct.unpack(self._order + form, self._loaded_at(address, struct.calcsize(form)))

    def _expected(self, place: int, count: int, texts: bytes, versions: dict[int, bytes]) -> None:
        """Adds the versions that the file expects of one library."""
        for _ in range(count):
            _, _, number, name, more = self._unpacked("IHHII", place)
            _put(versions, number, name, texts)
            if not more:
                return
            place += more


def _put(versions: dict[int, bytes], number: int, place: int, texts: bytes) -> None:
    number &= 0x7FFF
    if number > 1:  # 0 is of the file alone, and 1 has no version: its name is the library's
        versions[number] = texts[place : texts.index(b"\0", place)]
        if len(versions[number]) > VERSION:
            raise ValueError("a version that is too long")
