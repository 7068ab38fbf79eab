"""Shows BuildKit's progress as lines for people.

The input is `buildx --progress rawjson`: one JSON object a line, with steps (`vertexes`) that start and end, and their output
(`logs`, base64).
"""

from __future__ import annotations

import base64
import binascii
import re
import shutil
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from datetime import datetime
from typing import TextIO

from rosml.base import untrusted
from rosml.base.terminal import shown

_PREFIX = re.compile(r"^\[(?P<context>[^\]]*)\]\s*+(?P<command>.*)$")
_STAGE = re.compile(r"^\[(?:[^]]* )?(?P<stage>\S+) +\d+/\d+\] ")
_PART = re.compile(r"^\[(?:_files-|part-)?(?P<part>\S+) part-files [^]]*\] .*/assemble\.sh")
_MOUNT = re.compile(r"--mount=\S+\s*")
_WORD = re.compile(r'"([^"\\]*)",?')
_JSON = frozenset('{["-0123456789ntf')
_START = re.compile(r"^\S+/step\.sh ")

HEARTBEAT_SECONDS = 20.0
"""If a step is silent for so long, its name is printed again."""

WIDEST = 150
"""Characters of a line that is shown, unless a terminal has fewer columns."""

TAIL_LINES = 20
"""How many of a step's last lines are shown if it fails."""

LONGEST_LINE = 64 << 10
"""Bytes of a line without an end, such as a progress bar. A longer one counts as several lines."""

KEPT_LINES = 200
"""uv prints every hash that it would have accepted, so the reason may be far above the last lines."""


@dataclass
class Step:
    """One step of a build. `name` is BuildKit's, e.g. ``[ros1-bookworm-core ros 1/2] RUN …``; times are seconds since the epoch, 0.0 for none."""

    name: str
    started: float = 0.0
    completed: float = 0.0
    cached: bool = False
    error: str = ""
    tail: deque[str] = field(default_factory=lambda: deque(maxlen=KEPT_LINES))

    @property
    def seconds(self) -> float:
        """The duration; 0.0 for a step that was cached or has not ended."""
        return max(0.0, self.completed - self.started) if self.completed and not self.cached else 0.0

    @property
    def label(self) -> str:
        """The step for people, without its mounts and the script that starts it."""
        match = _PREFIX.match(self.name)
        if not match:
            return self.name
        context, command = match["context"], match["command"]
        if part := _PART.match(self.name):
            return f"build part {part['part']} from its lock"
        command = _MOUNT.sub("", command).replace("RUN ", "", 1).strip()
        if command.startswith('["/'):
            command = _START.sub("", " ".join(_WORD.findall(command)))
        return f"[{context}] {' '.join(command.split())}"

    @property
    def stage(self) -> str:
        """The stage of the Dockerfile; empty for BuildKit's own steps."""
        match = _STAGE.match(self.name)
        return match["stage"] if match else ""

    @property
    def internal(self) -> bool:
        return "internal]" in self.name or " context " in self.name.split("]")[0] or "LINK COPY" in self.name


def _seconds(timestamp: str) -> float:
    """Seconds since the epoch of an RFC 3339 time with any number of digits; 0.0 for Go's zero time, and for any other text."""
    if not timestamp or timestamp.startswith("0001"):
        return 0.0
    try:
        return datetime.fromisoformat(timestamp).timestamp()
    except (ValueError, OverflowError):
        return 0.0


def _message(line: str) -> dict[str, object] | None:
    """The object of a line, empty for another value; None if the line is no JSON."""
    if line[:1] not in _JSON:  # most lines that are none end here, without an exception
        return None
    try:
        value = untrusted.json_value(line)
    except ValueError:
        return None
    return value if isinstance(value, dict) else {}


def _objects(value: object) -> list[dict[str, object]]:
    return [item for item in value if isinstance(item, dict)] if isinstance(value, list) else []


