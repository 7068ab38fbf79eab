"""The packages of `rosml` import in one direction (`lint-imports`, contracts in pyproject.toml), one of them alone prints, and a reader finds
names that say something, short functions and short modules."""

from __future__ import annotations

import ast
import fnmatch
import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(sys.executable).parent / "lint-imports"

PRINTS = ("src/rosml/cli/", "src/rosml/base/terminal.py", "src/rosml/base/environment.py")
"""What prints: commands and their tables, how tables come onto a terminal, and what is said where packages are missing."""


def lint_imports(folder: Path) -> subprocess.CompletedProcess[str]:
    """Checks the contracts of a checkout."""
    argv = [str(PROGRAM), "--no-cache", "--config", str(folder / "pyproject.toml")]
    env = {**os.environ, "PYTHONPATH": str(folder / "src")}
    return subprocess.run(argv, cwd=folder, env=env, capture_output=True, text=True, check=False)


def printing(code: str) -> bool:
    """Whether code prints."""
    calls = [node.func for node in ast.walk(ast.parse(code)) if isinstance(node, ast.Call)]
    return any(ast.unparse(call) in ("print", "click.echo", "click.secho", "sys.stdout.write") for call in calls)


def test_imports_go_one_way() -> None:
    done = lint_imports(ROOT)
    if done.returncode:
        pytest.fail(done.stdout + done.stderr, pytrace=False)


def test_the_picture_shows_the_layers_of_the_contracts() -> None:
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
    layers = {word for contract in contracts for layer in contract.get("layers", ()) for word in layer.split(" | ")}
    order = [contract["layers"] for contract in contracts if "layers" in contract]
    picture = (ROOT / "docs/architecture.md").read_text().partition("```text\n")[2].partition("```")[0]
    shown = re.findall(r"^ *(\w+(?:, \w+)*)  |│  (\w+) ", picture, re.MULTILINE)
    names = [name for pair in shown for name in ", ".join(filter(None, pair)).split(", ")]
    assert sorted(names) == sorted(layers)
    for contract_layers in order:
        places = [min(names.index(word) for word in layer.split(" | ")) for layer in contract_layers]
        assert places == sorted(places), f"{names} are not in the order of {contract_layers}"


def test_only_commands_print() -> None:
    files = {file.relative_to(ROOT).as_posix(): file.read_text() for file in (ROOT / "src/rosml").rglob("*.py")}
    assert [name for name in files if not name.startswith(PRINTS) and printing(files[name])] == []
    assert printing(files["src/rosml/cli/images/report.py"]) or printing(files["src/rosml/cli/images/tables.py"])


def lines_with_parts(text: str, parts: set[str]) -> list[int]:
    """The lines of a Python file that name a part or a release as one."""
    nodes = ast.walk(ast.parse(text))
    return [node.lineno for node in nodes if isinstance(node, ast.Constant) and node.value in parts]


def test_no_code_knows_which_parts_there_are() -> None:
    """A part is data; NVIDIA's libraries alone have an accelerator of their name, and facts of the stack."""
    matrix = yaml.safe_load((ROOT / "matrix.yaml").read_text())
    parts = {part["name"] for part in matrix["parts"]} - {"cuda"}
    for file in sorted((ROOT / "src/rosml").rglob("*.py")):
        assert not lines_with_parts(file.read_text(), parts), file
    assert lines_with_parts('if part == "torch":\n    pass\n', {"torch"}) == [1]


PRODUCT = ("src", "components", "scripts", "tools", "bench")

WHEN = {"asked", "found", "given", "known", "left", "made", "named", "old", "own", "said", "there", "told", "wanted"}
"""Words that say when a value came, and not what it is."""


def modules(folders: Iterable[str] = PRODUCT) -> Iterator[tuple[str, str]]:
    """The modules of folders: path and text."""
    for folder in folders:
        for file in sorted((ROOT / folder).rglob("*.py")):
            yield str(file.relative_to(ROOT)), file.read_text()


def bound(node: ast.AST) -> str:
    """The name that a node gives to something; empty if it gives none."""
    match node:
        case ast.Name(id=name, ctx=ast.Store()) | ast.arg(arg=name) | ast.Attribute(attr=name, ctx=ast.Store()):
            return name
        case ast.FunctionDef(name=name) | ast.ClassDef(name=name) | ast.MatchAs(name=str(name)):
            return name
    return ""


def long_functions(text: str) -> Iterator[str]:
    """Functions of more than 60 lines or six arguments."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef):
            arguments = [argument.arg for argument in (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)]
            if (node.end_lineno or 0) - node.lineno >= 60 or len({*arguments} - {"self", "cls"}) > 6:
                yield f"{node.lineno} {node.name}"


def test_names_say_what_they_hold() -> None:
    names = {
        f"{path}: {bound(node)}"
        for path, text in modules((*PRODUCT, "tests"))
        for node in ast.walk(ast.parse(text))
        if bound(node).strip("_") in WHEN
    }
    assert sorted(names) == []


def test_functions_and_modules_are_short() -> None:
    assert [f"{path}:{function}" for path, text in modules() for function in long_functions(text)] == []
    assert [path for path, text in modules() if text.count("\n") > 500] == []
    arguments = ", ".join("abcdefg")
    assert [*long_functions(f"def short(): pass\ndef many({arguments}): pass")] == ["2 many"]


def test_pytest_looks_into_every_folder_with_tests(pytestconfig: pytest.Config) -> None:
    """By itself it passes over folders with names such as build, without a word."""
    skipped: list[str] = pytestconfig.getini("norecursedirs")
    folders = {part for file in (ROOT / "tests").rglob("test_*.py") for part in file.relative_to(ROOT).parts[:-1]}
    assert {name for name in folders for pattern in skipped if fnmatch.fnmatch(name, pattern)} == set()
