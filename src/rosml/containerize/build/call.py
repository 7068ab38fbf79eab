"""A call of `rosml containerize` or `rosml dev`, checked before it asks any service."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from time import monotonic

from rosml.base.errors import RosmlError
from rosml.base.file_lock import holder, turn
from rosml.base.units import duration
from rosml.containerize import lock
from rosml.containerize.inputs import Values
from rosml.containerize.names import Names
from rosml.machine.services import Services

SYMLINKS = "--symlink-install"


@dataclass(frozen=True)
class Call:
    """What is built, and with what."""

    folder: Path
    values: Values
    environment: Mapping[str, str]  # the process's variables
    services: Services
    say: Callable[[str], None]  # tells the user what begins now
    renew: bool  # take the newest versions and write the lock file, instead of following it
    lock_file: Path
    names: Names
    state: Path  # a folder for all that the build writes

    @property
    def reports(self) -> Path:
        """The folder of test reports, in which `results` has the packages' own; one for each platform if there are several."""
        return self.state / "report"

    def for_podman(self) -> Call:
        """The same call with an image for podman, as `Names` says."""
        return replace(self, names=Names(self.values, self.folder.name, self.services, for_podman=True))

    def turn(self) -> contextlib.AbstractContextManager[int]:
        self.state.mkdir(parents=True, exist_ok=True)
        file, waiting = self.state / "lock", f"waiting for another call that makes {self.names.app}"
        return turn(file, lambda: self.say(f"{waiting} ({holder(file)})"))


class Headings:
    """The steps of a build, as the user reads them: what begins, which of all steps it is, and how long the one before it took."""

    def __init__(self, call: Call, *titles: str) -> None:
        self._say, self._titles, self._number, self._began = call.say, titles, 0, 0.0

    def begin(self) -> None:
        """Says that the next step begins."""
        now, number = monotonic(), self._number + 1
        took = f" (step {self._number} took {duration(now - self._began)})" if self._number else ""
        self._say(f"step {number} of {len(self._titles)}: {self._titles[self._number]}{took}")
        self._number, self._began = number, now


def new_call(
    folder: Path,
    values: Values,
    environment: Mapping[str, str],
    services: Services,
    say: Callable[[str], None],
    renew: bool = False,
) -> Call:
    """Checks the values of a call, and completes it."""
    lock_file = lock.place(folder, values.lock_file, renew)
    names = Names(values, folder.name, services)
    if "run" in names.targets and not values.command:
        remedy = "add --command 'ros2 launch …', or --target dev; rosml init proposes one"
        raise RosmlError("there is no command for the run image", remedy, exit_code=2)
    if "run" in names.targets and SYMLINKS in values.colcon_args:
        text = f"colcon-args: with {SYMLINKS}, colcon installs links to your sources, which are in no run image"
        remedy = f"leave {SYMLINKS} out; rosml dev takes it: rosml dev -- colcon build {SYMLINKS}"
        raise RosmlError(text, remedy, exit_code=2)
    if not values.base_image:
        remedy = "add --base-image, such as ros:jazzy-base; rosml init proposes one"
        raise RosmlError("there is no base image", remedy, exit_code=2)
    # Two calls may work side by side, unless they make the same image: then they take turns.
    name = f"{names.app}@{values.image_tag}".replace("/", "+").replace(":", "=")
    state = services.state / "containerize" / name
    return Call(folder, values, environment, services, say, renew, lock_file, names, state)
