"""Publishes pictures over DDS, and checks the answers of a listener in another process. Exits with 1 if one is wrong."""

import ros_wheels_bootstrapper  # isort: skip  # noqa: F401  (first: it executes this program anew, with the library path)
import array
import sys
import time
from typing import Any

import rclpy
from sensor_msgs.msg import Image
from std_msgs.msg import Float32MultiArray

PICTURES = 20
SIDE = 8
SECONDS = 120.0
"""Longest that all of it may take; the listener imports both frameworks before it answers."""


def points(number: int) -> list[float]:
    """A picture, row by row: small whole numbers, of which every sum is exact."""
    return [float((number + 3 * row + column) % 7) for row in range(SIDE) for column in range(SIDE)]


def expected(number: int) -> float:
    """The sum of all sums of 3 x 3 points: each point as often as a window covers it."""
    picture = points(number)

    def windows(place: int) -> int:
        return min(place, 2, SIDE - 1 - place) + 1

    return sum(
        picture[SIDE * row + column] * windows(row) * windows(column) for row in range(SIDE) for column in range(SIDE)
    )


def main() -> int:
    rclpy.init()
    node = rclpy.create_node("talker")
    pictures = node.create_publisher(Image, "pictures", 10)
    sums_by_picture: dict[int, tuple[float, float]] = {}

    def hear(answer: Any) -> None:
        number, *sums = answer.data
        sums_by_picture[int(number)] = (sums[0], sums[1])

    node.create_subscription(Float32MultiArray, "answers", hear, 10)
    deadline = time.monotonic() + SECONDS
    for number in range(PICTURES):
        image = Image(height=SIDE, width=SIDE, encoding="32FC1", step=4 * SIDE)
        image.header.frame_id = str(number)
        image.data = array.array("B", array.array("f", points(number)).tobytes())
        while number not in sums_by_picture and time.monotonic() < deadline:  # again, until the listener is there
            pictures.publish(image)
            rclpy.spin_once(node, timeout_sec=0.5)
    while pictures.get_subscription_count() and time.monotonic() < deadline:
        pictures.publish(Image())
        rclpy.spin_once(node, timeout_sec=0.1)
    wrong = [number for number in range(PICTURES) if sums_by_picture.get(number) != (expected(number),) * 2]
    print(f"{len(sums_by_picture)} answers, wrong: {len(wrong)}", flush=True)
    for number in wrong:
        print(f"picture {number}: {sums_by_picture.get(number)}, not twice {expected(number)}", file=sys.stderr)
    node.destroy_node()
    rclpy.shutdown()
    return 1 if wrong else 0


sys.exit(main())
