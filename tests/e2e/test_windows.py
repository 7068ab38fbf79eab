"""Windows of programs that `rosml run` starts: a real engine, and a display that lets in only who has its cookie."""

from __future__ import annotations

import os
import secrets
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from rosml.machine.services import Services
from tests.e2e import engine
from tests.e2e.images import Publish
from tests.e2e.person import Person, somebody

TARGET = "ros1-bookworm-desktop"
SECONDS = 120.0


@contextmanager
def display(folder: Path) -> Iterator[dict[str, str]]:
    """A virtual display (packages xvfb and xauth); gives the environment of whoever may use it."""
    authority = folder / "Xauthority"
    authority.touch(mode=0o600)
    name = next(f":{number}" for number in range(90, 1000) if not Path(f"/tmp/.X11-unix/X{number}").exists())
    subprocess.run(["xauth", "-f", str(authority), "add", name, ".", secrets.token_hex(16)], check=True)
    command = ["Xvfb", name, "-screen", "0", "1024x768x24", "-nolisten", "tcp", "-auth", str(authority)]
    with (folder / "Xvfb.log").open("w") as log:
        process = subprocess.Popen(command, stdout=log, stderr=log)
        try:
            yield {"DISPLAY": name, "XAUTHORITY": str(authority)}
        finally:
            process.terminate()
            process.wait()


def windows(environment: dict[str, str]) -> str:
    done = subprocess.run(
        ["xwininfo", "-root", "-tree"], env={**os.environ, **environment}, capture_output=True, text=True, check=False
    )
    return done.stdout + done.stderr


def ended(process: subprocess.Popen[str]) -> str:
    process.terminate()
    with suppress(subprocess.TimeoutExpired):
        return "".join(process.communicate(timeout=30))
    process.kill()
    return "".join(process.communicate())


@pytest.fixture
def person(services: Services, published: Publish, tmp_path: Path) -> Iterator[tuple[Person, str]]:
    with engine.running() as docker, somebody(docker) as found:
        yield found, docker.load(services, published(TARGET).reference, TARGET, tmp_path)


@pytest.mark.full(proof="desktop")
def test_rviz_opens_its_window(person: tuple[Person, str]) -> None:
    """As docs/run.md says: the person types the command, and nothing about windows. Without the cookie nobody gets in."""
    who, image = person
    runtime = who.folder / "runtime"
    runtime.mkdir(mode=0o700)
    with display(who.folder) as environment:
        for path in (runtime, Path(environment["XAUTHORITY"])):
            os.chown(path, who.uid, who.uid)
        end = time.monotonic() + SECONDS
        while "Root window id" not in windows(environment):
            assert time.monotonic() < end, (who.folder / "Xvfb.log").read_text()
            time.sleep(0.2)
        assert "unable to open display" in windows({**environment, "XAUTHORITY": "/dev/null"})
        who.environment |= {**environment, "XDG_RUNTIME_DIR": str(runtime)}
        script = "roscore >/dev/null & until rostopic list >/dev/null 2>&1; do sleep 0.2; done; exec rosrun rviz rviz"
        process = who.start("run", "--ros-network", "-e", "LIBGL_ALWAYS_SOFTWARE=1", image, "bash", "-c", script)
        end = time.monotonic() + SECONDS
        while "RViz" not in (seen := windows(environment)) and time.monotonic() < end and process.poll() is None:
            time.sleep(0.5)
        if picture := os.environ.get("ROSML_SCREENSHOT"):
            time.sleep(5)
            subprocess.run(["import", "-window", "root", picture], env={**os.environ, **environment}, check=True)
        said = ended(process)
        assert "RViz" in seen, seen + said
    left = [path for path in runtime.rglob("*") if path.is_file()]
    assert [oct(path.stat().st_mode & 0o777) for path in left] == ["0o600"], "one file, for this person alone"
