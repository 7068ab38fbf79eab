"""Missing locks: those that wait for PyTorch's own index, and those that were lost or are yet to be made."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence

from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed, some
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.names import ENVIRONMENTS, environments_end, lock_architecture

MAKE_LOCKS = "run 'rosml locks'"
"""The remedy for a lock that needs only the Python package index."""

ASK_PYTORCH = f"{MAKE_LOCKS} on a machine that reaches the package indexes, PyTorch's own among them"
"""The remedy for a lock whose wheel only PyTorch's own index has, with a digest that the matrix lacks."""

RESTORE = f"{MAKE_LOCKS}; if they were there and got lost: git checkout locks"
"""The remedy for locks that should exist."""


def waiting(matrix: Matrix, parts: Iterable[Part]) -> frozenset[str]:
    """Locks of stacks' parts that need PyTorch's own index: those of releases with wheels `elsewhere` and without a digest for a Python, and those of
    packages that only such releases share."""
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
    rows = {by_lock[lock][:3] for lock in asking} - others
    return frozenset(
        asking | {lock for lock, (*key, kind) in by_lock.items() if matrix.part[kind].shared and tuple(key) in rows}
    )


def _asks(matrix: Matrix, stack: str, architecture: str, python: str, family: str) -> bool:
    digests = matrix.release(stack, family).elsewhere.get(stack, {}).get(architecture)
    return digests is not None and python not in digests


UNLOCKED = "lock missing"
"""The beginning of the reason why an image or part without a lock cannot be built."""


def on(thing: Image | Part, architecture: str) -> list[str]:
    """The locks that an image or part lacks for an architecture."""
    return [lock for lock in thing.unlocked if lock_architecture(lock) == architecture]


def hindrance(thing: Image | Part, architecture: str) -> str:
    """Why an image or part cannot be built for an architecture, as far as its locks are concerned; empty if it can."""
    lacking, damaged = on(thing, architecture), thing.damaged if isinstance(thing, Image) else ()
    if not lacking:
        return ""
    if isinstance(thing, Image) and {*damaged}.intersection(lacking):
        return f"{UNLOCKED}: {_of_image(thing, lacking, some)}"
    return f"{UNLOCKED}: {some(lacking)}"


def damage(image: Image, architectures: Collection[str]) -> str:
    """Which locks of an image for some architectures are there and unusable, in words; empty if none is."""
    locks = [lock for name in architectures for lock in on(image, name) if lock in image.damaged]
    return _of_image(image, locks, some) if locks else ""


def reason(image: Image) -> str:
    """The missing locks of an image, in words: `locks/cpu/amd64/3.11/torch.txt is missing`."""
    return _of_image(image, image.unlocked, listed)


def _of_image(image: Image, locks: Sequence[str], names: Callable[[list[str]], str]) -> str:
    """The problems of some locks of an image, in words. Of an environment that does not go with it, the reason is said."""
    others = [lock for lock in locks if not (image.misfit and lock.startswith(f"{ENVIRONMENTS}/"))]
    return "; ".join(filter(None, [image.misfit, _described(others, image.damaged, names)]))


def _described(locks: Sequence[str], damaged: Collection[str], names: Callable[[list[str]], str]) -> str:
    """The problems of locks in words: first missing ones, then unusable ones."""
    kinds = (
        ("missing", [lock for lock in locks if lock not in damaged]),
        ("damaged, or not of the release that matrix.yaml names", [lock for lock in locks if lock in damaged]),
    )
    return "; ".join(
        f"{names(locks_of_kind)} {'is' if len(locks_of_kind) == 1 else 'are'} {what}"
        for what, locks_of_kind in kinds
        if locks_of_kind
    )


def remedy(image: Image) -> str:
    """The remedy for an image without its locks."""
    if all(lock.startswith(f"{ENVIRONMENTS}/") for lock in image.unlocked):
        provider = image.target.removesuffix(environments_end([image.environment]))
        beside = (
            "; if another image needs the present lock: there is one for each Python, so write a second environment"
        )
        return f"run 'rosml env add {image.environment} --image {provider}'{beside if image.misfit else ''}"
    return MAKE_LOCKS if image.lost else ASK_PYTORCH


def way_back(image: Image) -> str:
    """The remedy for somebody who may have had the locks before."""
    return RESTORE if remedy(image) == MAKE_LOCKS else remedy(image)


def lost(image_set: ImageSet) -> RosmlError | None:
    """The error about images whose locks should exist; None if only locks are missing that wait for another index."""
    images = [image.target for image in image_set.images if image.lost]
    if not images:
        return None
    locks = list(dict.fromkeys(lock for image in image_set.images for lock in image.lost))
    damaged = {lock for image in image_set.images for lock in image.damaged}
    misfits = dict.fromkeys(image.misfit for image in image_set.images if image.misfit)
    unfit = {lock for image in image_set.images if image.misfit for lock in image.lost if lock.startswith(ENVIRONMENTS)}
    described = _described([lock for lock in locks if lock not in unfit], damaged, some)
    cannot = f"{counted(len(images), 'image')} cannot be built ({some(images)})"
    remedies = (way_back(image) for image in image_set.images if image.lost)
    return RosmlError(f"{cannot}: {'; '.join(filter(None, [*misfits, described]))}", "; ".join(dict.fromkeys(remedies)))
