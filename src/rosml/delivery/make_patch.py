"""Finds the differences between two layers, and writes them as `apply_patch.py` reads them."""

from __future__ import annotations

import hashlib
import re
import tarfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import IO

from rosml.base import archives
from rosml.base.archives import zstd
from rosml.delivery import apply_patch
from rosml.delivery.apply_patch import Part, Plan, Range, Step
from rosml.registry import oci

_LEVEL = 9
_MARGIN = 64 << 10
"""How much more of the old file than twice the new one's size is the prefix."""


@dataclass(frozen=True)
class _Entry:
    """An entry of a tar file: where its header, its content and the next entry begin, and hashes of header and content."""

    name: str
    start: int
    content: int
    end: int
    head: bytes
    digest: bytes


@dataclass
class _Piece:
    """Bytes of the new layer: equal to those of the older one at `older`; or changed, with ranges that they may be like."""

    length: int
    older: int | None = None
    near: list[Range] = field(default_factory=list)


def make(older: IO[bytes], new: IO[bytes]) -> Iterator[bytes]:
    """The patch that makes a new layer of an older one, both without compression, in pieces. The same layers give the same bytes."""
    steps = _steps(_joined(_pieces(_entries(older), _entries(new))))
    plan = oci.encoded(Plan(size=new.seek(0, 2), steps=steps).model_dump())
    if len(plan) > apply_patch.PLAN_BYTES or sum(step.prefix for step in steps) > apply_patch.LARGEST:
        raise ValueError("the layers differ in too many places")
    yield zstd.compress(plan, _LEVEL)
    offset = 0
    for step in steps:
        fresh = bytearray()
        for part in step.parts:
            if len(part) == 1:
                fresh += apply_patch.joined(new, [(offset, part[0])])
            offset += part[-1]
        if fresh:
            yield _frame(fresh, apply_patch.joined(older, step.near))


def _frame(fresh: bytearray, near: bytearray) -> bytes:
    names = zstd.CompressionParameter
    options: dict[int, int] = {names.compression_level: _LEVEL, names.content_size_flag: 1}
    if not near:
        return zstd.compress(fresh, options=options)
    window = min(apply_patch.WINDOW, max(17, (len(fresh) + len(near)).bit_length()))
    options |= {names.window_log: window, names.enable_long_distance_matching: 1}
    return zstd.compress(fresh, options=options, zstd_dict=zstd.ZstdDict(near, is_raw=True).as_prefix)


def _entries(file: IO[bytes]) -> list[_Entry]:
    """The entries of a tar file. Between them, they have all its bytes."""
    if not 0 < (size := file.seek(0, 2)) <= apply_patch.LARGEST:
        raise ValueError(f"a layer has {size:,} bytes")
    file.seek(0)
    places: list[tuple[str, int, int]] = []
    try:
        with tarfile.open(fileobj=file, mode="r:", tarinfo=archives.Entry) as archive:
            for entry in archive:
                places.append((entry.name, entry.offset, entry.offset_data))
                archive.members = []  # type: ignore[attr-defined] # tarfile would keep them all
    except (tarfile.TarError, EOFError, OverflowError) as error:
        raise ValueError(f"a layer is no tar file, or is damaged: {error}") from None
    ends = [*(start for _, start, _ in places[1:]), size]
    if not places or places[0][1]:
        raise ValueError("a layer has no entries")
    entries = []
    for (name, start, content), end in zip(places, ends, strict=True):
        if not start < content <= end <= size:
            raise ValueError(f"a layer is damaged at {name[:100]!r}")
        hashes = _hash(file, start, content - start), _hash(file, content, end - content)
        entries.append(_Entry(name, start, content, end, *hashes))
    return entries


def _hash(file: IO[bytes], offset: int, length: int) -> bytes:
    state = hashlib.sha256()
    for block in apply_patch.blocks_of(file, offset, length):
        state.update(block)
    return state.digest()


_NUMBERS = re.compile(r"[0-9]+(?:\.[0-9]+)*")


def _kind(name: str) -> str:
    """What the names of a file in two versions have in common."""
    return _NUMBERS.sub("0", name)


def _pieces(older: list[_Entry], new: list[_Entry]) -> Iterator[_Piece]:
    """The new layer, each entry with what it is like in the older one."""
    by_name = {entry.name: entry for entry in older}
    by_content = {entry.digest: entry for entry in older}
    by_kind = {_kind(entry.name): entry for entry in older}
    for entry in new:
        like = by_name.get(entry.name) or by_kind.get(_kind(entry.name))
        if like and like.head == entry.head:
            yield _Piece(entry.content - entry.start, like.start)
        else:
            yield _Piece(entry.content - entry.start, near=[(like.start, like.content - like.start)] if like else [])
        size = entry.end - entry.content
        if not size:
            continue
        same = like if like and like.digest == entry.digest else by_content.get(entry.digest)
        if same:
            yield _Piece(size, same.content)
        else:
            yield from _changed(size, like)


def _changed(size: int, like: _Entry | None) -> Iterator[_Piece]:
    """The content of a file that changed. Of a large one, each piece has the range of the old file that is at the same place."""
    older_size = like.end - like.content if like else 0
    at = 0
    while at < size:
        length = min(apply_patch.FRESH, size - at)
        if not like or not older_size:
            yield _Piece(length)
        else:
            most = min(apply_patch.NEAR, older_size, 2 * length + _MARGIN)
            middle = (at + length // 2) * older_size // size
            start = max(0, min(middle - most // 2, older_size - most))
            yield _Piece(length, near=[(like.content + start, most)])
        at += length


def _joined(pieces: Iterable[_Piece]) -> Iterator[_Piece]:
    """The same with equal pieces in one, if they follow each other in both layers."""
    last: _Piece | None = None
    for piece in pieces:
        if last and last.older is not None and last.older + last.length == piece.older:
            last.length += piece.length
            continue
        if last:
            yield last
        last = piece
    if last:
        yield last


def _steps(pieces: Iterable[_Piece]) -> list[Step]:
    """The plan: as many pieces in a step as fit into it."""
    steps: list[Step] = []
    near: list[Range] = []
    parts: list[Part] = []
    fresh = prefix = 0
    for piece in pieces:
        if piece.older is not None:
            parts.append((piece.older, piece.length))
            continue
        added = sum(length for _, length in piece.near)
        if fresh + piece.length > apply_patch.FRESH or prefix + added > apply_patch.NEAR:
            steps.append(Step(near=_merged(near), parts=parts))
            near, parts, fresh, prefix = [], [], 0, 0
        near += piece.near
        fresh, prefix = fresh + piece.length, prefix + added
        if parts and len(parts[-1]) == 1:
            parts[-1] = (parts[-1][0] + piece.length,)
        else:
            parts.append((piece.length,))
    steps.append(Step(near=_merged(near), parts=parts))
    return steps


def _merged(ranges: Iterable[Range]) -> list[Range]:
    """The same bytes, each once."""
    merged: list[Range] = []
    for offset, length in sorted(ranges):
        if merged and offset <= sum(merged[-1]):
            start = merged[-1][0]
            merged[-1] = (start, max(sum(merged[-1]), offset + length) - start)
        elif length:
            merged.append((offset, length))
    return merged
