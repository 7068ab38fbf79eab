#!/usr/bin/env python3
"""The loader finds the CUDA runtime, cuDNN and NCCL that the tag promises, without ldconfig or LD_LIBRARY_PATH."""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
from typing import Any

assert "LD_LIBRARY_PATH" not in os.environ
assert "libcudart" not in subprocess.run(["ldconfig", "-p"], capture_output=True, text=True, check=True).stdout


def promised(name: str) -> list[int]:
    """The numbers of a version, such as 12.8.90."""
    return [int(number) for number in os.environ["EXPECT_" + name].split(".")]


def written(function: Any) -> int:
    """What a function writes into its argument."""
    version = ctypes.c_int()
    assert function(ctypes.byref(version)) == 0
    return int(version.value)


cuda, cudnn, nccl = map(promised, ("CUDA", "CUDNN", "NCCL"))
cudnn_version = ctypes.CDLL(f"libcudnn.so.{cudnn[0]}").cudnnGetVersion
cudnn_version.restype = ctypes.c_size_t
libraries = {
    "CUDA runtime": (
        written(ctypes.CDLL(f"libcudart.so.{cuda[0]}").cudaRuntimeGetVersion),
        cuda[0] * 1000 + cuda[1] * 10,
    ),
    "cuDNN": (cudnn_version(), cudnn[0] * 10000 + cudnn[1] * 100 + cudnn[2]),
    "NCCL": (written(ctypes.CDLL(f"libnccl.so.{nccl[0]}").ncclGetVersion), nccl[0] * 10000 + nccl[1] * 100 + nccl[2]),
}
wrong = [
    f"{name} {version}, expected {expected}" for name, (version, expected) in libraries.items() if version != expected
]
sys.exit("\n".join(wrong) or 0)
