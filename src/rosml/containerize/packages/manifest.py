"""Manifests of ROS packages: which packages a folder has, and for which ROS they are. Reads `package.xml` and starts nothing."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from graphlib import CycleError, TopologicalSorter
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.problems import some
from rosml.containerize import inputs as app_inputs
from rosml.containerize import within
from rosml.containerize.packages import workspace
from rosml.containerize.packages.conditions import holds
from rosml.containerize.packages.ignored import LeftOut
from rosml.containerize.sources import repos_file

LARGEST = 1 << 20
"""The most bytes of a manifest."""

EXAMPLES: Mapping[int, str] = {1: "ros:ros1-bookworm-base", 2: "ros:jazzy-base"}
"""A base image for each ROS, in remedies."""

_GENERATIONS = {1: ("roscpp", "rospy", "message_generation"), 2: ("rclcpp", "rclpy", "rosidl_default_generators")}
"""Packages by which we know the ROS of a package whose build type says nothing."""

_WITHOUT_ORDER = ("doc_depend", "group_depend")
"""Dependencies for which colcon builds nothing first: those of the documentation, and groups, which are no packages."""


@dataclass(frozen=True)
class Package:
    """A ROS package.

    Attributes:
        name: its name.
        folder: its folder, relative to the folder of all packages; `.` if it is that.
        kinds: texts of its build types, each with its condition.
        tools: its build tools, likewise.
        needs: the keys that it depends on, without build tools.
        depends: the keys after which colcon builds it, likewise with their conditions.
        languages: of LANGUAGES.
        launches: names of its launch files.
        scripts: names of its Python programs in `setup.py` or `setup.cfg`.
    """

    name: str
    folder: Path
    kinds: tuple[tuple[str, str], ...]
    tools: tuple[tuple[str, str], ...]
    needs: frozenset[str]
    depends: tuple[tuple[str, str], ...] = ()
    languages: tuple[str, ...] = ()
    launches: tuple[str, ...] = ()
    scripts: tuple[str, ...] = ()

    @property
    def manifest(self) -> str:
        """Its manifest, as people find it."""
        return str(self.folder / workspace.MANIFEST)

    @property
    def is_python(self) -> bool:
        """Whether it has nothing for a compiler and CMake."""
        kinds = {text for text, _ in self.kinds}
        return kinds == {"ament_python"} and "C++" not in self.languages and "rclcpp" not in self.needs

    def foreign(self, ros: int, ros_distro: str) -> bool:
        """Whether it is for the other ROS alone: by its build type or build tools, and by what it depends on. Debian's ROS 1 can build
        packages of ament that need nothing else of ROS 2."""
        other = 3 - ros
        asked = self.needs.union(text for text, _ in self.tools)
        needs = _GENERATIONS[other] + (("catkin",) if other == 1 else ())
        return not self.fits(ros, ros_distro) and self.fits(other, ros_distro) and not asked.isdisjoint(needs)

    def fits(self, ros: int, ros_distro: str) -> bool:
        """Whether it is for a ROS, by its build type and build tools."""
        variables = {"ROS_VERSION": str(ros), "ROS_DISTRO": ros_distro}

        def holding(texts: tuple[tuple[str, str], ...]) -> list[str]:
            return [text for text, condition in texts if holds(condition, variables)]

        words = holding(self.kinds) or holding(self.tools)
        if not words and (self.kinds or self.tools):
            return False
        found = {1 for word in words if word.startswith("catkin")} | {2 for word in words if word.startswith("ament")}
        found = found or {number for number, names in _GENERATIONS.items() if self.needs.intersection(names)}
        return not found or ros in found


def read(folder: Path, left: LeftOut) -> list[tuple[Package, str]]:
    """The packages of a folder, as `rosml containerize` finds them, each with the text of its manifest.

    Raises:
        RosmlError: a manifest cannot be read, is no XML, or has no name (exit code 2).
    """
    found = [path for path in workspace.manifests(folder, left=left) if path.name == workspace.MANIFEST]
    return [_read(path, folder) for path in found]


def require(folder: Path, given: Mapping[str, str], environment: Mapping[str, str]) -> None:
    """Checks that a folder has packages, or names upstream ones, that their manifests can be read, and that none depend on each
    other in a ring. It looks at no other input.

    Args:
        given: inputs of the command line, by name.
        environment: the variables of the process.

    Raises:
        RosmlError: it has none, a manifest is wrong, or there is a ring (exit code 2).
    """

    def said(name: str) -> Path:
        return folder / app_inputs.first_look(name, given, folder, environment)

    left = LeftOut(folder)
    if os.path.lexists(said("before-dependency-identification-script")):  # it may correct manifests
        found = any(path.name == workspace.MANIFEST for path in workspace.manifests(folder, left=left))
    else:
        packages = read(folder, left)
        found = bool(packages)
        if not os.path.lexists(
            said("blacklisted-packages-file")
        ):  # it may name packages of a ring: `require_order` knows them
            _require_no_ring(packages)
    if not (found or os.path.lexists(said("vcs-import-file")) or repos_file.found(folder)):
        raise workspace.none_in(folder)


def require_one_ros(folder: Path, base: str, ros: int, ros_distro: str, without: Collection[str] = ()) -> None:
    """Checks that the packages of a folder are for the ROS of a base image.

    Args:
        base: the name of the base image.
        ros: 1 or 2.
        ros_distro: what conditions compare with.
        without: names of packages that do not count.

    Raises:
        RosmlError: some are for the other one alone (exit code 2).
    """
    packages = [package for package, _ in read(folder, LeftOut(folder)) if package.name not in without]
    odd = [package for package in packages if package.foreign(ros, ros_distro)]
    if not odd:
        return
    other = 3 - ros
    text = f"{base} has ROS {ros}, and {some(package.manifest for package in odd)} {'is' if len(odd) == 1 else 'are'} for ROS {other}"
    remedy = f"name a base image with ROS {other}, such as --base-image {EXAMPLES[other]}"
    fit = [package for package in packages if package.fits(ros, ros_distro)]
    if rest := [package for package in fit if not package.fits(other, ros_distro)]:
        text += f"; {some(package.manifest for package in rest)} {'is' if len(rest) == 1 else 'are'} for ROS {ros}"
        remedy = f"leave them out: put a file COLCON_IGNORE into their folders; for images of them, {remedy}, and leave out the others"
    raise RosmlError(text, remedy, exit_code=2)


def require_order(manifests: Path, variables: Mapping[str, str], without: Collection[str] = ()) -> None:
    """Checks that no packages depend on each other in a ring, those of upstream repositories included.

    Args:
        manifests: the folder that `workspace.write_manifests` wrote.
        variables: ROS_VERSION and ROS_DISTRO of the base image, with which conditions compare.
        without: names of packages that do not count.

    Raises:
        RosmlError: there is a ring (exit code 2).
    """
    try:
        packages = read(manifests, LeftOut(manifests))
    except RosmlError:  # a manifest of an upstream repository: the build says where it is
        return
    target = Path("target")
    packages = [
        (replace(item, folder=item.folder.relative_to(target)) if item.folder.is_relative_to(target) else item, text)
        for item, text in packages
    ]
    _require_no_ring([(item, text) for item, text in packages if item.name not in without], variables)


def _require_no_ring(packages: Iterable[tuple[Package, str]], variables: Mapping[str, str] | None = None) -> None:
    """Checks that colcon can build some packages one after another.

    Args:
        packages: each with the text of its manifest.
        variables: with which conditions compare; if None, dependencies with a condition do not count.

    Raises:
        RosmlError: they depend on each other in a ring (exit code 2).
    """
    by_name = {package.name: (package, text) for package, text in packages}
    graph = {
        name: [
            key
            for key, condition in package.depends
            if key in by_name and (holds(condition, variables) if variables else not condition)
        ]
        for name, (package, _) in by_name.items()
    }
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        ring: list[str] = error.args[1][::-1]  # each needs the next one, and the last one is the first one again
        lines = []
        for name, needed in pairwise(ring):
            package, text = by_name[name]
            line = text.count("\n", 0, max(text.find(f">{needed}<"), 0)) + 1
            lines.append(f"{package.manifest}:{line}: {name} depends on {needed}")
        raise RosmlError(
            "packages depend on each other in a ring, so none of them can be built first:"
            + "".join(f"\n{line}" for line in lines),
            "remove one of these dependencies, or move what both packages need into a third one",
            exit_code=2,
        ) from None


def _read(path: Path, folder: Path) -> tuple[Package, str]:
    """A package by its manifest, and the manifest's text.

    Raises:
        RosmlError: it cannot be read, is no XML, or has no name (exit code 2).
    """
    within.there(path, folder)
    shown = path.relative_to(folder)
    try:
        content = files.limited(path, LARGEST)
    except OSError as error:
        raise RosmlError(f"{path}: cannot be read: {error.strerror}", "make it readable", exit_code=2) from None
    if len(content) > LARGEST:
        raise RosmlError(f"{path}: has more than {LARGEST >> 20} MiB", "check the file", exit_code=2)
    try:
        root = ElementTree.fromstring(content)
    except ElementTree.ParseError as error:
        line, column = error.position
        text = f"{path}:{line}:{column + 1}: no XML: {str(error).partition(':')[0]}"
        raise RosmlError(text, "correct that line", exit_code=2) from None
    except (LookupError, ValueError) as error:  # an encoding that Python does not know
        raise RosmlError(f"{path}:1: no XML: {error}", "save it as UTF-8", exit_code=2) from None
    name = (root.findtext("name") or "").strip()
    if root.tag != "package" or not name:
        what = "no <name>" if root.tag == "package" else f"its first element is <{root.tag}>, not <package>"
        raise RosmlError(f"{path}: no manifest of a ROS package: {what}", "correct it", exit_code=2)
    kinds, tools, depends, needs = list[tuple[str, str]](), list[tuple[str, str]](), list[tuple[str, str]](), set[str]()
    for element in root:
        text, condition = (element.text or "").strip(), element.get("condition", "")
        if element.tag.endswith("depend") and element.tag not in _WITHOUT_ORDER:
            depends.append((text, condition))
        if element.tag == "buildtool_depend":
            tools.append((text, condition))
        elif element.tag.endswith("depend") and text:
            needs.add(text)
    for element in root.iterfind("export/build_type"):
        kinds.append(((element.text or "").strip(), element.get("condition", "")))
    package = Package(name, shown.parent, tuple(kinds), tuple(tools), frozenset(needs), tuple(depends))
    return package, content.decode("utf-8", "replace")
