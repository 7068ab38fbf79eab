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

from rosml import ROOT
from rosml.base.errors import RosmlError

ROUNDS = 15
"""Pairs of calls, of which the median counts."""

WORDS = ("run", "--rm", "ubuntu", "true")

ENGINE = """\
#!/bin/sh
echo "$*" >>"$0.calls"
case $1 in
  info) echo '{"ServerVersion": "28.2.2"}' ;;
  image) echo '{"Id": "sha256:1", "Config": {"Env": ["DOCKER_UID="]}}' ;;
esac
"""

ROSML = (sys.executable, "-c", "import sys; sys.argv[0] = 'rosml'; from rosml.cli.main import run; sys.exit(run())")
"""What the installed command does."""


def seconds() -> float:
    """The median of what a call takes longer.

    Raises:
        RosmlError: a call failed, or started nothing.
    """
    with tempfile.TemporaryDirectory() as folder:
        engine = Path(folder, "docker")
        engine.write_text(ENGINE)
        engine.chmod(0o755)
        return statistics.median(_seconds(engine, ROSML) - _seconds(engine, [str(engine)]) for _ in range(ROUNDS))


def _seconds(engine: Path, program: Sequence[str]) -> float:
    calls = engine.with_name("docker.calls")
    calls.write_text("")
    env = {
        "PATH": f"{engine.parent}:{os.environ['PATH']}",
        "PYTHONPATH": str(ROOT / "src"),
        "HOME": str(engine.parent),
    }
    begun = time.perf_counter()
    done = subprocess.run([*program, *WORDS], env=env, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    took = time.perf_counter() - begun
    if done.returncode or "\nrun " not in f"\n{calls.read_text()}":
        raise RosmlError(f"{' '.join(WORDS)} failed:\n{done.stderr.decode(errors='replace').strip()}")
    return took
