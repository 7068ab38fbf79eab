"""The compute capabilities of this machine's NVIDIA GPUs, and whether code was built for them. Starts no process: this machine's
files have the numbers of the chips."""

from __future__ import annotations

import re
from collections.abc import Iterable

from rosml.run.context import Host

DRIVEN = "/sys/bus/pci/drivers/nvidia"
BOARD = "/proc/device-tree/compatible"
CARDS = {
    "15f.": (6, 0),
    "1[bc]..|1d[0-5].": (6, 1),
    "1d[89a-f].": (7, 0),
    "1[ef]..|21..": (7, 5),
    "20..": (8, 0),
    "2[245]..": (8, 6),
    "2[678]..": (8, 9),
    "23..": (9, 0),
    "29..": (10, 0),
    "31..": (10, 3),
    "2b00": (11, 0),
    "2b..|2c..|2d..|2f..": (12, 0),
    "2e..": (12, 1),
}
"""Patterns of the devices' numbers, from Pascal on, of which the first counts: the list of PCI devices names the chips
(https://pci-ids.ucw.cz/read/PC/10de), and NVIDIA their compute capabilities (https://developer.nvidia.com/cuda-gpus)."""

BOARDS = {"186": (6, 2), "194": (7, 2), "234": (8, 7), "264": (11, 0)}
"""The same of Jetsons: TX2, Xavier, Orin, Thor."""

_KIND = re.compile(r"(sm|compute)_([0-9]{1,2})([0-9])([af]?)")

Capability = tuple[int, int]


def capabilities(host: Host) -> list[Capability]:
    """The compute capabilities of this machine's GPUs, without duplicates; those of unknown chips are left out."""
    board = re.search(r"nvidia,tegra([0-9]{3})(?![0-9])", host.text(BOARD))
    known_capabilities = {BOARDS[board[1]]} if board and board[1] in BOARDS else set()
    for device in host.files(DRIVEN):
        number = host.text(f"{device}/device").strip().lower().removeprefix("0x")
        known_capabilities.update([value for pattern, value in CARDS.items() if re.fullmatch(pattern, number)][:1])
    return sorted(known_capabilities)


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
