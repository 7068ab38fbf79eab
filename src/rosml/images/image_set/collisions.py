"""Names that two things of an image set would share, and defaults that do not exist."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from rosml.base.problems import KeyPath, listed, unknown
from rosml.images.image_set.expand import Place, expand
from rosml.images.image_set.explain import why_not
from rosml.images.image_set.model import Environment, Part
from rosml.images.matrix import names
from rosml.images.matrix.model import Matrix


def collisions(matrix: Matrix, images: Sequence[Place], parts: Iterable[Part]) -> Iterator[tuple[KeyPath, str]]:
    """Names that two things would share, and unknown names in `default`."""
    owners: dict[str, str] = {}
    for name, owner, place in _names(matrix, images, parts):
        if owners.setdefault(name, owner) != owner:
            yield place, f"{owner} and {owners[name]} would both be called {name}; rename one"
    yield from _unusable_environments(matrix, images)
    yield from _unusable_defaults(matrix, images)


def _names(matrix: Matrix, images: Iterable[Place], parts: Iterable[Part]) -> Iterator[tuple[str, str, KeyPath]]:
    """Every target, tag, group and key of DIGESTS, with its owner and the owner's place in the file."""
    for image in images:
        kind = image.kind
        what = " with ".join(filter(None, [kind.framework, *kind.addons, kind.environment]))
        owner = f"the image of {kind.distribution}, {image.component}, {what} and {kind.stack}"
        target = image.target
        for name in (target, names.test_target(target), *image.tags):
            yield name, owner, ("distributions", kind.distribution)
    for part in parts:
        if isinstance(part, Environment):
            owner, place = (
                f"the environment {part.environment} of Python {part.python}",
                ("environments", part.environment),
            )
        else:
            owner, place = f"the part {part.kind} of {part.stack} and Python {part.python}", ("stacks", part.stack)
        for name in (part.name, part.target):
            yield name, owner, place
    for os in matrix.operating_systems:
        for runtime in (False, True):
            yield names.os_target(os, runtime), f"the operating system {os}", ("operating_systems", os)
    for axis in names.AXES:
        for name in getattr(matrix, axis):
            yield name, f"the group {name}", (axis, name)


def _unusable_environments(matrix: Matrix, images: Sequence[Place]) -> Iterator[tuple[KeyPath, str]]:
    """Each environment goes onto images that exist, have a framework and tags, and one of its architectures."""
    by_target = {image.target: image for image in images}
    for name, entry in matrix.environments.items():
        for index, target in enumerate(entry.images):
            path: KeyPath = ("environments", name, "images", index)
            if target not in by_target:
                yield path, _no_image(matrix, target)
                continue
            place = by_target[target]
            if not place.kind.stack or not place.tags or place.kind.environment:
                why = "no tags" if place.kind.stack and not place.tags else "no framework"
                why = f"the environment {place.kind.environment} already" if place.kind.environment else why
                yield path, f"{target} has {why}; name an image with a framework and tags"
            elif not {*place.kind.architectures} & {*entry.architectures}:
                text = f"{target} is for {listed(place.kind.architectures)}, and the environment has locks for"
                yield path, f"{text} {listed(entry.architectures)}; name another image"


def _no_image(matrix: Matrix, target: str) -> str:
    """Why the matrix has no image of this name."""
    image_set = expand(matrix)
    return why_not(image_set, target) or unknown("image", target, image_set.by_target)


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
            yield path, _no_image(matrix, name)
