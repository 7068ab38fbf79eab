"""`ros2 bag`: messages are recorded, counted, and played to a node that hears them in their order."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import rclpy
from record import topics
from std_msgs.msg import Int32
from waiting import SECONDS, until

SENT = 30

folder = Path(os.environ["HOME"]) / "bag"
rclpy.init()
node = rclpy.create_node("bag")


def start(name: str, *arguments: str) -> subprocess.Popen[bytes]:
    """Starts a command of `ros2 bag`; what it says goes to a file."""
    log = folder.with_name(name).open("wb")
    return subprocess.Popen(["ros2", "bag", name, *arguments], stdin=subprocess.DEVNULL, stdout=log, stderr=log)


def stop(name: str, process: subprocess.Popen[bytes]) -> str:
    """Ends a command as Ctrl-C does. What it said."""
    process.send_signal(signal.SIGINT)
    try:
        process.wait(SECONDS)
    except subprocess.TimeoutExpired:
        process.kill()
        sys.exit(f"`ros2 bag {name}` did not end within {SECONDS} s of Ctrl-C:\n{folder.with_name(name).read_text()}")
    return folder.with_name(name).read_text()


publisher = node.create_publisher(Int32, "numbers", SENT)
recorder = start("record", "--output", str(folder), *topics("/numbers"))
until("`ros2 bag record` listens to /numbers", publisher.get_subscription_count, lambda: time.sleep(0.1))
for number in range(SENT):
    publisher.publish(Int32(data=number))
    time.sleep(0.1)
output = stop("record", recorder)
node.destroy_publisher(publisher)

info = subprocess.run(["ros2", "bag", "info", str(folder)], capture_output=True, text=True, timeout=SECONDS)
counted = re.search(r"Topic: /numbers \| Type: std_msgs/msg/Int32 \| Count: ([1-9]\d*)", info.stdout)
if not counted:
    sys.exit(f"no message of /numbers was recorded:\n{info.stdout}{info.stderr}\n`ros2 bag record` said:\n{output}")

heard: list[int] = []
node.create_subscription(Int32, "numbers", lambda message: heard.append(message.data), SENT)
player = start("play", "--loop", str(folder))  # again and again: it does not wait for who listens
until("`ros2 bag play` sends /numbers", lambda: len(heard) > 1, lambda: rclpy.spin_once(node, timeout_sec=0.1))
stop("play", player)
first, second = heard[:2]
assert second in (first + 1, 0), heard
node.destroy_node()
rclpy.shutdown()
print("bag: recorded, counted and played")
