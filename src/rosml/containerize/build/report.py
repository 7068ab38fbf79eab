"""Reports from the build of an app: this module alone reads them.

A build leaves two archives. rosml's own steps write one of them, from files that they read and never run: it describes the images.
The tests of the packages write the other one. Only the failures in it count.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import TypeVar

from pydantic import ConfigDict, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import Shape
from rosml.containerize import lock
from rosml.containerize.build import attachments as contents
from rosml.containerize.build import junit
from rosml.containerize.names import SLIM
from rosml.machine import exported

DEPENDENCIES = "dependencies.json"
"""The file with the packages' dependencies, written by components/containerize/identify.py."""

APP = "app.json"
"""The file with the changes of an app to its base image, written by components/containerize/app_files.py."""

SLIM_APP = "slim.json"
"""The same file for the slim image."""

DESCRIBED = ("run", SLIM)
"""Images with an SBOM and a list of files."""

TARGET, DOWNSTREAM = "results", "downstream"
KINDS = (TARGET, SLIM, DOWNSTREAM)
"""Folders of test reports: of the packages, of the same tests in the slim image, and of packages that use them."""


class _Model(Shape):
    model_config = ConfigDict(strict=True, extra="forbid")


class Answer(_Model):
    """What a key of rosdep became: how it is installed, and the names of the packages."""

    installer: str
    names: list[str]


class Dependencies(_Model):
    """The dependencies of an app's packages.

    Attributes:
        packages: for each ROS package its keys of rosdep, by kind.
        keys: the rule for each key.
        skipped: keys that were left out.
    """

    packages: dict[str, dict[str, list[str]]]
    keys: dict[str, list[Answer]]
    skipped: list[str]


class Facts(_Model):
    """The changes of an app to its base image, for one platform.

    Attributes:
        packages: new packages of the operating system, with their architecture.
        replaced: packages of the base image that it replaces or removes.
        removed: files of the base image that it removes.
        changed: files of the base image that its packages change.
        built: ROS packages in the install space.
        lost: dependencies of files in the install space that the build had and the image lacks.
        absent: dependencies that the build lacked, too.
        forgotten: launch files and programs, as `PACKAGE NAME`, that no image has; with their places in the sources or the build.
        outside: files that its ROS packages installed outside of the install space.
        architecture, apt, pip: versions for the lock file, as in `lock.Packages`.
    """

    packages: list[str]
    replaced: list[str]
    changed: list[str]
    removed: list[str]
    built: list[str]
    lost: list[str]
    absent: list[str]
    forgotten: dict[str, str]
    outside: list[str]
    architecture: lock.Architecture
    apt: dict[lock.Deb, lock.Version]
    pip: list[lock.Requirement]


@dataclass(frozen=True)
class Tests:
    """The results of an app's tests: of its packages, of these in the slim image, and of packages that use them."""

    target: junit.Tests
    slim: junit.Tests
    downstream: junit.Tests


def place(platform: str, platforms: Sequence[str]) -> str:
    """The folder of a platform in an archive; empty if there is only one platform."""
    return "" if len(platforms) == 1 else platform.replace("/", "_")


class Said:
    """The reports of rosml's own steps about an app.

    Args:
        archive: the steps' archive.
        folder: a folder for its files; it belongs to this class.
        platforms: the platforms of the build.

    Raises:
        RosmlError: the archive is missing or damaged.
    """

    def __init__(self, archive: Path, folder: Path, platforms: Sequence[str]) -> None:
        self._folder = folder
        self._places = [Path(place(platform, platforms)) for platform in platforms]
        self._platforms = dict(zip(platforms, self._places, strict=True))
        refused = exported.unpack(archive, folder, limits=exported.OURS)
        for name, reason in refused.items():
            raise RosmlError(f"what the build says of the app is damaged: {name}: {reason}", "run it again")

    def dependencies(self) -> Dependencies:
        """The packages' dependencies."""
        return self._model(Dependencies, self._places[0] / DEPENDENCIES)

    def apps(self) -> list[Facts]:
        """The app's changes, for each platform."""
        return [self._model(Facts, folder / APP) for folder in self._places]

    def slim_apps(self) -> list[Facts]:
        """The app's changes to the slim image, for each platform."""
        return [self._model(Facts, folder / SLIM_APP) for folder in self._places]

    def detail(self, name: str) -> bytes:
        """The contents of an image, by a name of `details`.

        Raises:
            RosmlError: the build did not report them.
        """
        return exported.read(self._folder, self._details()[name])

    def details(self) -> dict[str, bytes]:
        """The contents of the images, by target, platform and kind: `run/linux/amd64/files.gz`."""
        there = {name: path for name, path in self._details().items() if (self._folder / path).exists()}
        return {name: exported.read(self._folder, path) for name, path in there.items()}

    def _details(self) -> dict[str, str]:
        return {
            f"{target}/{platform}/{kind}": str(folder / f"contents-{target}" / kind)
            for target in DESCRIBED
            for platform, folder in self._platforms.items()
            for kind in contents.KINDS
        }

    def _model(self, model: type[_Found], path: Path) -> _Found:
        try:
            return model.model_validate_json(untrusted.json_text(exported.read(self._folder, str(path))))
        except ValueError as error:
            reason = first_of(error) if isinstance(error, ValidationError) else error
            text = f"what the build says of the app is damaged: {path}: {reason}"
            raise RosmlError(
                text, "look at what your scripts and packages install; if that is right, report this"
            ) from None


_Found = TypeVar("_Found", bound=_Model)


def tests(archive: Path, folder: Path, platforms: Sequence[str]) -> Tests:
    """Reads the test reports, and leaves them in a folder for people.

    If a report is no file, or too large, it counts as a failed test.

    Args:
        archive: the tests' archive.
        folder: the folder for the reports; if there are several platforms, each has its own folder in it.

    Raises:
        RosmlError: the archive is missing, damaged or too large.
    """
    places = [place(platform, platforms) for platform in platforms]
    refused = exported.unpack(archive, folder, _is_report)
    found = dict.fromkeys(KINDS, junit.Tests())
    for kind in KINDS:
        for below in places:
            found[kind] = junit.add(found[kind], junit.read(folder / below / kind))
    for name, reason in refused.items():
        parts = name.split("/")[len(platforms) > 1 :]
        kind = parts[0] if parts and parts[0] in KINDS else TARGET
        found[kind] = junit.add(found[kind], junit.Tests(1, 0, (f"{name}: {reason}",)))
    return Tests(found[TARGET], found[SLIM], found[DOWNSTREAM])


def _is_report(path: PurePosixPath) -> bool:
    """Whether a file is a test report: a JUnit file or one of CTest, the list of tests without reports, or their output."""
    return path.suffix == ".xml" or path.name in (junit.FAILED, junit.PRINTED)
