"""A night at scale beside the usual way, and which limit a growing load breaks first: by the simulation in `scale_night`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from bench.results import Result, Row
from bench.scale_facts import fact
from bench.scale_night import MOVED, WAYS, Load, Night, scaled
from rosml.images.builds import disk
from rosml.images.image_set.model import ImageSet
from rosml.registry import transport

Knob = tuple[str, Callable[[Load], Load]]
"""A setting of the project, and what it makes of a night."""

SHARDS: Knob = ("ROSML_SHARDS", lambda load: replace(load, machines=2 * load.machines))
RUNNER: Knob = ("architectures.*.runner", lambda load: replace(load, speed=2 * load.speed, disk_mb=2 * load.disk_mb))
REGISTRY: Knob = ("ROSML_REGISTRY", lambda load: replace(load, limited=False))
TIMEOUT: Knob = ("timeout-minutes", lambda load: replace(load, app_minutes=350))
PRUNE: Knob = ("rosml publish prune --days", lambda load: replace(load, days=load.days // 4))


@dataclass(frozen=True)
class Limit:
    """A limit of a night.

    Attributes:
        what: it says. knobs: what may help, the cheapest first.
        share: how much of it a night takes; more than 1 is too much.
    """

    what: str
    knobs: tuple[Knob, ...]
    share: Callable[[Night], float]


LIMITS = (
    Limit("minutes of a shard", (SHARDS, RUNNER), lambda night: longest(night) / fact("minutes of a shard")),
    Limit("disk of a machine", (RUNNER,), lambda night: _disk(night) / (night.load.disk_mb - disk.RESERVE_MB)),
    Limit(
        "minutes of the job that moves tags",
        (REGISTRY,),
        lambda night: night.phases["promote"] / 60 / fact("minutes of promote"),
    ),
    Limit(
        "minutes of the job that moves apps",
        (TIMEOUT, REGISTRY),
        lambda night: night.phases["apps"] / 60 / night.load.app_minutes,
    ),
    Limit("requests that the registry refuses for good", (REGISTRY,), lambda night: 1 + night.failed),
    Limit("pages of a list of tags", (PRUNE,), lambda night: night.tags / fact("tags on a page") / transport.PAGES),
)
"""A night that takes more than 1 of one of them breaks it. They are those of the workflows, the client and the registry."""


def longest(night: Night) -> float:
    """Minutes of the shard that takes longest."""
    return max(night.shards.values()) / 60


def _disk(night: Night) -> int:
    return max(place.peak for place in night.disks)


@dataclass(frozen=True)
class Growth:
    """How one load grows from night to night.

    Attributes:
        what: the load, as `Load` has it.
        unit: it is in, for people.
        first, factor: its first value, and the factor between two nights.
        beside: other loads of these nights.
    """

    what: str
    unit: str
    first: int
    factor: float
    beside: Mapping[str, int] = field(default_factory=lambda: {"pulls": 0, "apps": 0})


GROWTHS = (
    Growth("images", "images, of 20 stacks", 1_000, 1.25),
    Growth("stacks", "stacks, with 100 images each", 10, 1.25),
    Growth("pulls", "pulls", 100_000, 2, {"images": 500, "apps": 0}),
    Growth("apps", "apps", 2_500, 1.25, {"images": 500, "pulls": 0}),
    Growth(
        "disk_mb", "MB of disk of a machine, for 1,000 images", 72_000, 0.75, {"images": 1_000, "pulls": 0, "apps": 0}
    ),
)
"""What is tried for the limits. The disk shrinks."""


def broken(night: Night) -> list[Limit]:
    """The limits that a night breaks, the one that it exceeds most first."""
    return sorted((limit for limit in LIMITS if limit.share(night) > 1), key=lambda limit: -limit.share(night))


def simulate(load: Load, way: str, image_set: ImageSet | None = None) -> Night:
    """A night by a way, with an image set of the load's size unless another one is given."""
    return Night(load, way, image_set or scaled(load.images, load.stacks)).run()


@dataclass(frozen=True)
class Broken:
    """Which limit a growing load breaks first: the last value that fits, the first that does not, and the knob that helps."""

    fits: int | None
    breaks: int | None
    limit: str
    knob: str


def grown(load: Load, growth: Growth, nights: int = 16) -> Broken:
    """Lets one load grow until a night breaks a limit, and tries the knobs of that limit."""
    fits, value = None, growth.first
    for _ in range(nights):
        more: dict[str, Any] = {**growth.beside, growth.what: value}
        if growth.what == "stacks":
            more["images"] = 100 * value
        night = replace(load, **more)
        if limits := broken(simulate(night, MOVED)):
            return Broken(fits, value, limits[0].what, _helping(night, limits[0]))
        fits, value = value, int(value * growth.factor)
    return Broken(fits, None, "none", "")


def _helping(load: Load, limit: Limit) -> str:
    """The first knob by which a night keeps a limit; empty if none helps."""
    image_set = scaled(load.images, load.stacks)
    nights = ((name, simulate(turned(load), MOVED, image_set)) for name, turned in limit.knobs)
    return next((name for name, night in nights if limit not in broken(night)), "")


# ---- Results ---------------------------------------------------------------------------------------------------------


def measure(load: Load, command: str, say: Callable[[str], None]) -> tuple[Result, Result]:
    """Simulates a night by each way, and then nights that grow."""
    nights = []
    for way in WAYS:
        say(f"a night of {load.images:,} images: {way}")
        nights.append(simulate(load, way))
    rows = []
    for growth in GROWTHS:
        say(f"nights that differ in {growth.what}")
        first = grown(load, growth)
        rows.append(Row(growth.unit, (first.fits, first.breaks), "", first.limit, command=first.knob))
    return Result("scale", command, WAYS, table(nights)), Result("scale-limits", command, ("fits", "breaks"), rows)


def table(nights: Sequence[Night]) -> list[Row]:
    """The rows of nights by all ways."""
    usual, moved, locks = nights
    month = (30 * usual.new_bytes, 26 * moved.new_bytes + 4 * locks.new_bytes, None)

    def row(what: str, value: Callable[[Night], float], unit: str = "", goal: str = "") -> Row:
        values = [value(night) for night in nights]
        most = fact(goal) if goal else 0
        return Row(what, values, unit, f"at most {most:.0f}" if goal else "", values[-1] <= most if goal else None)

    return [
        row("pip installs, for each image and architecture", lambda night: night.steps["pip"]),
        row("joins, for each image and architecture", lambda night: night.steps["join"]),
        row("parts that are built, for each architecture", lambda night: night.steps["part"]),
        row("new in the registry", lambda night: night.new_bytes, "B"),
        Row("new in 30 nights, 4 of them with new locks", month, "B"),
        row("what pulls transfer", lambda night: night.egress, "B"),
        row("what machines fetch, parts or wheels", lambda night: night.fetched, "B"),
        row("requests", lambda night: sum(night.minutes.values())),
        row("requests a second in the busiest minute", lambda night: max(night.minutes.values()) / 60),
        row("requests that are refused once or more (429)", lambda night: night.refused),
        row("minutes of machines", lambda night: night.machine_minutes),
        row("minutes of the longest shard", longest, goal="minutes of a shard"),
        row("minutes of the job that moves apps", lambda night: night.phases["apps"] / 60, goal="minutes of rebase"),
        row("minutes of the whole night", lambda night: sum(night.phases.values()) / 60),
        row("most disk that a machine uses", lambda night: _disk(night) * 1e6, "B"),
    ]
