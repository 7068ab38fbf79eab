"""Words that people say instead of ours, on the command line and as answers: `noble`, `ros-base`, `pytorch`, `gpu`, `no`."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rosml.images.matrix import combinations, names
from rosml.images.matrix.model import Matrix

NOTHING = ("none", "no", "nothing", "without", "-")

NVIDIA = ("gpu", "nvidia", "cuda")


def distributions(matrix: Matrix, word: str) -> list[str]:
    """The distributions that a word means: `jazzy`, `ROS2 Jazzy`, `bookworm` and other old names, `noble`, `Ubuntu 24.04`, `ROS 1`."""
    rows, name = matrix.distributions, word.strip().lower()
    if name in rows:
        return [name]
    if ros := re.fullmatch(r"ros[\s-]?([12])", name):
        return [row for row, facts in rows.items() if facts.ros == int(ros[1])]
    name = re.sub(r"^ros[12]?[\s-]+", "", name)
    meant = [row for row, facts in rows.items() if name in (row, facts.ros_distro, *facts.aliases)]
    for key, system in matrix.operating_systems.items():
        aliases = {key, key.partition("-")[2], system.codename, system.image.rpartition("/")[2]}
        if _bare(name) in {_bare(alias) for alias in aliases if alias}:
            meant += [row for row, facts in rows.items() if facts.os == key]
    return list(dict.fromkeys(meant))


def _bare(text: str) -> str:
    return re.sub(r"[\s:_-]", "", text)


def component(matrix: Matrix, word: str) -> str:
    """The component that a word means: `ros-base`, `desktop_full`; the word itself if it means none."""
    name = re.sub(r"^ros[12]?-", "", word.strip().lower().replace("_", "-"))
    return name if name in matrix.components else word.strip()


def frameworks(matrix: Matrix, text: str) -> list[str]:
    """The frameworks that a text means: `PyTorch`, `tensorflow2`, `torch and tf`, `no`. Each word as it is if it means none."""
    words = [word for word in re.split(r"[\s,+&]+", text.strip()) if word.lower() not in ("", "and")]
    return [combinations.plain(matrix) if word.lower() in NOTHING else names.our_word(matrix, word) for word in words]


def stack(matrix: Matrix, word: str, stacks: Sequence[str]) -> str:
    """The first of some stacks that a word means: `cu128`, `CUDA 12.8`, `12`, `gpu`, `cpu`; the word itself if it means none."""
    name = word.strip().lower()
    cuda = {stack: matrix.stacks[stack].cuda or "" for stack in stacks}
    if name in stacks:
        return name
    if name in (*NOTHING, "cpu"):
        return next((stack for stack in stacks if not cuda[stack]), name)
    if name in NVIDIA:
        return next((stack for stack in stacks if cuda[stack]), name)
    if version := re.fullmatch(r"(?:cuda|cu)?[\s-]*([0-9]+(?:\.[0-9]+)*)", name):
        return next((stack for stack in stacks if f"{cuda[stack]}.".startswith(f"{version[1]}.")), name)
    return name


def forge(word: str) -> str:
    """The forge that a word means: `GitHub Actions`, `gitlab-ci`, `no`; the word itself if it means none."""
    name = word.strip().lower()
    return "none" if name in NOTHING else re.sub(r"^(git(?:hub|lab))(?:\.com|[\s-](?:actions|ci))$", r"\1", name)
