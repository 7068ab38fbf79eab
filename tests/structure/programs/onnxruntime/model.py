#!/usr/bin/env python3
"""Writes models, without the package onnx: `model.py FOLDER` makes FOLDER/tanh.onnx and FOLDER/mean.onnx.

They are messages of protobuf: https://github.com/onnx/onnx/blob/main/onnx/onnx.proto3 has the numbers of the fields.
"""

from __future__ import annotations

import struct
import sys
from collections.abc import Sequence
from pathlib import Path

FLOAT = 1
WEIGHTS = [[((3 * row + 5 * column) % 11 - 5) / 7 for column in range(3)] for row in range(4)]
BIAS = [0.25, -0.5, 1.0]
"""Of tanh.onnx: y = tanh(x · WEIGHTS + BIAS)."""


def number(value: int) -> bytes:
    """A number as protobuf has it, in groups of seven bits."""
    encoded = bytearray()
    while value > 127:
        encoded.append(value & 127 | 128)
        value >>= 7
    return bytes([*encoded, value])


def field(key: int, value: int | str | bytes) -> bytes:
    """A field of a message; a message in it is its bytes."""
    if isinstance(value, int):
        return number(key << 3) + number(value)
    data = value.encode() if isinstance(value, str) else value
    return number(key << 3 | 2) + number(len(data)) + data


def tensor(name: str, shape: Sequence[int], values: Sequence[float]) -> bytes:
    """Numbers of a model."""
    sizes = b"".join(field(1, size) for size in shape)
    return sizes + field(2, FLOAT) + field(8, name) + field(9, struct.pack(f"<{len(values)}f", *values))


def node(operator: str, *inputs: str, output: str) -> bytes:
    """A step of a model."""
    return b"".join(field(1, name) for name in inputs) + field(2, output) + field(4, operator)


def port(name: str, shape: Sequence[int]) -> bytes:
    """An input or output of a model."""
    sizes = b"".join(field(1, field(1, size)) for size in shape)
    return field(1, name) + field(2, field(1, field(1, FLOAT) + field(2, sizes)))


def model(nodes: Sequence[bytes], tensors: Sequence[bytes], inputs: bytes, outputs: bytes) -> bytes:
    """A model of one input and one output, for every release from 2021 on."""
    graph = b"".join(field(1, item) for item in nodes) + field(2, "graph")
    graph += b"".join(field(5, item) for item in tensors) + field(11, inputs) + field(12, outputs)
    return field(1, 7) + field(7, graph) + field(8, field(2, 13))


def main(folder: Path) -> None:
    weights = tensor("w", (4, 3), [value for row in WEIGHTS for value in row])
    steps = [
        node("MatMul", "x", "w", output="product"),
        node("Add", "product", "b", output="sum"),
        node("Tanh", "sum", output="y"),
    ]
    (folder / "tanh.onnx").write_bytes(
        model(steps, [weights, tensor("b", (3,), BIAS)], port("x", (2, 4)), port("y", (2, 3)))
    )
    quarters = tensor("w", (4, 1), [0.25] * 4)
    (folder / "mean.onnx").write_bytes(
        model([node("MatMul", "x", "w", output="y")], [quarters], port("x", (1, 4)), port("y", (1, 1)))
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]))
