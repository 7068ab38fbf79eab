"""A node that says where in the camera's picture something bright is."""

import contextlib

import numpy as np
import rclpy
import torch
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image
from std_msgs.msg import String

from detector.model import load, place


def picture(image: Image) -> torch.Tensor:
    """A message with the encoding rgb8 as a tensor, 3 x height x width between 0 and 1."""
    rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
    pixels = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
    return torch.from_numpy(pixels.copy()).permute(2, 0, 1).float() / 255


class Detector(Node):
    """Hears `image`, and publishes `place`."""

    def __init__(self) -> None:
        super().__init__("detector")
        self._device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
        self._model = load(self.declare_parameter("weights", "weights.pt").value, self._device)
        self._publisher = self.create_publisher(String, "place", 1)
        self.create_subscription(Image, "image", self._look, qos_profile_sensor_data)
        self.get_logger().info(f"PyTorch {torch.__version__} on {self._device.type}")

    def _look(self, image: Image) -> None:
        if image.encoding != "rgb8":
            self.get_logger().error(f"rgb8 is wanted, and not {image.encoding}", throttle_duration_sec=5.0)
            return
        self._publisher.publish(String(data=place(self._model, picture(image).to(self._device))))


def main() -> None:
    """Looks until somebody stops it."""
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Detector())
