"""Copies of the project: to publish from, to generate in, and to compare in a git repository. `conftest` has fixtures of them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

from rosml.containerize.ci import files as ci_files
from rosml.images.bake import bake_file

ROOT = Path(__file__).resolve().parents[3]
LOCK = "locks/cu1/amd64/3.12/torch.txt"
INSTALL = "components/ros/install.sh"
BASE = "alpha-base-torch-cu1"
"""An image of the small matrix that has parts and stands on another one."""


def copy(folder: Path) -> Path:
    """All that images are built from, without the matrix and its locks; files have the time of the copy."""
    for name in ("components", "tests/structure"):
        shutil.copytree(ROOT / name, folder / name, copy_function=shutil.copy)
    for name in ("docs", "tools"):
        (folder / name).mkdir()
    for name in [
        "Dockerfile",
        "docs/tags.md",
        "docs/licences.md",
        "tools/requirements.txt",
        "tools/structure-test.txt",
    ]:
        shutil.copy(ROOT / name, folder / name)
    lock = folder / LOCK
    lock.parent.mkdir(parents=True)
    lock.write_text("torch==2.10.0\n")
    return folder


def copy_for_generator(folder: Path) -> Path:
    for name in ("components", "environments", "locks", "src", "scripts", "tests/structure", "tools"):
        shutil.copytree(ROOT / name, folder / name)
    pages = ("docs/tags.md", "docs/licences.md", "docs/images/layers.svg", "docs/images/rebase.svg")
    files = ["matrix.yaml", "matrix.schema.json", "catalogue.schema.json", "Dockerfile", "Makefile", "rosml"]
    for name in (*files, bake_file.NAME, bake_file.TESTS, *pages, *ci_files.FILES):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    return folder


def copy_with_commands(folder: Path, matrix: str) -> Path:
    copy(folder)
    for name in ("src", "scripts"):
        shutil.copytree(ROOT / name, folder / name)  # with its bytecode, which Python would make anew
    (folder / ".gitignore").write_text("__pycache__\n")
    (folder / "matrix.yaml").write_text(matrix)
    git(folder, "init", "--quiet")
    commit(folder)
    return folder


def git(folder: Path, *arguments: str) -> str:
    names = {f"GIT_{who}_{what}": "a@example.org" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
    command = ["git", "-C", str(folder), *arguments]
    done = subprocess.run(command, check=True, capture_output=True, text=True, env={**os.environ, **names})
    return done.stdout.strip()


def commit(folder: Path) -> None:
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "--message", "A version")


def diff(folder: Path, version: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "src", "diff", *arguments, "--", version]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=60)
