#!/usr/bin/env python3
"""torchvision and torchaudio are those that the tag's release of PyTorch goes with, or are not there; their operators work
on its tensors, and pictures are read the same beside OpenCV, where that is there."""

from __future__ import annotations

import io
import math
import os
import subprocess
import sys
from importlib import metadata, util
from typing import Any


def promised(package: str) -> str | None:
    """The version that the matrix promises of a package; none where there is to be none."""
    expected = os.environ.get(f"EXPECT_{package.upper()}")
    try:
        version = metadata.version(package).partition("+")[0]
    except metadata.PackageNotFoundError:
        version = None
    if version != expected:
        sys.exit(f"{package} {version}, expected {expected}")
    return expected


def overlap(one: list[float], other: list[float]) -> float:
    """The area that two boxes share, as a part of the area that they cover together."""
    width = min(one[2], other[2]) - max(one[0], other[0])
    height = min(one[3], other[3]) - max(one[1], other[1])
    shared = max(width, 0.0) * max(height, 0.0)
    area = sum((box[2] - box[0]) * (box[3] - box[1]) for box in (one, other))
    return shared / (area - shared)


def kept(boxes: list[list[float]], scores: list[float], limit: float) -> list[int]:
    """What non-maximum suppression keeps, best first."""
    best: list[int] = []
    for index in sorted(range(len(boxes)), key=lambda index: -scores[index]):
        if all(overlap(boxes[index], boxes[other]) <= limit for other in best):
            best.append(index)
    return best


def vision(opencv_first: bool) -> None:
    """Boxes are suppressed as they should be, and pictures decoded as Pillow and OpenCV decode them."""
    has_opencv = util.find_spec("cv2") is not None
    if has_opencv and opencv_first:
        import cv2
    import torch
    import torchvision
    from PIL import Image
    from torchvision.io import decode_image, encode_png

    if has_opencv:
        import cv2

    torch.manual_seed(1)
    corners = torch.rand(200, 2) * 100
    boxes, scores = torch.cat([corners, corners + 5 + torch.rand(200, 2) * 30], 1), torch.rand(200)
    indices = torchvision.ops.nms(boxes, scores, 0.4).tolist()
    assert indices == kept(boxes.tolist(), scores.tolist(), 0.4), indices
    assert 0 < len(indices) < 200

    ramp = torch.linspace(0, 255, 32).to(torch.uint8)
    picture = torch.stack([ramp.expand(32, 32), ramp.expand(32, 32).T, torch.full((32, 32), 128, dtype=torch.uint8)])
    png = encode_png(picture)
    assert torch.equal(decode_image(png), picture)
    stream = io.BytesIO()
    Image.fromarray(picture.permute(1, 2, 0).numpy()).save(stream, "jpeg", quality=95)
    jpeg = torch.frombuffer(bytearray(stream.getvalue()), dtype=torch.uint8)
    assert (decode_image(jpeg).int() - picture.int()).abs().max() < 30
    if has_opencv:
        theirs: Any = cv2.imdecode(png.numpy(), cv2.IMREAD_COLOR)
        assert torch.equal(torch.from_numpy(theirs[..., ::-1].copy()).permute(2, 0, 1), picture)
    with open("/proc/self/maps") as maps:
        runtimes = {line.split()[-1] for line in maps if "libcudart" in line}
    assert len(runtimes) == (1 if os.environ.get("EXPECT_CUDA") else 0), runtimes


def audio() -> None:
    """A filter and a loss, both in C++, come to what they are by definition."""
    import torch
    import torchaudio

    sound = torch.sin(torch.arange(100) * 0.3)
    filtered = torchaudio.functional.lfilter(sound, torch.tensor([1.0, -0.5]), torch.tensor([0.25, 0.0]))
    level = 0.0
    for number, result in zip(sound.tolist(), filtered.tolist()):
        level = 0.25 * number + 0.5 * level
        assert abs(level - result) < 1e-5
    loss = torchaudio.functional.rnnt_loss(  # three ways of four steps, each one of four that are equally likely
        torch.zeros(1, 2, 3, 4), *(torch.tensor(item, dtype=torch.int32) for item in ([[1, 2]], [2], [2]))
    )
    assert abs(loss.item() - (4 * math.log(4) - math.log(3))) < 1e-4, loss


if __name__ == "__main__":
    if sys.argv[1:]:
        vision(opencv_first=sys.argv[1] == "opencv-first")
        sys.exit()
    if version := promised("torchvision"):
        orders = ("opencv-first", "opencv-last") if util.find_spec("cv2") else ("opencv-first",)
        for order in orders:
            subprocess.run([sys.executable, __file__, order], check=True)
        print("torchvision", version)
    if version := promised("torchaudio"):
        audio()
        print("torchaudio", version)
