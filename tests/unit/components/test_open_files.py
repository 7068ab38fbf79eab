"""How many files a container's programs may open: what is sourced before each command, in a real bash."""

from __future__ import annotations

import resource
import subprocess

import pytest
from conftest import ROOT

LIMIT = "1048576"


@pytest.mark.parametrize(
    ("soft", "hard", "limits"),
    [(64, 128, "64 128"), (64, 8192, "64 512"), (8192, 8192, "512 512")],
    ids=["few", "a hard limit of many", "many"],
)
def test_a_limit_of_many_files_is_lowered(soft: int, hard: int, limits: str) -> None:
    """Each node of roscpp takes memory for all of them. Here, 512 stand for the limit, which not every machine can exceed."""
    text = (ROOT / "components/base/setup.bash").read_text()
    script = f"set -u; {text.replace(LIMIT, '512')}\necho $(ulimit -Sn) $(ulimit -Hn)"
    done = subprocess.run(
        ["/bin/bash", "-c", script],
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard)),
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.stdout.split(), done.stderr) == (limits.split(), "")
