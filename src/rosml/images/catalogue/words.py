"""Words by which people look for an image, from the matrix: `noble`, `py312`, `gpu`, `aarch64`, `lts`."""

from __future__ import annotations

from collections.abc import Iterator

from rosml.images.image_set.model import Image, ImageSet
from rosml.images.image_set.selection import NVIDIA
from rosml.images.matrix.names import our_words

_DEBIAN = {"bookworm": "12", "trixie": "13"}
"""Numbers of Debian's releases, which base images name by codename alone: https://www.debian.org/releases/"""

_JETSON, _THOR = "arm64", "sm_110"
"""The architecture of NVIDIA's boards, and the newest one's GPU: a Jetson may run images with CUDA whose libraries were built for both
(docs/gpus.md)."""


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
    yield from (f"python {image.python}", f"py{image.python.replace('.', '')}")
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
        yield from (*NVIDIA, f"cuda {stack.cuda}", "jetson" * _on_jetson(image))
    for name, value in image.gpu.items():
        yield from [f"{name} {value}"] if name == "driver" else value.split()


def _on_jetson(image: Image) -> bool:
    built = [value.split() for name, value in image.gpu.items() if name.endswith(f".{_JETSON}")]
    return _JETSON in image.architectures and all(_THOR in kinds for kinds in built)


def _content(image_set: ImageSet, image: Image) -> Iterator[str]:
    has = {image.framework, *image.addons, *(item.name for item in image.brought), *image.architectures}
    yield from image.addons
    yield from (word for word, ours in our_words(image_set.matrix).items() if ours in has)
