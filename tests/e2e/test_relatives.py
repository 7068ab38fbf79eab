"""Relatives of Ubuntu's releases, whose archive cannot be reached everywhere: the base layer is built on Debian's releases of the
same time, and holds what the contract promises without ROS. bookworm and trixie, which have rows, stand for 22.04 and 24.04."""

from __future__ import annotations

import shutil
import warnings
from pathlib import Path

import pytest

from offline import debian
from rosml import ROOT
from rosml.build.push import COMPRESSION
from rosml.machine.services import Services
from tests.e2e.conftest import NAMESPACE, run
from tests.e2e.images import NATIVE, build, ca_secret

pytestmark = pytest.mark.full(proof="relatives")

LENIENT = 'Acquire::Check-Valid-Until "false"'
"""A mirror of a release that moves every day may be some weeks old."""


def base_image(services: Services, suite: str, monkeypatch: pytest.MonkeyPatch) -> str:
    """The official image, or one that is made here: of the release alone, since mirrors lack parts of old updates."""
    if not services.bases:
        return f"docker.io/library/debian:{suite}"
    archive = f"deb http://deb.debian.org/debian {suite} main"
    lenient = {"etc/apt/apt.conf.d/lenient": (0o644, f"{LENIENT};\n")}
    monkeypatch.setattr(debian, "FILES", {**debian.FILES, **lenient})
    command = debian.command
    monkeypatch.setattr(debian, "command", lambda *given: [*command(*given), f"--aptopt={LENIENT}", archive])
    return f"docker.io/library/debian:{suite}@{debian.debian(services, suite, NATIVE)}"


def told(services: Services, folder: Path, suite: str, python: str, monkeypatch: pytest.MonkeyPatch) -> str:
    """Builds the base layer on a release and checks it; what the builder said.

    Raises:
        AssertionError: the build or a check failed, with what was said.
    """
    reference = f"{services.registry}/{NAMESPACE}/relative:{suite}"
    base = [*services.buildx, "build", "--progress", "plain", "--target", "base", "--build-arg", "NUMPY=<3"]
    base += ["--build-arg", f"SOURCE_DATE_EPOCH={debian.EPOCH}", *ca_secret(services)]
    base += ["--build-context", f"os=docker-image://{base_image(services, suite, monkeypatch)}"]
    base += ["--output", f"type=image,push=true,name={reference},{COMPRESSION}"]
    done = run(*base, str(ROOT), env=services.environment())
    assert done.code == 0, done.err
    shutil.copytree(Path(__file__).parent / "relatives", folder, dirs_exist_ok=True)
    shutil.copytree(ROOT / "tests/structure/checks", folder / "checks")
    return build(services, folder, "--build-arg", f"BASE={reference}", "--build-arg", f"PYTHON={python}")


def test_ubuntu_20(services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert "relative: holds" in told(services, tmp_path, "bullseye", "3.9", monkeypatch)


def test_ubuntu_26(services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What moves every day may fail any day: it warns of what comes."""
    try:
        assert "relative: holds" in told(services, tmp_path, "sid", "3.14", monkeypatch)
    except AssertionError as error:
        warnings.warn(f"Debian sid: {str(error)[-3000:]}", stacklevel=1)
