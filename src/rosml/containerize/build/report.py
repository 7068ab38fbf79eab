"""Reports from the build of an app: this module alone reads them.

A build leaves two archives. rosml's own steps write one, from files that they read and never run: it describes the images. The packages'
tests write the other one, of which only the failures count.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import TypeVar

from pydantic import ConfigDict, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import Shape
from rosml.containerize import lock
from rosml.containerize.build import attachments, junit
from rosml.containerize.names import DEV, SLIM
from rosml.images.builds.contents import PACKAGES
from rosml.machine import exported

DEPENDENCIES = "dependencies.json"
"""The file with the packages' dependencies, written by components/containerize/identify.py."""

APP, SLIM_APP = "app.json", "slim.json"
"""The files with the app's changes to the base images, written by components/containerize/app_files.py."""

DESCRIBED = {"run": attachments.KINDS, SLIM: attachments.KINDS, DEV: (PACKAGES,)}
"""What a build says of each image: the packages for an SBOM; of those to run, also the files and facts."""

TARGET, DOWNSTREAM = "results", "downstream"
KINDS = (TARGET, SLIM, DOWNSTREAM)
"""Folders of test reports: of the packages, of the same tests in the slim image, and of packages that use them."""


class _Model(Shape):
    model_config = ConfigDict(strict=True, extra="forbid")


_Document = TypeVar("_Document", bound=_Model)


class Answer(_Model):
    """What a key of rosdep became: how it is installed, and the names of the packages."""

    installer: str
    names: list[str]


class Dependencies(_Model):
    """The dependencies of an app's packages."""

    packages: dict[str, dict[str, list[str]]]  # for each ROS package its keys of rosdep, by kind
    keys: dict[str, list[Answer]]  # the rule for each key
    skipped: list[str]  # keys that were left out


class Facts(_Model):
    """The changes of an app to its base image, for one platform. The last three are for the lock file, as in `lock.Packages`."""

    packages: list[str]  # new packages of apt, with their architecture
    replaced: list[str]  # packages of the base image that it replaces or removes
    changed: list[str]  # files of the base image that its packages change
    removed: list[str]  # files of the base image
    built: list[str]  # ROS packages in the install space
    lost: list[str]  # dependencies of the install space that the build had and the image lacks
    absent: list[str]  # dependencies that the build lacked, too
    forgotten: dict[str, str]  # launch files and programs, as `PACKAGE NAME`, that no image has; with their places
    outside: list[str]  # files that its ROS packages installed outside of the install space
    architecture: lock.Architecture
    apt: dict[lock.Deb, lock.Version]
    pip: list[lock.Requirement]


@dataclass(frozen=True)
class TestResults:
    """The results of an app's tests: of its packages, of these in the slim image, and of packages that use them."""

    target: junit.Tests = field(default_factory=junit.Tests)
    slim: junit.Tests = field(default_factory=junit.Tests)
    downstream: junit.Tests = field(default_factory=junit.Tests)


def _place(platform: str, platforms: Sequence[str]) -> str:
    """The folder of a platform in an archive; empty if there is only one platform."""
    return "" if len(platforms) == 1 else platform.replace("/", "_")


@dataclass(frozen=True)
class AppReport:
    """The report of rosml's own steps about an app, with a folder for each platform."""

    folder: Path
    places: Mapping[str, Path]

    def dependencies(self) -> Dependencies:
        return self._model(Dependencies, next(iter(self.places.values())) / DEPENDENCIES)

    def apps(self, file: str = APP) -> list[Facts]:
        return [self._model(Facts, place / file) for place in self.places.values()]

    def detail(self, name: str) -> bytes:
        """The contents of an image, by a name of `details`."""
        return exported.read(self.folder, self._paths()[name])

    def details(self) -> dict[str, bytes]:
        """The contents of the images, by target, platform and kind: `run/linux/amd64/files.gz`."""
        present = {name: path for name, path in self._paths().items() if (self.folder / path).exists()}
        return {name: exported.read(self.folder, path) for name, path in present.items()}

    def _paths(self) -> dict[str, str]:
        return {
            f"{target}/{platform}/{kind}": str(place / f"contents-{target}" / kind)
            for target, kinds in DESCRIBED.items()
            for platform, place in self.places.items()
            for kind in kinds
        }

    def _model(self, model: type[_Document], path: Path) -> _Document:
        try:
            return model.model_validate_json(untrusted.json_text(exported.read(self.folder, str(path))))
        except ValueError as error:
            reason = first_of(error) if isinstance(error, ValidationError) else error
            text = f"what the build says of the app is damaged: {path}: {reason}"
            remedy = "look at what your scripts and packages install; if that is right, report this"
            raise RosmlError(text, remedy) from None


def of_app(archive: Path, folder: Path, platforms: Sequence[str]) -> AppReport:
    """Unpacks the archive of rosml's own steps into a folder, which belongs to this module."""
    for name, reason in exported.unpack(archive, folder, limits=exported.OURS).items():
        raise RosmlError(f"what the build says of the app is damaged: {name}: {reason}", "run it again")
    return AppReport(folder, {platform: Path(_place(platform, platforms)) for platform in platforms})


def of_tests(archive: Path, folder: Path, platforms: Sequence[str]) -> TestResults:
    """Reads the test reports, and leaves them for people in a folder, with one for each of several platforms. A report that is no file, or
    too large, counts as a failed test."""
    places = [_place(platform, platforms) for platform in platforms]
    refused = exported.unpack(archive, folder, _is_report)
    results = {kind: [junit.read(folder / place / kind) for place in places] for kind in KINDS}
    for name, reason in refused.items():
        parts = name.split("/")[len(platforms) > 1 :]
        kind = parts[0] if parts and parts[0] in KINDS else TARGET
        results[kind].append(junit.Tests(1, 0, (f"{name}: {reason}",)))
    return TestResults(*(junit.total(results[kind]) for kind in KINDS))


def _is_report(path: PurePosixPath) -> bool:
    """Whether a file is a report of JUnit or CTest, the list of tests without one, or their output."""
    return path.suffix == ".xml" or path.name in (junit.FAILED, junit.PRINTED)
