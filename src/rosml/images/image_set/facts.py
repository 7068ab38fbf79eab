"""An image set as a table for people and as JSON for machines."""

from __future__ import annotations

from typing import Any

from rosml.images.image_set.model import Image


def facts(image: Image) -> dict[str, Any]:
    """An image's resolved facts as plain data. Tags are without the registry, sizes in MB."""
    return {
        "target": image.target,
        "distribution": image.distribution,
        "component": image.component,
        "framework": image.framework,
        "addons": list(image.addons),
        "stack": image.stack,
        "os": image.os,
        "python": image.python,
        "ros": image.ros,
        "ros_distro": image.ros_distro,
        "platforms": list(image.platforms),
        "versions": dict(image.versions),
        "repository": image.repository,
        "tags": list(image.tags),
        "groups": list(image.groups),
        "parent": image.parent,
        "packages": image.packages.split(),
        "wheels": list(image.wheels),
        "parts": list(image.parts),
        "locks": list(image.locks),
        "locked": image.locked,
        "tests": list(image.tests),
        "disk": {"unpacked": image.disk.unpacked, "compressed": image.disk.compressed},
    }
