"""What `rosml run` takes longer than `docker run`: the engine is a script that writes down its calls and answers at once."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

from bench.limits import Held
from rosml import ROOT
from rosml.base.errors import RosmlError

ROUNDS = 15
"""Pairs of calls, of which the median counts."""

SECONDS = 0.1
"""What `rosml run` may take longer."""

WORDS = ("run", "--rm", "ubuntu", "true")

ENGINE = """\
#!/bin/sh
echo "$*" >>"$0.calls"
case $1 in
  info) echo '{"ServerVersion": "28.2.2"}' ;;
  image) echo '{"Id": "sha256:1", "Config": {"Env": ["DOCKER_UID="]}}' ;;
esac
"""

ROSML = "import sys; sys.argv[0] = 'rosml'; from rosml.cli.main import run; sys.exit(run())"
"""What the installed command does."""


def held() -> Held:
    """The median beside its limit.

    Raises:
        RosmlError: a call failed, or started nothing.
    """
    with tempfile.TemporaryDirectory() as folder:
        engine = Path(folder, "docker")
        engine.write_text(ENGINE)
        engine.chmod(0o755)
        pairs = [
            (_seconds(engine, [sys.executable, "-c", ROSML]), _seconds(engine, [str(engine)])) for _ in range(ROUNDS)
        ]
    return Held("rosml run, beyond docker run", statistics.median(ours - theirs for ours, theirs in pairs), SECONDS)


def _seconds(engine: Path, program: Sequence[str]) -> float:
    """How long a call takes.

    Raises:
        RosmlError: it failed, or started nothing.
    """
    calls = engine.with_name("docker.calls")
    calls.unlink(missing_ok=True)
    environment = {
        "PATH": f"{engine.parent}:{os.environ['PATH']}",
        "PYTHONPATH": str(ROOT / "src"),
        "HOME": str(engine.parent),
    }
    begun = time.perf_counter()
    done = subprocess.run(
        [*program, *WORDS], env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
    )
    seconds = time.perf_counter() - begun
    if done.returncode or not any(line.startswith("run ") for line in calls.read_text().splitlines()):
        raise RosmlError(f"{' '.join(WORDS)} failed:\n{done.stderr.strip()}")
    return seconds
