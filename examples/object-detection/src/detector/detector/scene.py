"""A picture to try a detector with, if you have no camera."""

import numpy as np

RED, BLUE = (64, 32), (160, 128)
"""Where the left upper corners of its squares are: x and y."""
SIDE = 32
WIDTH, HEIGHT = 256, 192


def picture() -> np.ndarray:
    """A red and a blue square on dark gray: HEIGHT x WIDTH x 3."""
    found = np.full((HEIGHT, WIDTH, 3), 20, np.uint8)
    for (x, y), color in ((RED, (255, 0, 0)), (BLUE, (0, 0, 240))):
        found[y : y + SIDE, x : x + SIDE] = color
    return found
