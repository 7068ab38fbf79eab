"""The operating system of an image that is not ours, and the distributions for it."""

from __future__ import annotations

import datetime
import re
from collections.abc import Collection
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import combinations
from rosml.images.matrix.model import Distribution, Matrix

DEBIAN, CALLED = "Debian", "noetic"
"""The name of Debian's own ROS 1, and the release for conditions in manifests, whose packages it has."""

OTHER = "*"
"""A ROS that the matrix does not have, such as melodic."""

_LINE = re.compile(r"""(ID|VERSION_ID|VERSION_CODENAME|PRETTY_NAME)=(["']?)([^"'\\$`]*)\2""")
"""The lines of os-release that we read: https://www.freedesktop.org/software/systemd/man/latest/os-release.html"""


@dataclass(frozen=True)
class System:
    """The facts of an image about its operating system.

    Attributes:
        id: such as `ubuntu`.
        version: such as `24.04`; empty if it has none.
        codename: such as `noble`; empty if it has none.
        title: its name for people, such as `Ubuntu 24.04.3 LTS`.
        ros: ROS distributions below /opt/ros; OTHER if there are only unknown ones.
        tools: what it has of NEEDED.
        carries: its CUDA and frameworks, such as `torch`.
        passes_on: whether its entrypoint ends by becoming the command.
    """

    id: str = ""
    version: str = ""
    codename: str = ""
    title: str = ""
    ros: tuple[str, ...] = ()
    tools: frozenset[str] = frozenset()
    carries: tuple[str, ...] = ()
    passes_on: bool = False


PROGRAMS = ("apt-get", "bash")
DPKG, SOURCE = "/var/lib/dpkg/status", "source for apt"
_DEBIAN = "name a base image of Debian or Ubuntu with a package manager and a shell"
NEEDED = {
    **dict.fromkeys(PROGRAMS, _DEBIAN),
    DPKG: "name an image that has dpkg's own files; one that was made small for delivery may have lost them",
    SOURCE: "write one into /etc/apt/sources.list, in an image of your own on this one, and name that",
}
"""What an installation of ROS needs, each with the remedy for an image that lacks it."""


def system(release: str, ros: Collection[str] = (), tools: Collection[str] = tuple(NEEDED)) -> System:
    """The facts in an image's os-release. The text may be a stranger's, so we drop control characters."""
    text = "".join(letter if letter.isprintable() else "\n" for letter in release[:65536])
    facts = {match[1]: match[3].strip()[:80] for line in text.splitlines() if (match := _LINE.fullmatch(line.strip()))}
    return System(
        facts.get("ID", ""),
        facts.get("VERSION_ID", ""),
        facts.get("VERSION_CODENAME", ""),
        facts.get("PRETTY_NAME", ""),
        tuple(sorted(ros)),
        frozenset(tools),
    )


def rows(matrix: Matrix, system: System) -> dict[str, Distribution]:
    """The distributions for a system, the default first: long-term releases before others, those with the longest support before
    others, experimental ones last."""
    names = {f"{system.id}:{system.version}", f"{system.id}:{system.codename}"}
    systems = {name for name, facts in matrix.operating_systems.items() if _bare_name(facts.image) in names}

    def order(item: tuple[str, Distribution]) -> tuple[bool, bool, datetime.timedelta]:
        facts = item[1]
        return facts.experimental, not facts.lts, datetime.date.max - (facts.eol or datetime.date.max)

    return dict(
        sorted(((name, facts) for name, facts in matrix.distributions.items() if facts.os in systems), key=order)
    )


def _bare_name(image: str) -> str:
    """The name of an operating system's image without its registry: `ubuntu:24.04`."""
    return image.rpartition("/")[2]


def choose(
    image_set: ImageSet, system: System, name: str, ros_distro: str, component: str, architectures: Collection[str]
) -> Image:
    """The ROS image whose ROS we install on an image that is not ours, `name`. `ros_distro` is empty if the user names none. Raises a
    RosmlError if nothing fits: it says what would."""
    matrix = image_set.matrix
    what = f"{name} is {system.title or system.id}" if system.id else f"{name} does not say which system it has"
    if lacking := [thing for thing in NEEDED if thing not in system.tools]:
        remedy = NEEDED[lacking[0]]
        first = " and no ".join(thing for thing in lacking if NEEDED[thing] == remedy)
        raise RosmlError(f"{name} has no {first}, so ROS cannot be installed on it", remedy, exit_code=2)
    distributions = rows(matrix, system)
    if not distributions:
        systems = [_bare_name(matrix.operating_systems[facts.os].image) for facts in matrix.distributions.values()]
        text = f"{what}, and ROS is installed on {listed(sorted(set(systems)))} alone"
        raise RosmlError(text, "name another base image, or one that has ROS", exit_code=2)
    fits = [row for row, facts in distributions.items() if not ros_distro or ros_distro in _called(row, facts)]
    if not fits:
        raise _unfit(matrix, what, distributions, ros_distro)
    row = fits[0]
    if component not in distributions[row].components or combinations.only_runs(matrix, component):
        full = [item for item in distributions[row].components if not combinations.only_runs(matrix, item)]
        raise RosmlError(unknown("component", component, full), f"{row} has {listed(full)}", exit_code=2)
    image = next(
        image
        for image in image_set.images
        if (image.distribution, image.component, image.stack) == (row, component, None)
    )
    if others := sorted(set(architectures).difference(image.architectures)):
        text = f"{row} is for {listed(image.architectures)}, and not for {listed(others)}"
        raise RosmlError(text, "name other platforms", exit_code=2)
    return image


def _called(row: str, facts: Distribution) -> set[str]:
    ros_name = facts.ros_distro or row
    return {row, ros_name, *facts.aliases, *([CALLED] if ros_name == DEBIAN else [])}


def _unfit(matrix: Matrix, what: str, distributions: dict[str, Distribution], request: str) -> RosmlError:
    every = {name: facts for name, facts in matrix.distributions.items() if request in _called(name, facts)}
    has = listed([name for name, facts in distributions.items() if not facts.experimental] or [*distributions])
    if not every:
        names = {name for row, facts in matrix.distributions.items() for name in _called(row, facts)}
        return RosmlError(unknown("ROS distribution", request, names), f"{what}, which has {has}", exit_code=2)
    stands = listed([_bare_name(matrix.operating_systems[facts.os].image) for facts in every.values()])
    text = f"{what}, which has {has}; {request} stands on {stands}"
    return RosmlError(text, "name another --ros-distro, or another base image", exit_code=2)
