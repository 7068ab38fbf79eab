#!/usr/bin/python3 -IS
"""Stops what runs in a container: each process gets the signal on which it saves, once. Ends when all of them have ended.

The entrypoint calls it when a stop arrives: `stop.py SIGNAL CHILD`, with the process id of its child. An engine's stop reaches one process
alone, and a shell would end at once and hand nothing on.

- A shell gets SIGTERM: it starts nothing further, and its trap runs. If it has one, that has a second to signal the children. An
  interactive shell ignores SIGTERM; it gets SIGHUP after all others have ended.
- ROS's commands, and programs with ROS 2's client library, get SIGINT: `rosbag` and `ros2 launch` save nothing on SIGTERM.
- All others get SIGTERM if they handle it, else SIGINT if they handle that (C++ nodes of ROS 1, Python).
- A process that handles SIGTERM, and ros2 launch, stops its children itself: they get nothing as long as it lives. The children of
  others that get SIGINT get it too, as on Ctrl-C.
- A process that reads the output of another one, such as `tee`, ends after it.
"""

import os
import re
import signal
import sys
import time
from typing import Dict, Iterator, List, NamedTuple, Optional, Set, Tuple

SHELLS = ("ash", "bash", "busybox", "dash", "fish", "ksh", "sh", "zsh")
ROS = re.compile(r"(.*/)?ros[a-z0-9]+")
TERMINALS = ("/dev/pts/", "/dev/tty", "/dev/console")
CLIENT = "/librcl"  # ROS 2's client library, also in wheels
SECONDS = 0.05  # between two looks
TRAP = 1.0  # seconds for the trap of a shell: bash runs it at once in `wait`, and otherwise after the present command

Identity = Tuple[int, str]


class Process(NamedTuple):
    pid: int
    started: str  # with the pid it is unique
    parent: int
    group: int
    program: str
    words: Tuple[str, ...]
    stdin: str  # where its first file descriptors lead to; empty if it cannot be read
    outputs: Tuple[str, str]
    ignores: int  # signals, bit by bit
    catches: int

    @property
    def identity(self) -> Identity:
        return self.pid, self.started

    def handles(self, number: int) -> bool:
        return bool(self.catches >> (number - 1) & 1)

    def passes_over(self, number: int) -> bool:
        return bool(self.ignores >> (number - 1) & 1)

    @property
    def is_shell(self) -> bool:
        return self.program in SHELLS

    @property
    def is_interactive(self) -> bool:
        return self.is_shell and self.passes_over(signal.SIGTERM)

    @property
    def script(self) -> Tuple[str, ...]:
        """Its words, without Python's own."""
        return (self.words[1:] if self.program.startswith("python") else self.words) or ("",)

    @property
    def is_launch(self) -> bool:
        return os.path.basename(self.script[0]) == "ros2" and self.script[1:2] == ("launch",)

    @property
    def has_terminal(self) -> bool:
        return self.stdin.startswith(TERMINALS) and not (self.is_launch and {"-n", "--noninteractive"} & {*self.script})

    @property
    def is_ros(self) -> bool:
        if ROS.fullmatch(self.script[0]):
            return True
        try:
            with open(f"/proc/{self.pid}/maps", encoding="utf-8", errors="replace") as maps:
                return any(CLIENT in line for line in maps)
        except OSError:
            return False


class Sent(NamedTuple):
    """What a process got; 0 for nothing."""

    number: int
    until: float = 0  # its children are its own affair until then, by the monotonic clock
    group: Optional[int] = None  # processes of this group get SIGINT as well


ALWAYS = float("inf")


# ---- What runs -------------------------------------------------------------------------------------------------------


def running() -> Dict[int, Process]:
    """All processes that can be seen; not those that have ended and wait for their parent."""
    processes = (_process(int(name)) for name in os.listdir("/proc") if name.isdigit())
    return {process.pid: process for process in processes if process}


def _process(pid: int) -> Optional[Process]:
    place = f"/proc/{pid}"
    try:
        with open(f"{place}/stat", encoding="utf-8", errors="replace") as file:
            name, _, rest = file.read().partition(" (")[2].rpartition(") ")
        with open(f"{place}/status", encoding="utf-8", errors="replace") as file:
            sets = dict(re.findall(r"^Sig(Ign|Cgt):\s*(\w+)$", file.read(), re.MULTILINE))
        with open(f"{place}/cmdline", encoding="utf-8", errors="replace") as file:
            words = tuple(file.read().split("\0"))
        state, parent, group, *others = rest.split()
        if state in "ZX":
            return None
        program = os.path.basename(_link(f"{place}/exe")) or name
        outputs = _link(f"{place}/fd/1"), _link(f"{place}/fd/2")
        stdin = _link(f"{place}/fd/0")
        ignores, catches = (int(sets[key], 16) for key in ("Ign", "Cgt"))
        return Process(pid, others[16], int(parent), int(group), program, words, stdin, outputs, ignores, catches)
    except (OSError, ValueError, KeyError, IndexError):
        return None  # it has ended


