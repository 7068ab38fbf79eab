"""A stop of a container: the entrypoint and all that it starts are real processes, below an init that is called tini."""

from __future__ import annotations

import os
import pty
import select
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import pytest

from fakes.stubs import script_of_a_build
from rosml import ROOT

BASE = ROOT / "components/base"

INIT = """\
import os, signal, sys
open("/proc/self/comm", "w").write("tini")
signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals())
child = os.fork()
if not child:
    os.setpgid(0, 0)
    if os.isatty(0):
        os.tcsetpgrp(0, os.getpid())
    signal.pthread_sigmask(signal.SIG_SETMASK, ())
    os.execv(sys.argv[1], sys.argv[1:])
while True:
    number = signal.sigwait(signal.valid_signals())
    if number != signal.SIGCHLD:
        os.kill(child, number)
    elif (ended := os.waitpid(-1, os.WNOHANG))[0] == child:
        code = os.waitstatus_to_exitcode(ended[1])
        sys.exit(code if code >= 0 else 128 - code)
"""
"""What tini does."""

NODE = """\
#!/usr/bin/env python3
import signal, sys, time
name, handled, seconds = sys.argv[1], sys.argv[2].split(","), float(sys.argv[3])
log = open(name, "ab", buffering=0)
asked = []
def got(number, frame):
    log.write(signal.Signals(number).name[3:].encode() + b" ")
    asked.append(number)
signal.signal(signal.SIGINT, signal.SIG_DFL)
for signal_name in handled:
    signal.signal(getattr(signal, "SIG" + signal_name), got)
log.write(b"up ")
while not asked:
    time.sleep(0.02)
end = time.time() + seconds
while time.time() < end:
    time.sleep(0.02)
print("last words of " + name, flush=True)
log.write(b"saved")
"""
"""`node NAME SIGNALS SECONDS` handles these signals: on the first one it saves for some time, and writes down all."""

ROS2 = """\
#!/usr/bin/env python3
# ros2 launch, by what it does with signals: https://github.com/ros2/launch. It ends on SIGTERM, and its nodes go on.
import os, signal, subprocess, sys
nodes = [subprocess.Popen(["node", name, "INT,TERM", "0.5"]) for name in sys.argv[2:]]
def interrupted(number, frame):
    for node in nodes:
        if not os.isatty(0):  # else Ctrl-C has reached them
            node.send_signal(signal.SIGINT)
signal.signal(signal.SIGINT, interrupted)
for node in nodes:
    node.wait()
"""

ROSLAUNCH = """\
#!/usr/bin/env python3
import os, signal, subprocess, sys
nodes = [subprocess.Popen(["node", name, "INT,TERM", "0.5"], start_new_session=True) for name in sys.argv[1:]]
def stopped(number, frame):
    for node in nodes:
        os.killpg(node.pid, signal.SIGINT)
for number in (signal.SIGINT, signal.SIGTERM):
    signal.signal(number, stopped)
for node in nodes:
    node.wait()
"""

ROSBAG = """\
#!/usr/bin/env python3
import signal, subprocess, sys
signal.signal(signal.SIGTERM, lambda number, frame: recorder.terminate())
signal.signal(signal.SIGINT, lambda number, frame: recorder.send_signal(signal.SIGINT))
recorder = subprocess.Popen(["node", sys.argv[1], "INT", "0.5"])
recorder.wait()
"""

PARENT = """\
#!/usr/bin/env python3
import subprocess, sys
process = subprocess.Popen(["node", sys.argv[1], "INT", "0.5"])
while process.returncode is None:
    try:
        process.wait()
    except KeyboardInterrupt:  # ros2 run: the process gets it as well
        pass
"""

PROGRAMS = {"node": NODE, "ros2": ROS2, "roslaunch": ROSLAUNCH, "rosbag": ROSBAG, "parent": PARENT}


@dataclass
class Ended:
    """How a command ended, and what its nodes wrote."""

    code: int
    output: str
    seconds: float
    files: Mapping[str, str]


def shared(folder: Path) -> Path:
    """A folder with the entrypoint, and with what it calls."""
    share = folder / "share"
    share.mkdir()
    for file in ("entrypoint.sh", "setup.bash", "stop.py", "job.sh"):
        text = (BASE / file).read_text().replace("/usr/local/share/rosml", str(share))
        (share / file).write_text(text)
        (share / file).chmod(0o755)
    return share


