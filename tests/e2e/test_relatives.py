"""Relatives of Ubuntu's releases, whose archive cannot be reached everywhere: the base layer is built on Debian's releases of the
same time, and holds what the contract promises without ROS. bookworm and trixie, which have rows, stand for 22.04 and 24.04."""

from __future__ import annotations

import shutil
import warnings
from pathlib import Path

import pytest

from offline import debian
from rosml import ROOT
from rosml.images.builds import apt_sources
from rosml.images.builds.push import COMPRESSION
from rosml.machine.services import Services
from tests.e2e.calls import NAMESPACE
from tests.e2e.images import NATIVE, SOURCES, build, buildx, context

pytestmark = pytest.mark.full(proof="relatives")

PIP_20 = "4ae14a42d8adba3205ebeb38aa68cfc0b6c346e1ae2e699a0b3bad4da19cef5c"
"""The sha256 of pip 20.0.2, which Ubuntu 20.04 has."""


def base_image(services: Services, suite: str) -> str:
    """The official image, or one that is made here."""
    if not services.bases:
        return f"docker.io/library/debian:{suite}"
    return f"docker.io/library/debian:{suite}@{debian.debian(services, suite, NATIVE)}"


def release_alone(monkeypatch: pytest.MonkeyPatch, suite: str) -> None:
    """Makes base images from the release alone, since mirrors lack parts of old updates."""
    files = [Path("/etc/apt/sources.list"), *Path("/etc/apt/sources.list.d").glob("*")]
    mirror = apt_sources.parse({str(file): file.read_text() for file in files if file.is_file()}, "this machine")[0]
    command = debian.command
    archive = f"deb {mirror.address} {suite} main"
    monkeypatch.setattr(debian, "command", lambda *words: [*command(*words), archive])


def with_older_pip(services: Services, folder: Path, reference: str) -> str:
    """A release with the pip of Ubuntu 20.04 in the place of its own; gives its reference."""
    folder.mkdir()
    (folder / "pip").mkdir()
    (folder / "pip/requirements.txt").write_text(f"pip==20.0.2 --hash=sha256:{PIP_20}\n")
    steps = [
        "install-packages python3-pip python3-venv",
        "online python3 -m pip download --no-deps --require-hashes --dest /pip --requirement /pip/requirements.txt",
        "rm -r /usr/lib/python3/dist-packages/pip /usr/lib/python3/dist-packages/pip-* /usr/share/python-wheels/pip-*",
        "python3 -m zipfile -e /pip/pip-20.0.2-py2.py3-none-any.whl /usr/lib/python3/dist-packages",
        "mv /pip/pip-20.0.2-py2.py3-none-any.whl /usr/share/python-wheels",
        "rm -r /pip",
    ]
    context(reference, folder, steps)
    (folder / "Dockerfile").write_text((folder / "Dockerfile").read_text().replace("\nRUN", "\nCOPY pip /pip\nRUN", 1))
    name = f"{services.registry}/{NAMESPACE}/relative:older-pip"
    buildx(services, "--output", f"type=image,push=true,name={name},{COMPRESSION}", str(folder))
    return name


def holds(services: Services, folder: Path, base: str, suite: str, python: str) -> None:
    """Builds the base layer on a release and checks it.

    Raises:
        AssertionError: the build or a check failed, with what was said.
    """
    reference = f"{services.registry}/{NAMESPACE}/relative:{suite}"
    options = ["--target", "base", "--build-arg", "NUMPY=<3", "--build-arg", f"SOURCE_DATE_EPOCH={debian.EPOCH}"]
    options += ["--build-context", f"os=docker-image://{base}"]
    options += ["--output", f"type=image,push=true,name={reference},{COMPRESSION}"]
    buildx(services, *options, str(ROOT))
    shutil.copytree(SOURCES / "relatives", folder, dirs_exist_ok=True)
    shutil.copytree(ROOT / "tests/structure/checks", folder / "checks")
    output = build(services, folder, "--build-arg", f"BASE={reference}", "--build-arg", f"PYTHON={python}")
    assert "relative: holds" in output


def test_ubuntu_20(services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its own pip installs what contradicts the constraints, and only warns."""
    release_alone(monkeypatch, "bullseye")
    base = with_older_pip(services, tmp_path / "older", base_image(services, "bullseye"))
    holds(services, tmp_path / "relative", base, "bullseye", "3.9")


def test_ubuntu_26(services: Services, tmp_path: Path) -> None:
    """What moves every day may fail any day: it warns of what comes."""
    try:
        holds(services, tmp_path / "relative", base_image(services, "sid"), "sid", "3.14")
    except AssertionError as error:
        warnings.warn(f"Debian sid: {str(error)[-3000:]}", stacklevel=1)
