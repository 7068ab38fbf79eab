"""Selections of images: by name, pattern, group and architecture."""

from __future__ import annotations

import fnmatch
import re
from collections.abc import Iterable, Sequence

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix.names import our_word


def select(image_set: ImageSet, only: Sequence[str]) -> tuple[Image, ...]:
    """The images that patterns of targets or tags, or groups, name; all images without any of these."""
    if not only:
        return image_set.images
    targets: set[str] = set()
    for pattern in only:
        matches = fnmatch.filter(image_set.by_target, pattern)
        if not matches and ":" in pattern:
            matches = [image.target for image in image_set.images if fnmatch.filter(image.tags, pattern)]
        if not matches and pattern in image_set.groups:
            matches = [name for name in image_set.groups[pattern] if name in image_set.by_target]
        if not matches:
            raise RosmlError(unknown("image", pattern, image_set.by_target), "see all with: rosml list", exit_code=2)
        targets.update(matches)
    return tuple(image for image in image_set.images if image.target in targets)


def require_architectures(image_set: ImageSet, names: Iterable[str]) -> None:
    architectures = image_set.matrix.architectures
    for name in names:
        if name not in architectures:
            raise RosmlError(
                unknown("architecture", name, architectures), f"there is {', '.join(architectures)}", exit_code=2
            )


def groups_of(image_set: ImageSet) -> list[str]:
    """All groups that `members` knows, including architectures and groups of images without a lock."""
    return sorted({group for image in image_set.images for group in (*image.groups, *image.architectures)})


def members(image_set: ImageSet, groups: Sequence[str] = ()) -> tuple[Image, ...]:
    """The images that are in all given groups, in the order of the matrix, including those without a lock. An architecture is the group
    of its images."""
    groups_by_name = groups_of(image_set)
    for name in groups:
        if name not in groups_by_name:
            raise _no_group(image_set, name, groups, groups_by_name)
    names_asked = set(groups)
    return tuple(image for image in image_set.images if names_asked <= {*image.groups, *image.architectures})


def _no_group(image_set: ImageSet, name: str, groups: Sequence[str], group_names: Sequence[str]) -> RosmlError:
    """The error about a word that is no group: what people may have meant by it, or all groups."""
    if image := image_set.by_tag(name):
        return RosmlError(f"{name} is an image, and no group", f"rosml explain {image.target}", exit_code=2)
    parts = [our_word(image_set.matrix, word) for word in re.split(r"[\s,*-]+", name.lower()) if word]
    if parts and all(part in group_names for part in parts):
        words = [word for group in groups for word in (parts if group == name else [group])]
        return RosmlError(f"no group named {name!r}", f"rosml list {' '.join(words)}", exit_code=2)
    return RosmlError(unknown("group", name, group_names), f"there is {listed(group_names)}", exit_code=2)


def none_in(image_set: ImageSet, groups: Sequence[str]) -> str:
    """The message if no image is in all given groups."""
    groups_by_kind = {
        kind: [group for group in groups if group in names]
        for kind, names in (
            ("distribution", image_set.matrix.distributions),
            ("component", image_set.matrix.components),
            ("framework", image_set.matrix.frameworks),
        )
    }
    text = f"no image is in all of {listed(groups)}"
    if len(groups_by_kind["framework"]) > 1:
        stack = next((stack for stack, facts in image_set.matrix.stacks.items() if facts.cuda), "")
        return f"{text}: {listed(groups_by_kind['framework'])} are different images; a stack such as {stack} says which CUDA is beside"
    row = next(iter(groups_by_kind["distribution"]), "<distribution>")
    rest = [*groups_by_kind["component"][:1], *groups_by_kind["framework"]] or ["<component>", "<framework>"]
    example = "-".join([row, *rest])
    return f"{text}; see why: rosml explain {example}"


def architecture_of(image_set: ImageSet, platform: str) -> str:
    """The architecture of a platform such as `linux/arm64`; `arm64` and `aarch64` mean that, too."""
    by_platform = {facts.platform: name for name, facts in image_set.matrix.architectures.items()}
    name = our_word(image_set.matrix, platform.lower().removeprefix("linux/").removesuffix("/v8"))
    if name not in image_set.matrix.architectures:
        raise RosmlError(
            unknown("platform", platform, by_platform), f"take {listed(list(by_platform), 'or')}", exit_code=2
        )
    return name