class Started:
    """A command that the entrypoint has started, as in a container."""

    def __init__(self, folder: Path, terminal: bool, *command: str) -> None:
        share = shared(folder)
        for name, text in PROGRAMS.items():
            (share / name).write_text(text)
            (share / name).chmod(0o755)
        self.folder = folder / "data"
        self.folder.mkdir()
        path = f"{share}:{os.path.dirname(sys.executable)}:/usr/bin:/bin"
        environment = {"PATH": path, "HOME": str(folder), "WORKSPACE": str(folder)}
        arguments = [sys.executable, "-c", INIT, str(share / "entrypoint.sh"), *command]
        self.terminal, other = pty.openpty() if terminal else (-1, subprocess.DEVNULL)
        self.log = (folder / "log").open("w+")
        output = other if terminal else self.log
        self.process = subprocess.Popen(
            ["setsid", *(["--ctty"] if terminal else []), *arguments],
            cwd=self.folder,
            env=environment,
            stdin=other,
            stdout=output,
            stderr=output,
        )
        self.shown = b""
        if terminal:
            os.close(other)

    def read(self) -> None:
        """What the terminal says."""
        with suppress(OSError):  # the other end was closed
            while self.terminal >= 0 and select.select([self.terminal], [], [], 0.02)[0]:
                self.shown += os.read(self.terminal, 65536)

    def up(self, *names: str, text: str = "") -> None:
        """Waits for nodes, and for what the terminal says."""
        end = time.monotonic() + 30
        while text.encode() not in self.shown or any("up" not in self.files().get(name, "") for name in names):
            assert time.monotonic() < end and self.process.poll() is None, (self.files(), self.shown, self.logged())
            time.sleep(0.02)
            self.read()

    def files(self) -> dict[str, str]:
        return {path.name: path.read_text().strip() for path in self.folder.iterdir()}

    def logged(self) -> str:
        return Path(self.log.name).read_text()

    def type(self, text: str) -> None:
        os.write(self.terminal, text.encode())

    def ended(self, *numbers: int, within: float = 20.0) -> Ended:
        """Sends signals to the init, and waits for the end."""
        begin = time.monotonic()
        for number in numbers:
            self.process.send_signal(number)
        while self.process.poll() is None and time.monotonic() < begin + within:
            time.sleep(0.02)
            self.read()
        code = self.process.poll()
        if code is None:
            self.process.kill()
            self.process.wait()
        seconds = time.monotonic() - begin
        self.read()
        if self.terminal >= 0:
            os.close(self.terminal)
        assert code is not None, f"it still runs: {self.files()}"
        return Ended(code, self.logged() + self.shown.decode(errors="replace"), seconds, self.files())


@pytest.fixture(autouse=True)
def _no_process_is_left(tmp_path: Path) -> Iterator[None]:
    """A test that fails, or one of what ignores a stop, leaves some: no engine kills them here."""
    yield
    for place in Path("/proc").glob("[0-9]*/cmdline"):
        with suppress(OSError):
            if os.fsencode(tmp_path) in place.read_bytes():
                os.kill(int(place.parent.name), signal.SIGKILL)


BOTH = pytest.mark.parametrize("terminal", [False, True], ids=["plain", "terminal"])


