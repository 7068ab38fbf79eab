"""Each backend that the image has finds what is there."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from detector import scene
from detector.backends import load
from detector.boxes import Box, Detector, pixels, select
from detector.make_model import HEIGHT, WIDTH, make

THERE = [name for name, module in (("onnx", "onnxruntime"), ("pt", "torch")) if importlib.util.find_spec(module)]
ROS = os.environ.get("ROS_VERSION")
NODE = f"import sys; from detector.ros{ROS} import detect; sys.exit(detect())"


@pytest.fixture(scope="module")
def models(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("models")
    make(folder)
    return folder


def test_the_image_has_a_backend() -> None:
    assert THERE, "take a base image with PyTorch, or the add-on onnx"


@pytest.mark.parametrize("kind", THERE)
def test_two_squares_are_two_boxes(models: Path, kind: str) -> None:
    found = Detector(str(models / f"boxes.{kind}")).look(scene.picture())
    corners = [(x, y, x + scene.SIDE, y + scene.SIDE) for x, y in (scene.RED, scene.BLUE)]
    assert [box[:4] for box in found] == corners
    assert [box.label for box in found] == [0, 1]
    assert [box.score for box in found] == pytest.approx([1, 240 / 255], abs=1e-4)


@pytest.mark.skipif(len(THERE) < 2, reason="the image has one backend")
def test_backends_say_the_same(models: Path) -> None:
    picture = np.random.default_rng(1).random((1, 3, HEIGHT, WIDTH), np.float32)
    one, two = (load(str(models / f"boxes.{kind}"), "cpu")(picture) for kind in THERE)
    np.testing.assert_allclose(one, two, atol=1e-4)


@pytest.mark.parametrize("kind", THERE)
def test_a_wrong_device_is_refused(models: Path, kind: str) -> None:
    with pytest.raises(ValueError, match="can be auto, cpu, cuda"):
        load(str(models / f"boxes.{kind}"), "gpu")


def test_the_best_of_boxes_that_overlap_stays() -> None:
    rows = [(0, 0, 10, 10, 0.7, 0), (1, 1, 11, 11, 0.9, 0), (1, 1, 11, 11, 0.8, 1), (50, 50, 60, 60, 0.2, 0)]
    found = select(np.asarray(rows, np.float32), 0.5, (2, 1))
    assert [(*box[:4], box.label) for box in found] == [(2, 1, 22, 11, 0), (2, 1, 22, 11, 1)]
    assert isinstance(found[0], Box)


def test_pixels_of_a_picture() -> None:
    padded = bytes([1, 2, 3, 4, 5, 6, 0, 0]) * 2
    image = SimpleNamespace(encoding="bgr8", height=2, width=2, step=8, data=padded)
    assert pixels(image)[1].tolist() == [[3, 2, 1], [6, 5, 4]]
    image.encoding = "mono8"
    with pytest.raises(ValueError, match="mono8"):
        pixels(image)


@pytest.mark.parametrize("kind", THERE)
def test_the_node_publishes_boxes(models: Path, kind: str) -> None:
    command = [sys.executable, "-m", "detector.check", f"{models}/boxes.{kind}", sys.executable, "-c", NODE]
    subprocess.run(command, check=True, timeout=120)


@pytest.mark.skipif(ROS != "2", reason="without a master, a node of ROS 1 waits for one")
@pytest.mark.parametrize("kind", THERE)
def test_a_node_without_its_model_says_why(tmp_path: Path, kind: str) -> None:
    (tmp_path / f"broken.{kind}").write_text("no model")
    for model, why in (("missing", "there is no such file"), ("broken", "")):
        words = [sys.executable, "-c", NODE, "--ros-args", "-p", f"model:={tmp_path / model}.{kind}"]
        done = subprocess.run(words, capture_output=True, text=True, timeout=60)
        assert done.returncode == 1 and "Traceback" not in done.stderr, done.stderr
        assert "[FATAL]" in done.stderr and why in done.stderr
