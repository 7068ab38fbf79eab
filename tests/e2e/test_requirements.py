"""Pinned Python packages have a wheel, with a hash that is in the file, for every architecture on which something runs: so that
no machine of a night finds out. They are installed for it into a folder, whatever machine this is."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from rosml.images.image_set import load
from rosml.machine.services import Services

ROOT = Path(__file__).resolve().parents[2]
FILES = sorted(file.name for file in (ROOT / "tools").glob("*.txt") if "--hash=" in file.read_text())
PLATFORMS = {
    name: architecture.wheels for name, architecture in load.load(ROOT / "matrix.yaml").matrix.architectures.items()
}


@pytest.mark.parametrize("architecture", PLATFORMS)
@pytest.mark.parametrize("file", FILES)
def test_wheels_are_there(services: Services, tmp_path: Path, file: str, architecture: str) -> None:
    argv = [services.uv, "pip", "install", "--no-deps", "--require-hashes", "--no-build", "--target", str(tmp_path)]
    argv += ["--python-platform", PLATFORMS[architecture], "--python-version", "3.12", "--requirement", f"tools/{file}"]
    done = subprocess.run(argv, cwd=ROOT, env=services.environment(), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
