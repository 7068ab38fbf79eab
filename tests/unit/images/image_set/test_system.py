"""Which ROS fits an image that somebody else made: by what it says of its system."""

from __future__ import annotations

import dataclasses

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.images.image_set import load
from rosml.images.image_set.model import ImageSet
from rosml.images.image_set.system import NEEDED, System, choose, system

UBUNTU = """PRETTY_NAME="Ubuntu 24.04.3 LTS"
NAME="Ubuntu"
VERSION_ID="24.04"
VERSION_CODENAME=noble
ID=ubuntu
ID_LIKE=debian
"""
JAMMY = UBUNTU.replace("24.04.3", "22.04.5").replace("24.04", "22.04").replace("noble", "jammy")
BOOKWORM = "PRETTY_NAME='Debian GNU/Linux 12'\nID=debian\nVERSION_ID=\"12\"\nVERSION_CODENAME=bookworm\n"


@pytest.fixture(scope="module")
def image_set() -> ImageSet:
    return load.load(ROOT / "matrix.yaml")


@pytest.mark.parametrize(
    ("release", "distribution", "component", "target"),
    [
        (UBUNTU, "", "core", "jazzy-core"),
        (UBUNTU, "kilted", "base", "kilted-base"),
        (JAMMY, "", "core", "humble-core"),
        (JAMMY, "iron", "core", "iron-core"),
        (UBUNTU.replace("24.04", "20.04").replace("noble", "focal"), "", "core", "noetic-core"),
        (UBUNTU.replace("24.04", "26.04").replace("noble", "resolute"), "", "core", "lyrical-core"),
        (BOOKWORM, "", "core", "ros1-bookworm-core"),
        (BOOKWORM, "noetic", "desktop", "ros1-bookworm-desktop"),
        (BOOKWORM, "jazzy", "core", "jazzy-wheels-core"),
    ],
)
def test_the_row_that_fits(image_set: ImageSet, release: str, distribution: str, component: str, target: str) -> None:
    assert choose(image_set, system(release), "vendor:1", distribution, component, ["amd64"]).target == target


@pytest.mark.parametrize(
    ("of_image", "distribution", "component", "says"),
    [
        (system(JAMMY), "jazzy", "core", "vendor:1 is Ubuntu 22.04.5 LTS, which has humble and iron; jazzy stands on ubuntu:24.04"),
        (system(JAMMY), "jazy", "core", "no ROS distribution named 'jazy'; did you mean 'jazzy'?"),
        (system(JAMMY), "", "robot", "no component named 'robot'"),
        (system(JAMMY), "", "core-run", "no component named 'core-run'"),
        (system('ID=fedora\nPRETTY_NAME="Fedora Linux 42"'), "", "core", "vendor:1 is Fedora Linux 42, and ROS is installed on"),
        (system(JAMMY, tools={*NEEDED} - {"source for apt"}), "", "core", "vendor:1 has no source for apt, so ROS cannot be installed"),
        (system(JAMMY, tools={*NEEDED} - {"apt-get"}), "", "core", "vendor:1 has no apt-get, so ROS cannot be installed on it"),
        (System(tools=frozenset(NEEDED)), "", "core", "vendor:1 does not say which system it has"),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_named(
    image_set: ImageSet, of_image: System, distribution: str, component: str, says: str
) -> None:
    with pytest.raises(RosmlError) as caught:
        choose(image_set, of_image, "vendor:1", distribution, component, ["amd64"])
    assert caught.value.message.startswith(says) and caught.value.remedy and caught.value.exit_code == 2


def test_an_architecture_that_the_row_lacks(image_set: ImageSet) -> None:
    with pytest.raises(RosmlError, match="jazzy-wheels is for amd64, and not for arm64"):
        choose(image_set, system(BOOKWORM), "vendor:1", "jazzy", "core", ["amd64", "arm64"])


@given(st.text())
def test_os_release_is_a_strangers_word(text: str) -> None:
    facts = dataclasses.asdict(system(text + "\nID=debian\x1b[31m\n"))
    for value in facts.values():
        assert not isinstance(value, str) or (value.isprintable() and len(value) <= 80)
