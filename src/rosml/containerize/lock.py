"""The lock file of an app: digests of base images, commits of upstream repositories, and versions of added packages of apt and pip. A build
that follows it takes nothing else.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator, ConfigDict, Field, StringConstraints, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.containerize import inputs, within

SUFFIX = ".lock"
RENEW = "renew the lock file with --lock"

FOLDER = "lock"
"""The folder in the requests: for each architecture it has a folder with the lists `apt` and `pip`."""

Digest = Annotated[str, StringConstraints(pattern=r"^sha256:[0-9a-f]{64}$")]
Name = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9._:/-]{1,300}$")]
Architecture = Annotated[str, StringConstraints(pattern=r"^[a-z0-9][a-z0-9-]{0,30}$")]
Deb = Annotated[str, StringConstraints(pattern=r"^[a-z0-9][a-z0-9.+-]*(:[a-z0-9-]+)?$")]
Version = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9][A-Za-z0-9.+:~-]*$")]


def _without_secrets(line: str) -> str:
    """Refuses an address with a user or a query, either of which may be a password. The user of ssh is allowed."""
    address = line.partition(" @ ")[2].partition("#")[0]
    scheme, _, rest = address.partition("://")
    if "?" in address or ("@" in rest.partition("/")[0] and not scheme.endswith("ssh")):
        raise ValueError("its address has a user or a query, which may be a secret")
    return line


Requirement = Annotated[
    str,
    StringConstraints(pattern=r"^[a-z0-9-]+(==[A-Za-z0-9.+!_-]+( --hash=sha256:[0-9a-f]{64})?| @ [a-z+]+:[!-~]+)$"),
    AfterValidator(_without_secrets),
]


class Image(Shape):
    """A base image, or rosdep's lists. The name is as the user wrote it; empty if there is none."""

    model_config = ConfigDict(extra="forbid")

    name: str
    digest: Digest

    def of(self, name: str) -> str:
        if self.name != name:
            names = [text or "none of that name" for text in (self.name, name)]
            raise RosmlError(f"the lock file is of {names[0]}, and not of {names[1]}", RENEW, exit_code=2)
        return self.digest


class Pin(Shape):
    model_config = ConfigDict(extra="forbid", frozen=True)

    url: str
    version: str
    commit: str = Field(pattern="^[0-9a-f]{40}$")


class Packages(Shape):
    """What was added to the base images, by dpkg's architecture. Names of another one end in it: `libc6:i386`."""

    model_config = ConfigDict(extra="forbid")

    apt: dict[Architecture, dict[Deb, Version]] = {}
    pip: dict[Architecture, list[Requirement]] = {}


class Lock(Packages):
    """A lock file. `format` grows if older releases cannot read it."""

    format: Annotated[int, Field(strict=True, ge=1, le=1)] = 1
    base_image: Image
    slim_base_image: Image | None = None
    rosdep_index: Image | None = None
    addons: dict[Name, Digest] | None = None
    repositories: dict[str, Pin] = {}
    downstream: dict[str, Pin] = {}

    def text(self) -> str:
        return json.dumps(self.model_dump(exclude_none=True), indent=1, sort_keys=True) + "\n"

    def line(self) -> str:
        """The lock in one line, for a label: without inputs that are in no image."""
        content = self.model_dump(exclude_none=True, exclude={"downstream"})
        return json.dumps(content, separators=(",", ":"), sort_keys=True)

    def with_other_architectures(self, other: Lock) -> Lock:
        """This lock with the packages of another one for other architectures, if all else is the same."""
        packages = {"apt", "pip"}
        if self.model_dump(exclude=packages) != other.model_dump(exclude=packages):
            return self
        return self.model_copy(update={"apt": {**other.apt, **self.apt}, "pip": {**other.pip, **self.pip}})

    def lacks(self, platforms: Iterable[str]) -> list[str]:
        """The platforms for which it has no packages."""
        names = {"linux/arm/v7": "armhf", "linux/386": "i386", "linux/ppc64le": "ppc64el"}
        return [name for name in platforms if names.get(name, name.split("/")[1]) not in self.apt]

    def write_requests(self, requests: Path) -> None:
        """Writes the versions for the steps that install packages."""
        for architecture in self.apt.keys() | self.pip.keys():
            folder = requests / FOLDER / architecture
            folder.mkdir(parents=True)
            debs = self.apt.get(architecture, {})
            (folder / "apt").write_text("".join(f"{name} {version}\n" for name, version in sorted(debs.items())))
            (folder / "pip").write_text("".join(f"{line}\n" for line in self.pip.get(architecture, [])))


def added(apps: Iterable[Mapping[str, Any]]) -> Packages:
    """The added packages in reports of builds. An archive may change meanwhile: of two versions, the first counts."""
    packages = Packages()
    for app in apps:
        architecture = app["architecture"]
        packages.apt[architecture] = {**app["apt"], **packages.apt.get(architecture, {})}
        lines = [*app["pip"], *packages.pip.get(architecture, [])]
        by_name = {re.split("[ =]", line, maxsplit=1)[0]: line for line in lines}
        packages.pip[architecture] = sorted(by_name.values())
    return packages


def place(folder: Path, name: str, renew: bool) -> Path:
    """The path of a repository's lock file. It need not exist if it will be written, or has its default name."""
    file = Path(os.path.normpath(folder / name))
    exists = within.exists(file, folder)
    if not name.endswith(SUFFIX):  # --lock overwrites it
        raise RosmlError(f"lock-file: {name} does not end in {SUFFIX}", "name it so", exit_code=2)
    within.require_inside(file, folder)
    if renew and not file.parent.is_dir():
        raise RosmlError(f"lock-file: there is no folder {file.parent}", "make it, or name another file", exit_code=2)
    if not (renew or exists or name == inputs.default("lock-file")):
        raise RosmlError(f"lock-file: there is no file {file}", "check its name, or write it with --lock", exit_code=2)
    return file


def read(file: Path, folder: Path) -> Lock | None:
    """The lock file of a repository; None if it has none."""
    content = within.read(file, folder, untrusted.SIZE)
    if content is None:
        return None
    try:
        return Lock.model_validate(untrusted.json_value(content))
    except ValidationError as error:
        first = error.errors()[0]
        why = ": ".join(filter(None, (".".join(map(str, first["loc"])), first["msg"].removeprefix("Value error, "))))
    except ValueError as error:
        why = str(error)
    raise RosmlError(f"{file} is no lock file: {why}", RENEW, exit_code=2) from None
