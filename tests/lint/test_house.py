"""The packages of `rosml` import in one direction (`lint-imports`, contracts in pyproject.toml), and one of them alone prints."""

from __future__ import annotations

import ast
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(sys.executable).parent / "lint-imports"

PRINTS = ("rosml/cli/", "rosml/base/terminal.py", "rosml/base/environment.py")
"""What prints: commands and their tables, how tables come onto a terminal, and what is said where packages are missing."""


def lint_imports(folder: Path) -> subprocess.CompletedProcess[str]:
    """Checks the contracts of a checkout."""
    argv = [str(PROGRAM), "--no-cache", "--config", str(folder / "pyproject.toml")]
    return subprocess.run(argv, cwd=folder, capture_output=True, text=True, check=False)


def printing(code: str) -> bool:
    """Whether code prints."""
    calls = [node.func for node in ast.walk(ast.parse(code)) if isinstance(node, ast.Call)]
    return any(ast.unparse(call) in ("print", "click.echo", "click.secho", "sys.stdout.write") for call in calls)


def test_imports_go_one_way() -> None:
    done = lint_imports(ROOT)
    if done.returncode:
        pytest.fail(done.stdout + done.stderr, pytrace=False)


@pytest.mark.parametrize(
    ("module", "line", "contract"),
    [
        ("base/errors", "from rosml.matrix import names", "from those below them alone BROKEN"),
        ("scan/policy", "def f() -> None:\n    from rosml.build import push", "from those below them alone BROKEN"),
        ("images/image_set", "def f() -> None:\n    from rosml.images import explain", "in one direction BROKEN"),
        ("matrix/rules", "import httpx", "neither network nor processes BROKEN"),
        ("bake/hcl", "def f() -> None:\n    import subprocess", "neither network nor processes BROKEN"),
        ("machine/disk", "def f() -> None:\n    from offline import debian", "nothing of tools/ BROKEN"),
        ("news/paper", "import re", "rosml.news"),
    ],
    ids=["up", "lazy, beside", "lazy circle", "network", "process", "tools", "without a floor"],
)
def test_what_goes_another_way_is_found(tmp_path: Path, module: str, line: str, contract: str) -> None:
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    shutil.copytree(ROOT / "rosml", tmp_path / "rosml", ignore=shutil.ignore_patterns("__pycache__", "page"))
    file = tmp_path / f"rosml/{module}.py"
    file.parent.mkdir(exist_ok=True)
    (file.parent / "__init__.py").touch()
    with file.open("a") as text:
        text.write(f"\n\n{line}\n")
    done = lint_imports(tmp_path)
    assert done.returncode
    assert contract in done.stdout + done.stderr


def test_only_commands_print() -> None:
    files = {file.relative_to(ROOT).as_posix(): file.read_text() for file in (ROOT / "rosml").rglob("*.py")}
    assert [name for name in files if not name.startswith(PRINTS) and printing(files[name])] == []
    assert printing("def f():\n    print('it')")
    assert printing(files["rosml/cli/report.py"]) or printing(files["rosml/cli/tables.py"])


def test_the_page_about_it_knows_its_way() -> None:
    """Every package has its place in the table, in the order of the contract, and every file that is named is there."""
    page = (ROOT / "docs/architecture.md").read_text()
    layers = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"][0]["layers"]
    rows = [re.findall(r"`(\w+)`", row) for row in re.findall(r"^\| (`.+?) \|", page, re.MULTILINE)]
    assert rows == [layer.split(" | ") for layer in layers]
    named = re.findall(r"`(\w+/\w+\.(?:py|hcl))`", page)
    assert len(named) > 20
    assert [name for name in named if not (ROOT / "rosml" / name).is_file()] == []


def named_parts(text: str, parts: set[str]) -> list[int]:
    """The lines of a Python file that name a part or a release as one."""
    nodes = ast.walk(ast.parse(text))
    return [node.lineno for node in nodes if isinstance(node, ast.Constant) and node.value in parts]


def test_no_code_knows_which_parts_there_are() -> None:
    """A part is data; NVIDIA's libraries alone have an accelerator of their name, and facts of the stack."""
    matrix = yaml.safe_load((ROOT / "matrix.yaml").read_text())
    parts = {part["name"] for part in matrix["parts"]} - {"cuda"}
    for file in sorted((ROOT / "rosml").rglob("*.py")):
        assert not named_parts(file.read_text(), parts), file
    assert named_parts('if part == "torch":\n    pass\n', {"torch"}) == [1]
