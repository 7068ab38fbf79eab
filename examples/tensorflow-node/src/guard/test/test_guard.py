"""The network learns, and the node answers with what it learned."""

import time
from pathlib import Path

import keras
import numpy as np
import pytest
import rclpy
from guard.model import blocked
from guard.node import Guard
from guard.train import FURTHEST, scan, train
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool


@pytest.fixture(scope="module")
def model(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("model") / "model.keras"
    train().save(file)
    return file


def test_the_network_has_learned(model: Path) -> None:
    network, random = keras.saving.load_model(model), np.random.default_rng(2)
    wanted = [bool(number % 2) for number in range(40)]
    right = sum(blocked(network, scan(one, random, 360), FURTHEST) == one for one in wanted)
    assert right >= 36
    assert not blocked(network, np.full(90, np.inf), FURTHEST)


def test_the_node_answers(model: Path) -> None:
    ranges = scan(True, np.random.default_rng(3)).astype(np.float32)
    message = LaserScan(range_max=FURTHEST, ranges=ranges.tolist())
    rclpy.init(args=["--ros-args", "--param", f"model:={model}"])
    try:
        heard, other, executor = [], rclpy.create_node("laser"), SingleThreadedExecutor()
        publisher = other.create_publisher(LaserScan, "scan", qos_profile_sensor_data)
        other.create_subscription(Bool, "blocked", heard.append, 1)
        for node in (other, Guard()):
            executor.add_node(node)
        end = time.monotonic() + 30
        while not heard and time.monotonic() < end:
            publisher.publish(message)
            executor.spin_once(timeout_sec=0.1)
        assert heard and heard[0].data is True
    finally:
        rclpy.shutdown()
