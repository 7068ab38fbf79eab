"""Which layers of an image a machine pulls if it has others: those that no other has, by digest."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

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
    """How many layers a machine with one image pulls for another one, for one platform. Sizes are in bytes, compressed.

    Attributes:
        before: the digest of the image that the machine has; empty if that is not for this platform.
        replaced: how many of the pulled layers replace one that the machine has.
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


def unique(image: Source) -> dict[str, Descriptor]:
    """The layers of an image by digest, lowest first: an image may have the same layer twice."""
    return {layer.digest: layer for layer in image.manifest.layers}


def shared(image: Source, have: Iterable[Source]) -> dict[str, Source]:
    """The layers of an image that other images have as well, each with the first image that has it."""
    layers, owners = unique(image), dict[str, Source]()
    for other in have:
        for digest in unique(other):
            if digest in layers:
                owners.setdefault(digest, other)
    return owners


LEAST = 256 << 10
"""The smallest layer of which we look for differences, in bytes, compressed."""

MOST = 16
"""How many times larger than a layer the older one may be."""


@dataclass(frozen=True)
class OlderLayer:
    """A layer of an older image that a new layer replaces. `size` is in bytes, compressed."""

    image: Source
    digest: str
    diff_id: str
    size: int


def replaced(image: Source, have: Iterable[Source]) -> dict[str, OlderLayer]:
    """The layers of an image that replace layers of others, by digest: the same step of a build made both, or they have the same place among
    the layers that differ. Small layers do not count."""
    older_layers = dict[str, OlderLayer]()
    layers, others = unique(image), [*have]
    shared_layers = shared(image, others)
    for other in others:
        for digest, older in _paired(image, other):
            size = layers[digest].size
            if digest not in shared_layers and size >= LEAST and older.size <= MOST * size:
                older_layers.setdefault(digest, older)
    return older_layers


def _paired(image: Source, other: Source) -> Iterable[tuple[str, OlderLayer]]:
    if len(other.manifest.layers) != len(other.diff_ids):
        return
    diff_ids = {layer.digest: diff_id for layer, diff_id in zip(other.manifest.layers, other.diff_ids, strict=True)}
    new_steps, older_steps = _steps(image), _steps(other)
    gone, rest = [digest for digest in older_steps if digest not in new_steps], list[str]()
    pairs = dict[str, str]()
    for digest, step in new_steps.items():
        if digest in older_steps:
            continue
        if same := next((name for name in gone if step and older_steps[name] == step), ""):
            gone.remove(same)
            pairs[digest] = same
        else:
            rest.append(digest)
    if len(rest) == len(gone):
        pairs |= dict(zip(rest, gone, strict=True))
    sizes = unique(other)
    for digest, name in pairs.items():
        yield digest, OlderLayer(other, name, diff_ids[name], sizes[name].size)


_CHANGING = re.compile(r"[0-9a-f]{12,}|[0-9]+(?:\.[0-9]+)*")
"""What two builds of a step may have different: commits, versions and dates."""


def _steps(image: Source) -> dict[str, str]:
    """The layers of an image by digest, each with the step of a build that made it; empty texts if the image does not say."""
    entries = [entry for entry in image.config.facts.history or () if not entry.get("empty_layer")]
    digests = [layer.digest for layer in image.manifest.layers]
    steps = [_CHANGING.sub("0", str(entry.get("created_by") or "")) for entry in entries]
    return dict(zip(digests, steps if len(steps) == len(digests) else [""] * len(digests), strict=True))


def delta(image: Source, have: Source | None) -> Delta:
    """What a machine that has one image, if any, pulls for another one."""
    others = [have] if have else []
    layers, shared_layers = unique(image), shared(image, others)
    kept = [layers[digest].size for digest in shared_layers]
    pulled = [layer.size for digest, layer in layers.items() if digest not in shared_layers]
    changed = [layers[digest].size for digest in replaced(image, others)]
    counts = len(pulled), sum(pulled), len(kept), sum(kept), len(changed), sum(changed)
    return Delta(image.platform, have.digest if have else "", image.digest, *counts)


def complete(text: str, services: Services, registries: Registries) -> str:
    """The complete reference of an image. A name without a registry is one of the local registry, or else of Docker Hub."""
    places = [services.place, services.registry] if services.registry and not references.has_registry(text) else []
    for place in places:
        where = references.parse(f"{place}/{text}")
        if registries(where.host).head(where.repository, where.reference):
            return str(where)
    return str(references.parse(references.complete(text)))


def for_platform(transfer: Transfer, name: str, platform: str) -> Source:
    """An image, by its complete reference, for one platform."""
    images = transfer.platforms(name)
    if platform not in images:
        text = f"{name} is for {listed(sorted(images)) or 'no platform'}, not for {platform}"
        remedy = f"name one that it has: --platform {min(images)}" if images else "name another image"
        raise RosmlError(text, remedy, exit_code=2)
    return images[platform]
