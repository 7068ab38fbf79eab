"""A node that keeps a robot to the speed that its driver allows."""

import contextlib

import rclpy
from driver import FASTEST
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float64


def limited(speed: float) -> float:
    """A speed in m/s that is not above the driver's."""
    return max(-FASTEST, min(FASTEST, speed))


class Limit(Node):
    """Hears `wanted`, and publishes `speed`."""

    def __init__(self) -> None:
        super().__init__("limit")
        publisher = self.create_publisher(Float64, "speed", 1)
        self.create_subscription(Float64, "wanted", lambda one: publisher.publish(Float64(data=limited(one.data))), 1)


def main() -> None:
    """Limits until somebody stops it."""
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Limit())
