"""Makes the locks of an environment on an image of the matrix, for all its architectures."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from rosml.base import files, web
from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.base.units import size
from rosml.images.bake.targets import unlocked
from rosml.images.environments import lock as locks
from rosml.images.environments.declaration import FILE, Declaration, content
from rosml.images.environments.lock import Lock, NoSolution, Provider
from rosml.images.image_set import lock_file
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.locks.index import Index, WheelTarget
from rosml.images.locks.installs import GLIBC
from rosml.images.locks.uv import Uv, with_glibc
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.names import environments_end, lock_architecture


class Sized(NamedTuple):
    """A lock, and the bytes of its wheels."""

    lock: Lock
    size: int


@dataclass(frozen=True)
class Request:
    """An environment that gets new locks. `folder` has those of before, whose versions stay if they fit and `upgrade` is not set.
    `preferences` has versions of a uv.lock, which stay alike."""

    name: str
    declaration: Declaration
    folder: Path
    upgrade: bool = False
    preferences: str = ""

    def previous(self, python: str, architecture: str) -> str:
        if self.preferences:
            return self.preferences
        file = locks.file_of(self.folder, python, architecture)
        text = "" if self.upgrade or not file.is_file() else files.text(file)
        return text if locks.parse(text) else ""  # uv would follow what somebody wrote into it


def resolved(
    request: Request, image_set: ImageSet, target: str, say: Callable[[str], None], uv: Uv | None = None
) -> list[Sized]:
    """The lock for each architecture of an image. Writes nothing.

    Raises:
        RosmlError: there is no such image, or nothing fits; then it names releases of other stacks that do.
    """
    image = _image(image_set, target)
    if reason := unlocked(image):
        raise RosmlError(f"{target} {reason}", "name another image", exit_code=2)
    uv = uv or Uv()
    every = list[Sized]()
    with web.client() as client:
        index = Index(uv, client)
        for architecture in image.architectures:
            say(f"resolve {request.name} on {target} for {architecture}")
            provider = provider_of(image_set.matrix, image, architecture)
            if request.declaration.apart:
                provider = _with_nothing(provider)
            previous = request.previous(provider.python, architecture)
            try:
                lock = locks.resolved(request.name, request.declaration, provider, uv, previous)
            except NoSolution as error:
                raise _refused(request, image_set, image, provider, index, error) from None
            every.append(Sized(lock, _size(index, lock, provider.wheels)))
    return every


def with_images(declaration: Declaration, targets: Iterable[str], image_set: ImageSet) -> Declaration:
    """A declaration for images beside those that it has. One takes the place of an earlier one with the same Python.

    Raises:
        RosmlError: there is no such image, or no image at all; two of `targets` have the same Python.
    """
    new = dict[str, str]()
    for target in dict.fromkeys(targets):
        python = _image(image_set, target).python
        if python in new:
            text = (
                f"{new[python]} and {target} both have Python {python}, and an environment has one lock for each Python"
            )
            raise RosmlError(text, "name one of them; the environment goes onto all images with what it takes", 2)
        new[python] = target
    by_python = {_image(image_set, target).python: target for target in declaration.images} | new
    if not by_python:
        raise RosmlError("no image is named", "name the one that it stands on: --image jazzy-base", exit_code=2)
    return declaration.model_copy(update={"images": sorted(by_python.values())})


def _image(image_set: ImageSet, target: str) -> Image:
    if target not in image_set.by_target:
        raise RosmlError(f"there is no image {target}", "see all with: rosml list", exit_code=2)
    if environment := (image := image_set.by_target[target]).environment:
        plain = target.removesuffix(environments_end([environment]))
        raise RosmlError(f"{target} has the environment {environment} already", f"name {plain}", exit_code=2)
    return image


def provider_of(matrix: Matrix, image: Image, architecture: str) -> Provider:
    """What an image has for an environment. Its parts' locks say it."""
    from rosml import ROOT

    packages = dict[str, str]()
    for path in image.locks:
        if lock_architecture(path) == architecture:
            packages |= lock_file.versions(files.text(ROOT / path))
    releases = {lock_file.package_name(item) for item in matrix.families}
    glibc = GLIBC[image.os]
    wheels = with_glibc(matrix.architectures[architecture].wheels, glibc)
    return Provider(image.target, architecture, image.python, glibc, wheels, packages, releases)


