"""A time limit for each test: one that hangs fails under its own name, and the others go on."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parent

SECONDS = {"lint": 600, "unit": 300, "page": 120, "e2e": 900}
"""By folder: many times what a test takes on a busy machine. A test that takes longer says so: ``@pytest.mark.timeout``."""

PROOF_SECONDS = 3600
"""For a test that only `make test-all` runs: its images are the large ones."""


def set_limits(items: Sequence[pytest.Item]) -> None:
    """Gives each test the limit of its folder, if it has none of its own."""
    for item in items:
        if item.get_closest_marker("timeout") is None:
            folder = item.path.relative_to(TESTS).parts[0]
            if folder not in SECONDS:
                raise pytest.UsageError(f"{item.path}: tests lie in one of tests/{', tests/'.join(SECONDS)}")
            seconds = PROOF_SECONDS if item.get_closest_marker("full") else SECONDS[folder]
            item.add_marker(pytest.mark.timeout(seconds))
