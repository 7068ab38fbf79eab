#!/usr/bin/env python3
"""A stop reaches every process of a command, and is over when all of them have ended.

With `--untold`: prints why this cannot be told here, if it cannot.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

NODE = """
import signal, sys, time
log = open(sys.argv[1], "ab", buffering=0)
def got(number, frame):
    log.write(b" %d" % number)
    time.sleep(0.5)
    log.write(b" saved")
    print("last words")
    sys.exit()
signal.signal(getattr(signal, sys.argv[2]), got)
log.write(b"up")
while True:
    time.sleep(0.05)
"""

SCRIPT = 'python3 node "$1/a" SIGTERM | tee "$1/log" & python3 node "$1/b" SIGINT; touch "$1/further"'

EXPECTED = {"a": "up 15 saved", "b": "up 2 saved", "log": "last words"}


def read(folder: Path) -> dict[str, str]:
    """What the nodes wrote."""
    return {path.name: path.read_text().strip() for path in folder.iterdir() if path.name != "node"}


def untold() -> str:
    """Why this cannot be told here; empty if it can. Without a container's first process, tini takes its place as a subreaper, which QEMU
    7.2 does not know."""
    done = subprocess.run(["/tini", "-s", "true"], capture_output=True, text=True)
    unknown = "PR_SET_CHILD_SUBREAPER is unavailable" in done.stderr
    return "not told under emulation: no process takes the place of a container's first one" if unknown else ""


def main() -> None:
    """Starts two nodes behind a shell, and stops them as an engine does."""
    if why := untold():
        print(why)
        return
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "node").write_text(NODE)
        command = ["/tini", "-s", "--", "/entrypoint.sh", "bash", "-c", SCRIPT, "bash", name]
        environment = {key: value for key, value in os.environ.items() if not key.startswith("DOCKER_")}
        process = subprocess.Popen(command, cwd=name, env=environment)
        end = time.monotonic() + 60
        while not all(read(folder).get(node) == "up" for node in ("a", "b")):
            assert time.monotonic() < end and process.poll() is None, read(folder)
            time.sleep(0.05)
        process.terminate()
        process.wait(60)
        logs = read(folder)
        if logs != EXPECTED or process.returncode != 128 + 15:
            sys.exit(f"{logs}, exit code {process.returncode}; expected {EXPECTED}, {128 + 15}")


if __name__ == "__main__":
    if sys.argv[1:] == ["--untold"]:
        print(untold())
    else:
        main()
