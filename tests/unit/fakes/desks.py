"""A folder in which somebody calls `rosml run` and `rosml attach`, with local replacements for docker and podman."""

from __future__ import annotations

import contextlib
import json
import os
import pty
import shlex
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from conftest import ROOT

from fakes import forks
from rosml.run.context import Host

ENGINE = """\
import json, os, signal, sys, time
here, name = os.path.split(sys.argv.pop(1))
with open(f"{here}/{name}.json") as file:
    says = json.load(file)
first, last = sys.argv[1], sys.argv[-1]
if first == "info":
    print(json.dumps(says["info"]))
    sys.exit(says["complaint"] or 0)
if first == "image":
    if last not in says["images"]:
        sys.exit(says["complaint"] or f"Error: No such image: {last}")
    config = {"Env": says["images"][last]} | says["configs"].get(last, {})
    print(json.dumps({"Id": "sha256:" + last.removeprefix("sha256:"), "Config": config}))
if first == "container":
    for asked in sys.argv[5:]:
        if asked in says["containers"]:
            given = says["containers"][asked]
            state, own, image, config, mounts, settings = [*given, *["", {}, [], {}][len(given) - 2:]]
            print(*map(json.dumps, [own, state, image, config, mounts, settings]))
    if not set(sys.argv[5:]) <= {*says["containers"]}:
        sys.exit(says["complaint"] or "Error: No such container")
if first == "ps":
    print(*says["containers"], sep="\\n")
    sys.exit(says["complaint"] or 0)
if first == "start":
    if not says["started"]:
        sys.exit("no such file or directory")
    says["containers"][last][0] = says["started"]
    with open(f"{here}/{name}.json", "w") as file:
        json.dump(says, file)
if first == "pull":
    print("progress")
    if last not in says["registry"]:
        sys.exit("pull access denied")
    says["images"][last] = says["registry"][last]
    with open(f"{here}/{name}.json", "w") as file:
        json.dump(says, file)
if first in ("run", "exec"):
    if last == "read":
        print(sys.stdin.read().upper(), end="")
    if last == "wait":
        signal.signal(signal.SIGTERM, lambda *_: os._exit(7))
        print("waiting", flush=True)
        time.sleep(60)
    sys.exit(says["code"])
"""
"""An engine that answers as its file says."""

SHORT = """\
#!/bin/sh
printf '%s\\0' "$(($# + 1))" "${{0##*/}}" "$@" >>"${{0%/*}}/calls"
for last; do :; done
case $1:$last in
{answers}
  run:read | run:wait | exec:read | exec:wait) ;;
  run:* | exec:*) exit {code} ;;
esac
exec {python} -IS "${{0%/*}}/engine.py" "$0" "$@"
"""
"""Writes down all calls: how many words, and the words. Gives the usual answers itself, before Python has started."""


def answers(says: Mapping[str, Any]) -> Iterator[str]:
    """Lines of `case` for the most frequent questions to an engine."""
    for word, answer in says["answers"].items():
        yield f"  {word}:*) printf '%s\\n' {shlex.quote(answer)}; exit ;;"
    if says["complaint"]:
        return
    yield f"  info:*) printf '%s\\n' {shlex.quote(json.dumps(says['info']))}; exit ;;"
    for image in says["images"].keys() - says["registry"].keys():
        config = {"Env": says["images"][image]} | says["configs"].get(image, {})
        answer = json.dumps({"Id": f"sha256:{image.removeprefix('sha256:')}", "Config": config})
        yield f"  image:{shlex.quote(image)}) printf '%s\\n' {shlex.quote(answer)}; exit ;;"
    if not says["containers"]:
        yield "  container:*) [ $# -lt 5 ] || { echo 'Error: No such container' >&2; exit 1; } ;;"


DOCKER = {"ServerVersion": "28.2.2", "SecurityOptions": ["name=seccomp,profile=builtin", "name=cgroupns"]}
ROOTLESS = {**DOCKER, "SecurityOptions": [*DOCKER["SecurityOptions"], "name=rootless"]}
PODMAN = {"host": {"security": {"rootless": True}}}
OURS = ["PATH=/usr/bin", "DOCKER_USER=dockeruser", "DOCKER_UID=", "DOCKER_GID=", "WORKSPACE=/docker-ros/ws"]
OTHER = ["PATH=/usr/bin"]

UID, GID = os.geteuid(), os.getegid()


START = """\
import os, sys
from pathlib import Path
from rosml.run import host
from rosml.cli import command
from rosml.cli.run import run as of_run
command.IN_CHECKOUT, of_run.ROOT = False, Path(os.environ.get("DESK_CHECKOUT", "/nowhere"))
host.ROOT, sys.argv = Path(sys.argv[1]), ["rosml", *sys.argv[2:]]
if uid := os.environ.get("DESK_UID", ""):
    from dataclasses import replace
    found = host.person
    host.person = lambda environment: replace(found(environment), uid=int(uid), gid=int(uid), name="jo")
from rosml.cli.main import run
sys.exit(run())
"""
"""Starts rosml as an installed command, with another folder in the place of /, and as somebody else for whom the container runs, if DESK_UID says so; its checkout is
DESK_CHECKOUT."""


BARE = Host(Path("/dev/null/nothing"))


