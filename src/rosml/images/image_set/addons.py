"""Which add-ons an image can take, and the commands that put them onto it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rosml.images.image_set.model import PARTS, Image
from rosml.images.matrix import names, rules
from rosml.images.matrix.model import ANY_PYTHON, Matrix


@dataclass(frozen=True)
class Fitting:
    """An add-on that an image can take.

    Attributes:
        addon: its name, such as `onnx`.
        called: its name for `--addons`: with the stack, if the image has none: `onnx-cpu`.
        parts: names of the parts that the image lacks, in the order of a join.
        platforms: the image's platforms for which it exists.
        restricted: whether images with it go to private registries alone.
    """

    addon: str
    called: str
    parts: tuple[str, ...]
    platforms: tuple[str, ...]
    restricted: bool

    def joins(self, image: str) -> str:
        """The command that joins it to an image in a registry."""
        return f"rosml join {image} {PARTS}:{braced(self.parts)} --tag NAME"


def braced(words: tuple[str, ...]) -> str:
    """Words in a shell's braces: `{a,b}`; one word alone."""
    return f"{{{','.join(words)}}}" if len(words) > 1 else "".join(words)


def fitting(matrix: Matrix, image: Image) -> Iterator[Fitting]:
    """The add-ons that an image can take besides its own; one without a stack takes those of every stack."""
    for stack in [image.stack] if image.stack else [*matrix.stacks]:
        for addon in matrix.addons:
            place = image.distribution, image.framework, stack
            if addon in image.addons or rules.stack_reason(matrix, *place, addon):
                continue
            there = [name for name in rules.architectures(matrix, *place, addon) if name in image.architectures]
            kinds = rules.parts(matrix, matrix.carrying(image.framework, addon), matrix.stacks[stack])
            entries = [matrix.part[kind] for kind in kinds]
            parts = [names.part_name(x.name, stack, ANY_PYTHON if x.any_python else image.python) for x in entries]
            if there:
                yield Fitting(
                    addon=addon,
                    called=addon if image.stack else f"{addon}-{stack}",
                    parts=tuple(part for part in parts if part not in image.parts),
                    platforms=tuple(matrix.architectures[name].platform for name in there),
                    restricted=any(entry.restricted for entry in entries),
                )