def _with_nothing(provider: Provider) -> Provider:
    """A provider of nothing but its Python: an environment on it has its own PyTorch."""
    return replace(provider, packages={}, releases=())


def _refused(
    request: Request, image_set: ImageSet, image: Image, provider: Provider, index: Index, error: NoSolution
) -> RosmlError:
    """The error about an environment that does not fit, with what would."""
    declaration, uv = request.declaration, index.uv
    if not locks.fits(declaration, provider, {}, uv):
        text = f"no set of wheels for Python {provider.python} on {provider.architecture} is what it asks for:\n{error.reason}"
        python = " or ".join(_of_other_pythons(declaration, image_set, provider, uv)) or "one with another Python"
        remedy = f"relax the requirements, name another image: {python}, or leave a package out: --without PACKAGE"
        return RosmlError(text, remedy, exit_code=2)
    fitting = [*_fitting(declaration, image_set, image, provider, uv)]
    remedy = f"name an image of another stack: {listed(fitting, last='or')}" if fitting else "relax the requirements"
    apart = f"give it its own beside the image's: --apart{_size_apart(request, provider, index)}"
    return RosmlError(error.message, f"{remedy}; or an image without a framework; or {apart}", exit_code=2)


def _of_other_pythons(declaration: Declaration, image_set: ImageSet, provider: Provider, uv: Uv) -> Iterator[str]:
    """A ROS image of each other Python for which there are the wheels."""
    ros = [it for it in image_set.images if not it.stack and it.locked and provider.architecture in it.architectures]
    for python, image in {it.python: it for it in reversed(ros)}.items():
        other = _with_nothing(provider_of(image_set.matrix, image, provider.architecture))
        if python != provider.python and locks.fits(declaration, other, {}, uv):
            yield image.target


def _size_apart(request: Request, provider: Provider, index: Index) -> str:
    """How much an environment with its own PyTorch downloads; empty if the index does not say."""
    with suppress(RosmlError):
        lock = locks.resolved(request.name, request.declaration, _with_nothing(provider), index.uv)
        return f" ({size(_size(index, lock, provider.wheels))} to download)"
    return ""


def _fitting(declaration: Declaration, image_set: ImageSet, image: Image, provider: Provider, uv: Uv) -> Iterator[str]:
    """The same image of other stacks with releases that fit, in words: `ros1-bookworm-core-torch-cu128 has torch 2.10.0`."""

    def content(item: Image) -> tuple[object, ...]:
        return item.distribution, item.component, item.framework, item.addons, item.environment

    for other in image_set.images:
        if other.locked and content(other) == content(image) and provider.architecture in other.architectures:
            has = provider_of(image_set.matrix, other, provider.architecture).pinned_releases
            if has != provider.pinned_releases and locks.fits(declaration, provider, has, uv):
                yield f"{other.target} has {listed([f'{name} {version}' for name, version in has.items()])}"


def _size(index: Index, lock: Lock, wheels: str) -> int:
    """The bytes of a lock's wheels."""
    pins = {pin.name: pin.version for pin in lock.pins}
    target = WheelTarget(lock.python, wheels)
    return sum(wheel.size for wheel in index.wheels(target, pins).values()) if pins else 0


def write(folder: Path, every: Iterable[Lock], declaration: Declaration | None = None) -> None:
    """Writes all locks of an environment, with its declaration if it is new, and removes locks of other Pythons and architectures."""
    texts = {locks.file_of(folder, lock.python, lock.architecture): str(lock) for lock in every}
    for place in (folder, *(file.parent for file in texts)):
        place.mkdir(parents=True, exist_ok=True)
    files.write_all({**texts, **({folder / FILE: content(declaration)} if declaration else {})})
    for file in {*folder.glob(locks.FILES)} - texts.keys():
        if locks.parse(files.text(file)):
            file.unlink()
