"""The nodes for ROS 2."""

import contextlib

import rclpy
from detector_msgs.msg import Box, Boxes
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

from detector import scene
from detector.boxes import HEIGHT, WIDTH, Detector, pixels


class Detect(Node):
    """Hears `image`, and publishes `boxes`."""

    def __init__(self) -> None:
        super().__init__("detector")
        defaults = {"model": "", "threshold": 0.6, "device": "auto", "width": WIDTH, "height": HEIGHT}
        self._detector = Detector(
            **{name: self.declare_parameter(name, value).value for name, value in defaults.items()}
        )
        self._publisher = self.create_publisher(Boxes, "boxes", 1)
        self.create_subscription(Image, "image", self._look, qos_profile_sensor_data)
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
        self._publisher = self.create_publisher(Image, "image", qos_profile_sensor_data)
        self.create_timer(0.1, self._publish)

    def _publish(self) -> None:
        self._image.header.stamp = self.get_clock().now().to_msg()
        self._publisher.publish(self._image)


def _spin(kind: type[Node]) -> None:
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(kind())


def detect() -> None:
    """Looks until somebody stops it."""
    _spin(Detect)


def camera() -> None:
    """Publishes until somebody stops it."""
    _spin(Camera)
