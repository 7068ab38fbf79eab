"""Calls of uv, which resolves requirements: several at a time, and all ended at once."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from typing import TypeVar

from rosml.base import progress_bar
from rosml.base.errors import RosmlError

Item = TypeVar("Item")
Result = TypeVar("Result")

WORKERS = 8
"""How many resolutions run at a time. They mostly wait for the indexes."""

_CHANGING = frozenset(
    {"UV_RESOLUTION", "UV_PRERELEASE", "UV_EXCLUDE_NEWER", "UV_CONSTRAINT", "UV_OVERRIDE", "UV_TORCH_BACKEND"}
)
"""Settings of uv that would change the result. The user's indexes and caches stay."""


class Uv:
    """Runs uv in several threads at a time. Another thread can end all of them."""

    def __init__(self, command: str = "uv") -> None:
        self.command = command
        self._running: set[subprocess.Popen[str]] = set()
        self._ended = False
        self._lock = threading.Lock()

    def __call__(self, arguments: Sequence[str], folder: Path) -> tuple[int, str]:
        """Runs uv in a folder. Returns its exit status and its standard error."""
        command = [self.command, *arguments]
        environment = {name: value for name, value in os.environ.items() if name not in _CHANGING}
        pipe = subprocess.PIPE
        with self._lock:
            if self._ended:
                raise RosmlError("interrupted")
            try:
                process = subprocess.Popen(
                    command, cwd=folder, env=environment, stdout=pipe, stderr=pipe, text=True, errors="replace"
                )
            except FileNotFoundError:
                raise RosmlError(f"'{self.command}' is not installed", "run 'rosml setup', which installs it") from None
            self._running.add(process)
        with process:
            _, errors = process.communicate()
        with self._lock:
            self._running.discard(process)
        return process.returncode, errors

    def compile(
        self, arguments: Sequence[str], inputs: Mapping[str, str], output: str = "out.txt"
    ) -> tuple[int, str, str]:
        """Runs uv beside files with these texts. Returns its exit status, what it wrote, if anything, and its standard error."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in inputs.items():
                Path(folder, name).write_text(text)
            status, errors = self([*arguments, "--output-file", output], Path(folder))
            file = Path(folder, output)
            return status, file.read_text(encoding="utf-8", errors="replace") if file.is_file() else "", errors

    def for_each(
        self, items: Iterable[Item], work: Callable[[Item], Result], title: str, report: Callable[[int, Result], object]
    ) -> list[Result]:
        """The results of work that calls uv, in the order of the items. An error, also Ctrl-C, ends all calls at once."""
        with ThreadPoolExecutor(WORKERS) as pool:
            futures = [pool.submit(work, item) for item in items]
            try:
                for number, future in enumerate(progress_bar.over(as_completed(futures), title, len(futures)), 1):
                    report(number, future.result())
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                self.end()
                raise
            return [future.result() for future in futures]

    def end(self) -> None:
        """Ends all calls, and starts no more: uv waits minutes for an index that does not answer."""
        with self._lock:
            self._ended = True
            for process in self._running:
                process.terminate()


def with_glibc(wheels: str, glibc: int) -> str:
    """uv's name of a platform of wheels, with glibc 2.N instead of the one in it."""
    return re.sub(r"manylinux_2_\d+", f"manylinux_2_{glibc}", wheels)


def compile_command(python: str, wheels: str) -> list[str]:
    """The beginning of every resolution's command, for a version of Python and uv's name of a platform of wheels.

    It names this process' own interpreter, of any version, as nothing is built with it. Otherwise uv downloads an interpreter of each
    version, or tries to for ten seconds each time.
    """
    quiet = ["pip", "compile", "--quiet", "--no-config", "--python", sys.executable, "--only-binary", ":all:"]
    return [*quiet, "--python-version", python, "--python-platform", wheels]
