"""The apt repository of a distribution's ROS packages."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import date

from rosml.base import clock
from rosml.base.errors import RosmlError
from rosml.images.matrix import combinations, support
from rosml.images.matrix.model import Matrix

CHANNELS = ("live", "testing", "snapshot", "final")
ARCHIVE = "archive"
"""The channel of packages from another archive than ROS's own."""


@dataclass(frozen=True)
class AptRepository:
    """An apt repository of ROS. The channel is live, testing, snapshot or final; or archive if it is not ROS's own. Only snapshots have
    a day."""

    channel: str
    day: str
    address: str
    codename: str
    components: tuple[str, ...] = ("main",)


def of(matrix: Matrix, name: str, environ: Mapping[str, str] = os.environ) -> AptRepository | None:
    """The apt repository of a distribution, by the matrix or ROS_CHANNEL and ROS_SNAPSHOT; None if the operating system has ROS's
    packages itself."""
    distribution = matrix.distributions[name]
    channel, day = environ.get("ROS_CHANNEL", ""), environ.get("ROS_SNAPSHOT", "")
    if distribution.apt is None:
        archive = distribution.archive
        if channel or day:
            whose = "from its archive" if archive else "wheels" if distribution.wheels else f"{distribution.os}'s own"
            text = f"the ROS packages of {name} are {whose}: there is no other channel"
            raise RosmlError(text, "leave CHANNEL and SNAPSHOT out", exit_code=2)
        return AptRepository(ARCHIVE, "", archive.address, archive.suite, archive.components) if archive else None
    if channel and channel not in CHANNELS:
        raise RosmlError(f"no channel {channel!r}", f"CHANNEL takes {', '.join(CHANNELS)}", exit_code=2)
    channel = channel or distribution.apt.channel
    if channel == "snapshot":
        day = day or (distribution.apt.date.isoformat() if distribution.apt.date else "")
        if not _is_day(day):
            text = f"no day {day!r} of a snapshot" if day else "a snapshot is of a day"
            raise RosmlError(text, "name one, such as SNAPSHOT=2026-08-07", exit_code=2)
        if day > clock.today().isoformat():
            raise RosmlError(f"{day} is still to come", "name a day that has passed", exit_code=2)
    elif day:
        raise RosmlError(f"the channel {channel} has no days", "add CHANNEL=snapshot", exit_code=2)
    if channel == support.FINAL and not support.has_ended(matrix, name, clock.today()):
        text = f"{name} gets updates until {distribution.eol or 'further notice'}: it has no final snapshot yet"
        raise RosmlError(text, "take CHANNEL=snapshot and a day", exit_code=2)
    codename = matrix.operating_systems[distribution.os].codename or ""
    addresses = {"live": combinations.ros_live(matrix, name), "testing": combinations.ros_testing(matrix, name)}
    address = addresses.get(channel) or combinations.ros_snapshot(matrix, name, day or channel)
    if channel == "testing" and not addresses["testing"]:
        text = "ROS's testing repository has no address"
        raise RosmlError(text, "add 'testing: …' to ros_archive in matrix.yaml", exit_code=2)
    return AptRepository(channel, day, address, codename)


def _is_day(text: str) -> bool:
    try:
        return date.fromisoformat(text).isoformat() == text
    except ValueError:
        return False
