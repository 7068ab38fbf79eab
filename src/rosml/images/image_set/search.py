"""Words by which people look for an image, from the matrix: `noble`, `py312`, `rtx 4090`, `driver 550`, `libtorch`, `cv_bridge`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from rosml.base.gpu_code import Capability, covers
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.image_set.selection import groups_of, members
from rosml.images.matrix import combinations
from rosml.images.matrix.names import our_words

_DEBIAN = {"bookworm": "12", "trixie": "13"}
"""Numbers of Debian's releases, which base images name by codename alone: https://www.debian.org/releases/"""

_JETSON, _THOR = "arm64", "sm_110"
"""The architecture of NVIDIA's boards, and the newest one's GPU: a Jetson may run images with CUDA whose libraries were built for both
(docs/gpus.md)."""
_ORIN: Capability = (8, 7)

_GPUS: dict[Capability, Sequence[str]] = {
    (7, 0): ("v100",),
    (7, 5): ("t4", "rtx 2060", "rtx 2070", "rtx 2080"),
    (8, 0): ("a100", "a30"),
    (8, 6): ("a10", "a40", "rtx a4000", "rtx a6000", "rtx 3050", "rtx 3060", "rtx 3070", "rtx 3080", "rtx 3090"),
    (8, 9): ("l4", "l40", "l40s", "rtx 6000", "rtx 4050", "rtx 4060", "rtx 4070", "rtx 4080", "rtx 4090"),
    (9, 0): ("h100", "h200", "gh200"),
    (10, 0): ("b200", "gb200"),
    (10, 3): ("b300", "gb300"),
    (12, 0): ("rtx 5050", "rtx 5060", "rtx 5070", "rtx 5080", "rtx 5090"),
    (12, 1): ("gb10", "dgx spark"),
}
"""GPUs by their compute capability: https://developer.nvidia.com/cuda-gpus"""

_JOINED = re.compile(r"([a-z][a-z_]*)[-:=]*([0-9][0-9.]*)")
"""A name and its number without a space: `python3.12`, `ubuntu-24.04`, `driver:550`."""


def search(image_set: ImageSet, terms: Sequence[str]) -> tuple[Image, ...]:
    """The images that each of some terms means: a group, or one or two words of `words`.

    Raises:
        RosmlError: a term means no image (exit code 2).
    """
    groups = groups_of(image_set)
    words_by_image = {image.target: words(image_set, image) for image in image_set.images}
    hits = {image.target for image in image_set.images}
    rest = [term for text in terms for term in ([text] if text in groups else text.lower().split())]
    while rest:
        term, *after = rest
        pair = " ".join(rest[:2])
        for phrase, remaining in ((pair, after[1:]), (term, after)):
            if phrase not in groups and (matches := _having(words_by_image, phrase)):
                rest = remaining
                break
        else:
            matches, rest = {image.target for image in members(image_set, [term])}, after
        hits &= matches
    return tuple(image for image in image_set.images if image.target in hits)


def having(image_set: ImageSet, phrase: str) -> set[str]:
    """The targets of the images that have a phrase among their words."""
    return _having({image.target: words(image_set, image) for image in image_set.images}, phrase.lower())


def _having(words_by_image: dict[str, tuple[str, ...]], phrase: str) -> set[str]:
    """The images with a phrase among their words. A version may go on: `cuda 13.0` means 13.0.96. A driver runs what older ones run."""
    joined = _JOINED.fullmatch(phrase)
    spaced = f"{joined[1]} {joined[2]}" if joined else phrase
    driver = re.fullmatch(r"driver ([0-9]{1,4})[0-9.]*", spaced)

    def fits(word: str) -> bool:
        if driver and (oldest := re.match(r"driver ([0-9]+)", word)):
            return int(oldest[1]) <= int(driver[1])
        return word in (phrase, spaced) or word.startswith(f"{spaced}.")

    return {target for target, of_image in words_by_image.items() if any(map(fits, of_image))}


def words(image_set: ImageSet, image: Image) -> tuple[str, ...]:
    """Words for an image beside its name, its tags and the versions in it. A version follows its name: `python
    3.12`."""
    every = (*_distribution(image_set, image), *_machine(image_set, image), *_content(image_set, image))
    return tuple(dict.fromkeys(word.lower() for word in every if word))


def _distribution(image_set: ImageSet, image: Image) -> Iterator[str]:
    matrix = image_set.matrix
    facts = matrix.distributions[image.distribution]
    system = matrix.operating_systems[facts.os]
    base = system.image.rpartition("/")[2]
    name, _, release = base.partition(":")
    yield from (*facts.aliases, image.ros_distro, f"ros{facts.ros}")
    yield from (facts.os, system.codename or "", base, f"{name} {_DEBIAN.get(release, release)}")
    yield from (f"python {image.python}", f"py{image.python.replace('.', '')}", f"py{image.python}")
    yield from ("lts" * facts.lts, "experimental" * facts.experimental)


def _machine(image_set: ImageSet, image: Image) -> Iterator[str]:
    matrix = image_set.matrix
    for name in image.architectures:
        facts = matrix.architectures[name]
        yield from (name, facts.platform, facts.wheels.partition("-")[0])
    if not image.stack:
        return
    stack = matrix.stacks[image.stack]
    yield stack.accelerator
    if stack.cuda:
        yield from ("gpu", "nvidia", f"cuda {stack.cuda}", *_boards(image), *_gpus(image))
    for name, value in image.gpu.items():
        yield from [f"{name} {value}"] if name == "driver" else value.split()


def _boards(image: Image) -> Iterator[str]:
    built = _built(image, _JETSON)
    if _JETSON in image.architectures and all(_THOR in kinds for kinds in built):
        yield from ("jetson", "thor")
        yield "orin" * all(covers(kinds, _ORIN) for kinds in built)


def _gpus(image: Image) -> Iterator[str]:
    """The GPUs on which all that an image has runs, on some architecture."""
    for capability, names in _GPUS.items():
        if any(all(covers(kinds, capability) for kinds in _built(image, name)) for name in image.architectures):
            yield from names


def _built(image: Image, architecture: str) -> list[list[str]]:
    """For each library of an image: the GPUs for which it was built on an architecture."""
    return [value.split() for name, value in image.gpu.items() if name.endswith(f".{architecture}")]


def _content(image_set: ImageSet, image: Image) -> Iterator[str]:
    matrix = image_set.matrix
    has = {image.framework, *image.addons, *(item.name for item in image.brought), *image.architectures}
    yield from (*image.addons, image.environment)
    yield from (word for word, ours in our_words(matrix).items() if ours in has)
    if matrix.distributions[image.distribution].wheels or combinations.only_runs(matrix, image.component):
        return  # the one has rclpy alone, the other no compiler
    yield from ("c++", "cpp")
    yield from (f"lib{name}" for name in matrix.releases if name in has)
    for component in combinations.chain(matrix, image.component):
        yield from matrix.components[component].search
