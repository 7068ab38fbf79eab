"""Shards: which machine of a run builds which images, so that all of them are ready soon, at the same time.

What is dealt out are units, a distribution on an architecture: its ROS images stand on one another, and all its other
images on one of those, so that no unit builds what another one has to wait for. Parts and operating systems are
shared between units: a shard assembles them once, however many of its units need them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

from rosml.base.errors import RosmlError
from rosml.images.builds import disk
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix.model import Size

Named = Annotated[tuple[str, ...], Field(min_length=1)]
"""Names of what is meant: none would mean all that there are."""


class Fact(BaseModel):
    """Something that a plan says; it is written by one job and read by others."""

    model_config = ConfigDict(frozen=True, strict=True)


class Estimates(Fact):
    """What a shard takes.

    Attributes:
        download_mb: what the network brings: base images, Debian packages and wheels, compressed.
        disk_mb: room that it needs at its peak, which is its end, with the reserve; counted as `machine/disk.py` counts.
        seconds: time of building and testing: what each took the last time, or else by the matrix' rates.
    """

    download_mb: int
    disk_mb: int
    seconds: int


class Shard(Fact):
    """What one machine of a run builds.

    Attributes:
        name: `amd64-1`; an architecture's longest shard has the number 1.
        architecture: under BuildKit's name. platform: the same as BuildKit calls it.
        runner: label of the machines in CI.
        distributions: what it builds, in the order of the matrix.
        targets: bake targets in build order: of each distribution the ROS images from the lowest up, then the others.
        parts: names of the parts that it assembles.
    """

    name: str
    architecture: str
    platform: str
    runner: str
    distributions: tuple[str, ...]
    targets: Named
    parts: tuple[str, ...]
    estimates: Estimates


Costs = dict[tuple[str, str], int]
"""Seconds by what is built: its kind and its name. What two units both have, they share."""


@dataclass(frozen=True)
class Work:
    """What is to be done, by target and architecture.

    Attributes:
        made: images and parts that are built or joined. tested: images whose tests run.
        seconds: what each step took the last time, where that is known.
    """

    made: frozenset[tuple[str, str]]
    tested: frozenset[tuple[str, str]]
    seconds: Mapping[tuple[str, str], Mapping[str, float]] = field(default_factory=dict)


@dataclass(frozen=True)
class Unit:
    """What one machine has to build: a distribution's images on an architecture, in build order."""

    distribution: str
    images: tuple[Image, ...]
    costs: Costs


def deal(
    image_set: ImageSet, shards: int, include: Callable[[Image], bool] = lambda image: True, work: Work | None = None
) -> tuple[Shard, ...]:
    """Deals the images of a set out to machines: by architecture, the longest shard first.

    Args:
        image_set: all that the matrix describes.
        shards: how many machines there are at most; but each architecture that something is built for gets one.
        include: whether an image is built. The ROS images that it stands on are built with it.
        work: what is to be done; images and architectures without any get no machine, and times count nothing else. All that
            is included if None. What a machine fetches and keeps is counted whole: tests need all of an image.

    Raises:
        RosmlError: the matrix does not say where an architecture is built (exit code 2).
    """
    units = _units(image_set, include, work)
    return tuple(
        _shard(image_set, architecture, number, content)
        for architecture, share in _shares(units, shards).items()
        for number, content in enumerate(_dealt(units[architecture], share), 1)
    )


def _runner(image_set: ImageSet, architecture: str) -> str:
    if runner := image_set.matrix.architectures[architecture].runner:
        return runner
    raise RosmlError(
        f"matrix.yaml: architectures.{architecture}: 'runner' is missing: the label of CI's machines",
        "add it, such as 'runner: ubuntu-24.04'",
        exit_code=2,
    )


# ---- Units -----------------------------------------------------------------------------------------------------------


def _units(image_set: ImageSet, include: Callable[[Image], bool], work: Work | None) -> dict[str, list[Unit]]:
    """Units by architecture, both in the order of the matrix; architectures without any are left out."""
    members: dict[str, dict[str, list[Image]]] = {name: {} for name in image_set.matrix.architectures}
    for image in filter(include, image_set.images):
        for architecture in image.architectures:
            if work is None or (image.target, architecture) in work.made | work.tested:
                members[architecture].setdefault(image.distribution, []).append(image)
    return {
        architecture: [_unit(image_set, name, images, architecture, work) for name, images in distributions.items()]
        for architecture, distributions in members.items()
        if distributions
    }


