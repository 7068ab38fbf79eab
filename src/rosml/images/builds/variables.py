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


def variables(services: Services, image_set: ImageSet, image: Image, architecture: str, prefix: str) -> dict[str, str]:
    """The registry, the platform and the base images. `prefix` has the registry, and the path before all repositories."""
    matrix = image_set.matrix
    systems = {image.os, matrix.default.assembler, *(image_set.part_by_name[name].os for name in image.parts)}
    references = {
        names.os_variable(name): base_images.reference(services, matrix.operating_systems, name, architecture)
        for name in sorted(systems)
    }
    return {
        "REGISTRY": prefix,
        "DOCKER_HUB": f"{base_images.docker_hub(services, image.os)}/",
        "PLATFORM": matrix.architectures[architecture].platform,
        **{variable: f"docker-image://{reference}" for variable, reference in references.items()},
    }


def base(image: Image, variables: dict[str, str]) -> str:
    """The reference of the operating system's image that an image starts from."""
    return variables[names.os_variable(image.os)].removeprefix("docker-image://")


def sync_dates(
    services: Services, image_set: ImageSet, distribution: str, say: Callable[[str], None], date: str = ""
) -> dict[str, str]:
    """The variable with `sync_date`; empty if the distribution's packages come from elsewhere."""
    published = sync_date(services, image_set, distribution, say, date)
    return {} if published is None else {"ROS_SYNC_DATES": json.dumps({distribution: published})}


def sync_date(
    services: Services, image_set: ImageSet, distribution: str, say: Callable[[str], None], date: str = ""
) -> str | None:
    """When ROS published a distribution's apt repository; empty if that is unknown, and None if the packages come from elsewhere."""
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
