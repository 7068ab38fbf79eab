"""Locks that are not there: those that wait for PyTorch's own index, and those that somebody lost or has yet to make."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence

from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed, some
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix.model import Matrix

MAKE_LOCKS = "run 'rosml locks'"
"""How a lock comes into being that needs the Python package index alone."""

ASK_PYTORCH = f"{MAKE_LOCKS} where the package indexes answer, PyTorch's own among them"
"""How a lock comes into being whose wheel only PyTorch's own index has, under a digest that the matrix does not know."""

RESTORE = f"{MAKE_LOCKS}; if they were there and got lost: git checkout locks"
"""What to do about locks that should be there."""


def waiting(matrix: Matrix, parts: Iterable[Part]) -> frozenset[str]:
    """Locks that cannot be made before PyTorch's own index was asked: of releases that have wheels `elsewhere` and no
    digest for a Python, and what is common to such releases alone."""
    by_lock = {
        lock: (part.stack, architecture, part.python, part.kind)
        for part in parts
        for architecture, lock in zip(part.architectures, part.locks, strict=True)
    }
    asking: set[str] = set()
    others: set[tuple[str, str, str]] = set()
    for lock, (stack, architecture, python, kind) in by_lock.items():
        if kind in matrix.families:
            if _asks(matrix, stack, architecture, python, kind):
                asking.add(lock)
            else:
                others.add((stack, architecture, python))
    known = {by_lock[lock][:3] for lock in asking} - others
    return frozenset(
        asking | {lock for lock, (*key, kind) in by_lock.items() if matrix.part[kind].shared and tuple(key) in known}
    )


def _asks(matrix: Matrix, stack: str, architecture: str, python: str, family: str) -> bool:
    facts = matrix.stacks[stack]
    digests = matrix.releases[family][facts.releases[family]].elsewhere.get(stack, {}).get(architecture)
    return digests is not None and python not in digests


UNLOCKED = "lock missing"
"""How reasons begin why an image or part cannot be made that lacks a lock."""


def on(thing: Image | Part, architecture: str) -> list[str]:
    """The locks that an image or part lacks for an architecture."""
    return [lock for lock in thing.unlocked if lock.split("/")[2] == architecture]


def reason(image: Image) -> str:
    """What an image lacks: `locks/cpu/amd64/3.11/torch.txt is missing`."""
    return _told(image.unlocked, image.damaged, listed)


def _told(locks: Sequence[str], damaged: Collection[str], names: Callable[[list[str]], str]) -> str:
    """What is wrong with some locks: those that are not there, then those that are there and cannot be used.

    Args:
        names: spells several of them out.
    """
    kinds = (
        ("missing", [lock for lock in locks if lock not in damaged]),
        ("damaged, or not of the release that matrix.yaml names", [lock for lock in locks if lock in damaged]),
    )
    return "; ".join(f"{names(found)} {'is' if len(found) == 1 else 'are'} {what}" for what, found in kinds if found)


def remedy(image: Image) -> str:
    """How an image comes by its locks."""
    return MAKE_LOCKS if image.lost else ASK_PYTORCH


def lost(image_set: ImageSet) -> RosmlError | None:
    """What to say of images whose locks should be there; None where none is missing but those that wait."""
    images = [image.target for image in image_set.images if image.lost]
    if not images:
        return None
    locks = list(dict.fromkeys(lock for image in image_set.images for lock in image.lost))
    damaged = {lock for image in image_set.images for lock in image.damaged}
    cannot = f"{counted(len(images), 'image')} cannot be built ({some(images)})"
    return RosmlError(f"{cannot}: {_told(locks, damaged, some)}", RESTORE)
