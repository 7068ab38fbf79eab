"""score [FRAMEWORK...]: publishes what frameworks computed in a generated message, and hears it."""

import sys
import time

import rclpy
from example_msgs.msg import Score


def scores(name: str) -> list:
    """Two numbers that a framework computed."""
    if name == "torch":
        import torch

        return torch.softmax(torch.zeros(2), 0).tolist()
    import tensorflow as tf

    return tf.nn.softmax(tf.zeros(2)).numpy().tolist()


def main() -> None:
    """The node."""
    message = Score(label="python", scores=[0.5])
    for name in sys.argv[1:]:
        message.label += f" {name}"
        message.scores.extend(scores(name))
    rclpy.init()
    node = rclpy.create_node("score")
    heard: list = []
    node.create_subscription(Score, "scores", heard.append, 10)
    publisher = node.create_publisher(Score, "scores", 10)
    end = time.monotonic() + 30
    while not heard and time.monotonic() < end:
        publisher.publish(message)
        rclpy.spin_once(node, timeout_sec=0.1)
    node.destroy_node()
    rclpy.shutdown()
    if not heard or len(heard[0].scores) != 2 * len(sys.argv) - 1:
        sys.exit(f"heard {heard}")
    print("score:", heard[0].label, *heard[0].scores)
