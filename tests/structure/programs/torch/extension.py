#!/usr/bin/env python3
"""What PyTorch builds is built with the distribution's setuptools, which ROS's tools need, whatever release of setuptools
PyTorch asks for: a function by torch.compile, and an extension by a setup.py.

PyTorch builds for the GPU where it finds a toolkit: it finds none until a compiler is there, and says nothing of it. An
extension that calls CUDA, and has no kernels, is built with the folder that docs/cpp.md names."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

SETUP = """
from setuptools import setup
from torch.utils.cpp_extension import BuildExtension, {kind}
setup(name="answer", ext_modules=[{kind}("answer", ["answer.cpp"])], cmdclass={{"build_ext": BuildExtension}})
"""
CUDA_HOME = "/usr/local/lib/rosml/cuda-home"
# Without PyTorch's own headers, which take a minute to read.
SOURCE = """
#include <Python.h>
#ifdef CALLS_CUDA
#include <cuda_runtime_api.h>
#endif
static PyModuleDef module = {PyModuleDef_HEAD_INIT, "answer", nullptr, -1, nullptr};
PyMODINIT_FUNC PyInit_answer() {
  PyObject* made = PyModule_Create(&module);
  int answer = 42;
#ifdef CALLS_CUDA
  if (cudaRuntimeGetVersion(&answer) == cudaSuccess) answer = 42 + (answer != CUDART_VERSION);
#endif
  PyModule_AddIntConstant(made, "answer", answer);
  return made;
}
"""


def found_toolkit(path: str) -> str:
    """The CUDA_HOME that PyTorch finds with programs of a path before its own, and what it says about that."""
    asked = "from torch.utils.cpp_extension import CUDA_HOME; print(CUDA_HOME)"
    env = {**os.environ, "PATH": f"{path}:{os.environ['PATH']}"}
    done = subprocess.run(
        [sys.executable, "-c", asked], env=env, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    return done.stdout


def answer(folder: str, kind: str, **env: str) -> None:
    """Builds an extension of a kind, and asks it."""
    Path(folder, "setup.py").write_text(SETUP.format(kind=kind))
    Path(folder, "answer.cpp").write_text(SOURCE)
    build = [sys.executable, "setup.py", "-q", "build_ext", "--inplace", "--force"]
    subprocess.run(build, cwd=folder, check=True, env={**os.environ, **env})
    asked = "import torch, answer; print(answer.answer)"
    said = subprocess.run([sys.executable, "-c", asked], cwd=folder, stdout=subprocess.PIPE, text=True, check=True)
    assert said.stdout == "42\n", said.stdout


def main() -> None:
    import setuptools

    with tempfile.TemporaryDirectory() as folder:
        said = found_toolkit(folder)
        toolkit = "/usr/local/cuda"  # of a part, perhaps
        assert said.endswith(f"{toolkit}\n") if os.path.exists(f"{toolkit}/bin/nvcc") else said == "None\n", said
        compiler = Path(folder, "bin/nvcc")
        compiler.parent.mkdir()
        compiler.touch(mode=0o755)
        said = found_toolkit(str(compiler.parent))
        assert said.endswith(f"{folder}\n"), said

    assert not str(setuptools.__file__).startswith("/usr/local"), setuptools.__file__
    with tempfile.TemporaryDirectory() as folder:
        os.environ["TORCHINDUCTOR_CACHE_DIR"] = folder
        import torch

        compiled = torch.compile(lambda x: torch.sin(x) ** 2 + torch.cos(x) ** 2)
        assert torch.allclose(compiled(torch.rand(1000)), torch.ones(1000))
        answer(folder, "CppExtension")
        if torch.version.cuda:
            answer(folder, "CUDAExtension", CUDA_HOME=CUDA_HOME, CFLAGS="-DCALLS_CUDA")
    print("setuptools", setuptools.__version__)


if __name__ == "__main__":
    main()
