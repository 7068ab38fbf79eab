"""Compares cv_bridge's conversions of pictures under two numpys: pictures.py write FILE, and beside the other one pictures.py compare FILE."""

import itertools
import sys
import zlib

import numpy as np
from cv_bridge import CvBridge
from cv_bridge.boost import cv_bridge_boost

COLOURS = ("mono", "rgb", "bgr", "rgba", "bgra", "bayer_rggb", "bayer_bggr", "bayer_gbrg", "bayer_grbg")
PLAIN = [f"{kind}C{channels}" for kind in ("8U", "8S", "16U", "16S", "32S", "32F", "64F") for channels in (1, 2, 3, 4)]
ENCODINGS = [*(f"{colour}{bits}" for colour in COLOURS for bits in (8, 16)), "yuv422", *PLAIN]


def picture(encoding: str) -> np.ndarray:
    """Noise, the same in each process; numbers with a fraction are beyond what a byte holds."""
    kind, channels = CvBridge().encoding_to_dtype_with_channels(encoding)
    shape = (64, 96) if channels == 1 else (64, 96, channels)
    noise = np.random.default_rng(zlib.crc32(encoding.encode()))
    if np.dtype(kind).kind == "f":
        return (noise.standard_normal(shape) * 300).astype(kind)
    limits = np.iinfo(kind)
    return noise.integers(limits.min, limits.max, shape, kind, endpoint=True)


def converted(before: str, after: str) -> np.ndarray:
    """By a message, as a node does it. A refusal is a picture of no size."""
    message = CvBridge().cv2_to_imgmsg(picture(before), before)
    try:
        return CvBridge().imgmsg_to_cv2(message, after)
    except TypeError:  # CvBridgeError is one
        return np.zeros(0)


def difference(one: np.ndarray, other: np.ndarray) -> float:
    if (one.shape, one.dtype) != (other.shape, other.dtype):
        return float("inf")
    return float(np.abs(one.astype(float) - other.astype(float)).max(initial=0))


mode, file = sys.argv[1:]
pictures = {f"{before} {after}": converted(before, after) for before, after in itertools.product(ENCODINGS, repeat=2)}
if mode == "write":
    np.savez(file, **pictures)
else:
    others = np.load(file)
    differing = {pair: difference(image, others[pair]) for pair, image in pictures.items()}
    for pair, most in differing.items():
        steps = 257 if pair.endswith("16") else 1  # OpenCV's own demosaicing rounds otherwise in another version
        if most > (steps if pair.startswith("bayer") and " mono" in pair else 0):
            sys.exit(f"{pair}: differs by {most}")
done = sum(image.size > 0 for image in pictures.values())
print(
    f"pictures: {len(pictures)} pairs, {done} converted, numpy {np.__version__}, {cv_bridge_boost.cvtColor2.__module__}"
)
