"""Shards: which machine of a run builds which images, so that all machines finish early, at about the same time.

A unit is a distribution on an architecture. Its ROS images build on one another, and its other images on one of those,
so no unit waits for another. Units share parts and operating systems. A shard installs each operating system once. If several
shards need a part, one of them builds it, and does so first; the others take it from the registry.

If a distribution needs more disk than a machine has (`runner_disk` in matrix.yaml), it becomes several units, by stack. The first one has its
ROS images, and the others take these from the registry, too.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby
from typing import Annotated

from pydantic import ConfigDict, Field

from rosml.base.errors import RosmlError
from rosml.base.problems import some
from rosml.base.shapes import Shape
from rosml.images.builds import disk
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix.sizes import Size
from rosml.images.publish.items import Key, ros_images

Names = Annotated[tuple[str, ...], Field(min_length=1)]
"""Names, at least one: an empty list would mean all."""


class Fact(Shape):
    """A piece of a plan, which one job writes and others read."""

    model_config = ConfigDict(frozen=True, strict=True)


class Estimates(Fact):
    """What a shard takes."""

    download_mb: int  # base images, Debian packages and wheels, compressed
    disk_mb: int  # disk space at the end, which is the peak, with the reserve; counted as in `builds/disk.py`
    seconds: int  # time to build and test: the measured time of the last run, or else an estimate by the matrix's rates


class Shard(Fact):
    """What one machine of a run builds."""

    name: str  # `amd64-1`; an architecture's longest shard has the number 1
    architecture: str
    platform: str  # such as `linux/amd64`
    runner: str  # label of the machines in CI
    distributions: tuple[str, ...]
    targets: Names  # in build order: for each distribution the ROS images from the lowest up, then the others
    parts: tuple[str, ...]  # names of the parts that its images have
    elsewhere: tuple[str, ...]  # names of those that another shard builds
    ros_elsewhere: tuple[str, ...]  # the ROS images below its images that another shard builds
    estimates: Estimates


Costs = dict[tuple[str, str], int]
"""Seconds by kind and name of what is built. Units share the items that they have in common."""


@dataclass(frozen=True)
class Work:
    """The work of a run, by target and architecture. The ROS images below an image are built with it."""

    images: frozenset[Key]  # the requested images that are built or tested
    built: frozenset[Key]  # images and parts to build or join
    tested: frozenset[Key]  # images to test
    seconds: Mapping[Key, Mapping[str, float]] = field(default_factory=dict)  # how long each step took the last time


@dataclass(frozen=True)
class Unit:
    """Images of a distribution on an architecture, in build order. One machine builds all of them."""

    distribution: str
    images: tuple[Image, ...]
    ros_elsewhere: tuple[Image, ...]  # the ROS images below, if another unit has them
    costs: Costs

    @property
    def name(self) -> str:
        return self.images[0].target


def deal(image_set: ImageSet, shards: int, work: Work) -> tuple[Shard, ...]:
    """Deals work to at most so many machines, but at least one for each architecture with work, and so many that each has enough disk;
    the longest shard first.

    Estimates of time count only work, those of download and disk whole images, since tests need these.
    """
    units = _units(image_set, work)
    return tuple(
        shard
        for architecture, share in _shares(image_set, units, shards).items()
        for shard in _dealt(image_set, architecture, units[architecture], share)
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


def _units(image_set: ImageSet, work: Work) -> dict[str, list[Unit]]:
    members: dict[str, dict[str, list[Image]]] = {name: {} for name in image_set.matrix.architectures}
    for image in image_set.images:
        for architecture in image.architectures:
            if (image.target, architecture) in work.images:
                members[architecture].setdefault(image.distribution, []).append(image)
    return {
        architecture: [
            unit
            for name, images in distributions.items()
            for unit in _of_distribution(image_set, name, images, architecture, work)
        ]
        for architecture, distributions in members.items()
        if distributions
    }


def _of_distribution(
    image_set: ImageSet, distribution: str, images: list[Image], architecture: str, work: Work
) -> Iterator[Unit]:
    """A distribution's units: several if one machine has too little disk for all of its images."""
    ordered = _ordered(image_set, images)
    limit = image_set.matrix.architectures[architecture].runner_disk
    pieces = [ordered] if limit is None or _disk_mb(image_set, ordered) <= limit else _pieces(image_set, ordered, limit)
    for number, piece in enumerate(pieces):
        ros_elsewhere = _ordered(image_set, piece)[: -len(piece)] if number else ()
        yield Unit(distribution, piece, ros_elsewhere, _costs(image_set, piece, architecture, work))


