"""What the labels of images and parts say: for the bake file, and for whoever joins images in a registry.

A part says what it is and what it takes, so that it can be joined by somebody who has the registry and nothing else.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from rosml.images.image_set.model import Image, Part
from rosml.images.matrix import names
from rosml.images.matrix.model import ANY_PYTHON, PartEntry
from rosml.images.matrix.rules import Brought

PREFIX = "io.rosml."
TITLE = "org.opencontainers.image.title"
DESCRIPTION = "org.opencontainers.image.description"
VERSION = "org.opencontainers.image.version"
SOURCE = "org.opencontainers.image.source"
REVISION = "org.opencontainers.image.revision"

OCI = "org.opencontainers.image."
"""Prefix of the labels that an index has as annotations too."""

BRINGS = f"{PREFIX}brings"
"""The label of a part that says what it brings, with how tags and descriptions call it: `tensorflow:tf:TensorFlow`."""

APP = f"{PREFIX}app"
"""The label of an image with an app: which of its images it is, such as `run`. Its title is the app's name."""

GPU = f"{PREFIX}gpu."
"""Prefix of the labels that say which driver and which GPUs: `driver`, `torch.amd64`."""

RUNTIME = f"{PREFIX}runtime"
"""The label of an image that says on which component programs run that are built on it."""

RMW = f"{PREFIX}rmw"
"""The label of an image whose ROS 2 takes another RMW implementation than Fast DDS's if nobody names one."""

OWN = f"{PREFIX}own"
"""The label of an image of somebody else, with ROS on it, that has CUDA or a framework of its own: what, and the variables that say so."""

RELEASE = f"{PREFIX}release"
"""The label of a part that says what it is a release of."""


def named(
    distribution: str, component: str, ros: str, framework: str, stack: str | None, brought: Sequence[Brought]
) -> dict[str, str]:
    """The labels by which people know an image.

    Args:
        brought: what it carries, in the order in which the environment names it.
    """
    carried = [f"{item.title} {item.version}" for item in brought if item.title]
    return {
        TITLE: names.image_target(distribution, component, framework, stack),
        DESCRIPTION: ", ".join([f"ROS {ros} {component} ({distribution})", *carried]),
        VERSION: names.spelled_tag(names.main_tag(distribution, component, stack), spelled(brought)),
        f"{PREFIX}component": component,
    }


def spelled(brought: Sequence[Brought]) -> dict[str, str]:
    """The versions of what an image is for, by what tags call it: of its releases, or else of what its stack has."""
    called = [item for item in brought if item.short]
    return {item.short: item.version for item in [item for item in called if item.released] or called}


def environment(brought: Sequence[Brought]) -> dict[str, str]:
    """The variables that an image has of what was joined to it."""
    versions = {f"{variable(item.name)}_VERSION": item.version for item in brought}
    cuda = next((item.version for item in brought if item.name == "cuda"), None)
    return versions | ({REQUIRE: required_driver(cuda)} if cuda else {})


REQUIRE = "NVIDIA_REQUIRE_CUDA"
"""The variable that NVIDIA's container runtime compares with the driver before it starts a container."""


def required_driver(cuda: str) -> str:
    """What a version of CUDA asks of the driver: the first release of its generation, by NVIDIA's minor-version
    compatibility: `cuda>=12.0` for 12.8.90."""
    return f"cuda>={cuda.partition('.')[0]}.0"


def about_gpus(facts: Mapping[str, str]) -> dict[str, str]:
    """The labels about GPUs."""
    return {GPU + name: value for name, value in facts.items()}


def variable(name: str) -> str:
    """How variables begin that are about a part or a version."""
    return name.upper().replace("-", "_")


def of_part(
    entry: PartEntry,
    stack: str,
    python: str,
    brought: Sequence[Brought],
    frameworks: Mapping[str, Sequence[PartEntry]],
    gpu: Mapping[str, str] | None = None,
) -> dict[str, str]:
    """The labels of a part.

    Args:
        python: `any` where the part is the same for all. brought: what it brings.
        frameworks: the parts of every framework that takes this one. gpu: what it says of GPUs.
    """
    pythons = "any Python" if python == ANY_PYTHON else f"Python {python}"
    return {
        TITLE: names.part_name(entry.name, stack, python),
        DESCRIPTION: f"part {entry.name} of stack {stack}, for {pythons}",
        f"{PREFIX}part": entry.name,
        f"{PREFIX}stack": stack,
        f"{PREFIX}python": python,
        **{f"{PREFIX}{item.name}": item.version for item in brought},
        **about_gpus(gpu or {}),
        **({BRINGS: called(brought)} if brought else {}),
        **({RELEASE: entry.release} if entry.release else {}),
        f"{PREFIX}frameworks": " ".join(f"{name}={_marked(frameworks[name])}" for name in smallest_first(frameworks)),
    }


def _marked(parts: Iterable[PartEntry]) -> str:
    """Names of parts, with * at those for any Python."""
    return ",".join(f"{part.name}*" if part.any_python else part.name for part in parts)


def called(brought: Sequence[Brought]) -> str:
    """What a part brings, as its label says it: `cuda:cuda:CUDA cudnn::`."""
    return " ".join(f"{item.name}:{item.short}:{item.title}" for item in brought)


def brought_by(labels: Mapping[str, str]) -> Iterator[Brought]:
    """What a part with these labels brings.

    Raises:
        ValueError: the label is damaged.
    """
    for item in labels.get(BRINGS, "").split():
        name, short, title = item.split(":")
        if version := labels.get(PREFIX + name):
            yield Brought(name, version, title, short, RELEASE in labels)


def smallest_first(frameworks: Mapping[str, Sequence[object]]) -> list[str]:
    """Frameworks by the number of their parts, then by name: the order of the matrix does not count."""
    return sorted(frameworks, key=lambda name: (len(frameworks[name]), name))


def frameworks(text: str) -> dict[str, tuple[str, ...]]:
    """The parts of every framework that takes a part, as its label has them: smallest first.

    Raises:
        ValueError: the label is damaged.
    """
    pairs = (item.split("=") for item in text.split())
    return {name: tuple(part.removesuffix("*") for part in parts.split(",")) for name, parts in pairs}


def any_python(text: str, part: str) -> bool:
    """Whether a part is for any Python, as the label that names it says."""
    return f"{part}*" in re.split("[ =,]", text)


def title(thing: Image | Part) -> str:
    """What the label and the annotation of that name say of an image or part."""
    return thing.name if isinstance(thing, Part) else thing.target
