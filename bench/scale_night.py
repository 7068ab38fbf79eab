"""A night at scale, by simulation: the usual way, in which each image is built with `RUN pip install` and each app on its new base image,
beside ours. Images, parts, sizes and shards are those of the project's matrix, with more stacks and distributions like the real ones.

Events are steps of machines, requests and pulls. A registry lets through so many requests a minute; clients wait and ask again as ours does.
"""

from __future__ import annotations

import copy
import heapq
import itertools
import math
import random
from collections import Counter, OrderedDict
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from bench.scale_facts import STEPS, fact
from rosml import ROOT
from rosml.base.side_by_side import AT_ONCE
from rosml.images.builds import disk
from rosml.images.image_set import load
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import combinations, source
from rosml.images.matrix.sizes import Size
from rosml.images.publish.prune import Pruner
from rosml.images.publish.shards import Shard, Work, deal
from rosml.images.publish.steps import join
from rosml.machine.setup import builder_cache
from rosml.registry import retries

USUAL, MOVED, LOCKS = WAYS = ("usual", "here", "here, with new locks")
"""In all nights the packages of all distributions have changed. In the last one all locks have, so that all parts are built."""

PULLS = 100_000
"""Of more pulls than these, several of the same image count as one event."""

Process = Iterator[float]
"""What somebody does: gives the seconds until it goes on."""


@dataclass(frozen=True)
class Load:
    """What a night has to bear.

    Attributes:
        images, stacks: of the image set.
        pulls, apps: pulls while people work, and apps that get new base images.
        machines: for shards, and for apps that are built again.
        disk_mb, speed: of each machine: the builder's disk, and how many times faster it is than the one with two cores that was measured.
        limited: whether the registry limits requests as ghcr.io does.
        app_minutes, days: what the job that moves apps may take, and how long `prune` keeps dated tags.
        held: the share of pulls by clients that have yesterday's image.
        seed: of all that is random.
    """

    images: int = 2_000
    stacks: int = 20
    pulls: int = 50_000
    apps: int = 10_000
    machines: int = 24
    disk_mb: int = 72_000
    speed: float = 1.0
    limited: bool = True
    app_minutes: float = fact("minutes of rebase")
    days: int = Pruner.days
    held: float = 0.7
    seed: int = 1


# ---- The image set ---------------------------------------------------------------------------------------------------


@cache
def scaled(images: int, stacks: int) -> ImageSet:
    """The project's image set with copies of stacks, then of distributions, and so many of its images."""
    document = source.read(ROOT / "matrix.yaml")
    for architecture in document.data["architectures"].values():
        architecture.pop("runner_disk")  # the load says how many machines there are, however small their disks
    real = list(document.data["stacks"])
    for number in range(stacks - len(real)):
        name = real[number % len(real)]
        _copy(document.data, name, f"{name}x{number // len(real) + 2}")
    whole, distributions = load.image_set(document), list(document.data["distributions"])
    cycle, done = len(whole.images), 1
    while (missing := images - len(whole.images)) > 0:
        for number in range(done + 1, done + 1 + math.ceil(missing / cycle)):
            for name in distributions:
                _copy(document.data, name, f"{name}-{number}")
                document.data["distributions"][f"{name}-{number}"].pop("aliases", None)
            done = number
        whole = load.image_set(document)
    return _thinned(whole, images)


