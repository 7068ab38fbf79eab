import rclpy
from beat.node import Beat


def test_it_counts() -> None:
    rclpy.init()
    try:
        node = Beat()
        node.beat()
        node.beat()
        assert node.count == 2
    finally:
        rclpy.shutdown()
