"""Variables of the bake file for a build on this machine: the registry, the platform, base images, and of when packages are."""

from __future__ import annotations

import json
from collections.abc import Callable

from rosml.base.errors import RosmlError
from rosml.images.builds import base_images, sync
from rosml.images.image_set import apt_repository
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import names
from rosml.machine.services import Services


def variables(
    services: Services,
    image_set: ImageSet,
    image: Image,
    architecture: str,
    prefix: str,
    say: Callable[[str], None],
    moment: str = "",
) -> dict[str, str]:
    """What a build or a test of an image is told.

    Args:
        services: this machine's.
        image_set: all that the matrix describes.
        image, architecture: what is built, and for what.
        prefix: of references: the registry and the path before the names of repositories.
        say: told what is going on, a line at a time.
        moment: of when ROS's apt repository is taken to be: the build fails where it is of another time by then. It is
            asked if nothing is said.

    Raises:
        RosmlError: no base image can be had; there is no such channel of the apt repository (exit code 2).
    """
    systems = image_set.matrix.operating_systems
    wanted = {image.os, image_set.matrix.default.assembler}
    wanted |= {image_set.part_by_name[name].os for name in image.parts}
    found = {"REGISTRY": prefix, "PLATFORM": image_set.matrix.architectures[architecture].platform}
    for name in sorted(wanted):
        reference = base_images.reference(services, systems, name, architecture)
        found[names.os_variable(name)] = f"docker-image://{reference}"
    date = sync_date(services, image_set, image.distribution, say, moment)
    return found | ({"ROS_SYNC_DATES": json.dumps({image.distribution: date})} if date is not None else {})


def base(image: Image, variables: dict[str, str]) -> str:
    """The reference of the operating system's image that an image starts from."""
    return variables[names.os_variable(image.os)].removeprefix("docker-image://")


def sync_date(
    services: Services, image_set: ImageSet, distribution: str, say: Callable[[str], None], moment: str = ""
) -> str | None:
    """Of when ROS's apt repository is, that a distribution's packages come from: a new state of it is installed anew.

    Returns:
        The moment; empty if nobody knows it; None if its packages come from elsewhere.

    Raises:
        RosmlError: there is no such channel of the repository (exit code 2).
    """
    source = apt_repository.of(image_set.matrix, distribution)
    if source is None:
        return None
    if not moment:
        try:
            moment = sync.published(source)
            sync.remember(services.state, source, moment)
        except RosmlError as error:  # what the builder has of it may be enough
            if error.exit_code == 2:
                raise
            moment = sync.remembered(services.state, source)
            say(f"{error.message}; taken for as it was last time: {moment or 'never asked'}")
        say(f"ROS's apt repository {source.address}, published {moment or 'nobody knows when'}")
    return moment
