"""A node that follows the light."""

import contextlib

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

from lights.picture import brightest


class Watcher(Node):
    """Hears `image`, and says where the light is, once a second."""

    def __init__(self) -> None:
        super().__init__("watcher")
        self.create_subscription(Image, "image", self._look, qos_profile_sensor_data)

    def _look(self, image: Image) -> None:
        self.get_logger().info(f"the light is in column {brightest(image)}", throttle_duration_sec=1.0)


def main() -> None:
    """Looks until somebody stops it."""
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Watcher())
