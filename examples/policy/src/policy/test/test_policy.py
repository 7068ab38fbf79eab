"""The node starts in its environment, and acts. The test itself is in ROS's Python, as other nodes are."""

import importlib.util
import subprocess
import time
from pathlib import Path

import pytest
import rclpy
from ament_index_python.packages import get_package_prefix
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image, JointState
from std_msgs.msg import Float64MultiArray

FOLDER = Path(__file__).parents[3] / "policy"
JOINTS, HEIGHT, WIDTH = 6, 240, 320


def test_rosps_python_has_no_lerobot() -> None:
    assert importlib.util.find_spec("lerobot") is None


def test_the_node_acts() -> None:
    program = Path(get_package_prefix("policy"), "lib/policy/act")
    node = subprocess.Popen([program, "--ros-args", "--param", f"policy:={FOLDER}"])
    rclpy.init()
    try:
        actions, robot = [], rclpy.create_node("robot")
        robot.create_subscription(Float64MultiArray, "commands", actions.append, 1)
        camera = robot.create_publisher(Image, "image", qos_profile_sensor_data)
        joints = robot.create_publisher(JointState, "joint_states", 1)
        image = Image(height=HEIGHT, width=WIDTH, encoding="rgb8", step=3 * WIDTH, data=bytes(3 * HEIGHT * WIDTH))
        end = time.monotonic() + 120
        while not actions and node.poll() is None and time.monotonic() < end:
            joints.publish(JointState(position=[0.0] * JOINTS))
            camera.publish(image)
            rclpy.spin_once(robot, timeout_sec=0.1)
        assert node.poll() is None
        assert len(actions[0].data) == JOINTS
        assert actions[0].data != pytest.approx([0.0] * JOINTS)
    finally:
        node.terminate()
        node.wait()
        rclpy.shutdown()
