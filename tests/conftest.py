"""The tests find the same environment however they are started: a make that a test calls is not a sub-make, and Ctrl-C is
not ignored."""

from __future__ import annotations

import os
import signal

import pytest

from tests.fork import skip_ours

for name in ("MAKELEVEL", "MAKEFLAGS", "MFLAGS"):
    os.environ.pop(name, None)
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:  # as nohup and some CI leave it; tests send it to programs
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    skip_ours(items)
