"""What the build of an app says: the one place that takes it in, and gives it a shape.

Two archives come out of a build. Steps of rosml's own write one of them, from files that they read and never run: it says what is in
the images. The tests of the packages write the other one. It says what failed, and nothing else that it has counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import TypeVar

from pydantic import BaseModel, ConfigDict, ValidationError

from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.containerize import contents, junit, lock
from rosml.containerize.names import SLIM
from rosml.machine import exported

DEPENDENCIES = "dependencies.json"
"""What the packages need, as components/containerize/identify.py writes it."""

APP = "app.json"
"""What an app adds to its base image, as components/containerize/app_files.py writes it."""

SLIM_APP = "slim.json"
"""The same of the slim image."""

DESCRIBED = ("run", SLIM)
"""Images that get an SBOM and a list of files."""

TARGET, DOWNSTREAM = "results", "downstream"
KINDS = (TARGET, SLIM, DOWNSTREAM)
"""Folders of what tests left: of the packages, of the same in the slim image, and of packages that use them."""


class _Model(BaseModel):
    model_config = ConfigDict(strict=True, extra="forbid")


class Answer(_Model):
    """What a key of rosdep became: how it is installed, and the names of the packages."""

    installer: str
    names: list[str]


class Dependencies(_Model):
    """What the packages of an app need.

    Attributes:
        packages: for each ROS package its keys of rosdep, by kind. keys: what each key became. skipped: keys that were left out.
    """

    packages: dict[str, dict[str, list[str]]]
    keys: dict[str, list[Answer]]
    skipped: list[str]


class Facts(_Model):
    """What an app adds to its base image, for one platform.

    Attributes:
        packages: of the operating system that it adds, with their architecture.
        replaced: packages of the base image that it replaces or removes. removed: files that it takes away.
        changed: files of the base image that its packages change.
        built: ROS packages that are in the install space.
        lost: what files of the install space need, the build had and the image lacks. absent: what the build lacked, too.
        forgotten: launch files and programs, as `PACKAGE NAME`, that no image has; with their places in the sources or the build.
        outside: what its ROS packages installed outside of the install space.
        architecture, apt, pip: what is to be locked, as `lock.Packages` has it.
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
    """What the tests of an app said: of its packages, in the slim image, and of packages that use them."""

    target: junit.Tests
    slim: junit.Tests
    downstream: junit.Tests


def place(platform: str, platforms: Sequence[str]) -> str:
    """The folder of an archive that has what is said of a platform; empty if there is one platform alone."""
    return "" if len(platforms) == 1 else platform.replace("/", "_")


class Said:
    """What rosml's own steps said of an app.

    Args:
        archive: that they left. folder: for its files; it belongs to this class. platforms: of the build.

    Raises:
        RosmlError: there is none, or it is damaged.
    """

    def __init__(self, archive: Path, folder: Path, platforms: Sequence[str]) -> None:
        self._folder = folder
        self._places = [Path(place(platform, platforms)) for platform in platforms]
        self._platforms = dict(zip(platforms, self._places, strict=True))
        refused = exported.unpack(archive, folder, limits=exported.OURS)
        for name, reason in refused.items():
            raise RosmlError(f"what the build says of the app is damaged: {name}: {reason}", "run it again")

    def dependencies(self) -> Dependencies:
        """What the packages need."""
        return self._model(Dependencies, self._places[0] / DEPENDENCIES)

    def apps(self) -> list[Facts]:
        """What the app adds, for each platform."""
        return [self._model(Facts, folder / APP) for folder in self._places]

    def slim_apps(self) -> list[Facts]:
        """The same of the slim image."""
        return [self._model(Facts, folder / SLIM_APP) for folder in self._places]

    def detail(self, name: str) -> bytes:
        """What is in an image, by a name of `details`.

        Raises:
            RosmlError: the build did not say it.
        """
        return exported.read(self._folder, self._details()[name])

    def details(self) -> dict[str, bytes]:
        """What is in the images, by target, platform and kind: `run/linux/amd64/files.gz`."""
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
            return model.model_validate_json(exported.read(self._folder, str(path)))
        except ValidationError as error:
            text = f"what the build says of the app is damaged: {path}: {first_of(error)}"
            raise RosmlError(
                text, "look at what your scripts and packages install; if that is right, report this"
            ) from None


_Found = TypeVar("_Found", bound=_Model)


def tests(archive: Path, folder: Path, platforms: Sequence[str]) -> Tests:
    """What tests left. Their reports are in the folder afterwards, for people.

    What is no file, or too large, counts as a test that failed.

    Args:
        archive: that they left. folder: for the reports: those of each platform in a folder of its own if there are several.

    Raises:
        RosmlError: there is none, it is damaged, or it has too much.
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
    """Whether a file is one that tests leave: JUnit files and those of CTest, and the list of what left none, with what that printed."""
    return path.suffix == ".xml" or path.name in (junit.FAILED, junit.PRINTED)