def _unit(image_set: ImageSet, distribution: str, images: list[Image], architecture: str, work: Work | None) -> Unit:
    rates = image_set.matrix.rates
    ordered = _ordered(image_set, images)

    def made(target: str) -> bool:
        return work is None or (target, architecture) in work.made

    def took(target: str, step: str) -> int | None:
        found = work.seconds.get((target, architecture), {}).get(step) if work else None
        return math.ceil(found) if found and found >= 1 else None  # what was in a cache says nothing

    def test(image: Image) -> int:
        carried = rates.carried if image.carriers[:1] == (image.target,) else 0
        known = took(image.target, "test")
        return rates.test + carried if known is None else known

    ros = [image for image in ordered if image.stack is None and made(image.target)]
    known = {image.target: seconds for image in ros if (seconds := took(image.target, "build")) is not None}
    packages = sum(_own(image_set, image).unpacked for image in ros if image.target not in known)
    tests = sum(test(image) for image in ordered if work is None or (image.target, architecture) in work.tested)
    seconds = _divided(packages, rates.packages) + sum(known.values()) + tests
    costs: Costs = {("distribution", distribution): seconds}
    if any(image.parent not in image_set.by_target for image in ros):
        costs["os", ordered[0].os] = _divided(image_set.matrix.disk.os.unpacked, rates.packages)
    for part in (image_set.part_by_name[name] for name in _parts(ordered)):
        if made(part.target):
            known_part = took(part.target, "build")
            costs["part", part.name] = _divided(part.disk.unpacked, rates.parts) if known_part is None else known_part
    return Unit(distribution, ordered, costs)


def _ordered(image_set: ImageSet, images: Iterable[Image]) -> tuple[Image, ...]:
    """Images in build order, with the ROS images that they stand on, which come first."""
    images = list(images)
    chains = [link for image in images for link in _chain(image_set, image)]
    return tuple({image.target: image for image in [*chains, *images]}.values())


def _chain(image_set: ImageSet, image: Image) -> list[Image]:
    """The ROS images that an image stands on, lowest first, and the image itself if it is one."""
    chain = [] if image.stack else [image]
    while below := image_set.by_target.get(image.parent):
        chain.append(below)
        image = below
    return chain[::-1]


def _own(image_set: ImageSet, image: Image) -> Size:
    """Size of a ROS image without what it stands on."""
    below = image_set.by_target.get(image.parent)
    return image.disk - (below.disk if below else image_set.matrix.disk.os)


def _parts(images: Iterable[Image]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(part for image in images for part in image.parts))


def _divided(megabytes: int, rate: int) -> int:
    """Seconds, rounded up: whole numbers compare the same everywhere."""
    return math.ceil(megabytes / rate)


# ---- Shards ----------------------------------------------------------------------------------------------------------


def _seconds(units: Iterable[Unit]) -> int:
    """Time of units on one machine: what they share is built once."""
    costs: Costs = {}
    for unit in units:
        costs |= unit.costs
    return sum(costs.values())


def _shares(units: dict[str, list[Unit]], shards: int) -> dict[str, int]:
    """How many shards each architecture gets: one, and every further one goes to that which takes longest."""
    shares = dict.fromkeys(units, 1)
    longest = {name: _seconds(members) for name, members in units.items()}
    while sum(shares.values()) < shards:
        growing = [name for name, members in units.items() if shares[name] < len(members)]
        if not growing:
            break
        name = max(growing, key=lambda name: longest[name])
        shares[name] += 1
        longest[name] = max(map(_seconds, _spread(units[name], shares[name])))
    return shares


def _dealt(units: list[Unit], share: int) -> list[list[Unit]]:
    """The contents of an architecture's shards, longest first; within a shard in the order of the matrix."""
    shards = _spread(units, share)
    position = {unit.distribution: index for index, unit in enumerate(units)}
    sort = [sorted(shard, key=lambda unit: position[unit.distribution]) for shard in shards]
    return sorted(sort, key=lambda shard: (-_seconds(shard), position[shard[0].distribution]))


def _spread(units: list[Unit], share: int) -> list[list[Unit]]:
    """Longest unit first, each to the shard that is done soonest with it, and of those to where it adds least."""
    shards: list[list[Unit]] = [[] for _ in range(share)]
    known: list[Costs] = [{} for _ in range(share)]
    loads = [0] * share
    for unit in sorted(units, key=lambda unit: -sum(unit.costs.values())):
        growths = [sum(cost for key, cost in unit.costs.items() if key not in costs) for costs in known]
        best = min(range(share), key=lambda index: (loads[index] + growths[index], growths[index]))
        shards[best].append(unit)
        known[best] |= unit.costs
        loads[best] += growths[best]
    return shards


def _shard(image_set: ImageSet, architecture: str, number: int, units: list[Unit]) -> Shard:
    images = [image for unit in units for image in unit.images]
    parts = _parts(images)
    systems = {image.os for image in images}
    sizes = [
        *(image_set.matrix.disk.os for _ in systems),
        *(_own(image_set, image) for image in images if image.stack is None),
        *(image_set.part_by_name[name].disk for name in parts),
    ]
    return Shard(
        name=f"{architecture}-{number}",
        architecture=architecture,
        platform=image_set.matrix.architectures[architecture].platform,
        runner=_runner(image_set, architecture),
        distributions=tuple(unit.distribution for unit in units),
        targets=tuple(image.target for image in images),
        parts=parts,
        estimates=Estimates(
            download_mb=sum(size.compressed for size in sizes),
            disk_mb=_disk_mb(image_set, images),
            seconds=_seconds(units),
        ),
    )


def _disk_mb(image_set: ImageSet, images: list[Image]) -> int:
    total, built = disk.RESERVE_MB, set[str]()
    for image in images:
        total += disk.needed_mb(image_set, image, built)
        built.update((image.parent, image.target, *image.parts))
    return total
