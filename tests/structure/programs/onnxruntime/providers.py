#!/usr/bin/env python3
"""ONNX Runtime's libraries: Python and C++ have the same; the provider for CUDA is there where the image has CUDA, and finds CUDA's
libraries.

The provider may lack the driver alone, which comes from the machine: libcuda.so.1, and functions such as cuInit.
"""

from __future__ import annotations

import ctypes
import os
import re
import subprocess
import sys
import sysconfig
from pathlib import Path

import onnxruntime as ort

cuda = "EXPECT_CUDA" in os.environ
assert ("CUDAExecutionProvider" in ort.get_available_providers()) == cuda, ort.get_available_providers()
capi = Path(ort.__file__).parent / "capi"
system = Path("/usr/lib", sysconfig.get_config_var("MULTIARCH"))
for library in capi.glob("libonnxruntime*"):
    assert library.resolve() == (system / library.name).resolve(), library
wrong = []
for folder in (capi, system) if cuda else ():
    done = subprocess.run(
        ["ldd", "-r", folder / "libonnxruntime_providers_cuda.so"],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    wrong += [line.strip() for line in done.stdout.splitlines() if re.search("not found|undefined", line)]
# Provider_GetHost is in a library of ONNX Runtime's that the process has loaded before.
expected = re.compile(r"libcuda\.so\.1 => not found|undefined symbol: (cu[A-Z]\w*|Provider_GetHost)\b.*")
if wrong := [line for line in wrong if not expected.fullmatch(line)]:
    sys.exit("\n".join(wrong))
# What it loads when a model first needs it.
for name in ("cublas", "cublasLt", "cudart", "cudnn", "cufft", "curand", "nvrtc") if cuda else ():
    ctypes.CDLL(f"lib{name}.so")
print(*ort.get_available_providers())
