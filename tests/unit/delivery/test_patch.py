"""Differences between layers: what they make, what they cost, and what a stranger's are refused for."""

from __future__ import annotations

import io
import json
import tarfile
from random import Random
from typing import Any

import pytest

from rosml.base.archives import zstd
from rosml.delivery import apply_patch, make_patch

Files = dict[str, bytes]


def noise(size: int, name: str = "") -> bytes:
    """Bytes that no compression makes smaller; the same ones for a name."""
    return Random(f"{size}{name}").randbytes(size)


def layer(files: Files, mtime: int = 0, form: int = tarfile.PAX_FORMAT) -> bytes:
    """An uncompressed layer."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w", format=form) as archive:
        for name, data in files.items():
            entry = tarfile.TarInfo(name)
            entry.size, entry.mtime = len(data), mtime
            if not data:
                entry.type, entry.linkname = tarfile.SYMTYPE, "elsewhere"
            archive.addfile(entry, io.BytesIO(data))
    return out.getvalue()


def patch_of(older: bytes, new: bytes) -> bytes:
    return b"".join(make_patch.make(io.BytesIO(older), io.BytesIO(new)))


def applied(patch_bytes: bytes, older: bytes) -> bytes:
    """What a patch makes. It arrives in small pieces."""
    blocks = (patch_bytes[at : at + 7] for at in range(0, len(patch_bytes), 7))
    return b"".join(apply_patch.Reader(blocks, len(older)).apply(io.BytesIO(older)))


BIG, SMALL = noise(50_000), noise(900, "small")
OLDER = {"usr/lib/libx.so.1.2": BIG, "etc/x": SMALL, "usr/y": noise(20_000, "y"), "usr/link": b""}
MOVED = BIG[:20_000] + b"inserted" + BIG[20_000:]

CHANGES: dict[str, tuple[bytes, int]] = {
    "nothing": (layer(OLDER), 200),
    "other headers": (layer(OLDER, form=tarfile.GNU_FORMAT), 400),
    "a changed file": (layer(OLDER | {"usr/lib/libx.so.1.2": MOVED}), 600),
    "another version of it": (layer({"usr/lib/libx.so.1.10.7": MOVED, "etc/x": SMALL, "usr/y": OLDER["usr/y"]}), 600),
    "another name of it": (layer({"opt/elsewhere": BIG, "etc/x": SMALL}), 600),
    "a new file": (layer(OLDER | {"usr/z": noise(3000, "z")}), 3600),
    "a small file that moved": (layer({"a": SMALL, "b": BIG, "c": SMALL}), 2000),
    "a longer name": (layer(OLDER | {"long/" * 60: SMALL}), 1800),
    "zeros at the end": (layer(OLDER) + bytes(50_000), 400),
    "all": (layer({"a": noise(40_000, "a")}), 42_000),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_patch_makes_the_new_layer_and_costs_what_changed(change: str) -> None:
    older, (new, most) = layer(OLDER), CHANGES[change]
    patch_bytes = patch_of(older, new)
    assert applied(patch_bytes, older) == new
    assert len(patch_bytes) < most


@pytest.mark.parametrize("size", [100, 190_000, 205_000])
def test_a_large_file_is_made_in_steps(monkeypatch: pytest.MonkeyPatch, size: int) -> None:
    """Each with the bytes of the older file that are at about the same place."""
    monkeypatch.setattr(apply_patch, "FRESH", 30_000)
    monkeypatch.setattr(apply_patch, "NEAR", 60_000)
    monkeypatch.setattr(make_patch, "_MARGIN", 10_000)
    before = noise(200_000)
    after = (before[:100_000] + noise(5000, "in the middle") + before[100_000:])[:size]
    older, new = layer({"a": before, "b": SMALL}), layer({"a": after, "b": SMALL, "c": noise(31_000, "c")})
    patch_bytes = patch_of(older, new)
    assert applied(patch_bytes, older) == new
    plan = apply_patch.Reader([patch_bytes], len(older)).plan
    assert max(step.fresh for step in plan.steps) <= 30_000
    assert max(step.prefix for step in plan.steps) <= 60_000
    assert len(patch_bytes) < 31_000 + 5000 + 1500


@pytest.mark.parametrize("data", [b"", b"x" * 3000, bytes(1024), layer(OLDER)[:-60_000], b"x" + layer(OLDER)])
def test_what_is_no_layer_has_no_patch(data: bytes) -> None:
    with pytest.raises(ValueError, match="a layer"):
        patch_of(layer(OLDER), data)
    with pytest.raises(ValueError, match="a layer"):
        patch_of(data, layer(OLDER))


# ---- A stranger's patch ----------------------------------------------------------------------------------------------

OLDER_BYTES = bytes(range(256)) * 40
"""The old layer."""


def frame(data: bytes, near: bytes = b"") -> bytes:
    return zstd.compress(data, zstd_dict=zstd.ZstdDict(near, is_raw=True).as_prefix if near else None)


def planned(size: Any, *steps: Any, frames: bytes = b"", **more: Any) -> bytes:
    return frame(json.dumps({"size": size, "steps": steps, **more}).encode()) + frames


def step(*parts: list[Any], near: Any = ()) -> dict[str, Any]:
    return {"near": near, "parts": parts}


ENDLESS = zstd.ZstdCompressor(options={zstd.CompressionParameter.content_size_flag: 0})

HOSTILE: dict[str, tuple[bytes, str]] = {
    "nothing": (b"", "incomplete|invalid|unknown|frame|information"),
    "a large plan": (frame(b" " * (9 << 20)), "9437184 bytes"),
    "a plan without its size": (ENDLESS.compress(b"{}") + ENDLESS.flush(), "None bytes"),
    "another key": (planned(3, step([0, 3]), path="/etc/passwd"), "path"),
    "a name for a range": (planned(3, step(["/etc/passwd", 3])), "parts"),
    "before the old layer": (planned(3, step([-1, 3])), "parts"),
    "after the old layer": (planned(3, step([len(OLDER_BYTES) - 2, 3])), "more than the old layer"),
    "a prefix after it": (planned(3, step([3], near=[[len(OLDER_BYTES), 9]])), "more than the old layer"),
    "a text as a number": (planned(3, step(["0", "3"])), "parts"),
    "more than it says": (planned(3, step([0, 4])), "another size"),
    "a layer of terabytes": (planned(1 << 40, step([0, 3])), "size"),
    "a frame of gigabytes": (planned(1 << 30, step([1 << 30])), "a step is too large"),
    "a short prefix": (planned(3, step([3], near=[[0, 7]]), frames=frame(b"abc")), "a step is too large"),
    "no frame": (planned(3, step([3])), "frame|information|early"),
    "a larger frame": (planned(3, step([3]), frames=frame(b"abcd")), "has 4 bytes, and at most 3"),
    "a smaller frame": (planned(3, step([3]), frames=frame(b"ab")), "has 2 bytes, and not 3"),
    "a frame that lies": (
        planned(3, step([3]), frames=frame(b"abcd").replace(b"\x04", b"\x03", 1)),
        "corrupt|more than the 3 bytes",
    ),
    "a cut frame": (planned(900, step([900]), frames=frame(noise(900))[:-9]), "too early"),
    "another frame": (planned(3, step([3]), frames=frame(b"abc") + frame(b"def")), "more than its plan"),
    "a byte more": (planned(3, step([0, 3]), frames=b"x"), "more than its plan"),
}


@pytest.mark.parametrize("case", HOSTILE)
def test_a_strangers_patch_is_refused(case: str) -> None:
    data, message = HOSTILE[case]
    with pytest.raises(ValueError, match=message):
        applied(data, OLDER_BYTES)


def test_prefixes_of_many_gigabytes_are_refused() -> None:
    data = planned(600, *(step([1], near=[[0, apply_patch.NEAR]]) for _ in range(600)))
    with pytest.raises(ValueError, match="too much of the old layer"):
        apply_patch.Reader([data], 1 << 30)


def test_a_patch_that_somebody_else_wrote_is_applied() -> None:
    near = OLDER_BYTES[5:15] + OLDER_BYTES[2:12]
    parts = [[3], [256, 256], [4]], [[0, 1]]
    frames = frame(b"abcdefg", near)
    data = planned(264, step(*parts[0], near=[[5, 10], [2, 10]]), step(*parts[1]), frames=frames)
    assert applied(data, OLDER_BYTES) == b"abc" + OLDER_BYTES[:256] + b"defg" + OLDER_BYTES[:1]
