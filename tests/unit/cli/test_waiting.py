"""What people wait for: how much a command imports and expands, in counts, which are the same on each machine."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from conftest import ROOT

from rosml.cli import MODULES
from rosml.cli.images import explain, listing
from rosml.images.image_set import expand, load, lock_file

HEAVY = {
    *[
        "asyncio",
        "httpx",
        "importlib.metadata",
        "jinja2",
        "msgspec",
        "packageurl",
        "pydantic",
        "rich",
        "ssl",
        "subprocess",
        "yaml",
    ]
}

IMPORTS = """\
import sys
before = {*sys.modules}
from rosml.__main__ import run
code = run()
print()
print(*{*sys.modules} - before)
sys.exit(code)
"""


def imported(*words: str) -> set[str]:
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "src")}
    argv = [sys.executable, "-c", IMPORTS, *words]
    done = subprocess.run(argv, env=environment, capture_output=True, text=True, check=True)
    return {*done.stdout.splitlines()[-1].split()}


@pytest.mark.parametrize(("words", "most"), [((), 180), *(((name,), 140) for name in MODULES)])
def test_help_imports_little(words: tuple[str, ...], most: int) -> None:
    modules = imported(*words, "--help")
    assert not modules & HEAVY
    assert not {name for name in modules if name.startswith("rosml.images")}
    assert len(modules) <= most


def test_a_table_that_is_no_terminals_needs_no_rich() -> None:
    assert "rich" not in imported("list")


class Counted:
    def __init__(self, function: Any) -> None:
        self.function, self.calls = function, 0

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        self.calls += 1
        return self.function(*arguments, **options)


def counted(monkeypatch: pytest.MonkeyPatch, module: Any, name: str) -> Counted:
    counter = Counted(getattr(module, name))
    monkeypatch.setattr(module, name, counter)
    return counter


ONE = "jazzy-base-torch-cu130"


def test_explain_expands_one_image_and_those_that_run_its_tests(monkeypatch: pytest.MonkeyPatch) -> None:
    image = load.load(ROOT / "matrix.yaml").by_target[ONE]
    images, locks = counted(monkeypatch, expand, "Image"), counted(monkeypatch, lock_file, "current")
    assert CliRunner().invoke(explain.main, [ONE]).exit_code == 0
    assert images.calls == len({ONE, *image.carriers}) < 10
    assert locks.calls < 60


def test_list_expands_each_image_once(monkeypatch: pytest.MonkeyPatch) -> None:
    total = len(load.load(ROOT / "matrix.yaml").images)
    images, kinds = counted(monkeypatch, expand, "Image"), counted(monkeypatch, expand, "Kind")
    assert CliRunner().invoke(listing.main, []).exit_code == 0
    assert images.calls == total
    assert kinds.calls < total / 2


@pytest.mark.parametrize("name", [ONE, f"{ONE}-test", "ros-torch:jazzy-base-cu130", "ghcr.io/me/ros:jazzy-base"])
def test_one_image_has_the_same_facts_among_a_few(name: str) -> None:
    everything, few = load.load(ROOT / "matrix.yaml"), load.load_one(ROOT / "matrix.yaml", name)
    assert 0 < len(few.images) < 10
    for image in few.images:
        assert image == everything.by_target[image.target]
    assert all(part in everything.parts for part in few.parts)
    assert {name for image in few.images for name in image.parts} == {*few.part_by_name}


def test_a_name_of_no_image_gives_the_whole_set() -> None:
    assert load.load_one(ROOT / "matrix.yaml", "nosuch").images == load.load(ROOT / "matrix.yaml").images


# ---- Bytecode --------------------------------------------------------------------------------------------------------


def checkout(folder: Path) -> list[str]:
    package = folder / "src/rosml"
    package.mkdir(parents=True)
    shutil.copy(ROOT / "src/__main__.py", folder / "src")
    (package / "__init__.py").write_text("")
    (package / "__main__.py").write_text("def run() -> int:\n    print('here')\n    return 0\n")
    return [sys.executable, str(folder / "src")]


def call(argv: list[str], cwd: Path, **variables: str) -> str:
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    return subprocess.run(argv, cwd=cwd, env=environment | variables, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("inside", [False, True])
def test_bytecode_has_its_own_folder_where_none_shall_be_beside_sources(tmp_path: Path, inside: bool) -> None:
    argv, cwd = checkout(tmp_path), tmp_path / "src" if inside else tmp_path
    (tmp_path / ".state").mkdir()
    assert call([argv[0], "__main__.py"] if inside else argv, cwd, PYTHONDONTWRITEBYTECODE="1") == "here\n"
    kept = {file.name.partition(".")[0] for file in (tmp_path / ".state/bytecode").rglob("*.pyc")}
    assert {"__init__", "__main__"} <= kept
    assert not [*(tmp_path / "src").rglob("__pycache__")]


def test_bytecode_is_beside_sources_otherwise(tmp_path: Path) -> None:
    assert call(checkout(tmp_path), tmp_path) == "here\n"
    assert [*(tmp_path / "src").rglob("__pycache__")] and not (tmp_path / ".state").exists()


def test_bytecode_makes_no_state(tmp_path: Path) -> None:
    assert call(checkout(tmp_path), tmp_path, PYTHONDONTWRITEBYTECODE="1") == "here\n"
    assert not (tmp_path / ".state").exists()


def test_it_works_where_bytecode_cannot_be_written(tmp_path: Path) -> None:
    argv = checkout(tmp_path)
    (tmp_path / ".state").mkdir()
    (tmp_path / ".state/bytecode").write_text("a file is in the way, for root as well")
    assert call(argv, tmp_path, PYTHONDONTWRITEBYTECODE="1") == "here\n"
