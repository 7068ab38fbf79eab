"""Gives ROS's cv_bridge other functions if its own are compiled for another numpy or OpenCV than the environment's.

A module for numpy 1 complains beside numpy 2 when it is imported, and ends the process when it gets a picture. A module that is compiled
for numpy 2 looks for `numpy._core` first, so its file has that name: https://numpy.org/doc/stable/dev/depending_on_numpy.html
"""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.machinery import ModuleSpec, PathFinder

TYPE_CHECKING = False  # each start of the environment's Python reads this file, and typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

MODULE = "cv_bridge.boost.cv_bridge_boost"


def _is_for_this_numpy(file: str) -> bool:
    numpy: Any = import_module("numpy")
    with open(file, "rb") as opened:
        return int(numpy.__version__.partition(".")[0]) < 2 or b"numpy._core" in opened.read()


def _replace_functions(module: Any) -> None:
    vars(module).update(import_module("_rosml_cv_bridge").FUNCTIONS)


class _Loader:
    """Loads a module that has the other functions alone."""

    @staticmethod
    def create_module(spec: ModuleSpec) -> None:
        """Python makes it."""

    exec_module = staticmethod(_replace_functions)


class _Finder:
    @staticmethod
    def find_spec(name: str, path: Sequence[str] | None = None, target: Any = None) -> ModuleSpec | None:
        if name != MODULE:
            return None
        spec = PathFinder.find_spec(name, path, target)
        loader: Any = spec and spec.loader
        if spec is None or loader is None or spec.origin is None:
            return spec
        if not _is_for_this_numpy(spec.origin):
            ours: Any = _Loader()
            return ModuleSpec(name, ours, origin=spec.origin)
        load = loader.exec_module

        def exec_module(module: Any) -> None:
            load(module)
            opencv: Any = import_module("cv2")
            if module.getCvType("8UC2") != opencv.CV_8UC2:
                _replace_functions(module)

        loader.exec_module = exec_module
        return spec


sys.meta_path.insert(0, _Finder)
