"""A matrix of any size: shaped like the real one, with everything that costs the generator time."""

from __future__ import annotations

import math

_SYSTEMS = 8
_COMPONENTS = ("core", "base", "robot", "perception", "desktop", "desktop-full")
_STACKS = ("cu118", "cu126", "cu128", "cu130", "cpu")
_FAMILIES = {"torch": "2.10.0", "tensorflow": "2.20.0"}

_PARTS = ("cuda", "common", "torch", "tensorflow-cc", "tensorflow")

IMAGES = len(_COMPONENTS) * (1 + 3 * len(_STACKS))
"""Images of a distribution: ROS alone, and three frameworks on each stack."""


def matrix(images: int) -> str:
    """The text of a valid matrix of at least that many images, and fewer than `IMAGES` more. Only the distributions
    grow in number, as they do in the real one; each takes 0.2 KB.
    """
    return "\n".join([_head(), "distributions:", *(_distribution(number) for number in range(_rows(images))), ""])


def _rows(images: int) -> int:
    return math.ceil(images / IMAGES)


def _distribution(number: int) -> str:
    components = f"[{', '.join(_COMPONENTS)}]"
    return (
        f"  d{number}: {{os: os-{number % _SYSTEMS}, ros: 2, packages: 'ros-{{ros_distro}}-{{metapackage}}', "
        f"components: {components}, default_stack: cu128, eol: 2030-05-31, lts: true, "
        f"apt: {{channel: snapshot, date: 2026-11-01}}}}"
    )


def _head() -> str:
    architectures = "[amd64, arm64]"
    pythons = ", ".join(f'"3.{8 + number}"' for number in range(_SYSTEMS))
    wheels = ", ".join(f"{stack}: {architectures}" for stack in _STACKS)
    forecast = "{unpacked: 900, compressed: 300}"
    lines = [
        "version: 1",
        "registry: localhost:5000",
        "default: {targets: [d0-core-torch-cu128], assembler: os-0, group: [d0-core]}",
        "architectures:",
        "  amd64: {platform: linux/amd64, wheels: x86_64-manylinux_2_28, runner: amd64}",
        "  arm64: {platform: linux/arm64, wheels: aarch64-manylinux_2_28, runner: arm64}",
        "operating_systems:",
    ]
    for number in range(_SYSTEMS):
        lines.append(
            f"  os-{number}: {{image: 'docker.io/library/os:{number}', digest: 'sha256:{number:064x}', "
            f"python: '3.{8 + number}', numpy: <2, architectures: {architectures}, tools: colcon vcstool, "
            f"codename: os{number}, apt_sources: {{ros2: {{version: 1.2.0, digest: 'sha256:{number:064x}'}}}}}}"
        )
    lines.append(
        "ros_archive: {live: 'http://ros.invalid/{generation}', snapshot: 'http://ros.invalid/{ros_distro}/{day}', "
        "apt_source: 'http://ros.invalid/{generation}-{version}.{codename}.deb'}"
    )
    lines.append("components:")
    for name, below in zip(_COMPONENTS, (None, *_COMPONENTS), strict=False):
        lines.append(f"  {name}: {{{f'builds_on: {below}' if below else ''}}}")
    lines += [
        "parts:",
        "  - {name: cuda, title: CUDA, accelerator: cuda, any_python: true, versions: [cuda, cudnn], takes: [nvidia-*]}",
        "  - {name: common, needs: [cuda], shared: true, tested: false, slot: 1}",
        "  - {name: torch, title: PyTorch, release: torch, needs: [common], slot: 2}",
        "  - {name: tensorflow-cc, release: tensorflow, any_python: true, needs: [tensorflow], repeats: [tensorflow], tested: false}",
        "  - {name: tensorflow, title: TensorFlow, short: tf, release: tensorflow, needs: [common, tensorflow-cc], slot: 3}",
        "frameworks:",
        "  none: {repository: ros}",
        "  torch: {repository: ros-torch, parts: [cuda, common, torch]}",
        "  tensorflow: {repository: ros-tf, parts: [cuda, common, tensorflow-cc, tensorflow]}",
        "  ml: {repository: ros-ml, parts: [cuda, common, torch, tensorflow-cc, tensorflow]}",
        "releases:",
        *(
            f"  {family}: {{{version}: {{python: [{pythons}], wheels: {{{wheels}}}}}}}"
            for family, version in _FAMILIES.items()
        ),
        "stacks:",
    ]
    for stack in _STACKS:
        cuda = "" if stack == "cpu" else "cuda: 12.8.90, cudnn: 9.10.2.21, nccl: 2.27.5, "
        accelerator = "cpu" if stack == "cpu" else "cuda"
        versions = ", ".join(f"{family}: {version}" for family, version in _FAMILIES.items())
        lines.append(f"  {stack}: {{accelerator: {accelerator}, {cuda}releases: {{{versions}}}}}")
    lines += ["disk:", f"  os: {forecast}", "  components:", *(f"    {name}: {forecast}" for name in _COMPONENTS)]
    parts = ", ".join(f"{part}: {forecast}" for part in _PARTS)
    lines += ["  parts:", *(f"    {stack}: {{{parts}}}" for stack in _STACKS)]
    lines.append("rates: {packages: 25, parts: 60, test: 15}")
    return "\n".join(lines)
