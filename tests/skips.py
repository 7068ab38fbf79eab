"""No test is skipped silently: a skip fails the run unless its reason is listed here. pytest prints the others at its end."""

from __future__ import annotations

from collections.abc import Generator
from typing import TypeVar

import pytest

from tests import fork

REASONS = (
    fork.REASON,
    "Docker is the builder here, and these tests start and kill a buildkitd of their own",
    "Docker is the builder here, and somebody else may not call it",
    "Docker is the builder here, and only root may mount a file system",
    "Docker Hub answers: its base images are used",
    "this machine has only a loopback address, where a registry without certs.d speaks plain http",
    "no buildx on this machine; 'rosml setup' installs it",  # make unit does without; make test sets it up
    "no podman with a generator of units is here",
    "no podman is here that needs no root: 'make test-packages' installs it",
    "no Docker before 23 is here",
    "no current Docker is here: 'rosml setup engine' builds one",
    "no xauth is here",
    "no Python as old as the oldest one of the matrix is here, nor can it be downloaded",
)
"""What a machine may lack. docs/status.md says what stays unproved there."""

Report = TypeVar("Report", pytest.TestReport, pytest.CollectReport)


def _refuse(report: Report) -> Report:
    """Makes a failure of a skip, or of an expected failure, for any other reason."""
    if not report.skipped:
        return report
    reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
    reason = reason.removeprefix("Skipped: ")
    if reason not in REASONS:
        report.outcome = "failed"
        report.longrepr = f"{report.nodeid} was skipped: {reason}\nInstall what it names, or list it in tests/skips.py."
    return report


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    return _refuse((yield))


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    return _refuse((yield))
