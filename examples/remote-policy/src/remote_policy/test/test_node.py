"""The node acts by the server, says so if there is none, and goes on when it is back."""

import subprocess
import sys
import time
from pathlib import Path

import pytest
import rclpy
from ament_index_python.packages import get_package_prefix
from rclpy.node import Node
from remote_policy.node import NEWEST
from sensor_msgs.msg import Image, JointState
from std_msgs.msg import Float64MultiArray

SERVER = Path(__file__).parents[3] / "server/server.py"
HEIGHT, WIDTH = 1080, 1920
WHITE = bytes([255]) * (3 * HEIGHT * WIDTH)


class Robot(Node):
    """A camera that sees white, two joints, and what they are told."""

    def __init__(self) -> None:
        super().__init__("robot")
        self.actions = []
        self.create_subscription(Float64MultiArray, "commands", lambda message: self.actions.append(message.data), 1)
        self._camera = self.create_publisher(Image, "image", NEWEST)
        self._joints = self.create_publisher(JointState, "joint_states", 1)

    def moves(self, seconds: float) -> list[float]:
        """The first action within some seconds; empty if none comes."""
        self.actions.clear()
        end = time.monotonic() + seconds
        while not self.actions and time.monotonic() < end:
            self._joints.publish(JointState(position=[0.0, 0.5]))
            self._camera.publish(Image(height=HEIGHT, width=WIDTH, encoding="rgb8", step=3 * WIDTH, data=WHITE))
            rclpy.spin_once(self, timeout_sec=0.1)
        return [*self.actions[0]] if self.actions else []


def test_the_node_acts_by_the_server() -> None:
    rclpy.init()
    node = subprocess.Popen([Path(get_package_prefix("remote_policy"), "lib/remote_policy/act")])
    server = subprocess.Popen([sys.executable, SERVER])
    try:
        robot = Robot()
        assert robot.moves(60) == pytest.approx([1.0, 1.5])
        server.kill()
        server.wait()
        robot.moves(2)  # what is still on its way
        assert robot.moves(3) == [] and node.poll() is None
        server = subprocess.Popen([sys.executable, SERVER])
        assert robot.moves(60) == pytest.approx([1.0, 1.5])
    finally:
        for process in (node, server):
            process.terminate()
            process.wait(20)
        rclpy.shutdown()
