"""talk: publishes a message, and hears it."""

import sys
import time

import rclpy
from std_msgs.msg import String


def main() -> None:
    """The node."""
    rclpy.init()
    node = rclpy.create_node("talk")
    heard: list = []
    node.create_subscription(String, "workspace", heard.append, 10)
    publisher = node.create_publisher(String, "workspace", 10)
    end = time.monotonic() + 30
    while not heard and time.monotonic() < end:
        publisher.publish(String(data="a message"))
        rclpy.spin_once(node, timeout_sec=0.1)
    node.destroy_node()
    rclpy.shutdown()
    print(f"the workspace heard {heard[0].data}" if heard else "heard nothing")
    sys.exit(not heard)
