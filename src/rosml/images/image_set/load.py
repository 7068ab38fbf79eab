"""Reads and checks a matrix, and makes its image set with the existing locks."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from rosml import ROOT
from rosml.base.problems import InputError, KeyPath
from rosml.images.image_set.collisions import collisions
from rosml.images.image_set.expand import Place, carriers, parts_of, places, with_images
from rosml.images.image_set.locked import current_locks, unusable_locks, with_environments, with_locks
from rosml.images.image_set.model import ImageSet, Part
from rosml.images.matrix import extends
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.source import Document
from rosml.images.matrix.validate import validate

KEYS = "components/archive-keys"
BEGIN = "-----BEGIN PGP PUBLIC KEY BLOCK-----"


def load(file: Path, root: Path = ROOT) -> ImageSet:
    """Reads, validates and expands a matrix, or a set that extends it, and finds its locks. Raises an InputError with all problems that
    can be seen at once."""
    return _locked(_checked(extends.read(file, root / "matrix.yaml"), root).expanded(), root)


def load_one(file: Path, name: str, root: Path = ROOT) -> ImageSet:
    """As `load`, but with one image, those that may run its tests, and its parts alone, if the name is a target, a test or a tag. All
    names are checked."""
    checked = _checked(extends.read(file, root / "matrix.yaml"), root)
    tag = name.rpartition("/")[2] if ":" in name else ""
    names = {name, name.removesuffix("-test")}
    few = [place for place in checked.places if place.target in names or tag in place.tags]
    if not few:
        return _locked(checked.expanded(), root)
    targets = {place.target for place in few}.union(*(carriers(checked.matrix, place) for place in few))
    places = tuple(place for place in checked.places if place.target in targets)
    return _of_few(replace(checked, places=places).expanded(), root)


def _of_few(image_set: ImageSet, root: Path) -> ImageSet:
    locks = {lock for image in image_set.images for lock in image.locks}
    locked = _locked(image_set, root, locks)
    used = {name for image in locked.images for name in image.parts}
    return replace(locked, parts=tuple(part for part in locked.parts if part.name in used))


@dataclass(frozen=True)
class _Checked:
    """A matrix without problems. `base` is the matrix that a set extends."""

    matrix: Matrix
    places: tuple[Place, ...]
    parts: tuple[Part, ...]
    base: Matrix | None

    def expanded(self) -> ImageSet:
        """Its image set."""
        return replace(with_images(self.matrix, self.places, self.parts), base=self.base)


def _checked(document: Document, root: Path | None = None) -> _Checked:
    """A matrix after all checks. `root` has the keys of archives; None if they do not matter."""
    matrix = validate(document)
    images = tuple(places(matrix))
    parts = parts_of(matrix, images)
    findings = collisions(matrix, images, parts)
    if document.base:
        findings = _about_the_set(findings, document, images)
    if problems := [document.problem(path, text) for path, text in dict.fromkeys(findings)]:
        raise InputError(document.name, problems)
    base = validate(document.base) if document.base else None
    if root and (problems := [document.problem(path, text) for path, text in lacking_keys(matrix, root)]):
        raise InputError(document.name, problems)
    return _Checked(matrix, images, parts, base)


def _about_the_set(
    findings: Iterable[tuple[KeyPath, str]], document: Document, images: Sequence[Place]
) -> Iterator[tuple[KeyPath, str]]:
    """The findings in a set. If rosml's default images are not in it, it has to name its own."""
    for path, text in findings:
        if path[0] == "default" and path[:2] not in document.places and images:
            yield path[:2], f"rosml's are not all in this set; name its own, such as [{images[0].target}]"
        else:
            yield path, text


def _locked(image_set: ImageSet, root: Path, only: Collection[str] | None = None) -> ImageSet:
    """An image set with its locks. `only`: the locks to look at; all if left out."""
    image_set = with_environments(image_set, root)
    present = current_locks(image_set, root, only)
    return with_locks(image_set, present, unusable_locks(image_set, root, present))


def lacking_keys(matrix: Matrix, root: Path) -> Iterator[tuple[KeyPath, str]]:
    """Distributions whose ROS comes from an archive, and that lack the archive's key."""
    for name, distribution in matrix.distributions.items():
        if archive := distribution.archive:
            file = root / KEYS / archive.key
            try:
                has_key = BEGIN in file.read_text(errors="replace")
            except OSError:
                has_key = False
            if not has_key:
                text = f"{KEYS}/{archive.key} is no armored public key; put it there: gpg --armor --export KEY"
                yield ("distributions", name, "archive", "key"), text


def without_locks(file: Path, root: Path = ROOT) -> ImageSet:
    """The image set of a matrix, or of a set that extends it, for those who need only its names; raises as `load` does."""
    return image_set(extends.read(file, root / "matrix.yaml"))


def image_set(document: Document) -> ImageSet:
    """The image set of a matrix as `extends.read` gives it; raises as `load` does."""
    return _checked(document).expanded()
