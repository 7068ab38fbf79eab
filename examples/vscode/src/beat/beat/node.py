"""A node that says that it lives."""

import contextlib

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int64


class Beat(Node):
    """Publishes `beat`, once a second."""

    def __init__(self) -> None:
        super().__init__("beat")
        self.count = 0
        self._publisher = self.create_publisher(Int64, "beat", 1)
        self.create_timer(1.0, self.beat)

    def beat(self) -> None:
        self.count += 1
        self._publisher.publish(Int64(data=self.count))


def main() -> None:
    """Beats until somebody stops it."""
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Beat())
