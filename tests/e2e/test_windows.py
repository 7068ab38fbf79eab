"""Windows of programs that `rosml run` starts: a real engine, and a display that lets in only who has its cookie."""

from __future__ import annotations

import os
import secrets
import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from rosml.machine.services import Services
from tests.e2e import engine
from tests.e2e.calls import wait_until
from tests.e2e.images import Publish
from tests.e2e.person import Person, somebody

SECONDS = 120.0

WINDOW = """\
from PyQt5.QtCore import QTimer
from PyQt5.QtWidgets import QApplication, QLabel

def look():
    if label.windowHandle().isExposed():
        print(app.platformName(), flush=True)
        app.quit()

app = QApplication([])
label = QLabel("A window by rosml run")
label.resize(400, 200)
label.show()
timer = QTimer()
timer.timeout.connect(look)
timer.start(100)
app.exec()
"""
"""Opens a window, and once it is seen says by which platform of Qt's."""


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


@contextmanager
def compositor(who: Person, name: str) -> Iterator[None]:
    """A Wayland session of the person's without a screen (package weston)."""
    options = ["--backend=headless-backend.so", "--use-pixman", "--no-config", "--debug", f"--socket={name}"]
    log = who.folder / "weston.log"
    with log.open("w") as file:
        process = subprocess.Popen(
            [*who.become, "weston", *options], env={**os.environ, **who.environment}, stdout=file, stderr=file
        )
        try:
            wait_until((who.folder / "runtime" / name).exists, SECONDS, log.read_text, process)
            yield
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
def person() -> Iterator[tuple[Person, engine.Engine]]:
    """Who has a folder for the session, as a login makes it."""
    with engine.running() as docker, somebody(docker) as somebody_here:
        runtime = somebody_here.folder / "runtime"
        runtime.mkdir(mode=0o700)
        os.chown(runtime, somebody_here.uid, somebody_here.uid)
        somebody_here.environment["XDG_RUNTIME_DIR"] = str(runtime)
        yield somebody_here, docker


@pytest.mark.full(proof="desktop")
def test_rviz_opens_its_window(
    person: tuple[Person, engine.Engine], services: Services, published: Publish, tmp_path: Path
) -> None:
    """As docs/run.md says: the person types the command, and nothing about windows. Without the cookie nobody gets in."""
    who, docker = person
    target = "ros1-bookworm-desktop"
    image = docker.image(services, published(target).reference, target, tmp_path)
    with display(who.folder) as environment:
        os.chown(environment["XAUTHORITY"], who.uid, who.uid)
        wait_until(lambda: "Root window id" in windows(environment), SECONDS, (who.folder / "Xvfb.log").read_text)
        assert "unable to open display" in windows({**environment, "XAUTHORITY": "/dev/null"})
        who.environment |= environment
        script = "roscore >/dev/null & until rostopic list >/dev/null 2>&1; do sleep 0.2; done; exec rosrun rviz rviz"
        process = who.start(
            "run", "--trust", "--ros-network", "-e", "LIBGL_ALWAYS_SOFTWARE=1", image, "bash", "-c", script
        )
        end = time.monotonic() + SECONDS
        while "RViz" not in (seen := windows(environment)) and time.monotonic() < end and process.poll() is None:
            time.sleep(0.5)
        if picture := os.environ.get("ROSML_SCREENSHOT"):
            time.sleep(5)
            subprocess.run(["import", "-window", "root", picture], env={**os.environ, **environment}, check=True)
        output = ended(process)
        assert "RViz" in seen, seen + output
    files = [path for path in (who.folder / "runtime").rglob("*") if path.is_file()]
    assert [oct(path.stat().st_mode & 0o777) for path in files] == ["0o600"], "one file, for this person alone"


@pytest.mark.full(proof="desktop")
def test_a_window_by_wayland(
    person: tuple[Person, engine.Engine], services: Services, published: Publish, tmp_path: Path
) -> None:
    """A session that has no X11 (package weston), and a program that takes what it finds. Its user has another uid than root."""
    who, docker = person
    target = "ros1-bookworm-core"
    steps = ["install-packages --no-install-recommends python3-pyqt5 qtwayland5"]
    image = docker.image(services, published(target).reference, f"{target}-qt", tmp_path, *steps)
    who.environment |= {"DISPLAY": "", "WAYLAND_DISPLAY": "wayland-7"}
    with compositor(who, "wayland-7"):
        done = who.run(image, "python3", "-c", WINDOW)
        if picture := os.environ.get("ROSML_SCREENSHOT"):
            shown = who.start("run", "--network", "none", image, "python3", "-c", WINDOW.replace("app.quit()", "None"))
            time.sleep(10)
            who.other("weston-screenshooter")
            shutil.copy(next(who.folder.glob("*.png")), picture)
            ended(shown)
    assert (done.code, done.out) == (0, "wayland\n"), done
