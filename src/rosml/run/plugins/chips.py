"""The compute capabilities of this machine's NVIDIA GPUs. Starts no process: this machine's files have the numbers of the chips."""

from __future__ import annotations

import re

from rosml.base.gpu_code import Capability
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


def capabilities(host: Host) -> list[Capability]:
    """The compute capabilities of this machine's GPUs, without duplicates; those of unknown chips are left out."""
    board = re.search(r"nvidia,tegra([0-9]{3})(?![0-9])", host.text(BOARD))
    known_capabilities = {BOARDS[board[1]]} if board and board[1] in BOARDS else set()
    for device in host.files(DRIVEN):
        number = host.text(f"{device}/device").strip().lower().removeprefix("0x")
        known_capabilities.update([value for pattern, value in CARDS.items() if re.fullmatch(pattern, number)][:1])
    return sorted(known_capabilities)
