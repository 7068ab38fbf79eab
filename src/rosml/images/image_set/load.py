"""Reads and checks a matrix, and makes its image set with the existing locks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from rosml import ROOT
from rosml.base.problems import InputError, KeyPath
from rosml.images.image_set.collisions import collisions
from rosml.images.image_set.expand import expand
from rosml.images.image_set.locked import current_locks, unusable_locks, with_locks
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import extends
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.source import Document
from rosml.images.matrix.validate import validate

KEYS = "components/archive-keys"
BEGIN = "-----BEGIN PGP PUBLIC KEY BLOCK-----"


def load(file: Path, root: Path = ROOT) -> ImageSet:
    """Reads, validates and expands a matrix, and finds its locks.

    Args:
        file: the matrix, or a set that extends it.
        root: the project's root, which has the matrix that a set extends, the locks and the keys of archives.

    Raises:
        RosmlError: the file cannot be read (exit code 2).
        InputError: with all problems that can be seen at once, each with its place (exit code 2).
    """
    document = extends.read(file, root / "matrix.yaml")
    result = image_set(document)
    if found := [document.problem(path, text) for path, text in lacking_keys(result.matrix, root)]:
        raise InputError(document.name, found)
    present = current_locks(result, root)
    return with_locks(result, present, unusable_locks(result, root, present))


def lacking_keys(matrix: Matrix, root: Path) -> Iterator[tuple[KeyPath, str]]:
    """Distributions whose ROS comes from an archive, and that lack the archive's key."""
    for name, distribution in matrix.distributions.items():
        if archive := distribution.archive:
            file = root / KEYS / archive.key
            try:
                there = BEGIN in file.read_text(errors="replace")
            except OSError:
                there = False
            if not there:
                text = f"{KEYS}/{archive.key} is no armored public key; put it there: gpg --armor --export KEY"
                yield ("distributions", name, "archive", "key"), text


def without_locks(file: Path, root: Path = ROOT) -> ImageSet:
    """The image set of a matrix, or of a set that extends it, for those who need only its names; raises as `load` does."""
    return image_set(extends.read(file, root / "matrix.yaml"))


def image_set(document: Document) -> ImageSet:
    """The image set of a matrix as `extends.read` gives it; raises as `load` does."""
    result = expand(validate(document))
    if found := [document.problem(path, text) for path, text in collisions(result)]:
        raise InputError(document.name, found)
    return replace(result, base=validate(document.base)) if document.base else result
