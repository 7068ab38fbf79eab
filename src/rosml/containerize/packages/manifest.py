"""Manifests of ROS packages: which packages a folder has, and for which ROS they are. Reads `package.xml` and starts nothing."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from graphlib import CycleError, TopologicalSorter
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

from rosml.base.errors import RosmlError
from rosml.base.problems import some
from rosml.containerize import inputs, within
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.packages import workspace
from rosml.containerize.packages.conditions import holds
from rosml.containerize.sources import repos_file

LARGEST = 1 << 20  # bytes of a manifest

EXAMPLES: Mapping[int, str] = {1: "ros:ros1-bookworm-base", 2: "ros:jazzy-base"}
"""A base image for each ROS, in remedies."""

_GENERATIONS = {1: ("roscpp", "rospy", "message_generation"), 2: ("rclcpp", "rclpy", "rosidl_default_generators")}
"""Packages that tell the ROS of a package whose build type does not."""

_WITHOUT_ORDER = ("doc_depend", "group_depend")
"""Dependencies for which colcon builds nothing first: those of the documentation, and groups, which are no packages."""

_USUAL_KIND = "catkin"
"""The build type of a package whose manifest names none: https://ros.org/reps/rep-0149.html#build-type"""

_BUILT_BY = {
    "catkin": workspace.PLAIN,
    "ament_cmake": workspace.PLAIN,
    "cmake": workspace.PLAIN,
    "ament_python": "setup.py",
}
"""The file that a package of a build type has beside its manifest."""

Conditional = tuple[tuple[str, str], ...]
"""Texts, each with its condition."""


@dataclass(frozen=True)
class Package:
    """A ROS package."""

    name: str
    folder: Path
    kinds: Conditional  # its build types
    tools: Conditional  # its build tools
    needs: frozenset[str]  # the keys that it depends on, without build tools
    depends: Conditional = ()  # the keys after which colcon builds it
    languages: tuple[str, ...] = ()
    launches: tuple[str, ...] = ()  # names of its launch files
    programs: tuple[str, ...] = ()  # names of those that `setup.py`, `setup.cfg` or `CMakeLists.txt` installs

    @property
    def manifest(self) -> str:
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
        keys = self.needs.union(text for text, _ in self.tools)
        telling = _GENERATIONS[other] + (("catkin",) if other == 1 else ())
        return not self.fits(ros, ros_distro) and self.fits(other, ros_distro) and not keys.isdisjoint(telling)

    def fits(self, ros: int, ros_distro: str) -> bool:
        """Whether it is for a ROS, by its build type and build tools."""
        variables = {"ROS_VERSION": str(ros), "ROS_DISTRO": ros_distro}

        def holding(texts: Conditional) -> list[str]:
            return [text for text, condition in texts if holds(condition, variables)]

        words = holding(self.kinds) or holding(self.tools)
        if not words and (self.kinds or self.tools):
            return False
        begins = {"catkin": 1, "ament": 2}
        versions = {number for begin, number in begins.items() if any(word.startswith(begin) for word in words)}
        versions = versions or {number for number, names in _GENERATIONS.items() if self.needs.intersection(names)}
        return not versions or ros in versions


def read(folder: Path, ignored: IgnoredFiles) -> list[tuple[Package, str]]:
    """The packages of a folder, as `rosml containerize` finds them, each with the text of its manifest."""
    paths = [path for path in workspace.manifests(folder, ignored=ignored) if path.name == workspace.MANIFEST]
    return [_read(path, folder) for path in paths]


def require(folder: Path, typed: Mapping[str, str], environment: Mapping[str, str]) -> None:
    """Checks that a folder has packages, or names upstream ones, that can be read, and that none depend on each other in a ring."""

    def exists(name: str) -> bool:
        return os.path.lexists(folder / inputs.first_look(name, typed, folder, environment))

    ignored = IgnoredFiles(folder)
    if exists("before-dependency-identification-script"):  # it may correct manifests
        has_packages = any(path.name == workspace.MANIFEST for path in workspace.manifests(folder, ignored=ignored))
    else:
        packages = read(folder, ignored)
        has_packages = bool(packages)
        if not exists("blacklisted-packages-file"):  # it may name packages of a ring: `require_order` knows them
            _require_no_ring(packages)
    if not (has_packages or exists("vcs-import-file") or repos_file.find(folder)):
        raise workspace.none_in(folder)


