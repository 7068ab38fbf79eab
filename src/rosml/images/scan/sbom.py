"""What is in an image, as CycloneDX: read once, and kept in the registry beside the image."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from rosml.base import untrusted
from rosml.base.problems import first_of
from rosml.images.scan.trivy import ScannerFailed
from rosml.registry.client import Registry

MEDIA_TYPE = "application/vnd.cyclonedx+json"
"""Also the type of the artifact, by which trivy and others find it beside an image."""

FORMAT = {"io.rosml.sbom.format": "1"}
"""The annotation of our SBOMs. With another number all images get a new one, although their digests stay the same."""

COVERED = "io.rosml.sbom."
"""How annotations of an image in its index begin that name the SBOMs of what the image is made of, each by repository and
digest."""

OF_A_SYSTEM = re.compile(r"pkg:(?:deb|rpm|apk)/([^/]+)/")
"""The package URL of an operating system's package; its group is that system."""


REMEDY = "build it again: rosml publish build --force --only NAME"


class _Said(BaseModel):
    model_config = ConfigDict(frozen=True, strict=True)


class Component(_Said):
    """One thing in an SBOM: a package, or an operating system."""

    ref: str = Field(alias="bom-ref")
    type: str
    name: str = ""
    version: str | None = None
    purl: str = ""


class Subject(_Said):
    """What an SBOM is of."""

    name: str = ""


class About(_Said):
    """What an SBOM says of itself."""

    component: Subject | None = None


class Document(_Said):
    """What is read of an SBOM."""

    bomFormat: Literal["CycloneDX"]
    metadata: About | None = None
    components: list[Component]


LARGEST = 256 << 20
"""Bytes that an SBOM may have; those of parts have some MB."""


@dataclass(frozen=True)
class Sbom:
    """An SBOM.

    Attributes:
        content: the bytes that are kept.
    """

    content: bytes

    def is_of(self, digest: str) -> bool:
        """Whether it says that it is of an image.

        Raises:
            ScannerFailed: it is no CycloneDX.
        """
        about = self.document.metadata
        return bool(about and about.component and about.component.name.endswith(f"@{digest}"))

    @cached_property
    def document(self) -> Document:
        """The content as data.

        Raises:
            ScannerFailed: it is no CycloneDX.
        """
        remedy = "delete that artifact in the registry"
        try:
            return Document.model_validate(untrusted.json_value(self.content, LARGEST))
        except ValidationError as error:
            raise ScannerFailed(f"what is kept as an SBOM is none: {first_of(error)}", remedy) from None
        except ValueError as error:
            raise ScannerFailed(f"what is kept as an SBOM is none: {error}", remedy) from None

    @property
    def packages(self) -> list[Component]:
        """Its packages, without those of another operating system: a wheel's SBOM names the packages that its libraries were
        copied from, which no advisory of this system speaks of."""
        family = self.system.partition(" ")[0]
        libraries = [item for item in self.document.components if item.type == "library"]
        origins = [OF_A_SYSTEM.match(item.purl) for item in libraries]
        return [item for item, origin in zip(libraries, origins, strict=True) if not origin or origin[1] == family]

    @property
    def system(self) -> str:
        """Its operating system, such as `debian 12.12`; empty where it has none. One without a version is none of its own: a
        wheel's SBOM says where the libraries in it came from."""
        found = [item for item in self.document.components if item.type == "operating-system" and item.version]
        return f"{found[0].name} {found[0].version}" if found else ""

    @property
    def sources(self) -> list[str]:
        """Names of the advisories' sources, as trivy's database calls them, that its packages need."""
        family, _, version = self.system.partition(" ")
        release = version.partition(".")[0] if family == "debian" else version
        wheels = any(item.purl.startswith("pkg:pypi/") for item in self.packages)
        return [*([f"{family} {release}"] if family else []), *(["pip::"] if wheels else [])]

    def require(self, name: str, ros: bool) -> None:
        """Checks that it can be all that is in a part: an SBOM that misses most would look like a clean image.

        Args:
            name: of the part, for messages. ros: whether it is a ROS image; any other part is made of wheels.

        Raises:
            ScannerFailed: it lacks the operating system, or its packages.
        """
        if not ros and not self.packages:
            raise ScannerFailed(
                f"{name}: its SBOM names no package, and a part is made of wheels",
                "see whether the part has the dist-info of its wheels",
            )
        debian = sum(item.purl.startswith("pkg:deb/") for item in self.packages)
        if ros and not (self.system and debian):
            raise ScannerFailed(
                f"{name}: its SBOM names {'no operating system' if not self.system else 'no Debian package'}",
                "see whether the image has /usr/lib/os-release and /var/lib/dpkg/status",
            )


class Shelf:
    """SBOMs in the registry, each attached to the manifest that it is of, by the build that made that one.

    Anybody who may push into a repository can attach something that says it is an SBOM. So a shelf does not ask what is
    attached: it takes the artifact alone that the publisher's records name by its digest.
    """

    def __init__(self, client: Registry, recorded: Mapping[str, str]) -> None:
        """Reads SBOMs from a registry.

        Args:
            client: of that registry.
            recorded: digests of artifacts with SBOMs, by the digest of the manifest that each is of, as the records say.
        """
        self.client, self.recorded = client, recorded

    def load(self, repository: str, digest: str) -> Sbom:
        """The SBOM of a manifest.

        Raises:
            RosmlError: the registry fails.
            ScannerFailed: the records name none, or what they name is not there, is none of ours, or is of another image.
        """
        artifact = self.recorded.get(digest)
        manifest = self.client.manifest(repository, artifact) if artifact else None
        if manifest is None:
            raise ScannerFailed("the records name no SBOM of it" if not artifact else "its SBOM is not there", REMEDY)
        if manifest.subject == digest and len(manifest.layers) == 1 and manifest.annotations.items() >= FORMAT.items():
            found = Sbom(self.client.part(repository, manifest.layers[0]))
            if found.is_of(digest):
                return found
        raise ScannerFailed("what the records name as its SBOM is another thing", REMEDY)
