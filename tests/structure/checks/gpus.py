#!/usr/bin/env python3
"""The GPU architectures that a framework's libraries were built for are those that the labels promise; and the variable by
which NVIDIA's runtime refuses an old driver is there where CUDA is, and nowhere else.

gpus.py torch | tensorflow | onnxruntime | driver
"""

from __future__ import annotations

import mmap
import os
import re
import struct
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path


def of_torch() -> list[str]:
    """What PyTorch was built for, as its library has it: torch.cuda.get_arch_list() of older releases says nothing without
    a GPU."""
    spec = find_spec("torch")
    assert spec and spec.submodule_search_locations, "torch is not there"
    library = Path(spec.submodule_search_locations[0], "lib/libtorch_python.so").read_bytes()
    targets = {match[1].decode() for match in re.finditer(rb"\0((?:sm_[0-9]+[af]?)(?: sm_[0-9]+[af]?)*) ?\0", library)}
    assert len(targets) < 2, targets
    return " ".join(targets).split()


def of_tensorflow() -> list[str]:
    """What TensorFlow was built for."""
    return list(import_module("tensorflow").sysconfig.get_build_info().get("cuda_compute_capabilities", []))


def of_onnxruntime() -> list[str]:
    """What ONNX Runtime's library for CUDA was built for, as its kernels have it: nothing else says so. Kernels for one architecture
    alone do not count, such as those of Hopper's own instructions; an architecture does if most of the others have it."""
    spec = find_spec("onnxruntime")
    assert spec and spec.submodule_search_locations, "onnxruntime is not there"
    library = Path(spec.submodule_search_locations[0], "capi/libonnxruntime_providers_cuda.so")
    if not library.exists():
        return []
    with library.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
        several = [kinds for kinds in compiled(content) if len(kinds) > 1]
    counts = Counter(kind for kinds in several for kind in kinds)
    return [name for _, _, name in sorted(kind for kind, times in counts.items() if times * 2 > len(several))]


MAGIC = struct.pack("<IH", 0xBA55ED50, 1)
"""The beginning of what nvcc compiled from one source: a header, and the same for each architecture, as PTX or machine code."""

PTX, CODE = 1, 2

ARCHITECTURE_ALONE = 1 << 20
"""The flag of instructions that no later GPU has: sm_90a."""


def compiled(content: mmap.mmap) -> Iterator[set[tuple[int, int, str]]]:
    """The kinds of code in a library, for each source that nvcc compiled: whether it is PTX, the architecture, its name."""
    at = content.find(MAGIC)
    while at >= 0:
        size, whole = struct.unpack_from("<HQ", content, at + 6)
        place, end, kinds = at + size, at + size + whole, set()
        while place < end:
            kind, header, length, number, flags = struct.unpack_from("<H2xIQ12xI8xQ", content, place)
            assert kind in (PTX, CODE) and header, f"unknown code at {place}"
            name = f"{'sm' if kind == CODE else 'compute'}_{number}{'a' if flags & ARCHITECTURE_ALONE else ''}"
            kinds.add((kind == PTX, number, name))
            place += header + length
        yield kinds
        at = content.find(MAGIC, end)


def wrong(what: str, present: object, promised: object) -> None:
    """Ends with an error unless the two are the same."""
    if present != promised:
        sys.exit(f"{what}: {present}, expected {promised}")


if __name__ == "__main__":
    (what,) = sys.argv[1:]
    if what == "driver":
        cuda = os.environ.get("EXPECT_CUDA")
        wrong("NVIDIA_REQUIRE_CUDA", os.environ.get("NVIDIA_REQUIRE_CUDA"), cuda and f"cuda>={cuda.split('.')[0]}.0")
    else:
        command = ["dpkg", "--print-architecture"]
        architecture = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout.strip().upper()
        promised = os.environ.get(f"EXPECT_GPU_{what.upper()}_{architecture}", "")
        of = {"torch": of_torch, "tensorflow": of_tensorflow, "onnxruntime": of_onnxruntime}[what]
        wrong(what, of(), promised.split(",") if promised else [])
        print(promised or "for the CPU")