def require_one_ros(folder: Path, base: str, ros: int, ros_distro: str, without: Collection[str] = ()) -> None:
    """Checks that the packages of a folder, without some, are for the ROS of a base image. `ros`: 1 or 2."""
    packages = [package for package, _ in read(folder, IgnoredFiles(folder)) if package.name not in without]
    foreign = [package.manifest for package in packages if package.foreign(ros, ros_distro)]
    if not foreign:
        return
    other = 3 - ros
    text = f"{base} has ROS {ros}, and {some(foreign)} {'is' if len(foreign) == 1 else 'are'} for ROS {other}"
    remedy = f"name a base image with ROS {other}, such as --base-image {EXAMPLES[other]}"
    fitting = [package for package in packages if package.fits(ros, ros_distro)]
    if rest := [package.manifest for package in fitting if not package.fits(other, ros_distro)]:
        text += f"; {some(rest)} {'is' if len(rest) == 1 else 'are'} for ROS {ros}"
        remedy = f"leave them out: put a file COLCON_IGNORE into their folders; for images of them, {remedy}, and leave out the others"
    raise RosmlError(text, remedy, exit_code=2)


def needed(folder: Path, variables: Mapping[str, str], without: Collection[str] = ()) -> dict[str, set[str]]:
    """The keys of what the packages of a folder, without some, depend on, and their build types, by manifest. Conditions compare with
    `variables`, as in `require_order`."""
    packages = [package for package, _ in read(folder, IgnoredFiles(folder)) if package.name not in without]
    return {
        package.manifest: {
            text for text, condition in (*package.depends, *package.kinds) if holds(condition, variables)
        }
        for package in packages
    }


def require_build_files(
    folder: Path, staged: Path, variables: Mapping[str, str], without: Collection[str] = ()
) -> None:
    """Checks that the packages of a folder, without some, have the file by which colcon builds them: it has no message about a missing
    one. `staged` is what the builder gets of the folder. Conditions compare with `variables`, as in `require_order`."""
    for package, _ in read(folder, IgnoredFiles(folder)):
        kind = next((text for text, condition in package.kinds if holds(condition, variables)), _USUAL_KIND)
        file = _BUILT_BY.get(kind)
        if package.name in without or file is None or os.path.lexists(staged / package.folder / file):
            continue
        text = f"{package.manifest} is of a package that colcon builds by {file} ({kind})"
        if os.path.lexists(folder / package.folder / file):
            remedy = f"bring it back with a line !{package.folder / file}"
            raise RosmlError(f"{text}, and .dockerignore leaves it out", remedy, exit_code=2)
        remedy = (
            "write one, or correct <build_type>; to leave the package out, put a file COLCON_IGNORE into its folder"
        )
        raise RosmlError(f"{text}, and there is none beside it", remedy, exit_code=2)


def require_order(manifests: Path, variables: Mapping[str, str], without: Collection[str] = ()) -> None:
    """Checks that no packages in the folder of `workspace.write_manifests`, but for those `without`, depend on each other in a ring.
    Conditions compare with `variables`: ROS_VERSION and ROS_DISTRO of the base image."""
    try:
        packages = read(manifests, IgnoredFiles(manifests))
    except RosmlError:  # a manifest of an upstream repository: the build says where it is
        return
    target = Path("target")
    packages = [
        (replace(item, folder=item.folder.relative_to(target)) if item.folder.is_relative_to(target) else item, text)
        for item, text in packages
        if item.name not in without
    ]
    _require_no_ring(packages, variables)


def _require_no_ring(packages: Iterable[tuple[Package, str]], variables: Mapping[str, str] | None = None) -> None:
    """Checks that colcon can build packages one after another. Without variables, dependencies with a condition do not count."""
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
            lines.append(f"\n{package.manifest}:{line}: {name} depends on {needed}")
        raise RosmlError(
            f"packages depend on each other in a ring, so none of them can be built first:{''.join(lines)}",
            "remove one of these dependencies, or move what both packages need into a third one",
            exit_code=2,
        ) from None


def _read(path: Path, folder: Path) -> tuple[Package, str]:
    """A package by its manifest, and the manifest's text."""
    content = within.read(path, folder, LARGEST) or b""
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
        problem = "no <name>" if root.tag == "package" else f"its first element is <{root.tag}>, not <package>"
        raise RosmlError(f"{path}: no manifest of a ROS package: {problem}", "correct it", exit_code=2)
    depends = [element for element in root if element.tag.endswith("depend")]
    package = Package(
        name,
        path.relative_to(folder).parent,
        kinds=_conditional(root.iterfind("export/build_type")),
        tools=_conditional(element for element in depends if element.tag == "buildtool_depend"),
        needs=frozenset(
            text for element in depends if element.tag != "buildtool_depend" and (text := (element.text or "").strip())
        ),
        depends=_conditional(element for element in depends if element.tag not in _WITHOUT_ORDER),
    )
    return package, content.decode("utf-8", "replace")


def _conditional(elements: Iterable[ElementTree.Element]) -> Conditional:
    return tuple(((element.text or "").strip(), element.get("condition", "")) for element in elements)
