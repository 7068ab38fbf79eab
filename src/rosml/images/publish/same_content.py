"""Checks that the images of an index have the same content on all architectures."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from rosml.base.errors import RosmlError
from rosml.images.image_set.labels import PREFIX

BY_ARCHITECTURE = ("org.opencontainers.image.base.digest",)
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
    """The versions in an image that must be the same. 2.10.0+cpu counts as 2.10.0, built for another accelerator."""
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
    """Checks that the images of an index have the same configs and versions; both are by architecture."""
    facts = {
        architecture: _facts(target, architecture, config, content(versions.get(architecture, {}), released))
        for architecture, config in configs.items()
    }
    first, *others = facts
    for other in others:
        for name in sorted(facts[first].keys() | facts[other].keys()):
            value, other_value = facts[first].get(name, "nothing"), facts[other].get(name, "nothing")
            if value != other_value:
                shown = name.removeprefix(PREFIX)
                raise RosmlError(
                    f"{target} is not the same on all architectures: {shown} is {value} on {first}, {other_value} on {other}",
                    "build both from the same inputs, or give them separate tags",
                )


def _facts(target: str, architecture: str, config: Mapping[str, Any], versions: Mapping[str, str]) -> dict[str, str]:
    """What has to be the same on all architectures."""
    if config.get("architecture") != architecture:
        text = f"{target}: the image for {architecture} says that it is for {config.get('architecture')}"
        raise RosmlError(text, "rebuild it: --force")
    settings = config.get("config") or {}
    facts = {name: str(value) for name, value in (settings.get("Labels") or {}).items() if name not in BY_ARCHITECTURE}
    facts |= dict(item.split("=", 1) for item in settings.get("Env") or [] if "=" in item)
    facts |= {key: str(settings.get(key)) for key in ("Entrypoint", "Cmd", "WorkingDir", "User")}
    return facts | {f"{name} inside": version for name, version in versions.items()}
