"""An image that somebody else made: what is read of it, and how steps run on it."""

from __future__ import annotations

import io
import json
import re
import tarfile
from pathlib import Path

import pytest
from registry_stand_in import StandIn

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.containerize import adopt
from rosml.containerize.app_base import Base
from rosml.containerize.app_inputs import Values
from rosml.images.builds import adopted
from rosml.images.builds.adopted import Adopted
from rosml.images.image_set import load
from rosml.machine import buildx
from rosml.machine.services import Services

RELEASE = "ID=debian\nVERSION_CODENAME=bookworm\n"
VALUES = Values()


@pytest.fixture
def services(stand_in: StandIn, tmp_path: Path) -> Services:
    return Services(tmp_path, stand_in.address, ("buildx",), "rosml", "buildkitd", None, "", "", "", bases=())


def leaves(monkeypatch: pytest.MonkeyPatch, *files: str) -> None:
    """Lets the builder copy these files out of an image, and an os-release."""

    def run(_services: Services, bake: buildx.Bake) -> None:
        [output] = json.loads(Path(bake.file).read_text())["target"]["system"]["output"]
        with tarfile.open(output.partition("dest=")[2], "w") as archive:
            for name in ("etc/os-release", "bin/bash", "bin/apt-get", *files):
                entry = tarfile.TarInfo(name)
                entry.size = len(RELEASE)
                archive.addfile(entry, io.BytesIO(RELEASE.encode()))

    monkeypatch.setattr(buildx, "run", run)


def test_a_ros_that_the_matrix_does_not_have(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is installed beside it, as beside one that it has."""
    leaves(monkeypatch, "opt/ros/setup.bash")
    with pytest.raises(RosmlError, match="vendor:1 has another ROS in /opt/ros") as caught:
        adopt.with_ros(Base("vendor:1", "sha256:1", {}), services, VALUES, ("linux/amd64",), print)
    assert caught.value.remedy == "add --ros-distro NAME"


def test_an_image_that_cannot_be_looked_at(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    leaves(monkeypatch, *(f"etc/os-release/{number}" for number in range(300)))
    with pytest.raises(RosmlError, match=r"vendor:1 cannot be examined: .*200 files") as caught:
        adopted.look(services, "vendor:1", "linux/amd64", ["jazzy"])
    assert caught.value.remedy == "name another base image"
    assert not [*services.state.rglob("*.tar")], "it may be large"

    def fails(_services: Services, bake: buildx.Bake) -> None:
        raise RosmlError('failed to calculate checksum of ref x::y: "/etc/os-release": not found', "run 'rosml locks'")

    monkeypatch.setattr(buildx, "run", fails)
    with pytest.raises(RosmlError, match="is a link that leads nowhere") as caught:
        adopted.look(services, "vendor:1", "linux/amd64", ["jazzy"])
    assert caught.value.remedy == "name another base image"


def test_steps_run_as_on_our_own_images(tmp_path: Path) -> None:
    """What an image says of shells, Python and the loader is for its programs, and has it in the end."""
    image_set = load.load(ROOT / "matrix.yaml")
    environment = {"BASH_ENV": "/etc/noise", "PYTHONHOME": 'a\n"$b"', "HOME": "/none", "SDK": "ready"}
    image = image_set.by_target["ros1-bookworm-core"]
    onto = Adopted("vendor@sha256:1", image_set, image, environment, shell=("conda", "run", "/bin/bash", "-c"))
    found = adopted.base_targets(onto, "base", {}, tmp_path, tmp_path)
    first, last = found["base-system"]["dockerfile-inline"], found["base"]
    assert re.findall("^(?:ENV|SHELL) (.*)", first, re.M)[:-1] == [
        '["/bin/sh", "-c"]',
        "BASH_ENV=",
        "PYTHONHOME=",
        "HOME=/root",
    ]
    assert 'SHELL ["conda", "run", "/bin/bash", "-c"]\n' in last["dockerfile-inline"]
    assert last["args"] == {f"KEPT_{name}": value for name, value in environment.items() if name != "SDK"}


def test_what_an_image_claims_to_be_of_ours(tmp_path: Path) -> None:
    """Its labels say nothing to `rosml join`, which would look for an image without compilers, or take it for an app."""
    image_set = load.load(ROOT / "matrix.yaml")
    claims = {"io.rosml.runtime": "core-run", "io.rosml.app": "run", "io.rosml.python": "3.8", "maintainer": "me"}
    onto = Adopted("vendor@sha256:1", image_set, image_set.by_target["ros1-bookworm-core"], labels=claims)
    found = adopted.base_targets(onto, "base", {}, tmp_path, tmp_path)["base"]["labels"]
    wanted = ("io.rosml.runtime", "io.rosml.app", "io.rosml.python", "maintainer")
    assert [found.get(name) for name in wanted] == ["", "", "3.11", None]


def test_a_framework_that_no_variable_names(services: Services, monkeypatch: pytest.MonkeyPatch) -> None:
    """`rosml join` asks the label: two releases of torch in one folder would work with neither."""
    leaves(monkeypatch, "carries/torch/__init__.py", "carries/cuda/version.json")
    base = adopt.with_ros(Base("vendor:1", "sha256:1", {}), services, VALUES, ("linux/amd64",), print)
    assert base.adopted
    found = adopted.base_targets(base.adopted, "base", {}, services.state, services.state)
    assert found["base"]["labels"]["io.rosml.own"] == "cuda torch"
