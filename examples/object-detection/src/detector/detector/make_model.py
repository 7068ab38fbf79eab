"""Makes a small model, in the place of your own: python3 -m detector.make_model FOLDER

It finds red and blue things of about 16 x 16 pixels. A convolution gives each window of the picture a score for each color, and
each window is a box. FOLDER gets boxes.onnx, and boxes.pt if PyTorch is there.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

WIDTH, HEIGHT = 128, 96
"""Of a picture that the model takes: 1 x 3 x HEIGHT x WIDTH, red, green and blue between 0 and 1."""
WINDOW, STEP = 16, 8
COLORS = {"red": (1.0, -0.5, -0.5), "blue": (-0.5, -0.5, 1.0)}
"""What each label looks for: how much red, green and blue add to a score."""


def weights() -> np.ndarray:
    """Of the convolution: labels x 3 x WINDOW x WINDOW. They give the mean of a window."""
    every = np.asarray([*COLORS.values()], np.float32) / WINDOW**2
    return np.ascontiguousarray(np.broadcast_to(every[:, :, None, None], (len(COLORS), 3, WINDOW, WINDOW)))


def windows() -> np.ndarray:
    """x1, y1, x2, y2, label of each window, in the order of the convolution's results: 1 x N x 5."""
    tops, lefts = range(0, HEIGHT - WINDOW + 1, STEP), range(0, WIDTH - WINDOW + 1, STEP)
    found = [(x, y, x + WINDOW, y + WINDOW, label) for label in range(len(COLORS)) for y in tops for x in lefts]
    return np.asarray([found], np.float32)


def write_torch(path: Path) -> None:
    """The model in TorchScript, with a result of 1 x N x 6: x1, y1, x2, y2, score, label."""
    import torch
    from torch import Tensor, nn

    class Boxes(nn.Module):
        def __init__(self) -> None:
            super().__init__()
            self.register_buffer("weights", torch.from_numpy(weights()))
            self.register_buffer("windows", torch.from_numpy(windows()))

        def forward(self, picture: Tensor) -> Tensor:
            scores = nn.functional.conv2d(picture, self.weights, stride=STEP).reshape(1, -1, 1)
            return torch.cat((self.windows[:, :, :4], scores, self.windows[:, :, 4:]), 2)

    torch.jit.trace(Boxes().eval(), torch.zeros(1, 3, HEIGHT, WIDTH)).save(str(path))


def message(*fields: tuple[int, int | str | bytes]) -> bytes:
    """Bytes of protobuf, from numbers of fields and their values.

    https://github.com/onnx/onnx/blob/main/onnx/onnx.proto3 has the numbers. With the package `onnx`, or for a model of PyTorch by
    `torch.onnx.export`, you need none of this.
    """

    def varint(value: int) -> bytes:
        return bytes([value]) if value < 128 else bytes([value % 128 + 128]) + varint(value // 128)

    found = b""
    for number, value in fields:
        if isinstance(value, int):
            found += varint(number * 8) + varint(value)
        else:
            data = value.encode() if isinstance(value, str) else value
            found += varint(number * 8 + 2) + varint(len(data)) + data
    return found


def tensor(name: str, values: np.ndarray) -> bytes:
    """Constant numbers of a model."""
    kind = {"float32": 1, "int64": 7}[values.dtype.name]
    return message(*((1, size) for size in values.shape), (2, kind), (8, name), (9, values.tobytes()))


def port(name: str, *sizes: int) -> bytes:
    """The input or the output."""
    shape = message(*((1, message((1, size))) for size in sizes))
    return message((1, name), (2, message((1, message((1, 1), (2, shape))))))


def write_onnx(path: Path) -> None:
    """The same model for ONNX Runtime."""
    boxes, labels = windows()[:, :, :4], windows()[:, :, 4:]
    constants = {"weights": weights(), "every": np.asarray([1, -1, 1], np.int64), "boxes": boxes, "labels": labels}
    strides = message((1, "strides"), (8, STEP), (8, STEP), (20, 7))
    axis = message((1, "axis"), (3, 2), (20, 2))
    nodes = (
        message((1, "picture"), (1, "weights"), (2, "map"), (4, "Conv"), (5, strides)),
        message((1, "map"), (1, "every"), (2, "scores"), (4, "Reshape")),
        message((1, "boxes"), (1, "scores"), (1, "labels"), (2, "found"), (4, "Concat"), (5, axis)),
    )
    graph = message(
        *((1, node) for node in nodes),
        (2, "boxes"),
        *((5, tensor(name, np.ascontiguousarray(values))) for name, values in constants.items()),
        (11, port("picture", 1, 3, HEIGHT, WIDTH)),
        (12, port("found", 1, boxes.shape[1], 6)),
    )
    path.write_bytes(message((1, 7), (7, graph), (8, message((2, 13)))))


def make(folder: Path) -> list[Path]:
    """Writes the model for what the image has."""
    found = [folder / "boxes.onnx"]
    write_onnx(found[0])
    try:
        write_torch(folder / "boxes.pt")
        found.append(folder / "boxes.pt")
    except ModuleNotFoundError:
        pass
    return found


if __name__ == "__main__":
    print(*make(Path(sys.argv[1])))
