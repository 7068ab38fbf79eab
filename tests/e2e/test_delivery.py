"""A file for a robot with the real Docker: which layers its store finds by itself, and which `rosml load` reads from `docker save`."""

from __future__ import annotations

import gzip
import io
import os
import subprocess
import sys
import tarfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from random import Random

import pytest

from rosml import ROOT
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry
from tests.e2e import engine

REPOSITORY = "rosml-test/delivery"
IMAGES = {"base": "ab", "night": "ac", "app": "abx", "moved": "acx", "monday": "amx", "tuesday": "anx"}
GZIP = "application/vnd.oci.image.layer.v1.tar+gzip"


def layer(name: str) -> bytes:
    """A layer with one file. Those of `m` and `n` are nearly the same."""
    data = Random(0).randbytes(400_000) + name.encode() if name in "mn" else name.encode() * 100_000
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w") as archive:
        entry = tarfile.TarInfo("file" if name in "mn" else name)
        entry.size = len(data)
        archive.addfile(entry, io.BytesIO(data))
    return out.getvalue()


def push(services: Services) -> None:
    """Puts images with layers of gzip into the local registry: Debian's docker.io knows no zstd."""
    with Registry(services.registry) as registry:
        for tag, names in IMAGES.items():
            plain = [layer(name) for name in names]
            packed = [gzip.compress(data, mtime=0) for data in plain]
            diff_ids = [oci.digest_of(data) for data in plain]
            facts = {"os": "linux", "architecture": "amd64", "config": {"Labels": {"tag": tag}}}
            config = oci.encoded({**facts, "rootfs": {"type": "layers", "diff_ids": diff_ids}})
            for data in (*packed, config):
                registry.put_blob(REPOSITORY, data)
            layers = [oci.descriptor(GZIP, data) for data in packed]
            content = {"schemaVersion": 2, "mediaType": oci.IMAGE, "config": oci.descriptor(oci.CONFIG, config)}
            registry.put_manifest(REPOSITORY, tag, {**content, "layers": layers})


@pytest.fixture(params=[False, True], ids=["newest", "debian"])
def robot(services: Services, tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Robot]:
    """A robot with the real Docker, and images in the local registry. Many robots have one as old as Debian's."""
    push(services)
    with engine.running(request.param) as docker:
        robot = Robot(docker, f"{services.registry}/{REPOSITORY}", tmp_path)
        yield robot
        docker.docker("rmi", "--force", *(robot.name(tag) for tag in IMAGES))


@dataclass
class Robot:
    """A robot. `place` is the repository of the images."""

    docker: engine.Engine
    place: str
    folder: Path

    def name(self, tag: str) -> str:
        """The complete reference of an image."""
        return f"{self.place}:{tag}"

    def rosml(self, *words: str) -> subprocess.CompletedProcess[str]:
        """Calls rosml for this robot's Docker."""
        environment = {**self.docker.variables(), "ROSML_ENGINE": "docker"}
        argv = [sys.executable, "-m", "rosml", *words]
        return subprocess.run(argv, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)

    def saved(self, tag: str, *have: str) -> str:
        """A file for the robot."""
        options = [word for other in have for word in ("--have", self.name(other))]
        file = str(self.folder / tag)
        done = self.rosml("save", self.name(tag), *options, "--platform", "linux/amd64", "-o", file)
        assert done.returncode == 0, done.stderr
        return file

    def require(self, tag: str) -> None:
        """Checks that Docker has the layers of an image."""
        inspected = self.docker.docker("image", "inspect", "--format", "{{.RootFS.Layers}}", self.name(tag))
        assert inspected.out.split() == f"[{' '.join(oci.digest_of(layer(name)) for name in IMAGES[tag])}]".split()


@pytest.mark.skipif(bool(engine.missing()), reason=engine.missing())
def test_a_layer_arrives_as_what_differs(robot: Robot) -> None:
    assert robot.docker.docker("load", "--input", robot.saved("monday")).code == 0
    file = robot.saved("tuesday", "monday")
    assert os.path.getsize(file) < 20_000
    done = robot.rosml("load", file)
    assert done.returncode == 0, done.stderr
    assert "differences of 1 layer" in done.stdout
    robot.require("tuesday")


@pytest.mark.skipif(bool(engine.missing()), reason=engine.missing())
def test_an_app_on_tonights_base_arrives_without_what_is_there(robot: Robot) -> None:
    docker = robot.docker
    finds_lower_layers = not docker.docker("info", "--format", "{{.DriverStatus}}").out.count("containerd.snapshotter")
    assert docker.docker("load", "--input", robot.saved("app")).code == 0  # a whole archive needs no rosml
    done = robot.rosml("load", robot.saved("night", "app"))
    assert done.returncode == 0, done.stderr
    assert ("docker save" not in done.stderr) == finds_lower_layers
    docker.docker("rmi", robot.name("night"))
    done = robot.rosml("load", robot.saved("moved", "app"))
    assert done.returncode == 0, done.stderr
    layers = "1 layer" if finds_lower_layers else "2 layers"
    assert f"{layers} from docker save" in done.stderr  # the app's own stood on other layers
    robot.require("moved")
    docker.docker("rmi", robot.name("app"), robot.name("moved"))
    done = robot.rosml("load", str(robot.folder / "moved"))
    assert done.returncode == 2
    assert f"needs 2 layers of {robot.name('app')}@sha256:" in done.stderr
