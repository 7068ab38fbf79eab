"""Differences between layers: what makes a new layer of an old one, for a machine that has the old one.

A patch is a plan, and then the bytes that the old layer lacks. Both layers count without their compression, as tar files. The plan is JSON in
a frame of zstd:

    {"size": 123, "steps": [{"near": [[OFFSET, LENGTH], …], "parts": [[LENGTH], [OFFSET, LENGTH], …]}, …]}

The parts of all steps, one after another, are the new layer, which has `size` bytes. A part [OFFSET, LENGTH] is a range of the old layer. A
part [LENGTH] is the next bytes of the step's frame. These frames follow the plan's, one for each step with such a part. Each is compressed
with the ranges `near` of the old layer before it, one after another, as a prefix (ZSTD_CCtx_refPrefix). So a changed file costs little more
than what changed in it. The memory for that depends on FRESH and NEAR, and not on the size of a layer.

Nothing else of a patch counts: no name, and no file but the old layer. Who applies one checks the new layer's digest.
"""

from __future__ import annotations

import hashlib
import re
import tarfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import IO, Annotated, Any

from pydantic import ConfigDict, Field, ValidationError

from rosml.base import archives, untrusted
from rosml.base.archives import zstd
from rosml.base.problems import first_of
from rosml.base.shapes import Shape
from rosml.registry import oci

MEDIA_TYPE = "application/vnd.rosml.layer-patch.v1+zstd"
"""Another format gets another number."""

LARGEST = 1 << 35
"""The largest layer, in bytes without compression."""

FRESH = 32 << 20
"""The most bytes of a step's frame, unpacked."""

NEAR = 64 << 20
"""The most bytes of the old layer that a step has as its prefix."""

PLAN_BYTES = 8 << 20
"""The largest plan, unpacked."""

_WINDOW = 27  # bits: FRESH and NEAR fit into it
_LEVEL = 9
_MARGIN = 64 << 10
"""How much more of the old file than twice the new one's size is the prefix."""

_BLOCK = 1 << 20

Range = tuple[int, int]
"""An offset and a length, in bytes."""


@dataclass(frozen=True)
class Step:
    """A step of a plan: ranges of the old layer that are the frame's prefix; and the parts of the new layer, each a length with an offset in the old layer, or None for bytes of the frame."""

    near: list[Range]
    parts: list[tuple[int | None, int]]

    @property
    def fresh(self) -> int:
        """The size of the frame, unpacked."""
        return sum(length for offset, length in self.parts if offset is None)


def unpack(packed: IO[bytes], diff_id: str, out: IO[bytes]) -> None:
    """Writes a layer, compressed or not, without its compression. Raises a ValueError if it is damaged, too large, or has another digest."""
    state, size = hashlib.new(diff_id.partition(":")[0]), 0
    for block in archives.unpacked(_range(packed, 0, packed.seek(0, 2))):
        size += len(block)
        if size > LARGEST:
            raise ValueError(f"it has more than {LARGEST:,} bytes")
        state.update(block)
        out.write(block)
    if state.hexdigest() != diff_id.partition(":")[2]:
        raise ValueError(f"unpacked, it is not {diff_id}")
    out.flush()


# ---- Making ----------------------------------------------------------------------------------------------------------


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
    plan_steps = [
        {"near": step.near, "parts": [part if part[0] is not None else part[1:] for part in step.parts]}
        for step in steps
    ]
    plan = oci.encoded({"size": new.seek(0, 2), "steps": plan_steps})
    if len(plan) > PLAN_BYTES or sum(length for step in steps for _, length in step.near) > LARGEST:
        raise ValueError("the layers differ in too many places")
    yield zstd.compress(plan, _LEVEL)
    offset = 0
    for step in steps:
        fresh = bytearray()
        for source, length in step.parts:
            if source is None:
                fresh += _bytes(new, [(offset, length)])
            offset += length
        if fresh:
            yield _frame(fresh, _bytes(older, step.near))


def _frame(fresh: bytearray, near: bytearray) -> bytes:
    names = zstd.CompressionParameter
    options: dict[int, int] = {names.compression_level: _LEVEL, names.content_size_flag: 1}
    if not near:
        return zstd.compress(fresh, options=options)
    window = min(_WINDOW, max(17, (len(fresh) + len(near)).bit_length()))
    options |= {names.window_log: window, names.enable_long_distance_matching: 1}
    return zstd.compress(fresh, options=options, zstd_dict=zstd.ZstdDict(near, is_raw=True).as_prefix)


