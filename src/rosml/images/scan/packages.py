"""A build's report about an image's packages: what components/containerize/contents.py writes."""

from __future__ import annotations

from typing import Annotated

from pydantic import ConfigDict, Field

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape

Name = Annotated[str, Field(pattern=r"[^/\s\x00-\x1f]")]
"""A name that a package URL can have: not of slashes and blanks alone, which it leaves out."""


Digest = Annotated[str, Field(pattern=r"^([0-9a-f]{64}|[0-9a-f]{128})?$")]
"""SHA-256 or SHA-512; empty if nobody knows it."""


class _Model(Shape):
    model_config = ConfigDict(strict=True, extra="forbid")


class System(_Model):
    """As /etc/os-release names it."""

    name: str
    version: str
    vendor: str = ""
    home: str = ""  # its URL


class Apt(_Model):
    """A package of the operating system, and the source package that it was built from."""

    name: Name
    version: str
    architecture: str
    source: str
    source_version: str
    maintainer: str = ""
    depends: str = ""
    provides: str = ""
    licenses: list[str] = []
    digest: Digest = ""  # of its .deb


class Python(_Model):
    name: Name
    version: str
    author: str = ""
    licenses: list[str] = []
    requires: list[str] = []
    file: str = ""  # the name of the wheel, or of the folder that says what was installed
    record: str = ""  # the path of its RECORD
    digest: Digest = ""  # of its RECORD


class Ros(_Model):
    """A ROS package of an app."""

    name: Name
    version: str
    maintainer: str = ""
    licenses: list[str]
    depends: list[str] = []
    folder: str = ""  # with this package alone
    executable: bool = False
    digest: Digest = ""  # of the files in the folder
    is_source: bool = False  # the image has its sources alone


class Packages(_Model):
    system: System
    apt: list[Apt]
    python: list[Python]
    ros: list[Ros]


def read(data: bytes) -> Packages:
    """Reads the file of components/containerize/contents.py."""
    try:
        return Packages.model_validate_json(untrusted.json_text(data))
    except ValueError:
        raise RosmlError("what the build says of the packages is damaged", "run it again") from None
