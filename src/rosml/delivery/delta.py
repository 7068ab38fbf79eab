"""Which layers of an image a machine pulls if it has others: those that no other has, by digest."""

from __future__ import annotations

import re
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
        replaced: how many of the pulled layers replace one that is there. replaced_bytes: their size. Of these, `rosml save` sends what differs,
            if that is much smaller.
    """

    platform: str
    before: str
    after: str
    pulled: int
    pulled_bytes: int
    kept: int
    kept_bytes: int
    replaced: int = 0
    replaced_bytes: int = 0

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


LEAST = 256 << 10
"""The smallest layer of which we look for differences, in bytes, compressed."""

MOST = 16
"""How many times larger than a layer the older one may be."""


@dataclass(frozen=True)
class Old:
    """A layer of an older image that a new layer replaces. `size` is in bytes, compressed.

    Attributes:
        image: has the layer.
        digest: of the compressed layer.
        diff_id: of the uncompressed one.
    """

    image: Source
    digest: str
    diff_id: str
    size: int


def replaced(image: Source, have: Iterable[Source]) -> dict[str, Old]:
    """The layers of an image that replace layers of others, by digest: the same step of a build made both, or they have the same place among
    the layers that differ. Small layers do not count."""
    found = dict[str, Old]()
    layers, others = unique(image), [*have]
    there = shared(image, others)
    for other in others:
        for digest, old in _paired(image, other):
            size = layers[digest].size
            if digest not in there and size >= LEAST and old.size <= MOST * size:
                found.setdefault(digest, old)
    return found


def _paired(image: Source, other: Source) -> Iterable[tuple[str, Old]]:
    """The layers that one image alone has, each with one that the other alone has."""
    if len(other.manifest.layers) != len(other.diff_ids):
        return
    diff_ids = {layer.digest: diff_id for layer, diff_id in zip(other.manifest.layers, other.diff_ids, strict=True)}
    new, old = _steps(image), _steps(other)
    gone, rest = [digest for digest in old if digest not in new], list[str]()
    pairs = dict[str, str]()
    for digest, step in new.items():
        if digest in old:
            continue
        if same := next((name for name in gone if step and old[name] == step), ""):
            gone.remove(same)
            pairs[digest] = same
        else:
            rest.append(digest)
    if len(rest) == len(gone):
        pairs |= dict(zip(rest, gone, strict=True))
    sizes = unique(other)
    for digest, name in pairs.items():
        yield digest, Old(other, name, diff_ids[name], sizes[name].size)


_CHANGING = re.compile(r"[0-9a-f]{12,}|[0-9]+(?:\.[0-9]+)*")
"""What two builds of a step may have different: commits, versions and dates."""


def _steps(image: Source) -> dict[str, str]:
    """The layers of an image by digest, each with the step of a build that made it; empty texts if the image does not say."""
    entries = [entry for entry in image.config.facts.history or () if not entry.get("empty_layer")]
    layers = image.manifest.layers
    said = [_CHANGING.sub("0", str(entry.get("created_by") or "")) for entry in entries]
    return {
        layer.digest: step
        for layer, step in zip(layers, said if len(said) == len(layers) else [""] * len(layers), strict=True)
    }


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
    changed = [wanted[digest].size for digest in replaced(image, [have] if have else [])]
    counts = pulled, sum(sizes[False]), kept, sum(sizes[True]), len(changed), sum(changed)
    return Delta(image.platform, before, image.digest, *counts)


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
