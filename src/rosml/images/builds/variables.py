"""Variables of the bake file for a build on this machine: registry, platform, base images and sync date."""

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
    date: str = "",
) -> dict[str, str]:
    """The variables to build or test an image.

    Args:
        services: of this machine.
        image_set: all that the matrix describes.
        image: the image.
        architecture: to build for.
        prefix: the registry and the path before the names of repositories.
        say: prints a line of progress.
        date: the sync date of ROS's apt repository, which the build requires; if empty, the repository is asked.

    Raises:
        RosmlError: a base image is not available; there is no such channel of the apt repository (exit code 2).
    """
    systems = image_set.matrix.operating_systems
    wanted = {image.os, image_set.matrix.default.assembler}
    wanted |= {image_set.part_by_name[name].os for name in image.parts}
    found = {"REGISTRY": prefix, "PLATFORM": image_set.matrix.architectures[architecture].platform}
    for name in sorted(wanted):
        reference = base_images.reference(services, systems, name, architecture)
        found[names.os_variable(name)] = f"docker-image://{reference}"
    published = sync_date(services, image_set, image.distribution, say, date)
    return found | ({"ROS_SYNC_DATES": json.dumps({image.distribution: published})} if published is not None else {})


def base(image: Image, variables: dict[str, str]) -> str:
    """The reference of the operating system's image that an image starts from."""
    return variables[names.os_variable(image.os)].removeprefix("docker-image://")


def sync_date(
    services: Services, image_set: ImageSet, distribution: str, say: Callable[[str], None], date: str = ""
) -> str | None:
    """The sync date of a distribution: when ROS published the apt repository of its packages. With a new date, the
    build installs the packages again.

    Args:
        services: of this machine.
        image_set: all that the matrix describes.
        distribution: its name.
        say: prints a line of progress.
        date: the sync date, if it is known; if empty, the repository is asked.

    Returns:
        The date; empty if it is unknown; None if the packages come from elsewhere.

    Raises:
        RosmlError: there is no such channel of the repository (exit code 2).
    """
    source = apt_repository.of(image_set.matrix, distribution)
    if source is None:
        return None
    if not date:
        try:
            date = sync.published(source)
            sync.remember(services.state, source, date)
        except RosmlError as error:  # the builder's cache may be enough
            if error.exit_code == 2:
                raise
            date = sync.remembered(services.state, source)
            say(f"{error.message}; using the date of last time: {date or 'unknown'}")
        say(f"ROS's apt repository {source.address}, published {date or 'at an unknown time'}")
    return date
