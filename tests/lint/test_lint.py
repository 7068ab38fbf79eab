"""Linters, one test each, so that pytest's summary counts them."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(sys.executable).parent
"""Where the linters' Python packages put their commands."""


def check(program: str, *arguments: str | Path) -> None:
    """Runs a linter in the checkout; fails with all that it says."""
    argv = [str(PROGRAMS / program), *map(str, arguments)]
    done = subprocess.run(argv, cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        pytest.fail(f"{program}:\n{done.stdout}{done.stderr}", pytrace=False)


def shell_scripts() -> list[Path]:
    """Every shell script of the project."""
    return sorted(
        [
            *(path for name in ("components", "tests", "scripts") for path in (ROOT / name).rglob("*.sh")),
            ROOT / ".ci/run",
        ]
    )


def test_ruff_check() -> None:
    check("ruff", "check", "--quiet", ".")


def test_ruff_format() -> None:
    check("ruff", "format", "--quiet", "--check", "--diff", ".")


def test_mypy() -> None:
    check("mypy", "--no-error-summary")


def test_shellcheck() -> None:
    scripts = shell_scripts()
    assert len(scripts) > 1
    check("shellcheck", "--external-sources", *scripts)


def test_hadolint() -> None:
    check("hadolint", "--no-color", ROOT / "Dockerfile")


def test_generated_files_are_current() -> None:
    check("python", "scripts/generate_bake.py", "--check")


def test_makefile_lists_its_commands() -> None:
    """Every target that a user may call is in the list that ``make`` alone prints."""
    listed = subprocess.run(["make"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    named = (ROOT / "Makefile").read_text().split(".PHONY: ")[1].splitlines()[0].split()
    assert [line.split()[1] for line in listed.splitlines()] == named
