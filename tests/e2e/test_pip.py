"""The second hour: what users install into images with frameworks, by pip and uv and from the public index, leaves these and ROS
as they are; and who wants another release of what is there gets it whole."""

from __future__ import annotations

import pytest

from tests.e2e.images import BuildOn

ANY = "onnxruntime opencv-python pandas scikit-learn open3d"
OF_TORCH = "torchvision torchaudio ultralytics transformers timm lightning accelerate diffusers torchmetrics kornia"
OF_TENSORFLOW = "tensorboard tf-keras tensorflow-hub tf2onnx"

CV_BRIDGE = "install-packages python3-cv-bridge"
"""What a component below perception lacks; libGL, which OpenCV's wheels need, comes with it."""


@pytest.mark.full(proof="everyday")
@pytest.mark.parametrize(
    ("target", "packages"),
    [
        ("ros1-bookworm-core-tensorflow-cpu", f"{ANY} {OF_TENSORFLOW}"),
        ("ros1-bookworm-core-torch-cu128", f"{ANY} {OF_TORCH}"),
        ("ros1-bookworm-perception-ml-cu128", f"{ANY} {OF_TORCH} {OF_TENSORFLOW}"),
    ],
)
def test_everyday_packages_leave_what_is_installed_as_it_is(build_on: BuildOn, target: str, packages: str) -> None:
    steps = [CV_BRIDGE, f"online /entrypoint.sh /everyday/check.py {packages}"]
    output = build_on(target, steps, "everyday")
    assert "everyday: done" in output


def test_another_release_for_who_says_so(build_on: BuildOn) -> None:
    """By pip and by uv: refused as it stands, installed with the word, and TensorFlow still computes."""
    steps = ["online /everyday/unpinned.sh h5py 3.13.0 3.12.1", "python3 /everyday/computes.py tensorflow"]
    output = build_on("ros1-bookworm-core-tensorflow-cpu", steps, "everyday")
    assert "unpinned: h5py 3.12.1" in output and "computes: tensorflow" in output


@pytest.mark.full(proof="everyday")
def test_another_tensorflow_is_whole(build_on: BuildOn) -> None:
    """The wheel for the CPU is called otherwise, and goes with the package that stands for it; C++ is told."""
    steps = [
        "online unpinned pip install tensorflow==2.19.1",
        "python3 /everyday/computes.py tensorflow 2.19.1",
        "! pip list | grep tensorflow.cpu",
        "! cmake -S /everyday/tensorflow -B /tmp/tensorflow >/tmp/said 2>&1",
        "grep -w replaced /tmp/said",
    ]
    output = build_on("ros1-bookworm-core-tensorflow-cpu", steps, "everyday")
    assert "computes: tensorflow 2.19.1" in output


@pytest.mark.full(proof="everyday")
def test_another_torch_is_whole(build_on: BuildOn) -> None:
    """With the image's CUDA or another: its libraries are found, since torch is imported; our CMake package says that it was
    replaced."""
    steps = [
        "online unpinned pip install torch==2.9.1",
        "python3 /everyday/computes.py torch 2.9.1",
        "online pip install uv",
        "online unpinned uv pip install torch==2.12.1",
        "python3 /everyday/computes.py torch 2.12.1",
        "! cmake -S /everyday/torch -B /tmp/torch >/tmp/said 2>&1",
        "grep -w replaced /tmp/said",
    ]
    output = build_on("ros1-bookworm-core-torch-cu128", steps, "everyday")
    assert "computes: torch 2.9.1" in output and "computes: torch 2.12.1" in output
