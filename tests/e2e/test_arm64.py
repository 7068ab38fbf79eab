"""Images for the other architecture, built and tested under emulation: import, arithmetic, C++ programs, ROS that talks.

On two cores it takes half an hour; `make test-all PROOF=arm64` runs it.
"""

from __future__ import annotations

import json

import pytest

from rosml.images.builds import base_images
from tests.e2e.calls import publish

OTHER = "amd64" if base_images.native_architecture() == "arm64" else "arm64"


@pytest.mark.full(proof="arm64")
def test_both_frameworks_on_the_other_architecture() -> None:
    outcome = publish("ros1-bookworm-core-ml-cpu", "--platform", f"linux/{OTHER}")
    assert outcome.code == 0, outcome.err
    result = json.loads(outcome.out)
    assert result["failed"] == 0
    assert result["passed"] > 20
    assert not result["tags"]
