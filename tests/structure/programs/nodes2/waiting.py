"""Waiting that ends with a sentence: what was waited for, and for how long."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

SECONDS = 60
"""Longest wait for one thing; a second or two are usual."""


def until(what: str, holds: Callable[[], Any], step: Callable[[], Any], seconds: float = SECONDS) -> Any:
    """Takes steps until something holds, and returns it."""
    end = time.monotonic() + seconds
    while not (value := holds()):
        if time.monotonic() > end:
            sys.exit(f"waited {seconds} s in vain: {what}")
        step()
    return value


def answer(what: str, future: Any, step: Callable[[], Any]) -> Any:
    """The result of a future of rclpy."""
    until(what, future.done, step)
    return future.result()


def says(command: list[str], words: str) -> None:
    """A command says something within its time, if not at the first try: other nodes are found little by little."""
    output = ""

    def tried() -> bool:
        nonlocal output
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            sys.exit(f"`{' '.join(command)}` did not end within {SECONDS} s")
        output = done.stdout + done.stderr
        return done.returncode == 0 and words in done.stdout

    end = time.monotonic() + SECONDS
    while not tried():
        if time.monotonic() > end:
            sys.exit(f"`{' '.join(command)}` did not say '{words}' within {SECONDS} s, but:\n{output}")
        time.sleep(0.2)
