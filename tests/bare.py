"""scripts/bootstrap.py in a checkout of a test's own."""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType

from tests.pages import ROOT


class Bootstrap:
    """A copy of it in `root`, a checkout that is made and has nothing else. `module` is the copy, imported."""

    def __init__(self, root: Path) -> None:
        self.root, self.file = root, root / "scripts/bootstrap.py"
        self.file.parent.mkdir(parents=True)
        shutil.copy(ROOT / "scripts/bootstrap.py", self.file)
        self.module = self._imported()

    def _imported(self) -> ModuleType:
        spec = importlib.util.spec_from_file_location("bootstrap_of_a_test", self.file)
        assert spec and spec.loader
        module = importlib.util.module_from_spec(spec)
        before, sys.dont_write_bytecode = sys.dont_write_bytecode, True
        spec.loader.exec_module(module)
        sys.dont_write_bytecode = before
        return module

    def __call__(self, *arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
        """Calls it as a user does."""
        env = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", **environment}  # which `clean` would find
        argv = [sys.executable, str(self.file), *arguments]
        return subprocess.run(argv, capture_output=True, text=True, timeout=60, check=False, env=env)
