"""What short commands take, here and at another commit: in turns, with the same interpreter and packages."""

from __future__ import annotations

import os
import shutil
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from bench.results import Result, Row
from rosml import ROOT
from rosml.base.errors import RosmlError

ROUNDS = 9
"""Calls of each command in each checkout, of which the median counts. One call before them fills the caches."""

IMAGE = "ros1-bookworm-base-torch-cu130"

ROSML = ("-c", "import sys; sys.argv[0] = 'rosml'; from rosml.cli.main import run; sys.exit(run())")
"""What the installed command does."""

GOALS = {
    "rosml --help": 0.12,
    f"rosml explain {IMAGE}": 0.25,
    "rosml list": 0.25,
    "rosml generate --check": 0.5,
    f"docker buildx bake --print {IMAGE}": 1.0,
}
"""Seconds that each command may take."""

WHAT = ("help", "what an image is made of", "the list of images", "whether the bake files are up to date",
        "one target as buildx sees it")  # fmt: skip


def measure(commit: str, say: Callable[[str], None]) -> Result:
    """Calls each command in both checkouts in turns.

    Args:
        commit: what is compared with this checkout.

    Raises:
        RosmlError: git does not know the commit, or a command failed.
    """
    rows = []
    with _checkout(commit) as before:
        for what, (command, goal) in zip(WHAT, GOALS.items(), strict=True):
            say(command)
            sides = [statistics.median(seconds) for seconds in _turns(command, (before, ROOT))]
            rows.append(Row(what, sides, "s", f"{goal} s", sides[-1] <= goal, command))
    return Result("commands", f"python -m bench commands --before {commit}", (f"at {commit}", "now"), rows)


def _turns(command: str, folders: Sequence[Path]) -> list[list[float]]:
    """Seconds of each call, for each checkout."""
    for folder in folders:
        _seconds(command, folder)
    rounds = [[_seconds(command, folder) for folder in folders] for _ in range(ROUNDS)]
    return [list(seconds) for seconds in zip(*rounds, strict=True)]


def _seconds(command: str, folder: Path) -> float:
    program, *words = command.split()
    argv = [sys.executable, *ROSML, *words] if program == "rosml" else [str(ROOT / ".state/bin/buildx"), *words[1:]]
    env = {**os.environ, "PYTHONPATH": str(folder / "src")}
    begun = time.perf_counter()
    done = subprocess.run(argv, cwd=folder, env=env, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    took = time.perf_counter() - begun
    if done.returncode:
        raise RosmlError(f"{command} failed in {folder}:\n{done.stderr.decode(errors='replace').strip()}")
    return took


@contextmanager
def _checkout(commit: str) -> Iterator[Path]:
    """A checkout of a commit, as long as this lasts."""
    folder = ROOT / ".state/bench" / commit
    shutil.rmtree(folder, ignore_errors=True)
    _git("worktree", "prune")
    _git("worktree", "add", "--detach", str(folder), commit)
    try:
        yield folder
    finally:
        _git("worktree", "remove", "--force", str(folder))


def _git(*words: str) -> None:
    done = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, check=False)
    if done.returncode:
        raise RosmlError(f"git {words[0]} {words[1]} failed: {done.stderr.strip()}", "is it a commit of this checkout?")