class Desk:
    """A folder in which somebody calls `rosml run`, with engines that are local replacements.

    Attributes:
        root: where it finds the machine's files.
        bin: all of PATH.
        command: `run`, or `attach`.
    """

    command = "run"

    def __init__(self, path: Path) -> None:
        self.folder, self.bin = path / "dr", path / "bin"
        self.root = path / "root"
        self.root.mkdir()
        self.folder.mkdir()
        self.bin.mkdir()
        self.environment = {"PATH": str(self.bin), "HOME": str(path), "PYTHONPATH": str(ROOT / "src")}

    @property
    def memory(self) -> Path:
        return Path(self.environment["HOME"], ".local/state/rosml/allowed.json")

    def trust(self, **images: bool) -> None:
        """Whether somebody trusts images of docker's own registry."""
        self.memory.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        self.memory.write_text(json.dumps({f"image docker.io/library/{name}": says for name, says in images.items()}))

    def engine(self, name: str = "docker", **facts: Any) -> None:
        """Installs an engine, or changes its answers."""
        says = {"info": DOCKER, "images": {"ubuntu": OTHER, "ours": OURS}, "containers": {}, "registry": {}}
        says |= {"code": 0, "complaint": "", "configs": {}, "started": "running", "answers": {}} | facts
        (self.bin / f"{name}.json").write_text(json.dumps(says))
        (self.bin / "engine.py").write_text(ENGINE)
        (self.bin / name).write_text(
            SHORT.format(answers="\n".join(answers(says)), code=says["code"], python=shlex.quote(sys.executable))
        )
        (self.bin / name).chmod(0o755)

    def argv(self, *words: str) -> list[str]:
        return [sys.executable, "-c", START, str(self.root), self.command, *words]

    def call(self, *words: str, **environment: str) -> subprocess.CompletedProcess[str]:
        """Calls it without a terminal, and with nothing to read."""
        output, errors = os.pipe(), os.pipe()
        with open(os.devnull) as nothing:
            ended = self._begin(words, environment, nothing.fileno(), output[1], errors[1])
        os.close(output[1])
        os.close(errors[1])
        with open(output[0]) as stdout, open(errors[0]) as complaints, ThreadPoolExecutor(1) as beside:
            complaint = beside.submit(complaints.read)
            text = stdout.read()
            return subprocess.CompletedProcess(self.argv(*words), ended(), text, complaint.result())

    @property
    def calls(self) -> list[list[str]]:
        """All calls of engines so far."""
        file = self.bin / "calls"
        words = os.fsdecode(file.read_bytes()).split("\0")[:-1] if file.exists() else []
        calls = []
        while words:
            count = int(words[0])
            calls.append(words[1 : count + 1])
            words = words[count + 1 :]
        return calls

    @property
    def ran(self) -> list[str]:
        """The call of the only engine that ran something."""
        (argv,) = [call for call in self.calls if call[1] in ("run", "exec")]
        return argv

    def called(self, word: str) -> bool:
        """Whether an engine was called with this first word."""
        return any(call[1] == word for call in self.calls)

    def on_a_terminal(
        self, *words: str, output: int | None = None, keys: bytes = b"", before: bytes = b""
    ) -> tuple[int, bytes]:
        """Calls it on a terminal of Python's own making: its exit code, and what the terminal shows.

        Args:
            output: in the place of the terminal.
            keys: what somebody types, a line at each question.
            before: what they typed already.
        """
        ours, theirs = pty.openpty()
        os.write(ours, before)
        lines = keys.splitlines(keepends=True)
        out = theirs if output is None else output
        ended = self._begin(words, {}, theirs, out, theirs)
        os.close(theirs)
        screen = b""
        with contextlib.suppress(OSError):  # how a terminal says that nobody writes any more
            while part := os.read(ours, 1000):
                screen += part
                if screen.endswith(b"[y/N] ") and lines:
                    os.write(ours, lines.pop(0))
        os.close(ours)
        return ended(), screen

    def _begin(self, words: Sequence[str], environment: Mapping[str, str], *files: int) -> Callable[[], int]:
        """Begins a call. The result waits for its end and has its exit code."""
        _, _, code, *arguments = self.argv(*words)
        env = {**self.environment, **environment}
        server = forks.server(env)
        server.begin(code, arguments, str(self.folder), env, *files)
        return server.end


def docker_desk(path: Path, command: str = "run", **facts: Any) -> Desk:
    """A desk with docker, which has the images `ubuntu` and `ours`; the latter is trusted."""
    desk = Desk(path)
    desk.command = command
    desk.engine(**facts)
    desk.trust(ours=True)
    return desk


def folder_container(
    desk: Desk, image: str = "ours", state: str = "running", name: str = "dr", **config: Any
) -> list[Any]:
    """A container of the desk's folder, as an engine has it."""
    ours = {"Env": OURS, "Entrypoint": ["/tini", "--", "/entrypoint.sh"]} if image == "ours" else {"Env": OTHER}
    labels = {"io.rosml.run.folder": str(desk.folder)}
    mounts = [{"Destination": place} for place in config.pop("mounts", [])]
    return [state, f"/{name}", f"sha256:{image}", {"Image": image, "Labels": labels, **ours, **config}, mounts]


LOCKED = ["--security-opt", "no-new-privileges"]
USER = ["--user", f"{UID}:{GID}", *([] if UID == 0 else ["-e", "HOME=/tmp", *LOCKED])]


def plain(desk: Desk) -> list[str]:
    """The options of rosml without a terminal for an image that makes no user."""
    return ["docker", "run", "--rm", *labelled(desk), *USER]


def labelled(desk: Desk) -> list[str]:
    return ["--label", f"io.rosml.run.folder={desk.folder}"]
