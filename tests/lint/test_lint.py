"""Linters, one test each, so that pytest's summary counts them."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.documented import blocks

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
            *(path for name in ("components", "tests", "scripts", "tools") for path in (ROOT / name).rglob("*.*sh")),
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


def actionlint(*files: Path) -> None:
    """Checks workflows; all of the project's own if none is named."""
    program = shutil.which("actionlint", path=f"{ROOT / '.state/bin'}:{os.environ['PATH']}")
    assert program, "actionlint is not there: make lint builds it"
    check(program, "-no-color", "-shellcheck", PROGRAMS / "shellcheck", "-pyflakes", "", *files)


def test_actionlint() -> None:
    """Workflows, and what they pass to shells."""
    actionlint()


def test_actionlint_of_the_documentation(tmp_path: Path) -> None:
    """The workflow that users are shown."""
    [block] = [block for block in blocks(ROOT / "docs/use.md") if block.title == ".github/workflows/test.yml"]
    (tmp_path / "test.yml").write_text(block.text)
    actionlint(tmp_path / "test.yml")


def test_zizmor() -> None:
    """The security of workflows."""
    check("zizmor", "--offline", "--pedantic", "--strict-collection", "--no-progress", "--quiet", ".github/workflows")


def test_hadolint() -> None:
    check("hadolint", "--no-color", ROOT / "Dockerfile", ROOT / "tests/e2e/docker_ros/Dockerfile")


def oxlint(*files: Path) -> None:
    """Checks the page's JavaScript, which no build step reads before a browser does."""
    assert files
    check("oxlint", "--config", "tests/lint/oxlint.json", "--deny-warnings", *files)


def test_oxlint() -> None:
    oxlint(*sorted((ROOT / "rosml/catalogue/page").glob("*.js")))


BAD = {
    "a syntax error": ("const x = ;", "Unexpected token"),
    "a name that there is not": ("document.title = nothing_like_that;", "nothing_like_that"),
    "a variable that nobody reads": ("const unread = 1;", "unread"),
    "a long function": ("window.x = function long() {\n" + "window.y = 1;\n" * 61 + "};", "too many lines"),
}


@pytest.mark.parametrize("what", BAD)
def test_oxlint_finds(tmp_path: Path, what: str) -> None:
    text, reason = BAD[what]
    (tmp_path / "bad.js").write_text(f"{text}\n")
    with pytest.raises(pytest.fail.Exception, match=reason):
        oxlint(tmp_path / "bad.js")


def test_generated_files_are_current() -> None:
    check("python", "scripts/generate_bake.py", "--check")


def test_makefile_lists_its_commands() -> None:
    """Every target that a user may call is in the list that ``make`` alone prints."""
    listed = subprocess.run(["make"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    [named] = re.findall(r"^COMMANDS := ((?:.*\\\n)*.*)$", (ROOT / "Makefile").read_text(), re.MULTILINE)
    assert sorted(line.split()[1] for line in listed.splitlines() if line.startswith("  make ")) == sorted(
        named.replace("\\", "").split()
    )
