"""What buildx makes of a bake file. `--print` needs no builder."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

from rosml.base.errors import RosmlError
from rosml.images.bake import bake_file
from rosml.images.image_set.model import ImageSet


def buildx() -> list[str]:
    """The machine's buildx: the one that the set-up chose, or any other."""
    services = ROOT / ".state/services.json"
    if services.is_file():
        return [str(word) for word in json.loads(services.read_text())["buildx"]]
    if program := shutil.which("buildx", path=f"{ROOT}/.state/bin:{os.environ.get('PATH', '')}"):
        return [program]
    if shutil.which("docker") and not subprocess.run(["docker", "buildx", "version"], capture_output=True).returncode:
        return ["docker", "buildx"]
    pytest.skip("no buildx on this machine; 'rosml setup' installs it")


def evaluated(*names: str, file: Path | None = None, **env: str) -> dict[str, Any]:
    """What buildx makes of a bake file, or of the committed ones."""
    read = [file] if file else [ROOT / bake_file.NAME, ROOT / bake_file.TESTS]
    shells = {key for key in os.environ if key.upper().endswith("_PROXY")} | {"REGISTRY", "PLATFORM"}  # the user's own
    clean = {key: value for key, value in os.environ.items() if key not in shells}
    done = subprocess.run(
        [*buildx(), "bake", "--print", *(f"--file={path}" for path in read), *names],
        cwd=ROOT,
        env={**clean, "GOGC": "off", **env},  # it ends before it is worth to collect garbage
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    if done.returncode:
        raise RosmlError(done.stderr)
    result: dict[str, Any] = json.loads(done.stdout)
    return result


def printed(*names: str, file: Path | None = None, **env: str) -> dict[str, Any]:
    """What buildx makes of the targets of a bake file, or of the committed ones."""
    targets: dict[str, Any] = evaluated(*names, file=file, **env)["target"]
    return targets


def whole(image_set: ImageSet) -> str:
    """Both bake files of an image set as one."""
    return "\n".join(bake_file.render(image_set).values())
