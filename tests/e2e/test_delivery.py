"""A file for a robot with the real Docker: which layers its store finds by itself, and which `rosml load` reads from `docker save`."""

from __future__ import annotations

import gzip
import io
import os
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry
from tests.e2e import engine

REPOSITORY = "rosml-test/delivery"
IMAGES = {"base": "ab", "night": "ac", "app": "abx", "moved": "acx"}
GZIP = "application/vnd.oci.image.layer.v1.tar+gzip"


def layer(name: str) -> bytes:
    """A layer with one file."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w") as found:
        entry = tarfile.TarInfo(name)
        entry.size = 100_000
        found.addfile(entry, io.BytesIO(name.encode() * entry.size))
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


@pytest.mark.skipif(bool(engine.missing()), reason=engine.missing())
def test_an_app_on_tonights_base_arrives_without_what_is_there(services: Services, tmp_path: Path) -> None:
    push(services)
    place = f"{services.registry}/{REPOSITORY}"
    with engine.running() as docker:
        environment = {**os.environ, "ROSML_ENGINE": "docker"}
        if docker.host:
            environment["DOCKER_HOST"] = docker.host

        def rosml(*words: str) -> subprocess.CompletedProcess[str]:
            argv = [sys.executable, "-m", "rosml", *words]
            return subprocess.run(argv, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)

        def saved(tag: str, *have: str) -> str:
            given = [word for other in have for word in ("--have", f"{place}:{other}")]
            file = str(tmp_path / tag)
            done = rosml("save", f"{place}:{tag}", *given, "--platform", "linux/amd64", "-o", file)
            assert done.returncode == 0, done.stderr
            return file

        try:
            assert docker.docker("load", "--input", saved("app")).code == 0  # a whole archive needs no rosml
            done = rosml("load", saved("night", "app"))
            assert done.returncode == 0, done.stderr
            assert "docker save" not in done.stderr  # Docker finds the lowest layer by itself
            docker.docker("rmi", f"{place}:night")
            done = rosml("load", saved("moved", "app"))
            assert done.returncode == 0, done.stderr
            assert "1 layer from docker save" in done.stderr  # the app's own, which stood on other layers
            told = docker.docker("image", "inspect", "--format", "{{.RootFS.Layers}}", f"{place}:moved")
            assert told.out.split() == f"[{' '.join(oci.digest_of(layer(name)) for name in 'acx')}]".split()
            docker.docker("rmi", f"{place}:app", f"{place}:moved")
            done = rosml("load", str(tmp_path / "moved"))
            assert done.returncode == 2
            assert f"needs 2 layers of {place}:app@sha256:" in done.stderr
        finally:
            docker.docker("rmi", *(f"{place}:{tag}" for tag in IMAGES))
