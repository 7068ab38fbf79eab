"""Differences between layers: what makes a new layer of an old one, for a machine that has the old one. `make_patch.py` finds them.

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
from collections.abc import Iterable, Iterator
from typing import IO, Annotated

from pydantic import ConfigDict, Field, ValidationError

from rosml.base import archives, untrusted
from rosml.base.problems import first_of
from rosml.base.shapes import Shape

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

WINDOW = 27
"""The window of a frame as a power of two: FRESH and NEAR fit into it."""

_BLOCK = 1 << 20

_Offset = Annotated[int, Field(ge=0, lt=LARGEST, strict=True)]
_Length = Annotated[int, Field(gt=0, le=LARGEST, strict=True)]
Range = tuple[_Offset, _Length]
Part = tuple[_Length] | Range
"""A length of the step's frame, or a range of the old layer."""


class _Shape(Shape):
    model_config = ConfigDict(extra="forbid")


class Step(_Shape):
    """`near`: the ranges of the old layer that are the frame's prefix."""

    near: list[Range]
    parts: list[Part]

    @property
    def fresh(self) -> int:
        """The size of the frame, unpacked."""
        return sum(part[0] for part in self.parts if len(part) == 1)

    @property
    def prefix(self) -> int:
        return sum(length for _, length in self.near)


class Plan(_Shape):
    """What a patch does. `size` is that of the new layer, in bytes without compression."""

    size: _Length
    steps: list[Step]


class Reader:
    """A patch that somebody gave us, for an older layer of `size` bytes. Raises a ValueError if it is damaged or reads what that does not have."""

    def __init__(self, blocks: Iterable[bytes], older: int) -> None:
        self._frames = archives.Frames(blocks, WINDOW)
        try:
            self.plan = Plan.model_validate(untrusted.json_value(self._frames.next(PLAN_BYTES), PLAN_BYTES))
        except ValidationError as error:
            raise ValueError(first_of(error)) from None
        _require_fitting(self.plan, older)

    def apply(self, older: IO[bytes]) -> Iterator[bytes]:
        """The new layer, in pieces, of a file of the older layer without compression. It can be asked for once."""
        for step in self.plan.steps:
            fresh, at = b"", 0
            if step.fresh:
                fresh = self._frames.next(step.fresh, joined(older, step.near))
                if len(fresh) != step.fresh:
                    raise ValueError(f"a frame has {len(fresh)} bytes, and not {step.fresh:,}")
            for part in step.parts:
                if len(part) == 2:
                    yield from blocks_of(older, *part)
                else:
                    yield fresh[at : at + part[0]]
                    at += part[0]
        if not self._frames.end():
            raise ValueError("it has more than its plan says")


def _require_fitting(plan: Plan, older_size: int) -> None:
    for step in plan.steps:
        if any(sum(place) > older_size for place in (*step.near, *step.parts) if len(place) == 2):
            raise ValueError("it reads more than the old layer has")
        if step.fresh > FRESH or (step.near and not 8 <= step.prefix <= NEAR):
            raise ValueError("a step is too large")
    if sum(part[-1] for step in plan.steps for part in step.parts) != plan.size:
        raise ValueError("its parts have another size than it says")
    if sum(step.prefix for step in plan.steps) > LARGEST:
        raise ValueError("it reads too much of the old layer")


def unpack(packed: IO[bytes], diff_id: str, out: IO[bytes]) -> None:
    """Writes a layer, compressed or not, without its compression. Raises a ValueError if it is damaged, too large, or has another digest."""
    state, size = hashlib.new(diff_id.partition(":")[0]), 0
    for block in archives.unpacked(blocks_of(packed, 0, packed.seek(0, 2))):
        size += len(block)
        if size > LARGEST:
            raise ValueError(f"it has more than {LARGEST:,} bytes")
        state.update(block)
        out.write(block)
    if state.hexdigest() != diff_id.partition(":")[2]:
        raise ValueError(f"unpacked, it is not {diff_id}")
    out.flush()


def joined(file: IO[bytes], ranges: Iterable[Range]) -> bytearray:
    value = bytearray()
    for offset, length in ranges:
        for block in blocks_of(file, offset, length):
            value += block
    return value


def blocks_of(file: IO[bytes], offset: int, length: int) -> Iterator[bytes]:
    file.seek(offset)
    while length:
        block = file.read(min(_BLOCK, length))
        if not block:
            raise ValueError("the old layer is too short")
        length -= len(block)
        yield block
