#!/usr/bin/env python3
"""Resolves the Python packages in pyproject.toml, and their dependencies, to versions and hashes: tools/requirements-*.txt."""

from __future__ import annotations

import hashlib
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "src"))

import rosml.base.environment  # noqa: F401 (first: says what to do if the others are missing)

# isort: split

import click

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.cli import command

FILES: dict[str, tuple[str, ...]] = {"app": (), "build": ("build",), "dev": ("dev",), "page": ("dev", "page")}
"""The groups of pyproject.toml in each file, beside the packages of the commands."""


def group(project: dict[str, Any], name: str) -> Iterator[str]:
    for item in project["dependency-groups"][name]:
        if isinstance(item, str):
            yield item
        else:
            yield from group(project, item["include-group"])


def requirements(root: Path) -> dict[str, str]:
    project = tomllib.loads((root / "pyproject.toml").read_text())
    commands = project["project"]["dependencies"]
    return {
        file: "\n".join(sorted({*commands, *(item for name in groups for item in group(project, name))})) + "\n"
        for file, groups in FILES.items()
    }


def path(root: Path, file: str) -> Path:
    return root / "tools" / f"requirements-{file}.txt"


def header(file: str, lines: str) -> str:
    """The first lines of a file, with a digest of its requirements."""
    contents = " and ".join(["The commands' Python packages", *(f"the group {name}" for name in FILES[file])])
    digest = hashlib.sha256(lines.encode()).hexdigest()
    return f"# {contents}, by hash. Written by: uv run scripts/requirements.py\n# asked for: sha256:{digest}\n"


def stale(root: Path) -> list[str]:
    return [
        str(path(root, file).relative_to(root))
        for file, lines in requirements(root).items()
        if not path(root, file).is_file() or not path(root, file).read_text().startswith(header(file, lines))
    ]


def resolve(root: Path, upgrade: bool) -> None:
    """Writes all files, the largest first: the others take its versions."""
    lines = requirements(root)
    python = tomllib.loads((root / "pyproject.toml").read_text())["project"]["requires-python"].removeprefix(">=")
    for file in sorted(FILES, key=lambda name: -len(lines[name])):
        target = path(root, file)
        argv = ["uv", "pip", "compile", "-", "--quiet", "--universal", "--python-version", python, "--generate-hashes"]
        argv += ["--no-annotate", "--no-header", "--output-file", str(target)]
        if file != "page":
            argv += ["--constraint", str(path(root, "page"))]
        if upgrade:
            argv += ["--upgrade"]
        try:
            subprocess.run(argv, input=lines[file], text=True, check=True, capture_output=True)
        except FileNotFoundError:
            raise RosmlError("'uv' is not installed", "run 'rosml setup'") from None
        except subprocess.CalledProcessError as error:
            raise RosmlError(f"uv cannot resolve {target.name}:\n{error.stderr.strip()}", "see what uv says") from None
        target.write_text(header(file, lines[file]) + target.read_text())


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--check", is_flag=True, help="Write nothing; exit 1 if pyproject.toml asks for other packages.")
@click.option("--upgrade", is_flag=True, help="Move dependencies of the packages to the newest versions.")
def main(check: bool, upgrade: bool) -> None:
    """Resolves the Python packages in pyproject.toml, and their dependencies, to versions and hashes.

    \b
    Examples:
      uv run scripts/requirements.py
      uv run scripts/requirements.py --check
    """
    if not check:
        resolve(ROOT, upgrade)
    elif stale_files := stale(ROOT):
        raise RosmlError(f"not of today's pyproject.toml: {', '.join(stale_files)}", "uv run scripts/requirements.py")


if __name__ == "__main__":
    sys.exit(command.run(main))
