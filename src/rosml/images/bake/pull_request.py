"""Chooses the images that a pull request builds: few, which together cover the changes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from rosml.base.problems import counted, some
from rosml.images.bake.diff import Difference
from rosml.images.image_set.model import Image, ImageSet


@dataclass(frozen=True)
class Choice:
    """Targets that a change reaches, and how many further ones have no lock, or are for other architectures."""

    built: tuple[str, ...]
    left_out: tuple[str, ...]
    unlocked: int = 0
    elsewhere: int = 0

    def __str__(self) -> str:
        number = len(self.built) + len(self.left_out)
        text = f"{counted(number, 'image')} changed" + (f"; built: {', '.join(self.built)}" if self.built else "")
        if self.left_out:
            text += f"; left out, {len(self.left_out)} of {number}: {some(list(self.left_out))}"
        if self.unlocked:
            text += f"; {self.unlocked} more without a lock"
        if self.elsewhere:
            text += f"; {self.elsewhere} more for other architectures"
        return text


def choose(image_set: ImageSet, difference: Difference, architectures: Sequence[str], at_most: int) -> Choice:
    """Chooses images that differ from an earlier version.

    It takes one image after the other: that which covers most new things; first changes, then distributions, components,
    frameworks and stacks. If several cover the same, it takes the smallest. `architectures` can be built here.
    """
    reached = [image for image in image_set.images if image.target in {*difference.added, *difference.changed}]
    locked = [image for image in reached if image.locked]
    left_out = [image for image in locked if set(architectures) & set(image.architectures)]
    unlocked, elsewhere = len(reached) - len(locked), len(locked) - len(left_out)
    built: list[Image] = []
    covered: set[object] = set()
    while left_out and len(built) < at_most:
        best = min(
            left_out,
            key=lambda image: (*(-len(new - covered) for new in _brings(image, difference)), image.disk.unpacked),
        )
        built.append(best)
        left_out.remove(best)
        covered = covered.union(*_brings(best, difference))
    return Choice(
        tuple(image.target for image in built), tuple(image.target for image in left_out), unlocked, elsewhere
    )


def _brings(image: Image, difference: Difference) -> tuple[set[object], set[object]]:
    """The changes that reach an image, and its groups. Changed labels count only if nothing else changed: they repeat other inputs."""
    changes = difference.changed.get(image.target, ())
    plain = [change for change in changes if not change.input.startswith("label ")]
    return set(plain or changes), set(image.groups)
