"""The recording of a first session, docs/casts/first.cast: its commands are recorded, drawn as a picture, and compared by tests with
what the same commands say now.

    .venv/bin/python -m tests.recording         record all commands, and draw
    .venv/bin/python -m tests.recording list    record one of them, and draw
    .venv/bin/python -m tests.recording draw    only draw

It needs `rosml setup`, the image ros1-bookworm-core in the local registry, and Docker, or a dockerd that it may start.
"""

from __future__ import annotations

import fcntl
import json
import os
import pty
import re
import shutil
import struct
import sys
import tempfile
import termios
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from html import escape
from pathlib import Path

from rosml import ROOT
from rosml.machine.progress import Step
from rosml.machine.services import Services
from tests.e2e import engine

CAST = ROOT / "docs/casts/first.cast"
"""A cast of format 2: https://docs.asciinema.org/manual/asciicast/v2/. A marker begins each command."""

PICTURE = ROOT / "docs/images/first.svg"
BASE = "ros1-bookworm-core"
COMMANDS = {
    "list": "./rosml list jazzy torch cu130",
    "containerize": f"./rosml containerize ~/compass --base-image ros:{BASE} --command 'roslaunch compass compass.launch'",
    "run": "rospack find compass",
}
"""What is typed, by the marker. `run` follows the line `try` of `containerize`, which names the image."""

WIDTH, ROWS = 100, 24
"""Characters and lines of the terminal."""

THINKING, LONGEST = 1.0, 1.5
"""Seconds in the picture between two commands, and the longest that it waits for a line."""


@dataclass(frozen=True)
class Event:
    """What appears on the terminal, and after how many seconds; or a marker, which begins a command."""

    seconds: float
    kind: str
    text: str


@dataclass(frozen=True)
class Command:
    """A command that was recorded: the line after the prompt, and what it printed, by seconds since it began."""

    typed: str
    events: tuple[Event, ...]

    @property
    def output(self) -> str:
        """All that it printed, as plain lines."""
        return plain("".join(event.text for event in self.events))


def plain(text: str) -> str:
    """What a terminal prints, without colours and returns."""
    return re.sub(r"\x1b\[[\d;]*m|\r", "", text)


# ---- The file --------------------------------------------------------------------------------------------------------


def read(file: Path = CAST) -> dict[str, Command]:
    """The commands of a cast, by their markers."""
    events_by_name: dict[str, list[Event]] = {}
    for line in file.read_text(encoding="utf-8").splitlines()[1:]:
        seconds, kind, text = json.loads(line)
        if kind == "m":
            events_by_name[text] = []
        else:
            events_by_name[list(events_by_name)[-1]].append(Event(seconds, kind, text))
    return {name: _command(events) for name, events in events_by_name.items()}


def _command(events: list[Event]) -> Command:
    first, *others = events
    events_after = tuple(Event(round(event.seconds - first.seconds, 2), event.kind, event.text) for event in others)
    return Command(plain(first.text).removeprefix("$ ").strip(), events_after)


def written(commands: Mapping[str, Command]) -> str:
    """The text of a cast."""
    size = {"version": 2, "width": WIDTH, "height": ROWS, "idle_time_limit": LONGEST}
    lines, now = [json.dumps({**size, "title": "rosml: a first session"})], 0.0
    for name, command in commands.items():
        begun = Event(now, "o", f"\x1b[1m$ {command.typed}\x1b[0m\r\n")
        events = [Event(now + event.seconds, event.kind, event.text) for event in command.events]
        for event in (Event(now, "m", name), begun, *events):
            lines.append(json.dumps([round(event.seconds, 2), event.kind, event.text], ensure_ascii=False))
        now = (events or [begun])[-1].seconds + THINKING
    return "\n".join(lines) + "\n"


# ---- Recording -------------------------------------------------------------------------------------------------------


def recorded(typed: str, home: Path, environment: Mapping[str, str]) -> Command:
    """Calls a command on a terminal, in the checkout. `home` is what `~` means."""
    child, terminal = pty.fork()
    if not child:
        fcntl.ioctl(1, termios.TIOCSWINSZ, struct.pack("HHHH", ROWS, WIDTH, 0, 0))
        os.chdir(ROOT)
        os.execvpe("bash", ["bash", "-c", typed], {**os.environ, **environment, "HOME": str(home), "TERM": "xterm"})
    begin, events, rest = time.monotonic(), list[Event](), b""
    while data := _chunk(terminal):
        whole, newline, rest = (rest + data).rpartition(b"\n")
        if newline:
            events.append(Event(round(time.monotonic() - begin, 2), "o", (whole + newline).decode()))
    if rest:
        events.append(Event(round(time.monotonic() - begin, 2), "o", rest.decode()))
    os.close(terminal)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    command = Command(typed, tuple(events))
    if code:
        sys.exit(f"{typed}: exit code {code}\n{command.output}")
    return command


def _chunk(terminal: int) -> bytes:
    try:
        return os.read(terminal, 65536)
    except OSError:  # the other end was closed
        return b""


def package(home: Path, fresh: bool = True) -> None:
    """A package in ~/compass. `fresh`: no build has anything of it in its cache."""
    shutil.copytree(ROOT / "examples/ros1", home / "compass")
    (home / "compass/.env").unlink()
    if fresh:
        with (home / "compass/src/compass/src/compass.cpp").open("a") as source:
            source.write(f"// {time.time_ns()}\n")


