"""A catalogue as a table for people and as JSON for machines."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from rosml import missing, terminal
from rosml.errors import RosmlError
from rosml.expand import Catalogue, Image
from rosml.inputs import Inputs
from rosml.problems import counted, listed, unknown


def facts(image: Image) -> dict[str, Any]:
    """An image's resolved facts as plain data. Tags are without the registry, sizes in MB."""
    return {
        "target": image.target,
        "distribution": image.distribution,
        "component": image.component,
        "framework": image.framework,
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


def members(catalogue: Catalogue, groups: Sequence[str] = ()) -> tuple[Image, ...]:
    """The images that are in all of some groups, those without a lock among them, in the order of the matrix. An
    architecture counts as the group of the images that exist for it.

    Raises:
        RosmlError: there is no such group (exit code 2).
    """
    known = {group for image in catalogue.images for group in (*image.groups, *image.architectures)}
    for name in groups:
        if name not in known:
            raise RosmlError(unknown("group", name, sorted(known)), f"there is {listed(sorted(known))}", exit_code=2)
    wanted = set(groups)
    return tuple(image for image in catalogue.images if wanted <= {*image.groups, *image.architectures})


def none_in(catalogue: Catalogue, groups: Sequence[str]) -> str:
    """What to say where no image is in all of some groups: so, and how to learn why."""
    return f"no image is in all of {listed(groups)}; see why: make explain TARGET={_example(catalogue, groups)}"


def _example(catalogue: Catalogue, groups: Sequence[str]) -> str:
    """A name to ask about: an image of the other groups where an architecture is what is lacking, or the name that the
    groups make up, or its pattern."""
    axes = [name for name in groups if name not in catalogue.matrix.architectures]
    if len(axes) < len(groups) and (others := members(catalogue, axes)):
        return others[0].target
    matrix = catalogue.matrix
    words = [
        [name for name in groups if name in axis]
        for axis in (matrix.distributions, matrix.components, matrix.frameworks, matrix.stacks)
    ]
    distribution, component, framework, stack = words
    readable = len(distribution) == 1 and max(map(len, words)) == 1 and (framework or (component and not stack))
    return "-".join(name for word in words for name in word) if readable else "<distribution>-<component>-<framework>"


def as_json(inputs: Inputs, images: Sequence[Image]) -> str:
    """Images with the digests of their inputs by architecture."""
    return json.dumps([{**facts(image), "inputs": inputs.digests(image)} for image in images], indent=2) + "\n"


def print_table(images: Sequence[Image]) -> None:
    """Prints images, a row each."""
    size = "GB unpacked (forecast)"
    table = terminal.table("target", "versions", "platforms", "main tag", "lock", size, right=[size])
    for image in images:
        versions = ", ".join(f"{name} {version}" for name, version in image.versions.items())
        platforms = ", ".join(image.platforms)
        state = "" if image.locked else "missing"
        table.add_row(image.target, versions, platforms, image.tags[0], state, f"{image.disk.unpacked / 1000:.1f}")
    terminal.show(table)
    out = terminal.console()
    payloads = {name for image in images for name in image.parts}
    out.print(f"{counted(len(images), 'image')}, {counted(len(payloads), 'payload')}", style="dim")
    lost = sum(bool(image.lost) for image in images)
    waiting = sum(not image.locked for image in images) - lost
    for count, remedy in ((lost, missing.RESTORE), (waiting, missing.ASK_PYTORCH)):
        if count:
            out.print(f"{count} without a lock, which cannot be built yet: {remedy}", style="yellow")
