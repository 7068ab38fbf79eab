"""An image without compilers says so where somebody builds."""

from __future__ import annotations

import subprocess

import pytest

from rosml import ROOT

SCRIPT = ROOT / "components/base/only-runs.sh"


def said(*words: str, apt: str = "", **environment: str) -> tuple[int, str]:
    """The exit code, and what it says. `apt`: how apt was called, where it is apt's hook."""
    given = f"VERSION 2\nAPT::Architecture=amd64\nCommandLine::AsString={apt.replace(' ', '%20')}\n\nhello - < 2.10 /x.deb\n"
    done = subprocess.run(
        [SCRIPT, *words], input=given, capture_output=True, text=True, env={"PATH": "/usr/bin:/bin", **environment}
    )
    return done.returncode, done.stderr


@pytest.mark.parametrize("name", ["colcon", "catkin_make", "/usr/bin/g++", "pip"])
def test_what_is_not_there_because_the_image_only_runs(name: str) -> None:
    code, text = said(name)
    assert code == 0 and text.startswith(
        f"{name}: this image only runs programs. To build, take the image of the same name without -run"
    )


def test_nothing_is_said_of_other_commands() -> None:
    assert said("no-such-command") == said("ros2") == (0, "")


@pytest.mark.parametrize("packages", ["build-essential", "-y gcc-12 x", "x g++"])
def test_a_compiler_is_not_installed(packages: str) -> None:
    code, text = said(apt=f"apt-get install {packages}")
    assert code == 1 and "this image only runs programs" in text


@pytest.mark.parametrize(
    "call",
    ["apt-get install gcc-12-base libgcc-s1", "apt-get upgrade", "apt install ros-jazzy-gcc", "apt-get remove gcc"],
)
def test_other_packages_are_installed(call: str) -> None:
    assert said(apt=call) == (0, "")


def test_the_images_own_build_is_left_alone() -> None:
    assert said(apt="apt-get install g++", RUNTIME="1") == (0, "")
