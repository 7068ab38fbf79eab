"""ROS for a base image without it: chooses a distribution, and makes a base image of it."""

from __future__ import annotations

import hashlib
import shlex
from collections.abc import Callable, Mapping
from dataclasses import replace

from rosml import MATRIX
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.containerize.base_image.base import Base
from rosml.containerize.build import bake_file
from rosml.containerize.build.bake_file import BASE
from rosml.containerize.inputs import Values
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
    """Adds the ROS to install to a base image, if it has none. Chooses from rosml's own matrix, if no image set is passed."""
    _require_path(base)
    if base.environment.get("ROS_DISTRO") or values.disable_ros_installation:
        return base
    image_set = image_set or load(MATRIX)
    distributions = {row.ros_distro or name for name, row in image_set.matrix.distributions.items()}
    frameworks = {item.name for image in image_set.images for item in image.brought}
    scripts = adopted.scripts(base.entrypoint, base.environment) if values.base_entrypoint else ()
    sought = adopted.Query(tuple(sorted(distributions)), tuple(sorted(frameworks)), scripts)
    facts = adopted.look(services, base.reference, platforms[0], sought)
    if facts.ros:
        if values.ros_distro:
            return base
        names = [name for name in facts.ros if name != system.OTHER]
        text = f"{base.name} has {' and '.join(names) or 'another ROS'} in /opt/ros, and does not say which ROS it is"
        raise RosmlError(text, f"add --ros-distro {(names or ['NAME'])[0]}", exit_code=2)
    architectures = [platform.split("/")[1] for platform in platforms]
    image = system.choose(image_set, facts, base.name, values.ros_distro, values.ros_component, architectures)
    lasting = image_set.matrix.distributions[image.distribution].lts
    kind = "the newest long-term release" if lasting else "the first choice"
    why = "" if values.ros_distro else f", {kind} for {facts.title or facts.id}; --ros-distro names another"
    say(f"it has no ROS: {image.distribution}-{image.component} is installed on it{why}")
    entrypoint = _entrypoint(base, facts.passes_on, values, say)
    sync = variables.sync_date(services, image_set, image.distribution, say)
    own_base = base_images.reference(services, image_set.matrix.operating_systems, image.os) if image.wheels else ""
    ros = Adopted(
        base.reference,
        image_set,
        image,
        base.environment,
        base.user,
        entrypoint,
        base.shell,
        base.labels,
        facts.carries,
        sync or "",
        own_base,
    )
    added = {"ROS_DISTRO": image.ros_distro, "ROS_VERSION": str(image.ros)}
    return replace(base, environment={**base.environment, **added}, adopted=ros)


def _entrypoint(base: Base, passes_on: bool, values: Values, say: Callable[[str], None]) -> tuple[str, ...]:
    """The words of a base image's entrypoint that run before each command."""
    entrypoint = adopted.called(base.entrypoint) if passes_on else ()
    if base.entrypoint:
        words = " ".join(shlex.join(entrypoint or base.entrypoint).split())  # its text may have several lines
        why = 'it is no script that ends in exec "$@"' if values.base_entrypoint else "as --no-base-entrypoint says"
        say(f"its entrypoint {'runs before each command' if entrypoint else f'is left out, {why}'}: {words}")
    return entrypoint


_FOLDERS = (("/usr/bin", "/bin"), ("/usr/sbin", "/sbin"))
"""Folders of which PATH needs one each: dpkg looks for its programs there."""


def _require_path(base: Base) -> None:
    path = base.environment.get("PATH")
    folders = (path or "").split(":")
    lacking = [either[0] for either in _FOLDERS if not {*either} & {*folders}]
    if path is not None and lacking:
        problem = f"{base.name}: its PATH lacks {' and '.join(lacking)}, so dpkg installs nothing on it: {path[:200]!r}"
        remedy = f"name an image of your own on it, with ENV PATH=$PATH:{':'.join(lacking)}"
        raise RosmlError(problem, remedy, exit_code=2)


def make(
    base: Base,
    services: Services,
    environment: Mapping[str, str],
    platforms: tuple[str, ...],
    tag: str,
    output: str,
) -> str:
    """Makes a base image with ROS of one that `with_ros` returned, if the builder has not done so yet. Returns its digest.

    Calls for the same base image take turns, so that it happens once.

    Args:
        tag: its full name; empty if it gets none.
        output: in buildx's words.
    """
    assert base.adopted
    name = f"image-{base.adopted.image.target}-on-{base.digest.rpartition(':')[2][:16]}"
    state = services.state / "adopted" / name
    state.mkdir(parents=True, exist_ok=True)
    steps = bake_file.steps(services, environment, platforms)
    text = bake_file.render_base(base, services, steps, tag, output, adopted.empty(state))
    file = state / f"{hashlib.sha256(text.encode()).hexdigest()[:16]}.json"
    files.write(file, text)
    _progress, metadata = buildx.run(services, buildx.Bake(BASE, name, file, shares=name))
    return metadata.get("containerimage.digest", "")
