#!/usr/bin/env python3
"""One process in which a callback of rclpy computes with each framework that the image promises: whichever is imported
first, the answers are right, and the process ends cleanly.

Without arguments: runs itself once for each order. `beside.py NAME…`: one process with that order.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from typing import Any


def sums(names: list[str], data: Any) -> dict[str, float]:
    """The sum of a message's numbers, by numpy and by each framework."""
    import numpy as np

    numbers = np.asarray(data, np.float32)
    sums = {"numpy": float(numbers.sum())}
    if "torch" in names:
        import torch

        sums["torch"] = float(torch.from_numpy(numbers.copy()) @ torch.ones(len(numbers)))
    if "tensorflow" in names:
        import tensorflow as tf

        sums["tensorflow"] = float(tf.tensordot(tf.constant(numbers), tf.ones(len(numbers)), 1))
    return sums


def work(names: list[str]) -> None:
    """Imports everything in an order, then has a message of its own answered."""
    import importlib

    for name in names:
        importlib.import_module(name)
    import rclpy
    from sensor_msgs.msg import LaserScan

    rclpy.init()
    node = rclpy.create_node("beside")
    topic = f"ranges_{os.getpid()}"
    heard: list[dict[str, float]] = []
    node.create_subscription(LaserScan, topic, lambda message: heard.append(sums(names, message.ranges)), 10)
    publisher = node.create_publisher(LaserScan, topic, 10)
    end = time.monotonic() + 60
    while not heard and time.monotonic() < end:
        publisher.publish(LaserScan(ranges=[1.0, 2.5, 4.0]))
        rclpy.spin_once(node, timeout_sec=0.1)
    node.destroy_node()
    rclpy.shutdown()
    assert heard, "no message came in 60 s"
    assert set(heard[0].values()) == {7.5}, heard[0]
    print(" ".join(names), heard[0], flush=True)


def main() -> None:
    promised = [name for name in ("torch", "tensorflow") if f"EXPECT_{name.upper()}" in os.environ]
    names = ["rclpy", *promised]
    for first in range(len(names)):
        order = [*names[first:], *names[:first]]
        done = subprocess.run([sys.executable, __file__, *order], text=True, capture_output=True)
        if done.returncode != 0 or "terminate called" in done.stderr:
            sys.exit(f"{' '.join(order)} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
        print(done.stdout, end="")
    print("every order ends well")


if sys.argv[1:]:
    work(sys.argv[1:])
else:
    os.environ.setdefault("TF_CPP_MIN_LOG_LEVEL", "3")
    main()
