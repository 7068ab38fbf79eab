"""Words that people say instead of ours, on the command line and as answers: `noble`, `ros-base`, `pytorch`, `gpu`, `no`."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rosml.images.matrix import names, rules
from rosml.images.matrix.model import Matrix

NOTHING = ("none", "no", "nothing", "without", "-")
"""Answers of those who want none of it."""

NVIDIA = ("gpu", "nvidia", "cuda")
"""Words for any stack with CUDA."""


def distributions(matrix: Matrix, word: str) -> list[str]:
    """The distributions that a word names: `jazzy`, `ROS2 Jazzy`, `bookworm` and other old names, `noble`, `Ubuntu 24.04`, `ROS 1`."""
    rows, said = matrix.distributions, word.strip().lower()
    if said in rows:
        return [said]
    if ros := re.fullmatch(r"ros[\s-]?([12])", said):
        return [name for name, facts in rows.items() if facts.ros == int(ros[1])]
    said = re.sub(r"^ros[12]?[\s-]+", "", said)
    found = [name for name, facts in rows.items() if said in (name, facts.ros_distro, *facts.aliases)]
    for key, system in matrix.operating_systems.items():
        called = {key, key.partition("-")[2], system.codename, system.image.rpartition("/")[2]}
        if _bare(said) in {_bare(name) for name in called if name}:
            found += [name for name, facts in rows.items() if facts.os == key]
    return list(dict.fromkeys(found))


def _bare(text: str) -> str:
    return re.sub(r"[\s:_-]", "", text)


def component(matrix: Matrix, word: str) -> str:
    """The component that a word names: `ros-base`, `desktop_full`; the word itself if it names none."""
    said = re.sub(r"^ros[12]?-", "", word.strip().lower().replace("_", "-"))
    return said if said in matrix.components else word.strip()


def frameworks(matrix: Matrix, word: str) -> list[str]:
    """The frameworks that a text names: `PyTorch`, `tensorflow2`, `torch and tf`, `no`. Each word as it is if it names none."""
    said = [text for text in re.split(r"[\s,+&]+", word.strip()) if text.lower() not in ("", "and")]
    return [rules.plain(matrix) if text.lower() in NOTHING else names.our_word(matrix, text) for text in said]


def stack(matrix: Matrix, word: str, there: Sequence[str]) -> str:
    """The stack that a word names: `cu128`, `CUDA 12.8`, `12`, `gpu`, `cpu`; the word itself if it names none.

    Args:
        there: the stacks to choose from, the best first.
    """
    said = word.strip().lower()
    cuda = {name: matrix.stacks[name].cuda or "" for name in there}
    if said in there:
        return said
    if said in (*NOTHING, "cpu"):
        return next((name for name in there if not cuda[name]), said)
    if said in NVIDIA:
        return next((name for name in there if cuda[name]), said)
    if version := re.fullmatch(r"(?:cuda|cu)?[\s-]*([0-9]+(?:\.[0-9]+)*)", said):
        return next((name for name in there if f"{cuda[name]}.".startswith(f"{version[1]}.")), said)
    return said


def forge(word: str) -> str:
    """The forge that a word names: `GitHub Actions`, `gitlab-ci`, `no`; the word itself if it names none."""
    said = word.strip().lower()
    return "none" if said in NOTHING else re.sub(r"^(git(?:hub|lab))(?:\.com|[\s-](?:actions|ci))$", r"\1", said)
