"""A node that publishes pictures of a light that moves."""

import contextlib

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

from lights.picture import WIDTH, picture


class Camera(Node):
    """Publishes `image`, ten times a second."""

    def __init__(self) -> None:
        super().__init__("camera")
        self._column = 0
        self._publisher = self.create_publisher(Image, "image", qos_profile_sensor_data)
        self.create_timer(0.1, self._publish)

    def _publish(self) -> None:
        self._publisher.publish(picture(self._column))
        self._column = (self._column + 1) % WIDTH


def main() -> None:
    """Publishes until somebody stops it."""
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Camera())
