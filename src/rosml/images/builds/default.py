"""Which image is built if none is named."""

from __future__ import annotations

from collections.abc import Callable

from rosml.base.errors import RosmlError
from rosml.images.builds import base_images, package_state
from rosml.images.builds.maker import require_buildable
from rosml.images.image_set.model import Image, ImageSet
from rosml.machine.services import Services


def default(services: Services, image_set: ImageSet, architecture: str, say: Callable[[str], None]) -> Image:
    """The first of the matrix's default images that this machine can build. If it can build none, the last one."""
    why = ""
    *preferred, last = (image_set.by_target[name] for name in image_set.matrix.default.targets)
    for image in preferred:
        if not (reason := _hindrance(services, image_set, image, architecture)):
            say(f"image: {image.target}{why}")
            return image
        why = why or f", since {image.target} cannot be built here: {reason}"
    say(f"image: {last.target}{why}")
    return last


def _hindrance(services: Services, image_set: ImageSet, image: Image, architecture: str) -> str:
    """Why an image cannot be built on this machine; empty if it can."""
    if missing := base_images.missing(services, image_set.matrix.operating_systems, image.os):
        return missing
    try:
        require_buildable(image, architecture)
    except RosmlError as error:
        return error.message
    try:
        package_state.state(services, image_set.matrix, image.distribution)
    except RosmlError as error:
        if error.exit_code == 2:
            raise
        return error.message
    return ""
