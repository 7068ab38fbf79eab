"""Folders with ROS packages for `rosml init`, and what it says about them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from rosml.cli import main
from rosml.cli.containerize import init
from rosml.containerize import inputs as app_inputs
from rosml.images.image_set import load
from rosml.images.image_set.model import ImageSet
from rosml.run.plugins import gpu

REGISTRY = ["--registry", "ghcr.io/me/rosml"]
TORCH = {"a.py": "import torch\n"}
WITH_CI = {".github/x": ""}


@pytest.fixture(autouse=True)
def machine(monkeypatch: pytest.MonkeyPatch, real: ImageSet) -> None:
    """A machine without a GPU, without ROS and without a local registry."""
    monkeypatch.setattr(load, "load", lambda *_: real)
    monkeypatch.setattr(gpu, "is_nvidia", lambda _: False)
    monkeypatch.setattr(init, "_local", lambda _: ("", False))
    monkeypatch.delenv("ROS_DISTRO", raising=False)


@pytest.fixture
def terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(init, "_has_terminal", lambda: True)


def manifest(name: str = "arm", build: str = "ament_python", depends: str = "", condition: str = "") -> str:
    where = f' condition="{condition}"' if condition else ""
    needs = "".join(f"\n  <depend>{key}</depend>" for key in depends.split())
    kind = f"<export><build_type{where}>{build}</build_type></export>" if build else ""
    return f'<package format="3">\n  <name>{name}</name>{needs}\n  {kind}\n</package>\n'


def write(folder: Path, files: Mapping[str, str], **of_package: str) -> Path:
    """Writes files, and a package into the folder itself, unless one of them is a manifest."""
    package = {} if any(name.endswith("package.xml") for name in files) else {"package.xml": manifest(**of_package)}
    for name, text in {**package, **files}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def called(folder: Path, *words: str, code: int = 0, typed: str | None = None) -> Result:
    done = CliRunner().invoke(main.cli, ["init", str(folder), *words], input=typed)
    assert getattr(done.exception, "exit_code", done.exit_code) == code, (done.output, done.exception)
    return done


def chosen(folder: Path, *words: str) -> dict[str, str]:
    """The values that are chosen, by question."""
    document = json.loads(called(folder, "--json", "--dry-run", *words).stdout)
    return {name: choice["value"] for name, choice in document["choices"].items()}


def values_of(folder: Path) -> Any:
    """What rosml containerize reads in the folder."""
    return app_inputs.values({}, folder, {})


def snapshot(folder: Path) -> dict[str, tuple[bytes, int]]:
    files = (path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    return {str(path.relative_to(folder)): (path.read_bytes(), path.stat().st_mtime_ns) for path in files}


def package(**of_package: str) -> dict[str, str]:
    return {"package.xml": manifest(**of_package)}
