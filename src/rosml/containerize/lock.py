"""The lock file of an app: what its images were built from, so that they can be built from the same again.

It names the base images by their digests, upstream repositories by their commits, and the packages of apt and pip that were added,
by their versions. A build that follows it takes nothing else.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, StringConstraints, ValidationError

from rosml.base import files, untrusted
from rosml.base.errors import RosmlError
from rosml.containerize import app_inputs, within

SUFFIX = ".lock"

RENEW = "write the lock file anew with --lock"

FOLDER = "lock"
"""Of requests: for each architecture a folder with the lists `apt` and `pip`."""


Digest = Annotated[str, StringConstraints(pattern=r"^sha256:[0-9a-f]{64}$")]
Architecture = Annotated[str, StringConstraints(pattern=r"^[a-z0-9][a-z0-9-]{0,30}$")]
Deb = Annotated[str, StringConstraints(pattern=r"^[a-z0-9][a-z0-9.+-]*(:[a-z0-9-]+)?$")]
Version = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9][A-Za-z0-9.+:~-]*$")]


def _without_secrets(line: str) -> str:
    """A requirement whose address has no user and no query, which may be a password. The user of ssh is none.

    Raises:
        ValueError: it has one.
    """
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


class Image(BaseModel):
    """A base image, or rosdep's lists: the name as the user wrote it, and the digest. The name is empty where the user said
    none."""

    model_config = ConfigDict(extra="forbid")

    name: str
    digest: Digest

    def of(self, name: str) -> str:
        """The digest, for the image that the user names.

        Raises:
            RosmlError: the lock file is of another one (exit code 2).
        """
        if self.name != name:
            known, named = self.name or "none of that name", name or "none of that name"
            raise RosmlError(f"the lock file is of {known}, and not of {named}", RENEW, exit_code=2)
        return self.digest


class Pin(BaseModel):
    """The commit of a repository: of this url and this version."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    url: str
    version: str
    commit: str = Field(pattern="^[0-9a-f]{40}$")


class Packages(BaseModel):
    """What was added to the base images, by architecture as dpkg calls it.

    Attributes:
        apt: versions by name; names of another architecture end in it, such as `libc6:i386`.
        pip: requirements, each with the hash of the archive where pip said it.
    """

    model_config = ConfigDict(extra="forbid")

    apt: dict[Architecture, dict[Deb, Version]] = {}
    pip: dict[Architecture, list[Requirement]] = {}


class Lock(Packages):
    """A lock file. `format` is another number where older releases cannot read it."""

    format: Annotated[int, Field(strict=True, ge=1, le=1)] = 1
    base_image: Image
    slim_base_image: Image | None = None
    rosdep_index: Image | None = None
    repositories: dict[str, Pin] = {}
    downstream: dict[str, Pin] = {}

    def text(self) -> str:
        """The file."""
        return json.dumps(self._content(), indent=1, sort_keys=True) + "\n"

    def line(self) -> str:
        """The same in one line, for a label: without what is in no image."""
        return json.dumps(self._content({"downstream"}), separators=(",", ":"), sort_keys=True)

    def _content(self, without: set[str] | None = None) -> dict[str, Any]:
        return self.model_dump(exclude_none=True, exclude=without)

    def with_other_architectures(self, other: Lock) -> Lock:
        """This lock, and what another one has for other architectures, if both have the same images and repositories."""
        names = ("base_image", "slim_base_image", "rosdep_index", "repositories", "downstream")
        if any(getattr(self, name) != getattr(other, name) for name in names):
            return self
        return self.model_copy(update={"apt": {**other.apt, **self.apt}, "pip": {**other.pip, **self.pip}})

    def lacks(self, platforms: Iterable[str]) -> list[str]:
        """Those of some platforms for which it has no packages."""
        names = {"linux/arm/v7": "armhf", "linux/386": "i386", "linux/ppc64le": "ppc64el"}
        return [name for name in platforms if names.get(name, name.split("/")[1]) not in self.apt]

    def write_requests(self, requests: Path) -> None:
        """Writes the versions down for the steps that install packages."""
        for architecture in self.apt.keys() | self.pip.keys():
            folder = requests / FOLDER / architecture
            folder.mkdir(parents=True)
            debs = self.apt.get(architecture, {})
            (folder / "apt").write_text("".join(f"{name} {version}\n" for name, version in sorted(debs.items())))
            (folder / "pip").write_text("".join(f"{line}\n" for line in self.pip.get(architecture, [])))


def added(apps: Iterable[Mapping[str, Any]]) -> Packages:
    """What reports of builds say of packages. Of two versions, which an archive has at two moments, the first counts.

    Args:
        apps: of each image and platform, with `architecture`, `apt` and `pip`.
    """
    found = Packages()
    for app in apps:
        name = app["architecture"]
        found.apt[name] = {**app["apt"], **found.apt.get(name, {})}
        known = {re.split("[ =]", line, maxsplit=1)[0]: line for line in [*app["pip"], *found.pip.get(name, [])]}
        found.pip[name] = sorted(known.values())
    return found


def place(folder: Path, name: str, renew: bool) -> Path:
    """Where the lock file of a repository is.

    Args:
        name: as the user wrote it. renew: it is to be written.

    Raises:
        RosmlError: it leads out of the repository; or a user named one that is not there, or cannot be there (exit code 2).
    """
    file = Path(os.path.normpath(folder / name))
    there = within.there(file, folder)
    if not name.endswith(SUFFIX):  # it is overwritten
        raise RosmlError(f"lock-file: {name} does not end in {SUFFIX}", "name it so", exit_code=2)
    within.require_own(file, folder)
    if renew and not file.parent.is_dir():
        raise RosmlError(f"lock-file: there is no folder {file.parent}", "make it, or name another file", exit_code=2)
    if not (renew or there or name == app_inputs.default("lock-file")):
        raise RosmlError(f"lock-file: there is no file {file}", "check its name, or write it with --lock", exit_code=2)
    return file


def read(file: Path, folder: Path) -> Lock | None:
    """The lock file of a repository; None if it has none.

    Raises:
        RosmlError: it cannot be read, is damaged, or leads out of the repository (exit code 2).
    """
    if not within.there(file, folder):
        return None
    try:
        return Lock.model_validate(untrusted.json_value(files.limited(file, untrusted.SIZE)))
    except OSError as error:
        raise RosmlError(f"cannot read {file}: {error.strerror}", "let this user read it", exit_code=2) from None
    except ValidationError as error:
        first = error.errors()[0]
        why = ": ".join(filter(None, (".".join(map(str, first["loc"])), first["msg"].removeprefix("Value error, "))))
    except ValueError as error:
        why = str(error)
    raise RosmlError(f"{file} is no lock file: {why}", RENEW, exit_code=2) from None
