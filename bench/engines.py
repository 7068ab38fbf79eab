"""Container engines that live as long as a measurement, each with an empty storage of its own."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

from rosml.base.errors import RosmlError

START_SECONDS = 60.0
STOP_SECONDS = 60.0

Pull = Callable[[str], None]
"""Pulls an image that a registry without TLS has."""

CONTAINERD = """\
version = 3
root = "{folder}/root"
state = "{folder}/state"
[grpc]
address = "{folder}/socket"
[ttrpc]
address = "{folder}/socket.ttrpc"
[plugins."io.containerd.transfer.v1.local"]
max_concurrent_unpacks = {unpacks}
"""


@contextmanager
def docker(programs: Path, folder: Path) -> Iterator[Pull]:
    """Docker with containerd's image store, which unpacks one layer after the other.

    Args:
        programs: has dockerd, containerd, containerd-shim-runc-v2 and runc.
        folder: an empty folder on a file system that overlayfs works on.

    Raises:
        RosmlError: it does not start.
    """
    config = folder / "daemon.json"
    runc = {"runc-of-the-folder": {"path": str(programs / "runc")}}
    network = {"bridge": "none", "iptables": False, "ip6tables": False, "ip-masq": False}
    store = {"features": {"containerd-snapshotter": True}}
    config.write_text(json.dumps({**network, **store, "runtimes": runc, "default-runtime": "runc-of-the-folder"}))
    host = f"unix://{folder}/socket"
    places = ["--data-root", f"{folder}/data", "--exec-root", f"{folder}/exec", "--pidfile", f"{folder}/pid"]
    with _running([str(programs / "dockerd"), "--host", host, "--config-file", str(config), *places],
                  ["docker", "--host", host, "info"], programs, folder):  # fmt: skip
        yield lambda reference: _call(["docker", "--host", host, "pull", "--quiet", reference], programs)


@contextmanager
def containerd(programs: Path, folder: Path, unpacks: int) -> Iterator[Pull]:
    """containerd alone, as Kubernetes has it.

    Args:
        programs, folder: as for `docker`.
        unpacks: how many layers it unpacks at once.
    """
    (folder / "config.toml").write_text(CONTAINERD.format(folder=folder, unpacks=unpacks))
    ctr = [str(programs / "ctr"), "--address", f"{folder}/socket"]
    with _running(
        [str(programs / "containerd"), "--config", f"{folder}/config.toml"], [*ctr, "version"], programs, folder
    ):
        yield lambda reference: _call([*ctr, "images", "pull", "--plain-http", reference], programs)


@contextmanager
def podman(programs: Path, folder: Path) -> Iterator[Pull]:
    """The machine's podman."""
    call = ["podman", "--root", f"{folder}/root", "--runroot", f"{folder}/run", "--storage-driver", "overlay"]
    try:
        yield lambda reference: _call([*call, "pull", "--quiet", "--tls-verify=false", reference], programs)
    finally:
        with suppress(RosmlError):
            _call([*call, "rmi", "--all", "--force"], programs)


@contextmanager
def storage(parent: Path) -> Iterator[Path]:
    """An empty folder for an engine, and nothing of it afterwards."""
    folder = Path(tempfile.mkdtemp(prefix="engine-", dir=parent))  # short: sockets are in it
    try:
        yield folder
    finally:
        mounts = [line.split()[1] for line in Path("/proc/mounts").read_text().splitlines()]
        for mount in sorted((path for path in mounts if path.startswith(f"{folder}/")), reverse=True):
            subprocess.run(["umount", "--lazy", mount], check=False)
        shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def _running(daemon: Sequence[str], ready: Sequence[str], programs: Path, folder: Path) -> Iterator[None]:
    """A daemon that answers."""
    with (folder / "log").open("wb") as log:
        process = subprocess.Popen(daemon, stdout=log, stderr=log, env=_environment(programs), start_new_session=True)
    try:
        end = time.monotonic() + START_SECONDS
        while subprocess.run(ready, env=_environment(programs), capture_output=True, check=False).returncode:
            if process.poll() is not None or time.monotonic() > end:
                raise RosmlError(f"{daemon[0]} did not start:\n{(folder / 'log').read_text()[-2000:]}")
            time.sleep(0.3)
        yield
    finally:
        process.terminate()
        with suppress(subprocess.TimeoutExpired):
            process.wait(STOP_SECONDS)
        process.kill()
        process.wait()


def _call(argv: Sequence[str], programs: Path) -> None:
    done = subprocess.run(argv, env=_environment(programs), stdin=subprocess.DEVNULL, capture_output=True, check=False)
    if done.returncode:
        raise RosmlError(f"{' '.join(argv)} failed:\n{done.stderr.decode(errors='replace').strip()[-2000:]}")


def _environment(programs: Path) -> dict[str, str]:
    return {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}"}
