"""Which tests are about this project's own matrix and documentation, and mean nothing where a fork has another matrix.

A fork is a checkout without tests/unit/test_design.py: docs/extend.md tells forks to delete that file.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
FORK = not (ROOT / "tests/unit/test_design.py").is_file()
REASON = "about this project's own matrix and documentation, of which this is a fork"

OURS = frozenset(
    {
        "unit/test_built.py::test_newer_records_take_the_place_of_older_ones",
        "unit/test_built.py::test_results_of_a_checkout_are_recorded",
        "unit/test_built.py::test_the_readme_tells_what_was_built",
        "unit/test_built.py::test_what_is_committed_is_of_this_matrix",
    }
)
"""Files, or tests of them, below tests/; folders with a slash at their end."""


def skip_ours(items: Iterable[pytest.Item]) -> None:
    """Skips in a fork what is about the matrix that it was forked from."""
    for item in items:
        file = item.path.relative_to(ROOT / "tests").as_posix()
        name = f"{file}::{getattr(item, 'originalname', item.name)}"
        if FORK and any(ours in (file, name) or (ours.endswith("/") and file.startswith(ours)) for ours in OURS):
            item.add_marker(pytest.mark.skip(reason=REASON))
