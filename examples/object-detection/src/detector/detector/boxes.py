"""From a picture to what a model takes, and from what it gives to boxes. With another model, change these two functions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from detector.backends import load
from detector.make_model import HEIGHT, WIDTH


class Box(NamedTuple):
    """Something in a picture; as the message of the same name."""

    x1: float
    y1: float
    x2: float
    y2: float
    score: float
    label: int


def prepare(pixels: np.ndarray, width: int, height: int) -> np.ndarray:
    """Pixels, height x width x 3, as the model takes them: scaled to its size, 1 x 3 x height x width between 0 and 1."""
    rows = np.arange(height) * pixels.shape[0] // height
    columns = np.arange(width) * pixels.shape[1] // width
    scaled = pixels[rows[:, None], columns].transpose(2, 0, 1)
    return np.ascontiguousarray(scaled[None], np.float32) / 255


def select(rows: np.ndarray, threshold: float, scale: tuple[float, float], overlap: float = 0.3) -> list[Box]:
    """The best of those boxes that overlap and have the same label. `scale` leads from the model's pixels to the picture's."""
    found: list[Box] = []
    sure = rows[rows[:, 4] > threshold]
    for row in sure[np.argsort(-sure[:, 4], kind="stable")]:
        x1, y1, x2, y2, score = (float(value) for value in row[:5] * (*scale, *scale, 1))
        box = Box(x1, y1, x2, y2, score, int(row[5]))
        if all(other.label != box.label or shared(box, other) <= overlap for other in found):
            found.append(box)
    return found


def shared(one: Sequence[float], two: Sequence[float]) -> float:
    """What two boxes share of what they cover."""
    width = min(one[2], two[2]) - max(one[0], two[0])
    height = min(one[3], two[3]) - max(one[1], two[1])
    both = max(width, 0) * max(height, 0)
    areas = [(box[2] - box[0]) * (box[3] - box[1]) for box in (one, two)]
    return both / (sum(areas) - both)


def pixels(image: Any) -> np.ndarray:
    """The pixels of a sensor_msgs/Image of either ROS: height x width x 3, red first.

    Raises:
        ValueError: it has another encoding than rgb8 and bgr8, or lacks pixels.
    """
    if image.encoding not in ("rgb8", "bgr8") or image.step < 3 * image.width or not image.width * image.height:
        raise ValueError(f"no whole picture in rgb8 or bgr8, but {image.encoding}")
    rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
    found = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
    return found if image.encoding == "rgb8" else found[:, :, ::-1]


class Detector:
    """A model, and what is around it."""

    def __init__(
        self, model: str, threshold: float = 0.6, device: str = "auto", width: int = WIDTH, height: int = HEIGHT
    ) -> None:
        self._model, self._threshold, self._size = load(model, device), threshold, (width, height)
        self.about = self._model.about

    def look(self, pixels: np.ndarray) -> list[Box]:
        """What is in a picture: height x width x 3, red first. The surest comes first."""
        width, height = self._size
        scale = (pixels.shape[1] / width, pixels.shape[0] / height)
        return select(self._model(prepare(pixels, width, height)), self._threshold, scale)