def _link(path: str) -> str:
    try:
        return os.readlink(path)
    except OSError:
        return ""


def ancestors(processes: Dict[int, Process], pid: int) -> Iterator[int]:
    while pid in processes:
        yield pid
        pid = processes[pid].parent


# ---- Who gets what ---------------------------------------------------------------------------------------------------


def signal_for(process: Process, number: int, is_orphan: bool) -> Sent:
    """What a process gets that nobody else stops. `is_orphan`: its parent should have stopped it, and is gone."""
    terminates, interrupts = (process.handles(item) for item in (signal.SIGTERM, signal.SIGINT))
    if process.is_shell:
        return Sent(number, time.monotonic() + TRAP if terminates else 0)
    if interrupts and (number == signal.SIGINT or not terminates or (process.is_ros and not is_orphan)):
        # ros2 launch hands it on itself; but with a terminal, it takes it that Ctrl-C has reached its nodes.
        hands_on = (terminates or process.is_launch) and not process.has_terminal
        return Sent(signal.SIGINT, ALWAYS) if hands_on else Sent(signal.SIGINT, group=process.group)
    return Sent(signal.SIGTERM, ALWAYS) if terminates else Sent(number)


class Stop:
    def __init__(self, number: int) -> None:
        self.number = number  # the signal that the container got
        self.sent: Dict[Identity, Sent] = {}
        self.deferred: Set[Identity] = set()  # processes whose parent should stop them
        self.others: Set[Identity] = set()  # processes of another user

    def step(self, scope: Dict[int, Process]) -> bool:
        """Signals processes of the container that have got nothing, once they can get it. Returns whether some still run."""
        scope = {pid: process for pid, process in scope.items() if process.identity not in self.others}
        for process, sent in [*self.due(scope)]:
            self.tell(process, sent)
        shells = [process for process in scope.values() if process.is_interactive]
        if len(shells) < len(scope):
            return True
        if self.number == signal.SIGINT:
            return False
        for process in shells:
            if process.identity not in self.sent:
                self.tell(process, Sent(signal.SIGHUP))
        return bool(shells)

    def tell(self, process: Process, sent: Sent) -> None:
        self.sent[process.identity] = sent
        try:
            os.kill(process.pid, sent.number)
        except ProcessLookupError:
            pass
        except PermissionError:
            self.others.add(process.identity)

    def due(self, scope: Dict[int, Process]) -> Iterator[Tuple[Process, Sent]]:
        """The processes that get a signal now, and which."""
        children: Dict[int, List[Process]] = {}
        for process in scope.values():
            children.setdefault(process.parent, []).append(process)
        writes = {(output, process.pid) for process in scope.values() for output in process.outputs}
        pending = [(process, Sent(0)) for process in scope.values() if process.parent not in scope]
        while pending:
            process, above = pending.pop()
            sent = self.sent.get(process.identity)
            if sent is None and (above.until > time.monotonic() or above.group not in (None, process.group)):
                self.deferred.add(process.identity)
                sent = Sent(0, ALWAYS)
            elif sent is None:
                sent = self.new(process, above)
                reads = process.stdin.startswith("pipe:")
                if reads and any(output == process.stdin and pid != process.pid for output, pid in writes):
                    sent = sent._replace(number=0)  # after those that it reads from
                if sent.number:
                    yield process, sent
            pending += [(child, sent) for child in children.get(process.pid, [])]

    def new(self, process: Process, above: Sent) -> Sent:
        """What a process gets that has got nothing. `above`: what its parent got."""
        if process.is_interactive:
            return Sent(0)
        if above.group is not None:
            return Sent(0 if process.passes_over(signal.SIGINT) else signal.SIGINT, group=above.group)
        return signal_for(process, self.number, process.identity in self.deferred)


# ---- The call --------------------------------------------------------------------------------------------------------


def main(number: int, child: int, *words: str) -> None:
    """`child`: the entrypoint's. `words`: `terminal`, if the command is the child of that child; `all`, if process 1 is the container's own,
    so that all processes are."""
    stop, identities = Stop(number), set()  # type: Stop, Set[Identity]
    while True:
        processes = running()
        apart = {1, *ancestors(processes, os.getpid()), *([child] if "terminal" in words else [])}
        # Other children of the entrypoint are calls of this file: two signals may come at once. They would wait for each other.
        apart |= {pid for pid, process in processes.items() if process.parent == os.getppid() and pid != child}
        scope = {
            pid: process
            for pid, process in processes.items()
            if pid not in apart
            and ("all" in words or process.identity in identities or child in ancestors(processes, pid))
        }
        identities |= {process.identity for process in scope.values()}  # one whose parent ends is below it no longer
        if not stop.step(scope):
            return
        time.sleep(SECONDS)


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), *sys.argv[3:])
