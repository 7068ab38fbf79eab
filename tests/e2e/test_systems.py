"""Each stack's frameworks on systems with other Pythons, compilers and libraries of C: Debian's releases, and the one to come.

forky, which has no row in matrix.yaml, is Debian's unstable suite. Its Python 3.14 is that of Ubuntu 26.04.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from rosml.machine.services import Services
from tests import regctl
from tests.e2e.calls import publish
from tests.e2e.images import Publish

pytestmark = [pytest.mark.full(proof="systems"), pytest.mark.timeout(7200)]

RELEASES = [
    f"ros1-{release}-core-{content}"
    for release in ("bookworm", "trixie")
    for content in ("ml-cu128", "torch-cu130", "torch-cu132", "tensorflow-cpu")
]
"""Images with all frameworks that a stack has on a release, apart from PyTorch for the CPU, which only PyTorch's own index has."""

FORKY = [f"ros1-forky-core-{content}" for content in ("torch-cu128", "torch-cu130", "torch-cu132", "onnx-cpu314")]

SID = "docker.io/library/debian:sid"

SET = """\
extends: rosml
registry: localhost/none
default: {targets: [ros1-forky-core-torch-cu130], group: [ros1-forky-core]}
addons: {onnx: }
operating_systems:
  forky:
    image: @image@
    digest: @digest@
    python: "3.14"
    numpy: ">=2.3,<2.4"
    architectures: [amd64]
    tools: >-
      catkin python3-rosdep2 vcstool
      colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata
      python3-colcon-output python3-colcon-package-information python3-colcon-package-selection
      python3-colcon-parallel-executor python3-colcon-ros
    provides: {setuptools: 78.1.1, packaging: "26.0", wheel: 0.46.3, six: 1.17.0, pyyaml: 6.0.3}
distributions:
  ros1-forky:
    os: forky
    ros: 1
    ros_distro: Debian
    packages: rosbash ros-{component} ros-{component}-dev ros-{component}-python-dev
    components: [core]
    default_stack: [cu130, cu128]
    experimental: true
"""
"""forky as a set of its own, with the locks of Python 3.14."""


@pytest.mark.parametrize("target", RELEASES)
def test_a_stack_on_a_release(published: Publish, target: str) -> None:
    assert published(target).result["failed"] == 0


@pytest.fixture
def forky(checkout: Path, services: Services) -> Path:
    """A checkout with the set. A base image that is made here has no digest beforehand."""
    digest = f"sha256:{'0' * 64}" if services.bases else regctl.digest(services, SID)
    (checkout / "set.yaml").write_text(SET.replace("@image@", SID).replace("@digest@", digest))
    return checkout


@pytest.mark.parametrize("target", FORKY)
def test_a_stack_on_the_release_to_come(forky: Path, target: str) -> None:
    done = publish(target, root=forky)
    assert done.code == 0, done.err
    assert json.loads(done.out)["failed"] == 0
