"""Names that two things of an image set would share, and defaults that do not exist."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from rosml.base.problems import KeyPath, listed, unknown
from rosml.images.image_set.expand import Place, expand
from rosml.images.image_set.explain import why_not
from rosml.images.image_set.model import Part
from rosml.images.matrix import names
from rosml.images.matrix.model import Matrix


def collisions(matrix: Matrix, images: Sequence[Place], parts: Iterable[Part]) -> Iterator[tuple[KeyPath, str]]:
    """Names that two things would share, and unknown names in `default`."""
    owners: dict[str, str] = {}
    for name, owner, place in _names(matrix, images, parts):
        if owners.setdefault(name, owner) != owner:
            yield place, f"{owner} and {owners[name]} would both be called {name}; rename one"
    yield from _unusable_defaults(matrix, images)


def _names(matrix: Matrix, images: Iterable[Place], parts: Iterable[Part]) -> Iterator[tuple[str, str, KeyPath]]:
    """Every target, tag, group and key of DIGESTS, with its owner and the owner's place in the file."""
    for image in images:
        kind = image.kind
        what = " with ".join([kind.framework, *kind.addons])
        owner = f"the image of {kind.distribution}, {image.component}, {what} and {kind.stack}"
        target = image.target
        for name in (target, names.test_target(target), *image.tags):
            yield name, owner, ("distributions", kind.distribution)
    for part in parts:
        for name in (part.name, part.target):
            yield name, f"the part {part.kind} of {part.stack} and Python {part.python}", ("stacks", part.stack)
    for os in matrix.operating_systems:
        for runtime in (False, True):
            yield names.os_target(os, runtime), f"the operating system {os}", ("operating_systems", os)
    for axis in ("distributions", "components", "frameworks", "addons", "stacks"):
        for name in getattr(matrix, axis):
            yield name, f"the group {name}", (axis, name)


def _unusable_defaults(matrix: Matrix, images: Sequence[Place]) -> Iterator[tuple[KeyPath, str]]:
    carried = {(image.kind.distribution, image.kind.stack) for image in images if len(image.kind.parts) > 1}
    for name, distribution in matrix.distributions.items():
        stacks = {stack for row, stack in carried if row == name and stack}
        for default_stack in distribution.default_stacks:
            if stacks and default_stack not in stacks:
                text = f"no framework exists for {name} on stack {default_stack}; there is {listed(sorted(stacks))}"
                yield ("distributions", name, "default_stack"), text
    targets_of_set = {image.target for image in images}
    defaults = {"targets": matrix.default.targets, "group": matrix.default.group}
    targets = [
        (("default", key, index), name)
        for key, target_names in defaults.items()
        for index, name in enumerate(target_names)
    ]
    for path, name in targets:
        if name not in targets_of_set:
            image_set = expand(matrix)
            yield path, why_not(image_set, name) or unknown("image", name, image_set.by_target)
