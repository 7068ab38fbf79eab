"""Names that two things of an image set would share, and defaults that name what there is not."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rosml.base.problems import Path as Place
from rosml.base.problems import listed, unknown
from rosml.images.explain import why_not
from rosml.images.image_set import ImageSet
from rosml.matrix import names, rules
from rosml.matrix.model import ANY_PYTHON


def collisions(image_set: ImageSet) -> Iterator[tuple[Place, str]]:
    """Names that two things would share, and names in `default` that nothing has."""
    owners: dict[str, str] = {}  # of targets and tags
    yield from _shared_by_images(image_set, owners)
    yield from _shared_by_parts(image_set)
    yield from _taken(image_set, owners)
    yield from _unusable_defaults(image_set)


def _shared_by_images(image_set: ImageSet, owners: dict[str, str]) -> Iterator[tuple[Place, str]]:
    """Targets and tags that two images would share; and writes down whose they are."""
    for image in image_set.images:
        for target in (image.target, image.test_target):
            if target in owners:
                text = f"{image.target} and {owners[target]} would both be the target {target}; rename one"
                yield ("distributions", image.distribution), text
            owners.setdefault(target, image.target)
        for tag in image.tags:
            if owners.setdefault(tag, image.target) != image.target:
                text = f"{image.target} and {owners[tag]} would both have the tag {tag}; rename one"
                yield ("distributions", image.distribution), text


def _shared_by_parts(image_set: ImageSet) -> Iterator[tuple[Place, str]]:
    """Names that the parts of two stacks would share."""
    matrix = image_set.matrix
    sources: dict[str, tuple[str, str, str]] = {}
    for stack, python, framework in {(image.stack, image.python, image.framework): None for image in image_set.images}:
        for part in rules.parts(matrix, matrix.frameworks[framework], matrix.stacks[stack]) if stack else ():
            source = (part, stack or "", ANY_PYTHON if matrix.part[part].any_python else python)
            name = names.part_name(*source)
            if sources.setdefault(name, source) != source:
                yield (
                    ("stacks", source[1]),
                    f"{source[1]} and {sources[name][1]} would share the part {name}; rename one",
                )


def _taken(image_set: ImageSet, owners: Mapping[str, str]) -> Iterator[tuple[Place, str]]:
    """Groups and parts whose names are those of targets."""
    taken = owners.keys() | {part.target for part in image_set.parts}
    for axis in ("distributions", "components", "frameworks", "stacks"):
        for name in getattr(image_set.matrix, axis):
            if name in taken:
                yield (axis, name), f"the group {name} would have the name of a target; rename it"
    for part in image_set.parts:
        if part.name in owners:  # both are keys of DIGESTS
            text = f"{part.name} is the name of a part and of an image; rename one"
            yield ("stacks", part.stack), text
        if part.target in owners:
            yield ("stacks", part.stack), f"{part.target} is a part and an image; rename one"


def _unusable_defaults(image_set: ImageSet) -> Iterator[tuple[Place, str]]:
    """Default stacks and targets that there are not."""
    carried = {(image.distribution, image.stack) for image in image_set.images if len(image.parts) > 1}
    for name, distribution in image_set.matrix.distributions.items():
        if (name, distribution.default_stack) not in carried and any(row == name and stack for row, stack in carried):
            there = dict.fromkeys(stack for row, stack in carried if row == name and stack)
            text = f"no framework exists for {name} on stack {distribution.default_stack}; there is {listed(sorted(there))}"
            yield ("distributions", name, "default_stack"), text
    default = image_set.matrix.default
    targets: list[tuple[Place, str]] = [(("default", "target"), default.target)]
    targets += [(("default", "group", index), name) for index, name in enumerate(default.group)]
    for path, name in targets:
        if name not in image_set.by_target:
            yield path, why_not(image_set, name) or unknown("image", name, image_set.by_target)
