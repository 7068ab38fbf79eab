"""A node that says whether something stands in the way."""

import contextlib

import keras
import numpy as np
import rclpy
import tensorflow as tf
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool

from guard.model import blocked


class Guard(Node):
    """Hears `scan`, and publishes `blocked`."""

    def __init__(self) -> None:
        super().__init__("guard")
        self._model = keras.saving.load_model(self.declare_parameter("model", "model.keras").value)
        self._publisher = self.create_publisher(Bool, "blocked", 1)
        self.create_subscription(LaserScan, "scan", self._look, qos_profile_sensor_data)
        devices = "a GPU" if tf.config.list_physical_devices("GPU") else "the CPU"
        self.get_logger().info(f"TensorFlow {tf.__version__} on {devices}")

    def _look(self, scan: LaserScan) -> None:
        ranges = np.array(scan.ranges, np.float32)
        self._publisher.publish(Bool(data=blocked(self._model, ranges, scan.range_max)))


def main() -> None:
    """Watches until somebody stops it."""
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Guard())
