#!/usr/bin/env python3
"""What PyTorch builds is built with the distribution's setuptools, which ROS's tools need, whatever release of setuptools
PyTorch asks for: a function by torch.compile, and an extension by a setup.py."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

SETUP = """
from setuptools import setup
from torch.utils.cpp_extension import BuildExtension, CppExtension
setup(name="answer", ext_modules=[CppExtension("answer", ["answer.cpp"])], cmdclass={"build_ext": BuildExtension})
"""
# Without PyTorch's own headers, which take a minute to read.
SOURCE = """
#include <Python.h>
static PyModuleDef module = {PyModuleDef_HEAD_INIT, "answer", nullptr, -1, nullptr};
PyMODINIT_FUNC PyInit_answer() {
  PyObject* made = PyModule_Create(&module);
  PyModule_AddIntConstant(made, "answer", 42);
  return made;
}
"""


def main() -> None:
    import setuptools

    assert not str(setuptools.__file__).startswith("/usr/local"), setuptools.__file__
    with tempfile.TemporaryDirectory() as folder:
        os.environ["TORCHINDUCTOR_CACHE_DIR"] = folder
        import torch

        compiled = torch.compile(lambda x: torch.sin(x) ** 2 + torch.cos(x) ** 2)
        assert torch.allclose(compiled(torch.rand(1000)), torch.ones(1000))
        Path(folder, "setup.py").write_text(SETUP)
        Path(folder, "answer.cpp").write_text(SOURCE)
        subprocess.run([sys.executable, "setup.py", "-q", "build_ext", "--inplace"], cwd=folder, check=True)
        asked = "import torch, answer; print(answer.answer)"
        said = subprocess.run([sys.executable, "-c", asked], cwd=folder, stdout=subprocess.PIPE, text=True, check=True)
        assert said.stdout == "42\n", said.stdout
    print("setuptools", setuptools.__version__)


if __name__ == "__main__":
    main()
