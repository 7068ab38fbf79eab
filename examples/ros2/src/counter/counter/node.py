"""A node that counts."""

import contextlib

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

from counter.round import is_round


class Counter(Node):
    """Publishes each round number that it comes to."""

    def __init__(self) -> None:
        super().__init__("counter")
        self._publisher = self.create_publisher(String, "round", 10)
        self._timer = self.create_timer(0.1, self._count)
        self._number = 0

    def _count(self) -> None:
        self._number += 1
        if is_round(self._number):
            self._publisher.publish(String(data=f"round: {self._number}"))
            self.get_logger().info(f"round: {self._number}")


def main() -> None:
    """Counts until somebody stops it."""
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Counter())
