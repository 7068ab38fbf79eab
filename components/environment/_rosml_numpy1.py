"""Refuses what ends a process without a word: functions of ROS's modules that are compiled for numpy 1, beside numpy 2.

Such a module cannot read arrays of numpy 2. Most fail when they are imported. cv_bridge goes on, and its functions end the process when
they get a picture. A module that is compiled for numpy 2 looks for `numpy._core` first, so its file has that name:
https://numpy.org/doc/stable/dev/depending_on_numpy.html
"""

from __future__ import annotations

import sys
from importlib.machinery import ModuleSpec, PathFinder

TYPE_CHECKING = False  # each start of the environment's Python reads this file, and typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

UNSAFE = {"cv_bridge.boost.cv_bridge_boost": ("cvtColor2", "cvtColorForDisplay")}
REMEDY = "read the picture as it is (desired_encoding='passthrough'), and convert it by cv2.cvtColor"


def _refusing(name: str, version: str) -> Callable[..., None]:
    def refuse(*_arguments: object, **_more: object) -> None:
        text = f"{name} is compiled for numpy 1, and this environment has numpy {version}; {REMEDY}"
        raise RuntimeError(text)

    return refuse


def _disarm(module: Any) -> None:
    """Replaces the unsafe functions of a module, if it is compiled for numpy 1 and imported numpy 2."""
    numpy: Any = sys.modules["numpy"]
    with open(module.__file__, "rb") as file:
        numpy2 = b"numpy._core" in file.read()
    if not numpy2 and int(numpy.__version__.partition(".")[0]) > 1:
        for function in UNSAFE[module.__name__]:
            setattr(module, function, _refusing(f"{module.__name__}.{function}", numpy.__version__))


class _Finder:
    @staticmethod
    def find_spec(name: str, path: Sequence[str] | None = None, target: Any = None) -> ModuleSpec | None:
        if name not in UNSAFE:
            return None
        spec = PathFinder.find_spec(name, path, target)
        loader: Any = spec and spec.loader
        if loader:
            load = loader.exec_module

            def exec_module(module: Any) -> None:
                load(module)
                _disarm(module)

            loader.exec_module = exec_module
        return spec


sys.meta_path.insert(0, _Finder)
