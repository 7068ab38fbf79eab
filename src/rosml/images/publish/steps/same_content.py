"""One index, one content: what must be alike on all architectures of a tag."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from rosml.base.errors import RosmlError
from rosml.images.builds.structure_tests import LABEL

OWN = ("org.opencontainers.image.base.digest",)
"""Labels that an architecture may have to itself: a machine may take another base image than matrix.yaml names."""

CONTENT = {
    "ROS's distribution": "ros-distro",
    "ROS's generation": "ros-version",
    "CUDA": r"nvidia-cuda-runtime(-cu\d+)?",
    "cuDNN": r"nvidia-cudnn-cu\d+",
    "NCCL": r"nvidia-nccl-cu\d+",
    "numpy": "numpy",
}
"""What of the versions that were found inside must be the same, by the packages that have it: wheels of one release have
other names on other architectures. Debian may be a revision apart."""


def content(versions: Mapping[str, str], released: Iterable[str] = ()) -> dict[str, str]:
    """What counts of the versions found inside; 2.10.0+cpu is 2.10.0, built for another accelerator.

    Args:
        released: what else counts; the wheel for the CPU may be called so.
    """
    patterns = {**CONTENT, **{name: f"{re.escape(name)}(-cpu)?" for name in released}}
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
    """Checks that the images of an index promise and hold the same.

    Args:
        target: for the message.
        configs: the images' configs by architecture.
        versions: what was found inside them by architecture.
        released: what they are releases of.

    Raises:
        RosmlError: they differ; the message says in what.
    """
    found: dict[str, dict[str, str]] = {}
    for architecture, config in configs.items():
        inner = config.get("config") or {}
        if config.get("architecture") != architecture:
            raise RosmlError(
                f"{target}: the image for {architecture} says that it is for {config.get('architecture')}",
                "build it anew: --force",
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
                    "an index holds one content: build both from the same inputs, or give them tags of their own",
                )
