#!/usr/bin/env python3
"""What PyTorch builds is built with the distribution's setuptools, which ROS's tools need, whatever release of setuptools
PyTorch asks for: a function by torch.compile, and an extension by a setup.py.

PyTorch builds for the GPU where it finds a toolkit: it finds none until a compiler is there, and says nothing of it. An
extension that calls CUDA, and has no kernels, is built with the folder that docs/cpp.md names."""

from __future__ import annotations

import importlib
import os
import runpy
import sys
import tempfile
import traceback
from collections.abc import Callable
from functools import partial
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


def forked(work: Callable[[], object]) -> Callable[[], str]:
    """Begins work in a process of its own that has imported PyTorch already, which takes seconds.

    Returns:
        Waits for it: the last line of what it said.
    """
    ours, theirs = os.pipe()
    child = os.fork()
    if not child:
        try:
            os.dup2(theirs, 1)
            work()
            sys.stdout.flush()
            os._exit(0)
        except BaseException:
            traceback.print_exc()
            os._exit(1)
    os.close(theirs)

    def ended() -> str:
        with open(ours) as stream:
            output = stream.read()
        _, status = os.waitpid(child, 0)
        if status:
            sys.exit(f"the test ended with {status}: {output}")
        return output.splitlines()[-1]

    return ended


def find_toolkit(path: str) -> None:
    """Prints the CUDA_HOME that PyTorch finds with programs of a path before its own."""
    os.environ["PATH"] = f"{path}:{os.environ['PATH']}"
    from torch.utils.cpp_extension import CUDA_HOME

    print(CUDA_HOME)


def build(folder: str, kind: str, **env: str) -> None:
    """Builds an extension of a kind as its setup.py does, imports it, and asks it."""
    Path(folder, "setup.py").write_text(SETUP.format(kind=kind))
    Path(folder, "answer.cpp").write_text(SOURCE)
    os.chdir(folder)
    os.environ.update(env)
    sys.argv = ["setup.py", "-q", "build_ext", "--inplace", "--force"]
    runpy.run_path("setup.py", run_name="__main__")
    sys.path.insert(0, folder)
    print(importlib.import_module("answer").answer)


def main() -> None:
    import setuptools
    import torch

    assert not str(setuptools.__file__).startswith("/usr/local"), setuptools.__file__
    with tempfile.TemporaryDirectory() as scratch:
        folders = [os.path.join(scratch, name) for name in ("bin", "cpu", "cuda", "none")]
        for folder in folders:
            os.mkdir(folder)
        with_compiler, cpu, cuda, none = folders
        Path(with_compiler, "nvcc").touch(mode=0o755)
        toolkits = [forked(partial(find_toolkit, path)) for path in (none, with_compiler)]
        built = [forked(partial(build, cpu, "CppExtension"))]
        if torch.version.cuda:
            built.append(forked(partial(build, cuda, "CUDAExtension", CUDA_HOME=CUDA_HOME, CFLAGS="-DCALLS_CUDA")))

        # Last, as it starts threads, which no fork has.
        os.environ["TORCHINDUCTOR_CACHE_DIR"] = scratch
        compiled = torch.compile(lambda x: torch.sin(x) ** 2 + torch.cos(x) ** 2)
        assert torch.allclose(compiled(torch.rand(1000)), torch.ones(1000))

        toolkit = "/usr/local/cuda"  # of a part, perhaps
        assert toolkits[0]() == (toolkit if os.path.exists(f"{toolkit}/bin/nvcc") else "None")
        assert toolkits[1]() == scratch
        assert {ended() for ended in built} == {"42"}
    print("setuptools", setuptools.__version__)


if __name__ == "__main__":
    main()
