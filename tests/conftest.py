"""The tests find the same environment however they are started, and no skip is free."""

from __future__ import annotations

import os
import signal
import subprocess

import pytest

from tests.fork import skip_ours
from tests.limits import set_limits
from tests.proofs import PROOFS
from tests.skips import pytest_make_collect_report, pytest_runtest_makereport  # noqa: F401 (hooks)

if not __debug__:
    raise pytest.UsageError("python -O leaves assertions out: unset PYTHONOPTIMIZE")
for name in ("MAKELEVEL", "MAKEFLAGS", "MFLAGS", "PROOF", "SHARD"):  # a make that a test calls is not a sub-make
    os.environ.pop(name, None)
# Nor are its repositories the one whose hook calls the tests.
local = subprocess.run(["git", "rev-parse", "--local-env-vars"], capture_output=True, text=True, check=True).stdout
for name in local.split():
    os.environ.pop(name, None)
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as nohup and some CI leave it; tests send it to programs
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    skip_ours(items)
    set_limits(items)
    for item in items:
        for mark in item.iter_markers("full"):
            if mark.args or mark.kwargs.get("proof") not in PROOFS:
                raise pytest.UsageError(f"{item.nodeid}: mark it full(proof=NAME), a name of tests/proofs.py")
