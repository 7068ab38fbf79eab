"""Builders beside the one that `rosml setup` started: a machine of a fleet, or one that a small project has to itself."""

from __future__ import annotations

import os
import re
import signal
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from rosml import ROOT
from rosml.machine.services import Services
from rosml.machine.setup.builder import config
from tests.e2e.calls import wait_until


@dataclass
class Builder:
    """A buildkitd of its own with an empty cache, under a name that buildx knows."""

    name: str
    process: subprocess.Popen[bytes]
    folder: Path


@contextmanager
def builder(
    name: str,
    folder: Path,
    services: Services,
    root: Path | None = None,
    certificates: Mapping[str, Sequence[Path]] | None = None,
    env: Mapping[str, str] | None = None,
) -> Iterator[Builder]:
    """Starts one. `root`: where it keeps its cache. `certificates`: files that it trusts for registries, by host. `env`:
    what its environment has beside this one's."""
    assert services.builder_kind == "buildkitd", "needs a buildkitd of our own"
    folder.mkdir()
    runc = re.search(r'^  binary = "(.*)"$', (ROOT / ".state/run/buildkitd.toml").read_text(), re.MULTILINE)
    socket = folder / "buildkitd.sock"
    places = {"root": root or folder / "root", "socket": socket, "otel": folder / "otel.sock", "runc": runc and runc[1]}
    texts = {key: str(value) for key, value in places.items()}
    text = config(services.registry, bool(services.bases), texts, certificates)
    (folder / "buildkitd.toml").write_text(text)
    command = [str(ROOT / ".state/bin/buildkitd"), "--config", str(folder / "buildkitd.toml")]
    with (folder / "log").open("wb") as log:
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=log,
            env={**os.environ, **(env or {})},
            start_new_session=True,
        )
    buildx = [*services.buildx]
    try:
        wait_until(socket.exists, 30, lambda: (folder / "log").read_text()[-2000:], process)
        create = [*buildx, "create", "--name", name, "--driver", "remote", f"unix://{socket}"]
        subprocess.run(create, env=services.environment(), check=True, capture_output=True)
        yield Builder(name, process, folder)
    finally:
        subprocess.run([*buildx, "rm", name], env=services.environment(), capture_output=True, check=False)
        process.terminate()
        try:
            process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        _clear(folder)


def _clear(folder: Path) -> None:
    """Ends what a builder that was killed has left: its containers, and their mounts."""
    for line in reversed(Path("/proc/self/mounts").read_text().splitlines()):
        if (place := line.split()[1]).startswith(str(folder)):
            subprocess.run(["umount", "--lazy", place], check=False)
    for process in Path("/proc").glob("[0-9]*"):
        try:
            words, root = (process / "cmdline").read_bytes(), os.readlink(process / "root")
            if os.fsencode(folder) in words or str(folder) in root:
                os.kill(int(process.name), signal.SIGKILL)
        except OSError:
            continue
