"""Subscribes to pictures over DDS, has both frameworks infer on each, and publishes what they say.

Usage: listener.py rclpy,torch,tensorflow   (in the order in which they are to be imported)

A picture of no width ends it.
"""
# ruff: noqa: E402  (the order of imports is what is tested)

import ros_wheels_bootstrapper  # isort: skip  # noqa: F401  (first: it executes this program anew, with the library path)
import importlib
import sys
from typing import Any

for name in sys.argv[1].split(","):
    importlib.import_module(name)

import numpy as np
import rclpy
import tensorflow as tf
import torch
from sensor_msgs.msg import Image
from std_msgs.msg import Float32MultiArray

CONVOLUTION = torch.nn.Conv2d(1, 1, 3, bias=False)
torch.nn.init.ones_(CONVOLUTION.weight)


def with_torch(picture: Any) -> float:
    """The sum of all sums of 3 x 3 points."""
    with torch.inference_mode():
        return float(CONVOLUTION(torch.from_numpy(picture)[None, None]).sum())


@tf.function
def convolved(picture: Any) -> Any:
    return tf.reduce_sum(tf.nn.conv2d(picture[None, :, :, None], tf.ones((3, 3, 1, 1)), strides=1, padding="VALID"))


def with_tensorflow(picture: Any) -> float:
    """The same, in a graph."""
    return float(convolved(tf.constant(picture)))


def main() -> None:
    rclpy.init()
    node = rclpy.create_node("listener")
    answers = node.create_publisher(Float32MultiArray, "answers", 10)
    ended = False

    def answer(image: Any) -> None:
        nonlocal ended
        if not image.width:
            ended = True
            return
        picture = np.frombuffer(image.data, np.float32).reshape(image.height, image.width).copy()
        number = float(image.header.frame_id)
        answers.publish(Float32MultiArray(data=[number, with_torch(picture), with_tensorflow(picture)]))

    node.create_subscription(Image, "pictures", answer, 10)
    while not ended:
        rclpy.spin_once(node)
    node.destroy_node()
    rclpy.shutdown()


main()
