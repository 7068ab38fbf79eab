"""Files of Python that run in images need no newer Python than the oldest one of `matrix.yaml`."""

from __future__ import annotations

import ast
import importlib
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml

from offline.assembler import interpreter

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("components", "devcontainer/src", "tests/gpu", "tests/structure")
"""What runs in images of any row, or may: tests/e2e has its own images, on Debian bookworm."""

BESIDE = ("components/containerize", "components/part", "tests/structure/programs/nodes2")
"""Folders whose programs import what lies beside them."""

STARTS = """\
import importlib.abc, importlib.machinery, runpy, sys
from pathlib import Path
from unittest.mock import MagicMock

class Missing(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    "What an image has, and this machine has not."
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in sys.argv[1].split():
            return None
        return importlib.machinery.ModuleSpec(name, self, is_package=True)
    def create_module(self, spec):
        return MagicMock(__name__=spec.name, __path__=[], __spec__=spec)
    def exec_module(self, module):
        pass

sys.meta_path.append(Missing())
for name in sys.argv[2:]:
    text = Path(name).read_text()
    compile(text, name, "exec")
    if '\\nif __name__ == "__main__":\\n' in text:
        sys.path[0] = str(Path(name).parent)
        runpy.run_path(name, run_name="imported")
        print(name)
"""
"""Compiles files, and runs those up to their main part that have one; says which. First come the names of Python's own modules."""


def oldest() -> str:
    """Such as 3.8."""
    systems = yaml.safe_load((ROOT / "matrix.yaml").read_text())["operating_systems"].values()
    return min((str(system["python"]) for system in systems), key=lambda version: int(version.split(".")[1]))


def files() -> list[str]:
    return [str(file.relative_to(ROOT)) for folder in FOLDERS for file in sorted((ROOT / folder).rglob("*.py"))]


def uv() -> str:
    program = shutil.which("uv", path=f"{ROOT / '.state/bin'}:{os.environ['PATH']}")
    assert program, "uv is not there: make lint installs it"
    return program


@pytest.fixture(scope="module")
def mypy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that an older mypy is installed in: today's does not know that Python any more."""
    folder = tmp_path_factory.mktemp("mypy")
    install = [uv(), "pip", "install", "--quiet", "--require-hashes", "--python", sys.executable]
    requirements = ["--target", str(folder), "--requirement", str(ROOT / "tools/oldest-python.txt")]
    subprocess.run([*install, *requirements], check=True)
    return folder


def check(mypy: Path, python: str, *names: str) -> str:
    """Type-checks files for a version of Python; what is wrong with them."""
    argv = [sys.executable, "-m", "mypy", "--python-version", python, "--config-file", os.devnull]
    argv += ["--check-untyped-defs", "--explicit-package-bases", "--no-error-summary", "--hide-error-context"]
    argv += ["--disable-error-code=import-untyped", "--cache-dir", str(ROOT / ".state/cache/mypy-oldest")]
    env = {**os.environ, "PYTHONPATH": str(mypy), "MYPYPATH": ":".join(str(ROOT / path) for path in (".", *BESIDE))}
    done = subprocess.run([*argv, *names], cwd=ROOT, env=env, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stdout + done.stderr
    return "\n".join(line for line in done.stdout.splitlines() if ": error: " in line and not elsewhere(line))


def elsewhere(line: str) -> bool:
    """Whether mypy misses a module that is not Python's own: an image has it."""
    module = re.search(r'library stub for module named "(\w+)', line)
    return module is not None and module[1] not in sys.stdlib_module_names


def test_types_and_libraries(mypy: Path) -> None:
    if errors := check(mypy, oldest(), *files()):
        pytest.fail(errors, pytrace=False)


def generic(name: str) -> bool:
    """Whether a name such as `dict` or `collections.abc.Callable` is a class of Python's library that takes arguments from 3.9 on."""
    module, _, attribute = f"builtins.{name}".removeprefix("builtins." if "." in name else "").rpartition(".")
    if module == "typing" or module.partition(".")[0] not in sys.stdlib_module_names:
        return False
    value = getattr(importlib.import_module(module), attribute, None)
    return isinstance(value, type) and hasattr(value, "__class_getitem__")


def arguments_that_run(code: str) -> list[str]:
    """Classes with arguments outside of annotations, which nobody reads. mypy lets those of `collections.abc` pass."""
    nodes = [*ast.walk(ast.parse(code))]
    called = {}
    for node in nodes:
        if isinstance(node, ast.ImportFrom):
            called.update({item.asname or item.name: f"{node.module}.{item.name}" for item in node.names})
    kinds = (getattr(node, name, None) for node in nodes for name in ("annotation", "returns"))
    unread = {id(inner) for kind in kinds if kind for inner in ast.walk(kind)}
    subscripts = [node for node in nodes if isinstance(node, ast.Subscript) and id(node) not in unread]
    names = {ast.unparse(node): ast.unparse(node.value) for node in subscripts}
    return [whole for whole, name in names.items() if re.fullmatch(r"[\w.]+", name) and generic(called.get(name, name))]


def test_classes_with_arguments() -> None:
    code = "from collections.abc import Callable as C\nfrom typing import Dict\na: list[int] = os.environ['x']\n"
    assert arguments_that_run(f"{code}b = C[[], str]\nc = Dict[str, dict[str, int]]\n") == [
        "C[[], str]",
        "dict[str, int]",
    ]
    assert {name: kinds for name in files() if (kinds := arguments_that_run((ROOT / name).read_text()))} == {}


NEWER = {
    "a type of the language with arguments, which runs": "names = set[str]()\n",
    "the same as an alias": "Names = dict[str, int]\n",
    "dictionaries joined": "names = {'a': 1}\nnames |= {'b': 2}\n",
    "a method": "print('abc'.removeprefix('a'))\n",
    "a function": "from pathlib import Path\nprint(Path('a').is_relative_to('b'))\n",
    "a module": "import graphlib\n",
}


def test_what_python_3_8_lacks_is_found(mypy: Path, tmp_path: Path) -> None:
    for name, text in NEWER.items():
        (tmp_path / "newer.py").write_text(text)
        assert "error" in check(mypy, "3.8", str(tmp_path / "newer.py")), name


def test_ruff_knows_of_it() -> None:
    targets = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["ruff"]["per-file-target-version"]
    newest = int(oldest().partition(".")[2])
    assert [folder for folder in FOLDERS if int(targets[f"{folder}/**"].removeprefix("py3")) > newest] == []


def test_files_start() -> None:
    """With the Python itself, if there is one: this machine's, or one that uv downloads."""
    _, home = interpreter(oldest())
    python = [f"{home}/bin/python{oldest()}"] if home else [uv(), "run", "-q", "--no-project", "-p", oldest(), "python"]
    if subprocess.run([*python, "--version"], capture_output=True, check=False).returncode:
        pytest.skip("no Python as old as the oldest one of the matrix is here, nor can it be downloaded")
    library = " ".join(sys.stdlib_module_names)
    env = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "OUT": "/out", "SITE": "/site", "PYTHON": oldest()}
    argv = [*python, "-c", STARTS, library, *files()]
    done = subprocess.run(argv, cwd=ROOT, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "components/ros/runtime_packages.py" in done.stdout.split()
