"""Restricted parts: to which registries images with them may go.

Everything that pushes an image asks `require`. What an image has is read from its label, which everybody may write: so it is limited,
and anything in it counts as a restriction.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from rosml import MATRIX
from rosml.base.errors import RosmlError
from rosml.base.problems import some
from rosml.images.image_set.labels import RESTRICTED
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import extends, registries
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.patterns import HOST, NAME
from rosml.images.matrix.validate import validate

VARIABLE = "ROSML_PRIVATE"
"""The variable with further private registries, for those without a set: hosts with spaces between them."""

PAGE = "docs/licences.md"

UNREADABLE = "of an unreadable name"
"""How a part is called whose name in the label is none."""


@dataclass(frozen=True)
class Declared:
    """Where the owner of a set says that restricted parts may go: hosts of private registries, and places in public ones, a host and a
    path."""

    private: tuple[str, ...] = ()
    rights: tuple[str, ...] = ()

    @classmethod
    def of(cls, matrix: Matrix, environment: Mapping[str, str] = os.environ) -> Declared:
        words = environment.get(VARIABLE, "").lower().split()
        for host in words:
            if not re.fullmatch(HOST, host):
                text = f"{VARIABLE} has {host[:100]!r}, which is no host of a registry"
                raise RosmlError(text, "name hosts alone, such as registry.example.com:5000", exit_code=2)
            if registries.is_public(host):
                text = f"{VARIABLE} names {host}, which is a public registry"
                raise RosmlError(text, f"leave it out; {PAGE} says what you can declare in set.yaml", exit_code=2)
        return cls((*matrix.private, *words), matrix.i_have_the_rights)

    def keeps(self, host: str) -> bool:
        """Whether a registry is private, or on this machine."""
        return registries.is_here(host) or host.lower() in self.private or registries.name_of(host) in self.private

    def right(self, host: str, repository: str) -> str:
        """The declared place in which a repository is; empty if it is in none."""
        where = f"{host.lower()}/{repository}/"
        return next((place for place in self.rights if where.startswith(f"{place}/")), "")


def of_this_machine() -> Declared:
    """What the set or the matrix of this rosml declares, and the variable."""
    return Declared.of(validate(extends.read(MATRIX)))


def parts_of(labels: Mapping[str, str]) -> tuple[str, ...]:
    """The restricted parts of an image with these labels."""
    text = labels.get(RESTRICTED, "")
    words = text.split() or [text][: len(text)]
    return tuple(dict.fromkeys(word if re.fullmatch(NAME, word) and len(word) <= 64 else UNREADABLE for word in words))


def of(matrix: Matrix, parts: Iterable[str]) -> tuple[str, ...]:
    """The restricted ones of some parts of a matrix."""
    return tuple(name for name in parts if name in matrix.part and matrix.part[name].restricted)


def refused(
    image_set: ImageSet, images: Iterable[Image], host: str, repository: str
) -> tuple[dict[str, RosmlError], str]:
    """The images that may not go to a repository of a registry, by their targets, each with the error that says so; and what to tell
    the user about the others, as `require` gives it. A run over these others is a whole one: the registry may have no more."""
    declared, errors, note = Declared.of(image_set.matrix), dict[str, RosmlError](), ""
    for image in images:
        parts = of(image_set.matrix, [image_set.part_by_name[name].kind for name in image.parts])
        try:
            note = note or require(parts, image.target, host, repository, declared)
        except RosmlError as error:
            errors[image.target] = error
    return errors, note


def require(parts: Sequence[str], what: str, host: str, repository: str, declared: Declared) -> str:
    """Checks that restricted parts of an image, `what`, may go to a repository of a registry. Returns what to tell the user: that they
    declared to have the rights; empty if there is nothing to tell. Raises a RosmlError if the registry is not declared private."""
    if not parts or declared.keeps(host):
        return ""
    has = f"{what} has the restricted part{'s' * (len(parts) > 1)} {some(parts)}"
    if place := declared.right(host, repository):
        return f"{has}, and goes to {place}: you declared that you have the rights"
    if registries.is_public(host):
        remedy = f"push to a private registry; if the licence lets you, add i_have_the_rights: [{host}/{repository}] to set.yaml"
        raise RosmlError(f"{has}, and {host} is a public registry", f"{remedy}; see {PAGE}", exit_code=2)
    remedy = f"if only your organization can pull from it, add private: [{host}] to set.yaml, or set {VARIABLE}={host}"
    raise RosmlError(f"{has}, and {host} is not declared private", f"{remedy}; see {PAGE}", exit_code=2)
