"""Which add-ons an image can take, with the commands that put them onto it; and why it cannot have others, with what to take instead.

`rosml explain` says it, and so do the errors of commands that add one.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, some, unknown
from rosml.images.image_set.model import PARTS, Image, ImageSet
from rosml.images.matrix import combinations, names
from rosml.images.matrix.model import ANY_PYTHON, Matrix
from rosml.images.matrix.tags import main_tag


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
        """The command that joins it to an image in a registry, which has the image's parts as well."""
        return f"rosml join REGISTRY/{image} REGISTRY/{PARTS}:{braced(self.parts)} --tag REGISTRY/NAME:TAG"


def braced(words: Sequence[str]) -> str:
    """Words in a shell's braces: `{a,b}`; one word alone."""
    return f"{{{','.join(words)}}}" if len(words) > 1 else "".join(words)


def fitting(matrix: Matrix, image: Image) -> Iterator[Fitting]:
    """The add-ons that an image can take besides its own; one without a stack takes those of every stack."""
    for stack in [image.stack] if image.stack else [*matrix.stacks]:
        for addon in matrix.addons:
            place = image.distribution, image.framework, stack
            if addon in image.addons or combinations.stack_reason(matrix, *place, addon):
                continue
            architectures = [
                name for name in combinations.architectures(matrix, *place, addon) if name in image.architectures
            ]
            kinds = combinations.parts(matrix, matrix.carrying(image.framework, addon), matrix.stacks[stack])
            entries = [matrix.part[kind] for kind in kinds]
            parts = [names.part_name(x.name, stack, ANY_PYTHON if x.any_python else image.python) for x in entries]
            if architectures:
                yield Fitting(
                    addon=addon,
                    called=addon if image.stack else f"{addon}-{stack}",
                    parts=tuple(part for part in parts if part not in image.parts),
                    platforms=tuple(matrix.architectures[name].platform for name in architectures),
                    restricted=any(entry.restricted for entry in entries),
                )


@dataclass(frozen=True)
class OnStack:
    """What an add-on is on a stack: the releases that it brings, and the Pythons and platforms that it is for."""

    stack: str
    brings: tuple[str, ...]
    pythons: tuple[str, ...]
    platforms: tuple[str, ...]


def on_stacks(image_set: ImageSet, addon: str) -> Iterator[OnStack]:
    """The stacks on which an add-on exists. A part for any Python is for `any`."""
    matrix = image_set.matrix
    main = matrix.part[matrix.addons[addon].parts[-1]]
    for stack, facts in matrix.stacks.items():
        if parts := [part for part in image_set.parts if (part.kind, part.stack) == (main.name, stack)]:
            brought = (f"{item.title} {item.version}" for item in combinations.brought(matrix, [main.name], facts))
            pythons = sorted({part.python for part in parts}, key=lambda text: [*map(int, re.findall("[0-9]+", text))])
            platforms = dict.fromkeys(platform for part in parts for platform in part.platforms)
            yield OnStack(stack, tuple(brought) or (main.title or addon,), tuple(pythons), tuple(platforms))


SHOWN = 3
"""How many images a remedy names."""


@dataclass(frozen=True)
class Onto:
    """An image that is to get add-ons, by the name that people wrote and its place on the axes. Without a stack, that is empty."""

    name: str
    distribution: str
    component: str
    framework: str
    stack: str

    def exists_in(self, matrix: Matrix) -> bool:
        """Whether a matrix has all that it is made of."""
        exists = self.distribution in matrix.distributions and self.framework in matrix.frameworks
        return exists and self.component in matrix.components and (not self.stack or self.stack in matrix.stacks)


@dataclass(frozen=True)
class Wanted:
    """What a name of `--addons` means: an add-on, and the stack at its end. Each is empty if the name has none."""

    addon: str
    stack: str


def read(matrix: Matrix, name: str) -> Wanted:
    """Reads a name such as `onnx` or `onnx-cpu`. What follows an add-on's name is a stack, also if the matrix has none of that name."""
    for addon in sorted(matrix.addons, key=len, reverse=True):
        if name == addon or name.startswith(f"{addon}-"):
            return Wanted(addon, name.removeprefix(addon).removeprefix("-"))
    return Wanted("", "")


