"""Starts a node beside the camera, and fails if it hears other boxes than those of the scene, as tests of both nodes do:

python3 -m detector.check MODEL COMMAND…
"""

from __future__ import annotations

import os
import random
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from typing import Any

from detector_msgs.msg import Boxes

from detector import scene

ROS_1 = os.environ.get("ROS_VERSION") == "1"
CAMERA = (sys.executable, "-c", f"from detector.{'ros1' if ROS_1 else 'ros2'} import camera; camera()")


@contextmanager
def started(*command: str) -> Iterator[None]:
    """Stops it in the end, as Ctrl-C does."""
    process = subprocess.Popen(command)
    try:
        yield
    finally:
        process.send_signal(signal.SIGINT)
        code = process.wait(20)
    assert code == 0, f"{command} ended with {code}"


def heard_1(model: str, *command: str) -> Boxes:
    """What a node of ROS 1 publishes first."""
    import rospy
    from rosgraph import is_master_online

    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_HOSTNAME="127.0.0.1")
    with ExitStack() as stack:
        stack.enter_context(started("rosmaster", "--core", "-p", str(port)))
        while not is_master_online():
            time.sleep(0.1)
        stack.enter_context(started(*CAMERA))
        stack.enter_context(started(*command, f"_model:={model}"))
        rospy.init_node("check", argv=[])
        return rospy.wait_for_message("boxes", Boxes, timeout=60)


def heard_2(model: str, *command: str) -> Boxes:
    """The same of ROS 2."""
    import rclpy

    # Apart from other nodes. Before iron, the domain alone keeps them apart.
    os.environ.update(ROS_DOMAIN_ID=str(random.randint(1, 100)), ROS_AUTOMATIC_DISCOVERY_RANGE="LOCALHOST")
    with ExitStack() as stack:
        stack.enter_context(started(*CAMERA))
        stack.enter_context(started(*command, "--ros-args", "-p", f"model:={model}"))
        rclpy.init()
        node, found, end = rclpy.create_node("check"), [], time.monotonic() + 60
        node.create_subscription(Boxes, "boxes", found.append, 1)
        while not found:
            assert time.monotonic() < end, "nothing in 60 s"
            rclpy.spin_once(node, timeout_sec=1)
        rclpy.shutdown()
    return found[0]


def check(*words: str) -> None:
    """Compares it with the scene."""
    found: Any = heard_1(*words) if ROS_1 else heard_2(*words)
    wanted = [(x, y, x + scene.SIDE, y + scene.SIDE, label) for label, (x, y) in enumerate((scene.RED, scene.BLUE))]
    assert [(box.x1, box.y1, box.x2, box.y2, box.label) for box in found.boxes] == wanted, found
    stamp = found.header.stamp
    assert found.header.frame_id == "camera" and (stamp.secs if ROS_1 else stamp.sec), "as the picture has it"


if __name__ == "__main__":
    check(*sys.argv[1:])
