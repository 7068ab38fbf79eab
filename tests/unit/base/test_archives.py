"""Compressed files of others: each is unpacked with a limit, at one place."""

from __future__ import annotations

import ast
import gzip
import io
import resource
import time
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.base import archives
from rosml.base.archives import zstd

SOURCES = ROOT / "src/rosml"

UNPACKING = {
    "base/archives.py": {"decompressobj", "ZstdDecompressor", "ZipFile"},  # each function there has a limit
    # Of archives that may be compressed. Each reads at most what its own limit allows.
    "containerize/base_image/rosdep_index.py": {"tarfile.open"},
    "images/builds/apt_sources.py": {"tarfile.open"},
    "images/dossier/texts.py": {"tarfile.open"},
    # Of archives that are not compressed.
    "delivery/archive.py": {"tarfile.open"},
    "delivery/make_patch.py": {"tarfile.open"},
    "images/dossier/write.py": {"ZipFile"},  # it only writes
    "images/publish/revision.py": {"tarfile.open"},  # git's
    "machine/exported.py": {"tarfile.open"},
}
WORDS = {"decompressobj", "ZstdDecompressor", "ZstdFile", "ZipFile", "BZ2File", "LZMAFile", "unpack_archive"}


def unpacking(file: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            owner = node.func.value.id if isinstance(node.func.value, ast.Name) else ""
            if owner in ("tarfile", "gzip", "bz2", "lzma") and node.func.attr in ("open", "decompress"):
                yield f"{owner}.{node.func.attr}"
            elif node.func.attr in WORDS or (owner in ("zlib", "zstd") and node.func.attr == "decompress"):
                yield node.func.attr


def test_each_place_that_unpacks_has_a_limit() -> None:
    """A new one uses base/archives.py, or says here what limits it."""
    modules = {str(file.relative_to(SOURCES)): set(unpacking(file)) for file in SOURCES.rglob("*.py")}
    assert {module: calls for module, calls in modules.items() if calls} == UNPACKING


def assert_cheap_since(started: float) -> None:
    assert time.process_time() - started < 2
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss < (1 << 20), "kB"


def lying_frame(blocks: int) -> bytes:
    """A frame of zstd that says 8 MB and has as many times 128 kB: 4 bytes for each. Its window is small, so zstd itself counts nothing."""
    repeated = (1 << 1 | (128 << 10) << 3).to_bytes(3, "little") + b"x"
    return b"\x28\xb5\x2f\xfd\x80\x38" + (8 << 20).to_bytes(4, "little") + repeated * blocks


def test_a_frame_that_has_more_than_it_says() -> None:
    started = time.process_time()
    with pytest.raises(ValueError, match="more than the 8388608 bytes that it says"):
        archives.Frames([lying_frame(20_000)], window=27).next(8 << 20)
    assert_cheap_since(started)


@pytest.mark.parametrize("empty", [zstd.compress(b""), gzip.compress(b"")], ids=["zstd", "gzip"])
def test_many_parts_without_content(empty: bytes) -> None:
    started = time.process_time()
    with pytest.raises(ValueError, match="1000 parts without content"):
        list(archives.unpacked([empty * 400_000]))
    assert_cheap_since(started)


def test_frames_follow_each_other() -> None:
    """As pzstd and others write them: with content, there may be any number."""
    blocks = [zstd.compress(b"a") * 2000, zstd.compress(b"b", options={zstd.CompressionParameter.content_size_flag: 1})]
    assert b"".join(archives.unpacked(blocks)) == b"a" * 2000 + b"b"
    frames = archives.Frames([zstd.compress(b"one"), zstd.compress(b"two")], window=27)
    assert (frames.next(3), frames.next(3)) == (b"one", b"two") and frames.end()


def test_a_file_of_a_zip_archive_has_a_limit() -> None:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a/METADATA", bytes(50 << 20))
    assert len(packed.getvalue()) < 100_000
    with pytest.raises(ValueError, match="more than 1,000 bytes"):
        archives.file_of_zip(packed, r"[^/]+/METADATA", 1000)
