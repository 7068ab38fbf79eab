"""An image without compilers says so where somebody builds."""

from __future__ import annotations

import subprocess

import pytest

from rosml import ROOT

SCRIPT = ROOT / "components/base/only-runs.sh"


def call(*words: str, apt: str = "", **environment: str) -> tuple[int, str]:
    """The exit code, and the message. `apt`: how apt was called, if it calls the script."""
    text = f"VERSION 2\nAPT::Architecture=amd64\nCommandLine::AsString={apt.replace(' ', '%20')}\n\nhello - < 2.10 /x.deb\n"
    env = {"PATH": "/usr/bin:/bin", **environment}
    end = subprocess.run([SCRIPT, *words], input=text, capture_output=True, text=True, env=env, check=False)
    return end.returncode, end.stderr


@pytest.mark.parametrize("name", ["colcon", "catkin_make", "/usr/bin/g++", "pip"])
def test_what_is_not_there_because_the_image_only_runs(name: str) -> None:
    code, text = call(name)
    assert code == 0 and text.startswith(f"{name}: this image only runs programs. To build, take the image")


@pytest.mark.parametrize("packages", ["build-essential", "-y gcc-12 x", "x g++"])
def test_a_compiler_is_not_installed(packages: str) -> None:
    code, text = call(apt=f"apt-get install {packages}")
    assert code == 1 and "this image only runs programs" in text
    assert call(apt=f"apt-get install {packages}", RUNTIME="1") == (0, ""), "the image's own build"


@pytest.mark.parametrize("apt", ["install gcc-12-base libgcc-s1", "upgrade", "install ros-jazzy-gcc", "remove gcc"])
def test_other_commands_go_on(apt: str) -> None:
    assert call(apt=f"apt-get {apt}") == call("no-such-command") == call("ros2") == (0, "")