class BuildProgress:
    """Follows one build: prints a line for people when a step of some length ends, and keeps all steps.

    Args:
        log: gets everything, as plain text.
        summary: what the build does, in place of lines about its steps; empty to show these.
        hidden: texts that no line of a step shows.
    """

    def __init__(
        self,
        out: TextIO = sys.stderr,
        log: TextIO | None = None,
        clock: Callable[[], float] = time.monotonic,
        summary: str = "",
        hidden: Iterable[str] = (),
    ) -> None:
        self.steps: dict[str, Step] = {}
        self.other: deque[str] = deque(maxlen=TAIL_LINES)
        self._out, self._log, self._clock, self._summary = out, log, clock, summary
        self._begin = self._spoke = clock()
        self._hidden = [text for text in hidden if text]
        self._lock = threading.Lock()
        self._unfinished: dict[tuple[str, str], bytes] = {}

    def follow(self, lines: Iterable[str]) -> None:
        ended = threading.Event()

        def beat() -> None:
            while not ended.wait(HEARTBEAT_SECONDS / 4):
                with self._lock:
                    self._heartbeat()

        thread = threading.Thread(target=beat, daemon=True)
        thread.start()
        try:
            for line in lines:
                with self._lock:
                    self.feed(line)
        finally:
            ended.set()
            thread.join()
            for vertex in {vertex for vertex, _ in self._unfinished}:
                self._end_lines(vertex)

    def feed(self, line: str) -> None:
        """Takes one line. Lines that are no JSON (warnings, errors of the command itself) are kept for the error message."""
        message = _message(line)
        if message is None:
            if line := line.rstrip():
                self.other.append(line)
                self._write_log(line)
            return
        for vertex in _objects(message.get("vertexes")):
            self._vertex(vertex)
        for log in _objects(message.get("logs")):
            self._logs(log)
        self._heartbeat()

    def failed(self) -> Step | None:
        """The first failed step, apart from those that were cancelled because of it."""
        errors = (step for step in self.steps.values() if step.error and "context canceled" not in step.error)
        return next(errors, None)

    def _vertex(self, vertex: dict[str, object]) -> None:
        digest = str(vertex.get("digest", ""))
        step = self.steps.setdefault(digest, Step(str(vertex.get("name", ""))))
        step.name = str(vertex.get("name") or step.name)
        step.started = step.started or _seconds(str(vertex.get("started") or ""))
        step.cached = step.cached or bool(vertex.get("cached"))
        step.error = str(vertex.get("error") or step.error)
        completed = _seconds(str(vertex.get("completed") or ""))
        if completed and not step.completed:
            self._end_lines(digest)
            step.completed = completed
            self._write_log(f"{'CACHED' if step.cached else f'{step.seconds:.1f} s'} {step.name} {step.error}".rstrip())
            quiet = self._summary or step.internal or step.cached or step.error
            if not quiet and step.seconds >= 0.5:
                self.say(f"{step.seconds:6.1f} s  {step.label}")

    def _logs(self, log: dict[str, object]) -> None:
        """Takes the output of a step, in pieces of any size: a program that writes to a pipe may send a line word by word."""
        source = str(log.get("vertex", "")), str(log.get("stream", ""))
        try:
            data = base64.b64decode(str(log.get("data") or ""), validate=True)
        except (binascii.Error, ValueError):
            return
        whole, end, rest = (self._unfinished.pop(source, b"") + data).rpartition(b"\n")
        if len(rest) > LONGEST_LINE:
            whole, end, rest = whole + end + rest, b"", b""
        self._print(source[0], whole)
        if rest:
            self._unfinished[source] = rest

    def _end_lines(self, vertex: str) -> None:
        for source in [source for source in self._unfinished if source[0] == vertex]:
            self._print(vertex, self._unfinished.pop(source))

    def _print(self, vertex: str, data: bytes) -> None:
        step = self.steps.get(vertex)
        output = data.decode(errors="replace")
        for text in self._hidden:
            output = output.replace(text, "***")
        for line in output.splitlines():
            self._write_log(f"    {line}")
            if step is not None and line.strip():
                step.tail.append(line.rstrip())

    def _heartbeat(self) -> None:
        if self._clock() - self._spoke < HEARTBEAT_SECONDS:
            return
        if self._summary:
            self.say(f"   …      {self._summary}")
            return
        running = [step for step in self.steps.values() if step.started and not step.completed and not step.internal]
        if running:
            step = min(running, key=lambda item: item.started)
            last = f": {step.tail[-1].strip()}" if step.tail else ""
            self.say(f"   …      {step.label}{last}")

    def say(self, text: str) -> None:
        """Prints a line, with the time since the beginning."""
        self._spoke = self._clock()
        elapsed = int(self._clock() - self._begin)
        line = f"  {elapsed // 60:3d}:{elapsed % 60:02d}  {shown(text)}"
        wide = min(WIDEST, shutil.get_terminal_size((WIDEST, 0)).columns) if self._out.isatty() else WIDEST
        self._out.write((line if len(line) <= wide else line[: wide - 1] + "…") + "\n")
        self._out.flush()

    def _write_log(self, text: str) -> None:
        if self._log is not None:
            self._log.write(shown(text) + "\n")
