"""tf2: a static transform that one node sends is looked up by another, and turned."""

import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.time import Time
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformListener
from waiting import until

rclpy.init()
sender, looker = rclpy.create_node("sender"), rclpy.create_node("looker")
sent = TransformStamped()
sent.header.frame_id, sent.child_frame_id = "base", "camera"
sent.transform.translation.x = 1.0
sent.transform.rotation.z = sent.transform.rotation.w = math.sqrt(0.5)  # a quarter to the left
broadcaster = StaticTransformBroadcaster(sender)
broadcaster.sendTransform(sent)
buffer = Buffer()
listener = TransformListener(buffer, looker)


def step() -> None:
    """Both nodes work."""
    for node in (sender, looker):
        rclpy.spin_once(node, timeout_sec=0.05)


until("the transform from camera to base is known", lambda: buffer.can_transform("camera", "base", Time()), step)
transform = buffer.lookup_transform("camera", "base", Time()).transform
place = transform.translation
assert math.dist((place.x, place.y, place.z), (0, 1, 0)) < 1e-9, transform
assert abs(abs(transform.rotation.z) - math.sqrt(0.5)) < 1e-9, transform
sender.destroy_node()
looker.destroy_node()
rclpy.shutdown()
print("transform: there and back")