def refused(matrix: Matrix, onto: Onto, name: str) -> RosmlError | None:
    """Why an image cannot have an add-on, with what to do instead; None if it can, or if the matrix does not know the image."""
    addon = read(matrix, name)
    if not addon.addon:
        text, _, remedy = unknown("add-on", name, matrix.addons).partition("; ")
        if (ours := names.our_word(matrix, name)) in matrix.addons:
            remedy = f"it is called {ours}"
        return RosmlError(text, remedy or f"there is {listed([*matrix.addons])}", exit_code=2)
    if not onto.exists_in(matrix):
        return None
    stack = addon.stack or onto.stack
    text = ""
    if not stack:
        text = f"{onto.name} has no stack, so the add-on needs one"
    elif onto.stack and stack != onto.stack:
        text = f"{onto.name} is of stack {onto.stack}, and takes no add-on of {stack}"
    elif stack not in matrix.stacks:
        text = unknown("stack", stack, matrix.stacks).partition("; ")[0]
    elif reason := combinations.stack_reason(matrix, onto.distribution, onto.framework, stack, addon.addon):
        text = f"{onto.name} cannot have the add-on {addon.addon} of stack {stack}: {reason}"
    return RosmlError(text, instead(matrix, onto, addon.addon), exit_code=2) if text else None


def instead(matrix: Matrix, onto: Onto, addon: str) -> str:
    """What to take to have an add-on: on other stacks, without the framework, or of other distributions."""
    stacks = stacks_for(matrix, onto.distribution, onto.framework, addon)
    if onto.stack in stacks:
        return f"name it without a stack: --addons {addon}"
    if stacks and matrix.frameworks[onto.framework].parts:
        images = [_tag(matrix, onto, onto.framework, stack) for stack in stacks[:SHOWN]]
        return f"take {listed(images, last='or')}, with --addons {addon}"
    if stacks:
        called = f"--addons {listed([f'{addon}-{stack}' for stack in stacks[:SHOWN]], last='or')}"
        other = f"take {_tag(matrix, onto, onto.framework, '')}, with {called}"
        return other if onto.stack else f"name a stack that has it: {called}"
    bare = combinations.plain(matrix)
    if stacks := stacks_for(matrix, onto.distribution, bare, addon):
        return (
            f"it goes without {onto.framework}: take {_tag(matrix, onto, bare, '')}, with --addons {addon}-{stacks[0]}"
        )
    others = [name for name in matrix.distributions if stacks_for(matrix, name, bare, addon)]
    return f"no image of {onto.distribution} can have {addon}; those of {some(others)} can"


def stacks_for(matrix: Matrix, distribution: str, framework: str, addon: str) -> list[str]:
    """The stacks on which a distribution can have an add-on, beside a framework."""
    reasons = {
        stack: combinations.stack_reason(matrix, distribution, framework, stack, addon) for stack in matrix.stacks
    }
    return [stack for stack, reason in reasons.items() if reason is None]


def _tag(matrix: Matrix, onto: Onto, framework: str, stack: str) -> str:
    """The tag of another image, in the registry of the one that is to get add-ons if that is one of ours."""
    place, slash, name = onto.name.partition("@")[0].rpartition("/")
    ours = {
        f"{facts.repository}{end}"
        for facts in matrix.frameworks.values()
        for end in ("", *(f"-{it}" for it in matrix.addons))
    }
    where = f"{place}{slash}" if name.partition(":")[0] in ours else ""
    components = matrix.distributions[onto.distribution].components
    component = onto.component if onto.component in components else next(iter(components))
    tag = main_tag(onto.distribution, component, stack or None)
    return f"{where}{matrix.frameworks[framework].repository}:{tag}"


def parts(matrix: Matrix, distribution: str, addon: str, stack: str, present: Collection[str] = ()) -> list[str]:
    """The names of an add-on's parts and of those that they need, in the order of a join. `present` has parts of the image, without a
    stack: `common`."""
    python = matrix.operating_systems[matrix.distributions[distribution].os].python
    kinds = combinations.parts(matrix, matrix.carrying(combinations.plain(matrix), addon), matrix.stacks[stack])
    return [
        names.part_name(kind, stack, ANY_PYTHON if matrix.part[kind].any_python else python)
        for kind in kinds
        if kind not in present
    ]


def described(matrix: Matrix, addon: str, stack: str) -> Iterator[str]:
    """Lines about an add-on on a stack: which distributions can have it, and why others cannot."""
    bare = combinations.plain(matrix)
    reasons = {row: combinations.stack_reason(matrix, row, bare, stack, addon) for row in matrix.distributions}
    if can := [row for row, reason in reasons.items() if reason is None]:
        yield f"images of {listed(can)} can have it"
    why = {reason: [row for row in reasons if reasons[row] == reason] for reason in reasons.values() if reason}
    for reason, rows in why.items():
        yield f"{f'not {listed(rows)}' if can or len(why) > 1 else 'none'}: {reason}"
