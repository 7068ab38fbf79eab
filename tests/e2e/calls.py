"""Commands as people call them; in the tests' namespace of the registry, where they move no tag that somebody uses."""

from __future__ import annotations

import logging
import os
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosml import ROOT

NAMESPACE = "rosml-test"
LOG = logging.getLogger("e2e")

HANGS = 720.0
"""Seconds after which a command that a test waits for hangs; less than a test's own limit (tests/limits.py)."""


@dataclass(frozen=True)
class Run:
    """A command that ended: exit code, standard output, standard error."""

    code: int
    out: str
    err: str


def run(*command: str, cwd: Path = ROOT, env: dict[str, str] | None = None) -> Run:
    """Runs a command; its progress lines appear in the test's log while it works."""
    process = subprocess.Popen(
        command,
        cwd=cwd,
        env={**os.environ, **(env or {})},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stderr and process.stdout
    lines = []
    for line in process.stderr:
        LOG.info("%s", line.rstrip())
        lines.append(line)
    return Run(process.wait(), process.stdout.read(), "".join(lines))


def succeeds(*command: str, cwd: Path = ROOT, env: dict[str, str] | None = None) -> Run:
    """Runs a command that must end with 0."""
    outcome = run(*command, cwd=cwd, env=env)
    assert outcome.code == 0, outcome.err + outcome.out
    return outcome


def rosml(*words: str, root: Path = ROOT, env: dict[str, str] | None = None) -> Run:
    """A call of a checkout's rosml that must end with 0."""
    return succeeds(sys.executable, str(root / "src"), *words, cwd=root, env=env)


def wait_until(
    done: Callable[[], bool], seconds: float, state: Callable[[], object], process: subprocess.Popen[Any] | None = None
) -> None:
    """Waits for something; fails with its state after some seconds, or once a process has ended."""
    end = time.monotonic() + seconds
    while not done():
        assert (process is None or process.poll() is None) and time.monotonic() < end, state()
        time.sleep(0.1)


def publish(target: str, *options: str, root: Path = ROOT) -> Run:
    """`rosml image`, as `make image` calls it."""
    program = (sys.executable, str(root / "src"))
    return run(*program, "image", target, "--namespace", NAMESPACE, "--json", *options, cwd=root)
