"""Which GPUs run code that was compiled for others: https://docs.nvidia.com/cuda/cuda-programming-guide/, compute capabilities."""

from __future__ import annotations

import re
from collections.abc import Iterable

Capability = tuple[int, int]

_KIND = re.compile(r"(sm|compute)_([0-9]{1,2})([0-9])([af]?)")


def covers(built: Iterable[str], capability: Capability) -> bool:
    """Whether code runs on a GPU. True if a word is unknown, as an image may say anything. `built` is what it was compiled for:
    `sm_80`, `sm_90a`, `compute_90`."""
    kinds = [_KIND.fullmatch(word) for word in built]
    return not all(kinds) or any(_runs(kind, capability) for kind in kinds if kind)


def _runs(kind: re.Match[str], capability: Capability) -> bool:
    """Machine code is for GPUs of its major version, from its minor version on. PTX is for all later GPUs. Code with an `a` is for one
    GPU alone."""
    target = int(kind[2]), int(kind[3])
    if kind[4] == "a":
        return capability == target
    return capability >= target and ((kind[1] == "compute" and not kind[4]) or capability[0] == target[0])