def _entries(file: IO[bytes]) -> list[_Entry]:
    """The entries of a tar file. Between them, they have all its bytes."""
    if not 0 < (size := file.seek(0, 2)) <= LARGEST:
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
    for block in _range(file, offset, length):
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
        length = min(FRESH, size - at)
        if not like or not older_size:
            yield _Piece(length)
        else:
            most = min(NEAR, older_size, 2 * length + _MARGIN)
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
    parts: list[tuple[int | None, int]] = []
    fresh = prefix = 0
    for piece in pieces:
        added = sum(length for _, length in piece.near)
        if piece.older is None and (fresh + piece.length > FRESH or prefix + added > NEAR):
            steps.append(Step(_merged(near), parts))
            near, parts, fresh, prefix = [], [], 0, 0
        if piece.older is None:
            near += piece.near
            fresh, prefix = fresh + piece.length, prefix + added
        if piece.older is None and parts and parts[-1][0] is None:
            parts[-1] = (None, parts[-1][1] + piece.length)
        else:
            parts.append((piece.older, piece.length))
    steps.append(Step(_merged(near), parts))
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


# ---- Applying --------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Plan:
    """What a patch does. `size` is that of the new layer, in bytes without compression."""

    size: int
    steps: list[Step]


class Reader:
    """A patch that somebody gave us, for an older layer of `size` bytes. Raises a ValueError if it is damaged or reads what that does not have."""

    def __init__(self, blocks: Iterable[bytes], older: int) -> None:
        self._frames = archives.Frames(blocks, _WINDOW)
        self.plan = _plan(untrusted.json_value(self._frames.next(PLAN_BYTES), PLAN_BYTES), older)

    def apply(self, older: IO[bytes]) -> Iterator[bytes]:
        """The new layer, in pieces, of a file of the older layer without compression. It can be asked for once."""
        for step in self.plan.steps:
            fresh, at = b"", 0
            if step.fresh:
                fresh = self._frames.next(step.fresh, _bytes(older, step.near))
                if len(fresh) != step.fresh:
                    raise ValueError(f"a frame has {len(fresh)} bytes, and not {step.fresh:,}")
            for offset, length in step.parts:
                if offset is None:
                    yield fresh[at : at + length]
                    at += length
                else:
                    yield from _range(older, offset, length)
        if not self._frames.end():
            raise ValueError("it has more than its plan says")


def _bytes(file: IO[bytes], ranges: Iterable[Range]) -> bytearray:
    value = bytearray()
    for offset, length in ranges:
        for block in _range(file, offset, length):
            value += block
    return value


def _range(file: IO[bytes], offset: int, length: int) -> Iterator[bytes]:
    file.seek(offset)
    while length:
        block = file.read(min(_BLOCK, length))
        if not block:
            raise ValueError("the old layer is too short")
        length -= len(block)
        yield block


def _plan(value: Any, older_size: int) -> Plan:
    try:
        plan = _Plan.model_validate(value)
    except ValidationError as error:
        raise ValueError(first_of(error)) from None
    steps = []
    for entry in plan.steps:
        step = Step(entry.near, [part if len(part) == 2 else (None, *part) for part in entry.parts])
        ranges = [*step.near, *((offset, length) for offset, length in step.parts if offset is not None)]
        if any(offset + length > older_size for offset, length in ranges):
            raise ValueError("it reads more than the old layer has")
        if step.fresh > FRESH or (not 8 <= sum(length for _, length in step.near) <= NEAR and step.near):
            raise ValueError("a step is too large")
        steps.append(step)
    if sum(length for step in steps for _, length in step.parts) != plan.size:
        raise ValueError("its parts have another size than it says")
    if sum(length for step in steps for _, length in step.near) > LARGEST:
        raise ValueError("it reads too much of the old layer")
    return Plan(plan.size, steps)


class _Shape(Shape):
    model_config = ConfigDict(extra="forbid")


_Offset = Annotated[int, Field(ge=0, lt=LARGEST, strict=True)]
_Length = Annotated[int, Field(gt=0, le=LARGEST, strict=True)]


class _Step(_Shape):
    near: list[tuple[_Offset, _Length]]
    parts: list[tuple[_Length] | tuple[_Offset, _Length]]


class _Plan(_Shape):
    size: _Length
    steps: list[_Step]