@BOTH
@pytest.mark.parametrize(
    ("script", "expected"),
    [
        ("node a INT,TERM 1 | tee log", {"a": "up TERM saved", "log": "last words of a"}),
        ("node a INT,TERM 0.2; touch further", {"a": "up TERM saved"}),
        ("node a INT,TERM 1 & node b TERM 0.2 & wait", {"a": "up TERM saved", "b": "up TERM saved"}),
        ("node a INT 0.5 & node b INT 0.2", {"a": "up INT saved", "b": "up INT saved"}),  # nodes of roscpp
        ("(node a TERM 0.5; true) | (cat; true) >log", {"a": "up TERM saved", "log": "last words of a"}),
        ("setsid node a TERM 0.5 & node b TERM 0.2", {"a": "up TERM saved", "b": "up TERM saved"}),
        ("exec ros2 launch a b", {"a": "up INT saved", "b": "up INT saved"}),
        ("ros2 launch a b; true", {"a": "up INT saved", "b": "up INT saved"}),
        ("roslaunch a b | cat", {"a": "up INT saved", "b": "up INT saved"}),
        ("exec parent a", {"a": "up INT saved"}),
        ("trap 'kill -INT $!; wait' TERM; node a INT,TERM 0.5 & wait", {"a": "up INT saved"}),
        ("trap 'echo >further' TERM; node a INT,TERM 0.5; true", {"a": "up TERM saved", "further": ""}),
        ("while true; do node a TERM 0.2; done", {"a": "up TERM saved"}),
    ],
)
def test_each_process_gets_the_signal_on_which_it_saves_once(
    tmp_path: Path, terminal: bool, script: str, expected: Mapping[str, str]
) -> None:
    started = Started(tmp_path, terminal, "bash", "-c", script)
    started.up(*(name for name in expected if name not in ("log", "further")))
    assert started.ended(signal.SIGTERM).files == expected


def test_a_stop_that_comes_with_a_continue_is_not_lost(tmp_path: Path) -> None:
    """As timeout and systemd send it: both wait for a process, and reach it at once."""
    started = Started(tmp_path, False, "node", "a", "TERM", "0.2")
    started.up("a")
    init = started.process.pid
    entrypoint = int(Path(f"/proc/{init}/task/{init}/children").read_text())
    for number in (signal.SIGSTOP, signal.SIGTERM, signal.SIGCONT):
        os.kill(entrypoint, number)
    assert started.ended(within=10).files == {"a": "up TERM saved"}


@BOTH
def test_a_recorder_behind_its_wrapper_saves(tmp_path: Path, terminal: bool) -> None:
    """rosbag ends its recorder unsaved on SIGTERM, and with a terminal both get SIGINT, as on Ctrl-C."""
    started = Started(tmp_path, terminal, "rosbag", "bag")
    started.up("bag")
    files = started.ended(signal.SIGTERM).files
    assert files["bag"] in ("up INT saved", "up INT INT saved"), files


@BOTH
def test_a_command_alone_gets_its_signal_and_its_exit_code_passes(tmp_path: Path, terminal: bool) -> None:
    script = "trap 'echo ended; exit 9' TERM; touch up; echo up >up; while :; do sleep 0.1; done"
    started = Started(tmp_path, terminal, "bash", "-c", script)
    started.up("up")
    done = started.ended(signal.SIGTERM)
    assert done.code == 9 and "ended" in done.output and "erminated" not in done.output


@BOTH
@pytest.mark.parametrize(("command", "code"), [(("bash", "-c", "exit 37"), 37), (("bash", "-c", "kill -9 $$"), 137)])
def test_exit_codes_pass(tmp_path: Path, terminal: bool, command: tuple[str, ...], code: int) -> None:
    done = Started(tmp_path, terminal, *command).ended()
    assert (done.code, done.output) == (code, "")


@BOTH
def test_a_command_does_not_see_the_shells_that_wait_for_it(tmp_path: Path, terminal: bool) -> None:
    """The first shell that somebody opens has the banner."""
    done = Started(tmp_path, terminal, "bash", "-c", "echo level $SHLVL; env | grep -c _rosml; exit 0").ended()
    assert done.output.split() == ["level", "1", "0"]


@BOTH
def test_no_second_signal_comes_while_somebody_saves(tmp_path: Path, terminal: bool) -> None:
    started = Started(tmp_path, terminal, "bash", "-c", "node a INT,TERM 1; true")
    started.up("a")
    started.process.send_signal(signal.SIGTERM)
    time.sleep(0.5)
    assert started.ended(signal.SIGTERM).files == {"a": "up TERM saved"}


@BOTH
def test_sigint_from_the_engine_reaches_all(tmp_path: Path, terminal: bool) -> None:
    """--stop-signal SIGINT, and Ctrl-C of an engine without a terminal."""
    started = Started(tmp_path, terminal, "bash", "-c", "node a INT,TERM 0.5 | cat")
    started.up("a")
    assert started.ended(signal.SIGINT).files == {"a": "up INT saved"}


