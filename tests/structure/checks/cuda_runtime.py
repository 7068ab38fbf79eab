#!/usr/bin/env python3
"""The loader finds the CUDA runtime that the tag promises, without ldconfig or LD_LIBRARY_PATH."""

import ctypes
import os
import subprocess

assert "LD_LIBRARY_PATH" not in os.environ
assert "libcudart" not in subprocess.run(["ldconfig", "-p"], capture_output=True, text=True, check=True).stdout

major, minor = (int(number) for number in os.environ["EXPECT_CUDA"].split(".")[:2])
version = ctypes.c_int()
assert ctypes.CDLL(f"libcudart.so.{major}").cudaRuntimeGetVersion(ctypes.byref(version)) == 0
assert version.value == major * 1000 + minor * 10, f"CUDA runtime {version.value}, expected {major}.{minor}"
