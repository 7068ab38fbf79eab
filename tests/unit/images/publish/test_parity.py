"""What must be the same on all architectures of an index, with the names and versions that our own locks have."""

from __future__ import annotations

from typing import Any

import pytest
from conftest import ROOT

from rosml.base.errors import RosmlError
from rosml.images.image_set import lock_file
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.publish import same_content


def config(architecture: str) -> dict[str, Any]:
    return {"architecture": architecture, "config": {"Labels": {"a": "b"}, "Env": ["C=d"], "User": "root"}}


CONFIGS = {name: config(name) for name in ("amd64", "arm64")}


def inside(image_set: ImageSet, image: Image, platform: str) -> dict[str, str]:
    """The versions that an image's parts record of themselves."""
    versions: dict[str, str] = {}
    for name in image.parts:
        part = image_set.part_by_name[name]
        lock = dict(zip(part.platforms, part.locks, strict=True))[platform]
        versions |= lock_file.versions((ROOT / lock).read_text())
    return versions


def test_every_image_that_both_architectures_have_a_lock_of_can_have_an_index(real: ImageSet) -> None:
    platforms = {architecture: facts.platform for architecture, facts in real.matrix.architectures.items()}
    compared = set()
    for image in real.images:
        if image.parts and image.locked and set(image.platforms) == set(platforms.values()):
            versions = {architecture: inside(real, image, platform) for architecture, platform in platforms.items()}
            released = [item.name for item in image.brought if item.released]
            same_content.require(image.target, CONFIGS, versions, released)
            content = same_content.content(versions["amd64"], released)
            compared |= {(image.framework, image.stack, name) for name in content}
    assert ("tensorflow", "cpu", "tensorflow") in compared and ("ml", "cpu", "torch") in compared
    assert {("torch", "cu130", name) for name in ("CUDA", "cuDNN", "NCCL", "torch", "numpy")} <= compared


@pytest.mark.parametrize(
    ("amd64", "arm64", "what"),
    [
        ({"torch": "2.10.0+cpu"}, {"torch": "2.10.1"}, "torch inside is 2.10.0 on amd64, 2.10.1 on arm64"),
        ({"tensorflow-cpu": "2.20.0"}, {}, "tensorflow inside is 2.20.0 on amd64, nothing on arm64"),
        ({"nvidia-cudnn-cu13": "9.20"}, {"nvidia-cudnn-cu13": "9.21"}, "cuDNN inside is 9.20 on amd64, 9.21 on arm64"),
        ({"nvidia-cuda-runtime": "13.0.96"}, {"nvidia-cuda-runtime": "13.0.97"}, "CUDA inside is 13.0.96 on amd64"),
        ({"ros-distro": "jazzy"}, {"ros-distro": "kilted"}, "ROS's distribution inside is jazzy on amd64"),
    ],
)
def test_another_content_is_refused(amd64: dict[str, str], arm64: dict[str, str], what: str) -> None:
    with pytest.raises(RosmlError) as error:
        same_content.require("x", CONFIGS, {"amd64": amd64, "arm64": arm64}, ["torch", "tensorflow"])
    assert what in error.value.message


def test_what_an_architecture_may_have_to_itself() -> None:
    amd64 = {"python3-numpy": "1.24.2-1+b1", "tensorflow-cpu": "2.20.0", "torch": "2.10.0+cpu", "nvidia-cufile": "1"}
    arm64 = {"python3-numpy": "1.24.2-1", "tensorflow": "2.20.0", "torch": "2.10.0"}
    same_content.require("x", CONFIGS, {"amd64": amd64, "arm64": arm64}, ["torch", "tensorflow"])


def test_what_an_image_promises_is_compared() -> None:
    other = config("arm64")
    other["config"]["User"] = "robot"
    with pytest.raises(RosmlError, match="User is root on amd64, robot on arm64"):
        same_content.require("x", {"amd64": config("amd64"), "arm64": other}, {})
    with pytest.raises(RosmlError, match="says that it is for amd64"):
        same_content.require("x", {"arm64": config("amd64")}, {})
