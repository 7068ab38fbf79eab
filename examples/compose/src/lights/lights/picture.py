"""Pictures with a light in one column."""

import numpy as np
from sensor_msgs.msg import Image

HEIGHT, WIDTH = 24, 32


def picture(column: int) -> Image:
    """A dark picture with a light in a column."""
    pixels = np.zeros((HEIGHT, WIDTH), np.uint8)
    pixels[:, column] = 255
    return Image(height=HEIGHT, width=WIDTH, encoding="mono8", step=WIDTH, data=pixels.tobytes())


def brightest(image: Image) -> int:
    """The column in which the light is."""
    pixels = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
    return int(pixels[:, : image.width].sum(axis=0, dtype=np.int64).argmax())
