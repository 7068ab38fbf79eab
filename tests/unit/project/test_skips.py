"""A skip fails the run, of a test and of a whole file, unless the committed list has the test and its reason."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests import skips
from tests.skips import Leave

ROOT = Path(__file__).resolve().parents[3]

FILE = """\
import pytest

def test_passes(): pass

@pytest.mark.skip("no gpg on this machine")
def test_marked(): pass

def test_called(): pytest.skip("about this project's own matrix and documentation, of which this is a fork")
"""


def run(folder: Path, text: str) -> subprocess.CompletedProcess[str]:
    """Runs a file of tests in a child, with the hooks that all tests have."""
    (folder / "test_one.py").write_text(text)
    command = [sys.executable, "-m", "pytest", "-p", "tests.skips", "--rootdir", str(folder), "-c", "/dev/null"]
    return subprocess.run([*command, str(folder)], cwd=ROOT, capture_output=True, text=True, check=False)


def test_a_run_with_a_skip_fails(tmp_path: Path) -> None:
    done = run(tmp_path, FILE)
    assert done.returncode == 1
    assert "test_one.py::test_marked was skipped: no gpg on this machine" in done.stdout
    assert "1 passed, 1 skipped, 1 error" in done.stdout


@pytest.mark.parametrize(
    ("test", "reason", "refused"),
    [
        ("tests/e2e/test_fleet.py::test_one[a]", "Docker is the builder", False),
        ("tests/e2e/test_fleet.py::test_one", "Skipped: Docker is the builder", False),
        ("tests/e2e/test_fleet.py::test_one", "Docker is the builder here", True),
        ("tests/e2e/test_fleets.py::test_one", "Docker is the builder", True),
    ],
)
def test_the_test_and_the_whole_reason_count(test: str, reason: str, refused: bool) -> None:
    leaves = [Leave("e2e/test_fleet.py::*", "Docker is the builder")]
    assert bool(skips.refusal(test, reason, leaves)) == refused
