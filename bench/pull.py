"""From `docker pull` to an image's files: our torch image beside the usual one, over lines of several rates, with several engines.

The usual image is made as most people make it: a ROS image, `RUN pip install` of the same locked wheels, buildx's own compression.
Each pull begins with an empty engine and nothing in the page cache. What an engine has is removed before the next one starts.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from time import monotonic

from bench import engines, line
from bench.results import Result, Row
from rosml.machine.services import Services

Engine = Callable[[Path, Path], AbstractContextManager[engines.Pull]]

ENGINES: Mapping[str, Engine] = {
    "docker": engines.docker,
    "containerd": partial(engines.containerd, unpacks=1),
    "containerd-3": partial(engines.containerd, unpacks=3),
    "podman": engines.podman,
}
"""By name; `containerd-3` unpacks three layers at once."""

RATES = {"no limit": 0.0, "1 Gbit/s": 125e6, "100 Mbit/s": 12.5e6}
"""Bytes per second of the lines."""

GOAL = 0.4
"""What ours may take of the usual image's time, with Docker on two cores and a line without a limit."""

DROP = Path("/proc/sys/vm/drop_caches")


@dataclass(frozen=True)
class Setting:
    """What pulls have in common.

    Attributes:
        services: the local registry, which has all images.
        programs: the folder with dockerd, containerd and runc.
        storage: a folder on the disk where engines keep images.
        rounds: how often each pull is done, in turns; the median counts.
        say: tells what begins.
    """

    services: Services
    programs: Path
    storage: Path
    rounds: int
    say: Callable[[str], None]


def measure(setting: Setting, images: Mapping[str, str], names: Sequence[str], rates: Sequence[str]) -> Result:
    """Pulls images in turns.

    Args:
        setting: where and how often.
        images: the sides of the comparison: repository and digest of each. The first is the usual way.
        names, rates: of `ENGINES` and `RATES`.

    Raises:
        RosmlError: an engine does not start, or a pull failed.
    """
    rows = []
    for name in names:
        for rate in rates:
            seconds: dict[str, list[float]] = {side: [] for side in images}
            for number in range(setting.rounds):
                for side, reference in images.items():
                    setting.say(f"{name}, {rate}: {side} ({number + 1} of {setting.rounds})")
                    seconds[side].append(_pull(setting, ENGINES[name], RATES[rate], reference))
            medians = [statistics.median(taken) for taken in seconds.values()]
            judged = name == "docker" and not RATES[rate]
            met = medians[-1] <= GOAL * medians[0] if judged else None
            rows.append(Row(f"{name}, {rate}", medians, "s", f"{GOAL} of the usual" if judged else "", met))
    return Result("pull", "python -m bench pull", tuple(images), rows)


def _pull(setting: Setting, engine: Engine, rate: float, reference: str) -> float:
    """Seconds until an empty engine has an image unpacked."""
    with (
        line.serve(setting.services.state / "registry", rate) as host,
        engines.storage(setting.storage) as folder,
        engine(setting.programs, folder) as pull,
    ):
        with suppress(
            OSError
        ):  # a container may not; then files of the registry may come from memory, for all sides alike
            DROP.write_text("3")
        started = monotonic()
        pull(f"{host}/{reference}")
        return monotonic() - started
