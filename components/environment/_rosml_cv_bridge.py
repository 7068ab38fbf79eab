"""The functions of cv_bridge's compiled module, by the environment's OpenCV: for a module that was compiled for another numpy or OpenCV.

The names of encodings are those of sensor_msgs. The rules are cv_bridge's: colours go to any colours, 8 and 16 bits are scaled, and a
picture without colours only goes to another one with as many channels. The tests compare the results with cv_bridge's own. OpenCV's
number of a type depends on its version, so it comes from the OpenCV that cv_bridge's Python code asks as well.
"""

from __future__ import annotations

import re
from typing import Any

import cv2
import numpy as np

_DEPTHS = {"8U": "u1", "8S": "i1", "16U": "u2", "16S": "i2", "32S": "i4", "32F": "f4", "64F": "f8"}
_COLOURS = {"mono": "GRAY", "rgb": "RGB", "bgr": "BGR", "rgba": "RGBA", "bgra": "BGRA"}

_CAMERAS = {
    "yuv422": "YUV2{}_UYVY",
    "yuv422_yuy2": "YUV2{}_YUY2",
    "bayer_rggb": "BayerBG2{}",  # OpenCV's names are of other pixels: those in the second row, from the second column on
    "bayer_bggr": "BayerRG2{}",
    "bayer_gbrg": "BayerGR2{}",
    "bayer_grbg": "BayerGB2{}",
}
"""What comes from a camera alone, and OpenCV's names of its conversions to colours."""

_CHANNELS = {"GRAY": 1, "RGB": 3, "BGR": 3, "RGBA": 4, "BGRA": 4}


class _Encoding:
    """An encoding: its colours if it has some, the type of its numbers, also by OpenCV's name, and how many each pixel has; 0 if the name
    does not say it, as in 32F."""

    def __init__(self, name: str) -> None:
        self.name = name
        depth = re.fullmatch(r"(8U|8S|16U|16S|32S|32F|64F)(?:C([0-9]+))?", name)
        colours = re.fullmatch(r"(mono|rgba?|bgra?|bayer_[a-z]{4})(8|16)", name)
        self.colours = colours[1] if colours else name if name in _CAMERAS else ""
        if depth:
            self.depth, self.channels = depth[1], int(depth[2] or 0)
        elif self.colours in _COLOURS or self.colours in _CAMERAS:
            self.depth = "16U" if colours and colours[2] == "16" else "8U"
            self.channels = 2 if name.startswith("yuv") else _CHANNELS.get(_COLOURS.get(self.colours, ""), 1)
        else:
            raise RuntimeError(f"{name!r} is no encoding that cv_bridge reads")
        self.type = np.dtype(_DEPTHS[self.depth])


def convert(picture: Any, encoding_in: str, encoding_out: str) -> Any:
    """The picture in another encoding; a copy if it is the same one, or empty. Raises a RuntimeError if that makes no sense."""
    if picture is None:
        raise RuntimeError("there is no picture: its data are damaged")
    if encoding_out in ("", encoding_in):
        return picture.copy()
    before, after = _Encoding(encoding_in), _Encoding(encoding_out)
    if not (before.colours and after.colours):
        if after.colours or not before.channels or before.channels != after.channels:
            why = "that has colours" if after.colours else "that has other channels"
            raise RuntimeError(f"a picture of {encoding_in} cannot become one of {encoding_out}: {why}")
        return _to_type(picture, after.type)
    if before.colours != after.colours:
        try:
            return _to_type(cv2.cvtColor(picture, _code(before, after)), after.type)
        except cv2.error as error:  # cv_bridge makes its own error of a RuntimeError alone
            raise RuntimeError(str(error)) from None
    if before.colours.startswith("bayer"):
        raise _unsupported(before, after)
    return _to_type(picture, after.type)


def _code(before: _Encoding, after: _Encoding) -> int:
    """OpenCV's number of a conversion between colours."""
    to = _COLOURS.get(after.colours, "")
    name = _CAMERAS.get(before.colours, f"{_COLOURS.get(before.colours)}2{{}}").format(to)
    if not to or (before.colours.startswith("bayer") and to.endswith("A")):
        raise _unsupported(before, after)
    code: int = getattr(cv2, f"COLOR_{name}")
    return code


def _unsupported(before: _Encoding, after: _Encoding) -> RuntimeError:
    return RuntimeError(f"cv_bridge converts no {before.name} to {after.name}")


def _to_type(picture: Any, kind: Any) -> Any:
    """The picture with numbers of another type: 8 and 16 bits are scaled, and all stay in the type's range."""
    if picture.dtype == kind:
        return picture.copy()
    scale = {(1, 2): 65535 / 255, (2, 1): 255 / 65535}.get((picture.dtype.itemsize, kind.itemsize), 1)
    scaled = picture.astype(np.float64) * scale
    if kind.kind == "f":
        return scaled.astype(kind)
    limits = np.iinfo(kind)
    whole = np.nan_to_num(np.rint(scaled), nan=limits.min, posinf=limits.min, neginf=limits.min)
    return np.clip(whole, limits.min, limits.max).astype(kind)


def _number(encoding: str) -> int:
    """OpenCV's number of the type that a picture of an encoding has."""
    it = _Encoding(encoding)
    depth: int = getattr(cv2, f"CV_{it.depth}")
    return depth + (max(it.channels, 1) - 1) * _PER_CHANNEL


_PER_CHANNEL: int = cv2.CV_8UC2 - cv2.CV_8UC1


def _show(*_arguments: object, **_more: object) -> None:
    text = "cvtColorForDisplay of this cv_bridge is compiled for another numpy or OpenCV than the environment's"
    raise RuntimeError(f"{text}; convert the picture by CvBridge or cv2.cvtColor")


FUNCTIONS = {
    "cvtColor2": convert,
    "getCvType": _number,
    "CV_MAT_CNWrap": lambda number: number // _PER_CHANNEL + 1,
    "CV_MAT_DEPTHWrap": lambda number: number % _PER_CHANNEL,
    "cvtColorForDisplay": _show,
}
"""By cv_bridge's names."""
