"""Builds environments for all their architectures, and pushes each as an image of its own, which a join puts onto others."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.bake import bake_file, hcl
from rosml.images.bake.targets import ENVIRONMENT, ENVIRONMENT_LOCKS
from rosml.images.builds import base_images, contents
from rosml.images.builds.push import Push, push
from rosml.images.environments import lock as locks
from rosml.images.environments.declaration import FILE
from rosml.images.environments.lock import Lock
from rosml.images.image_set import labels
from rosml.images.image_set.model import ENVIRONMENTS, ImageSet
from rosml.images.matrix import names
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registry


@dataclass(frozen=True)
class BuiltEnvironment:
    """An environment in the registry. `layers` are its sizes in bytes, by platform."""

    name: str
    reference: str  # with the digest
    digest: str
    layers: Mapping[str, int]
    seconds: float

    def to_json(self) -> dict[str, Any]:
        return asdict(self)


def read(folder: Path, name: str, architectures: Iterable[str], python: str = "") -> list[list[Lock]]:
    """The locks of an environment, for each Python those of all architectures; only those of `python` if it is not empty.

    Raises:
        RosmlError: there is none, or they do not go together.
    """
    pythons = [python] if python else sorted({file.parent.name for file in folder.glob(locks.FILES)})
    every = []
    for version in pythons:
        places = (locks.file_of(folder, version, architecture) for architecture in architectures)
        if same := [locks.read(file) for file in places if file.is_file()]:
            every.append(same)
    if not every:
        text = f"{folder} has no lock{f' for Python {python}' if python else ''}"
        words = "" if (folder / FILE).exists() else " REQUIREMENT..."
        raise RosmlError(text, f"make it: rosml env add {name}{words} --image IMAGE", exit_code=2)
    differ = any(len({lock.glibc for lock in same}) > 1 for same in every)
    if differ or any(lock.name != name for same in every for lock in same):
        text = f"the locks in {folder} are not of one environment {name}"
        raise RosmlError(text, f"make them again: rosml env add {name}", exit_code=2)
    return every


def publish(
    services: Services, image_set: ImageSet, every: Sequence[Lock], prefix: str, say: Callable[[str], None]
) -> BuiltEnvironment:
    """Builds an environment from its locks, pushes it and what it has, and moves its tag. `prefix`: the registry, and the path before `env`."""
    started, first = time.monotonic(), every[0]
    place = references.parse(f"{prefix}/{ENVIRONMENTS}")
    with services.temporary_folder() as folder:
        for item in every:
            Path(folder, f"{item.architecture}.txt").write_text(str(item))
        call = _bake(services, image_set, every, Path(folder))
        say(f"environment {first.name} for {listed([*_platforms(image_set, every)])}")
        digest = push(services, Push(call, str(place).rpartition(":")[0], image_set.matrix.compression))
    tag = names.environment_name(first.name, first.python)
    with Registry(place.host, ca_bundle=services.ca_bundle) as registry:
        contents.attach(services, image_set, registry, [(place.repository, digest)], say)
        manifests = contents.manifests(registry, place.repository, digest)
        sizes = [sum(layer.size for layer in manifest.layers) for manifest in manifests]
        registry.tag(place.repository, digest, tag)
    return BuiltEnvironment(
        first.name,
        f"{prefix}/{ENVIRONMENTS}:{tag}@{digest}",
        digest,
        dict(zip(_platforms(image_set, every), sizes, strict=True)),
        time.monotonic() - started,
    )


def _platforms(image_set: ImageSet, every: Sequence[Lock]) -> list[str]:
    return [image_set.matrix.architectures[item.architecture].platform for item in every]


def _bake(services: Services, image_set: ImageSet, every: Sequence[Lock], folder: Path) -> buildx.Bake:
    """The call that builds an environment on an operating system that has its Python, which compiles the bytecode."""
    first, matrix = every[0], image_set.matrix
    systems = matrix.operating_systems
    system = next((name for name, facts in systems.items() if facts.python == first.python), "")
    if not system:
        text = f"environment {first.name} is for Python {first.python}, which no operating system of matrix.yaml has"
        raise RosmlError(text, "make its locks again: rosml env add NAME --image IMAGE", exit_code=2)
    base = base_images.assembler(services, systems, system, first.python)
    target = f"{ENVIRONMENT}-{first.name}"
    attributes = {
        "inherits": [ENVIRONMENT],
        "platforms": _platforms(image_set, every),
        "contexts": {ENVIRONMENT_LOCKS: str(folder), "os": f"docker-image://{base.reference}"},
        "args": {"ENVIRONMENT": first.name, "PYTHON": first.python, "GLIBC": str(first.glibc)},
        "labels": labels_of(every),
    }
    file = services.state / "bake" / f"{target}.hcl"
    file.parent.mkdir(parents=True, exist_ok=True)
    files.write(file, f"{bake_file.excerpt(image_set, [ENVIRONMENT])}\n{hcl.block('target', target, attributes)}")
    return buildx.Bake(target, target, file, shares=buildx.IMAGES)


def labels_of(every: Sequence[Lock]) -> dict[str, str]:
    """The labels of an environment. An image for several architectures takes the same releases for all."""
    first = every[0]
    taken = [{*item.releases.items()} for item in every]
    if any(other != taken[0] for other in taken):
        text = f"environment {first.name} takes other releases for each architecture"
        raise RosmlError(text, "pin their versions in environment.toml", exit_code=2)
    return labels.of_environment(
        first.name, first.python, first.releases, {package for item in every for package in item.takes}
    )
