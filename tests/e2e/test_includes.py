"""Headers of both frameworks, as C++ programs include them: those of a census of public programs and the whole public API compile
alone and together, but for a committed list, without a compiler for GPU code."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosml.machine.services import Services
from tests.e2e.images import Publish, build_on

pytestmark = pytest.mark.full(proof="includes")

COMPILE = "/includes/compile.py --fails"


def test_headers_of_torch(services: Services, published: Publish, tmp_path: Path) -> None:
    """With CUDA's. Some include Python's."""
    flags = "$(pkg-config --cflags torch) -I$(python3 -c 'import sysconfig; print(sysconfig.get_path(\"include\"))')"
    steps = [
        "cat /includes/torch.txt /includes/cuda.txt >/tmp/list.txt",
        f"{COMPILE} /includes/torch_fails.txt /tmp/list.txt -- {flags}",
    ]
    said = build_on(services, published("ros1-bookworm-core-torch-cu130"), tmp_path, steps, "includes")
    assert said.count("they compile") == 3


def test_headers_of_tensorflow(services: Services, published: Publish, tmp_path: Path) -> None:
    step = f"{COMPILE} /includes/tensorflow_fails.txt /includes/tensorflow.txt -- $(pkg-config --cflags tensorflow_cc)"
    said = build_on(services, published("ros1-bookworm-core-tensorflow-cpu"), tmp_path, [step], "includes")
    assert said.count("they compile") == 3
