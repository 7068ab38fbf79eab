"""The nodes for ROS 2."""

from __future__ import annotations

import contextlib

import rclpy
from detector_msgs.msg import Box, Boxes
from rclpy.executors import ExternalShutdownException
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import Image

from detector import scene
from detector.boxes import HEIGHT, WIDTH, Detector, pixels

NEWEST = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
"""It hears any camera, and of several pictures that wait for a slow model, the last one."""


class Detect(Node):
    """Hears `image`, and publishes `boxes`."""

    def __init__(self) -> None:
        super().__init__("detector")
        defaults = {"model": "", "threshold": 0.6, "device": "auto", "width": WIDTH, "height": HEIGHT}
        self._detector = Detector(
            **{name: self.declare_parameter(name, value).value for name, value in defaults.items()}
        )
        self._publisher = self.create_publisher(Boxes, "boxes", 1)
        self.create_subscription(Image, "image", self._look, NEWEST)
        self.get_logger().info(self._detector.about)

    def _look(self, image: Image) -> None:
        try:
            found = self._detector.look(pixels(image))
        except ValueError as error:
            self.get_logger().error(str(error), throttle_duration_sec=5.0)
            return
        self._publisher.publish(Boxes(header=image.header, boxes=[Box(**box._asdict()) for box in found]))


class Camera(Node):
    """Publishes a picture with a red and a blue square ten times a second."""

    def __init__(self) -> None:
        super().__init__("camera")
        self._image = Image(height=scene.HEIGHT, width=scene.WIDTH, encoding="rgb8", step=3 * scene.WIDTH)
        self._image.data, self._image.header.frame_id = scene.picture().tobytes(), "camera"
        self._publisher = self.create_publisher(Image, "image", NEWEST)
        self.create_timer(0.1, self._publish)

    def _publish(self) -> None:
        self._image.header.stamp = self.get_clock().now().to_msg()
        self._publisher.publish(self._image)


def _run(kind: type[Node]) -> int:
    """The exit code: 1 if the node cannot start, as without its model."""
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        try:
            node = kind()
        except Exception as error:
            get_logger("detector").fatal(str(error))
            return 1
        rclpy.spin(node)
    return 0


def detect() -> int:
    """Looks until somebody stops it."""
    return _run(Detect)


def camera() -> int:
    """Publishes until somebody stops it."""
    return _run(Camera)
