#!/usr/bin/env python3
"""A talker and a listener in one process: prints what the listener heard. Fails after 30 s of silence.

With the name of an RMW implementation: fails also where it is another one.
"""

import sys
import time

import rclpy
from std_msgs.msg import String

rclpy.init()
used = rclpy.get_rmw_implementation_identifier()
if sys.argv[1:] not in ([], [""], [used]):
    sys.exit(f"the RMW implementation is {used}, not {sys.argv[1]}")
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
print(f"{used} heard: {heard[0]}" if heard else f"{used}: heard nothing")
sys.exit(not heard)
