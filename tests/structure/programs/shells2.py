"""No shell that sets ROS 2 up says anything on its standard error: what is there would stand before the words of every
program, and in every log."""

from __future__ import annotations

import os
import pty
import subprocess
import sys

SETUP = f"/opt/ros/{os.environ['ROS_DISTRO']}/setup"
CLEAN = {"HOME": "/root", "PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin", "TERM": "dumb"}
CLEAN.update({name: os.environ[name] for name in ("LANG", "ROS_DISTRO", "WORKSPACE") if name in os.environ})

SHELLS = {
    "bash": ["bash", "-c", f"source {SETUP}.bash && ros2 --help >/dev/null"],
    "bash, twice": ["bash", "-c", f"source {SETUP}.bash && source {SETUP}.bash"],
    "sh": ["sh", "-c", f". {SETUP}.sh"],
    "a login shell": ["bash", "-l", "-c", "true"],
    "an interactive shell": ["bash", "-i", "-c", "ros2 --help >/dev/null"],
    "the entrypoint": ["/entrypoint.sh", "ros2", "--help"],
}

wrong = []
for name, command in SHELLS.items():
    # A terminal of its own, as a person has: without one an interactive bash says that it cannot control jobs.
    master, slave = pty.openpty()
    terminal = ["setsid", "--ctty", "--wait"]
    done = subprocess.run([*terminal, *command], env=CLEAN, stdin=slave, capture_output=True, text=True, timeout=60)
    os.close(master)
    os.close(slave)
    if done.returncode or done.stderr:
        wrong.append(f"{name} ended with {done.returncode} and said:\n{done.stderr}")
if wrong:
    sys.exit("\n".join(wrong))
print(f"{len(SHELLS)} shells: silent")
