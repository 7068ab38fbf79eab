from driver import FASTEST
from robot.node import limited


def test_no_speed_is_above_that_of_the_driver() -> None:
    assert [limited(speed) for speed in (-2 * FASTEST, 0.0, 2 * FASTEST)] == [-FASTEST, 0.0, FASTEST]
