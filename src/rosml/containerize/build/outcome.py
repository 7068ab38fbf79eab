"""What building an app's packages came to: one form for the report at the end, `--json`, the cache and the lock."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from pydantic import ConfigDict

from rosml.base.shapes import Shape
from rosml.containerize import lock
from rosml.containerize.build.report import Answer, Dependencies, Facts
from rosml.containerize.names import SLIM


class Outcome(Shape):
    """What another build from the same would come to as well.

    Attributes:
        packages: ROS packages of the app. keys: what each key of rosdep became.
        installed: packages of the operating system that the run image has beyond its base.
        changed: files of the base image that these packages change.
        replaced: packages and files of the base image that they replace or remove; if there are some, the run image does not
            share its layers with the base image alone.
        slim_replaced: the same of the slim image and its base; None if there is no slim image.
        outside: what the packages installed outside of the install space, which is in no image.
        lost, slim_lost: what files of the install space need, the build had and the run image or the slim image lacks.
        absent: what they need, and neither an image nor the build has.
        forgotten: launch files and programs, as `PACKAGE NAME`, that are not installed, with a place of each.
        added: the packages of apt and pip that were added, with their versions.
    """

    model_config = ConfigDict(strict=True, extra="forbid")

    packages: list[str] = []
    keys: dict[str, list[Answer]] = {}
    installed: list[str] = []
    changed: list[str] = []
    replaced: list[str] = []
    slim_replaced: list[str] | None = None
    outside: list[str] = []
    lost: list[str] = []
    slim_lost: list[str] = []
    absent: list[str] = []
    forgotten: dict[str, str] = {}
    added: lock.Packages = lock.Packages()

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
    """The packages and files of the base image that an app's packages replace or remove, on any platform."""
    return sorted({name for app in apps for name in (*app.replaced, *app.removed)})
