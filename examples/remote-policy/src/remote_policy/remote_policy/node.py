"""A node that moves a robot by a policy in another process, which it asks by Zenoh."""

import contextlib
import json

import rclpy
import zenoh
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import Image, JointState
from std_msgs.msg import Float64MultiArray

NEWEST = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
"""Of the pictures that come while the policy works, the newest counts."""


class RemotePolicy(Node):
    """Hears `image` and `joint_states`, and publishes what the policy answers as `commands`."""

    def __init__(self, session: zenoh.Session) -> None:
        super().__init__("remote_policy")
        self._session, self._timeout = session, self.declare_parameter("timeout", 0.5).value
        self._positions: list[float] = []
        self._publisher = self.create_publisher(Float64MultiArray, "commands", 1)
        self.create_subscription(JointState, "joint_states", self._hear, 1)
        self.create_subscription(Image, "image", self._act, NEWEST)

    def _hear(self, joints: JointState) -> None:
        self._positions = list(joints.position)

    def _act(self, image: Image) -> None:
        if image.encoding != "rgb8" or image.step != 3 * image.width:
            self.get_logger().error(
                f"rgb8 without padding is wanted, and not {image.encoding}", throttle_duration_sec=5.0
            )
        elif self._positions:
            self._ask(image)

    def _ask(self, image: Image) -> None:
        facts = json.dumps({"height": image.height, "width": image.width, "positions": self._positions})
        replies = self._session.get("policy/act", payload=bytes(image.data), attachment=facts, timeout=self._timeout)
        problem = "no policy answers"
        for reply in replies:
            if reply.ok:
                self._publisher.publish(Float64MultiArray(data=json.loads(reply.ok.payload.to_string())))
                return
            problem = f"the policy says: {reply.err.payload.to_string()}"
        self.get_logger().warning(problem, throttle_duration_sec=5.0)


def main() -> None:
    """Moves the robot until somebody stops it. The policy connects to this node, from this machine alone."""
    config = zenoh.Config()
    config.insert_json5("listen/endpoints", '["tcp/127.0.0.1:7448"]')
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("transport/shared_memory/enabled", "true")
    rclpy.init()
    with zenoh.open(config) as session, contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        node = RemotePolicy(session)
        while rclpy.ok():  # a signal that comes while the policy is asked wakes nobody, so the wait has an end
            rclpy.spin_once(node, timeout_sec=1.0)
