"""Emulation: the kernel runs programs of another architecture through QEMU, so that you can build and test its images here.

The kernel has a table of interpreters (binfmt_misc). An entry with the flag F holds QEMU open, so build steps need no copy of it
in their root file system. It lasts until the machine restarts.
"""

from __future__ import annotations

import os
import platform
import subprocess
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.base.programs import pinned_image
from rosml.machine.setup.installer import Installer, which_system
from rosml.machine.setup.process import output_of

TABLE = Path("/proc/sys/fs/binfmt_misc")
ENTRIES = Path("/usr/lib/binfmt.d")
PACKAGE = "qemu-user-static"
PROBE = "arch-test"
"""The program, and its package, that tells mmdebstrap whether programs of an architecture run."""
OTHER = {"x86_64": ("arm64", "qemu-aarch64"), "aarch64": ("amd64", "qemu-x86_64")}
"""For each processor: the architecture to emulate, and the name of QEMU's entry for it."""


def ensure(installer: Installer, hub: bool, table: Path = TABLE, entries: Path = ENTRIES) -> bool:
    """Makes sure that the kernel runs programs of the other architecture. Returns whether it changed something.

    Args:
        hub: whether base images come from Docker Hub. Otherwise mmdebstrap makes them, and calls `PROBE`.
    """
    architecture, name = OTHER.get(platform.machine(), ("", ""))
    if not name:
        raise RosmlError(f"no emulation is known for {platform.machine()}", "use a machine of the architecture itself")
    registered = (table / name).exists()
    probed = hub or which_system(PROBE)
    if registered and probed:
        installer.state.say(f"emulation: {architecture} runs already")
        return False
    root = [] if os.geteuid() == 0 else _sudo()
    if root is None:
        image = pinned_image(installer.state.root, "tonistiigi/binfmt")
        by_hand = f"docker run --privileged --rm {image} --install {architecture}"
        text = f"only root may let the kernel run programs of {architecture}"
        raise RosmlError(text, f"call it as root, or: {by_hand}")
    entry = _entry(entries, name)
    missing = {} if entry else {PACKAGE: f"runs programs of {architecture}"}
    if not probed:
        missing[PROBE] = "tells mmdebstrap that they run"
    if missing:
        installer.debian_packages(missing, root)
        entry = _entry(entries, name)
    if entry is None:
        raise RosmlError(f"{PACKAGE} brings no {name}.conf in {entries}", "register QEMU by hand")
    if not (table / "register").exists():
        output_of([*root, "mount", "-t", "binfmt_misc", "binfmt_misc", str(table)])
    if not (table / name).exists():  # installing the package may have done it
        argv = [*root, "tee", str(table / "register")]
        done = subprocess.run(argv, input=entry, capture_output=True, text=True, check=False)
        if done.returncode:
            remedy = "in a container, let its host do this; or take a machine of the architecture itself"
            raise RosmlError(f"the kernel does not take QEMU's entry: {done.stderr.strip()}", remedy)
    installer.state.say(f"emulation: {architecture} runs, through QEMU, until this machine restarts")
    return not registered


def _sudo() -> list[str] | None:
    """The words before a command that runs as root without a password, as on GitHub's machines; None if this user may not."""
    program = which_system("sudo")
    if not program:
        return None
    done = subprocess.run([program, "-n", "true"], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    return None if done.returncode else [program, "-n"]


def _entry(folder: Path, name: str) -> str | None:
    """QEMU's line for the kernel's table. The name of its file differs between releases."""
    files = (folder / f"{name}.conf", folder / f"{name}-static.conf")
    return next((file.read_text() for file in files if file.exists()), None)