@BOTH
def test_other_signals_reach_the_command(tmp_path: Path, terminal: bool) -> None:
    started = Started(tmp_path, terminal, "node", "a", "USR1,HUP", "0.1")
    started.up("a")
    assert started.ended(signal.SIGUSR1).files == {"a": "up USR1 saved"}


def test_two_stops_at_once_do_not_wait_for_each_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """Process 1 is the container's own. The command, 7, has ended; 66 and 67 are the two stops."""
    stop = script_of_a_build("base/stop.py")
    words = ("/usr/bin/python3", "/usr/local/share/rosml/stop.py", "2", "7", "all")
    facts = {
        "started": "1",
        "group": 6,
        "stdin": "",
        "outputs": ("", ""),
        "ignores": 1 << (signal.SIGINT - 1),
        "catches": 0,
    }
    processes = {
        pid: stop.Process(pid=pid, parent=parent, program=program, words=words, **facts)
        for pid, parent, program in [(1, 0, "tini"), (6, 1, "bash"), (66, 6, "python3"), (67, 6, "python3")]
    }
    monkeypatch.setattr(stop, "running", lambda: processes)
    monkeypatch.setattr(os, "getpid", lambda: 66)
    monkeypatch.setattr(os, "getppid", lambda: 6)
    monkeypatch.setattr(os, "kill", lambda pid, number: pytest.fail(f"{pid} gets {number}"))
    stop.main(2, 7, "all")


def test_what_ignores_a_stop_is_waited_for(tmp_path: Path) -> None:
    """Until the engine kills the container."""
    started = Started(tmp_path, False, "bash", "-c", "trap '' TERM; node a USR1 0.1; true")
    started.up("a")
    with pytest.raises(AssertionError, match="still runs"):
        started.ended(signal.SIGTERM, within=1.5)


# ---- A terminal ------------------------------------------------------------------------------------------------------


def test_a_shell_ends_at_once_after_what_runs_in_it(tmp_path: Path) -> None:
    started = Started(tmp_path, True, "bash", "--norc")
    started.up(text="bash-")
    started.type("node a INT,TERM 0.5 &\rnode b INT 0.5\r")
    started.up("a", "b")
    done = started.ended(signal.SIGTERM)
    assert done.files == {"a": "up TERM saved", "b": "up INT saved"}
    assert done.seconds < 5, done


def test_ctrl_c_comes_from_the_terminal_alone(tmp_path: Path) -> None:
    started = Started(tmp_path, True, "bash", "-c", "node a INT 0.5; true")
    started.up("a")
    started.type("\x03")
    assert started.ended().files == {"a": "up INT saved"}


def test_ctrl_z_stops_nothing_that_nobody_could_continue(tmp_path: Path) -> None:
    started = Started(tmp_path, True, "node", "a", "INT", "0.1")
    started.up("a")
    started.type("\x1a")
    time.sleep(0.3)
    started.type("\x03")
    assert started.ended().files == {"a": "up INT saved"}


@pytest.mark.parametrize("reaches", ["every process", "a shell alone"])
def test_the_structure_test_sees_whom_a_stop_reaches(tmp_path: Path, reaches: str) -> None:
    share = shared(tmp_path)
    if reaches == "a shell alone":
        (share / "entrypoint.sh").write_text('#!/bin/bash\nexec "$@"\n')
    text = (ROOT / "tests/structure/checks/stop.py").read_text()
    words = '"/tini", "-s", "--", "/entrypoint.sh"'
    assert words in text
    init = f"{sys.executable!r}, '-c', {INIT!r}, {str(share / 'entrypoint.sh')!r}"
    assert '["/tini", "-s", "true"]' in text
    (share / "check.py").write_text(text.replace(words, init).replace('["/tini", "-s", "true"]', '["true"]'))
    environment = {"PATH": os.environ["PATH"], "HOME": str(tmp_path), "WORKSPACE": str(tmp_path)}
    with (tmp_path / "output").open("w") as output:  # no pipe: a node that is left holds it
        command = ["setsid", sys.executable, str(share / "check.py")]
        done = subprocess.run(command, env=environment, stdout=output, stderr=output, check=False, timeout=60)
    printed = (tmp_path / "output").read_text()
    assert (done.returncode == 0) == (reaches == "every process"), printed
    assert reaches == "every process" or "'a': 'up'" in printed, printed
