"""Reads a matrix and gives its image set, checked, with the locks that are there."""

from __future__ import annotations

from pathlib import Path

from rosml import ROOT
from rosml.base.problems import InputError
from rosml.images.collisions import collisions
from rosml.images.expand import expand
from rosml.images.image_set import ImageSet
from rosml.images.locked import current_locks, unusable_locks, with_locks
from rosml.matrix.source import Document, read
from rosml.matrix.validate import validate


def load(file: Path, root: Path = ROOT) -> ImageSet:
    """Reads, validates and expands a matrix, and looks which locks are there.

    Args:
        file: the matrix.
        root: the project's root, where the locks are.

    Raises:
        RosmlError: the file cannot be read (exit code 2).
        InputError: it has problems: all that can be seen at once, each with its place (exit code 2).
    """
    result = image_set(read(file))
    present = current_locks(result, root)
    return with_locks(result, present, unusable_locks(result, root, present))


def image_set(document: Document) -> ImageSet:
    """The image set of a parsed matrix; raises as `load` does."""
    result = expand(validate(document))
    if found := [document.problem(path, text) for path, text in collisions(result)]:
        raise InputError(document.name, found)
    return result
