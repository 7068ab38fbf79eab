#!/usr/bin/env python3
"""PyTorch finds the toolkit without a variable, and builds an extension with a kernel by a setup.py. Triton compiles a kernel to
what a GPU runs. Nothing of that needs a GPU."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SETUP = """
from setuptools import setup
from torch.utils.cpp_extension import CUDA_HOME, BuildExtension, CUDAExtension
assert CUDA_HOME == "/usr/local/cuda", CUDA_HOME
setup(name="answer", ext_modules=[CUDAExtension("answer", ["operator.cu"])], cmdclass={"build_ext": BuildExtension})
"""
# Triton reads the source of the kernel from a file.
KERNEL = """
import triton
import triton.language as tl
from triton.backends.compiler import GPUTarget
from triton.compiler import ASTSource

@triton.jit
def twice(numbers, result, count, BLOCK: tl.constexpr):
    at = tl.program_id(0) * BLOCK + tl.arange(0, BLOCK)
    tl.store(result + at, 2 * tl.load(numbers + at, at < count), at < count)

kinds = {"numbers": "*fp32", "result": "*fp32", "count": "i32", "BLOCK": "constexpr"}
for number in (80, 90):
    compiled = triton.compile(ASTSource(twice, kinds, {"BLOCK": 128}), target=GPUTarget("cuda", number, 32))
    assert compiled.asm["cubin"].startswith(b"\\x7fELF")
    print("Triton", triton.__version__, "for", number)
"""


def main() -> None:
    if not os.environ.get("EXPECT_TORCH"):
        print("an image without PyTorch")
        return
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "setup.py").write_text(SETUP)
        Path(folder, "kernel.py").write_text(KERNEL)
        Path(folder, "operator.cu").write_bytes((HERE / "operator.cu").read_bytes())
        env = {name: value for name, value in os.environ.items() if name not in ("CUDA_HOME", "CUDA_PATH")}
        env.update({"TORCH_CUDA_ARCH_LIST": "9.0", "TRITON_CACHE_DIR": f"{folder}/cache"})
        build = [sys.executable, "setup.py", "-q", "build_ext", "--inplace"]
        show = [sys.executable, "-c", "import torch, answer; print('the answer is', answer.answer)"]
        for command in (build, show, [sys.executable, "kernel.py"]):
            subprocess.run(command, cwd=folder, check=True, env=env)


if __name__ == "__main__":
    main()
