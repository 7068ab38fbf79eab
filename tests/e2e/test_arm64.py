"""Images for arm64, built and tested under emulation: import, arithmetic, C++ programs, ROS that talks.

On two cores it takes half an hour, so `make test` leaves it out; `make test-arm64` runs it.
"""

from __future__ import annotations

import json
import os

import pytest

from rosml import base_images
from tests.e2e.conftest import publish

FOREIGN = base_images.native_architecture() != "arm64"
"""On a machine for arm64 these are the images of all other tests."""


@pytest.mark.skipif(not os.environ.get("ROSML_TEST_ARM64"), reason="half an hour under emulation: make test-arm64")
@pytest.mark.skipif(not FOREIGN, reason="this machine is for arm64: test_images.py builds for it")
def test_both_frameworks_on_arm64() -> None:
    outcome = publish("bookworm-core-ml-cpu", "--platform", "linux/arm64")
    assert outcome.code == 0, outcome.err
    result = json.loads(outcome.out)
    assert result["failed"] == 0
    assert result["passed"] > 20
    assert not result["tags"]
