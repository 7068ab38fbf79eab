"""Which layers of an image a machine pulls if it has others: those that no other has, by digest."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.join.layers import Source
from rosml.images.join.transfer import Transfer
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registries
from rosml.registry.documents import Descriptor


@dataclass(frozen=True)
class Delta:
    """What a machine with one image pulls for another one, for one platform. Sizes are in bytes, compressed as in the registry.

    Attributes:
        platform: such as `linux/arm64`.
        before: the digest of the image that the machine has; empty if that is not for this platform.
        after: the digest of the other image.
        pulled: how many layers are pulled. pulled_bytes: their size.
        kept: how many layers are there already. kept_bytes: their size.
    """

    platform: str
    before: str
    after: str
    pulled: int
    pulled_bytes: int
    kept: int
    kept_bytes: int

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)


def unique(image: Source) -> dict[str, Descriptor]:
    """The layers of an image by digest, lowest first: an image may have the same layer twice."""
    return {layer.digest: layer for layer in image.manifest.layers}


def shared(image: Source, have: Iterable[Source]) -> dict[str, Source]:
    """The layers of an image that a machine with others has: by digest, each with the first image that has it."""
    wanted, found = unique(image), dict[str, Source]()
    for other in have:
        for digest in unique(other):
            if digest in wanted:
                found.setdefault(digest, other)
    return found


def delta(image: Source, have: Source | None) -> Delta:
    """What a machine that has one image pulls for another one.

    Args:
        image: the other one.
        have: what the machine has; None if that is not for this platform.
    """
    wanted, there = unique(image), shared(image, [have] if have else [])
    sizes = {True: [0], False: [0]}
    for digest, layer in wanted.items():
        sizes[digest in there].append(layer.size)
    pulled, kept = len(wanted) - len(there), len(there)
    before = have.digest if have else ""
    return Delta(image.platform, before, image.digest, pulled, sum(sizes[False]), kept, sum(sizes[True]))


def deltas(before: Mapping[str, Source], after: Mapping[str, Source]) -> list[Delta]:
    """The same for each platform of the second image."""
    return [delta(image, before.get(platform)) for platform, image in sorted(after.items())]


def complete(text: str, services: Services, registries: Registries) -> str:
    """The complete reference of an image. A name without a registry is one of the local registry, or else of Docker Hub.

    Raises:
        RosmlError: it is no name of an image (exit code 2); the local registry does not answer.
    """
    places = [services.place, services.registry] if services.registry and not references.has_registry(text) else []
    for place in places:
        where = references.parse(f"{place}/{text}")
        if registries(where.host).head(where.repository, where.reference):
            return str(where)
    return str(references.parse(references.complete(text)))


def for_platform(transfer: Transfer, name: str, platform: str) -> Source:
    """An image for one platform.

    Args:
        name: its complete reference.

    Raises:
        RosmlError: there is no such image, or not for this platform (exit code 2); the registry does not answer or refuses.
    """
    found = transfer.platforms(name)
    if platform not in found:
        text = f"{name} is for {listed(sorted(found)) or 'no platform'}, not for {platform}"
        remedy = f"name one that it has: --platform {min(found)}" if found else "name another image"
        raise RosmlError(text, remedy, exit_code=2)
    return found[platform]
