"""Headers of both frameworks, as C++ programs include them: those of a census of public programs and the whole public API compile
alone and together, but for a committed list, without a compiler for GPU code."""

from __future__ import annotations

import pytest

from tests.e2e.images import BuildOn

pytestmark = pytest.mark.full(proof="includes")

COMPILE = "/includes/compile.py --fails"


def test_headers_of_torch(build_on: BuildOn) -> None:
    """With CUDA's. Some include Python's."""
    flags = "$(pkg-config --cflags torch) -I$(python3 -c 'import sysconfig; print(sysconfig.get_path(\"include\"))')"
    steps = [
        "cat /includes/torch.txt /includes/cuda.txt >/tmp/list.txt",
        f"{COMPILE} /includes/torch_fails.txt /tmp/list.txt -- {flags}",
    ]
    output = build_on("ros1-bookworm-core-torch-cu130", steps, "includes")
    assert output.count("they compile") == 3


def test_headers_of_tensorflow(build_on: BuildOn) -> None:
    step = f"{COMPILE} /includes/tensorflow_fails.txt /includes/tensorflow.txt -- $(pkg-config --cflags tensorflow_cc)"
    output = build_on("ros1-bookworm-core-tensorflow-cpu", [step], "includes")
    assert output.count("they compile") == 3
