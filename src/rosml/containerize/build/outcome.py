"""What building an app's packages came to: one form for the report at the end, `--json`, the cache and the lock."""

from __future__ import annotations

from pydantic import ConfigDict

from rosml.base.shapes import Shape
from rosml.containerize import lock
from rosml.containerize.build.report import Answer
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
        found = {"run": self.replaced, SLIM: self.slim_replaced}
        return {target: names for target, names in found.items() if names}
