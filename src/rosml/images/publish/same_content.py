"""Checks that the images of an index have the same content on all architectures."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from rosml.base.errors import RosmlError
from rosml.images.builds.structure_tests import LABEL

OWN = ("org.opencontainers.image.base.digest",)
"""Labels that may differ by architecture: a machine may use another base image than the one in matrix.yaml."""

CONTENT = {
    "ROS's distribution": "ros-distro",
    "ROS's generation": "ros-version",
    "CUDA": r"nvidia-cuda-runtime(-cu\d+)?",
    "cuDNN": r"nvidia-cudnn-cu\d+",
    "NCCL": r"nvidia-nccl-cu\d+",
    "numpy": "numpy",
}
"""Versions in the images that must be the same, with a pattern for the packages that have each: wheels of one release
have different names on different architectures. Debian packages may differ by a revision."""


def content(versions: Mapping[str, str], released: Iterable[str] = ()) -> dict[str, str]:
    """The versions in an image that must be the same. 2.10.0+cpu counts as 2.10.0, built for another accelerator.

    Args:
        versions: all versions found in the image.
        released: further packages that count; each may have `-cpu` or `-gpu` after its name.
    """
    patterns = {**CONTENT, **{name: f"{re.escape(name)}(-cpu|-gpu)?" for name in released}}
    return {
        name: version.split("+")[0]
        for name, pattern in patterns.items()
        for package, version in versions.items()
        if re.fullmatch(pattern, package)
    }


def require(
    target: str,
    configs: Mapping[str, Mapping[str, Any]],
    versions: Mapping[str, Mapping[str, str]],
    released: Iterable[str] = (),
) -> None:
    """Checks that the images of an index have the same configs and versions.

    Args:
        target: for the message.
        configs: the images' configs by architecture.
        versions: the versions found in the images by architecture.
        released: packages that the images are releases of.

    Raises:
        RosmlError: they differ; the message says how.
    """
    found: dict[str, dict[str, str]] = {}
    for architecture, config in configs.items():
        inner = config.get("config") or {}
        if config.get("architecture") != architecture:
            raise RosmlError(
                f"{target}: the image for {architecture} says that it is for {config.get('architecture')}",
                "rebuild it: --force",
            )
        facts = {name: str(value) for name, value in (inner.get("Labels") or {}).items() if name not in OWN}
        facts |= dict(item.split("=", 1) for item in inner.get("Env") or [] if "=" in item)
        facts |= {key: str(inner.get(key)) for key in ("Entrypoint", "Cmd", "WorkingDir", "User")}
        facts |= {
            f"{name} inside": version for name, version in content(versions.get(architecture, {}), released).items()
        }
        found[architecture] = facts
    first, *others = found
    for other in others:
        for name in sorted(found[first].keys() | found[other].keys()):
            one, two = found[first].get(name, "nothing"), found[other].get(name, "nothing")
            if one != two:
                shown = name.removeprefix(LABEL)
                raise RosmlError(
                    f"{target} is not the same on all architectures: {shown} is {one} on {first}, {two} on {other}",
                    "build both from the same inputs, or give them separate tags",
                )
