#!/usr/bin/env python3
"""A talker and a listener in one process: prints what the listener heard. Fails after 30 s of silence."""

import sys
import time

import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("talker_and_listener")
heard: list = []
node.create_subscription(String, "chatter", lambda message: heard.append(message.data), 10)
publisher = node.create_publisher(String, "chatter", 10)
end = time.monotonic() + 30
while not heard and time.monotonic() < end:
    publisher.publish(String(data="hello from rclpy"))
    rclpy.spin_once(node, timeout_sec=0.1)
node.destroy_node()
rclpy.shutdown()
print(f"heard: {heard[0]}" if heard else "heard nothing")
sys.exit(not heard)
