"""Names that two things of an image set would share, and defaults that do not exist."""

from __future__ import annotations

from collections.abc import Iterator

from rosml.base.problems import KeyPath, listed, unknown
from rosml.images.image_set.explain import why_not
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import names


def collisions(image_set: ImageSet) -> Iterator[tuple[KeyPath, str]]:
    """Names that two things would share, and unknown names in `default`."""
    owners: dict[str, str] = {}
    for name, owner, place in _names(image_set):
        if owners.setdefault(name, owner) != owner:
            yield place, f"{owner} and {owners[name]} would both be called {name}; rename one"
    yield from _unusable_defaults(image_set)


def _names(image_set: ImageSet) -> Iterator[tuple[str, str, KeyPath]]:
    """Every target, tag, group and key of DIGESTS, with its owner and the owner's place in the file."""
    for image in image_set.images:
        what = " with ".join([image.framework, *image.addons])
        owner = f"the image of {image.distribution}, {image.component}, {what} and {image.stack}"
        for name in (image.target, image.test_target, *image.tags):
            yield name, owner, ("distributions", image.distribution)
    for part in image_set.parts:
        for name in (part.name, part.target):
            yield name, f"the part {part.kind} of {part.stack} and Python {part.python}", ("stacks", part.stack)
    for os in image_set.matrix.operating_systems:
        for runtime in (False, True):
            yield names.os_target(os, runtime), f"the operating system {os}", ("operating_systems", os)
    for axis in ("distributions", "components", "frameworks", "addons", "stacks"):
        for name in getattr(image_set.matrix, axis):
            yield name, f"the group {name}", (axis, name)


def _unusable_defaults(image_set: ImageSet) -> Iterator[tuple[KeyPath, str]]:
    """Default stacks and targets that do not exist."""
    carried = {(image.distribution, image.stack) for image in image_set.images if len(image.parts) > 1}
    for name, distribution in image_set.matrix.distributions.items():
        there = {stack for row, stack in carried if row == name and stack}
        for default_stack in distribution.default_stacks:
            if there and default_stack not in there:
                text = f"no framework exists for {name} on stack {default_stack}; there is {listed(sorted(there))}"
                yield ("distributions", name, "default_stack"), text
    default = image_set.matrix.default
    named = {"targets": default.targets, "group": default.group}
    targets = [(("default", key, index), name) for key, found in named.items() for index, name in enumerate(found)]
    for path, name in targets:
        if name not in image_set.by_target:
            yield path, why_not(image_set, name) or unknown("image", name, image_set.by_target)
