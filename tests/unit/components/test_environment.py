"""What an environment adds to its Python: modules that are compiled for numpy 1 say so beside numpy 2, and do not end the process."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

PROGRAM = """\
import _rosml_numpy1
from cv_bridge.boost import cv_bridge_boost as module
print(module.getCvType("bgr8"))
try:
    print(module.cvtColor2())
except RuntimeError as error:
    print(error)
"""
MODULE = '"""{name}"""\nimport numpy\ndef getCvType(name): return 16\ndef cvtColor2(): return "converted"\ndef cvtColorForDisplay(): return "converted"\n'


@pytest.mark.parametrize(
    ("numpy", "compiled_for", "says"),
    [
        ("2.2.6", "numpy.core._multiarray_umath", "cv_bridge_boost.cvtColor2 is compiled for numpy 1, and this"),
        ("2.2.6", "numpy._core._multiarray_umath", "converted"),
        ("1.26.4", "numpy.core._multiarray_umath", "converted"),
    ],
)
def test_a_module_for_another_numpy_says_so(tmp_path: Path, numpy: str, compiled_for: str, says: str) -> None:
    package = tmp_path / "cv_bridge/boost"
    package.mkdir(parents=True)
    for file in (package / "__init__.py", package.parent / "__init__.py"):
        file.touch()
    (package / "cv_bridge_boost.py").write_text(MODULE.format(name=compiled_for))
    (tmp_path / "numpy.py").write_text(f"__version__ = {numpy!r}\n")
    command = [sys.executable, "-S", "-c", PROGRAM]
    paths = f"{tmp_path}:{ROOT / 'components/environment'}"
    done = subprocess.run(command, env={"PYTHONPATH": paths}, capture_output=True, text=True, check=True)
    first, second = done.stdout.splitlines()
    assert first == "16" and says in second