def _thinned(whole: ImageSet, images: int) -> ImageSet:
    """An image set with so many images: those of ROS, one for each part, and of the others as many of each kind as there is room for."""
    kept = {image.target for image in whole.images if image.stack is None}
    kept |= set({name: image.target for image in whole.images for name in image.parts}.values())
    others = [image.target for image in whole.images if image.target not in kept]
    room = max(0, min(images - len(kept), len(others)))
    kept |= {others[number * len(others) // room] for number in range(room)}
    return replace(whole, images=tuple(image for image in whole.images if image.target in kept))


def _copy(data: Any, name: str, twin: str) -> None:
    """Adds an entry like another one wherever a mapping has that one."""
    if isinstance(data, dict):
        for value in list(data.values()):
            _copy(value, name, twin)
        if name in data:
            data[twin] = copy.deepcopy(data[name])


# ---- Machines and the registry ---------------------------------------------------------------------------------------


@dataclass
class Bucket:
    """A limit of so many requests a second, of which a minute's may come at once."""

    rate: float
    at: float = 0.0
    tokens: float = math.inf

    def take(self, now: float, requests: int) -> int:
        """How many of some requests go through now."""
        most = self.rate * 60 * fact("burst in minutes")
        self.tokens, self.at = min(most, self.tokens + (now - self.at) * self.rate), now
        granted = min(requests, int(self.tokens))
        self.tokens -= granted
        return granted


@dataclass
class Disk:
    """A builder's disk in MB. The builder prunes what was used longest ago: before a step so much that there is room for it, and after it as
    the limits of `builder_cache` say."""

    size: int
    held: OrderedDict[str, int] = field(default_factory=OrderedDict)
    peak: int = 0

    def hold(self, entries: Mapping[str, int], beside: int = 0) -> list[str]:
        """Holds entries at once, and for the moment some MB beside them. Gives those that were missing."""
        missing = [name for name in entries if name not in self.held]
        new = sum(entries[name] for name in missing) + beside
        self._prune(self.size - disk.RESERVE_MB - new, entries)
        for name in entries:
            self.held[name] = entries[name]
            self.held.move_to_end(name)
        self.peak = max(self.peak, sum(self.held.values()) + beside)
        half = max(builder_cache.SMALLEST * 1000, min(builder_cache.LARGEST * 1000, self.size // 2))
        self._prune(min(half, self.size - builder_cache.FREE * 1000), {})
        return missing

    def _prune(self, most: int, but: Mapping[str, int]) -> None:
        used = sum(self.held.values())
        for name in [name for name in self.held if name not in but]:
            if used <= most:
                break
            used -= self.held.pop(name)


@dataclass
class Night:
    """One night.

    Attributes:
        stored: new bytes in the registry by what they are of. egress: bytes of pulls. fetched: bytes that machines get from the registry,
            or from the index of wheels.
        steps: how often each step was done. minutes: requests by the minute. refused: answers 429. failed: requests refused too often.
        shards: seconds of each shard. phases: seconds of each phase. disks: of the machines.
    """

    load: Load
    way: str
    image_set: ImageSet
    stored: dict[tuple[str, str], float] = field(default_factory=dict)
    egress: float = 0.0
    fetched: float = 0.0
    steps: Counter[str] = field(default_factory=Counter)
    minutes: Counter[int] = field(default_factory=Counter)
    refused: int = 0
    failed: int = 0
    shards: dict[str, float] = field(default_factory=dict)
    phases: dict[str, float] = field(default_factory=dict)
    disks: list[Disk] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.now, self._random, self._number = 0.0, random.Random(self.load.seed), itertools.count()
        self._heap: list[tuple[float, int, str, Process]] = []
        self._open: Counter[str] = Counter()
        self._together = 1 + self.load.pulls // PULLS
        rates = {name: fact(f"{name} a minute") / 60 if self.load.limited else 1e9 for name in ("reads", "writes")}
        self._buckets = {name: Bucket(rate) for name, rate in rates.items()}
        self._ros = {image.target: _ros_sizes(self.image_set, image) for image in self.image_set.images}

    # ---- Results

    @property
    def new_bytes(self) -> float:
        """Bytes that the registry gets."""
        return sum(self.stored.values())

    @property
    def machine_minutes(self) -> float:
        """Of shards, of the jobs after them, and of what builds apps."""
        apps = self.load.machines if self.way == USUAL else 1
        return (sum(self.shards.values()) + self.phases["promote"] + apps * self.phases["apps"]) / 60

    @property
    def tags(self) -> int:
        """Tags of the largest repository: the dated ones until `prune` takes them, and the others."""
        count: Counter[str] = Counter()
        for image in self.image_set.images:
            count[image.repository] += len(image.tags) + (self.load.days if image.tags else 0)
        return max(count.values())

    # ---- The night

    def run(self) -> Night:
        """Goes through all events."""
        things = [*self.image_set.images, *(self.image_set.parts if self.way == LOCKS else ())]
        todo, apps = iter(things), iter(range(self.load.apps))
        threads = self.load.machines if self.way == USUAL else AT_ONCE
        phases: list[tuple[str, Callable[[], Iterable[Process]]]] = [
            ("images", lambda: [self._machine(shard) for shard in self._deal()]),
            ("promote", lambda: [self._promote(todo) for _ in range(AT_ONCE)]),
            ("apps", lambda: [self._apps(apps) for _ in range(threads)]),
        ]
        weights = list(itertools.accumulate(1 / rank for rank in range(1, len(self.image_set.images) + 1)))
        images = self._random.sample(self.image_set.images, len(self.image_set.images))
        hours = fact("hours of pulls") * 3600
        times = sorted(self._random.triangular(0, hours) for _ in range(self.load.pulls // self._together))
        pulled = self._random.choices(images, cum_weights=weights, k=len(times))
        self._start("pulls", self._pulls(zip(times, pulled, strict=True)))
        for name, processes in phases:
            began = self.now
            for process in processes():
                self._start(name, process)
            self._until(name)
            self.phases[name] = self.now - began
        self._until("pulls")
        return self

    def _start(self, phase: str, process: Process) -> None:
        self._open[phase] += 1
        heapq.heappush(self._heap, (self.now, next(self._number), phase, process))

    def _until(self, awaited: str) -> None:
        """Goes through events until all processes of a phase have ended."""
        while self._open[awaited]:
            self.now, _, phase, process = heapq.heappop(self._heap)
            if (seconds := next(process, None)) is None:
                self._open[phase] -= 1
            else:
                heapq.heappush(self._heap, (self.now + seconds, next(self._number), phase, process))

    def _do(self, step: str, seconds: float = 0.0, times: int = 1) -> Process:
        """A step: its requests, and its time, which is at least that of its requests one after the other."""
        self.steps[step] += times
        reads, writes = STEPS[step].reads * times, STEPS[step].writes * times
        yield from self._ask("reads", reads)
        yield from self._ask("writes", writes)
        yield max(seconds / self.load.speed, (reads + writes) * fact("seconds of a request"))

    def _ask(self, kind: str, count: int) -> Process:
        """Requests. One that is refused is sent again after a pause, as `retries.pause` has it."""
        attempt = 0
        while count:
            granted = self._buckets[kind].take(self.now, count)
            count -= granted
            self.minutes[int(self.now // 60)] += granted + bool(count)
            if count:
                self.refused += 1
                attempt = 1 if granted else attempt + 1
                if attempt >= retries.ATTEMPTS:
                    self.failed += 1
                    return
                pause = retries.WAIT * 2 ** (attempt - 1) + self._random.uniform(0, retries.WAIT)
                yield min(pause, retries.LONGEST_WAIT)

    # ---- Machines

    def _deal(self) -> tuple[Shard, ...]:
        """The shards, dealt by the times that this way takes."""
        keys = {(image.target, name): image for image in self.image_set.images for name in image.architectures}
        parts = {(part.target, name) for part in self.image_set.parts for name in part.architectures}
        times = {key: {"test": self._pip(image) + self._test(image)} for key, image in keys.items()}
        builds = frozenset({*keys, *(parts if self.way == LOCKS else ())})
        work = Work(frozenset(keys), builds, frozenset(keys), times if self.way == USUAL else {})
        return deal(self.image_set, self.load.machines, work)

    def _pip(self, image: Image) -> float:
        return fact("pip seconds") * self._parts(image).unpacked / fact("pip unpacked MB")

    def _pip_bytes(self, image: Image) -> float:
        return fact("pip bytes") * self._parts(image).compressed / fact("pip compressed MB")

    def _parts(self, image: Image) -> Size:
        return Size.total(*(self.image_set.part_by_name[name].disk for name in image.parts))

    def _test(self, image: Image) -> float:
        rates = self.image_set.matrix.rates
        return rates.test + (rates.carried if image.carriers[:1] == (image.target,) else 0)

    def _machine(self, shard: Shard) -> Process:
        """A shard in the order of its steps: its own parts, ROS images, parts that another shard has not built by then, images that run tests
        for others, the others. Each image is tested at once."""
        began, place = self.now, Disk(self.load.disk_mb)
        self.disks.append(place)
        yield from self._do("survey", times=len(shard.targets) + len(shard.parts))
        images = [self.image_set.image(target) for target in shard.targets]
        for name in [name for name in shard.parts if name not in shard.elsewhere and self.way == LOCKS]:
            yield from self._part(name, shard.architecture, place)
        for image in [image for image in images if image.stack is None]:
            yield from self._build(image, shard.architecture, place)
        for name in shard.elsewhere:
            if ("part", f"{name} {shard.architecture}") not in self.stored:
                yield from self._part(name, shard.architecture, place)
        joined = [image for image in images if image.stack]
        for image in sorted(joined, key=join.order):
            yield from (self._usual if self.way == USUAL else self._joined)(image, shard.architecture, place)
        self.shards[shard.name] = self.now - began

    def _part(self, name: str, architecture: str, place: Disk) -> Process:
        part = self.image_set.part_by_name[name]
        place.hold({part.name: disk.part_mb(part)})
        yield from self._do("build", part.disk.unpacked / self.image_set.matrix.rates.parts)
        self.steps["part"] += 1
        self._store("part", part.name, architecture, part.disk.compressed * 1e6 + STEPS["build"].sent)

    def _build(self, image: Image, architecture: str, place: Disk) -> Process:
        """A ROS image, with the operating system if it is the first one on it."""
        for name in place.hold(self._ros_mb(image)):
            size = self._ros[image.target][name]
            yield from self._do("build", size.unpacked / self.image_set.matrix.rates.packages)
            self._store("ROS", name, architecture, size.compressed * 1e6 + STEPS["build"].sent + fact("SBOM bytes"))
        yield from self._tested(image, architecture)

    def _joined(self, image: Image, architecture: str, place: Disk) -> Process:
        """A join, and a test, for which the builder fetches what it has pruned, or never had."""
        yield from self._do("join", fact("join seconds"))
        self._store("image", image.target, architecture, STEPS["join"].sent + fact("SBOM bytes"))
        parts = {name: self.image_set.part_by_name[name].disk for name in image.parts}
        sizes = {**self._ros[image.target], **parts}
        unpacked = {name: size.unpacked + size.compressed for name, size in parts.items()}
        for name in place.hold({**self._ros_mb(image), **unpacked}):
            self.fetched += sizes[name].compressed * 1e6
            yield from self._do("fetch", sizes[name].unpacked / self.image_set.matrix.rates.parts)
        yield from self._tested(image, architecture)

    def _usual(self, image: Image, architecture: str, place: Disk) -> Process:
        """`RUN pip install`: a layer of its own, and all wheels beside it until it is pushed."""
        size, layer = self._parts(image), self._pip_bytes(image)
        place.hold({**self._ros_mb(image), image.target: size.unpacked + 2 * size.compressed}, size.compressed)
        self.fetched += layer
        yield from self._do("push", self._pip(image))
        self.steps["pip"] += 1
        self._store("image", image.target, architecture, layer)
        yield from self._tested(image, architecture)

    def _tested(self, image: Image, architecture: str) -> Process:
        yield from self._do("test", self._test(image))
        self._store("test", image.target, architecture, STEPS["test"].sent)

    def _ros_mb(self, image: Image) -> dict[str, int]:
        """What a builder holds of the ROS images of an image: as `builds/disk.py` counts it."""
        return {name: size.unpacked + 2 * size.compressed for name, size in self._ros[image.target].items()}

    def _store(self, what: str, name: str, architecture: str, count: float) -> None:
        """Bytes for the registry, which keeps what it has once."""
        self.stored[what, f"{name} {architecture}"] = count

    def _promote(self, things: Iterator[Any]) -> Process:
        """A thread of the steps that make indexes and move tags."""
        for thing in things:
            for step in ("push",) if self.way == USUAL else ("index", "promote"):
                yield from self._do(step)
                self._store(step, thing.target, "", STEPS[step].sent)

    def _apps(self, apps: Iterator[int]) -> Process:
        """A thread of `rosml rebase --all`, of which all together are as fast as was measured; or a machine that builds one by one."""
        for app in apps:
            usual = self.way == USUAL
            self._store("app", str(app), "", fact("app bytes") if usual else fact("rebase bytes") + fact("SBOM bytes"))
            if usual:
                yield from self._do("push", fact("containerize seconds"))
            else:
                yield from self._do("rebase", AT_ONCE * fact("rebase seconds"))

    def _pulls(self, pulls: Iterable[tuple[float, Image]]) -> Process:
        """Starts each pull at its time."""
        for at, image in pulls:
            yield max(0.0, at - self.now)
            self._start("pulls", self._pull(image))

    def _pull(self, image: Image) -> Process:
        """Pulls: what of the image the client lacks. In all ways ROS has changed; by the usual way what stands on it has, too."""
        ros, parts = (
            size.compressed * 1e6 for size in (Size.total(*self._ros[image.target].values()), self._parts(image))
        )
        if self.way == USUAL:
            parts = self._pip_bytes(image)
        kept = self.way == MOVED and self._random.random() < self.load.held
        layers = len(self._ros[image.target]) + (0 if kept else 1 if self.way == USUAL else len(image.parts))
        yield from self._ask("reads", self._together * (int(fact("requests of a pull")) + layers))
        self.egress += self._together * (ros + (0 if kept else parts))


def _ros_sizes(image_set: ImageSet, image: Image) -> dict[str, Size]:
    """The operating system and the ROS images that an image has, each without what is below it."""
    sizes: dict[str, Size] = {}
    below: Image | None = image_set.by_target[image.parent if image.stack else image.target]
    while below:
        lower = image_set.by_target.get(below.parent)
        base = lower.disk if lower else combinations.system_size(image_set.matrix, below.component)
        sizes[below.target] = below.disk - base
        if not lower:
            sizes[below.parent] = base
        below = lower
    return dict(reversed(sizes.items()))
