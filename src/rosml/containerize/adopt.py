"""ROS for a base image without it: chooses a distribution, and makes a base image of it."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping
from dataclasses import replace

from rosml import MATRIX
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.containerize import app_bake_file
from rosml.containerize.app_base import Base
from rosml.containerize.app_inputs import Values
from rosml.containerize.stage_cache import BASE
from rosml.images.builds import adopted, base_images, variables
from rosml.images.builds.adopted import Adopted
from rosml.images.image_set import system
from rosml.images.image_set.load import load
from rosml.images.image_set.model import ImageSet
from rosml.machine import buildx
from rosml.machine.services import Services


def with_ros(
    base: Base,
    services: Services,
    values: Values,
    platforms: tuple[str, ...],
    say: Callable[[str], None],
    image_set: ImageSet | None = None,
) -> Base:
    """Adds the ROS to install to a base image, if it has none.

    Args:
        values: the inputs.
        platforms: the app's platforms.
        image_set: the images to choose from; by default, those of rosml's own matrix.

    Raises:
        RosmlError: no ROS can be installed on it, or not the named one (exit code 2).
    """
    if base.environment.get("ROS_DISTRO") or values.disable_ros_installation:
        return base
    image_set = image_set or load(MATRIX)
    known = {facts.ros_distro or name for name, facts in image_set.matrix.distributions.items()}
    frameworks = {item.name for image in image_set.images for item in image.brought}
    found = adopted.look(services, base.reference, platforms[0], known, frameworks)
    if found.ros:
        if values.ros_distro:
            return base
        named = [name for name in found.ros if name != system.OTHER]
        text = f"{base.name} has {' and '.join(named) or 'another ROS'} in /opt/ros, and does not say which ROS it is"
        raise RosmlError(text, f"add --ros-distro {(named or ['NAME'])[0]}", exit_code=2)
    architectures = [platform.split("/")[1] for platform in platforms]
    wanted = values.ros_distro
    image = system.choose(image_set, found, base.name, wanted, values.ros_component, architectures)
    lasting = image_set.matrix.distributions[image.distribution].lts
    kind = "the newest long-term release" if lasting else "the first choice"
    why = "" if wanted else f", {kind} for {found.title or found.id}; --ros-distro names another"
    say(f"it has no ROS: {image.distribution}-{image.component} is installed on it{why}")
    if base.entrypoint:
        words = adopted.called(base.entrypoint)
        found_words = " ".join(
            shlex.join(words or base.entrypoint).split()
        )  # one line, also if the image's own text has several
        said = "runs before each command" if words else "takes no command, and is left out"
        say(f"its entrypoint {said}: {found_words}")
    sync = variables.sync_date(services, image_set, image.distribution, say)
    own = base_images.reference(services, image_set.matrix.operating_systems, image.os) if image.wheels else ""
    onto = Adopted(
        base.reference,
        image_set,
        image,
        base.environment,
        base.user,
        base.entrypoint,
        base.shell,
        base.labels,
        found.carries,
        sync or "",
        own,
    )
    ours = {"ROS_DISTRO": image.ros_distro, "ROS_VERSION": str(image.ros)}
    return replace(base, environment={**base.environment, **ours}, adopted=onto)


def make(
    base: Base,
    services: Services,
    environment: Mapping[str, str],
    platforms: tuple[str, ...],
    tag: str,
    output: str,
) -> str:
    """Makes a base image with ROS of one without it.

    Args:
        base: the result of `with_ros`.
        environment: the variables of the process.
        platforms: its platforms.
        tag: its full name.
        output: the builder's output, in buildx's words.

    Returns:
        Its digest.

    Raises:
        RosmlError: a step failed.
    """
    assert base.adopted
    state = services.state / "adopted"
    state.mkdir(parents=True, exist_ok=True)
    file = state / "bake.json"
    with turn(state / "lock", lambda: None):
        files.write(
            file, app_bake_file.render_base(base, services, environment, platforms, tag, output, adopted.empty(state))
        )
        call = buildx.Bake(BASE, f"image-{base.adopted.image.target}-on", file)
        _progress, metadata = buildx.run(services, call)
    return metadata.get("containerimage.digest", "")
