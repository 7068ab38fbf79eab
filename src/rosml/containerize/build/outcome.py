"""What building an app's packages came to: one form for the report at the end, `--json`, the cache and the lock."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from pydantic import ConfigDict

from rosml.base.shapes import Shape
from rosml.containerize import lock
from rosml.containerize.build.report import Answer, Dependencies, Facts
from rosml.containerize.names import SLIM


class Outcome(Shape):
    """What another build from the same would come to as well."""

    model_config = ConfigDict(strict=True, extra="forbid")

    packages: list[str] = []  # ROS packages of the app
    keys: dict[str, list[Answer]] = {}  # what each key of rosdep became
    installed: list[str] = []  # packages of the system that the run image has beyond its base
    changed: list[str] = []  # files of the base image that these change
    replaced: list[str] = []  # packages and files of the base image that they replace or remove
    slim_replaced: list[str] | None = None  # of the slim image's base; None if there is no slim image
    outside: list[str] = []  # files installed outside of the install space, which are in no image
    lost: list[str] = []  # what the install space needs, the build had and the run image lacks
    slim_lost: list[str] = []  # what the slim image lacks beyond that
    absent: list[str] = []  # what it needs, and neither an image nor the build has
    forgotten: dict[str, str] = {}  # launch files and programs that are not installed: `PACKAGE NAME`, and a place
    added: lock.Packages = lock.Packages()  # packages of apt and pip, with their versions

    @property
    def replacing(self) -> dict[str, list[str]]:
        """The images that do not link the app onto their base image, with what it replaces there."""
        replaced = {"run": self.replaced, SLIM: self.slim_replaced}
        return {target: names for target, names in replaced.items() if names}


def of_reports(dependencies: Dependencies, apps: Sequence[Facts], slim_apps: Sequence[Facts] | None) -> Outcome:
    """The outcome that rosml's own steps reported, for each platform. `slim_apps` is None if there is no slim image."""
    lost = {line for app in apps for line in app.lost}
    every = [*apps, *(slim_apps or ())]
    return Outcome(
        packages=[*dependencies.packages],
        keys=dependencies.keys,
        installed=apps[0].packages,
        changed=apps[0].changed,
        replaced=_replaced(apps),
        slim_replaced=None if slim_apps is None else _replaced(slim_apps),
        outside=apps[0].outside,
        lost=sorted(lost),
        slim_lost=sorted({line for app in slim_apps or () for line in app.lost} - lost),
        absent=sorted({line for app in every for line in app.absent}),
        forgotten={key: place for app in apps for key, place in app.forgotten.items()},
        added=lock.added(app.model_dump() for app in every),
    )


def _replaced(apps: Iterable[Facts]) -> list[str]:
    return sorted({name for app in apps for name in (*app.replaced, *app.removed)})
