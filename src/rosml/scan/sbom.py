"""What is in an image, as CycloneDX: read once, and kept in the registry beside the image."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from rosml.base import untrusted
from rosml.base.problems import first_of
from rosml.registry.oci import Registry
from rosml.scan.trivy import ScannerFailed

MEDIA_TYPE = "application/vnd.cyclonedx+json"
"""Also the type of the artifact, by which trivy and others find it beside an image."""

SCANNER_ANNOTATION = "io.rosml.sbom.scanner"

COVERED = "io.rosml.sbom."
"""How annotations of an image in its index begin that name the SBOMs of what the image is made of, each by repository and
digest."""

OF_A_SYSTEM = re.compile(r"pkg:(?:deb|rpm|apk)/([^/]+)/")
"""The package URL of an operating system's package; its group is that system."""


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

    @classmethod
    def of(cls, written: Mapping[str, Any], digest: str) -> Sbom:
        """What trivy wrote about an image.

        Raises:
            ScannerFailed: it is no SBOM, or one of another image.
        """
        made = cls(json.dumps(written, separators=(",", ":"), ensure_ascii=False).encode())
        if not made.is_of(digest):
            raise ScannerFailed(f"trivy's SBOM of {digest} is of something else")
        return made

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
                f"{name}: trivy found no package in it, and a part is made of wheels",
                "the part may lack the dist-info of its wheels, or the pinned trivy may not know their form",
            )
        debian = sum(item.purl.startswith("pkg:deb/") for item in self.packages)
        if ros and not (self.system and debian):
            raise ScannerFailed(
                f"{name}: trivy found {'no operating system' if not self.system else 'no Debian package'} in it",
                "the pinned trivy may not know this operating system, or the image lacks /var/lib/dpkg/status",
            )


class Shelf:
    """SBOMs in the registry, each attached to the manifest that it is of.

    Anybody who may push into a repository can attach something that says it is an SBOM. So a shelf does not ask what is
    attached: it takes the artifact alone that the publisher's records name by its digest.
    """

    def __init__(
        self,
        client: Registry,
        scanner: str,
        recorded: Mapping[str, str] | None = None,
        record: Callable[[str, str], None] = lambda digest, artifact: None,
    ) -> None:
        """Keeps SBOMs with a registry.

        Args:
            client: of that registry.
            scanner: name and version of the program that makes them. Those of another version do not count.
            recorded: digests of artifacts with SBOMs, by the digest of the manifest that each is of, as the records say.
            record: gets the digests of a manifest and of the artifact that was attached to it, for the records.
        """
        self.client, self.scanner, self.record = client, scanner, record
        self.recorded = dict(recorded or {})

    def load(self, repository: str, digest: str) -> Sbom | None:
        """The SBOM of a manifest. None if the records name none, or if the one that they name is of another scanner, of
        another image, or not there.

        Raises:
            RosmlError: the registry fails.
        """
        artifact = self.recorded.get(digest)
        manifest = self.client.manifest(repository, artifact) if artifact else None
        if manifest is None:
            return None
        said = manifest.annotations.get(SCANNER_ANNOTATION), manifest.subject
        if said != (self.scanner, digest) or len(manifest.layers) != 1:
            return None
        found = Sbom(self.client.part(repository, manifest.layers[0]))
        try:
            return found if found.is_of(digest) else None
        except ScannerFailed:
            return None

    def store(self, repository: str, digest: str, sbom: Sbom) -> None:
        """Attaches an SBOM to a manifest.

        Raises:
            RosmlError: there is no such manifest, or the registry fails.
        """
        manifest = self.client.manifest(repository, digest)
        if manifest is None:
            raise ScannerFailed(f"{repository}@{digest} is not in the registry", "build it again")
        annotations = {SCANNER_ANNOTATION: self.scanner}
        subject = manifest.descriptor
        artifact = self.client.attach(repository, subject, MEDIA_TYPE, sbom.content, MEDIA_TYPE, annotations)
        self.recorded[digest] = artifact
        self.record(digest, artifact)