def _pieces(image_set: ImageSet, images: Sequence[Image], limit: int) -> list[tuple[Image, ...]]:
    """Images dealt into pieces that need at most so much disk, if no image alone needs more. The images of a stack stay together, as far
    as they can. The ROS images are in the first one."""
    pieces = [[image for image in images if image.stack is None]]
    joined = sorted((image for image in images if image.stack), key=lambda image: image.stack or "")

    def fits(more: Sequence[Image]) -> bool:
        return _disk_mb(image_set, _ordered(image_set, [*pieces[-1], *more])) <= limit

    for _, group in groupby(joined, key=lambda image: image.stack):
        members = list(group)
        if not fits(members):
            pieces.append([])
        for image in members:
            if pieces[-1] and not fits([image]):
                pieces.append([])
            pieces[-1].append(image)
    return [tuple(piece) for piece in pieces if piece]


def _costs(image_set: ImageSet, ordered: Sequence[Image], architecture: str, work: Work) -> Costs:
    rates = image_set.matrix.rates

    def measured(target: str, step: str) -> int | None:
        seconds = work.seconds.get((target, architecture), {}).get(step, 0)
        return math.ceil(seconds) if seconds >= 1 else None  # less than a second: it came from a cache

    def test(image: Image) -> int:
        carried = rates.carried if image.carriers[:1] == (image.target,) else 0
        seconds = measured(image.target, "test")
        return rates.test + carried if seconds is None else seconds

    ros = [image for image in ordered if image.stack is None and (image.target, architecture) in work.built]
    builds = {image.target: seconds for image in ros if (seconds := measured(image.target, "build")) is not None}
    packages = sum(_size_alone(image_set, image).unpacked for image in ros if image.target not in builds)
    tests = sum(test(image) for image in ordered if (image.target, architecture) in work.tested)
    seconds = _divided(packages, rates.packages) + sum(builds.values()) + tests
    costs: Costs = {("images", ordered[0].target): seconds}
    if any(image.parent not in image_set.by_target for image in ros):
        costs["os", ordered[0].os] = _divided(image_set.matrix.disk.os.unpacked, rates.packages)
    for part in (image_set.part_by_name[name] for name in _parts(ordered)):
        if (part.target, architecture) in work.built:
            build = measured(part.target, "build")
            costs["part", part.name] = _divided(part.disk.unpacked, rates.parts) if build is None else build
    return costs


def _ordered(image_set: ImageSet, images: Iterable[Image]) -> tuple[Image, ...]:
    images = list(images)
    chains = [link for image in images for link in ros_images(image_set, image)]
    return tuple({image.target: image for image in [*chains, *images]}.values())


def _size_alone(image_set: ImageSet, image: Image) -> Size:
    below = image_set.by_target.get(image.parent)
    return image.disk - (below.disk if below else image_set.matrix.disk.os)


def _parts(images: Iterable[Image]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(part for image in images for part in image.parts))


def _divided(megabytes: int, rate: int) -> int:
    return math.ceil(megabytes / rate)  # whole numbers compare the same on every machine


# ---- Shards ----------------------------------------------------------------------------------------------------------


def _seconds(units: Iterable[Unit], elsewhere: Collection[str] = ()) -> int:
    costs: Costs = {}
    for unit in units:
        costs |= unit.costs
    return sum(cost for (kind, name), cost in costs.items() if kind != "part" or name not in elsewhere)


def _shares(image_set: ImageSet, units: dict[str, list[Unit]], shards: int) -> dict[str, int]:
    """How many shards each architecture gets: at least one; each further one goes to the architecture that takes longest. Then as many more
    as it takes until each shard has enough disk."""
    shares = dict.fromkeys(units, 1)
    longest = {name: _seconds(members) for name, members in units.items()}
    while sum(shares.values()) < shards:
        growing = [name for name, members in units.items() if shares[name] < len(members)]
        if not growing:
            break
        name = max(growing, key=lambda name: longest[name])
        shares[name] += 1
        longest[name] = max(map(_seconds, _spread(units[name], shares[name])))
    for name, members in units.items():
        limit = image_set.matrix.architectures[name].runner_disk
        while limit is not None and shares[name] < len(members):
            if all(_disk_mb(image_set, _all_images(shard)) <= limit for shard in _spread(members, shares[name])):
                break
            shares[name] += 1
    return shares


