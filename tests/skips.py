"""No test is skipped for free: a skip fails the run unless `tests/skips.yaml` lists the test and the reason."""

from __future__ import annotations

import fnmatch
import re
from collections.abc import Generator, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import pytest
import yaml

FILE = Path(__file__).with_name("skips.yaml")


@dataclass(frozen=True)
class Leave:
    """Leave for some tests to skip.

    Attributes:
        test: the tests' ids below tests/, as a shell pattern. reason: a regular expression for the whole reason.
    """

    test: str
    reason: str

    def covers(self, test: str, reason: str) -> bool:
        """Whether it is about a test and the reason that it gives."""
        return fnmatch.fnmatchcase(test, self.test) and re.fullmatch(self.reason, reason) is not None


def listed(file: Path = FILE) -> list[Leave]:
    """What the committed list allows."""
    return [Leave(entry["test"], entry["reason"]) for entry in yaml.safe_load(file.read_text(encoding="utf-8")) or []]


def refusal(test: str, reason: str, leaves: Iterable[Leave]) -> str:
    """Why a skip fails the run; empty where it is on the list.

    Args:
        test: the id of a test, or of a file that skips as a whole, below the checkout.
    """
    reason = reason.removeprefix("Skipped: ")
    if any(leave.covers(test.removeprefix("tests/"), reason) for leave in leaves):
        return ""
    return (
        f"{test} was skipped: {reason}\n"
        "A skip fails the run. Install what the reason names, or list the test and its reason in tests/skips.yaml."
    )


LEAVES = listed()

Report = TypeVar("Report", pytest.TestReport, pytest.CollectReport)


def _refuse(report: Report) -> Report:
    """Makes a failure of a skip that is not on the list."""
    if hasattr(report, "wasxfail"):
        del report.wasxfail
        report.outcome, report.longrepr = "failed", f"{report.nodeid}: a test that is expected to fail proves nothing"
        return report
    if not report.skipped or not isinstance(report.longrepr, tuple):
        return report
    if said := refusal(report.nodeid, report.longrepr[2], LEAVES):
        report.outcome = "failed"
        report.longrepr = said
    return report


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    return _refuse((yield))


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    return _refuse((yield))
