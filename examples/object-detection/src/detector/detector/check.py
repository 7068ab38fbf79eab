"""Starts a node of ROS 1 beside the camera, and fails if it hears other boxes than those of the scene, as tests of both nodes do:

python3 -m detector.check COMMAND… _model:=FILE
"""

import os
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager

import rospy
from detector_msgs.msg import Boxes
from rosgraph import is_master_online

from detector import scene


@contextmanager
def started(*command: str) -> Iterator[None]:
    """Stops it in the end."""
    process = subprocess.Popen(command)
    try:
        yield
    finally:
        process.terminate()
        process.wait(20)


def heard(*command: str) -> Boxes:
    """What a node publishes first."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_HOSTNAME="127.0.0.1")
    python = (sys.executable, "-c")
    with ExitStack() as stack:
        stack.enter_context(started("rosmaster", "--core", "-p", str(port)))
        while not is_master_online():
            time.sleep(0.1)
        stack.enter_context(started(*python, "from detector.ros1 import camera; camera()"))
        stack.enter_context(started(*command))
        rospy.init_node("check", argv=[])
        return rospy.wait_for_message("boxes", Boxes, timeout=60)


def check(*command: str) -> None:
    """Compares it with the scene."""
    found = heard(*command)
    wanted = [(x, y, x + scene.SIDE, y + scene.SIDE, label) for label, (x, y) in enumerate((scene.RED, scene.BLUE))]
    assert [(box.x1, box.y1, box.x2, box.y2, box.label) for box in found.boxes] == wanted, found
    assert found.header.frame_id == "camera" and found.header.stamp.secs, "as the picture has it"


if __name__ == "__main__":
    check(*sys.argv[1:])