def _dealt(image_set: ImageSet, architecture: str, units: list[Unit], share: int) -> list[Shard]:
    position = {unit.name: index for index, unit in enumerate(units)}
    contents = [sorted(shard, key=lambda unit: position[unit.name]) for shard in _spread(units, share)]
    contents = sorted(contents, key=lambda shard: (-_seconds(shard), position[shard[0].name]))
    elsewhere = _elsewhere(contents)
    dealt = sorted(zip(contents, elsewhere, strict=True), key=lambda shard: -_seconds(*shard))
    return [_shard(image_set, architecture, number, *shard) for number, shard in enumerate(dealt, 1)]


def _spread(units: list[Unit], share: int) -> list[list[Unit]]:
    """Deals units, the longest first, to the shard that finishes first with it; of equal ones, to where it adds least."""
    shards: list[list[Unit]] = [[] for _ in range(share)]
    shared: list[Costs] = [{} for _ in range(share)]
    loads = [0] * share
    for unit in sorted(units, key=lambda unit: -sum(unit.costs.values())):
        growths = [sum(cost for key, cost in unit.costs.items() if key not in costs) for costs in shared]
        best = min(range(share), key=lambda index: (loads[index] + growths[index], growths[index]))
        shards[best].append(unit)
        shared[best] |= unit.costs
        loads[best] += growths[best]
    return shards


def _elsewhere(shards: Sequence[Sequence[Unit]]) -> list[set[str]]:
    """For each shard the names of the parts that another one builds: the longest part goes to the shard that has least to build."""
    needed: dict[str, list[int]] = {}
    seconds = dict[str, int]()
    for index, units in enumerate(shards):
        parts = {name: cost for unit in units for (kind, name), cost in unit.costs.items() if kind == "part"}
        seconds |= parts
        for name in parts:
            needed.setdefault(name, []).append(index)
    loads, elsewhere = [0] * len(shards), [set[str]() for _ in shards]
    for name in sorted(needed, key=lambda name: (-seconds[name], name)):
        builder = min(needed[name], key=lambda index: loads[index])
        loads[builder] += seconds[name]
        for index in needed[name]:
            if index != builder:
                elsewhere[index].add(name)
    return elsewhere


def _shard(
    image_set: ImageSet, architecture: str, number: int, units: Sequence[Unit], elsewhere: Collection[str]
) -> Shard:
    images, targets = _all_images(units), tuple(image.target for unit in units for image in unit.images)
    parts = _parts(images)
    systems = {image.os for image in images}
    sizes = [
        *(image_set.matrix.disk.os for _ in systems),
        *(_size_alone(image_set, image) for image in images if image.stack is None),
        *(image_set.part_by_name[name].disk for name in parts),
    ]
    return Shard(
        name=f"{architecture}-{number}",
        architecture=architecture,
        platform=image_set.matrix.architectures[architecture].platform,
        runner=_runner(image_set, architecture),
        distributions=tuple(dict.fromkeys(unit.distribution for unit in units)),
        targets=targets,
        parts=parts,
        elsewhere=tuple(name for name in parts if name in elsewhere),
        ros_elsewhere=tuple(image.target for image in images if image.target not in targets),
        estimates=Estimates(
            download_mb=sum(size.compressed for size in sizes),
            disk_mb=_disk_mb(image_set, images),
            seconds=_seconds(units, elsewhere),
        ),
    )


def _all_images(units: Iterable[Unit]) -> list[Image]:
    """The images of some units, and the ROS images below them."""
    return [*{image.target: image for unit in units for image in (*unit.ros_elsewhere, *unit.images)}.values()]


def too_large(image_set: ImageSet, shards: Iterable[Shard]) -> Iterator[str]:
    """Says which images alone need more disk than their machine has: no plan can deal them smaller."""
    for shard in shards:
        limit = image_set.matrix.architectures[shard.architecture].runner_disk
        if limit is None or shard.estimates.disk_mb <= limit:
            continue
        needs = {
            target: _disk_mb(image_set, _ordered(image_set, [image_set.by_target[target]])) for target in shard.targets
        }
        large = [f"{target} ({disk.gigabytes(need)})" for target, need in needs.items() if need > limit]
        yield (
            f"{shard.name} has {disk.gigabytes(limit)} of disk by matrix.yaml, and that is too little for {some(large)};"
            f" name larger machines there: 'runner' and 'runner_disk' of architectures.{shard.architecture}"
        )


def _disk_mb(image_set: ImageSet, images: Iterable[Image]) -> int:
    total, built = disk.RESERVE_MB, set[str]()
    for image in images:
        total += disk.needed_mb(image_set, image, built)
        built.update((image.parent, image.target, *image.parts))
    return total