def image(containerized: Command) -> str:
    """The image that `containerize` made, by its last line."""
    return containerized.output.split()[-1]


def record(names: list[str]) -> dict[str, Command]:
    """Records commands; takes the others from the cast."""
    commands = read() if CAST.exists() else {}
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder)
        package(home)
        for name in names:
            if name == "run":
                reference = image(commands["containerize"])
                with engine.running() as docker:
                    variables = handed(docker, reference)
                    commands[name] = recorded(f"./rosml run {reference} {COMMANDS[name]}", home, variables)
            else:
                commands[name] = recorded(COMMANDS[name], home, {})
    return {name: commands[name] for name in COMMANDS}


def handed(docker: engine.Engine, reference: str) -> dict[str, str]:
    """Variables for the engine, which has the image already. An old one cannot pull what is compressed by zstd."""
    if docker.reads_zstd:
        docker.pull(reference)
        return dict(docker.environment)
    with tempfile.TemporaryDirectory() as folder:
        name = docker.image(Services.load(ROOT), reference, "recording", Path(folder))
    tagged = docker.docker("tag", name, reference)
    assert tagged.code == 0, tagged.err
    return dict(docker.environment)


# ---- Comparing -------------------------------------------------------------------------------------------------------

_STEP = re.compile(r"^(?: +\d+:\d\d +)?(?:[\d.]+ s|CACHED) +\[\S+ \S+ \d+/\d+\] .*$", re.MULTILINE)


def steps(output: str) -> set[str]:
    """The steps of a build that took long enough to be printed, or those of its log. Each is cut as it is printed, and lacks the
    target that came first."""
    names = (match[0].partition("[")[2].partition(" ")[2].rstrip("…") for match in _STEP.finditer(output))
    return {Step(f"[{step}").label.removeprefix("[") for step in names}


_CHANGES = re.compile(
    r" \([^()]* of it waiting for another build\)|127\.0\.0\.1:\d+|sha256:[0-9a-f]+|(?:\d+ min )?\b\d+(?:\.\d+)? (?:s|[kMG]?B)\b|\b\d+\.\d(?= +(?:amd|arm)64)"
    r"|(?<=linux/)(?:amd|arm)64$",
    re.MULTILINE,
)
"""Waits for other builds, addresses, digests, times, sizes with their unit, the column of sizes, and this machine's architecture."""


def stable(output: str) -> list[str]:
    """Lines that every call must print: without steps, and without what changes from call to call."""
    lines = [line for line in output.splitlines() if not re.match(r" +\d+:\d\d ", line)]
    return [" ".join(_CHANGES.sub("…", line).replace("……", "…").split()) for line in lines]


# ---- Drawing ---------------------------------------------------------------------------------------------------------

CELL, LINE, EDGE = 7.25, 16, 12
"""Pixels: a character, a line, the border."""

STYLE = """\
    text { font: 12px ui-monospace, SFMono-Regular, Menlo, Consolas, "DejaVu Sans Mono", monospace; white-space: pre; fill: #e6edf3; }
    .said { fill: #9da7b3; }
    @media (prefers-reduced-motion: no-preference) {
      text { opacity: 0; animation: appear 0.01s forwards; }
      @keyframes appear { to { opacity: 1; } }
    }
"""


def rows(commands: Mapping[str, Command]) -> Iterator[tuple[float, bool, str]]:
    """The lines of the picture: when each appears, whether it is bold, and what it says."""
    now = -THINKING
    for command in commands.values():
        now += THINKING
        before = 0.0
        for event in (Event(0.0, "o", f"\x1b[1m$ {command.typed}\x1b[0m\n"), *command.events):
            now += min(event.seconds - before, LONGEST)
            before = event.seconds
            for line in event.text.splitlines():
                text = plain(line)
                for begin in range(0, max(len(text), 1), WIDTH):
                    yield now, line.startswith("\x1b[1m"), text[begin : begin + WIDTH]


def picture(commands: Mapping[str, Command]) -> str:
    """The session as a picture in which lines appear one after the other, or all are there if the reader wants no motion."""
    lines = list(rows(commands))
    width, height = round(2 * EDGE + CELL * WIDTH), 2 * EDGE + LINE * len(lines)
    text = "".join(
        f'  <text{"" if bold else " class=" + chr(34) + "said" + chr(34)} x="{EDGE}" y="{EDGE + LINE * number + 12}" '
        f'textLength="{CELL * len(line):g}" style="animation-delay: {seconds:.1f}s">{escape(line)}</text>\n'
        for number, (seconds, bold, line) in enumerate(lines)
        if line
    )
    typed = "; ".join(command.typed for command in commands.values())
    return f"""\
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" role="img" aria-labelledby="t d">
  <!-- Written by python -m tests.recording, from docs/casts/first.cast. -->
  <title id="t">A first session with rosml</title>
  <desc id="d">{escape(typed)}</desc>
  <style>
{STYLE}  </style>
  <rect width="{width}" height="{height}" rx="8" fill="#0d1117"/>
{text}</svg>
"""


def main(names: list[str]) -> None:
    """Records what is named, or all, and draws."""
    if names != ["draw"]:
        commands = record(names or list(COMMANDS))
        CAST.parent.mkdir(exist_ok=True)
        CAST.write_text(written(commands), encoding="utf-8")
    PICTURE.write_text(picture(read()), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
