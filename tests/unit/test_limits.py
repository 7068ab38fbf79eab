"""Time limits of the tests: each has one, and one that hangs is named."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

CONFTEST = """\
from tests import limits

limits.SECONDS["unit"] = 1


def pytest_collection_modifyitems(items):
    limits.set_limits(items)
"""
TESTS = """\
import time

import pytest


def test_hangs():
    time.sleep(600)


@pytest.mark.timeout(300)
def test_takes_longer():
    time.sleep(1.5)
"""


def test_a_test_that_hangs_fails_under_its_name_and_the_others_go_on(tmp_path: Path) -> None:
    folder = tmp_path / "unit"
    folder.mkdir()
    (tmp_path / "conftest.py").write_text(CONFTEST)
    (folder / "test_two.py").write_text(TESTS)
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--rootdir", str(tmp_path), "unit"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 1, done.stdout + done.stderr
    assert "FAILED unit/test_two.py::test_hangs - Failed: Timeout" in done.stdout
    assert "1 failed, 1 passed" in done.stdout


def test_each_test_has_a_limit(request: pytest.FixtureRequest) -> None:
    assert [item.nodeid for item in request.session.items if item.get_closest_marker("timeout") is None] == []
