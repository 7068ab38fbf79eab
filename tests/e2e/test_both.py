"""Images with PyTorch, TensorFlow, CUDA and ROS: their layers, and programs that use all of it at once, in Python and C++."""

from __future__ import annotations

import shutil
import textwrap
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.images.builds import structure_tests
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import names
from rosml.machine.services import Services
from tests.e2e.calls import NAMESPACE
from tests.e2e.images import BuildOn, Publish, build, layers, push

pytestmark = pytest.mark.full(proof="cuda")

BOTH = "ros1-bookworm-perception-ml-cu128"
"""An image with cv_bridge and both frameworks."""

TALK_SECONDS = 600
"""Longest that two processes may talk, for all orders of imports; 90 seconds are usual."""


def test_both_frameworks_share_their_layers_and_import_in_either_order(published: Publish) -> None:
    both = published(BOTH)
    torch = published(names.image_target(both.image.distribution, "core", "torch", both.image.stack))
    assert both.part_layers[: len(torch.image.parts)] == torch.part_layers
    report = structure_tests.read_report(ROOT / ".state" / "tests" / both.image.target / "report", ("ros1-beside",))
    assert {outcome.name for outcome in report.outcomes if outcome.passed} >= {
        "one process with ROS, numpy, the frameworks, and OpenCV with cv_bridge if the image has them, whichever is imported first",
    }


def test_images_with_less_have_the_same_layers(services: Services, published: Publish, image_set: ImageSet) -> None:
    """Of CUDA alone and of TensorFlow alone, as in the image with both frameworks: built here and not tested, as all that
    they hold was."""
    both = published(BOTH)
    parts = dict(zip(both.image.parts, both.part_layers, strict=True))
    prefix = f"{services.registry}/{NAMESPACE}-layers"
    for framework in ("cuda", "tensorflow"):
        target = names.image_target(both.image.distribution, both.image.component, framework, both.image.stack)
        image = image_set.image(target)
        push(services, both, target, prefix)
        expected = [*both.layers[: -len(parts)], *(parts[name] for name in image.parts)]
        assert layers(services, f"{prefix}/{image.tags[0]}") == expected, target


def test_ros_and_both_frameworks_in_one_c_plus_plus_program(build_on: BuildOn) -> None:
    """A catkin package with roscpp, cv_bridge, libtorch (TorchScript) and tensorflow_cc (SavedModel)."""
    output = build_on(BOTH, ["/entrypoint.sh /coexist/run.sh"], "coexist")
    assert "pictures: seen, wrong: 0" in output


def test_the_usual_examples_of_both_frameworks_in_c_plus_plus(build_on: BuildOn) -> None:
    """MNIST with libtorch's C++ frontend; gradient descent and label_image with TensorFlow's ClientSession."""
    steps = [f"/examples/{framework}/run.sh" for framework in ("torch", "tensorflow")]
    output = build_on(BOTH, steps, "examples")
    for words in ("mnist: accuracy", "train: loss", "label_image: green"):
        assert words in output


def test_tensorflow_and_the_systems_protobuf_in_one_program(build_on: BuildOn) -> None:
    """Each target sees the protobuf, abseil and Eigen that it links; no image has the system's, but for Eigen."""
    steps = ["install-packages libprotobuf-dev protobuf-compiler libabsl-dev", "/headers/run.sh"]
    output = build_on(BOTH, steps, "headers")
    assert "both: done" in output


def test_ros_2_from_wheels_and_both_frameworks_in_one_process(
    services: Services, published: Publish, tmp_path: Path
) -> None:
    """rclpy, Fast DDS and messages in a virtual environment on the image's Python, beside ROS 1: a node in whose callback
    both frameworks infer answers another process, whichever of the three was imported first."""
    image = published(BOTH)
    shutil.copytree(Path(__file__).parent / "rclpy_wheels", tmp_path / "rclpy_wheels")
    (tmp_path / "Dockerfile").write_text(
        textwrap.dedent(f"""\
            FROM {image.result["reference"]} AS ros2
            COPY rclpy_wheels/requirements.txt /rclpy_wheels/
            RUN --mount=type=secret,id=ca-bundle \\
                if [ -s /run/secrets/ca-bundle ]; then export PIP_CERT=/run/secrets/ca-bundle; fi; \\
                python3 -m venv --system-site-packages /ros2 && /ros2/bin/pip install --no-cache-dir --no-deps \\
                  --require-hashes --only-binary :all: --requirement /rclpy_wheels/requirements.txt
            FROM ros2 AS talk
            COPY rclpy_wheels /rclpy_wheels
            RUN --network=none timeout {TALK_SECONDS} /entrypoint.sh /rclpy_wheels/run.sh /ros2/bin/python
        """)
    )
    output = build(services, tmp_path, "--no-cache-filter", "talk")
    assert output.count("20 answers, wrong: 0; exit codes 0 and 0") == 6, output
