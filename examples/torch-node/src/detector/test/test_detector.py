"""The network learns, and the node answers with what it learned."""

import time
from pathlib import Path

import pytest
import rclpy
import torch
from detector.model import PLACES, load, place
from detector.node import Detector
from detector.train import picture, train
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image
from std_msgs.msg import String


@pytest.fixture(scope="module")
def weights(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("weights") / "weights.pt"
    torch.save(train(), file)
    return file


def test_the_network_has_learned(weights: Path) -> None:
    model = load(str(weights), torch.device("cpu"))
    wanted = [number for number in range(len(PLACES)) for _ in range(20)]
    right = sum(place(model, picture(number, 60, 90)) == PLACES[number] for number in wanted)
    assert right >= 0.9 * len(wanted)


def test_the_node_answers(weights: Path) -> None:
    height, width = 48, 72
    pixels = (picture(2, height, width) * 255).to(torch.uint8).permute(1, 2, 0).contiguous()
    image = Image(height=height, width=width, encoding="rgb8", step=3 * width, data=pixels.numpy().tobytes())
    rclpy.init(args=["--ros-args", "--param", f"weights:={weights}"])
    try:
        heard, other, executor = [], rclpy.create_node("camera"), SingleThreadedExecutor()
        publisher = other.create_publisher(Image, "image", qos_profile_sensor_data)
        other.create_subscription(String, "place", heard.append, 1)
        for node in (other, Detector()):
            executor.add_node(node)
        end = time.monotonic() + 30
        while not heard and time.monotonic() < end:
            publisher.publish(image)
            executor.spin_once(timeout_sec=0.1)
        assert heard and heard[0].data == "right"
    finally:
        rclpy.shutdown()
