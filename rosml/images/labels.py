"""What the labels of images and payloads say: for the bake file, and for whoever joins images in a registry.

A payload says what it is and what it takes, so that it can be joined by somebody who has the registry and nothing else.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rosml.images.image_set import Image, Payload
from rosml.matrix import names
from rosml.matrix.model import ANY_PYTHON, FAMILY_OF, PARTS, Part

PREFIX = "io.rosml."
TITLE = "org.opencontainers.image.title"
DESCRIPTION = "org.opencontainers.image.description"
VERSION = "org.opencontainers.image.version"
SOURCE = "org.opencontainers.image.source"
REVISION = "org.opencontainers.image.revision"

OCI = "org.opencontainers.image."
"""Prefix of the labels that an index has as annotations too."""

VERSIONS = ("cuda", "cudnn", "torch", "tensorflow")
"""What labels and the environment count, in the order in which the Dockerfile sets it."""

TITLES = {"torch": "PyTorch", "tensorflow": "TensorFlow", "cuda": "CUDA"}
"""How a description calls what an image carries."""


def named(
    distribution: str, component: str, ros: str, framework: str, stack: str | None, versions: Mapping[str, str]
) -> dict[str, str]:
    """The labels by which people know an image.

    Args:
        versions: of what it carries: `{"torch": "2.10.0", "cuda": "12.8.90"}`.
    """
    carried = [f"{title} {versions[key]}" for key, title in TITLES.items() if key in versions]
    return {
        TITLE: names.image_target(distribution, component, framework, stack),
        DESCRIPTION: ", ".join([f"ROS {ros} {component} ({distribution})", *carried]),
        VERSION: names.spelled_tag(names.main_tag(distribution, component, stack), versions),
        f"{PREFIX}component": component,
    }


def of_payload(
    part: Part, stack: str, python: str, versions: Mapping[str, str], frameworks: Mapping[str, Sequence[str]]
) -> dict[str, str]:
    """The labels of a payload.

    Args:
        python: `any` where the part is the same for all.
        versions: of all that the stack has. frameworks: the parts of every framework that takes this one.
    """
    pythons = "any Python" if python == ANY_PYTHON else f"Python {python}"
    return {
        TITLE: names.payload_name(part, stack, python),
        DESCRIPTION: f"part {part} of stack {stack}, for {pythons}",
        f"{PREFIX}part": part,
        f"{PREFIX}stack": stack,
        f"{PREFIX}python": python,
        **{f"{PREFIX}{name}": versions[name] for name in brought(part) if name in versions},
        f"{PREFIX}parts": ",".join(PARTS),
        f"{PREFIX}frameworks": " ".join(f"{name}={','.join(frameworks[name])}" for name in smallest_first(frameworks)),
    }


def brought(part: Part) -> tuple[str, ...]:
    """What a part brings whose version its payloads' labels name."""
    return ("cuda", "cudnn") if part == "cuda" else (FAMILY_OF[part],) if part in FAMILY_OF else ()


def smallest_first(frameworks: Mapping[str, Sequence[str]]) -> list[str]:
    """Frameworks by the number of their parts, then by name: the order of the matrix does not count."""
    return sorted(frameworks, key=lambda name: (len(frameworks[name]), name))


def frameworks(text: str) -> dict[str, tuple[str, ...]]:
    """The parts of every framework that takes a payload, as its label has them: smallest first.

    Raises:
        ValueError: the label is damaged.
    """
    pairs = (item.split("=") for item in text.split())
    return {name: tuple(parts.split(",")) for name, parts in pairs}


def title(thing: Image | Payload) -> str:
    """What the label and the annotation of that name say of an image or payload."""
    return thing.name if isinstance(thing, Payload) else thing.target
