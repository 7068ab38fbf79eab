#!/usr/bin/env python3
"""The ball comes round."""

import math
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scripts"))
import ball


class Ball(unittest.TestCase):
    def test_it_is_on_its_circle(self) -> None:
        for step in range(10):
            place = ball.ball(step).pose.position
            self.assertAlmostEqual(math.hypot(place.x, place.y), 1.0)

    def test_it_comes_round(self) -> None:
        self.assertAlmostEqual(ball.position(0).x, ball.position(ball.SECONDS).x)


if __name__ == "__main__":
    unittest.main()
