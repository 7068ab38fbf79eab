"""What an environment adds to its Python: a cv_bridge that is compiled for numpy 1 does not end the process beside numpy 2. With real
pictures: tests/e2e/test_environments.py."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

PROGRAM = """\
import _rosml_cv_guard
from cv_bridge.boost import cv_bridge_boost as module
print(module.getCvType("8UC2"), module.cvtColor2())
"""
MODULE = '''"""{name}"""
import numpy, cv2
def getCvType(name): return 8
def cvtColor2(): return "its own"
'''
OURS = "FUNCTIONS = {'cvtColor2': lambda: 'ours', 'getCvType': lambda name: 32}\n"
NUMPY1, NUMPY2 = (f"numpy.{core}._multiarray_umath" for core in ("core", "_core"))


@pytest.mark.parametrize(
    ("numpy", "opencv", "compiled_for", "says"),
    [
        ("2.2.6", 8, NUMPY1, "32 ours"),
        ("2.2.6", 8, NUMPY2, "8 its own"),
        ("1.26.4", 8, NUMPY1, "8 its own"),
        ("1.26.4", 32, NUMPY1, "32 ours"),  # OpenCV 5 numbers its types otherwise
    ],
)
def test_a_module_for_another_numpy_or_opencv(
    tmp_path: Path, numpy: str, opencv: int, compiled_for: str, says: str
) -> None:
    package = tmp_path / "cv_bridge/boost"
    package.mkdir(parents=True)
    for file in (package / "__init__.py", package.parent / "__init__.py"):
        file.touch()
    (package / "cv_bridge_boost.py").write_text(MODULE.format(name=compiled_for))
    (tmp_path / "numpy.py").write_text(f"__version__ = {numpy!r}\n")
    (tmp_path / "cv2.py").write_text(f"CV_8UC2 = {opencv}\n")
    (tmp_path / "_rosml_cv_bridge.py").write_text(OURS)
    command = [sys.executable, "-S", "-c", PROGRAM]
    paths = f"{tmp_path}:{ROOT / 'components/environment'}"
    done = subprocess.run(command, env={"PYTHONPATH": paths}, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == says
