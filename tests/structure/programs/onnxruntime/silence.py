#!/usr/bin/env python3
"""ONNX Runtime tells its maker nothing: in C++ with the image's variables, in Python without them as well.

Releases from 1.29.0 on make a file with an identity of the machine in the home folder when a process creates its environment, and
send what the program does later. A program in C++ without the variables makes that file here, as proof that the others would.
It ends at once, before anything is sent.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

CREATES = """
import ctypes, os

Base = ctypes.POINTER(ctypes.c_void_p)
library = ctypes.CDLL("libonnxruntime.so.1")
library.OrtGetApiBase.restype = Base
get = ctypes.CFUNCTYPE(Base, ctypes.c_uint32)(library.OrtGetApiBase()[0])
create = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_void_p)(get(1)[3])
assert create(3, b"test", ctypes.byref(ctypes.c_void_p())) is None
os._exit(0)
"""
"""CreateEnv, the fourth function of ONNX Runtime's C API."""
IMPORTS = (
    "import onnxruntime, os; onnxruntime.SessionOptions(); onnxruntime.set_default_logger_severity(3); os._exit(0)"
)
VARIABLE = "ORT_DISABLE_TELEMETRY"


def written(program: str, environment: dict[str, str]) -> list[str]:
    """The files that a program of Python makes in its home folder."""
    with tempfile.TemporaryDirectory() as home:
        subprocess.run([sys.executable, "-c", program], env={**environment, "HOME": home}, check=True)
        return [str(file.relative_to(home)) for file in Path(home).rglob("*") if file.is_file()]


def main() -> None:
    can = any(VARIABLE.encode() in file.read_bytes() for file in Path("/usr/lib").glob("*/libonnxruntime.so.1"))
    image = {name: value for name, value in os.environ.items() if name in ("PATH", VARIABLE)}
    bare = {"PATH": image["PATH"]}
    for title, program, environment, expected in (
        ("C++ in the image", CREATES, image, False),
        ("Python in the image", IMPORTS, image, False),
        ("Python without the variables", IMPORTS, bare, False),
        ("C++ without the variables", CREATES, bare, can),
    ):
        files = written(program, environment)
        assert bool(files) == expected, f"{title} made {files}"
    print("it sends what a program does unless a variable says no: it says no" if can else "it sends nothing")


if __name__ == "__main__":
    main()
